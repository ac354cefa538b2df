"""Scenes given as moving pictures: .gif through Pillow, the others through OpenCV's FFmpeg."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.scenes.errors import damaged
from nscc_runtime.scenes.picture_files import quiet
from nscc_runtime.scenes.picture_size import refuse_size

CLIPS = (".avi", ".gif", ".m4v", ".mkv", ".mov", ".mp4", ".webm")


def read_clip(path: Path) -> Iterator[NDArray[Any]]:
    """The frames of a clip, uint8 (R, C, 3), red, green, blue; NS0732 where none can be decoded.

    A container that breaks off yields the frames before the break.
    """
    return _read_gif(path) if path.suffix.lower() == ".gif" else _read_video(path)


def _read_video(path: Path) -> Iterator[NDArray[Any]]:
    with quiet():
        import cv2

        # The backend is named: others would take a % in the name for a numbered sequence.
        video = cv2.VideoCapture(str(path), cv2.CAP_FFMPEG)
    found = 0
    try:
        sides = (cv2.CAP_PROP_FRAME_HEIGHT, cv2.CAP_PROP_FRAME_WIDTH)
        refuse_size(path, *(int(video.get(side)) for side in sides))
        while True:
            with quiet():
                good, frame = video.read()
            if not good or frame is None:
                break
            found += 1
            yield np.asarray(frame)[..., ::-1]
    except cv2.error as error:
        raise damaged(path, error.err) from error
    finally:
        video.release()
    if not found:
        raise damaged(path, "no frame of it can be decoded")


def _read_gif(path: Path) -> Iterator[NDArray[Any]]:
    """Each frame as it is shown: laid over those before it."""
    from PIL import Image

    try:
        image = Image.open(path)
    except Exception as error:  # Pillow's plugins raise what they like
        raise damaged(path, error) from error
    with image:
        refuse_size(path, image.height, image.width)
        for number in count():
            try:
                image.seek(number)
                frame = np.asarray(image.convert("RGB"))
            except EOFError:
                return
            except Exception as error:
                raise damaged(path, f"frame {number}: {error}") from error
            yield frame
