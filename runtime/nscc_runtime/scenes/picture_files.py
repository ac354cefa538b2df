"""Read scenes as pictures: single files and folders of them.

OpenEXR reads .exr. Pillow reads .jpg and .webp, because it detects truncated files, and .avif.
rawpy reads raw files of cameras. OpenCV reads the rest, because it keeps 16 bits per sample and
reads Radiance and PFM."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, redirect_stdout
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.diagnostics.rejection import rejected
from nscc.files import reads
from nscc_runtime.scenes.colour import Transfer
from nscc_runtime.scenes.errors import Path_or_name, damaged, unsupported
from nscc_runtime.scenes.exr_pictures import exr_pages
from nscc_runtime.scenes.numbering import frames_missing, missing_frames
from nscc_runtime.scenes.pages import Pages, UnsupportedPicture
from nscc_runtime.scenes.picture_light import large_pages
from nscc_runtime.scenes.picture_size import (
    png_head,
    read_radiance,
    refuse_huge,
    refuse_size,
    stated_size,
    without_pillow_limit,
)
from nscc_runtime.scenes.tiff_pictures import tiff_pages, tiff_size

RAW = (".arw", ".cr2", ".dng", ".nef")
"""Endings of raw files of cameras."""
_RAW_NOTE = (
    "is a raw file: linear light, black and white level applied, colours as the camera has them",
    "convert it to .tiff or .exr if you need the colours of a standard",
)
LINEAR = (".exr", ".hdr", ".pfm", *RAW)
_HEIF = (".heic", ".heif")
DISPLAY = (".avif", ".bmp", ".heic", ".heif", ".jpeg", ".jpg", ".png", ".tif", ".tiff", ".webp")
PICTURES = LINEAR + DISPLAY


def default_transfer(path: Path) -> Transfer:
    """Return the default curve: linear for formats of linear light, sRGB for display formats."""
    return "linear" if path.suffix.lower() in LINEAR else "srgb"


def transfer_of(path: Path) -> Transfer:
    """Return the transfer curve that a picture file names, or else the default of its format."""
    named = png_head(path).transfer if path.suffix.lower() == ".png" else None
    return named or default_transfer(path)


def open_pages(path: Path, large: bool = False) -> Pages:
    """Open the picture in a file, or its several pictures, which are a clip.

    Alpha is dropped; the rotation noted in a photograph is applied. `large` admits single pictures
    of 8 bits per sample with up to `MOST_LARGE_PIXELS`. Raises Rejected (NS0732) for a damaged
    file, or a file of a kind that is not decoded."""
    reads(path)
    with _readable(path):
        pages = large_pages(path) if large else None
        if pages is None:
            refuse_huge(path)
            pages = _READERS.get(path.suffix.lower(), _opencv_pages)(path)

    def read() -> Iterator[tuple[str, NDArray[Any]]]:
        pictures = pages.read()
        for number in range(pages.count):
            with _readable(path):
                picture = next(pictures)
                kind = picture.dtype.kind
                if picture.ndim not in (2, 3) or 0 in picture.shape or kind not in "uif":
                    raise ValueError(f"an array of {picture.dtype}, {picture.shape}")
            yield f"{path}, page {number}", picture

    return replace(pages, read=lambda: same_size(read()))


def read_picture(path: Path) -> NDArray[Any]:
    """Read the only picture of a file as stored: (R, C) grey or (R, C, 3) red, green, blue.

    Raises
    ------
    Rejected
        Like `open_pages`, and NS0732 for a file of several pictures.
    """
    pages = open_pages(path)
    if pages.count != 1:
        raise unsupported(
            path, f"it contains {pages.count} pictures, but one is needed here",
            "save the required picture in a separate file",
        )  # fmt: skip
    return next(iter(pages.read()))


def size_of(path: Path) -> tuple[int, int]:
    """Return rows and columns of the first picture of a file, before its rotation.

    The picture is decoded only if the head of the file does not state its size. Raises Rejected
    like `open_pages`."""
    reads(path)
    with _readable(path):
        if path.suffix.lower() in _HEIF:
            _register_heif()
        size = _SIZES.get(path.suffix.lower(), stated_size)(path)
    rows, cols = size or next(open_pages(path).read()).shape[:2]
    return rows, cols


@contextmanager
def _readable(path: Path) -> Iterator[None]:
    """Convert exceptions of readers to NS0732, with the reader's text or the reason."""
    try:
        with quiet():
            yield
    except (Rejected, ImportError, GeneratorExit):
        raise
    except UnsupportedPicture as error:
        raise unsupported(path, error.reason, error.help_text) from error
    except Exception as error:  # each reader has its own exceptions
        raise damaged(path, error) from error


def _single_picture_pages(path: Path, decode: Callable[[NDArray[np.uint8]], NDArray[Any]]) -> Pages:
    """Open a file of one picture. Decoding from memory recognises files by content, as imread does,
    and supports any path."""

    def read() -> Iterator[NDArray[Any]]:
        yield decode(np.fromfile(path, np.uint8))

    return Pages(1, read)


def _opencv_pages(path: Path) -> Pages:
    return _single_picture_pages(path, decoded)


def decoded(data: NDArray[np.uint8]) -> NDArray[Any]:
    """Decode a file's bytes by OpenCV. Raises ValueError if OpenCV cannot decode them."""
    import cv2

    if data.size == 0:
        raise ValueError("the file is empty")
    # IMREAD_COLOR refuses 32 and 64 bits of one channel; with alpha they need IMREAD_UNCHANGED.
    for flags in (cv2.IMREAD_COLOR, cv2.IMREAD_ANYCOLOR, cv2.IMREAD_UNCHANGED):
        image = cv2.imdecode(data, cv2.IMREAD_ANYDEPTH | flags)
        if image is not None:
            break
    else:
        raise ValueError("")
    picture = np.asarray(image)
    return picture if picture.ndim == 2 else picture[..., 2::-1]


def _pillow_pages(path: Path) -> Pages:
    """Open the frames of a file by Pillow; frames of an animation are composed."""
    from PIL import Image, ImageOps

    with without_pillow_limit(), Image.open(path) as image:
        count = int(getattr(image, "n_frames", 1))
        refuse_size(path, image.height, image.width)

    def read() -> Iterator[NDArray[Any]]:
        with without_pillow_limit(), Image.open(path) as image:
            for number in range(count):
                image.seek(number)
                upright = ImageOps.exif_transpose(image) if count == 1 else image
                grey = count == 1 and upright.mode in ("1", "L")
                yield np.asarray(upright.convert("L" if grey else "RGB"))

    return Pages(count, read)


def _heif_pages(path: Path) -> Pages:
    _register_heif()
    return _pillow_pages(path)


def _register_heif() -> None:
    from pillow_heif import register_heif_opener

    register_heif_opener()


def _png_pages(path: Path) -> Pages:
    """Open a .png: pictures by OpenCV, which keeps 16 bits, animations by Pillow."""
    head = png_head(path)
    pages = _pillow_pages(path) if head.animated else _opencv_pages(path)
    return replace(pages, transfer=head.transfer, notes=head.notes)


def _radiance_pages(path: Path) -> Pages:
    return _single_picture_pages(path, lambda data: read_radiance(path, data, decoded))


def _raw_size(path: Path) -> tuple[int, int]:
    """Return rows and columns of the picture in a raw file, without decoding it."""
    import rawpy

    with rawpy.imread(str(path)) as raw:
        return int(raw.sizes.height), int(raw.sizes.width)


def _raw_pages(path: Path) -> Pages:
    """Open the picture of a raw file: uint16, 65535 at the camera's white level. No curve, no
    colour balance and no brightening are applied. Raises ImportError without rawpy."""
    import rawpy

    def read() -> Iterator[NDArray[Any]]:
        with rawpy.imread(str(path)) as raw:
            refuse_size(path, raw.sizes.raw_height, raw.sizes.raw_width)
            picture = raw.postprocess(
                gamma=(1, 1), no_auto_bright=True, no_auto_scale=False, output_bps=16,
                user_wb=[1, 1, 1, 1], output_color=rawpy.ColorSpace.raw,
                highlight_mode=rawpy.HighlightMode.Clip,
            )  # fmt: skip
            yield np.asarray(picture)

    return Pages(1, read, notes=(_RAW_NOTE,))


_READERS: dict[str, Callable[[Path], Pages]] = {
    ".exr": exr_pages,
    ".hdr": _radiance_pages,
    ".png": _png_pages,
    **dict.fromkeys((".tif", ".tiff"), tiff_pages),
    **dict.fromkeys(_HEIF, _heif_pages),
    **dict.fromkeys((".avif", ".bmp", ".jpeg", ".jpg", ".webp"), _pillow_pages),
    **dict.fromkeys(RAW, _raw_pages),
}
_SIZES: dict[str, Callable[[Path], tuple[int, int] | None]] = {
    **dict.fromkeys((".tif", ".tiff"), tiff_size),
    **dict.fromkeys(RAW, _raw_size),
}


def files_of(
    folder: Path, skip: bool = False, warn: Callable[[Diagnostic], None] = lambda _: None
) -> list[Path]:
    """Return the pictures of a folder in natural order (2 before 10).

    Hidden files, and files that belong to no sequence of frames, are ignored. With `skip`, `warn`
    is called with a message about missing frames. Raises NS0735 for a folder without pictures,
    NS0739 for a folder of linear and display pictures, NS0776 if frames are missing: files that are
    not read, or gaps in the numbering."""
    try:
        names = sorted(entry.name for entry in folder.iterdir() if entry.is_file())
    except OSError as error:
        raise damaged(folder, error.strerror or error) from error
    pictures = [
        folder / name
        for name in sorted(names, key=_natural)
        if not name.startswith(".") and Path(name).suffix.lower() in PICTURES
    ]
    if not pictures:
        raise rejected(
            "NS0735",
            f"the folder '{folder}' holds no pictures",
            notes=(f"{len(names)} other files; pictures end in {', '.join(PICTURES)}",),
            helps=("name the folder that holds the clip's frames",),
        )
    first = {default_transfer(path): path.name for path in reversed(pictures)}
    if len(first) > 1:
        raise rejected(
            "NS0739",
            f"the folder '{folder}' contains linear pictures ({first['linear']}) and "
            f"display pictures ({first['srgb']})",
            helps=(
                "all frames of a clip must have one kind: move the others into a separate folder",
            ),
        )
    missing = missing_frames([path.name for path in pictures], names)
    if missing:
        if not skip:
            raise Rejected(frames_missing(folder, missing), status=2)
        warn(frames_missing(folder, missing, skipped=True))
    return pictures


def _natural(name: str) -> tuple[list[tuple[int, int, str]], str]:
    """Return a sort key in which runs of digits count as numbers; the name itself breaks ties."""
    runs = re.findall(r"\d+|\D+", name)
    return [
        (0, int(p), "") if p.isdecimal() and p.isascii() and len(p) < 4000 else (1, 0, p.casefold())
        for p in runs
    ], name


def read_folder(
    pictures: list[Path], skip: bool = False, warn: Callable[[Diagnostic], None] = lambda _: None
) -> Iterator[NDArray[Any]]:
    """Yield the frames of a folder as stored. With `skip`, damaged files are reported to `warn`
    (NS0776) and left out. Raises Rejected (NS0734) if one differs in size from the first."""

    def read() -> Iterator[tuple[Path, NDArray[Any]]]:
        for path in pictures:
            try:
                yield path, read_picture(path)
            except Rejected as error:
                if not skip:
                    raise
                reason = error.diagnostics[0].message
                warn(frames_missing(path.parent, (f"{path.name}: {reason}",), skipped=True))

    return same_size(read())


def same_size(pictures: Iterable[tuple[Path_or_name, NDArray[Any]]]) -> Iterator[NDArray[Any]]:
    """Yield the pictures of pairs (name, picture). Raises NS0734 if one differs in size."""
    first: tuple[int, int] | None = None
    for name, picture in pictures:
        have = (picture.shape[0], picture.shape[1])
        first = first or have
        if have != first:
            raise rejected(
                "NS0734",
                f"'{name}' is {have[0]} x {have[1]}, but the clip's first frame is "
                f"{first[0]} x {first[1]}",
                helps=("give all frames of a clip the same size",),
            )
        yield picture


@contextmanager
def quiet() -> Iterator[None]:
    """Suppress the output of decoding libraries about damaged files.

    They write to the process's standard error below Python, so the file descriptor is replaced.
    OpenCV and its FFmpeg read their own switches at first use."""
    import io
    import os
    import sys

    os.environ.setdefault("OPENCV_LOG_LEVEL", "SILENT")
    os.environ.setdefault("OPENCV_FFMPEG_LOGLEVEL", "-8")
    # A clip is a local file: a playlist inside one must not fetch others from a network.
    os.environ.setdefault("OPENCV_FFMPEG_CAPTURE_OPTIONS", "protocol_whitelist;file")
    with redirect_stdout(io.StringIO()):
        sys.stderr.flush()
        try:
            saved_stderr = os.dup(2)
        except OSError:  # standard error is closed: nothing to keep quiet
            yield
            return
        with open(os.devnull, "wb") as nowhere:
            os.dup2(nowhere.fileno(), 2)
        try:
            yield
        finally:
            os.dup2(saved_stderr, 2)
            os.close(saved_stderr)
