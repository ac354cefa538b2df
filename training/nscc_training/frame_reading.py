"""Reading frame files for reconstruction, with messages that name what is damaged."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc.files import reads
from nscc.npy import InvalidArrays
from nscc_runtime.frame_arrays import read_frame_arrays
from nscc_runtime.looked_light import OPEN
from nscc_runtime.pieces import COLOURS
from nscc_training.problems import why_no_arrays

Array = NDArray[Any]
_SLOTS = "decode_slot_us"
_READ = ("saturated", OPEN, _SLOTS, "shutter", "shutter_shape")


@dataclass(frozen=True, eq=False)
class FrameRead:
    """The content of a frame file that reconstruction needs.

    `frame` contains converter codes (colours, rows, cols), for two buckets (colours, 2, rows,
    cols), with one colour or red, green, blue. `saturated` marks saturated codes. `shutter` (N,
    rows, cols) are the first bucket's shutters, `slot_us` (N,) the slot lengths, None if not
    stored. `opened` (colours, rows, cols) is the number of open slots of pixels that looked, else
    None."""

    frame: NDArray[np.uint8]
    saturated: NDArray[np.bool_]
    meta: dict[str, Any]
    shutter: NDArray[Any] | None
    opened: NDArray[np.int64] | None = None
    slot_us: NDArray[np.float64] | None = None

    @property
    def buckets(self) -> int:
        """Number of frames per exposure."""
        return 1 if self.frame.ndim == 3 else self.frame.shape[1]


def read_frame(path: Path) -> FrameRead:
    """Read a frame file with one exposure, or one per colour; raise Rejected (NS0819)."""
    file = frame_arrays(path)
    frame, saturated, stored_shutters = file.frame, file.saturated, file.shutter
    in_colours = "colours" in file.meta and frame.shape[:1] == (len(COLOURS),)
    if frame.ndim != 3 + in_colours or frame.shape[-3] not in (1, 2):
        raise no_frame(path, f"its frame is {frame.shape}, not one exposure in a bucket or two")
    if stored_shutters is not None and stored_shutters.shape[:-1] != frame.shape[-3:]:
        raise no_frame(
            path, f"its shutters are of {stored_shutters.shape[:-1]}, its frame {frame.shape}"
        )
    shutter = (
        None
        if stored_shutters is None
        else np.asarray(stored_shutters[0].transpose(2, 0, 1), np.bool_)
    )
    opened = None if file.opened is None else by_colour(file.opened, in_colours)
    codes, full = (by_colour(values, in_colours) for values in (frame, saturated))
    return FrameRead(codes, full, file.meta, shutter, opened)


def refuse_missing(path: Path) -> None:
    """Raise Rejected (NS0819) for a missing file, before slow packages are imported."""
    try:
        path.open("rb").close()
    except OSError as error:
        raise no_frame(path, why_no_arrays(error)) from error


def by_colour(values: Array, in_colours: bool) -> Array:
    """Return an array ([colours,] buckets, rows, cols) as (colours, [2,] rows, cols)."""
    if values.shape[-3] == 1:
        return values[:, 0] if in_colours else values
    return values if in_colours else values[None]


def frame_arrays(path: Path) -> FrameRead:
    """Return the arrays of a frame file, shutters unpacked; raise Rejected (NS0819)."""
    reads(path)
    try:
        arrays, meta = read_frame_arrays(path, _READ.__contains__)
    except (InvalidArrays, OSError) as error:
        raise no_frame(path, why_no_arrays(error)) from error
    codes, slot_us = arrays["frame"], arrays.get(_SLOTS)
    if slot_us is not None and not are_lengths(slot_us):
        raise no_frame(path, f"`{_SLOTS}` are not valid slot lengths")
    # Without `saturated`, the codes decide.
    saturated = arrays.get("saturated", np.zeros(codes.shape, np.bool_))
    stored_shutters = None
    if "shutter" in arrays:
        try:
            count = int(arrays["shutter_shape"][3])
            stored_shutters = np.unpackbits(
                arrays["shutter"], axis=-1, count=count, bitorder="little"
            )
        except (LookupError, TypeError, ValueError, OverflowError) as error:
            raise no_frame(path, "its shutters are damaged") from error
    return FrameRead(codes, saturated, meta, stored_shutters, arrays.get(OPEN), slot_us)


def are_lengths(slot_us: Array) -> bool:
    """Return whether slot lengths are valid: finite numbers (N,) above 0."""
    numbers = slot_us.ndim == 1 and slot_us.size > 0 and slot_us.dtype.kind in "fiu"
    return numbers and bool((np.isfinite(slot_us) & (slot_us > 0)).all())


def number_of(meta: Mapping[str, Any], name: str) -> float:
    """Return a number of a frame's meta; raise ValueError if it is missing or not finite."""
    value = meta.get(name)
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    if value is not None and is_number and abs(value) <= sys.float_info.max:
        return float(value)
    raise ValueError(f"`{name}` of its meta is {str(value)[:40]}, not a number")


def no_frame(path: Path | str, reason: str) -> Exception:
    """Return the error (NS0819) for a file that cannot be reconstructed."""
    return rejected(
        "NS0819",
        f"'{path}' is not a frame that can be reconstructed",
        notes=(reason,),
        helps=("`nscc run RUN/shutter.nsl --scene .. -o FRAME.npz` writes one",),
    )
