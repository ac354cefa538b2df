"""Weighted sums of a scene's frames, by the compiled loop."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light
from nscc_runtime.loop import Bound
from nscc_runtime.planner import sum_loop
from nscc_runtime.planner.sum_loop import DARK, EVEN, FEW, MIXED, SceneSizes, SumSizes
from nscc_runtime.pool import in_parts

_MOST_ENTRIES = 1 << 23
"""Of tables in memory at once, unless a single one is larger."""


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
    bound = sum_loop.weighted_sums.bound(
        frames=np.require(frames, np.float32, ["C", "A"]),
        lanes=np.require(lanes, np.int32, ["C", "A"]),
        table=table,
        kinds=kinds,
        out=out,
    )

    def run(begin: int, end: int) -> None:
        bound(
            sizes=SumSizes(
                pixels=pixels,
                begin=begin,
                end=end,
                count=count,
                lane_count=table.shape[2],
                sums=sums,
            )
        )

    in_parts(run, pixels, threads, sum_loop.BLOCK)
    return out


def scene_sums(
    light: Light,
    lanes: NDArray[np.int32],
    scale: NDArray[np.float64],
    plain: Sequence[NDArray[np.float64]],
    smeared: Sequence[NDArray[np.float64]],
    fraction: float,
    threads: int = 1,
) -> NDArray[np.float64]:
    """The sums (plain and smeared, pixels) of a light's slots, each weighted by slot and lane; at
    least one.

    `lanes` and `scale`, a factor on the light, are (pixels,); weights are (N, lanes of the
    program). The smeared ones weigh what is there after `fraction` of each pixel's light has gone
    to each of its neighbours. Threads change no bit.
    """
    weights = [*plain, *smeared]
    shape = light.shape
    lane_count = weights[0].shape[1]
    if not (lanes.min(initial=0) >= 0 and lanes.max(initial=0) < lane_count):
        raise ValueError("a lane that the weights do not have")
    out = np.empty((len(weights), *shape))
    room = max(1, _MOST_ENTRIES // max(1, len(light.frames) * lane_count))
    frames = np.require(light.ended, np.float32, ["C", "A"])
    share = scale.astype(np.float32) if len(smeared) else np.ones(1, np.float32)
    for first in range(0, len(weights), room):
        table, kinds = _laid_out(_tables(light, weights[first : first + room]))
        bound = sum_loop.scene_sums.bound(
            frames=frames,
            scale=np.require(scale.reshape(shape), np.float64, ["C", "A"]),
            lanes=np.require(lanes.reshape(shape), np.int32, ["C", "A"]),
            share=share,
            table=table,
            kinds=kinds,
            alike=_alike(table),
            out=out[first : first + room],
        )
        sizes = {
            "rows": shape[0], "cols": shape[1], "count": len(frames), "sums": len(table),
            "lane_count": table.shape[2], "fraction": fraction,
            "smeared": min(max(len(plain) - first, 0), len(table)),
        }  # fmt: skip

        def run(begin: int, end: int, bound: Bound = bound, sizes: dict[str, Any] = sizes) -> None:
            lit = np.empty(sum_loop.TOGETHER * sum_loop.BLOCK, np.float32)
            gathered = np.empty(sum_loop.BLOCK)
            bound(sizes=SceneSizes(begin=begin, end=end, **sizes), lit=lit, gathered=gathered)

        in_parts(run, shape[0], threads)
    return out.reshape(len(weights), -1)


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
        found[first : first + room] = weighted_sums(frames, lanes, _tables(light, part), threads)
    return found


def _tables(light: Light, weights: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
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
