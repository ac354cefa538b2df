"""Frame files as they are read for reconstruction: what is damaged is said to be, by its name."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc.files import reads
from nscc_runtime.frame_file import SCHEMA
from nscc_runtime.looked_light import OPEN
from nscc_runtime.pieces import COLOURS
from nscc_training.problems import why_no_arrays

Array = NDArray[Any]
_SLOTS = "decode_slot_us"


@dataclass(frozen=True, eq=False)
class FrameRead:
    """What reconstruction needs of a frame file: codes (colours, rows, cols), one colour or red,
    green and blue, of two buckets (colours, 2, rows, cols), whether they are saturated, meta, the
    first bucket's shutters (N, rows, cols) if kept; of pixels that looked, for how many slots each
    was open (colours, rows, cols); how long slots are (N,), if it says so."""

    frame: NDArray[np.uint8]
    saturated: NDArray[np.bool_]
    meta: dict[str, Any]
    shutter: NDArray[Any] | None
    opened: NDArray[np.int64] | None = None
    slot_us: NDArray[np.float64] | None = None

    @property
    def buckets(self) -> int:
        """How many frames an exposure gave."""
        return 1 if self.frame.ndim == 3 else self.frame.shape[1]


def read_frame(path: Path) -> FrameRead:
    """A frame file of one exposure, or three in colours, in one bucket or two; Rejected (NS0819)
    for another."""
    file = frame_arrays(path)
    found, saturated, kept = file.frame, file.saturated, file.shutter
    if saturated.shape != found.shape or saturated.dtype != np.bool_:
        raise no_frame(path, f"`saturated` is {saturated.dtype} {saturated.shape}, no bool of it")
    in_colours = "colours" in file.meta and found.shape[:1] == (len(COLOURS),)
    if found.ndim != 3 + in_colours or found.shape[-3] not in (1, 2) or 0 in found.shape:
        raise no_frame(path, f"its frame is {found.shape}, not one exposure in a bucket or two")
    if kept is not None and kept.shape[:-1] != found.shape[-3:]:
        raise no_frame(path, f"its shutters are of {kept.shape[:-1]}, its frame {found.shape}")
    shutter = None if kept is None else np.asarray(kept[0].transpose(2, 0, 1), np.bool_)
    opened = None if file.opened is None else by_colour(file.opened, in_colours)
    codes, full = (by_colour(part, in_colours) for part in (found, saturated))
    return FrameRead(codes, full, file.meta, shutter, opened)


def by_colour(values: Array, in_colours: bool) -> Array:
    """What frame files hold of an exposure, ([colours,] buckets, rows, cols), as `FrameRead` has
    it: (colours, rows, cols), of two buckets (colours, 2, rows, cols)."""
    if values.shape[-3] == 1:
        return values[:, 0] if in_colours else values
    return values if in_colours else values[None]


def frame_arrays(path: Path) -> FrameRead:
    """The arrays of a frame file as they are stored, shutters unpacked; Rejected (NS0819) for
    another file."""
    reads(path)
    try:
        with open(path, "rb") as stream, np.load(stream, allow_pickle=False) as file:
            found, meta = file["frame"], json.loads(str(file["meta"]))
            named = "saturated" in file.files  # without, the codes that say so are
            saturated = file["saturated"] if named else np.zeros(found.shape, np.bool_)
            opened = file[OPEN] if OPEN in file.files else None
            slot_us = file[_SLOTS] if _SLOTS in file.files else None
            kept = None
            if "shutter" in file.files:
                count = int(file["shutter_shape"][3])
                kept = np.unpackbits(file["shutter"], axis=-1, count=count, bitorder="little")
    except Exception as error:  # numpy, zipfile and json raise a dozen types for damaged files
        raise no_frame(path, why_no_arrays(path, error)) from error
    if not isinstance(meta, dict) or meta.get("schema") != SCHEMA or found.dtype != np.uint8:
        raise no_frame(path, f"its schema is not {SCHEMA}")
    if opened is not None and (opened.shape != found.shape or opened.dtype.kind not in "iu"):
        raise no_frame(path, f"`{OPEN}` is {opened.dtype} {opened.shape}, no integers of it")
    if slot_us is not None and not are_lengths(slot_us):
        raise no_frame(path, f"`{_SLOTS}` are no lengths of slots")
    if not is_plan(meta.get("plan")):
        raise no_frame(path, "the `plan` of its meta does not say which effects it has")
    return FrameRead(found, saturated, meta, kept, opened, slot_us)


def are_lengths(slot_us: Array) -> bool:
    """Whether slots may be that long: finite numbers (N,) above 0."""
    numbers = slot_us.ndim == 1 and slot_us.dtype.kind in "fiu"
    return numbers and bool((np.isfinite(slot_us) & (slot_us > 0)).all())


def is_plan(plan: object) -> bool:
    """Whether a frame's meta may have such a `plan`: none, or one whose effects have a name and a
    decision."""
    if plan is None:
        return True
    rows = plan.get("effects", []) if isinstance(plan, dict) else None
    return isinstance(rows, list) and all(
        isinstance(row, dict) and all(isinstance(row.get(k), str) for k in ("name", "decision"))
        for row in rows
    )


def number_of(meta: Mapping[str, Any], name: str) -> float:
    """A number of a frame's meta; ValueError where there is none, or one that is not finite."""
    value = meta.get(name)
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    if value is not None and is_number and abs(value) <= sys.float_info.max:
        return float(value)
    raise ValueError(f"`{name}` of its meta is {str(value)[:40]}, no number")


def no_frame(path: Path | str, reason: str) -> Exception:
    """NS0819 for a file that no run can reconstruct."""
    return rejected(
        "NS0819",
        f"'{path}' is no frame that can be reconstructed",
        notes=(reason,),
        helps=("`nscc run RUN/shutter.nsl --scene .. -o FRAME.npz` writes one",),
    )
