"""Random numbers of arrays of pixels, by the compiled loops.

`pixels` are indices row * cols + col in the whole array, in any order and of any shape; results
have the same shape. A call uses one thread and releases the GIL. Splitting `pixels` over threads
does not change results."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Bools, Floats, Ints

Pixels = Ints

RATE_CAP = 1e12
"""Upper limit of rates, infinity included. No well contains this number of electrons."""


def uniforms(key: np.uint64, pixels: Pixels) -> Floats:
    """Return one uniform number inside (0, 1) for each of `pixels`, places of any shape, in this
    shape. It is an odd multiple of 2**-53 that depends on `key` and the pixel's place only, so
    equal places have equal numbers."""
    from nscc_runtime.noise.noise_loops import Draws, fill_uniforms

    places, out = _places(pixels), np.empty(np.shape(pixels))
    fill_uniforms(draws=Draws(count=places.size, key=key), pixels=places, out=out.reshape(-1))
    return out


def normals(key: np.uint64, pixels: Pixels, *, single: bool = False) -> Floats:
    """Return one standard normal number for each of `pixels`, places of any shape, in this shape:
    the normal quantiles of `uniforms` of the same key and pixel. The relative error is below 1e-12
    within +-8.21, and numbers are monotonic in `uniforms`. With `single`, the error is below 2e-6,
    and drawing takes a third of the time."""
    from nscc_runtime.noise.noise_loops import NormalDraws, fill_normals

    places, out = _places(pixels), np.empty(np.shape(pixels))
    draws = NormalDraws(count=places.size, key=key, single=single)
    fill_normals(draws=draws, pixels=places, out=out.reshape(-1))
    return out


def poisson(key: np.uint64, pixels: Pixels, rate: Floats) -> tuple[Floats, Bools]:
    """Return Poisson counts with mean `rate` (shape of `pixels`), and where they are valid.

    Rates below 0 count as 0, rates above `RATE_CAP` as `RATE_CAP`. For a NaN rate the count is 0
    and not valid. Counts never decrease with the rate: they are the inverse of the distribution
    function (`nscc_runtime.noise.poisson_law`) at `uniforms` of the same key and pixel."""
    from nscc_runtime.noise.noise_loops import Counts, fill_poisson

    places, out = _places(pixels), np.empty(np.shape(pixels))
    valid = np.empty(np.shape(pixels), np.bool_)
    fill_poisson(
        counts=Counts(count=places.size, key=key, cap=RATE_CAP),
        pixels=places,
        rate=_floats(rate).reshape(-1),
        out=out.reshape(-1),
        valid=valid.view(np.uint8).reshape(-1),
    )
    return out, valid


def _places(pixels: Pixels) -> Pixels:
    """Return `pixels` of any shape as a contiguous int64 array (count,), without a copy if it is
    one already."""
    return np.require(pixels, np.int64, ["C", "A"]).reshape(-1)


def _floats(values: Floats) -> Floats:
    """Return `values` as a contiguous float64 array of the same shape, without a copy if it is one
    already."""
    return np.require(values, np.float64, ["C", "A"])
