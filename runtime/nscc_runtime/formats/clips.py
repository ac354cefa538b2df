"""Formats of clips: .gif by Pillow, .mp4 by OpenCV."""

from __future__ import annotations

import io
import os
import tempfile
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.formats.content import Content
from nscc_runtime.scenes.picture_files import quiet

FRAMES_A_SECOND = 10.0
"""Frames per second of clips: slow motion, because a clip may last two milliseconds."""
_CODECS = ("vp09", "mp4v")
"""Codecs in order of preference: VP9 plays in browsers; MPEG-4 if OpenCV lacks it."""


def gif(content: Content) -> bytes:
    """Return a looping .gif file with 256 greys or colours."""
    from PIL import Image

    frames = map(Image.fromarray, content.shown)
    first = next(frames)
    stream = io.BytesIO()
    first.save(
        stream, "GIF", save_all=True, append_images=frames, loop=0,
        comment=content.tone_text.encode(), duration=round(1000 / FRAMES_A_SECOND), optimize=False,
    )  # fmt: skip
    return stream.getvalue()


def mp4(content: Content) -> bytes:
    """Return a lossy .mp4 file; odd sizes are padded for codecs. Raises OSError without a codec."""
    with quiet():
        import cv2

    frames = map(_even, content.shown)
    first = next(frames)
    size = (first.shape[1], first.shape[0])
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "clip.mp4")
        for codec in _CODECS:
            four = cv2.VideoWriter.fourcc(*codec)
            with quiet():
                video = cv2.VideoWriter(path, cv2.CAP_FFMPEG, four, FRAMES_A_SECOND, size)
            if video.isOpened():
                break
        else:
            raise OSError(0, f"OpenCV cannot write .mp4: it has no codec of {', '.join(_CODECS)}")
        with quiet():
            for frame in chain([first], frames):
                video.write(np.ascontiguousarray(frame))
            video.release()
        with open(path, "rb") as stream:
            return stream.read()


def _even(frame: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a frame with channels blue, green, red, padded to even numbers of rows and columns."""
    colours = frame[..., ::-1] if frame.ndim == 3 else np.repeat(frame[..., None], 3, axis=-1)
    odd = [(0, side % 2) for side in colours.shape[:2]]
    return np.pad(colours, [*odd, (0, 0)], mode="edge")
