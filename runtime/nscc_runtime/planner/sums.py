"""Weighted sums of a scene's frames, by the compiled loop."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light
from nscc_runtime.planner import sum_loop
from nscc_runtime.planner.sum_loop import DARK, EVEN, FEW, MIXED, SceneSizes, SumSizes
from nscc_runtime.pool import in_parts

_MOST_ENTRIES = 1 << 23
"""Of tables in memory at once, unless a single one is larger."""
MOST_KEPT = 1 << 21
"""Of tables that are kept from light to light."""


def weighted_sums(
    frames: NDArray[np.float32],
    lanes: NDArray[np.integer],
    tables: NDArray[np.float64],
    threads: int = 1,
) -> NDArray[np.float64]:
    """The sums (J, pixels) over k of tables[j, k, lane] * frames[k], in float64.

    `frames` (T, pixels), `lanes` (pixels,), `tables` (J, T, lanes). Threads change no bit.
    """
    count, pixels = frames.shape
    sums, _, lane_count = tables.shape
    if tables.shape[1] != count or lanes.shape != (pixels,):
        raise ValueError(f"frames {frames.shape}, lanes {lanes.shape}, tables {tables.shape}")
    if pixels and not (lanes.min() >= 0 and lanes.max() < lane_count):
        raise ValueError("a lane that the tables do not have")
    out = np.empty((sums, pixels))
    table, kinds = _laid_out(tables)
    frames = np.require(frames, np.float32, ["C", "A"])
    lanes_32 = np.require(lanes, np.int32, ["C", "A"])

    def run(begin: int, end: int) -> None:
        sum_loop.weighted_sums(
            sizes=SumSizes(
                pixels=pixels,
                begin=begin,
                end=end,
                count=count,
                lane_count=table.shape[2],
                sums=sums,
            ),
            frames=frames,
            lanes=lanes_32,
            table=table,
            kinds=kinds,
            out=out,
        )

    in_parts(run, pixels, threads, sum_loop.BLOCK)
    return out


@dataclass(frozen=True, eq=False)
class Tables:
    """Weights of frames as `nscc_runtime.planner.sum_loop.scene_sums` takes them."""

    table: NDArray[np.float64]
    kinds: NDArray[np.uint8]
    alike: NDArray[np.int64]

    @classmethod
    def of(cls, weights: NDArray[np.float64]) -> Tables:
        """Of weights (J, T, lanes)."""
        table, kinds = _laid_out(weights)
        return cls(table, kinds, _alike(table))


@dataclass(frozen=True, eq=False)
class OfFrames:
    """Weights (J, T, lanes) of the frames of all lights with one timing."""

    timing: Hashable
    weights: NDArray[np.float64]
    frame_weight: NDArray[np.float64]

    @classmethod
    def of(cls, light: Light, slots: Sequence[NDArray[np.float64]]) -> OfFrames:
        """Those of slots, of the frames of a light."""
        return cls(light.timing, frame_tables(light, slots), light.frame_weight)

    @cached_property
    def tables(self) -> Tables:
        """The same for the loop."""
        return Tables.of(self.weights)

    @cached_property
    def most_part(self) -> NDArray[np.float64]:
        """The most (lanes,) of a frame's light that any of them is."""
        found, whole = np.zeros(self.weights.shape), self.frame_weight[:, None]
        np.divide(self.weights, whole, out=found, where=whole > 0)
        return np.asarray(found.max(axis=(0, 1)))


class Weights:
    """Weights (N, lanes) of slots, to be those of frames; at least one.

    What they are for the frames of the last light is kept: those of a film fall in the same slots.
    """

    def __init__(self, slots: Iterable[NDArray[np.float64]]) -> None:
        self.slots = [*slots]
        self._last: OfFrames | None = None

    @property
    def lanes(self) -> int:
        """How many lanes they have."""
        return len(self.slots[0][0])

    def of_frames(self, light: Light) -> OfFrames:
        """Those of a light's frames."""
        last = self._last  # threads may make it anew
        if last is None or last.timing != light.timing:
            last = OfFrames.of(light, self.slots)
            if last.weights.size <= MOST_KEPT:
                self._last = last
        return last

    def tables(self, light: Light) -> Iterator[tuple[slice, Tables]]:
        """The same as the loop takes them: so many at once as memory has room for."""
        room = max(1, _MOST_ENTRIES // max(1, len(light.frames) * self.lanes))
        if room >= len(self.slots):
            yield slice(0, len(self.slots)), self.of_frames(light).tables
            return
        for first in range(0, len(self.slots), room):
            part = slice(first, min(first + room, len(self.slots)))
            yield part, Tables.of(frame_tables(light, self.slots[part]))


def scene_sums(
    light: Light,
    lanes: NDArray[np.int32],
    scale: tuple[NDArray[np.float64], NDArray[np.float32]],
    weights: Weights,
    smeared: int,
    fraction: float,
    threads: int = 1,
) -> NDArray[np.float64]:
    """The sums (of each of the weights, pixels) of a light's slots, each weighted by slot and lane.

    `lanes` and `scale`, a factor on the light, also in float32, are (pixels,). Those from number
    `smeared` on weigh what is there after `fraction` of each pixel's light has gone to each of its
    neighbours. Threads change no bit.
    """
    shape, count = light.shape, len(weights.slots)
    if lanes.view(np.uint32).max(initial=0) >= weights.lanes:
        raise ValueError("a lane that the weights do not have")
    out = np.empty((count, *shape))
    frames = np.require(light.ended, np.float32, ["C", "A"])
    for part, tables in weights.tables(light):
        arrays: dict[str, Any] = {
            "frames": frames,
            "scale": np.require(scale[0].reshape(shape), np.float64, ["C", "A"]),
            "lanes": np.require(lanes.reshape(shape), np.int32, ["C", "A"]),
            "share": scale[1],
            "table": tables.table,
            "kinds": tables.kinds,
            "alike": tables.alike,
            "out": out[part],
        }
        sums, _, lane_count = tables.table.shape
        sizes = {
            "rows": shape[0], "cols": shape[1], "count": len(frames), "sums": sums,
            "lane_count": lane_count, "fraction": fraction,
            "smeared": min(max(smeared - part.start, 0), sums),
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


def sums_by_slot(
    light: Light,
    frames: NDArray[np.float32],
    lanes: NDArray[np.integer],
    weights: Sequence[NDArray[np.float64]],
    threads: int = 1,
) -> NDArray[np.float64]:
    """The sums (len(weights), pixels) of a light's slots, each weighted by slot and lane.

    `frames` (T, pixels) are the light's frames at the pixels that are asked for, or what takes
    their place; each of `weights` is (N, lanes of the program).
    """
    found = np.empty((len(weights), frames.shape[1]))
    if len(weights):
        lane_count = weights[0].shape[1]
        used = np.flatnonzero(np.bincount(lanes, minlength=lane_count))
        if 2 * len(used) < lane_count == len(np.bincount(lanes, minlength=lane_count)):
            weights = [np.ascontiguousarray(each[:, used]) for each in weights]
            lanes = np.searchsorted(used, lanes).astype(np.int32)
    room = max(1, _MOST_ENTRIES // max(1, len(frames) * (weights[0].shape[1] if weights else 1)))
    for first in range(0, len(weights), room):
        part = weights[first : first + room]
        found[first : first + room] = weighted_sums(
            frames, lanes, frame_tables(light, part), threads
        )
    return found


def frame_tables(light: Light, weights: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Weights (N, lanes) of slots as tables (len(weights), T, lanes) of a light's frames."""
    if not light.in_order:
        tables = on_frames(light, np.stack(weights, axis=1))
        return np.ascontiguousarray(tables.swapaxes(0, 1))
    tables = np.empty((len(weights), *weights[0].shape))
    for table, each in zip(tables, weights, strict=True):
        np.multiply(light.weight[:, None], each, out=table)
    return tables


def _laid_out(tables: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
    """Tables (J, T, lanes) as the loops take them, and the kinds of each frame's weights."""
    even = (tables == tables[:, :, :1]).all(axis=2)
    kinds = np.where(even, np.where(tables[:, :, 0] == 0.0, DARK, EVEN), MIXED).astype(np.uint8)
    lacking = max(0, FEW - tables.shape[2])
    if lacking:
        tables = np.pad(tables, ((0, 0), (0, 0), (0, lacking)))
    return np.require(tables, np.float64, ["C", "A"]), kinds


def _alike(table: NDArray[np.float64]) -> NDArray[np.int64]:
    """With how many after it each frame has all weights of tables (J, T, lanes) in common, itself
    included."""
    count = table.shape[1]
    other = (table[:, 1:] != table[:, :-1]).any(axis=(0, 2))
    ends = np.append(np.flatnonzero(other) + 1, count)
    each = np.arange(count)
    return np.asarray(ends[np.searchsorted(ends, each, side="right")] - each, np.int64)


def on_frames(light: Light, slots: NDArray[np.float64]) -> NDArray[np.float64]:
    """Weights of slots (N, ..) as weights of the light's own frames (T, ..)."""
    flat = slots.reshape(len(slots), -1)
    return light.on_frames(flat).reshape(len(light.frames), *slots.shape[1:])
