"""Read Radiance, PFM and PNG pictures by OpenCV, which keeps 16 and 32 bits per sample."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from math import prod
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Bytes
from nscc_runtime.scenes.pages import Pages, UnsupportedPicture, head_of
from nscc_runtime.scenes.pillow_pictures import pillow_pages

_PFM = re.compile(rb"^P[Ff]\s+(?P<cols>\d+)\s+(?P<rows>\d+)\s")
_RADIANCE = re.compile(rb"[-+][XY]\s+(\d+)\s+[-+][XY]\s+(\d+)")
_RESOLUTION = re.compile(rb"^([+-])([XY]) (\d+) ([+-])([XY]) (\d+)$", re.MULTILINE)
_PNG_BITS_AT = 24
"""Where the number of bits per sample lies in a PNG file."""


def png_pages(path: Path) -> Pages:
    """Open the PNG file `path`: by OpenCV for 16 bits per sample, else by Pillow, which composes
    animations. Raises the errors of Pillow for a damaged file."""
    pages = pillow_pages(path)
    if head_of(path)[_PNG_BITS_AT] <= 8 or pages.durations_s is not None:
        return pages
    return replace(pages, read=_reader(path, decoded), has_8_bits=False)


def pfm_pages(path: Path) -> Pages:
    """Return the one picture of the PFM file `path`; raise ValueError if its size is not stated."""
    match = _PFM.match(head_of(path))
    if match is None:
        raise ValueError("its header does not state the numbers of rows and columns")
    return Pages(((int(match["rows"]), int(match["cols"])),), count=1, read=_reader(path, decoded))


def radiance_pages(path: Path) -> Pages:
    """Open the one picture of the Radiance file `path`. A comment may look like the line with the
    size, so the largest size counts. Raises ValueError without a size."""
    sizes = [(int(lines), int(count)) for lines, count in _RADIANCE.findall(head_of(path))]
    if not sizes:
        raise ValueError("its header does not state the numbers of rows and columns")
    return Pages((max(sizes, key=prod),), count=1, read=_reader(path, _radiance))


def _reader(path: Path, decode: Callable[[Bytes], Array]) -> Callable[[], Iterator[Array]]:
    """Return the function `read` (see `Pages`) of the file `path` of one picture. `decode` returns
    the picture in the bytes of the file. Decoding from memory recognises files by content, and
    supports any path."""

    def read() -> Iterator[Array]:
        """Yield the one picture of the file."""
        yield decode(np.fromfile(path, np.uint8))

    return read


def decoded(data: Bytes) -> Array:
    """Return the picture in the bytes `data` of a file, (R, C, 3) red, green, blue or (R, C) grey,
    with its type of samples. Alpha is dropped. Raises ValueError if OpenCV cannot decode it."""
    import cv2

    # IMREAD_COLOR refuses 32 and 64 bits of one channel; with alpha they need IMREAD_UNCHANGED.
    for flags in (cv2.IMREAD_COLOR, cv2.IMREAD_ANYCOLOR, cv2.IMREAD_UNCHANGED):
        image = cv2.imdecode(data, cv2.IMREAD_ANYDEPTH | flags)
        if image is not None:
            picture = np.asarray(image)
            # OpenCV orders colours blue, green, red, alpha.
            return picture if picture.ndim == 2 else picture[..., 2::-1]
    raise ValueError("OpenCV cannot decode it")


def _radiance(data: Bytes) -> Array:
    """Return the picture in the bytes `data` of a Radiance file of any of its eight orientations;
    OpenCV knows one. Raises UnsupportedPicture for colours other than red, green, blue, and
    ValueError for a damaged file."""
    head, blank, body = data.tobytes().partition(b"\n\n")
    line, newline, samples = body.partition(b"\n")
    if b"FORMAT=32-bit_rle_xyze" in head:
        raise UnsupportedPicture(
            "its colours are CIE XYZ (FORMAT=32-bit_rle_xyze)",
            "convert it to FORMAT=32-bit_rle_rgbe: `ra_xyze -r IN.hdr OUT.hdr`",
        )
    resolution = _RESOLUTION.fullmatch(line)
    if resolution is None or resolution[2] == resolution[5]:
        # A line that is no orientation is left to OpenCV, which reports the damage.
        return decoded(data)
    # "-Y R +X C": rows from top to bottom, columns from left to right. OpenCV reads this order
    # only, so the samples are decoded under this name, and then transposed and mirrored as stated.
    usual = b"-Y %s +X %s" % (resolution[3], resolution[6])
    picture = decoded(np.frombuffer(head + blank + usual + newline + samples, np.uint8))
    signs = {resolution[2]: resolution[1], resolution[5]: resolution[4]}
    if resolution[2] == b"X":
        picture = picture.swapaxes(0, 1)
    if signs[b"Y"] == b"+":
        picture = picture[::-1]
    return np.ascontiguousarray(picture[:, ::-1] if signs[b"X"] == b"-" else picture)
