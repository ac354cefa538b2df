"""Read and check frame files for all commands. Damaged files are refused before they are used."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Floats32
from nscc.diagnostics.diagnostic import rejected
from nscc.files import reads
from nscc.mappings import JsonObject
from nscc.npy import InvalidArrays, npz_arrays
from nscc_runtime.frame_file import SCHEMA
from nscc_runtime.looked_light import DEVIATION, LIGHT, OPEN, merged_image

Arrays = dict[str, Array]

_KINDS = {
    "frame": ("u", "codes of the ADC, uint8"),
    "exposure_e": ("f", "electrons, floats"),
    "valid": ("b", "true or false"),
    "saturated": ("b", "true or false"),
    "saturated_by": ("u", "marks, uint8"),
    OPEN: ("iu", "numbers of slots, integers"),
    LIGHT: ("f", "light, floats"),
    DEVIATION: ("f", "standard deviations, floats"),
}
"""Arrays of the frame's shape: the allowed kinds of numpy type, and their description."""
_MOST_LIGHT = 1e30
"""Largest number of electrons, or of electrons per second, in a frame file."""
_MOST_FRAME_S = 1e8
"""Largest length of a frame in seconds that is taken for one; about three years."""


def read_frame_arrays(
    path: Path, is_needed: Callable[[str], bool] = lambda name: True
) -> tuple[Arrays, JsonObject]:
    """Read and check the frame file `path`. Return its arrays by name, and its meta (see
    `nscc_runtime.frame_file.meta`).

    Only `frame`, `meta` and the arrays for which `is_needed(name)` is true are read; by default
    all. An array that the file lacks is left out. Raises InvalidArrays if the file is not a valid
    frame file, and OSError if it cannot be read."""
    arrays, _ = npz_arrays(path, lambda name: name in ("frame", "meta") or is_needed(name))
    return arrays, checked_meta(arrays)


def checked_meta(arrays: Mapping[str, Array]) -> JsonObject:
    """Check the arrays of a frame file, by name, and return its meta (see
    `nscc_runtime.frame_file.meta`).

    Raises InvalidArrays, with the first fault as text, if `meta` or `frame` is missing, the meta is
    of another schema, or an array has a wrong type, shape or size of values. Arrays with other
    names must be real numbers, and are not checked further."""
    for name in ("meta", "frame"):
        if name not in arrays:
            raise InvalidArrays(f"the array `{name}` is missing")
    meta = frame_meta(arrays)
    if meta is None:
        raise InvalidArrays(f"its schema is not {SCHEMA}")
    shape = arrays["frame"].shape
    pictured = "margin" in arrays  # every program with images or planes writes it
    if not 3 <= len(shape) <= 5 or 0 in (*shape[:-3], *shape[-2:]):
        raise InvalidArrays(f"its frame is {shape}, not (buckets, rows, cols)")
    if shape[-3] == 0 and not pictured:
        raise InvalidArrays("it has no exposures")
    for name, array in arrays.items():
        if name != "meta" and array.dtype.kind not in "buif":
            raise InvalidArrays(f"`{name}` is {array.dtype}, not real numbers")
    for name, (kinds, words) in _KINDS.items():
        values = arrays.get(name)
        if values is None:
            continue
        small = words.endswith("uint8") and values.dtype != np.uint8
        if values.dtype.kind not in kinds or small:
            raise InvalidArrays(f"`{name}` is {values.dtype}, not {words}")
        if values.shape != shape:
            raise InvalidArrays(f"`{name}` is {values.shape}, its frame {shape}")
        if kinds == "f" and (np.abs(values[np.isfinite(values)]) > _MOST_LIGHT).any():
            raise InvalidArrays(f"`{name}` has values above {_MOST_LIGHT:g}")
    if pictured:
        _check_pictures(arrays, shape)
    if not is_plan(meta.get("plan")):
        raise InvalidArrays("the `plan` of its meta does not list its effects")
    return meta


def _check_pictures(arrays: Mapping[str, Array], shape: tuple[int, ...]) -> None:
    """Raise InvalidArrays if images, planes, the margin or events do not fit a frame of `shape`:
    (buckets, rows, cols), possibly after axes of repeats. Pictures have the same shape without
    buckets; events are columns and rows within the frame, or -1."""
    pixels = (*shape[:-3], *shape[-2:])
    for name, values in arrays.items():
        if name == "margin" or name.startswith(("image_", "plane_")):
            if values.shape != pixels:
                raise InvalidArrays(f"`{name}` is {values.shape}, its frame {shape}")
        elif name.startswith("report_events_") and f"{name}_count" in arrays:
            size = np.array(shape[:-3:-1])  # cols, rows: an event is a column and a row
            if values.shape[-1:] != (2,) or values.dtype.kind != "i" or (values >= size).any():
                raise InvalidArrays(f"`{name}` does not hold columns and rows of its frame")


def frame_meta(arrays: Mapping[str, Array]) -> JsonObject | None:
    """Return the `meta` of a frame file, whose array is one text in JSON; None if `meta` is missing
    or damaged, or has another `schema`, as in arrays of another file."""
    text = arrays.get("meta")
    if text is None or text.dtype.kind != "U" or text.size != 1:
        return None
    try:
        meta = json.loads(str(text.reshape(())))
    except (ValueError, RecursionError):
        return None
    return meta if isinstance(meta, dict) and meta.get("schema") == SCHEMA else None


def is_plan(plan: object) -> bool:
    """Return whether `plan`, the entry of a meta, can be shown: None, or a dict whose list
    "effects" (missing: empty) has dicts with the texts "name" and "decision"."""
    if plan is None:
        return True
    rows = plan.get("effects", []) if isinstance(plan, dict) else None
    return isinstance(rows, list) and all(
        isinstance(row, dict) and all(isinstance(row.get(k), str) for k in ("name", "decision"))
        for row in rows
    )


def image_of(frame: Path) -> Floats32:
    """Return the image that `nscc reconstruct FRAME` writes: electrons over the frame (rows, cols).

    It is computed from the light in the frame file; repeats are averaged. Raises Rejected (NS0819,
    status 2) if the file is not a frame file of pixels that look."""
    reads(frame)
    try:
        arrays, meta = read_frame_arrays(frame, {LIGHT, DEVIATION}.__contains__)
        light, deviation = arrays[LIGHT], arrays[DEVIATION]
        frame_s = float(meta["frame_us"]) * 1e-6
        if light.ndim > 4 or np.isinf(light).any() or not 0 < frame_s < _MOST_FRAME_S:
            raise InvalidArrays(f"it has light {light.shape} of a frame of {frame_s:g} s, or inf")
    except (OSError, ValueError, KeyError, TypeError) as error:
        reason = f"it has no array {error}" if isinstance(error, KeyError) else str(error)
        raise rejected(
            "NS0819",
            f"'{frame.as_posix()}' does not contain light: it is not a frame file of a "
            "program whose pixels look at the light",
            notes=(reason,),
            helps=(
                "`nscc reconstruct any FRAME.npz` decodes the frame of any program",
                "`nscc run PROGRAM.nsl --scene SCENE -o FRAME.npz` exposes a picture or a clip",
            ),
        ) from None
    if light.ndim == 3:
        light, deviation = light[None], deviation[None]
    images = [merged_image(*pair) for pair in zip(light, deviation, strict=True)]
    return np.asarray(np.mean(images, axis=0) * frame_s, np.float32)
