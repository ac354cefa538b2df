"""Read the pages of TIFF files: by Pillow if samples have at most 8 bits, else by OpenCV.

OpenCV multiplies 8-bit colours by alpha, and does not invert 16-bit pictures in which 0 is white;
Pillow does not support 16-bit colours. OpenCV gets each page, or each of its colour planes, as a
TIFF file of its own, because it mistakes separate planes for colours side by side."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array
from nscc_runtime.scenes.file_colours import of_profile
from nscc_runtime.scenes.opencv_pictures import decoded
from nscc_runtime.scenes.pages import Note, Pages, Stated, UnsupportedPicture
from nscc_runtime.scenes.pillow_pictures import pixels

_SUBFILE, _COLS, _ROWS, _BITS, _COMPRESSION, _PHOTOMETRIC, _DESCRIPTION, _STARTS, _SAMPLES = (
    254,
    256,
    257,
    258,
    259,
    262,
    270,
    273,
    277,
)
_STRIP_ROWS, _COUNTS, _PLANES, _TILE_STARTS, _TILE_COUNTS, _EXTRA, _FORMAT, _TABLES, _PROFILE = (
    278,
    279,
    284,
    324,
    325,
    338,
    339,
    347,
    34675,
)
# The names above are numbers of tags.
_COPIED = (_COLS, _ROWS, _BITS, _COMPRESSION, _PHOTOMETRIC, 266, 274, _SAMPLES, _STRIP_ROWS,
           _PLANES, 317, 320, 322, 323, _EXTRA, _FORMAT, _TABLES, 530)  # fmt: skip
"""Tags that describe how samples are stored."""
_THUMBNAIL_OR_MASK = 0b101
"""Bits of the tag of subfiles that mark a reduced picture, and a mask of transparency."""
_WHITE_IS_ZERO, _BLACK_IS_ZERO, _CMYK = 0, 1, 5
"""Values of the tag of colour spaces; below, those of L*a*b*, which is not decoded."""
_LABS = {8: "CIE L*a*b*", 9: "ICC L*a*b*", 10: "ITU L*a*b*"}
_UNSIGNED, _SIGNED, _FLOAT = 1, 2, 3
"""Values of the tag of sample formats."""
_FORMATS = {_UNSIGNED: "unsigned integers", _SIGNED: "signed integers", _FLOAT: "floats"}
_DECODED = {
    (_UNSIGNED, 16),
    (_SIGNED, 16),
    (_UNSIGNED, 32),
    (_SIGNED, 32),
    (_FLOAT, 32),
    (_FLOAT, 64),
}

Tags = Mapping[int, Any]


@dataclass(frozen=True)
class _Page:
    """A page of a TIFF file: the `index` and the `tags` (number to value) of its directory.

    `skipped`: the number of pictures of the same size before it in the samples of that directory; 0
    unless one directory describes a stack."""

    index: int
    tags: Tags
    skipped: int = 0

    @property
    def size(self) -> tuple[int, int]:
        """Rows and columns of the page."""
        return int(self.tags[_ROWS]), int(self.tags[_COLS])

    @property
    def samples(self) -> tuple[int, int]:
        """Format (1 unsigned, 2 signed, 3 float) and number of bits of the samples. Without tags
        they are 1 and 1, the defaults of TIFF. Of several channels the format is the first's, the
        bits are the most."""
        kinds, bits = (np.ravel(self.tags.get(tag) or 1) for tag in (_FORMAT, _BITS))
        return int(kinds[0]), int(bits.max())


def tiff_pages(path: Path) -> Pages:
    """Open the pages of the TIFF file `path`, without thumbnails and masks. Of several channels the
    first is opened, with a note. The colours are those of the first page's profile.

    Raises
    ------
    UnsupportedPicture
        If a page has samples of a kind that neither library decodes, or for big-endian BigTIFF.
    ValueError
        For a file without pages. A damaged one raises the errors of Pillow.
    """
    byte_order, directories = _directories(path)
    shown = [
        _Page(index=index, tags=tags)
        for index, tags in enumerate(directories)
        if not int(tags.get(_SUBFILE) or 0) & _THUMBNAIL_OR_MASK
    ] or [_Page(index=0, tags=directories[0])]
    pages, notes = _of_one_channel(_of_stack(shown))
    for page in pages:
        _check_samples(page)
    profile = pages[0].tags.get(_PROFILE)

    def read() -> Iterator[Array]:
        """Yield the pictures of all pages."""
        for page in pages:
            yield _picture(path, byte_order, page)

    return Pages(
        tuple(dict.fromkeys(page.size for page in pages)),
        len(pages),
        read,
        Stated() if profile is None else of_profile(bytes(profile)),
        notes,
        has_8_bits=pages[0].samples[1] <= 8,
    )


def _directories(path: Path) -> tuple[bytes, list[Tags]]:
    """Return the first two bytes of the TIFF file `path`, `II` or `MM`, which name its byte order,
    and its directories, each as values by number of tag. Raises ValueError without pages,
    UnsupportedPicture for big-endian BigTIFF."""
    from PIL.TiffImagePlugin import ImageFileDirectory_v2

    directories: list[Tags] = []
    with open(path, "rb") as file:
        head = file.read(8)
        if head[2:4] in (b"+\0", b"\0+"):  # 43, the number of BigTIFF
            if head[:2] != b"II":  # Pillow does not recognise it
                raise UnsupportedPicture(
                    "it is a BigTIFF of big-endian numbers", "save it with little-endian numbers"
                )
            head += file.read(8)
        directory = ImageFileDirectory_v2(head)
        # A damaged file may chain its directories in a circle.
        visited = set()
        while directory.next and directory.next not in visited:
            visited.add(directory.next)
            file.seek(directory.next)
            directory = ImageFileDirectory_v2(head)
            directory.load(file)
            directories.append(dict(directory))
    if not directories:
        raise ValueError("it has no pages")
    return head[:2], directories


def _description(page: _Page) -> str:
    """Return the description of a page, "" if it has none."""
    return str(page.tags.get(_DESCRIPTION) or "")


def _of_stack(pages: list[_Page]) -> list[_Page]:
    """Return the pages of a stack whose only directory describes its first page (ImageJ): one for
    each picture that its description counts. Other `pages` are returned as they are; samples must
    not be compressed."""
    stated = re.match(r"ImageJ=.*?\bimages=(\d+)", _description(pages[0]), re.DOTALL)
    if stated is None or len(pages) > 1 or int(pages[0].tags.get(_COMPRESSION) or 1) != 1:
        return pages
    return [
        _Page(index=0, tags=pages[0].tags, skipped=number) for number in range(int(stated[1]))
    ] or pages


def _of_one_channel(pages: list[_Page]) -> tuple[list[_Page], tuple[Note, ...]]:
    """Return the pages to expose of a stack with several channels, and a note on the choice.

    They are those of the first channel, and of the first plane in depth if there are several times,
    by the axes that ImageJ or OME state in the description. All `pages` are returned, without a
    note, if there is no choice or the stated counts do not fit their number."""
    text = _description(pages[0])
    if text.startswith("ImageJ="):
        stated = re.findall(r"^(channels|slices|frames)=(\d+)", text, re.MULTILINE)
        axes = {"channels": "C", "slices": "Z", "frames": "T"}
        counts = {axes[name]: int(count) for name, count in stated}
        order = "CZT"
    elif "<OME" in text and (pixels_tag := re.search(r"<Pixels\b[^>]*>", text)):
        counts = {a: int(n) for a, n in re.findall(r'Size([CZT])="(\d+)"', pixels_tag[0])}
        found = re.search(r'DimensionOrder="XY([CZT]{3})"', pixels_tag[0])
        order = found[1] if found else "CZT"
        # Colours of one page are not channels.
        counts["C"] = counts.get("C", 1) // int(pages[0].tags.get(_SAMPLES) or 1) or 1
    else:
        return pages, ()
    shape = [counts.get(axis, 1) for axis in order]
    chosen = {"C": "channel"} if counts.get("C", 1) > 1 else {}
    if counts.get("Z", 1) > 1 and counts.get("T", 1) > 1:
        chosen["Z"] = "slice"
    if not chosen or prod(shape) != len(pages):
        return pages, ()
    # The first axis of `order` varies fastest in the file. Transposed, axis k of `numbers` is axis
    # `order[k]` of the stack.
    numbers = np.arange(len(pages)).reshape(shape[::-1]).transpose(2, 1, 0)
    for axis in chosen:
        numbers = np.take(numbers, [0], order.index(axis))
    kept = [pages[number] for number in sorted(numbers.ravel().tolist())]
    named = " and ".join(f"{name} 1 of {counts[axis]}" for axis, name in chosen.items())
    help_text = "save another one in a separate file if you need it"
    return kept, ((f"has several channels or slices: {named} is exposed", help_text),)


def _check_samples(page: _Page) -> None:
    """Raise UnsupportedPicture if the samples of `page` are not decoded to red, green, blue or
    grey."""
    kind, bits = page.samples
    photometric = int(page.tags.get(_PHOTOMETRIC) or 0)
    if photometric in _LABS or (photometric == _CMYK and bits > 8):
        name = _LABS.get(photometric, f"CMYK of {bits} bits")
        raise UnsupportedPicture(f"its colours are {name}", "convert it to RGB or to grey")
    if (bits <= 8 and kind == _UNSIGNED) or (kind, bits) in _DECODED:
        return
    raise UnsupportedPicture(
        f"its samples are {_FORMATS.get(kind, f'of format {kind}')} of {bits} bits",
        "save it with integers of 8 or 16 bits, or with floats of 32 bits",
    )


def _picture(path: Path, byte_order: bytes, page: _Page) -> Array:
    """Return the `page` of the TIFF file `path`: (R, C) grey or (R, C, 3). `byte_order` is `II` or
    `MM`. Raises ValueError if its size differs from its tags, or if it cannot be decoded."""
    kind, bits = page.samples
    picture = _by_pillow(path, page) if bits <= 8 else None
    if picture is None:
        files = _files_of_planes(path, byte_order, page)
        planes = [decoded(np.frombuffer(file, np.uint8)) for file in files]
        grey = int(page.tags.get(_PHOTOMETRIC) or 0) in (_WHITE_IS_ZERO, _BLACK_IS_ZERO)
        if grey or len(planes) > 1:
            # OpenCV may return grey samples as three equal colours.
            planes = [plane[..., 0] if plane.ndim == 3 else plane for plane in planes]
        picture = np.stack(planes[:3], axis=-1) if len(planes) > 2 else planes[0]
        if bits > 8 and kind == _UNSIGNED and page.tags.get(_PHOTOMETRIC) == _WHITE_IS_ZERO:
            picture = np.iinfo(picture.dtype).max - picture
    if sorted(picture.shape[:2]) != sorted(page.size):  # it may have been rotated
        raise ValueError(f"page {page.index} is {picture.shape[:2]}, its tags say {page.size}")
    return picture


def _by_pillow(path: Path, page: _Page) -> Array | None:
    """Return the `page` of the file `path` as 8-bit grey (R, C) or RGB (R, C, 3). Return None if
    Pillow does not support its kind, or cannot seek to it because it lies in the samples of another
    page's directory."""
    from PIL import Image, UnidentifiedImageError

    if page.skipped:
        return None
    try:
        with Image.open(path) as image:
            image.seek(page.index)
            return pixels(image)
    except UnidentifiedImageError:
        return None


def _files_of_planes(path: Path, byte_order: bytes, page: _Page) -> list[bytes]:
    """Return TIFF files in memory with the `page` of the file `path` alone: one, or one grey file
    for each of its separate colour planes. `byte_order` is `II` or `MM`."""
    tags = page.tags
    starts_tag, counts_tag = (
        (_TILE_STARTS, _TILE_COUNTS) if _TILE_STARTS in tags else (_STARTS, _COUNTS)
    )
    starts = np.ravel(tags[starts_tag]).astype(np.int64)
    counts = np.ravel(tags.get(counts_tag) or path.stat().st_size).astype(np.int64)
    planes = int(tags.get(_SAMPLES) or 1)
    kept = {tag: tags[tag] for tag in _COPIED if tag in tags}
    if page.skipped:
        page_bytes = prod(page.size) * planes * page.samples[1] // 8
        starts, counts = starts[:1] + page.skipped * page_bytes, np.array([page_bytes])
        kept[_STRIP_ROWS] = page.size[0]
    if int(tags.get(_PLANES) or 1) == 1:
        planes = 1
    else:
        kept |= {
            _SAMPLES: 1,
            _BITS: page.samples[1],
            _PHOTOMETRIC: _BLACK_IS_ZERO,
            _PLANES: 1,
            _FORMAT: page.samples[0],
        }
        kept.pop(_EXTRA, None)
    files = []
    with open(path, "rb") as file:
        for part in np.array_split(np.arange(len(starts)), planes):
            blocks = []
            for k in part:
                file.seek(int(starts[k]))
                blocks.append(file.read(int(counts[k])))
            offsets = 8 + np.cumsum([0, *map(len, blocks)])
            # A directory begins at an even position.
            blocks.append(bytes(int(offsets[-1]) % 2))
            stored = {starts_tag: offsets[:-1], counts_tag: np.diff(offsets)}
            files.append(_file_of(byte_order, b"".join(blocks), kept | stored))
    return files


def _file_of(byte_order: bytes, samples: bytes, tags: Tags) -> bytes:
    """Return a TIFF file: a head, the `samples`, and a directory of `tags`, number to whole numbers
    (one or an array) or bytes. `byte_order` is `II` or `MM`."""
    order = "<" if byte_order == b"II" else ">"
    start = 8 + len(samples)
    entries, values = b"", b""
    for tag, value in sorted(tags.items()):
        numbers = value if isinstance(value, bytes) else np.ravel(value)
        data = numbers if isinstance(numbers, bytes) else numbers.astype(f"{order}u4").tobytes()
        # Up to four bytes lie in the entry itself; more lie after the directory, at the position in
        # the entry.
        entry = data.ljust(4, b"\0")
        if len(data) > 4:
            entry = struct.pack(f"{order}I", start + 6 + 12 * len(tags) + len(values))
            values += data + bytes(len(data) % 2)
        # Types of TIFF: 7 bytes, 4 whole numbers of 32 bits.
        kind = 7 if isinstance(value, bytes) else 4
        entries += struct.pack(f"{order}HHI", tag, kind, len(numbers)) + entry
    head = byte_order + struct.pack(f"{order}HI", 42, start)
    count = struct.pack(f"{order}H", len(tags))
    return head + samples + count + entries + bytes(4) + values
