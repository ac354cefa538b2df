"""Uniform numbers from a key and a counter by a hash, without state.

Philox4x32-10: Salmon, Moraes, Dror and Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC
2011, which passes BigCrush. `nscc_runtime.noise.keys.philox` is the same function for Python. The
functions are scalar; loops (`nscc_runtime.loop`) call them, and LLVM vectorises the loops."""

from __future__ import annotations

import numpy as np

from nscc_runtime.loop import inlined

_HALF = np.uint64(32)
_MASK = np.uint64(0xFFFF_FFFF)
_MULTIPLIER_0 = np.uint64(0xD251_1F53)
_MULTIPLIER_1 = np.uint64(0xCD9E_8D57)
_WEYL_0 = np.uint64(0x9E37_79B9)
_WEYL_1 = np.uint64(0xBB67_AE85)

_SHIFT_52 = np.uint64(12)
_ONE_TO_TWO = np.uint64(0x3FF0_0000_0000_0000)


@inlined
def bits(key: np.uint64, pixel: int, lane: np.uint64) -> np.uint64:
    """Return 64 random bits of a key and a pixel. `lane`: 0, 1, .. for several results."""
    place = np.uint64(pixel)
    a, b = place & _MASK, place >> _HALF
    c, d = lane & _MASK, lane >> _HALF
    k, m = key & _MASK, key >> _HALF
    for _ in range(10):
        x, y = a * _MULTIPLIER_0, c * _MULTIPLIER_1
        a, b, c, d = (y >> _HALF) ^ b ^ k, y & _MASK, (x >> _HALF) ^ d ^ m, x & _MASK
        k, m = (k + _WEYL_0) & _MASK, (m + _WEYL_1) & _MASK
    return a | (b << _HALF)


@inlined
def unit(random: np.uint64) -> float:
    """Return the odd multiple of 2**-53 inside (0, 1) given by the upper 52 bits of `random`. The
    numbers are symmetric about 1/2, and 1 - u is exact."""
    # The bits become the fraction of a number in [1, 2): no conversion of integers, which not
    # every processor has for vectors.
    fraction = np.uint64((random >> _SHIFT_52) | _ONE_TO_TWO).view(np.float64) - 1.0
    return fraction + 2.0**-53
