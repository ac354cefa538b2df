"""Read pictures and animations by Pillow."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array, Bytes, Floats
from nscc_runtime.scenes.file_colours import of_adobe_rgb, of_film, of_pillow
from nscc_runtime.scenes.pages import Note, Pages, Stated, head_of, opened_by_pillow

_GREY = ("1", "L", "LA", "La")
"""Pillow's modes of grey pictures of at most 8 bits."""
_BAND_ROWS = 256
"""Number of rows that are converted at a time."""
_GAIN_MAPS = (b"hdrgm:Version", b"urn:iso:std:iso:ts:21496", b"tmap")
"""Bytes at the start of a file that has a gain map: Adobe's, that of ISO 21496-1, and in HEIF."""
_EXIF_IFD, _INTEROP = 0x8769, 0xA005
"""Tags of the EXIF data that point to the directories of the exposure and of interoperability."""
_GAIN_MAP: Note = (
    "has a gain map for displays of high dynamic range, which is not used",
    "save it as .exr, or as .png or .avif with the PQ curve, if the highlights matter",
)


def pillow_pages(path: Path) -> Pages:
    """Open the picture of the file `path`, or the frames of an animation, which Pillow composes:
    uint8, (R, C) of a grey photograph, else (R, C, 3). Of several photographs (MPO) the first is
    opened.

    Rows are copied in bands: Pillow needs 4 bytes per pixel while it decodes a picture. Raises the
    errors of Pillow for a damaged file."""
    with opened_by_pillow(path) as image:
        count = int(getattr(image, "n_frames", 1))
        # A picture before an animation is its title, which viewers of animations do not show.
        first = int(bool(getattr(image, "default_image", False)))
        moving = bool(getattr(image, "is_animated", False)) and image.format != "MPO"
        size, mode, stated = (image.height, image.width), image.mode, of_pillow(path, image.info)
        if stated == Stated() and _is_in_adobe_rgb(image):
            stated = of_adobe_rgb()
        gain = any("gainmap" in str(kind).lower() for kind in image.info.get("aux", ()))
    head = head_of(path)
    notes = (_GAIN_MAP,) if gain or any(mark in head for mark in _GAIN_MAPS) else ()
    numbers = range(first, count) if moving else range(1)

    def read() -> Iterator[Array]:
        """Yield the pictures of a file that Pillow reads, without its limit on sizes."""
        with opened_by_pillow(path) as image:
            for number in numbers:
                if moving:
                    image.seek(number)
                yield pixels(image, upright=not moving)

    return Pages(
        (size,),
        len(numbers),
        read,
        stated,
        notes,
        durations_s=(lambda: _durations_s(path, numbers)) if moving else None,
        has_8_bits=not mode.startswith(("I", "F")),
    )


def _is_in_adobe_rgb(image: Any) -> bool:
    """Return whether the EXIF data of `image`, a JPEG opened by Pillow, name Adobe RGB, by the
    number of its rules (DCF). False for other formats."""
    return image.format in ("JPEG", "MPO") and image.getexif().get_ifd(_INTEROP).get(1) == "R03"


def pixels(image: Any, upright: bool = True) -> Bytes:
    """Return the samples of an open `image` of Pillow, uint8: (R, C) of a grey photograph, else (R,
    C, 3). Alpha is dropped.

    `upright` marks a photograph, and applies the rotation that it notes, in place. False marks a
    frame of an animation, which has colours even if grey."""
    from PIL import ImageOps

    if upright:
        ImageOps.exif_transpose(image, in_place=True)
    width, height = image.size
    grey = upright and image.mode in _GREY
    samples = np.empty((height, width) if grey else (height, width, 3), np.uint8)
    for top in range(0, height, _BAND_ROWS):
        band = image.crop((0, top, width, min(top + _BAND_ROWS, height)))
        samples[top : top + _BAND_ROWS] = np.asarray(band.convert("L" if grey else "RGB"))
    return samples


def _durations_s(path: Path, numbers: range) -> Floats:
    """Return the durations in seconds of the frames with these `numbers` (from 0) in the file
    `path`; 0 for frames that state none or cannot be read, and for those after them."""
    durations_s = np.zeros(len(numbers))
    with opened_by_pillow(path) as image, suppress(Exception):
        for k, number in enumerate(numbers):
            image.seek(number)
            image.load()  # WebP states a duration with the samples
            durations_s[k] = float(image.info.get("duration") or 0) / 1e3
    return durations_s


def exif_of(path: Path) -> dict[int, Any]:
    """Return the EXIF tags of the photo `path` by number; empty if it has none. A raw file's are
    found though its first directory may be a mosaic, which Pillow does not open. Raises the errors
    of Pillow for other files."""
    from PIL import Image

    with open(path, "rb") as file:
        if file.read(4) in (b"II*\0", b"MM\0*"):
            file.seek(0)
            exif = Image.Exif()
            exif.load_from_fp(file)
            return {**exif, **exif.get_ifd(_EXIF_IFD)}
    with suppress(ImportError):
        _register_heif()
    with opened_by_pillow(path) as image:
        exif = image.getexif()
        return {**exif, **exif.get_ifd(_EXIF_IFD)}


def gif_pages(path: Path) -> Pages:
    """Open the frames of a GIF, also a single one, as a clip."""
    return replace(pillow_pages(path), is_clip=True)


def heif_pages(path: Path) -> Pages:
    """Open the HEIF file `path`. Raises ImportError without pillow_heif, and the errors of Pillow
    for a damaged file."""
    _register_heif()
    return pillow_pages(path)


def _register_heif() -> None:
    """Let Pillow read HEIF files, in the whole process. Raises ImportError without pillow_heif."""
    from pillow_heif import register_heif_opener

    register_heif_opener()


def avif_pages(path: Path) -> Pages:
    """Open the AVIF file `path`. Unless it has a profile, FFmpeg reads its numbers of H.273,
    because Pillow does not return them. If FFmpeg cannot read it, its colours are unstated."""
    pages = pillow_pages(path)
    if pages.stated.colours is not None:
        return pages
    stated = of_film(path)
    return replace(pages, stated=Stated(stated.colours, pages.stated.notes + stated.notes))
