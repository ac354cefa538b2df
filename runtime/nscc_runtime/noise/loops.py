"""The loops over pixels that `nscc_runtime.noise.compiled` makes machine code of.

They take bare pointers, allocate nothing and raise nothing; `nscc_runtime.noise.arrays` has checked
what they are given. Every number depends on its key and pixel alone, and nothing is rounded
otherwise in a vector than alone, so that how pixels are split over calls changes no bit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.noise.binomial import binomial
from nscc_runtime.noise.counter import bits, compiled, unit
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.poisson import (
    SEARCH_BELOW,
    SETTLED_ABOVE,
    poisson_exact,
    poisson_fast,
    quantile,
)

# Pointers; typed as arrays, which is how they are used.
Keys = NDArray[np.uint64]
Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Flags = NDArray[np.uint8]

_FIRST_LANE = np.uint64(0)
_SLOT_LANES = np.uint64(1 << 32)


@compiled
def uniform(key: np.uint64, pixel: int) -> float:
    """The first uniform number of a key at a pixel."""
    return unit(bits(key, pixel, _FIRST_LANE))


@compiled
def _drawable(rate: float, cap: float) -> float:
    """The rate within [0, cap], 0 for NaN."""
    if rate > 0.0:
        return rate if rate < cap else cap
    return 0.0


def fill_uniforms(sizes: Ints, key: Keys, pixels: Ints, out: Floats) -> None:
    """out[i] := the uniform number at pixels[i]; `sizes` is how many, `key` one word."""
    for i in range(sizes[0]):
        out[i] = uniform(key[0], pixels[i])


def fill_normals(sizes: Ints, key: Keys, pixels: Ints, out: Floats) -> None:
    """out[i] := the normal number at pixels[i]; `sizes` is how many, `key` one word."""
    for i in range(sizes[0]):
        out[i] = normal(uniform(key[0], pixels[i]))


def fill_poisson(
    sizes: Ints, key: Keys, pixels: Ints, cap: Floats, rate: Floats, out: Floats, valid: Flags
) -> None:
    """out[i] := a count of rate[i], drawn at pixels[i]; valid[i] := whether that is a number.

    `sizes` are how many, and 1 for exact counts; `cap` is one number.
    """
    count, top, stream = sizes[0], cap[0], key[0]
    for i in range(count):
        valid[i] = rate[i] == rate[i]
    if sizes[1]:
        for i in range(count):
            out[i] = poisson_exact(uniform(stream, pixels[i]), _drawable(rate[i], top))
        return
    low = 0
    for i in range(count):
        low += not rate[i] >= SETTLED_ABOVE
    # Two loops without a branch, of which LLVM makes vectors; then the few that need more.
    if low < count:
        for i in range(count):
            out[i] = normal(uniform(stream, pixels[i]))
        for i in range(count):
            known = rate[i] if rate[i] > SEARCH_BELOW else SEARCH_BELOW
            x = np.floor(quantile(out[i], known if known < top else top))
            out[i] = x if x > 0.0 else 0.0
    if low:
        for i in range(count):
            if not rate[i] >= SETTLED_ABOVE:
                out[i] = poisson_fast(uniform(stream, pixels[i]), _drawable(rate[i], top))


def fill_thin(
    sizes: Ints, key: Keys, pixels: Ints, counts: Floats, shares: Floats, out: Floats
) -> None:
    """Spread counts[i] over the slots of out[i] in proportion to shares[i * stride ..].

    `sizes` are how many pixels, how many slots, and the stride: slots, or 0 for shares that all
    pixels have in common.
    """
    slots, stride, stream = sizes[1], sizes[2], key[0]
    for i in range(sizes[0]):
        first, row = i * stride, i * slots
        rest = 0.0
        for j in range(slots - 1, -1, -1):
            rest += shares[first + j]
            out[row + j] = rest
        left = counts[i]
        for j in range(slots):
            drawn = 0.0
            if left > 0.0 and shares[first + j] > 0.0:
                u = unit(bits(stream, pixels[i], _SLOT_LANES | np.uint64(j)))
                drawn = binomial(u, left, shares[first + j] / out[row + j])
            out[row + j] = drawn
            left -= drawn


_HEAD = "void(CPointer(int64), CPointer(uint64), CPointer(int64), "
_DOUBLES = "CPointer(float64)"
SIGNATURES = {
    "fill_uniforms": f"{_HEAD}{_DOUBLES})",
    "fill_normals": f"{_HEAD}{_DOUBLES})",
    "fill_poisson": f"{_HEAD}{_DOUBLES}, {_DOUBLES}, {_DOUBLES}, CPointer(uint8))",
    "fill_thin": f"{_HEAD}{_DOUBLES}, {_DOUBLES}, {_DOUBLES})",
}
"""The types of each loop's parameters, for numba."""
