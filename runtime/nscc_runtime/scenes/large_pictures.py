"""Large pictures of 8 bits per sample: decoded once, copied and reduced in bands of rows."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.scenes import picture_size
from nscc_runtime.scenes.pages import Pages
from nscc_runtime.scenes.picture_heads import png_head
from nscc_runtime.scenes.picture_size import without_pillow_limit

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
    from PIL import Image, UnidentifiedImageError

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
        yield _samples(path)

    head = png_head(path) if path.suffix.lower() == ".png" else None
    return Pages(1, read, *((head.transfer, head.notes) if head else ()))


def _samples(path: Path) -> NDArray[np.uint8]:
    from PIL import Image, ImageOps

    with without_pillow_limit(), Image.open(path) as image:
        ImageOps.exif_transpose(image, in_place=True)
        width, height = image.size
        grey = image.mode in _GREY
        samples = np.empty((height, width) if grey else (height, width, 3), np.uint8)
        for top in range(0, height, _BAND_ROWS):
            band = image.crop((0, top, width, min(top + _BAND_ROWS, height)))
            samples[top : top + _BAND_ROWS] = np.asarray(band.convert("L" if grey else "RGB"))
    return samples


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
