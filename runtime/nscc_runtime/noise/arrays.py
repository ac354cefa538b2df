"""Random numbers of whole arrays of pixels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Pixels = NDArray[np.int64]

RATE_CAP = 1e12
"""Rates above it are drawn as this one: no well holds so many electrons."""


def uniforms(key: np.uint64, pixels: Pixels) -> Floats:
    """Numbers strictly inside (0, 1), one for each of `pixels`: odd multiples of 2**-53."""
    low, high = _philox(key, pixels, np.uint64(0))
    bits = (high << np.uint64(32) | low) >> np.uint64(12)
    return (bits.astype(np.float64) + 0.5) * 2.0**-52


def normals(key: np.uint64, pixels: Pixels) -> Floats:
    """Standard normal numbers, one for each of `pixels`, increasing in `uniforms`."""
    from scipy.special import ndtri

    return np.asarray(ndtri(uniforms(key, pixels)), np.float64)


def poisson(
    key: np.uint64, pixels: Pixels, rate: Floats, *, exact: bool
) -> tuple[Floats, NDArray[np.bool_]]:
    """Counts and where they are valid, one for each of `pixels` (same shape as `rate`).

    Rates below 0 count as 0, rates above `RATE_CAP` as `RATE_CAP`; where the rate is NaN the count
    is 0 and not valid.
    """
    from scipy.stats import poisson as law

    valid = ~np.isnan(rate)
    clipped = np.clip(np.where(valid, rate, 0.0), 0.0, RATE_CAP)
    counts = np.maximum(law.ppf(uniforms(key, pixels), clipped), 0.0)
    return counts, valid


def thin(key: np.uint64, pixels: Pixels, counts: Floats, shares: Floats) -> Floats:
    """Spread each count over slots in proportion to `shares`: (pixels, slots), rows sum to counts.

    `counts` (pixels,) are whole numbers, `shares` (pixels, slots) or (slots,).
    """
    from scipy.stats import binom

    shares = np.broadcast_to(shares, (len(counts), np.shape(shares)[-1]))
    left = np.cumsum(shares[:, ::-1], axis=1)[:, ::-1]
    rest = np.array(counts, np.float64)
    out = np.zeros(shares.shape)
    for slot in range(shares.shape[1]):
        p = np.divide(shares[:, slot], left[:, slot], out=np.zeros(len(rest)),
                      where=left[:, slot] > 0)  # fmt: skip
        low, high = _philox(key, pixels, np.uint64(slot + 1))
        bits = (high << np.uint64(32) | low) >> np.uint64(12)
        u = (bits.astype(np.float64) + 0.5) * 2.0**-52
        out[:, slot] = np.maximum(binom.ppf(u, rest, p), 0.0)
        rest -= out[:, slot]
    return out


def _philox(key: np.uint64, pixels: Pixels, third: np.uint64) -> tuple[NDArray[np.uint64], ...]:
    mask, half = np.uint64(0xFFFF_FFFF), np.uint64(32)
    place = np.asarray(pixels, np.int64).astype(np.uint64)
    a, b = place & mask, place >> half
    c, d = np.full_like(a, third), np.zeros_like(a)
    k, m = key & mask, key >> half
    for _ in range(10):
        x, y = a * np.uint64(0xD251_1F53), c * np.uint64(0xCD9E_8D57)
        a, b, c, d = y >> half ^ b ^ k, y & mask, x >> half ^ d ^ m, x & mask
        k, m = k + np.uint64(0x9E37_79B9) & mask, m + np.uint64(0xBB67_AE85) & mask
    return a, b
