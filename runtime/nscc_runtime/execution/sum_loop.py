"""Weighted sums of a scene's frames of light, by the compiled loop."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated

import numpy as np

from nscc.arrays import Bytes, Floats, Floats32, Ints, Ints32
from nscc.mappings import NamedValues
from nscc_runtime.light import DrawnFrames, Light
from nscc_runtime.loop import Written, compiled, inlined, loop, record
from nscc_runtime.pool import in_parts

SUM_BLOCK = 512
"""Number of pixels of a row whose light is gathered together."""

_PIXELS_A_LANE = 8
"""Number of pixels for each lane (the pixels of one distinct shutter) whose sums stay in the
processor cache for all frames: the table of weights, which may not fit, is read once for them."""

FRAMES_TOGETHER = 4
"""Number of frames that are added in one pass over the sums."""


@record
class SceneSizes:
    """The size of the frames, and the rows `begin` to `end` - 1 to process. `count`: number of
    frames. `lane_count`: number of lanes (the pixels of one distinct shutter each).

    Of the `sums` sums, those from number `smeared` on use light after crosstalk; `fraction` of a
    pixel's light moves to each neighbour."""

    begin: int
    end: int
    rows: int
    cols: int
    count: int
    lane_count: int
    sums: int
    smeared: int
    fraction: float


@inlined
def _moved(
    frames: Floats32,
    share: Floats32,
    frame: int,
    p: int,
    up_step: int,
    down_step: int,
    left_step: int,
    right_step: int,
    c: np.float32,
) -> np.float32:
    """Return the light of pixel p of a frame after crosstalk, where `share` is a factor on the
    light of each pixel, and `c` the part that moves to each neighbour.

    `frame`: index in `frames` of the frame's first pixel. The steps are the differences of index to
    the four neighbours; 0 at a border, so that the pixel itself stands for a missing neighbour."""
    own_light = share[p] * frames[frame + p]
    # Quarters are exact, and their sum stays within the range of float32.
    quarter = np.float32(0.25)
    mean = (
        quarter * (share[p + up_step] * frames[frame + p + up_step])
        + quarter * (share[p + down_step] * frames[frame + p + down_step])
        + quarter * (share[p + left_step] * frames[frame + p + left_step])
        + quarter * (share[p + right_step] * frames[frame + p + right_step])
    )
    exchanged: np.float32 = own_light + np.float32(4.0) * c * (mean - own_light)
    return exchanged


@compiled
def _smear(
    sizes: SceneSizes,
    frames: Floats32,
    share: Floats32,
    frame: int,
    first: int,
    stop: int,
    lit: Floats32,
    at: int,
) -> None:
    """Set lit[at + i] to q + fraction laplacian(q) at pixel first + i, where q = share * frame.

    `frame`: index in `frames` of the frame's first pixel. Pixels `first` to `stop` - 1, at least
    one, belong to one row. A neighbour beyond the border counts as equal to the pixel, so no light
    is lost there."""
    cols, c = sizes.cols, np.float32(sizes.fraction)
    row = first // cols
    up_step = -cols if row > 0 else 0
    down_step = cols if row + 1 < sizes.rows else 0
    # Inner pixels have all neighbours: no branch, so LLVM vectorises the loop.
    for p in range(first + 1, stop - 1):
        lit[at + p - first] = _moved(frames, share, frame, p, up_step, down_step, -1, 1, c)
    left_step, right_step = -1 if first % cols else 0, 1 if first + 1 < (row + 1) * cols else 0
    lit[at] = _moved(frames, share, frame, first, up_step, down_step, left_step, right_step, c)
    left_step, right_step = -1 if (stop - 1) % cols else 0, 1 if stop % cols else 0
    lit[at + stop - 1 - first] = _moved(
        frames, share, frame, stop - 1, up_step, down_step, left_step, right_step, c
    )


@compiled
def _gather(
    source: Floats32, at: int, step: int, count: int, first: int, stop: int, gathered: Floats
) -> None:
    """Add the light of pixel first + i of `count` frames to gathered[i], up to pixel `stop` - 1.

    `at`: index in `source` of pixel 0 of the first frame; each further frame begins `step` later.
    """
    for k in range(0, count - count % FRAMES_TOGETHER, FRAMES_TOGETHER):
        frame = at + k * step
        for p in range(first, stop):
            total = gathered[p - first] + source[frame + p]
            total += source[frame + step + p]
            total += source[frame + 2 * step + p]
            gathered[p - first] = total + source[frame + 3 * step + p]
    for k in range(count - count % FRAMES_TOGETHER, count):
        frame = at + k * step
        for p in range(first, stop):
            gathered[p - first] += source[frame + p]


@compiled
def _add_alike(
    sizes: SceneSizes,
    frames: Floats32,
    share: Floats32,
    k: int,
    alike: int,
    table: Floats,
    lit_sums: Bytes,
    lanes: Ints32,
    first: int,
    stop: int,
    lit: Floats32,
    gathered: Floats,
    out: Floats,
) -> None:
    """Add frames `k` to k + alike - 1, which have equal weights, to all sums `out`, for pixels
    `first` to `stop` - 1.

    `table` (sums, count, lanes): the weights. `lit_sums` (sums, count): 1 if a sum contains a
    frame. `lanes`: the lane (the pixels of one distinct shutter) of each pixel. `share`: a factor
    on the light of each pixel, for sums with crosstalk. `lit` (`FRAMES_TOGETHER` times `SUM_BLOCK`)
    and `gathered` are working memory."""
    pixels, count, lane_count = sizes.rows * sizes.cols, sizes.count, sizes.lane_count
    for smeared in range(2):
        begin, end = sizes.smeared * smeared, sizes.sums if smeared else sizes.smeared
        any_lit = 0
        for j in range(begin, end):
            any_lit |= lit_sums[j * count + k]
        if not any_lit:
            continue
        for i in range(stop - first):
            gathered[i] = 0.0
        if not smeared:
            _gather(frames, k * pixels, pixels, alike, first, stop, gathered)
        for first_frame in range(0, alike if smeared else 0, FRAMES_TOGETHER):
            together = min(FRAMES_TOGETHER, alike - first_frame)
            for index in range(together):
                frame = (k + first_frame + index) * pixels
                _smear(sizes, frames, share, frame, first, stop, lit, index * SUM_BLOCK)
            _gather(lit, -first, SUM_BLOCK, together, first, stop, gathered)
        for j in range(begin, end):
            if lit_sums[j * count + k]:
                row = (j * count + k) * lane_count
                for p in range(first, stop):
                    out[j * pixels + p] += table[row + lanes[p]] * gathered[p - first]


@loop
def scene_sums(
    sizes: SceneSizes,
    frames: Annotated[Floats32, "count rows cols"],
    share: Annotated[Floats32, "rows cols"],
    lanes: Annotated[Ints32, "rows cols"],
    table: Annotated[Floats, "sums count lane_count"],
    lit_sums: Annotated[Bytes, "sums count"],
    alike: Annotated[Ints, "count"],
    lit: Written[Floats32],
    gathered: Written[Floats],
    out: Written[Annotated[Floats, "sums rows cols"]],
) -> None:
    """Set out[j, p] to the sum over k of table[j, k, lanes[p]] * share[p] * frames[k, p], for the
    pixels p of rows `sizes.begin` to `sizes.end` - 1.

    For the sums j from number `sizes.smeared` on, share * frames is the light after crosstalk; it
    is computed in float32. All other products and sums are float64. The frames are read once for
    all sums. `lit_sums`: 1 if any lane (the pixels of one distinct shutter) has a nonzero weight
    for a frame in a sum. `alike`: number of consecutive frames from frame k on with equal weights;
    these are added up before they are weighted. `lit` and `gathered` are working memory for
    `FRAMES_TOGETHER` times `SUM_BLOCK` pixels and for `SUM_BLOCK` pixels."""
    cols, count, pixels = sizes.cols, sizes.count, sizes.rows * sizes.cols
    begin, together = sizes.begin, max(SUM_BLOCK, _PIXELS_A_LANE * sizes.lane_count)
    while begin < sizes.end:
        end = min(begin + -(-together // cols), sizes.end)
        for j in range(sizes.sums):
            for p in range(begin * cols, end * cols):
                out[j * pixels + p] = 0.0
        # Successive frames with equal weights are added together: `alike[k]` from frame k on.
        k = 0
        while k < count:
            for row in range(begin, end):
                for first in range(row * cols, (row + 1) * cols, SUM_BLOCK):
                    _add_alike(
                        sizes,
                        frames,
                        share,
                        k,
                        alike[k],
                        table,
                        lit_sums,
                        lanes,
                        first,
                        min(first + SUM_BLOCK, (row + 1) * cols),
                        lit,
                        gathered,
                        out,
                    )
            k += alike[k]
        for j in range(sizes.smeared):
            for p in range(begin * cols, end * cols):
                out[j * pixels + p] *= share[p]
        begin = end


_MOST_ENTRIES = 1 << 23
"""Largest number of table entries in memory, unless a single table is larger."""
_MOST_KEPT = 1 << 21
"""Largest number of table entries that are cached for the next light."""


@dataclass(frozen=True, eq=False)
class FrameWeights:
    """Weights (sums, frames, lanes) of frames of light, for all lights with the same `timing`
    (`Light.timing`). `frame_weight` (frames,): how much each frame of light weighs in all slots
    together. A lane is the pixels of one distinct shutter."""

    timing: Hashable
    weights: Floats
    frame_weight: Floats

    @classmethod
    def of(cls, light: Light, slots: Sequence[Floats]) -> FrameWeights:
        """Convert the weights `slots`, one array (N, lanes) for each sum, at least one, to weights
        of the frames of `light`. A lane is the pixels of one distinct shutter."""
        flat = np.stack(slots, axis=1).reshape(len(slots[0]), -1)
        by_frame = light.on_frames(flat).reshape(-1, len(slots), slots[0].shape[1])
        return cls(light.timing, np.ascontiguousarray(by_frame.swapaxes(0, 1)), light.frame_weight)

    @cached_property
    def lit_sums(self) -> Bytes:
        """Mask (sums, frames): whether any lane (the pixels of one distinct shutter) has a nonzero
        weight of a frame."""
        return np.asarray(self.weights.any(axis=2), np.uint8)

    @cached_property
    def alike(self) -> Ints:
        """For each frame, how many successive frames from it on have the same weights in all sums
        and lanes, (frames,); at least 1, the frame itself. A lane is the pixels of one distinct
        shutter."""
        count = self.weights.shape[1]
        differs = (self.weights[:, 1:] != self.weights[:, :-1]).any(axis=(0, 2))
        ends = np.append(np.flatnonzero(differs) + 1, count)
        frame = np.arange(count)
        return np.asarray(ends[np.searchsorted(ends, frame, side="right")] - frame, np.int64)

    @cached_property
    def most_part(self) -> Floats:
        """The largest weight of a frame in any sum, as a fraction of the frame's total weight, for
        each lane, (lanes,); 0 for frames without weight. A lane is the pixels of one distinct
        shutter."""
        fractions, frame_weight = np.zeros(self.weights.shape), self.frame_weight[:, None]
        np.divide(self.weights, frame_weight, out=fractions, where=frame_weight > 0)
        return np.asarray(fractions.max(axis=(0, 1)))


class SlotWeights:
    """The weights of slots in one or more sums, each an array (N, lanes). The weights of the last
    light's frames are cached, because series of frames have the same timing. A lane is the pixels
    of one distinct shutter."""

    def __init__(self, slots: Iterable[Floats], pairs: int = 0) -> None:
        """Store the weights `slots`, an array (N, lanes) for each sum; at least one sum. The first
        `pairs` of them are products of the weights of two buckets. A lane is
        the pixels of one distinct shutter."""
        self.slots, self.pairs = [*slots], pairs
        self._last: FrameWeights | None = None

    @property
    def lanes(self) -> int:
        """The number of lanes (the pixels of one distinct shutter each)."""
        return len(self.slots[0][0])

    def of_frames(self, light: Light) -> FrameWeights:
        """Return these weights of slots as weights of the frames of `light`. The last result is
        cached for lights of the same timing, unless it is large (`_MOST_KEPT`)."""
        last = self._last  # other threads may replace it
        if last is None or last.timing != light.timing:
            last = FrameWeights.of(light, self.slots)
            if last.weights.size <= _MOST_KEPT:
                self._last = last
        return last

    def batches(self, light: Light) -> Iterator[tuple[slice, FrameWeights]]:
        """Yield these weights, converted to frames of `light`, in batches of sums that fit into
        memory, at least one sum each: the slice of sums, and their weights."""
        room = max(1, _MOST_ENTRIES // max(1, len(light.frames) * self.lanes))
        if room >= len(self.slots):
            yield slice(0, len(self.slots)), self.of_frames(light)
            return
        for first in range(0, len(self.slots), room):
            batch = slice(first, min(first + room, len(self.slots)))
            yield batch, FrameWeights.of(light, self.slots[batch])


def light_sums(
    light: Light,
    lanes: Ints32,
    share: Floats32,
    weights: SlotWeights,
    smeared: int,
    fraction: float,
    threads: int = 1,
) -> Floats:
    """Return the sums (sums, pixels) of a light's slots, in electrons, each weighted by slot and
    lane (the pixels of one distinct shutter).

    `lanes` (pixels,): the lane of each pixel. `share` (pixels,): a factor on the light. Sums from
    number `smeared` on use light after crosstalk; `fraction` of a pixel's light moves to each
    neighbour. Results do not depend on `threads`. Raises ValueError for a lane without weights."""
    shape, count = light.shape, len(weights.slots)
    if isinstance(light.frames, DrawnFrames):
        cols = shape[1]
        strips = []
        for rows, first, strip in light.strips(1):
            inside = slice(first * cols, (first + strip.shape[0]) * cols)
            at = lanes[inside], share[inside]
            sums = light_sums(strip, *at, weights, smeared, fraction, threads)
            strips.append(sums[:, (rows.start - first) * cols :][:, : len(rows) * cols])
        return np.concatenate(strips, axis=1)
    # Seen as unsigned, a negative lane is a large number: one comparison finds both faults.
    if lanes.view(np.uint32).max(initial=0) >= weights.lanes:
        raise ValueError("a lane that the weights do not have")
    out = np.empty((count, *shape))
    frames = np.require(light.ended, np.float32, ["C", "A"])
    for batch, of_frames in weights.batches(light):
        arrays: NamedValues = {
            "frames": frames,
            "share": share.reshape(shape),
            "lanes": lanes.reshape(shape),
            "table": of_frames.weights,
            "lit_sums": of_frames.lit_sums,
            "alike": of_frames.alike,
            "out": out[batch],
        }
        sums, _, lane_count = of_frames.weights.shape
        sizes = {
            "rows": shape[0],
            "cols": shape[1],
            "count": len(frames),
            "sums": sums,
            "lane_count": lane_count,
            "fraction": fraction,
            "smeared": min(max(smeared - batch.start, 0), sums),
        }

        def run(
            begin: int, end: int, arrays: NamedValues = arrays, sizes: NamedValues = sizes
        ) -> None:
            """Add up the light of the rows from `begin` up to before `end` with the weights of
            their lanes. The defaults bind the arrays of this batch. A lane is the pixels of one
            distinct shutter."""
            lit = np.empty(FRAMES_TOGETHER * SUM_BLOCK, np.float32)
            gathered = np.empty(SUM_BLOCK)
            scene_sums(
                sizes=SceneSizes(begin=begin, end=end, **sizes),
                lit=lit,
                gathered=gathered,
                **arrays,
            )

        in_parts(run, shape[0], threads)
    return out.reshape(count, -1)


def drawn_at(light: Light, places: Ints) -> Light:
    """Return the light of the pixels at the ascending `places`, at least one, as a light with one
    row, in memory."""
    pieces = [np.asarray(own.frames) for _, own in light_at(light, places)]
    return replace(light, frames=np.concatenate(pieces, axis=2), motion=None)


def light_at(light: Light, places: Ints) -> Iterator[tuple[slice, Light]]:
    """Yield the light of the pixels at the ascending `places`, row * cols + col. Each result is a
    slice of `places` and the light of its pixels, with one row. The light is read in strips of
    rows, one slice for each strip with pixels; frames in memory are a single strip.

    The yielded lights have no `motion`. A caller that needs the light with motion passes
    `light.motion` instead of `light`."""
    for rows, first, strip in light.strips():
        begin, end = np.searchsorted(places, np.array([rows.start, rows.stop]) * light.shape[1])
        if begin < end:
            own = places[begin:end] - first * light.shape[1]
            frames = np.asarray(strip.frames).reshape(len(light.frames), -1).take(own, axis=1)
            yield slice(begin, end), replace(light, frames=frames[:, None], motion=None)
