"""The loops over pixels that draw random numbers, called by `nscc_runtime.noise.arrays`.

Every number depends only on its key and pixel, and vectors round like scalars, so splitting pixels
over calls does not change results."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc.arrays import Bytes, Floats, Ints
from nscc_runtime.loop import Written, compiled, inlined, loop, record
from nscc_runtime.noise.gaussian import normal, normal_fast
from nscc_runtime.noise.keys import bits, unit
from nscc_runtime.noise.poisson_law import (
    poisson_exact,
)

_Places = Annotated[Ints, "count"]
_Drawn = Written[Annotated[Floats, "count"]]

BLOCK = 512
"""Number of pixels per block. Light varies little along a row, so most blocks need one method."""

_FIRST_LANE = np.uint64(0)


@inlined
def uniform(key: np.uint64, pixel: int) -> float:
    """Return the first uniform number, inside (0, 1), of `key` at the place `pixel`."""
    return unit(bits(key, pixel, _FIRST_LANE))


@compiled
def _drawable(rate: float, cap: float) -> float:
    """Return `rate` clipped to 0..`cap`; 0 for NaN, whose count the caller marks as invalid."""
    if rate > 0.0:
        return rate if rate < cap else cap
    return 0.0


@record
class Draws:
    """The number of draws, and their random key (`nscc_runtime.noise.keys.key`)."""

    count: int
    key: np.uint64


@loop
def fill_uniforms(draws: Draws, pixels: _Places, out: _Drawn) -> None:
    """Set out[i] to the uniform number, inside (0, 1), of the key at the place pixels[i]."""
    for i in range(draws.count):
        out[i] = uniform(draws.key, pixels[i])


@record
class NormalDraws:
    """The number of draws, their random key, and whether single precision suffices (1) or not
    (0)."""

    count: int
    key: np.uint64
    single: int


@loop
def fill_normals(draws: NormalDraws, pixels: _Places, out: _Drawn) -> None:
    """Set out[i] to the standard normal number of the key at the place pixels[i], in single or
    double precision as `draws.single` says."""
    for i in range(draws.count):
        out[i] = uniform(draws.key, pixels[i])
    if draws.single:
        for i in range(draws.count):
            out[i] = float(normal_fast(out[i]))
        return
    for i in range(draws.count):
        out[i] = normal(out[i])


@record
class Counts:
    """Options of `fill_poisson`: the number of draws, their random key, and the rate `cap` to which
    larger rates are clipped."""

    count: int
    key: np.uint64
    cap: float


@loop
def fill_poisson(
    counts: Counts,
    pixels: _Places,
    rate: Annotated[Floats, "count"],
    out: _Drawn,
    valid: Written[Annotated[Bytes, "count"]],
) -> None:
    """Set out[i] to a Poisson count of mean rate[i], drawn at the place pixels[i], and valid[i] to
    1 if rate[i] is a number, 0 if it is NaN; the count is then 0. Rates are clipped to
    0..`counts.cap`."""
    for i in range(counts.count):
        out[i] = uniform(counts.key, pixels[i])
    for i in range(counts.count):
        valid[i] = rate[i] == rate[i]
        out[i] = poisson_exact(out[i], _drawable(rate[i], counts.cap))
