"""Many frames of one scene as arrays with a leading axis, in bounded memory."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from tempfile import TemporaryFile, gettempdir
from typing import Any

import numpy as np

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.frame_file import ARRAYS, Frame

MOST_BYTES = 1 << 28
"""Larger series of frames are stored in a temporary file."""


def gathered(frames: Iterable[Frame], count: int) -> Frame:
    """Return `frames`, which yields exactly `count` frames of equal shape, at least one, as one
    frame with a leading axis. Each is stored as soon as it is exposed.

    If the arrays need more than `MOST_BYTES`, they are mapped to an unnamed file in the system's
    temporary folder, which is removed with the arrays. Raises Rejected (NS0784) if that folder has
    no room."""
    rooms: dict[str, Array] = {}
    for number, frame in enumerate(frames):
        arrays = {name: getattr(frame, name) for name in ARRAYS} | {**frame.told}
        if not rooms:
            mapped = count * sum(values.nbytes for values in arrays.values()) > MOST_BYTES
            rooms = {
                name: _room((count, *values.shape), values.dtype, mapped)
                for name, values in arrays.items()
            }
        for name, values in arrays.items():
            rooms[name][number] = values
    return Frame(*(rooms.pop(name) for name in ARRAYS), told=rooms)


def _room(shape: tuple[int, ...], kind: np.dtype[Any], mapped: bool) -> Array:
    """Return an array of `shape` and type `kind` with arbitrary contents, in memory or, if
    `mapped`, in a temporary file, which is removed with the array.

    Raises Rejected (NS0784) if the disk has no space."""
    if not mapped:
        return np.empty(shape, kind)
    size = math.prod(shape) * kind.itemsize
    try:
        with TemporaryFile(prefix="nscc-film-") as file:
            # Reserve the space first, so that a full disk is an error here instead of a signal.
            if hasattr(os, "posix_fallocate"):
                os.posix_fallocate(file.fileno(), 0, size)
            return np.asarray(np.memmap(file, kind, "w+", shape=shape))
    except OSError as error:
        raise rejected(
            "NS0784",
            f"cannot keep {size / 1e9:.3g} GB of a film in '{gettempdir()}': {error.strerror}",
            notes=("films beyond memory lie in the folder for temporary files",),
            helps=("ask for fewer frames, or set TMPDIR to a folder with room",),
        ) from error
