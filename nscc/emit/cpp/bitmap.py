"""Planes as pictures that the devkit's host application can send."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_HEADER = 14 + 40


def bitmap(plane: NDArray[np.bool_]) -> bytes:
    """A Windows bitmap of 24 bits a pixel, white where `plane` bool (rows, cols) is 1.

    Its width is the next multiple of 8, black beyond the plane: the devkit packs eight pixels
    into a byte, and a row of its images begins with one.
    """
    rows, cols = plane.shape
    width = image_width(cols)
    pixels = np.zeros((rows, width, 3), dtype=np.uint8)
    pixels[:, :cols][plane] = 255
    data = pixels[::-1].tobytes()  # bottom row first; a multiple of 8 needs no padding
    sizes = (40, width, rows, 1 | 24 << 16, 0, len(data), 2835, 2835, 0, 0)
    info = b"".join(size.to_bytes(4, "little") for size in sizes)
    start = (_HEADER + len(data), 0, _HEADER)
    return b"BM" + b"".join(size.to_bytes(4, "little") for size in start) + info + data


def image_width(cols: int) -> int:
    """Pixels in a row of the image of a plane of `cols` columns."""
    return -(-cols // 8) * 8
