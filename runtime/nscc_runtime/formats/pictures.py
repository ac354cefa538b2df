"""Formats of pictures: linear light (.hdr .exr .pfm .tiff) and display pictures (.png); formats of
clips: .gif by Pillow, .mp4 by OpenCV."""

from __future__ import annotations

import io
import tempfile
from collections.abc import Iterable
from itertools import chain
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Bytes
from nscc_runtime.formats.content import Content
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
