"""Read clips: .gif by Pillow, other formats by PyAV."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.scenes.errors import damaged
from nscc_runtime.scenes.pages import Pages
from nscc_runtime.scenes.picture_files import quiet, same_size
from nscc_runtime.scenes.picture_size import refuse_size
from nscc_runtime.scenes.video import video_pages

CLIPS = (".avi", ".gif", ".m4v", ".mkv", ".mov", ".mp4", ".webm")


def open_clip(path: Path) -> Pages:
    """Open the frames of a clip, (R, C, 3) red, green, blue.

    A truncated file yields the frames before its end, with a note. The number of frames of a .gif
    is unknown and given as 0. Raises Rejected (NS0732) if no frame can be decoded."""
    if path.suffix.lower() == ".gif":
        return Pages(0, lambda: _read_gif(path))
    try:
        with quiet():
            pages = video_pages(path)
    except (Rejected, ImportError):
        raise
    except Exception as error:  # PyAV has an exception for each number of FFmpeg
        raise damaged(path, error) from error
    return replace(pages, read=lambda: same_size(_named(path, pages)))


def read_clip(path: Path) -> Iterator[NDArray[Any]]:
    """Yield the frames (R, C, 3) of a clip. Raises Rejected like `open_clip`."""
    return open_clip(path).read()


def _named(path: Path, pages: Pages) -> Iterator[tuple[str, NDArray[Any]]]:
    frames = pages.read()
    for number in count():
        try:
            with quiet():
                frame = next(frames)
        except StopIteration:
            return
        except Exception as error:
            raise damaged(path, error) from error
        yield f"{path}, frame {number}", frame


def _read_gif(path: Path) -> Iterator[NDArray[Any]]:
    """Yield each frame composed with the frames before it."""
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
