"""Convert stored pictures to light, by one rule for exposing and for training."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import prod
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Diagnostic
from nscc_runtime.scenes import picture_size
from nscc_runtime.scenes.colour import Transfer, grey
from nscc_runtime.scenes.errors import clamped, refuse_no_light
from nscc_runtime.scenes.light_arrays import check_type
from nscc_runtime.scenes.pages import Pages
from nscc_runtime.scenes.picture_size import png_head, without_pillow_limit

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


_GREY, _COLOUR = ("1", "L"), ("LA", "P", "PA", "RGB", "RGBA", "RGBX", "CMYK", "YCbCr")
_BAND_ROWS = 256


def large_pages(path: Path) -> Pages | None:
    """Open a single picture of 8 bits per sample that has more than `MOST_PIXELS`.

    Pillow needs 4 bytes per pixel while it decodes a picture. Rows are copied in bands, so a
    picture of `MOST_LARGE_PIXELS` needs at most 1.4 GB, or 1.6 GB if its EXIF orientation rotates
    it.

    Returns
    -------
    Pages or None
        None for smaller pictures, deeper samples, files of several pictures, and pictures that
        Pillow does not identify: the reader of their format opens or refuses them.
    """
    from PIL import Image, ImageOps, UnidentifiedImageError

    try:
        with without_pillow_limit(), Image.open(path) as image:
            pixels, mode = image.width * image.height, image.mode
            count = getattr(image, "n_frames", 1)
    except (UnidentifiedImageError, OSError):
        return None
    most, least = picture_size.MOST_LARGE_PIXELS, picture_size.MOST_PIXELS
    if count != 1 or mode not in (*_GREY, *_COLOUR) or not least < pixels <= most:
        return None

    def read() -> Iterator[NDArray[Any]]:
        with without_pillow_limit(), Image.open(path) as image:
            ImageOps.exif_transpose(image, in_place=True)
            width, height = image.size
            grey = image.mode in _GREY
            samples = np.empty((height, width) if grey else (height, width, 3), np.uint8)
            for top in range(0, height, _BAND_ROWS):
                band = image.crop((0, top, width, min(top + _BAND_ROWS, height)))
                samples[top : top + _BAND_ROWS] = np.asarray(band.convert("L" if grey else "RGB"))
        yield samples

    head = png_head(path) if path.suffix.lower() == ".png" else None
    return Pages(1, read, *((head.transfer, head.notes) if head else ()))


def reduced(bands: Iterator[NDArray[np.float64]], rows: int, size: tuple[int, int]) -> NDArray[Any]:
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
        covered = np.minimum(edges[1:, None], above + 1) - np.maximum(edges[:-1, None], above)
        means += np.maximum(covered, 0) @ narrow
        first += len(band)
    return means * (size[0] / rows)
