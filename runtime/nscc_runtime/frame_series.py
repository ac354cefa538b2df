"""Many frames of one scene as arrays with an axis in front, in bounded memory."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Iterator
from tempfile import TemporaryFile, gettempdir
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc_runtime.frame_file import Frame

MOST_BYTES = 1 << 28
"""Larger films lie in a temporary file."""


def gathered(frames: Iterable[Frame], count: int) -> Frame:
    """`count` frames, each taken as it is made, with an axis in front.

    Arrays of a film of more than `MOST_BYTES` are mapped to a file without a name in the system's
    temporary folder: memory holds the frame at work, whatever the count, and the file is gone when
    the arrays are. Raises Rejected (NS0784) where that folder has no room.
    """
    rooms: dict[str, NDArray[Any]] = {}
    for number, frame in enumerate(frames):
        arrays = dict(_named_arrays(frame))
        if not rooms:
            mapped = count * sum(values.nbytes for values in arrays.values()) > MOST_BYTES
            rooms = {
                name: _room((count, *values.shape), values.dtype, mapped)
                for name, values in arrays.items()
            }
        for name, values in arrays.items():
            rooms[name][number] = values
    frame_arrays = {name: rooms.pop(name) for name in _ARRAYS}
    return Frame(**frame_arrays, told=rooms)


_ARRAYS = ("frame", "exposure_e", "valid", "saturated_by")


def _named_arrays(frame: Frame) -> Iterator[tuple[str, NDArray[Any]]]:
    yield from ((name, getattr(frame, name)) for name in _ARRAYS)
    yield from frame.told.items()


def _room(shape: tuple[int, ...], kind: np.dtype[Any], mapped: bool) -> NDArray[Any]:
    """An array to be filled, in memory or mapped to a file."""
    if not mapped:
        return np.empty(shape, kind)
    size = math.prod(shape) * kind.itemsize
    try:
        with TemporaryFile(prefix="nscc-film-") as file:
            # Reserved before it is mapped: a full disk is told here, and not by a signal later.
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
