"""Check the size of a picture by its header, before it is decoded."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc_runtime.scenes.colour import Transfer
from nscc_runtime.scenes.pages import Note, UnsupportedPicture

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


TRANSFERS: dict[int, Transfer] = {
    **dict.fromkeys((1, 6, 13, 14, 15), "srgb"), 8: "linear", 16: "pq", 18: "hlg",
}  # fmt: skip
"""Transfer curves by their number in ITU-T H.273. Displays show the camera curves of BT.709 and
BT.2020 nearly like sRGB."""
_LINEAR_GAMMA, _SRGB_GAMMA = 100_000, 45_455
_GAMMA_SLACK = 500


@dataclass(frozen=True)
class PngHead:
    """The header of a PNG file. `animated`: whether it has several frames. `transfer`: None if the
    file names no transfer curve."""

    animated: bool
    transfer: Transfer | None
    notes: tuple[Note, ...]


def png_head(path: Path) -> PngHead:
    """Read the chunks of a PNG file before its samples."""
    chunks: dict[bytes, bytes] = {}
    with open(path, "rb") as file:
        file.seek(8)
        while len(start := file.read(8)) == 8 and start[4:] != b"IDAT":
            size = int.from_bytes(start[:4], "big")
            if start[4:] in (b"acTL", b"cICP", b"gAMA", b"sRGB"):
                chunks[start[4:]] = file.read(size)
                file.seek(4, 1)
            else:
                file.seek(size + 4, 1)
    transfer, notes = _png_transfer(chunks)
    return PngHead(b"acTL" in chunks, transfer, notes)


def _png_transfer(chunks: dict[bytes, bytes]) -> tuple[Transfer | None, tuple[Note, ...]]:
    """Return the curve of cICP, sRGB or gAMA, in this order (None without any), and notes."""
    help_text = "--transfer selects another curve"
    if len(chunks.get(b"cICP", b"")) == 4:
        number = chunks[b"cICP"][1]
        if number in TRANSFERS:
            return TRANSFERS[number], ()
        text = f"names the unknown transfer curve {number} (cICP): the sRGB curve is used"
        return None, ((text, help_text),)
    if b"sRGB" in chunks or len(chunks.get(b"gAMA", b"")) != 4:
        return None, ()
    gamma = int.from_bytes(chunks[b"gAMA"], "big")
    if abs(gamma - _LINEAR_GAMMA) <= _GAMMA_SLACK:
        return "linear", ()
    if abs(gamma - _SRGB_GAMMA) <= _GAMMA_SLACK:
        return "srgb", ()
    return None, ((f"names gamma {gamma / 100000.0:g} (gAMA): the sRGB curve is used", help_text),)


_RESOLUTION = re.compile(rb"^([+-])([XY]) (\d+) ([+-])([XY]) (\d+)$", re.MULTILINE)


def read_radiance(
    path: Path, data: NDArray[np.uint8], decode: Callable[[NDArray[np.uint8]], NDArray[Any]]
) -> NDArray[Any]:
    """Read the picture of a Radiance file in any of its eight orientations.

    `decode` decodes the bytes of a file whose rows run from top to bottom and left to right. Raises
    UnsupportedPicture for colours other than red, green, blue."""
    head, blank, body = data.tobytes().partition(b"\n\n")
    line, newline, samples = body.partition(b"\n")
    if b"FORMAT=32-bit_rle_xyze" in head:
        raise UnsupportedPicture(
            "its colours are CIE XYZ (FORMAT=32-bit_rle_xyze)",
            "convert it to FORMAT=32-bit_rle_rgbe: `ra_xyze -r IN.hdr OUT.hdr`",
        )
    resolution = _RESOLUTION.fullmatch(line)
    if resolution is None or resolution[2] == resolution[5]:
        return decode(data)
    lines, count = int(resolution[3]), int(resolution[6])
    refuse_size(path, lines, count)
    usual = b"-Y %d +X %d" % (lines, count)
    picture = decode(np.frombuffer(head + blank + usual + newline + samples, np.uint8))
    signs = {resolution[2]: resolution[1], resolution[5]: resolution[4]}
    if resolution[2] == b"X":
        picture = picture.swapaxes(0, 1)
    if signs[b"Y"] == b"+":
        picture = picture[::-1]
    return np.ascontiguousarray(picture[:, ::-1] if signs[b"X"] == b"-" else picture)
