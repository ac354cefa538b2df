"""Weighted sums of a scene's frames of light, by the compiled loop."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.execution import sum_loop
from nscc_runtime.execution.sum_loop import SceneSizes
from nscc_runtime.light import Light
from nscc_runtime.pool import in_parts

_MOST_ENTRIES = 1 << 23
"""Largest number of table entries in memory, unless a single table is larger."""
_MOST_KEPT = 1 << 21
"""Largest number of table entries that are cached for the next light."""


@dataclass(frozen=True, eq=False)
class FrameWeights:
    """Weights (sums, frames, lanes) of frames of light for
    `nscc_runtime.execution.sum_loop.scene_sums`, for all lights with the same timing.
    `frame_weight` (frames,): total weight of each frame."""

    timing: Hashable
    weights: NDArray[np.float64]
    frame_weight: NDArray[np.float64]

    @classmethod
    def of(cls, light: Light, slots: Sequence[NDArray[np.float64]]) -> FrameWeights:
        """Convert weights (N, lanes) of slots to weights of the frames of a light."""
        flat = np.stack(slots, axis=1).reshape(len(slots[0]), -1)
        by_frame = light.on_frames(flat).reshape(-1, len(slots), slots[0].shape[1])
        return cls(light.timing, np.ascontiguousarray(by_frame.swapaxes(0, 1)), light.frame_weight)

    @cached_property
    def lit_sums(self) -> NDArray[np.uint8]:
        """Mask (sums, frames): whether any lane has a nonzero weight of a frame."""
        return np.asarray(self.weights.any(axis=2), np.uint8)

    @cached_property
    def alike(self) -> NDArray[np.int64]:
        """The number of frames with equal weights in a row from each frame on, shape (frames,)."""
        count = self.weights.shape[1]
        differs = (self.weights[:, 1:] != self.weights[:, :-1]).any(axis=(0, 2))
        ends = np.append(np.flatnonzero(differs) + 1, count)
        frame = np.arange(count)
        return np.asarray(ends[np.searchsorted(ends, frame, side="right")] - frame, np.int64)

    @cached_property
    def most_part(self) -> NDArray[np.float64]:
        """Largest weight (lanes,) of a frame, as a fraction of the frame's total weight."""
        fractions, frame_weight = np.zeros(self.weights.shape), self.frame_weight[:, None]
        np.divide(self.weights, frame_weight, out=fractions, where=frame_weight > 0)
        return np.asarray(fractions.max(axis=(0, 1)))


class SlotWeights:
    """One or more weights (N, lanes) of slots. The weights of the last light's frames are cached,
    because series of frames have the same timing."""

    def __init__(self, slots: Iterable[NDArray[np.float64]]) -> None:
        self.slots = [*slots]
        self._last: FrameWeights | None = None

    @property
    def lanes(self) -> int:
        return len(self.slots[0][0])

    def of_frames(self, light: Light) -> FrameWeights:
        """Return these weights converted to weights of the frames of `light`."""
        last = self._last  # other threads may replace it
        if last is None or last.timing != light.timing:
            last = FrameWeights.of(light, self.slots)
            if last.weights.size <= _MOST_KEPT:
                self._last = last
        return last

    def batches(self, light: Light) -> Iterator[tuple[slice, FrameWeights]]:
        """Yield these weights, converted to frames of `light`, in batches that fit into memory,
        each with its slice of the weights."""
        room = max(1, _MOST_ENTRIES // max(1, len(light.frames) * self.lanes))
        if room >= len(self.slots):
            yield slice(0, len(self.slots)), self.of_frames(light)
            return
        for first in range(0, len(self.slots), room):
            batch = slice(first, min(first + room, len(self.slots)))
            yield batch, FrameWeights.of(light, self.slots[batch])


def scene_sums(
    light: Light,
    lanes: NDArray[np.int32],
    scale: tuple[NDArray[np.float64], NDArray[np.float32]],
    weights: SlotWeights,
    smeared: int,
    fraction: float,
    threads: int = 1,
) -> NDArray[np.float64]:
    """Return the sums (weights, pixels) of a light's slots, each weighted by slot and lane.

    `lanes` (pixels,): the lane of each pixel. `scale`: a factor (pixels,) on the light, in float64
    and in float32. Sums from number `smeared` on use light after crosstalk; `fraction` of a pixel's
    light moves to each neighbour. Results do not depend on `threads`. Raises ValueError for a lane
    without weights."""
    shape, count = light.shape, len(weights.slots)
    if lanes.view(np.uint32).max(initial=0) >= weights.lanes:
        raise ValueError("a lane that the weights do not have")
    out = np.empty((count, *shape))
    frames = np.require(light.ended, np.float32, ["C", "A"])
    for batch, of_frames in weights.batches(light):
        arrays: dict[str, Any] = {
            "frames": frames,
            "scale": np.require(scale[0].reshape(shape), np.float64, ["C", "A"]),
            "lanes": np.require(lanes.reshape(shape), np.int32, ["C", "A"]),
            "share": scale[1],
            "table": of_frames.weights,
            "lit_sums": of_frames.lit_sums,
            "alike": of_frames.alike,
            "out": out[batch],
        }
        sums, _, lane_count = of_frames.weights.shape
        sizes = {
            "rows": shape[0], "cols": shape[1], "count": len(frames), "sums": sums,
            "lane_count": lane_count, "fraction": fraction,
            "smeared": min(max(smeared - batch.start, 0), sums),
        }  # fmt: skip

        def run(
            begin: int, end: int, arrays: dict[str, Any] = arrays, sizes: dict[str, Any] = sizes
        ) -> None:
            lit = np.empty(sum_loop.TOGETHER * sum_loop.BLOCK, np.float32)
            gathered = np.empty(sum_loop.BLOCK)
            sum_loop.scene_sums(
                sizes=SceneSizes(begin=begin, end=end, **sizes), lit=lit, gathered=gathered,
                **arrays,
            )  # fmt: skip

        in_parts(run, shape[0], threads)
    return out.reshape(count, -1)
