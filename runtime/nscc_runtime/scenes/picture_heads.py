"""Read the headers of PNG and Radiance files."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.scenes.colour import Transfer
from nscc_runtime.scenes.pages import Note, UnsupportedPicture
from nscc_runtime.scenes.picture_size import refuse_size

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
