"""The loops over pixels that `nscc_runtime.noise.compiled` makes machine code of.

They take bare pointers, allocate nothing and raise nothing; `nscc_runtime.noise.arrays` has checked
what they are given. Every number depends on its key and pixel alone, and nothing is rounded
otherwise in a vector than alone, so that how pixels are split over calls changes no bit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.noise.binomial_law import binomial
from nscc_runtime.noise.counter import bits, compiled, inlined, unit
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.poisson_law import (
    SEARCH_BELOW,
    SETTLED_ABOVE,
    poisson_exact,
    poisson_fast,
    quantile,
    search,
)

# Pointers; typed as arrays, which is how they are used.
Keys = NDArray[np.uint64]
Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Flags = NDArray[np.uint8]

_BLOCK = 512
"""Pixels drawn together: light differs little along a row, so most blocks are of one kind."""

_FIRST_LANE = np.uint64(0)
_SLOT_LANES = np.uint64(1 << 32)


@inlined
def uniform(key: np.uint64, pixel: int) -> float:
    """The first uniform number of a key at a pixel."""
    return unit(bits(key, pixel, _FIRST_LANE))


@compiled
def _drawable(rate: float, cap: float) -> float:
    """The rate within [0, cap], 0 for NaN."""
    if rate > 0.0:
        return rate if rate < cap else cap
    return 0.0


@compiled
def _formula(rate: Floats, top: float, first: int, stop: int, out: Floats) -> None:
    """out[i] := the formula's count at the uniform number out[i]: no branch, so LLVM makes vectors.

    Rates that have no formula are taken as SEARCH_BELOW.
    """
    for i in range(first, stop):
        out[i] = normal(out[i])
    for i in range(first, stop):
        known = rate[i] if rate[i] > SEARCH_BELOW else SEARCH_BELOW
        x = np.floor(quantile(out[i], known if known < top else top))
        out[i] = x if x > 0.0 else 0.0


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
    for first in range(0, count, _BLOCK):
        stop = min(first + _BLOCK, count)
        low = 0
        for i in range(first, stop):
            valid[i] = rate[i] == rate[i]
            low += not rate[i] >= SETTLED_ABOVE
        for i in range(first, stop):
            out[i] = uniform(stream, pixels[i])
        if sizes[1]:
            for i in range(first, stop):
                out[i] = poisson_exact(out[i], _drawable(rate[i], top))
        elif low == stop - first:
            for i in range(first, stop):
                known, u = _drawable(rate[i], top), out[i]
                # The search is made part of this loop; the whole sampler would stay a call.
                out[i] = search(u, known) if known < SEARCH_BELOW else poisson_fast(u, known)
        else:
            _formula(rate, top, first, stop, out)
            # The uniform numbers are gone; only those that are needed once more are made again.
            for i in range(first, stop if low else first):
                if not rate[i] >= SETTLED_ABOVE:
                    u = uniform(stream, pixels[i])
                    out[i] = poisson_fast(u, _drawable(rate[i], top))


@compiled
def halved(
    stream: np.uint64, pixel: int, node: int, count: float, left: float, right: float
) -> float:
    """How many of `count` fall into the left half of a node whose halves have these shares."""
    if count <= 0.0 or left <= 0.0:
        return 0.0
    if right <= 0.0:
        return count
    u = unit(bits(stream, pixel, _SLOT_LANES | np.uint64(node)))
    return binomial(u, count, left / (left + right))


def fill_thin(
    sizes: Ints, key: Keys, pixels: Ints, counts: Floats, shares: Floats, out: Floats
) -> None:
    """Spread counts[i] over the slots of out[i] in proportion to shares[i * stride ..].

    `sizes` are how many pixels, how many slots, and the stride: slots, or 0 for shares that all
    pixels have in common. Halves are numbered as in a heap: 1 is the whole.
    """
    slots, stride, stream = sizes[1], sizes[2], key[0]
    whole = 1
    while whole < slots:
        whole *= 2
    for i in range(sizes[0]):
        first, row = i * stride, i * slots
        if slots > 0:
            out[row] = counts[i]
        size = whole // 2
        while size > 0:
            for start in range(0, slots, 2 * size):
                middle, end = start + size, min(start + 2 * size, slots)
                if middle < slots:
                    left, right = 0.0, 0.0
                    for j in range(start, middle):
                        left += shares[first + j]
                    for j in range(middle, end):
                        right += shares[first + j]
                    count, node = out[row + start], (whole + start) // (2 * size)
                    drawn = halved(stream, pixels[i], node, count, left, right)
                    out[row + start] = drawn
                    out[row + middle] = count - drawn
            size //= 2


_HEAD = "void(CPointer(int64), CPointer(uint64), CPointer(int64), "
_DOUBLES = "CPointer(float64)"
SIGNATURES = {
    "fill_uniforms": f"{_HEAD}{_DOUBLES})",
    "fill_normals": f"{_HEAD}{_DOUBLES})",
    "fill_poisson": f"{_HEAD}{_DOUBLES}, {_DOUBLES}, {_DOUBLES}, CPointer(uint8))",
    "fill_thin": f"{_HEAD}{_DOUBLES}, {_DOUBLES}, {_DOUBLES})",
}
"""The types of each loop's parameters, for numba."""
