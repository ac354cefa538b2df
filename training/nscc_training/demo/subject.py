"""Classification of a demo's scene: still or clip, and the part of a clip to use."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import NamedTuple

import numpy as np

from nscc.arrays import Array, Floats32
from nscc_runtime.scene_settings import Transfer
from nscc_runtime.scenes import Scene
from nscc_runtime.scenes.light_arrays import MAT_CLIP_KEY, read_light, read_mat
from nscc_runtime.scenes.load import ARRAYS
from nscc_runtime.scenes.pages import Pages
from nscc_runtime.scenes.picture_files import CLIPS, PICTURES, open_pages, read_picture
from nscc_runtime.scenes.picture_folders import files_of

_MOST_FRAMES = 600
"""Most frames of a clip that are searched for the part with the most motion."""
_SIDE = 64
"""Side in pixels of the reduced frames in which motion is measured."""
_CUT = 4.0
"""A change between frames that is this factor larger than both neighbouring changes is a cut."""


class Subject(NamedTuple):
    """A scene that is known to be a still or a clip, before its exposure is chosen.

    `transfer` is the encoding of its values. `chosen` says in words which part of a clip is used.
    `in_electrons` means that its values are electrons, so that it needs no exposure."""

    scene: Scene
    still: bool
    transfer: Transfer
    chosen: str = ""
    in_electrons: bool = False


def subject(scene: Scene, slots: int, frame_s: float) -> Subject:
    """Return whether a scene is a still or a clip, and the part of a clip to use.

    A clip must fill `slots` slots in `frame_s` seconds. In a longer clip, the frames with the most
    motion are chosen, one per slot; a shorter clip is slowed down. A scene that is no existing file
    counts as a still, whose reader refuses it. Raises Rejected for a file that cannot be read."""
    path = Path(scene.name)
    suffix = path.suffix.lower()
    if scene.name.startswith("builtin:"):
        return Subject(scene, not scene.name.startswith("builtin:motion"), "linear")
    # Arrays of light are recognised by their axes, files of pictures by their number of frames.
    if suffix in ARRAYS and path.is_file():
        shapes: list[tuple[int, ...]] = []
        if path.suffix.lower() == ".mat":
            key, light = read_mat(path, shapes.append)
            if key == MAT_CLIP_KEY:
                return Subject(scene, False, scene.transfer or "linear")
        else:
            light = read_light(path, shapes.append)
        return Subject(scene, light.ndim == 2, "linear", in_electrons=True)
    if path.is_dir():
        files = files_of(path)
        transfer = _transfer(scene, open_pages(files[0]))
        if len(files) == 1:
            return Subject(replace(scene, name=str(files[0])), True, transfer)
        return _of_clip(scene, (read_picture(file) for file in files), transfer, slots, frame_s)
    if suffix not in PICTURES + CLIPS or not path.is_file():
        return Subject(scene, True, scene.transfer or "srgb")
    pages = open_pages(path)
    transfer = _transfer(scene, pages)
    if pages.count > 1 or pages.is_clip:
        return _of_clip(scene, pages.read(), transfer, slots, frame_s)
    return Subject(scene, True, transfer)


def _transfer(scene: Scene, pages: Pages) -> Transfer:
    """Return the encoding of a scene's values: as its option says, else as the file says. A colour
    profile with another curve counts as "srgb"."""
    return scene.transfer or pages.colours.transfer or "srgb"


def _of_clip(
    scene: Scene, frames: Iterator[Array], transfer: Transfer, slots: int, frame_s: float
) -> Subject:
    """Return how to use a scene with these `frames`. A single frame is a still. Fewer frames than
    `slots` are spread over the slots; of more frames, the part with the most motion is used.

    `frame_s` is the exposure time of the sensor's frame in seconds. A frame rate in `scene` is
    kept, and then no part is chosen. `transfer` is the encoding. There is at least one frame; those
    after the first `_MOST_FRAMES` are not read."""
    small = np.stack([_reduced(frame) for frame in islice(frames, _MOST_FRAMES)])
    have = len(small)
    if have == 1:
        return Subject(replace(scene, single=True), True, transfer)
    if scene.fps is not None:
        return Subject(scene, False, transfer)
    if have < slots:
        text = f"its {have} frames are spread over {slots} slots"
        return Subject(replace(scene, fps=have / frame_s), False, transfer, text)
    first = liveliest(small, slots)
    text = f"frames {first} to {first + slots - 1} of it, where most moves" if first else ""
    return Subject(replace(scene, first=first), False, transfer, text)


def liveliest(frames: Floats32, count: int) -> int:
    """Return the number of the first of `count` successive frames with the most motion. Parts with
    a cut are used only if all parts have one; of equal parts, the first is chosen.

    `frames` (T, rows, cols), at least `count`, are grey values. Motion is the mean absolute
    difference of successive frames."""
    steps = np.abs(np.diff(frames, axis=0)).mean(axis=(1, 2))
    # Beyond both ends there is no change: 0.
    beside = np.pad(steps, 1)
    cuts = steps > _CUT * np.maximum(beside[:-2], beside[2:])
    windows = range(len(frames) - count + 1)
    moved = [float(steps[k : k + count - 1].sum()) for k in windows]
    uncut = [k for k in windows if not cuts[k : k + count - 1].any()]
    return max(uncut or windows, key=lambda k: (moved[k], -k))


def _reduced(frame: Array) -> Floats32:
    """Return the picture `frame` (rows, cols, [3]) as grey values (the mean of its colours) of
    `_SIDE` x `_SIDE` pixels, whatever its shape, in which motion is measured."""
    import cv2

    grey = frame.mean(axis=-1) if frame.ndim == 3 else frame
    size = (_SIDE, _SIDE)
    return np.asarray(cv2.resize(grey.astype(np.float32), size, interpolation=cv2.INTER_AREA))
