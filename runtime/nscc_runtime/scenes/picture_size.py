"""Check the size of a picture by its header, before it is decoded."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from math import prod
from pathlib import Path
from typing import Any

from nscc.diagnostics.rejection import rejected

MOST_PIXELS = 1 << 26
"""Largest number of pixels of a picture or of a frame of a clip: 8192 x 8192, 67 million."""

MOST_LARGE_PIXELS = 3 * MOST_PIXELS
"""Largest number of pixels of a scene that is one picture of 8 bits per sample: 201 million."""

_MOST_SAMPLES = 4
"""Largest number of samples of an OpenEXR file, in all parts and channels, per MOST_PIXELS."""

_HEADER_BYTES = 1 << 16
_WINDOWS = ("displayWindow", "dataWindow")
_PFM = re.compile(rb"^P[Ff]\s+(?P<cols>\d+)\s+(?P<rows>\d+)\s")
_PNG = re.compile(rb"^\x89PNG\r\n\x1a\n....IHDR(?P<cols>.{4})(?P<rows>.{4})", re.DOTALL)
_RADIANCE = re.compile(rb"[-+][XY]\s+(\d+)\s+[-+][XY]\s+(\d+)")


def refuse_huge(path: Path) -> None:
    """Raise NS0734 if the header states more than MOST_PIXELS; invalid headers are ignored."""
    size = stated_size(path)
    if size is not None:
        refuse_size(path, *size)


def refuse_size(path: Path, rows: int, cols: int) -> None:
    """Raise Rejected (NS0734) for a picture or a frame of more than MOST_PIXELS."""
    if rows * cols > MOST_PIXELS:
        raise rejected(
            "NS0734",
            f"'{path}' has {rows:,} x {cols:,} pixels, but at most {MOST_PIXELS:,} are allowed",
            helps=(
                "reduce or crop the picture; a single picture with 8 bits per sample may "
                f"have {MOST_LARGE_PIXELS:,} pixels",
            ),
        )


def stated_size(path: Path) -> tuple[int, int] | None:
    """Return rows and columns by the header of a picture; None if it does not state them."""
    with open(path, "rb") as file:
        head = file.read(_HEADER_BYTES)
    if match := _PFM.match(head):
        return int(match["rows"]), int(match["cols"])
    if match := _PNG.match(head):
        return int.from_bytes(match["rows"], "big"), int.from_bytes(match["cols"], "big")
    if head.startswith(b"#?"):  # a comment may look like the line that says the size
        sizes = [(int(lines), int(count)) for lines, count in _RADIANCE.findall(head)]
        return max(sizes, key=prod, default=None)
    if head.startswith(b"\x76\x2f\x31\x01"):
        return _exr_size(path)
    from PIL import Image

    try:
        with without_pillow_limit(), Image.open(path) as image:  # only the header is read
            return image.height, image.width
    except Exception:  # Pillow's plugins raise any exception; the reader reports it
        return None


@contextmanager
def without_pillow_limit() -> Iterator[None]:
    """Switch off Pillow's limit on pixels in a with block: this module defines the limits."""
    from PIL import Image

    pillow_limit, Image.MAX_IMAGE_PIXELS = Image.MAX_IMAGE_PIXELS, None
    try:
        yield
    finally:
        Image.MAX_IMAGE_PIXELS = pillow_limit


def _exr_size(path: Path) -> tuple[int, int] | None:
    """Return the size (rows, cols) of the display window of an OpenEXR file's first part; None if
    it cannot be read.

    Raises Rejected (NS0734) for a large window, and for too many samples in all parts, which are
    decoded together."""
    import OpenEXR

    try:
        with OpenEXR.File(str(path), header_only=True) as file:
            headers = [file_part.header for file_part in file.parts]
            sizes = [_window(header[name]) for name in _WINDOWS for header in headers]
            samples = sum(prod(_window(h["dataWindow"])) * len(h["channels"]) for h in headers)
    except Exception:  # OpenEXR's exceptions differ from version to version
        return None
    if samples > _MOST_SAMPLES * MOST_PIXELS:
        raise rejected(
            "NS0734",
            f"'{path}' has {samples:,} samples in its parts and channels, but at most "
            f"{_MOST_SAMPLES * MOST_PIXELS:,} are allowed",
            helps=("save the required picture in a separate file",),
        )
    refuse_size(path, *max(sizes, key=prod))
    return sizes[0]


def _window(corners: Any) -> tuple[int, int]:
    (x0, y0), (x1, y1) = corners
    return int(y1) - int(y0) + 1, int(x1) - int(x0) + 1
