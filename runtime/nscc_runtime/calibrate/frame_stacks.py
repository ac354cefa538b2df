"""Read the frames of a calibration: frame files of nscc, arrays, pictures, and folders of them.

Each file or folder is one level: frames of the same light and exposure time. The exposure time is
taken from the first of: the name (PATH@TIME, TIME a number with s, ms or us), the key `exposure_us`
of an .npz or .mat file, the `meta` of a frame file."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from math import prod
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Array, Bools
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.files import reads
from nscc.npy import npy_header, npz_arrays
from nscc_runtime.frame_arrays import checked_meta, frame_meta
from nscc_runtime.scenes.errors import size
from nscc_runtime.scenes.light_arrays import mat_arrays, mat_shapes

Codes = NDArray[np.uint16]

TIME_KEY = "exposure_us"
KEYS = ("frame", "frames")
"""Names of the array of frames in a file; the first one that exists counts."""
_SECONDS = {"s": 1.0, "ms": 1e-3, "us": 1e-6}
_TIME = re.compile(r"([0-9.]+(?:e[+-]?[0-9]+)?)(s|ms|us)")
_MOST_PIXELS, _MOST_BYTES = 1 << 24, 1 << 30
"""Largest number of pixels of a frame, and of bytes of all frames of a level."""
_no_frames = partial(rejected, "NS0757")
_SAME_PROGRAM = ("program_sha256", "scene_sha256", "sensor_sha256", "device_seed")
"""Entries of a frame file's `meta` that are equal in frames that differ in noise only."""


@dataclass(frozen=True, eq=False)
class Stack:
    """Frames of one light and one exposure time.

    `name`: what messages call them. `codes` uint16 (K, rows, cols): converter codes. `valid` bool
    (rows, cols): pixels that are valid in all frames. `exposure_s`: seconds, None if unknown.
    `origin`: the same text for frame files of one program, scene and sensor; None for other frames.
    """

    name: str
    codes: Codes
    valid: Bools
    exposure_s: float | None = None
    origin: str | None = None


def load_stack(source: str, top_code: int) -> Stack:
    """Read the frames of PATH or PATH@TIME (such as 2ms), with converter codes in 0..`top_code`.

    PATH is a frame file, an array, a picture or a folder of pictures; the head of this module says
    where the exposure time comes from. Raises Rejected (status 2): NS0757 for unsuitable frames and
    exposure times, NS0732, NS0734, NS0735 for unreadable pictures."""
    path, time_s = _timed(source)
    name = str(path)
    if not path.exists():
        raise _no_frames(
            f"the frames '{name[:200]}' cannot be read: the file does not exist",
            helps=(
                "name a frame file, an array (.npz, .npy, .mat), a picture or a folder of them",
            ),
        )
    origin, valid = None, None
    if path.suffix.lower() in (".npz", ".npy", ".mat") and path.is_file():
        arrays = _arrays(path)
        key, values = _chosen(name, arrays)
        meta = frame_meta(arrays)
        if meta is not None:
            values, from_meta = _ours(name, values, meta)
            origin = json.dumps([meta.get(key) for key in _SAME_PROGRAM])
            time_s = from_meta if time_s is None else time_s
            frame_valid = arrays.get("valid")
            # A mask of another size belongs to another array: all pixels count as valid.
            if frame_valid is not None and frame_valid.size == values.size:
                is_valid = frame_valid.reshape(values.shape).astype(np.bool_)
                valid = np.asarray(is_valid.all(axis=0))
        elif path.suffix.lower() == ".mat" and values.ndim == 3:
            # MATLAB's frames are (rows, cols, K).
            values = np.moveaxis(values, 2, 0)
        if time_s is None and TIME_KEY in arrays:
            with suppress(ValueError, TypeError):
                time_s = float(np.asarray(arrays[TIME_KEY], np.float64).reshape(())) * 1e-6
            if time_s is None or not _is_time(time_s * 1e6):
                raise _wrong_time(name, f"`{TIME_KEY}`")
    else:
        key, values = "the picture", _pictures(path)
    codes = _codes(name, key, values, top_code)
    if valid is None:
        valid = np.ones(codes.shape[1:], np.bool_)
    if time_s is not None:
        time_s = float(f"{time_s:.9g}")  # sums of slots differ in their last bits
    return Stack(name, codes, valid, time_s, origin)


def grouped(stacks: Iterable[Stack]) -> list[Stack]:
    """Return the stacks in order, those of the same run merged into the first of them.

    Stacks of a run have the same `origin`, exposure time and size; their valid pixels are those
    that are valid in all. A stack without an origin stays alone."""
    stacks_by_run: dict[object, Stack] = {}
    for stack in stacks:
        run = (stack.origin, stack.exposure_s, stack.codes.shape[1:])
        key = len(stacks_by_run) if stack.origin is None else run
        if key in stacks_by_run:
            earlier = stacks_by_run[key]
            codes = np.concatenate([earlier.codes, stack.codes])
            stack = replace(earlier, codes=codes, valid=earlier.valid & stack.valid)
        stacks_by_run[key] = stack
    return [*stacks_by_run.values()]


def _timed(source: str) -> tuple[Path, float | None]:
    """Split PATH@TIME into path and seconds; None without TIME, or if a file has this name. TIME is
    a number with s, ms or us. Raises Rejected (NS0757) for another TIME."""
    path, at, time = source.rpartition("@")
    if not at or Path(source).exists():
        return Path(source), None
    match = _TIME.fullmatch(time)
    with suppress(ValueError):
        seconds = float(match[1]) * _SECONDS[match[2]] if match else np.nan
        if _is_time(seconds * 1e6):
            return Path(path), seconds
    raise _wrong_time(source, f"'{time[:40]}'")


def _is_time(us: float) -> bool:
    """Return whether an exposure time is valid: 0, or from a picosecond to thirty years."""
    return us == 0 or 1e-6 <= us <= 1e15


def _wrong_time(name: str, text: str) -> Rejected:
    """Return the error (NS0757) that the exposure time of the argument `name` is invalid; `text` is
    what was found."""
    return _no_frames(
        f"invalid exposure time of '{name[:200]}': {text}",
        helps=("write PATH@TIME with TIME such as 2ms, 500us or 0.1s",),
    )


def _arrays(path: Path) -> dict[str, Array]:
    """Return the needed arrays of the file `path` by key; the array of an .npy file has the key
    `frame`. Sizes are checked before data is read. Raises Rejected (NS0757) for arrays that are too
    large and for a damaged file."""
    reads(path)
    try:
        if path.suffix.lower() == ".mat":
            for key, shape in mat_shapes(path).items():
                # The type is unknown here: a number has one byte or more.
                _check_size(path, key, shape, frame=shape[:2], itemsize=1)
            return mat_arrays(path)
        if path.suffix.lower() == ".npy":
            with open(path, "rb") as file:
                _check_header(path, KEYS[0], file)
            return {KEYS[0]: np.load(path, allow_pickle=False)}
        with open(path, "rb") as file, np.load(file, allow_pickle=False) as archive:
            names = set(archive.files)
            if "meta" in names:  # frame files of a chip lack exposures in electrons
                names &= {KEYS[0], "valid", "meta", TIME_KEY}
            for key in sorted(names):
                with archive.zip.open(f"{key}.npy") as entry:
                    _check_header(path, key, entry)
        arrays, _ = npz_arrays(path, names.__contains__)
        if frame_meta(arrays) is not None:
            checked_meta(arrays)
        return arrays
    except Rejected:
        raise
    except Exception as error:  # numpy, zipfile and scipy.io raise a dozen types
        raise _no_frames(
            f"the frames '{path}' cannot be read: {' '.join(str(error).split())[:200]}",
            helps=("check that the file is complete and that its ending matches its format",),
        ) from error


def _check_header(path: Path, key: str, file: IO[bytes]) -> None:
    """Raise Rejected (NS0757) if the array `key` of the file `path` is too large, by the .npy
    header at the start of the open `file`, before its data is read."""
    _, shape, _, dtype = npy_header(file)
    _check_size(path, key, shape, frame=shape[-2:], itemsize=dtype.itemsize)


def _check_size(
    path: Path, key: str, shape: Sequence[int], frame: Sequence[int], itemsize: int
) -> None:
    """Raise Rejected (NS0757) for an array `key` of the file `path` with frames that are too large,
    or too many.

    `shape` is that of the array, `frame` are the sizes of its two axes that belong to one frame,
    and `itemsize` is the number of bytes of a sample."""
    if prod(frame) > _MOST_PIXELS:
        raise _no_frames(
            f"'{key}' in '{path}' is {size(shape)}, but a frame has at most "
            f"{_MOST_PIXELS:,} pixels",
            helps=("crop the array: photon transfer needs some thousand pixels",),
        )
    if prod(shape) * itemsize > _MOST_BYTES:
        raise _no_frames(
            f"'{key}' in '{path}' is {size(shape)}: {prod(shape) * itemsize / 2**30:.3g} GiB",
            notes=(f"frames of one level may have at most {_MOST_BYTES >> 30} GiB",),
            helps=("a few hundred frames per level are enough; save codes as uint8 or uint16",),
        )


def _chosen(name: str, arrays: Mapping[str, Array]) -> tuple[str, Array]:
    """Return the key and the array of the frames in the file `name`, among its `arrays` by key. It
    is the first of `KEYS` that exists, or the only array beside the exposure time.

    Raises Rejected (NS0757) if there are several arrays, or none, without such a key."""
    for key in KEYS:
        if key in arrays:
            return key, arrays[key]
    other_keys = [key for key in arrays if key != TIME_KEY]
    if len(other_keys) == 1:
        return other_keys[0], arrays[other_keys[0]]
    shown = ", ".join(repr(key[:40]) for key in other_keys[:12]) or "nothing"
    raise _no_frames(
        f"'{name}' has no array 'frame'",
        notes=(f"it holds {shown}",),
        helps=("save the codes under that name: np.savez(file, frame=a), (K, rows, cols)",),
    )


def _ours(name: str, values: Array, meta: Mapping[str, Any]) -> tuple[Array, float | None]:
    """Return the converter codes (K, rows, cols) of the frame file `name`, and for how long (s) its
    pixels were open, None if unknown.

    `values` are the codes in the file, (buckets, rows, cols) or (K, buckets, rows, cols), and
    `meta` its description. Raises Rejected (NS0757) for several buckets, for pixels with different
    open times, and for an invalid time."""
    shaped = values[None] if values.ndim == 3 else values
    if shaped.ndim != 4 or shaped.shape[1] != 1:
        raise _no_frames(
            f"the frame file '{name}' has {size(values.shape)} codes: more than one bucket",
            helps=("expose flats and darks with a program of one bucket: `open when n < N`",),
        )
    if "open_us" not in meta:
        return shaped[:, 0], None
    times = meta["open_us"]
    if not isinstance(times, list) or len(times) != 1 or not isinstance(times[0], int | float):
        raise _no_frames(
            f"the pixels of '{name}' were open for different times",
            notes=("photon transfer compares pixels with the same light and exposure time",),
            helps=("expose flats and darks with a program without codes: `open when n < N`",),
        )
    if isinstance(times[0], bool) or not _is_time(times[0]):
        raise _wrong_time(name, f"`open_us` of its meta is {times[0]}"[:80])
    return shaped[:, 0], times[0] * 1e-6


def _pictures(path: Path) -> Array:
    """Return the stored values (K, rows, cols) of the pictures in the file or folder `path`; of
    colours with equal channels one is kept. Raises Rejected: NS0757 for a file with another ending
    or in colour, and the errors of `files_of` and `open_pages`."""
    from nscc_runtime.scenes.picture_files import PICTURES, open_pages
    from nscc_runtime.scenes.picture_folders import files_of, read_folder

    if path.is_dir():
        # The order of frames does not matter, nor do gaps in their numbers.
        pictures = [picture for picture, _ in read_folder(files_of(path, skip=True))]
    elif path.suffix.lower() in PICTURES:
        pictures = list(open_pages(path).read())
    else:
        raise _no_frames(
            f"the ending of '{path}' is not a format for frames",
            notes=(f"frames end in .npz, .npy, .mat, {', '.join(PICTURES)}",),
            helps=("give the file the ending of its format",),
        )
    for picture in pictures:
        if picture.ndim == 3 and np.any(picture != picture[..., :1]):
            raise _no_frames(
                f"'{path}' is in colour",
                notes=("photon transfer needs the codes of the ADC, one per pixel",),
                helps=("save the frames as grey pictures or arrays",),
            )
    return np.stack([p[..., 0] if p.ndim == 3 else p for p in pictures])


def _codes(name: str, key: str, values: Array, top_code: int) -> Codes:
    """Return the converter codes `values`, (K, rows, cols) or (rows, cols), as uint16 (K, rows,
    cols). They are the array `key` of the file `name`.

    Raises Rejected (NS0757) for other shapes, fewer than 2 rows or columns, types that are not
    numbers, and values that are not integers from 0 to `top_code`."""
    if values.ndim == 2:
        values = values[None]
    if values.ndim != 3 or 0 in values.shape or min(values.shape[1:]) < 2:
        raise _no_frames(
            f"'{key}' in '{name}' is {size(values.shape)}, not frames",
            notes=(
                "a frame is (rows, cols), frames of one level (K, rows, cols); photon transfer "
                "needs at least 2 rows and 2 columns",
            ),
            helps=("in a .mat file frames are (rows, cols, K)",),
        )
    if values.dtype.kind not in "uif":
        raise _no_frames(
            f"'{key}' in '{name}' is of type {values.dtype}, not codes of the ADC",
            helps=("save the codes as integers: a.astype(np.uint8)",),
        )
    low, high = float(values.min()), float(values.max())
    # Codes may be stored as floats, but they must be whole numbers that the converter can give.
    integral = values.dtype.kind in "ui" or bool(np.all(values == np.rint(values)))
    if not (integral and low >= 0 and high <= top_code):
        problem = f"values from {low:g} to {high:g}" if integral else "values that are not whole"
        raise _no_frames(
            f"'{key}' in '{name}' has {problem}, which are not codes of an ADC with the "
            f"largest code {top_code}",
            notes=(
                "averaging and conversion to electrons remove the noise that photon transfer "
                "measures",
            ),
            helps=(
                "use the original frames of the ADC, one by one",
                "if the ADC has more bits, set the key adc_bits of the target: --target FILE.toml",
            ),
        )
    return values.astype(np.uint16)
