"""The table of scene formats, and one way to open a file of any of them.

A file is recognised by its first bytes, and by its ending if they fit several formats or none."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, redirect_stdout
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.files import reads
from nscc_runtime.scenes import (
    exr_pictures,
    opencv_pictures,
    pillow_pictures,
    raw_pictures,
    tiff_pictures,
    videos,
)
from nscc_runtime.scenes.errors import Path_or_name, damaged, unsupported
from nscc_runtime.scenes.pages import Pages, UnsupportedPicture, check_sizes, head_of
from nscc_runtime.scenes.timing import evenly, timed


class SceneFormat(NamedTuple):
    """A format of scenes.

    `endings`: those of its files, in lower case with the dot, separated by spaces. `head`: a
    pattern of their first bytes, in which a dot matches any byte. `pages`: the function that opens
    a file. `is_light`: whether samples are linear light (else sRGB)."""

    endings: str
    head: bytes
    pages: Callable[[Path], Pages]
    is_light: bool = False


_TIFF = rb"II[*+]\0|MM\0[*+]"
# fmt: off
_PICTURE_FORMATS: tuple[SceneFormat, ...] = (
    SceneFormat(".exr", rb"\x76\x2f\x31\x01", exr_pictures.exr_pages, is_light=True),
    SceneFormat(".hdr", rb"#\?", opencv_pictures.radiance_pages, is_light=True),
    SceneFormat(".pfm", rb"P[Ff]\s", opencv_pictures.pfm_pages, is_light=True),
    SceneFormat(".arw .cr2 .dng .nef", _TIFF, raw_pictures.raw_pages, is_light=True),
    SceneFormat(".avif", rb"....ftypavi[fs]", pillow_pictures.avif_pages),
    SceneFormat(".bmp", rb"BM", pillow_pictures.pillow_pages),
    SceneFormat(".heic .heif", rb"....ftyp(?:he|mif1|msf1)", pillow_pictures.heif_pages),
    SceneFormat(".jpeg .jpg", rb"\xff\xd8\xff", pillow_pictures.pillow_pages),
    SceneFormat(".png", rb"\x89PNG\r\n\x1a\n", opencv_pictures.png_pages),
    SceneFormat(".tif .tiff", _TIFF, tiff_pictures.tiff_pages),
    SceneFormat(".webp", rb"RIFF....WEBP", pillow_pictures.pillow_pages),
)
_CLIP_FORMATS: tuple[SceneFormat, ...] = (
    SceneFormat(".gif", rb"GIF8", pillow_pictures.gif_pages),
    SceneFormat(".avi .m4v .mkv .mov .mp4 .webm",
                rb"RIFF....AVI |....(?:ftyp|moov|mdat|free|wide|skip)|\x1a\x45\xdf\xa3",
                videos.video_pages),
)
# fmt: on


def _endings(formats: Iterable[SceneFormat]) -> tuple[str, ...]:
    """Return all endings of formats."""
    return tuple(" ".join(format_.endings for format_ in formats).split())


LINEAR = _endings(format_ for format_ in _PICTURE_FORMATS if format_.is_light)
DISPLAY = _endings(format_ for format_ in _PICTURE_FORMATS if not format_.is_light)
PICTURES = LINEAR + DISPLAY
CLIPS = tuple(sorted(_endings(_CLIP_FORMATS)))
_FORMATS = _PICTURE_FORMATS + _CLIP_FORMATS


def format_of(path: Path) -> SceneFormat | None:
    """Return the format of the file `path`; None for an ending that is not in the table.

    The format of the ending counts if the first bytes fit it, else the first format in the table
    that they fit. If they fit none, the ending counts. Raises OSError if the file cannot be
    read."""
    own = next((f for f in _FORMATS if path.suffix.lower() in f.endings.split()), None)
    if own is None:
        return None
    head = head_of(path)
    fitting = [f for f in _FORMATS if re.match(f.head, head, re.DOTALL)]
    # Raw files begin like TIFF files: they are recognised by their ending only.
    return own if own in fitting else next((f for f in fitting if ".dng" not in f.endings), own)


def open_pages(path: Path, large: bool = False) -> Pages:
    """Open the picture in a file, or its several pictures, which are a clip.

    Alpha is dropped; the rotation noted in a photograph is applied. `large` admits single pictures
    of 8 bits per sample with up to `MOST_LARGE_PIXELS`.

    Raises
    ------
    Rejected
        NS0732 for a damaged file or a file of a kind that is not decoded, NS0734 for a picture that
        is too large.
    """
    reads(path)
    with _readable(path):
        format_ = format_of(path)
        if format_ is None:
            raise ValueError(f"files with pictures end in {', '.join(PICTURES + CLIPS)}")
        pages = replace(format_.pages(path), is_light=format_.is_light)
        check_sizes(path, pages, large)

    def read() -> Iterator[tuple[str, Array]]:
        """Yield each picture with its name for messages, which counts from 0. Raises Rejected
        (NS0732) where the file is damaged, or has an array that is no picture."""
        pictures, number = pages.read(), 0
        while True:
            with _readable(path):
                picture = next(pictures, None)
                if picture is None:
                    return
                kind = picture.dtype.kind
                if picture.ndim not in (2, 3) or 0 in picture.shape or kind not in "uif":
                    raise ValueError(f"an array of {picture.dtype}, {picture.shape}")
            yield f"{path}, {'frame' if pages.is_clip else 'page'} {number}", picture
            number += 1

    return replace(pages, read=lambda: same_size(read()))


def read_frames(path: Path) -> Iterator[Array]:
    """Yield the frames of the clip `path` at even steps, as stored; frames that last longer are
    repeated. Raises Rejected like `open_pages`."""
    pages = timed(open_pages(path))
    return evenly(pages.read(), pages.edges)


def read_picture(path: Path) -> Array:
    """Read the only picture of a file as stored: (R, C) grey or (R, C, 3) red, green, blue.

    Raises
    ------
    Rejected
        Like `open_pages`, and NS0732 for a file of several pictures.
    """
    return only_picture(path, open_pages(path))


def only_picture(path: Path, pages: Pages) -> Array:
    """Return the only picture among the `pages` of the file `path`, as stored: (R, C) or (R, C, 3).
    Raises Rejected (NS0732) for a file of several pictures or a damaged one."""
    if pages.count != 1:
        raise unsupported(
            path,
            f"it contains {pages.count} pictures, but one is needed here",
            "save the required picture in a separate file",
        )
    return next(pages.read())


@contextmanager
def _readable(path: Path) -> Iterator[None]:
    """Turn the exceptions of readers of the file `path` in a with block into Rejected (NS0732),
    with the reader's text; what they print is hidden. Rejected passes unchanged, and so does
    ImportError, which names a missing package."""
    try:
        with quiet():
            yield
    except (Rejected, ImportError, GeneratorExit):
        raise
    except UnsupportedPicture as error:
        raise unsupported(path, *error.args) from error
    except Exception as error:  # each reader has its own exceptions
        raise damaged(path, error) from error


def same_size(pictures: Iterable[tuple[Path_or_name, Array]]) -> Iterator[Array]:
    """Yield the pictures, (R, C) or (R, C, 3), of pairs (name for messages, picture). Raises NS0734
    at the first one that differs in rows or columns from the first picture."""
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
    """Suppress the output of decoding libraries about damaged files in a with block.

    They write to the process's standard error below Python, so the file descriptor is replaced, and
    put back at the end. OpenCV and its FFmpeg read their own switches, set in the environment, at
    first use. With a closed standard error only Python's output is hidden."""
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
