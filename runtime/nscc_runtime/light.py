"""The light on the array: the electrons that each pixel would collect in each slot."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from itertools import pairwise
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np

from nscc.arrays import Bools, Floats, Floats32, Ints, Ints32
from nscc.diagnostics.arguments import as_array, shown, wrong_argument
from nscc_runtime.caches import remembered

BRIGHTEST_E = 3.4e38
"""Infinite light of a slot counts as this, if effects are simulated, so that it saturates."""
_MOST_E = 1e36
"""Sums of float32 are limited to this value, because they may be infinite."""


_STRIP_BYTES = 1 << 26
"""Memory of the frames of one strip of rows, if frames are drawn."""


@dataclass(frozen=True, eq=False)
class DrawnFrames:
    """Frames that are drawn again whenever they are read, because all of them would take too much
    memory. They are read like an array of float32.

    `shape`: (T, rows, cols). `draw(numbers, rows)` returns these rows of the frames with these
    numbers, float32 (len(numbers), rows, cols)."""

    shape: tuple[int, int, int]
    draw: Callable[[range, slice], Floats32]
    ndim = 3
    dtype = np.dtype(np.float32)

    def __len__(self) -> int:
        """Return T, the number of frames."""
        return self.shape[0]

    def __getitem__(self, key: Any) -> Floats32:
        """Draw frames: `key` is a number of a frame or a slice of frames, and may go on with slices
        of rows and columns. Raises IndexError for a frame that does not exist."""
        given = key if isinstance(key, tuple) else (key,)
        which, rows, cols = (*given, slice(None), slice(None))[:3]
        numbers = range(len(self))[which]
        if isinstance(numbers, range):
            return self.draw(numbers, rows)[:, :, cols]
        return self.draw(range(numbers, numbers + 1), rows)[0, :, cols]

    def __iter__(self) -> Iterator[Floats32]:
        """Draw one frame (rows, cols) after the other."""
        return (self[k] for k in range(len(self)))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Floats32:
        """Return all frames as an array, for callers that need them together."""
        return np.asarray(self[:], dtype)


class LightMatrix(NamedTuple):
    """The frames and weights of a `Light`, with the names of its fields, for compiled loops. A
    frame is flat, row after row."""

    frames: Annotated[Floats32, "frames chip_pixels"]
    row_start: Annotated[Ints, "slots+1"]
    frame_index: Annotated[Ints32, "entries"]
    weight: Annotated[Floats, "entries"]


@dataclass(frozen=True, eq=False, repr=False)
class Light:
    """Electrons that each pixel collects in each of N slots while its shutter is open.

    Slot n is float32(sum over k of weight[k] * frames[frame_index[k]]) for k from `row_start[n]`
    to `row_start[n + 1]`. Products and sum are computed in float64, in this order, and rounded
    once. A still is one frame weighted with the slot lengths, so thousands of slots need the
    memory of one picture.

    Frames are not copied, and sums of them are remembered. If you change them in place, captures
    and plans notice it and use the new values; other methods of this object keep the old sums.

    Parameters
    ----------
    frames : array of float32, or DrawnFrames
        (T, rows, cols), at least 0, in any unit; the weights convert to electrons. A pixel with NaN
        is invalid in frames, and its neighbours get no charge from this light.
    row_start : array of int64
        (N + 1,): where the entries of each slot begin.
    frame_index : array of int32
        (row_start[N],): the frame of each entry.
    weight : array of float64
        (row_start[N],): the electrons of each entry for one unit of its frame.
    kind : {"still", "clip"}
    exposure_scale_e : float
        The factor that converted the scene's own numbers to electrons; 1 for scenes in electrons.
        It is part of the weights already, and stored in files only.
    motion : Light, optional
        The same light with the motion within slots, if the scene is sampled. It shares `frames`.
    """

    frames: Floats32 | DrawnFrames
    row_start: Ints
    frame_index: Ints32
    weight: Floats
    kind: Literal["still", "clip"]
    exposure_scale_e: float = 1.0
    motion: Light | None = None

    def __post_init__(self) -> None:
        """Raise WrongArgument for frames that are not float32 (T, rows, cols), for arrays of
        entries of other lengths, for no slot, and for weights that are not finite. Values of frames
        are not checked."""
        if self.frames.ndim != 3 or self.frames.dtype != np.float32:
            raise wrong_argument(
                "Light takes pictures (rows, cols) and clips (slots, rows, cols) of float32; its "
                f"frames are {shown(self.frames)}",
                helps=("a.astype(np.float32) converts an array",),
            )
        entries = int(self.row_start[-1])
        sizes = self.weight.shape, self.frame_index.shape
        no_slots = len(self.row_start) < 2
        if sizes != ((entries,),) * 2 or no_slots or not np.isfinite(self.weight).all():
            raise wrong_argument(
                f"Light takes a finite weight for each of {entries} entries and at least one "
                f"slot, not {shown(self.weight)}"
            )

    @classmethod
    def of_still(cls, frame: Floats32, weight: Floats, exposure_scale_e: float = 1.0) -> Light:
        """Return the light of one picture: slot n is weight[n] times the picture.

        Parameters
        ----------
        frame : array of float32
            (rows, cols), in any unit.
        weight : array of float64
            (N,), electrons in each slot for one unit of the picture: seconds for a picture in
            electrons per second, otherwise seconds times `exposure_scale_e`.
        exposure_scale_e : float
            The factor from the picture's unit to electrons per second, which `weight` contains.

        Returns
        -------
        Light
        """
        frame = as_array("Light", "the picture", frame)
        weight = as_array("Light", "the weights", weight, np.float64)
        starts = np.arange(weight.size + 1, dtype=np.int64)
        index = np.zeros(weight.size, np.int32)
        return cls(frame[None], starts, index, weight, "still", exposure_scale_e)

    @classmethod
    def of_clip(cls, frames: Floats32, exposure_scale_e: float = 1.0) -> Light:
        """Return the light of a clip with one frame for each slot.

        Parameters
        ----------
        frames : array of float32
            (N, rows, cols), in any unit.
        exposure_scale_e : float
            Factor from `frames` to electrons, which becomes the weight of every frame.

        Returns
        -------
        Light
        """
        frames = as_array("Light", "the clip", frames)
        starts = np.arange(len(frames) + 1 if frames.ndim else 2, dtype=np.int64)
        weight = np.full(len(starts) - 1, exposure_scale_e, np.float64)
        return cls(frames, starts, starts[:-1].astype(np.int32), weight, "clip", exposure_scale_e)

    def __repr__(self) -> str:
        """Return kind and size as one line."""
        rows, cols = self.shape
        return f"<nscc light: {self.kind}, {self.slots} slots, {rows} x {cols}>"

    @property
    def slots(self) -> int:
        """N, the number of slots."""
        return len(self.row_start) - 1

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, cols)."""
        return self.frames.shape[1], self.frames.shape[2]

    @property
    def timing(self) -> Hashable:
        """A key that is equal for two lights whose frames fall into the same slots with the same
        weights, whatever the frames contain."""
        arrays = self.row_start, self.frame_index, self.weight
        key = len(self.frames), *(array.tobytes() for array in arrays)
        return key if self.motion is None else (key, self.motion.timing)

    def slot(self, n: int, rows: slice = slice(None)) -> Floats32:
        """Return the electrons of one slot.

        Parameters
        ----------
        n : int
            Slot number.
        rows : slice
            Rows to return; all by default.

        Returns
        -------
        array of float32
            (rows, cols). It may be a view of `frames`, so do not write to it.
        """
        start, stop = int(self.row_start[n]), int(self.row_start[n + 1])
        if stop == start:  # no frame falls into the slot
            return np.zeros(self.shape, np.float32)[rows]
        if stop == start + 1 and self.weight[start] == 1.0:
            return self._frame(start, rows)
        total: Floats = self._frame(start, rows) * self.weight[start]
        for k in range(start + 1, stop):
            total += self._frame(k, rows) * self.weight[k]
        return total.astype(np.float32)

    def _frame(self, k: int, rows: slice) -> Floats32:
        """Return the `rows` of the frame of entry k, a view (rows, cols) of `frames`."""
        frame: Floats32 = self.frames[self.frame_index[k], rows]
        return frame

    def current(self) -> Light:
        """Return this light, or a new one without remembered sums if frames were changed in place
        since the first call. They are compared by a checksum, which takes much less time than a
        frame.

        Returns
        -------
        Light
        """
        if isinstance(self.frames, DrawnFrames):
            return self
        digest = zlib.crc32(np.ascontiguousarray(self.frames).data)
        if "digest" not in vars(self):
            self._forget_sums()
        if vars(self).setdefault("digest", digest) == digest:
            return self
        return replace(self, motion=self.motion and replace(self.motion))

    def _forget_sums(self) -> None:
        """Remove what was computed from the frames, of which no digest tells whether they changed
        since."""
        for name in vars(self).keys() - {field.name for field in fields(self)}:
            del vars(self)[name]
        if self.motion is not None:
            self.motion._forget_sums()

    def part(self, rows: slice, cols: slice) -> Light:
        """Return the light on a rectangle of pixels.

        Parameters
        ----------
        rows, cols : slice
            Rows and columns of the rectangle.

        Returns
        -------
        Light
        """
        return self._with_frames(np.ascontiguousarray(self.frames[:, rows, cols]))

    def strips(self, around: int = 0) -> Iterator[tuple[range, int, Light]]:
        """Yield the light in strips of rows, so that drawn frames need little memory.

        Parameters
        ----------
        around : int
            Rows that each strip has beyond its own on both sides, except beyond the border.

        Yields
        ------
        tuple
            The strip's own rows, the number of its first row, and its light. Frames in memory are
            one strip: this light itself.
        """
        if not isinstance(self.frames, DrawnFrames):
            yield range(self.shape[0]), 0, self
            return
        # The number of rows is a multiple of 64, as that of pixels has to be in some loops.
        most = max(64, _STRIP_BYTES // (4 * len(self.frames) * self.shape[1]) // 64 * 64)
        for begin in range(0, self.shape[0], most):
            rows = range(self.shape[0])[begin : begin + most]
            first = max(begin - around, 0)
            yield rows, first, self.part(slice(first, rows.stop + around), slice(None))

    def scaled(self, factor: float) -> Light:
        """Return the light multiplied by a factor.

        Parameters
        ----------
        factor : float
            At least 0, because light has no negative values.

        Returns
        -------
        Light
        """
        return self._with_frames(np.asarray(self.frames) * np.float32(factor))

    def _with_frames(self, frames: Floats32) -> Light:
        """Return the light with other `frames`, which the motion within slots shares."""
        motion = self.motion and replace(self.motion, frames=frames)
        return replace(self, frames=frames, motion=motion)

    def joined(self, starts: Sequence[int]) -> Light:
        """Return the same light in fewer, longer slots.

        Parameters
        ----------
        starts : sequence of int
            First slot of each new slot; the first is 0. A new slot ends where the next begins, the
            last at N.

        Returns
        -------
        Light
        """
        rows, index, weight = [0], [], []
        for begin, end in pairwise([*starts, self.slots]):
            entries = slice(int(self.row_start[begin]), int(self.row_start[end]))
            frame_numbers, place = np.unique(self.frame_index[entries], return_inverse=True)
            index.append(frame_numbers)
            weight.append(np.bincount(place, self.weight[entries], len(frame_numbers)))
            rows.append(rows[-1] + len(frame_numbers))
        return replace(
            self,
            row_start=np.array(rows, np.int64),
            frame_index=np.concatenate(index).astype(np.int32),
            weight=np.concatenate(weight),
            motion=self.motion and self.motion.joined(starts),
        )

    def dense(self) -> Floats32:
        """Return the electrons of all slots.

        Returns
        -------
        array of float32
            (N, rows, cols).
        """
        out = np.empty((self.slots, *self.shape), np.float32)
        for n in range(self.slots):
            out[n] = self.slot(n)
        return out

    @remembered
    def total_e(self) -> Floats:
        """Return the sum of all slots, to 1e-12 of its value.

        Slots with equal light are added as a multiple: equal slots of a still are one product.

        Returns
        -------
        array of float64
            (rows, cols), read-only.
        """
        slots: dict[tuple[bytes, bytes], list[int]] = {}
        for n in range(self.slots):
            entries = slice(int(self.row_start[n]), int(self.row_start[n + 1]))
            key = (self.frame_index[entries].tobytes(), self.weight[entries].tobytes())
            slots.setdefault(key, []).append(n)
        total = np.zeros(self.shape, np.float64)
        for alike in slots.values():
            slot = self.slot(alike[0])
            total += slot if len(alike) == 1 else slot.astype(np.float64) * len(alike)
        total.setflags(write=False)
        return total

    @cached_property
    def frame_weight(self) -> Floats:
        """The sum of the weights of each frame over all slots, (T,); 0 for frames that fall into
        none."""
        count = np.bincount(self.frame_index, self.weight, len(self.frames))
        return np.asarray(count, np.float64)

    @property
    def sum_e(self) -> Floats32:
        """The sum of all slots (rows, cols), at most 1e36, read-only. It adds up
        frames instead of slots; `total_e` is more exact and slower."""
        return self._summed[0]

    @property
    def most_e(self) -> float:
        """The largest sum of all slots of a pixel; NaN if a pixel has light that is NaN."""
        return self._summed[1]

    @cached_property
    def is_nan(self) -> Bools:
        """Which pixels (rows, cols) have light that is NaN in some slot."""
        return np.isnan(self.sum_e)

    @cached_property
    def matrix(self) -> LightMatrix:
        """The frames and weights as an argument of compiled loops; arrays are copied only if their
        type or order in memory differs."""
        return LightMatrix(
            np.require(self.frames, np.float32, ["C", "A"]).reshape(len(self.frames), -1),
            np.require(self.row_start, np.int64, ["C", "A"]),
            np.require(self.frame_index, np.int32, ["C", "A"]),
            np.require(self.weight, np.float64, ["C", "A"]),
        )

    @cached_property
    def _summed(self) -> tuple[Floats32, float]:
        """The light of all slots together, electrons (rows, cols), limited to `_MOST_E`, and the
        largest sum before the limit, NaN if one is NaN. Frames that fall into no slot do not
        count."""
        used = slice(None) if self.frame_weight.all() else np.flatnonzero(self.frame_weight)
        weight = self.frame_weight[used]
        with np.errstate(over="ignore", invalid="ignore"):
            strips = (np.asarray(light.frames)[used] for _, _, light in self.strips())
            # Weights beyond float32 are not rounded to it.
            if len(weight) and 1e-37 < weight[0] < 1e38 and (weight == weight[0]).all():
                sums = [
                    (frames[0] if len(frames) == 1 else frames.sum(axis=0)) * np.float32(weight[0])
                    for frames in strips
                ]
            else:
                sums = [
                    np.einsum("t,trc->rc", weight, frames).astype(np.float32) for frames in strips
                ]
        total = np.ascontiguousarray(sums[0]) if len(sums) == 1 else np.concatenate(sums)
        largest = float(total.max())
        if largest <= _MOST_E:  # False if a pixel is NaN
            return total, largest
        return np.minimum(total, np.float32(_MOST_E)), largest

    def on_frames(self, slots: Floats) -> Floats:
        """Convert weights of slots to weights of frames.

        Parameters
        ----------
        slots : array of float64
            J weights of each slot, (N, J).

        Returns
        -------
        array of float64
            J weights of each frame, (T, J).
        """
        # Two simple cases first, which need no sparse matrix (and no scipy).
        if len(self.frames) == 1 and self.one_each:
            return (self.weight @ slots)[None]
        if self.in_order:
            return self.weight[:, None] * slots
        return np.asarray(self._transposed @ slots)

    @cached_property
    def ended(self) -> Floats32:
        """The frames (T, rows, cols) in memory, with 0 for NaN and 1e30 for infinite light, so
        that closed slots contribute 0; the frames themselves without light that needs this."""
        frames = np.asarray(self.frames)
        if self.frame_weight.min() > 0 and self.most_e <= _MOST_E:
            return frames
        if np.isfinite(frames.max(initial=0)):
            return frames
        return np.minimum(np.where(np.isnan(frames), np.float32(0.0), frames), np.float32(1e30))

    @cached_property
    def one_each(self) -> bool:
        """Whether each slot has exactly one entry: it is a multiple of one frame, which may differ
        from slot to slot."""
        return bool(np.array_equal(self.row_start, np.arange(self.slots + 1)))

    @cached_property
    def in_order(self) -> bool:
        """Whether there are as many frames as slots, and the light of each slot n is a multiple of
        frame n, as in a clip with one frame for each slot."""
        count = len(self.frames)
        if not len(self.weight) == self.slots == count:
            return False
        return self.one_each and bool(np.array_equal(self.frame_index, np.arange(count)))

    @cached_property
    def even(self) -> bool:
        """Whether all slots have the same light of one frame."""
        one_frame = len(self.frames) == 1 and self.one_each
        return one_frame and bool(np.all(self.weight == self.weight[0]))

    @cached_property
    def _transposed(self) -> Any:
        """Return the matrix of slots and frames as a sparse array with one row for each frame."""
        from scipy.sparse import csr_array

        entries = self.weight, self.frame_index, self.row_start
        return csr_array(entries, (self.slots, len(self.frames))).T.tocsr()

    def sha256(self) -> str:
        """Return a digest of shape, matrix and frames: equal light has equal digests.

        Returns
        -------
        str
            Hexadecimal.
        """
        import hashlib

        digest = hashlib.sha256(f"light {self.slots} {self.frames.shape} {self.kind}".encode())
        matrix = ((self.row_start, "<i8"), (self.frame_index, "<i4"), (self.weight, "<f8"))
        for values, kind in matrix:
            digest.update(np.ascontiguousarray(values, kind).data)
        for frame in self.frames:
            digest.update(np.ascontiguousarray(frame, "<f4").data)
        if self.motion is not None:
            digest.update(self.motion.sha256().encode())
        return digest.hexdigest()
