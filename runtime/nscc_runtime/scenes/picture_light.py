"""Convert stored pictures to light, by one rule for exposing and for training."""

from __future__ import annotations

from collections.abc import Callable
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Diagnostic
from nscc_runtime.scenes import picture_size
from nscc_runtime.scenes.colour import Transfer, grey
from nscc_runtime.scenes.errors import clamped, refuse_no_light
from nscc_runtime.scenes.large_pictures import reduced
from nscc_runtime.scenes.light_arrays import check_type

_STRIP = 256
"""Number of rows that are converted at a time, to limit memory in double precision."""
_TINY_NEGATIVE = 1e-3
"""Samples below 0 by at most this fraction of the peak (filter ringing) are set to 0."""


def picture_light(
    stored: NDArray[Any],
    transfer: Transfer,
    name: str,
    *,
    channel: int | None = None,
    white: float | None = None,
    window: tuple[slice, slice] | None = None,
    size: tuple[int, int] | None = None,
    warn: Callable[[Diagnostic], object] = lambda _: None,
) -> NDArray[np.float64]:
    """Convert a stored picture to linear light (rows, cols).

    Parameters
    ----------
    stored : array
        (R, C) grey or (R, C, 3) red, green, blue.
    transfer : {"linear", "srgb", "pq", "hlg"}
        The transfer curve of the samples.
    name : str
        Name of the picture in messages.
    channel : int, optional
        0 to 2 for red, green or blue; None for the luminance.
    white : float, optional
        The sample value of white; None for `white_of` the type.
    window : tuple of slice, optional
        Rows and columns to convert. Other pixels may have any value.
    size : tuple of int, optional
        Rows and columns that the caller reduces the light to. A picture of more than `MOST_PIXELS`
        is returned in this size, because its light needs 8 bytes per pixel.
    warn : callable, optional
        Called with a warning (NS0740) about samples slightly below 0, which are set to 0.

    Raises
    ------
    Rejected
        NS0733 for numbers that are not real, NS0736 for values that cannot be light.
    """
    check_type(name, "picture", stored.dtype)
    rows, cols = window or (slice(0, len(stored)), slice(0, stored.shape[1]))
    with np.errstate(invalid="ignore", over="ignore"):  # the census reports invalid values
        floats = stored.dtype.kind == "f"
        peak = float(stored.max(initial=0.0, where=np.isfinite(stored))) if floats else 0.0
        region = stored[rows, cols]
        strips = (region[top : top + _STRIP] for top in range(0, len(region), _STRIP))
        bands = (grey(strip, transfer, channel, white) for strip in strips)
        if size and prod(region.shape[:2]) > picture_size.MOST_PIXELS:
            values = reduced(bands, len(region), size)
        else:
            values = np.concatenate([*bands])
        low = float(values.min())
    if low < 0 and low >= -_TINY_NEGATIVE * peak:
        count = int(np.count_nonzero(values < 0))
        values = np.maximum(values, 0.0)
        warn(clamped(name, count, values.size, low))
    refuse_no_light(values, name, (rows.start, cols.start))
    return values
