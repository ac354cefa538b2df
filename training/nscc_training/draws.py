"""Random numbers for tensors of any device."""

from __future__ import annotations

import torch
from torch import Tensor


def normal(like: Tensor, generator: torch.Generator, dtype: torch.dtype | None = None) -> Tensor:
    """Standard normal numbers of the shape, type and device of `like`.

    They are drawn on the CPU, so that every device has the same, in `dtype` or the type of `like`.
    """
    return torch.randn(like.shape, generator=generator, dtype=dtype or like.dtype).to(like)
