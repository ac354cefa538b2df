"""Convert stored pictures to light, by one rule for exposing and for training."""

from __future__ import annotations

from collections.abc import Iterator
from math import prod

import numpy as np

from nscc.arrays import Array, Floats
from nscc_runtime.scene_settings import Transfer
from nscc_runtime.scenes import pages
from nscc_runtime.scenes.colour import Colours, grey, white_of
from nscc_runtime.scenes.errors import Warn, clamped, refuse_no_light, unheard
from nscc_runtime.scenes.light_arrays import check_type

_STRIP = 256
"""Number of rows that are converted at a time, to limit memory in double precision."""
_TINY_NEGATIVE = 1e-3
"""Samples below 0 by at most this fraction of the peak (filter ringing) are set to 0."""


def picture_light(
    stored: Array,
    colours: Transfer | Colours,
    name: str,
    *,
    channel: int | None = None,
    white: float | None = None,
    window: tuple[slice, slice] | None = None,
    size: tuple[int, int] | None = None,
    warn: Warn = unheard,
) -> Floats:
    """Convert a stored picture to linear light (rows, cols).

    Parameters
    ----------
    stored : array
        (R, C) grey or (R, C, 3) red, green, blue.
    colours : Colours or {"linear", "srgb", "pq", "hlg"}
        The meaning of the samples, or a standard transfer curve.
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
        # Integers cannot be slightly negative: peak 0 tolerates nothing.
        peak = float(stored.max(initial=0.0, where=np.isfinite(stored))) if floats else 0.0
        peak /= white or white_of(stored.dtype)  # as a fraction of white, like the light
        region = stored[rows, cols]
        strips = (region[top : top + _STRIP] for top in range(0, len(region), _STRIP))
        bands = (grey(strip, colours, channel, white) for strip in strips)
        if size and prod(region.shape[:2]) > pages.MOST_PIXELS:
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


def reduced(bands: Iterator[Floats], rows: int, size: tuple[int, int]) -> Array:
    """Reduce a picture, given as bands of consecutive rows, by means over areas.

    Parameters
    ----------
    bands : iterator of array
        Light, each (band rows, cols).
    rows : int
        Number of rows of all bands together.
    size : tuple of int
        Rows and columns of the result, at most those of the picture.

    Returns
    -------
    array
        Light of shape `size`, float64: the mean over the area that each new pixel covers. A pixel
        on the border of two areas counts for both, in proportion to its overlap.
    """
    import cv2

    means = np.zeros(size)
    edges = np.linspace(0, rows, size[0] + 1)
    first = 0
    for band in bands:
        narrow = cv2.resize(band, (size[1], len(band)), interpolation=cv2.INTER_AREA)
        above = first + np.arange(len(band))
        # How much of each row of the band (columns of `covered`) lies in each new row.
        covered = np.minimum(edges[1:, None], above + 1) - np.maximum(edges[:-1, None], above)
        means += np.maximum(covered, 0) @ narrow
        first += len(band)
    return means * (size[0] / rows)
