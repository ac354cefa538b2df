"""Scenes given as pictures: single files and folders of them, through the readers that know them.

OpenEXR reads .exr; Pillow .jpg, .webp and .gif, because it notices truncated files; OpenCV the
rest, because it keeps 16 bits a sample and knows Radiance and PFM.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.files import reads
from nscc_runtime.scenes.colour import Transfer
from nscc_runtime.scenes.errors import damaged
from nscc_runtime.scenes.picture_size import refuse_huge

LINEAR = (".exr", ".hdr", ".pfm")
DISPLAY = (".bmp", ".jpeg", ".jpg", ".png", ".tif", ".tiff", ".webp")
PICTURES = LINEAR + DISPLAY


def default_transfer(path: Path) -> Transfer:
    """Linear for formats of linear light, the sRGB curve for those made for displays."""
    return "linear" if path.suffix.lower() in LINEAR else "srgb"


def read_picture(path: Path) -> NDArray[Any]:
    """A picture as stored: (R, C) grey or (R, C, 3) red, green, blue; NS0732 where damaged.

    Alpha is dropped; the rotation noted in a photograph is applied.
    """
    reads(path)
    try:
        with quiet():
            refuse_huge(path)
            picture = _READERS.get(path.suffix.lower(), _read_opencv)(path)
    except Rejected:
        raise
    except Exception as error:  # each reader has its own exceptions
        raise damaged(path, error) from error
    if picture.ndim not in (2, 3) or 0 in picture.shape or picture.dtype.kind not in "uif":
        raise damaged(path, f"an array of {picture.dtype}, {picture.shape}")
    return picture


def _read_opencv(path: Path) -> NDArray[Any]:
    import cv2

    # imread knows files by their content; decoding from memory also takes any path.
    data = np.fromfile(path, np.uint8)
    if data.size == 0:
        raise ValueError("the file is empty")
    # In colour it refuses 32 and 64 bits a sample of one channel; with alpha, in any but all four.
    for flags in (cv2.IMREAD_COLOR, cv2.IMREAD_ANYCOLOR, cv2.IMREAD_UNCHANGED):
        found = cv2.imdecode(data, cv2.IMREAD_ANYDEPTH | flags)
        if found is not None:
            break
    else:
        raise ValueError("")
    picture = np.asarray(found)
    return picture if picture.ndim == 2 else picture[..., 2::-1]


def _read_pillow(path: Path) -> NDArray[Any]:
    from PIL import Image, ImageOps

    with Image.open(path) as image:
        upright = ImageOps.exif_transpose(image)
        return np.asarray(upright.convert("L" if upright.mode in ("1", "L") else "RGB"))


def _read_exr(path: Path) -> NDArray[Any]:
    import OpenEXR

    with OpenEXR.File(str(path)) as file:
        channels = file.channels()
        for name in ("RGB", "RGBA"):
            if name in channels:
                return np.array(channels[name].pixels[..., :3])
        if "Y" in channels:
            return np.array(channels["Y"].pixels)
        names = sorted(channels)
    if len(names) == 1:
        raise ValueError(f"its only channel is {names[0]}, not Y")
    raise ValueError(f"no channels R, G, B or Y, but {', '.join(names)[:100]}")


_READERS = {".exr": _read_exr, **dict.fromkeys((".bmp", ".jpeg", ".jpg", ".webp"), _read_pillow)}


def files_of(folder: Path) -> list[Path]:
    """The pictures of a folder in natural order (2 before 10); NS0735 if there are none.

    Hidden files and files of other kinds are passed over.
    """
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
            f"the folder '{folder}' mixes linear pictures ({first['linear']}) and display ones "
            f"({first['srgb']})",
            helps=("a clip is one kind: put the others into a folder of their own",),
        )
    return pictures


def _natural(name: str) -> tuple[list[tuple[int, int, str]], str]:
    """Sort key in which runs of digits count as numbers; the name itself decides ties."""
    parts = re.findall(r"\d+|\D+", name)
    return [
        (0, int(p), "") if p.isdecimal() and p.isascii() and len(p) < 4000 else (1, 0, p.casefold())
        for p in parts
    ], name


def read_folder(pictures: list[Path]) -> Iterator[NDArray[Any]]:
    """The frames of a folder, each as stored; NS0734 where one differs in size from the first."""
    first: tuple[int, int] | None = None
    for path in pictures:
        picture = read_picture(path)
        have = (picture.shape[0], picture.shape[1])
        first = first or have
        if have != first:
            raise rejected(
                "NS0734",
                f"'{path}' is {have[0]} x {have[1]}, but the clip's first frame is "
                f"{first[0]} x {first[1]}",
                helps=("give all frames of a clip the same size",),
            )
        yield picture


@contextmanager
def quiet() -> Iterator[None]:
    """Keep what decoding libraries print about damaged files off the user's screen.

    They write to the process's standard error below Python, so the file descriptor is set aside.
    OpenCV and its FFmpeg read their own switches when first used.
    """
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
            kept = os.dup(2)
        except OSError:  # standard error is closed: nothing to keep quiet
            yield
            return
        with open(os.devnull, "wb") as nowhere:
            os.dup2(nowhere.fileno(), 2)
        try:
            yield
        finally:
            os.dup2(kept, 2)
            os.close(kept)
