"""Read the pages of TIFF files: by Pillow if samples have at most 8 bits, else by OpenCV.

OpenCV multiplies 8-bit colours by alpha, and does not invert 16-bit pictures in which 0 is white;
Pillow does not support 16-bit colours."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.scenes.pages import Pages, UnsupportedPicture
from nscc_runtime.scenes.picture_size import refuse_size

_SUBFILE, _COLS, _ROWS, _BITS, _COMPRESSION, _PHOTOMETRIC, _FORMAT = (
    254, 256, 257, 258, 259, 262, 339,
)  # fmt: skip
_THUMBNAIL_OR_MASK = 0b101
_WHITE_IS_ZERO, _BLACK_IS_ZERO = 0, 1
_UNSIGNED, _SIGNED, _FLOAT = 1, 2, 3
_FORMATS = {_UNSIGNED: "unsigned integers", _SIGNED: "signed integers", _FLOAT: "floats"}
_DECODED = {(_UNSIGNED, 16), (_SIGNED, 16), (_UNSIGNED, 32), (_SIGNED, 32), (_FLOAT, 32),
            (_FLOAT, 64)}  # fmt: skip

Tags = Mapping[int, Any]


def tiff_pages(path: Path) -> Pages:
    """Open the pages of a TIFF file, without thumbnails and masks.

    Raises
    ------
    UnsupportedPicture
        If a page has samples of a kind that neither library decodes.
    """
    directories = _directories(path)
    chosen = _shown(directories)
    for index in chosen:
        _check_samples(directories[index])
        refuse_size(path, *_size(directories[index]))

    def read() -> Iterator[NDArray[Any]]:
        for index in chosen:
            yield _read_page(path, index, directories[index])

    return Pages(len(chosen), read)


def tiff_size(path: Path) -> tuple[int, int]:
    """Return rows and columns of the first page, as its tags state them."""
    directories = _directories(path)
    return _size(directories[_shown(directories)[0]])


def _size(tags: Tags) -> tuple[int, int]:
    return int(tags[_ROWS]), int(tags[_COLS])


def _shown(directories: list[Tags]) -> list[int]:
    return [
        index
        for index, tags in enumerate(directories)
        if not int(tags.get(_SUBFILE) or 0) & _THUMBNAIL_OR_MASK
    ] or [0]


def _directories(path: Path) -> list[Tags]:
    from PIL.TiffImagePlugin import ImageFileDirectory_v2

    directories: list[Tags] = []
    with open(path, "rb") as file:
        head = file.read(8)
        if head[2:4] in (b"+\0", b"\0+"):  # 43, the number of BigTIFF
            head += file.read(8)
        directory = ImageFileDirectory_v2(head)
        visited = set()
        while directory.next and directory.next not in visited:
            visited.add(directory.next)
            file.seek(directory.next)
            directory = ImageFileDirectory_v2(head)
            directory.load(file)
            directories.append(dict(directory))
    if not directories:
        raise ValueError("it has no pages")
    return directories


def _samples(tags: Tags) -> tuple[int, int]:
    """Return format and number of bits of a page's samples."""
    kinds, bits = (np.ravel(tags.get(tag) or 1) for tag in (_FORMAT, _BITS))
    return int(kinds[0]), int(bits.max())


def _check_samples(tags: Tags) -> None:
    kind, bits = _samples(tags)
    if (bits <= 8 and kind == _UNSIGNED) or (kind, bits) in _DECODED:
        return
    raise UnsupportedPicture(
        f"its samples are {_FORMATS.get(kind, f'of format {kind}')} of {bits} bits",
        "save it with integers of 8 or 16 bits, or with floats of 32 bits",
    )


def _read_page(path: Path, index: int, tags: Tags) -> NDArray[Any]:
    kind, bits = _samples(tags)
    picture = _by_pillow(path, index) if bits <= 8 else None
    if picture is None:
        picture = _by_opencv(path, index)
        grey = tags.get(_PHOTOMETRIC) in (_WHITE_IS_ZERO, _BLACK_IS_ZERO)
        picture = picture[..., 0] if grey and picture.ndim == 3 else picture
        if bits > 8 and kind == _UNSIGNED and tags.get(_PHOTOMETRIC) == _WHITE_IS_ZERO:
            picture = np.iinfo(picture.dtype).max - picture
    if sorted(picture.shape[:2]) != sorted(_size(tags)):  # it may have been rotated
        raise ValueError(f"page {index} is {picture.shape[:2]}, its tags say {_size(tags)}")
    return picture


def _by_pillow(path: Path, index: int) -> NDArray[Any] | None:
    """Return the page in 8 bits; None if Pillow does not support its kind."""
    from PIL import Image, ImageOps, UnidentifiedImageError

    try:
        with Image.open(path) as image:
            image.seek(index)
            grey = image.mode in ("1", "L", "LA", "La")
            upright = ImageOps.exif_transpose(image)
            return np.asarray(upright.convert("L" if grey else "RGB"))
    except UnidentifiedImageError:
        return None


def _by_opencv(path: Path, index: int) -> NDArray[Any]:
    import cv2

    data = np.fromfile(path, np.uint8)
    # IMREAD_COLOR refuses 32 and 64 bits of one channel; with alpha they need IMREAD_UNCHANGED.
    for flags in (cv2.IMREAD_COLOR, cv2.IMREAD_ANYCOLOR, cv2.IMREAD_UNCHANGED):
        success, pages = cv2.imdecodemulti(
            data, cv2.IMREAD_ANYDEPTH | flags, range=(index, index + 1)
        )
        if success and len(pages) == 1:
            picture = np.asarray(pages[0])
            return picture if picture.ndim == 2 else picture[..., 2::-1]
    raise ValueError(f"OpenCV decodes no page {index} of it")
