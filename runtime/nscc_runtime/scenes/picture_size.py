"""The size of a picture by its header, so that a huge one is refused before it is decoded."""

from __future__ import annotations

import re
from pathlib import Path

from nscc.diagnostics.rejection import rejected

MOST_PIXELS = 1 << 26
"""Of a picture or of a frame of a clip: 8192 x 8192, 67 million."""

_HEADER_BYTES = 1 << 12
_SIZES = (
    re.compile(rb"^#\?.*?[-+]Y +(?P<rows>\d+) +[-+]X +(?P<cols>\d+)\s", re.DOTALL),  # Radiance
    re.compile(rb"^P[Ff]\s+(?P<cols>\d+)\s+(?P<rows>\d+)\s"),  # PFM
)


def refuse_huge(path: Path) -> None:
    """NS0734 for a picture file whose header states more than MOST_PIXELS; other faults pass."""
    size = _stated_size(path)
    if size is not None:
        refuse_size(path, *size)


def refuse_size(path: Path, rows: int, cols: int) -> None:
    """NS0734 for a picture or a frame of more than MOST_PIXELS."""
    if rows * cols > MOST_PIXELS:
        raise rejected(
            "NS0734",
            f"'{path}' is {rows:,} x {cols:,} pixels: at most {MOST_PIXELS:,} are read",
            helps=("make the picture smaller, or cut out a part of it",),
        )


def _stated_size(path: Path) -> tuple[int, int] | None:
    """Rows and columns; None where the header does not tell them."""
    with open(path, "rb") as file:
        head = file.read(_HEADER_BYTES)
    for size in _SIZES:
        match = size.match(head)
        if match:
            return int(match["rows"]), int(match["cols"])
    if head.startswith(b"\x76\x2f\x31\x01"):
        return _exr_size(path)
    from PIL import Image

    bound, Image.MAX_IMAGE_PIXELS = Image.MAX_IMAGE_PIXELS, None  # only the header is read
    try:
        with Image.open(path) as image:
            return image.height, image.width
    except Exception:  # Pillow's plugins raise what they like; the reader says what is wrong
        return None
    finally:
        Image.MAX_IMAGE_PIXELS = bound


def _exr_size(path: Path) -> tuple[int, int] | None:
    """The size of the largest part of an OpenEXR file."""
    import OpenEXR

    try:
        with OpenEXR.File(str(path), header_only=True) as file:
            sizes = []
            for part in file.parts:
                low, high = part.header["dataWindow"]
                sizes.append((int(high[1] - low[1]) + 1, int(high[0] - low[0]) + 1))
    except Exception:  # OpenEXR's exceptions differ from version to version
        return None
    return max(sizes, key=lambda size: size[0] * size[1], default=None)
