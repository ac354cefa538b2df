"""The loops over pixels that draw random numbers, called by `nscc_runtime.noise.arrays`.

Every number depends only on its key and pixel, and vectors round like scalars, so splitting pixels
over calls does not change results."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc_runtime.loop import Bytes, Floats, Ints, Written, compiled, inlined, loop, record
from nscc_runtime.noise.binomial_law import binomial
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.keys import bits, unit
from nscc_runtime.noise.poisson_law import (
    poisson_exact,
)

_Places = Annotated[Ints, "count"]
_Drawn = Written[Annotated[Floats, "count"]]

BLOCK = 512
"""Number of pixels per block. Light varies little along a row, so most blocks need one method."""

_FIRST_LANE = np.uint64(0)
_SLOT_LANES = np.uint64(1 << 32)


@inlined
def uniform(key: np.uint64, pixel: int) -> float:
    """Return the first uniform number of a key at a pixel."""
    return unit(bits(key, pixel, _FIRST_LANE))


@compiled
def _drawable(rate: float, cap: float) -> float:
    """Return the rate clipped to [0, cap], 0 for NaN."""
    if rate > 0.0:
        return rate if rate < cap else cap
    return 0.0


@record
class Draws:
    """The number of draws and their key."""

    count: int
    key: np.uint64


@loop
def fill_uniforms(draws: Draws, pixels: _Places, out: _Drawn) -> None:
    """Set out[i] to the uniform number of the key at pixels[i]."""
    for i in range(draws.count):
        out[i] = uniform(draws.key, pixels[i])


@loop
def fill_normals(draws: Draws, pixels: _Places, out: _Drawn) -> None:
    """Set out[i] to the standard normal number of the key at pixels[i]."""
    for i in range(draws.count):
        out[i] = normal(uniform(draws.key, pixels[i]))


@record
class Counts:
    """Options of `fill_poisson`: rates above `cap` count as `cap`."""

    count: int
    key: np.uint64
    cap: float


@loop
def fill_poisson(
    counts: Counts, pixels: _Places, rate: Annotated[Floats, "count"], out: _Drawn,
    valid: Written[Annotated[Bytes, "count"]],
) -> None:  # fmt: skip
    """Set out[i] to a Poisson count of rate[i], drawn at pixels[i], and valid[i] to whether rate[i]
    is a number."""
    for i in range(counts.count):
        out[i] = uniform(counts.key, pixels[i])
    for i in range(counts.count):
        valid[i] = rate[i] == rate[i]
        out[i] = poisson_exact(out[i], _drawable(rate[i], counts.cap))


@compiled
def halved(
    stream: np.uint64, pixel: int, node: int, count: float, left_share: float, right_share: float
) -> float:
    """Return the part of `count` in the left half of a tree node whose halves have these shares."""
    if count <= 0.0 or left_share <= 0.0:
        return 0.0
    if right_share <= 0.0:
        return count
    u = unit(bits(stream, pixel, _SLOT_LANES | np.uint64(node)))
    return binomial(u, count, left_share / (left_share + right_share))


@record
class Spread:
    """Options of `fill_thin`. `stride` is `slots`, or 0 if all pixels have the same shares."""

    count: int
    key: np.uint64
    slots: int
    stride: int


@loop
def fill_thin(
    spread: Spread, pixels: _Places, counts: Annotated[Floats, "count"],
    shares: Annotated[Floats, "sharers slots"], out: Written[Annotated[Floats, "count slots"]],
) -> None:  # fmt: skip
    """Distribute counts[i] over the slots of out[i] in proportion to shares[i * stride ..]. Tree
    nodes are numbered as in a heap: 1 is the root."""
    slots, stride, stream = spread.slots, spread.stride, spread.key
    leaf_count = 1
    while leaf_count < slots:
        leaf_count *= 2
    for i in range(spread.count):
        first, row = i * stride, i * slots
        if slots > 0:
            out[row] = counts[i]
        size = leaf_count // 2
        while size > 0:
            for start in range(0, slots, 2 * size):
                middle, end = start + size, min(start + 2 * size, slots)
                if middle < slots:
                    left_share, right_share = 0.0, 0.0
                    for j in range(start, middle):
                        left_share += shares[first + j]
                    for j in range(middle, end):
                        right_share += shares[first + j]
                    count, node = out[row + start], (leaf_count + start) // (2 * size)
                    drawn = halved(stream, pixels[i], node, count, left_share, right_share)
                    out[row + start] = drawn
                    out[row + middle] = count - drawn
            size //= 2
