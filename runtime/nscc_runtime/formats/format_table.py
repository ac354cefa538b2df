"""File formats, one function each, their table, and the check of file names before any work is
done."""

from __future__ import annotations

import io
import tempfile
import zipfile
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from types import SimpleNamespace
from typing import IO

import numpy as np

from nscc.arrays import Array, Bytes
from nscc.diagnostics.diagnostic import rejected
from nscc.files import Product
from nscc_runtime.formats.content import Arrays, Content
from nscc_runtime.scenes.picture_files import quiet


def png(content: Content) -> bytes:
    """Return a .png file of the single picture of `content`, 8 bits per sample; its text chunk
    Description names the tone curve."""
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    about = PngInfo()
    about.add_text("Description", content.tone_text)
    about.add_text("Software", "nscc")
    stream = io.BytesIO()
    (shown,) = content.shown
    Image.fromarray(shown).save(stream, "PNG", pnginfo=about)
    return stream.getvalue()


def hdr(content: Content) -> bytes:
    """Return the bytes of a Radiance file of the light of `content`, one picture, with 8 bits of
    mantissa per sample and a common exponent of colours. Raises OSError if OpenCV cannot write
    it."""
    (light,) = content.pictures
    colours = light if light.ndim == 3 else np.repeat(light[..., None], 3, axis=-1)
    return _encoded(".hdr", [colours])


def pfm(content: Content) -> bytes:
    """Return the bytes of a portable float map of float32 of the light of `content`, one picture;
    lossless. Raises OSError if OpenCV cannot write it."""
    return _encoded(".pfm", content.pictures)


def tiff(content: Content) -> bytes:
    """Return a lossless .tiff file of float32 of the light of `content`; a clip has one page per
    frame. Raises OSError if OpenCV cannot write it."""
    return _encoded(".tiff", content.pictures)


def exr(content: Content) -> bytes:
    """Return the bytes of a lossless OpenEXR file of float32 of the light of `content`, one
    picture; grey light is the channel Y. Raises ImportError without OpenEXR."""
    import OpenEXR

    (picture,) = content.pictures
    light = np.ascontiguousarray(picture, np.float32)
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    # The library can only write to a path.
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "picture.exr")
        channels = {"RGB" if content.colour else "Y": light}
        with OpenEXR.File(header, channels) as file:
            file.write(str(path))
        return path.read_bytes()


def _encoded(ending: str, pictures: Iterable[Array]) -> bytes:
    """Return the bytes of a file of `pictures`, (rows, cols) or (rows, cols, 3) each, as float32 in
    the format of `ending`, such as ".pfm". Raises OSError if OpenCV cannot write it."""
    import cv2

    # OpenCV orders colours blue, green, red.
    pages = [
        np.ascontiguousarray(light[..., ::-1] if light.ndim == 3 else light, np.float32)
        for light in pictures
    ]
    success, data = cv2.imencodemulti(ending, pages)
    if not success:
        raise OSError(0, f"OpenCV cannot write {ending}")
    return bytes(data)


FRAMES_A_SECOND = 10.0
"""Frames per second of clips: slow motion, because a clip may last two milliseconds."""
_CODECS = ("vp09", "mp4v")
"""Codecs in order of preference: VP9 plays in browsers; MPEG-4 if OpenCV lacks it."""


def gif(content: Content) -> bytes:
    """Return the bytes of a looping .gif file of the clip `content` with at most 256 greys or
    colours; its comment names the tone curve. Ten frames are shown in a second."""
    from PIL import Image

    frames = map(Image.fromarray, content.shown)
    first = next(frames)
    stream = io.BytesIO()
    first.save(
        stream,
        "GIF",
        save_all=True,
        append_images=frames,
        loop=0,
        comment=content.tone_text.encode(),
        duration=round(1000 / FRAMES_A_SECOND),
        optimize=False,
    )
    return stream.getvalue()


def mp4(content: Content) -> bytes:
    """Return the bytes of a lossy .mp4 file of the clip `content`, ten frames a second; odd sizes
    are padded to even ones for codecs. Raises OSError if OpenCV has no codec."""
    with quiet():
        import cv2

    frames = map(_even, content.shown)
    first = next(frames)
    size = (first.shape[1], first.shape[0])
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "clip.mp4")
        for codec in _CODECS:
            four = cv2.VideoWriter.fourcc(*codec)
            with quiet():
                video = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, four, FRAMES_A_SECOND, size)
            if video.isOpened():
                break
        else:
            codecs = ", ".join(_CODECS)
            raise OSError(0, f"OpenCV cannot write .mp4: it has no codec of {codecs}; use .gif")
        with quiet():
            for frame in chain([first], frames):
                video.write(np.ascontiguousarray(frame))
            video.release()
        return path.read_bytes()


def _even(frame: Bytes) -> Bytes:
    """Return a display `frame`, (rows, cols) or (rows, cols, 3), with channels blue, green, red,
    padded to even numbers of rows and columns by repeating the last ones."""
    colours = frame[..., ::-1] if frame.ndim == 3 else np.repeat(frame[..., None], 3, axis=-1)
    odd = [(0, side % 2) for side in colours.shape[:2]]
    return np.pad(colours, [*odd, (0, 0)], mode="edge")


def npz(content: Content) -> Product:
    """Return the function that writes an .npz file of `content`, such as `FrameFile.write` for a
    frame; without such a function, the bytes of a file of all arrays by name. Equal arrays give
    equal bytes, because no time is stored."""
    if content.write_npz is not None:
        return content.write_npz
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_STORED) as archive:
        for name, values in content.arrays.items():
            entry = io.BytesIO()
            np.lib.format.write_array(entry, np.asarray(values))
            archive.writestr(zipfile.ZipInfo(f"{name}.npy"), entry.getvalue())
    return stream.getvalue()


def npy(content: Content) -> Product:
    """Return a function that writes an .npy file of the main array of `content` (its `main()`, or
    its first array) to a stream, which may be a pipe."""
    first = content.main or (lambda: next(iter(content.arrays.values())))

    def write(file: IO[bytes]) -> None:
        """Write the main array to `file`."""
        # Hide the file's type from numpy, which would seek in it: pipes cannot seek.
        np.lib.format.write_array(SimpleNamespace(write=file.write), np.asarray(first()))

    return write


def mat(content: Content) -> bytes:
    """Return the bytes of a compressed MATLAB file (version 5) of the benchmark arrays of
    `content`, or of all its arrays without those. Raises what `content.benchmark` raises."""
    from scipy.io import savemat

    arrays: Arrays = content.arrays if content.benchmark is None else content.benchmark()
    stream = io.BytesIO()
    savemat(stream, dict(arrays), do_compression=True)
    # The header's text, 116 bytes, contains the time; replace it.
    head = b"MATLAB 5.0 MAT-file, written by nscc".ljust(116)
    return head + stream.getvalue()[116:]


@dataclass(frozen=True)
class Format:
    """A file format.

    `ending`: with the dot. `holds`: the kinds of content, "picture", "clip", "arrays" or "picture,
    clip". `write`: returns the bytes of a file, or a function that writes it. `shown`: it contains
    display pictures after a tone curve instead of light."""

    ending: str
    holds: str
    write: Callable[[Content], Product]
    shown: bool = False


FORMATS = {
    format_.ending: format_
    for format_ in (
        Format(".npz", "arrays", npz),
        Format(".npy", "arrays", npy),
        Format(".mat", "arrays", mat),
        Format(".hdr", "picture", hdr),
        Format(".exr", "picture", exr),
        Format(".pfm", "picture", pfm),
        Format(".tiff", "picture, clip", tiff),
        Format(".png", "picture", png, shown=True),
        Format(".gif", "clip", gif, shown=True),
        Format(".mp4", "clip", mp4, shown=True),
    )
}
"""Formats by ending. For names without ending (/dev/stdout), each command has a default."""


def endings(*kinds: str) -> tuple[str, ...]:
    """Return the endings of formats that hold one of `kinds` ("picture", "clip", "arrays"), in the
    order of the table; without kinds, all endings."""
    return tuple(
        ending
        for ending, format_ in FORMATS.items()
        if not kinds or any(kind in format_.holds for kind in kinds)
    )


def check_ending(path: Path, allowed: tuple[str, ...], product: str) -> str:
    """Return the lower-case ending of the file name `path`, or the first of `allowed` if it has no
    ending. `product` is what is written, for the message. Raises Rejected (NS0786) for an ending
    not in `allowed`."""
    ending = path.suffix.lower()
    if ending in allowed:
        return ending
    if not ending:
        return allowed[0]
    known = ", ".join(allowed)
    # The name of a file that exists may be that of the input.
    named = [path.with_name((path.stem or "name") + ending) for ending in allowed]
    free = next((name for name in named if not name.exists()), named[0])
    raise rejected(
        "NS0786",
        f"{product} cannot be written as '{path.name}': the ending '{path.suffix[:20]}' is "
        "not supported here",
        notes=(f"it can end in {known}" if len(allowed) > 1 else f"it ends in {known}",),
        helps=(f"name it {free.name}",),
        data={"endings": list(allowed)},
    )


def file_of(path: Path, content: Content, product: str) -> Product:
    """Return the bytes of an output file, or a function that writes it, in the format of the ending
    of `path`; without an ending, .npz. `product` is what is written, for messages. Raises Rejected
    (NS0786) for an unknown ending, or if its format cannot hold the content."""
    ending = check_ending(path, endings(), product)
    format_ = FORMATS[ending]
    lacks = content.lacks(format_.holds)
    if lacks is not None:
        kind = "clip" if content.moving else "picture"
        possible_endings = endings("arrays", *([kind] if content.light is not None else []))
        raise rejected(
            "NS0786",
            f"{product} cannot be written as '{path.name}': {lacks}",
            notes=(f"{ending} holds a {format_.holds.replace(', ', ' or a ')}",),
            helps=(f"use {', '.join(possible_endings)}",),
            data={"endings": list(possible_endings)},
        )
    return format_.write(content)
