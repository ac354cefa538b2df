"""The loops over pixels that draw random numbers, called by `nscc_runtime.noise.arrays`.

Every number depends only on its key and pixel, and vectors round like scalars, so splitting pixels
over calls does not change results."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc.arrays import Bytes, Floats, Ints
from nscc_runtime.loop import Words, Written, compiled, inlined, loop, record
from nscc_runtime.noise.gaussian import normal, normal_fast
from nscc_runtime.noise.keys import START, bits, both_bits, unit
from nscc_runtime.noise.poisson_law import RATE_CAP, poisson_exact

_Places = Annotated[Ints, "count"]
_Drawn = Written[Annotated[Floats, "count"]]

_FIRST_LANE = np.uint64(0)


@inlined
def uniform(key: np.uint64, pixel: int) -> float:
    """Return the first uniform number, inside (0, 1), of `key` at the place `pixel`."""
    return unit(bits(key, pixel, _FIRST_LANE))


@compiled
def row_normals(key: np.uint64, row: int, cols: int, out: Floats, at: int) -> None:
    """Set out[at + i] to the standard normal number, in single precision, of column i of a row of
    `cols` columns.

    Two columns share the random bits of a place, which saves time. The steps are separate loops,
    because a single loop runs out of processor registers."""
    half = cols // 2
    for i in range(half):
        first, second = both_bits(key, row * cols + i, _FIRST_LANE)
        out[at + i], out[at + half + i] = unit(first), unit(second)
    if cols % 2:
        out[at + cols - 1] = uniform(key, row * cols + half)
    for i in range(cols):
        out[at + i] = float(normal_fast(out[at + i]))


@record
class Draws:
    """The number of draws, and their random key (`nscc_runtime.noise.keys.key`)."""

    count: int
    key: np.uint64


@record
class Groups:
    """What random keys depend on: `seed`, the `stream` of the effect and source (`stream_of`), the
    number of the frame, and how many groups have keys."""

    seed: np.uint64
    stream: np.uint64
    frame: int
    groups: int


@loop
def fill_keys(of: Groups, out: Written[Annotated[Words, "groups"]]) -> None:
    """Set out[g] to the random key of group g (`nscc_runtime.noise.keys.key`)."""
    base = bits(START, of.seed, of.stream)
    for group in range(of.groups):
        out[group] = bits(base, of.frame, np.uint64(group))


@record
class Streams:
    """The seed of random keys, and how many streams have them."""

    seed: np.uint64
    streams: int


@loop
def fill_bases(
    of: Streams,
    stream: Annotated[Words, "streams"],
    out: Written[Annotated[Words, "streams"]],
) -> None:
    """Set out[s] to the first half of the keys of stream[s] (`nscc_runtime.noise.keys.base`), which
    is as in `Groups`."""
    for s in range(of.streams):
        out[s] = bits(START, of.seed, stream[s])


@loop
def fill_uniforms(draws: Draws, pixels: _Places, out: _Drawn) -> None:
    """Set out[i] to the uniform number, inside (0, 1), of the key at the place pixels[i]."""
    for i in range(draws.count):
        out[i] = uniform(draws.key, pixels[i])


@loop
def fill_normals(draws: Draws, pixels: _Places, out: _Drawn) -> None:
    """Set out[i] to the standard normal number of the key at the place pixels[i]."""
    for i in range(draws.count):
        out[i] = uniform(draws.key, pixels[i])
    for i in range(draws.count):
        out[i] = normal(out[i])


@loop
def fill_poisson(
    draws: Draws,
    pixels: _Places,
    rate: Annotated[Floats, "count"],
    out: _Drawn,
    valid: Written[Annotated[Bytes, "count"]],
) -> None:
    """Set out[i] to a Poisson count of mean rate[i], drawn at the place pixels[i], and valid[i] to
    1 if rate[i] is a number, 0 if it is NaN; the count is then 0. Rates are clipped to
    0..`RATE_CAP`."""
    for i in range(draws.count):
        out[i] = uniform(draws.key, pixels[i])
    for i in range(draws.count):
        valid[i] = rate[i] == rate[i]
        drawable = rate[i] if rate[i] > 0.0 else 0.0  # also for NaN
        out[i] = poisson_exact(out[i], drawable if drawable < RATE_CAP else RATE_CAP)
