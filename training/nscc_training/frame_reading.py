"""Reading frame files for reconstruction, and dark frames, with messages of what is wrong."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from nscc.arrays import Array, Bools, Bytes, Floats, Floats32, Ints
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity, rejected
from nscc.files import reads
from nscc.mappings import JsonObject
from nscc.npy import InvalidArrays
from nscc.program.problems import counted
from nscc_runtime.frame_arrays import read_frame_arrays
from nscc_runtime.light import Light
from nscc_runtime.looked_light import OPEN
from nscc_runtime.pieces import COLOURS
from nscc_training.code_choices import over_array
from nscc_training.problems import why_no_arrays

_SLOTS = "decode_slot_us"
_READ = ("saturated", OPEN, _SLOTS, "shutter", "shutter_shape")


class FrameRead(NamedTuple):
    """The content of a frame file that reconstruction needs.

    `frame` contains converter codes (colours, rows, cols), for two buckets (colours, 2, rows,
    cols), with one colour or red, green, blue. `saturated` marks saturated codes. `shutter` (N,
    rows, cols) are the first bucket's shutters, `slot_us` (N,) the slot lengths, None if not
    stored. `opened`, in the shape of `frame`, is the number of open slots of pixels that looked,
    else None. `meta` is the metadata of the file."""

    frame: Bytes
    saturated: Bools
    meta: JsonObject
    shutter: Array | None
    opened: Ints | None = None
    slot_us: Floats | None = None

    @property
    def buckets(self) -> int:
        """Number of buckets, and thus of frames per exposure and colour: 1 or 2."""
        return 1 if self.frame.ndim == 3 else self.frame.shape[1]


def read_frame(path: Path) -> FrameRead:
    """Read the frame file `path`, with one exposure or with one for each colour.

    Raises Rejected (NS0819) for files that cannot be read, for frames with repeats or more than two
    buckets, and for shutters of another size than the frame."""
    file = frame_arrays(path)
    frame, saturated, stored_shutters = file.frame, file.saturated, file.shutter
    # Repeats and colours are both a first axis; the metadata tells them apart.
    in_colours = "colours" in file.meta and frame.shape[:1] == (len(COLOURS),)
    if frame.ndim != 3 + in_colours or frame.shape[-3] not in (1, 2):
        raise no_frame(path, f"its frame is {frame.shape}, not one exposure in a bucket or two")
    shutter = None
    if stored_shutters is not None:
        if (sizes := stored_shutters.shape[:-1]) != frame.shape[-3:]:
            raise no_frame(path, f"its shutters are of {sizes}, its frame {frame.shape}")
        shutter = np.asarray(stored_shutters[0].transpose(2, 0, 1), np.bool_)
    opened = None if file.opened is None else by_colour(file.opened, in_colours)
    codes, full = (by_colour(values, in_colours) for values in (frame, saturated))
    return FrameRead(codes, full, file.meta, shutter, opened)


def refuse_missing(path: Path) -> None:
    """Raise Rejected (NS0819) if the file `path` cannot be opened, before slow packages are
    imported."""
    try:
        path.open("rb").close()
    except OSError as error:
        raise no_frame(path, why_no_arrays(error)) from error


def by_colour(values: Array, in_colours: bool) -> Array:
    """Return an array ([colours,] buckets, rows, cols) with an axis of colours, and an axis of
    buckets only if there are two: (colours, [2,] rows, cols).

    `in_colours` says whether the array has an axis of colours; otherwise the result has one colour.
    """
    if values.shape[-3] == 1:
        return values[:, 0] if in_colours else values
    return values if in_colours else values[None]


def frame_arrays(path: Path) -> FrameRead:
    """Return the content of the frame file `path` in the shapes that it has there, which may
    include repeats; shutters are unpacked to (buckets, rows, cols, N). Without `saturated` in the
    file, no pixel counts as saturated.

    Raises Rejected (NS0819) for a file that cannot be read, damaged shutters or invalid slot
    lengths."""
    reads(path)
    try:
        arrays, meta = read_frame_arrays(path, _READ.__contains__)
    except (InvalidArrays, OSError) as error:
        raise no_frame(path, why_no_arrays(error)) from error
    codes, slot_us = arrays["frame"], arrays.get(_SLOTS)
    if slot_us is not None and not are_lengths(slot_us):
        raise no_frame(path, f"`{_SLOTS}` are not valid slot lengths")
    # Without `saturated` in the file, no pixel counts as saturated.
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
    """Return the number `name` in the metadata `meta` of a frame. Raise ValueError if it is
    missing, not a number (a bool is none) or not finite."""
    value = meta.get(name)
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    if value is not None and is_number and abs(value) <= sys.float_info.max:
        return float(value)
    raise ValueError(f"`{name}` of its meta is {str(value)[:40]}, not a number")


def no_frame(
    path: Path | str,
    reason: str,
    help_text: str = "`nscc run RUN/shutter.nsl --scene .. -o FRAME.npz` writes one",
) -> Exception:
    """Return the error (NS0819), for the caller to raise, that the file `path` cannot be
    reconstructed, with the `reason` and what to do (`help_text`)."""
    message = f"'{path}' is not a frame that can be reconstructed"
    return rejected("NS0819", message, notes=(reason,), helps=(help_text,))


_LIT = 0.01
"""Largest fraction of saturated pixels in a dark frame; more mean that there was light."""


class Dark(NamedTuple):
    """A dark frame, from one exposure or repeated ones. It is subtracted from frames, because it
    contains the offsets of words and pixels.

    `name` is its file, for messages. `offset` (rows, cols), or (2, rows, cols) for two buckets, is
    the mean converter code above the ADC's offset. `meta` is the metadata of the file. `slot_us`
    (N,) are the slot lengths, None if unknown. `saturated` is the fraction of saturated pixels."""

    name: str
    offset: Floats
    meta: Mapping[str, Any]
    slot_us: Sequence[float] | Floats | None
    saturated: float

    def checked(
        self, frame: Mapping[str, Any], size: tuple[int, ...], *, force: bool = False
    ) -> tuple[Diagnostic, ...]:
        """Return warnings about subtracting this dark frame from a frame whose metadata is `frame`.

        `size` (rows, cols) is the size of the array. Raises Rejected (NS0819) if the dark frame has
        another program or contains light; with `force` these are warnings. A dark frame of another
        size cannot be subtracted: for it the result is empty, and the caller refuses it. An unknown
        light is a warning (NS0844) only if too many pixels are saturated."""
        if self.offset.shape[-2:] != tuple(size):
            return ()
        severity = Severity.WARNING if force else Severity.ERROR
        doubts = tuple(
            Diagnostic(
                "NS0819",
                f"'{self.name}' is not a dark frame for this frame: {reason}",
                severity=severity,
                notes=(
                    "the dark frame is subtracted, because it contains the offsets of words and "
                    "pixels",
                ),
                helps=(
                    "expose it with the frame's program: `nscc run FILE --scene "
                    "builtin:dark`, or a chip with its lens cap on",
                ),
            )
            for reason in self._doubts(frame)
        )
        if doubts and not force:
            raise Rejected(doubts, status=2)
        return doubts + tuple(self._bright())

    def _doubts(self, frame: Mapping[str, Any]) -> Iterator[str]:
        """Yield the reasons why this dark frame does not fit a frame with the metadata `frame`:
        another program (if both files name theirs by a digest), or light."""
        own_digest, frame_digest = (meta.get("program_sha256") for meta in (self.meta, frame))
        if own_digest is not None and frame_digest is not None and own_digest != frame_digest:
            yield "it was exposed with another program"
        if self._is_lit():
            yield "it was exposed to light"

    def _is_lit(self) -> bool | None:
        """Return whether the dark frame was exposed to light, by the digest of its scene. Return
        None if it has no digest, as from a chip, or no slot lengths."""
        scene, rows_cols = self.meta.get("scene_sha256"), self.offset.shape[-2:]
        if scene is None or self.slot_us is None:
            return None
        night = np.zeros(rows_cols, np.float32)
        seconds = np.asarray(self.slot_us, np.float64) * 1e-6
        if Light.of_still(night, seconds).sha256() == scene:
            return False
        # An array of zeros in every slot is also no light.
        clip = np.broadcast_to(night, (len(seconds), *rows_cols))
        return bool(Light.of_clip(clip).sha256() != scene)

    def _bright(self) -> Iterator[Diagnostic]:
        """Warn (NS0844) if more pixels are saturated than hot pixels explain, and it is unknown
        whether there was light."""
        if self.saturated > _LIT and self._is_lit() is None:
            yield Diagnostic(
                "NS0844",
                f"{100 * self.saturated:.3g} % of the pixels of '{self.name}', a dark "
                "frame, are saturated",
                severity=Severity.WARNING,
                notes=("in a dark frame only hot pixels are saturated",),
                helps=("use a frame that was exposed without light on the chip",),
            )


def of_pixels(offset: Floats, tile: tuple[int, int]) -> Floats:
    """Return the offset of each pixel (rows, cols) minus the mean over the pixels at the same place
    of all tiles.

    What remains belongs to single pixels; the mean belongs to their code. `offset` is (rows, cols),
    and `tile` the size (rows, cols) of a tile, which repeats from the top left corner."""
    pattern = np.empty_like(offset)
    for row, col in np.ndindex(tile):
        place = offset[row :: tile[0], col :: tile[1]]
        pattern[row :: tile[0], col :: tile[1]] = place - place.mean()
    return pattern


def undarkened(codes: Bytes, offset: Floats) -> Floats32:
    """Return converter codes ([2,] rows, cols) minus the dark offset ([2,] rows, cols), float32.

    The offset is repeated if the codes cover several arrays side by side."""
    return np.asarray(codes - over_array(offset, *codes.shape[-2:]), np.float32)


def read_dark(path: Path, buckets: int) -> Dark:
    """Read a dark frame file with one exposure or repeated ones, whose mean counts.

    Raises Rejected (NS0819) if it cannot be read, has another number of buckets, or lacks the
    offset of the converter."""
    file = frame_arrays(path)
    codes = file.frame.reshape(-1, *file.frame.shape[-3:])
    if codes.shape[1] != buckets or 0 in codes.shape:
        expected = counted(buckets, "bucket")
        raise no_frame(path, f"its frames are {codes.shape[1:]}, not of {expected}")
    try:
        adc_offset = number_of(file.meta, "adc_offset")
    except ValueError as error:
        raise no_frame(path, str(error)) from error
    full = float(file.saturated.mean())
    return Dark(str(path), mean_dark(codes, adc_offset), file.meta, file.slot_us, full)


def mean_dark(codes: Array, adc_offset: float) -> Floats:
    """Return the mean converter code above the offset `adc_offset`, (rows, cols), or (2, rows,
    cols) for two buckets. `codes` are repeated exposures (repeats, buckets, rows, cols)."""
    return np.asarray(by_colour(codes.mean(axis=0), in_colours=False)[0] - adc_offset)
