"""Random numbers of arrays of pixels, by the compiled loops.

`pixels` are indices row * cols + col in the whole array, in any order and of any shape; results
have the same shape. A call uses one thread and releases the GIL. Splitting `pixels` over threads
does not change results."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Bools, Floats, Ints
from nscc_runtime.loop import Words
from nscc_runtime.noise.keys import stream_of
from nscc_runtime.noise.noise_loops import (
    Draws,
    Groups,
    Streams,
    fill_bases,
    fill_keys,
    fill_normals,
    fill_poisson,
    fill_uniforms,
)

Pixels = Ints


def keys(seed: int, effect: int, source: int, frame: int, groups: int) -> Words:
    """Return the random keys (`nscc_runtime.noise.keys.key`) of the first `groups` groups."""
    out, stream = np.empty(groups, np.uint64), np.uint64(stream_of(effect, source))
    fill_keys(of=Groups(seed=np.uint64(seed), stream=stream, frame=frame, groups=groups), out=out)
    return out


def bases(seed: int, streams: Words, source: int) -> Words:
    """Return the parts of the random keys of `streams`, numbers of effects, that do not depend on
    frame and group (`nscc_runtime.noise.keys.base`)."""
    out, stream = np.empty_like(streams), streams | np.uint64(stream_of(0, source))
    fill_bases(of=Streams(seed=np.uint64(seed), streams=len(streams)), stream=stream, out=out)
    return out


def uniforms(key: np.uint64, pixels: Pixels) -> Floats:
    """Return one uniform number inside (0, 1) for each of `pixels`, places of any shape, in this
    shape. It is an odd multiple of 2**-53 that depends on `key` and the pixel's place only, so
    equal places have equal numbers."""
    places, out = _places(pixels), np.empty(np.shape(pixels))
    fill_uniforms(draws=Draws(count=places.size, key=key), pixels=places, out=out.reshape(-1))
    return out


def normals(key: np.uint64, pixels: Pixels) -> Floats:
    """Return one standard normal number for each of `pixels`, places of any shape, in this shape:
    the normal quantiles of `uniforms` of the same key and pixel. The relative error is below 1e-12
    within +-8.21, and numbers are monotonic in `uniforms`."""
    places, out = _places(pixels), np.empty(np.shape(pixels))
    fill_normals(draws=Draws(count=places.size, key=key), pixels=places, out=out.reshape(-1))
    return out


def poisson(key: np.uint64, pixels: Pixels, rate: Floats) -> tuple[Floats, Bools]:
    """Return Poisson counts with mean `rate` (shape of `pixels`), and where they are valid.

    Rates below 0 count as 0, rates above `RATE_CAP` as `RATE_CAP`. For a NaN rate the count is 0
    and not valid. Counts never decrease with the rate: they are the inverse of the distribution
    function (`nscc_runtime.noise.poisson_law`) at `uniforms` of the same key and pixel."""
    places, out = _places(pixels), np.empty(np.shape(pixels))
    valid = np.empty(np.shape(pixels), np.bool_)
    fill_poisson(
        draws=Draws(count=places.size, key=key),
        pixels=places,
        rate=np.require(rate, np.float64, ["C", "A"]).reshape(-1),
        out=out.reshape(-1),
        valid=valid.view(np.uint8).reshape(-1),
    )
    return out, valid


def _places(pixels: Pixels) -> Pixels:
    """Return `pixels` of any shape as a contiguous int64 array (count,), without a copy if it is
    one already."""
    return np.require(pixels, np.int64, ["C", "A"]).reshape(-1)
