"""Bit planes as bitmap files, which the devkit's host application sends to the chip."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_HEADER = 14 + 40


def bitmap(plane: NDArray[np.bool_]) -> bytes:
    """Return a 24-bit Windows bitmap that is white where `plane` bool (rows, cols) is 1.

    The width is rounded up to a multiple of 8 with black pixels, because the devkit packs eight
    pixels of a row into a byte."""
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
    """Return the width in pixels of the bitmap of a bit plane with `cols` columns."""
    return -(-cols // 8) * 8
