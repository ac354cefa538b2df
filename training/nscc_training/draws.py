"""Random numbers for tensors on any device."""

from __future__ import annotations

import numpy as np
import torch
from torch import Tensor


def generator_of(device: torch.device, *numbers: int) -> torch.Generator:
    """Return a random generator on `device`, seeded by all `numbers` (whole, from 0 on) together:
    other numbers, or another order, give an independent sequence."""
    state = np.random.SeedSequence(list(numbers)).generate_state(1, np.uint64)[0]
    # Shifted to 63 bits, so that the seed is not negative as a signed integer.
    return torch.Generator(device).manual_seed(int(state) >> 1)


def normal(like: Tensor, generator: torch.Generator, dtype: torch.dtype | None = None) -> Tensor:
    """Return standard normal numbers of the shape, dtype and device of `like`.

    They are drawn on the generator's device in `dtype` (None: that of `like`), so that the same
    generator gives the same numbers on every device."""
    drawn = torch.randn(
        like.shape, generator=generator, dtype=dtype or like.dtype, device=generator.device
    )
    return drawn.to(like)


def uniform(
    like: Tensor, generator: torch.Generator, shape: tuple[int, ...] | None = None
) -> Tensor:
    """Return random numbers from 0 up to but not including 1 in `shape` (None: that of `like`),
    float32, on the device of `like`. They are drawn on the generator's device."""
    size = like.shape if shape is None else shape
    return torch.rand(size, generator=generator, device=generator.device).to(like.device)
