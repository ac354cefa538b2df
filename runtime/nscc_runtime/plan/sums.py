"""Weighted sums of a scene's frames, by the compiled loop."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.light import Light

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
    from nscc_runtime.plan.compiled import entry_points

    count, pixels = frames.shape
    sums, _, lane_count = tables.shape
    if tables.shape[1] != count or lanes.shape != (pixels,):
        raise ValueError(f"frames {frames.shape}, lanes {lanes.shape}, tables {tables.shape}")
    if pixels and not (lanes.min() >= 0 and lanes.max() < lane_count):
        raise ValueError("a lane that the tables do not have")
    out = np.empty((sums, pixels))
    arrays = (
        np.require(frames, np.float32, ["C", "A"]),
        np.require(lanes, np.int32, ["C", "A"]),
        np.require(tables, np.float64, ["C", "A"]),
        out,
    )
    loop = entry_points()["weighted_sums"]

    def run(begin: int, end: int) -> None:
        sizes = np.array([pixels, begin, end, count, lane_count, sums], np.int64)
        loop(sizes.ctypes.data, *(array.ctypes.data for array in arrays))

    cuts = [pixels * i // threads for i in range(threads + 1)]
    if threads == 1:
        run(0, pixels)
    else:
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(run, cuts[:-1], cuts[1:]))
    return out


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
    room = max(1, _MOST_ENTRIES // max(1, len(frames) * (weights[0].shape[1] if weights else 1)))
    for first in range(0, len(weights), room):
        part = weights[first : first + room]
        tables = np.stack([on_frames(light, each) for each in part])
        found[first : first + room] = weighted_sums(frames, lanes, tables, threads)
    return found


def on_frames(light: Light, slots: NDArray[np.float64]) -> NDArray[np.float64]:
    """NDArray[np.float64] of slots (N, ..) as weights of the light's own frames (T, ..)."""
    from scipy.sparse import csr_array

    matrix = csr_array(
        (light.weight, light.frame_index, light.row_start), (light.slots, len(light.frames))
    )
    flat = slots.reshape(len(slots), -1)
    return np.asarray(matrix.T @ flat).reshape(len(light.frames), *slots.shape[1:])
