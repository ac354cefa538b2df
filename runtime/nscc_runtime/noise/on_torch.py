"""The keyed random numbers of `nscc_runtime.noise.arrays` as tensors on any torch device.

Uniform numbers are identical, normal numbers agree to 1e-12, and counts equal those of
`nscc_runtime.execution.frame_loop.draw_counts` except where rounding decides."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import torch

from nscc_runtime.noise.poisson_law import SEARCH_BELOW, SEARCHED, SETTLED_ABOVE

_MASK = 0xFFFF_FFFF
_MULTIPLIERS = 0xD251_1F53, 0xCD9E_8D57
_WEYL = 0x9E37_79B9, 0xBB67_AE85
_NOTHING = 1e-17


def key_tensor(keys: Sequence[np.uint64], device: torch.device | str) -> torch.Tensor:
    """Return keys as int64 with the same bits, for torch."""
    return torch.from_numpy(np.array(keys, np.uint64).view(np.int64)).to(device)


def uniforms(keys: torch.Tensor, places: torch.Tensor) -> torch.Tensor:
    """Return the uniform number of each key (..) at each place: float64 (.., places).

    This is Philox4x32-10 like `nscc_runtime.noise.keys`; 32-bit products overflow in int64 with
    the same bits as in uint64."""
    keys = keys[..., None]
    k, m = keys & _MASK, (keys >> 32) & _MASK
    a, b = places & _MASK, (places >> 32) & _MASK
    c = d = torch.zeros_like(places)
    for _ in range(10):
        x, y = a * _MULTIPLIERS[0], c * _MULTIPLIERS[1]
        a, b = ((y >> 32) & _MASK) ^ b ^ k, y & _MASK
        c, d = ((x >> 32) & _MASK) ^ d ^ m, x & _MASK
        k, m = (k + _WEYL[0]) & _MASK, (m + _WEYL[1]) & _MASK
    return ((b << 20) | (a >> 12)).double() * 2.0**-52 + 2.0**-53


def normals(keys: torch.Tensor, places: torch.Tensor) -> torch.Tensor:
    """Return standard normal numbers (.., places), float64."""
    quantiles: torch.Tensor = torch.special.ndtri(uniforms(keys, places))
    return quantiles


def poisson(
    keys: torch.Tensor, places: torch.Tensor, rate: torch.Tensor, cap: float
) -> torch.Tensor:
    """Return Poisson counts (.., places) of rates that broadcast to this shape. Rates above `cap`
    count as `cap`, NaN as 0."""
    u = uniforms(keys, places)
    rate = torch.where(rate > 0.0, rate, 0.0).clamp(max=cap).expand(u.shape)
    counts = _quantile(torch.special.ndtri(u), rate.clamp(min=SEARCH_BELOW)).floor().clamp(min=0.0)
    low = rate < SETTLED_ABOVE
    searched = _searched(u[low], rate[low].clamp(max=SEARCH_BELOW))
    # The formula's error at the crossover must not give a larger rate a smaller count.
    formula = torch.where(rate[low] >= SEARCH_BELOW, counts[low], 0.0)
    counts[low] = torch.maximum(searched, formula)
    return counts


def _quantile(z: torch.Tensor, rate: torch.Tensor) -> torch.Tensor:
    """Return a number that, rounded down, is the Poisson count at the normal quantile z, as
    `nscc_runtime.noise.poisson_law.quantile` does."""
    root, square = rate.sqrt(), z * z
    order_2 = z * (1 / 36 + square * (1 / 72))
    order_3 = square * (7 / 810 + square * (1 / 270)) - 8 / 405
    return rate + root * z + (1 / 3 + square * (1 / 6)) + (order_3 / root - order_2) / root


def _searched(u: torch.Tensor, rate: torch.Tensor) -> torch.Tensor:
    """Return the smallest counts whose distribution functions reach u; rate <= SEARCH_BELOW."""
    mass = torch.exp(-rate)
    remainder, counts = u - mass, torch.zeros_like(u)
    for k in range(1, SEARCHED):
        mass = mass * (rate / k)
        going = (remainder > 0.0) & (mass > _NOTHING)
        if not bool(going.any()):
            break
        counts += going
        remainder = remainder - mass
    return counts
