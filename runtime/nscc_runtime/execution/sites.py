"""The light of pixels that run through their words, and of those beside them: what frames of one
scene on one chip have in common."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.execution.charge_loop import Sites
from nscc_runtime.execution.layout import Numbers, OnDevice
from nscc_runtime.execution.site_loop import Laying, lay_out
from nscc_runtime.light import Light
from nscc_runtime.pool import in_parts

_FEWEST = 256
"""Sites that are worth a thread."""
_SPARSE = 64
"""Of every so many pixels at most one is chosen: a list is faster than an array of all."""
_MOST_KEPT = 1 << 21
"""Numbers of the slots of all lanes that are kept from scene to scene."""


def needed(chosen: NDArray[np.int64], shape: tuple[int, int], beside: bool) -> NDArray[np.int64]:
    """Places of an array, row * cols + col, in order, each once; with those `beside` them."""
    if beside and len(chosen) * _SPARSE < shape[0] * shape[1]:
        row, col = np.divmod(chosen, shape[1])
        rows = np.clip(np.stack([row, row - 1, row + 1, row, row]), 0, shape[0] - 1)
        cols = np.clip(np.stack([col, col, col, col - 1, col + 1]), 0, shape[1] - 1)
        return np.unique(rows * shape[1] + cols)
    inside = np.zeros(shape, np.bool_)
    inside.reshape(-1)[chosen] = True
    found = inside.copy()
    if beside:
        found[1:] |= inside[:-1]
        found[:-1] |= inside[1:]
        found[:, 1:] |= inside[:, :-1]
        found[:, :-1] |= inside[:, 1:]
    return np.flatnonzero(found)


@dataclass(frozen=True, eq=False)
class Times:
    """Slots of lanes as sites have them: `of_slot` int32 (lanes, N), the group of each slot, of
    `groups`; `slot_s` (N,) their lengths."""

    of_slot: NDArray[np.int32]
    groups: int
    slot_s: NDArray[np.float64]

    @cached_property
    def every(self) -> tuple[NDArray[np.float64], NDArray[np.int64]] | None:
        """See `tables`, of all lanes; None: too large to be kept."""
        lanes, slots = self.of_slot.shape
        if 2 * lanes * self.groups * (slots + 1) > _MOST_KEPT:
            return None
        return self.tables(np.arange(lanes))

    def tables(self, used: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Sums (rows, groups, N + 1) over the slots of each group: of 1, for each of the lanes that
        are `used`, then of seconds; and where (lanes, 2) those of each lane begin."""
        lanes, slots = self.of_slot.shape
        apart = self.of_slot[used, None, :] == np.arange(self.groups)[:, None]
        sums = np.zeros((2, len(used), self.groups, slots + 1))
        np.cumsum(apart, axis=2, out=sums[0, :, :, 1:])
        np.cumsum(apart * self.slot_s, axis=2, out=sums[1, :, :, 1:])
        number = np.zeros((lanes, 2), np.int64)
        number[used, 0] = np.arange(len(used))
        number[used, 1] = len(used) + number[used, 0]
        return sums.reshape(-1, self.groups, slots + 1), number * (self.groups * (slots + 1))


def sites_of(
    light: Light,
    places: NDArray[np.int64],
    lanes: NDArray[np.int32],
    times: Times,
    numbers: Numbers,
    device: OnDevice,
    switches: dict[str, int],
    threads: int,
) -> Sites:
    """The sites at `places`, of pixels with these `lanes` (rows, cols). `switches` are those of
    `Laying` that effects have.
    """
    count, even, groups = len(places), light.even, times.groups
    row = groups * (light.slots + 1)
    kept = times.every
    if kept is None:
        kept = times.tables(np.unique(lanes.reshape(-1)[places]))
    sums, of_lane = kept
    if not even:
        # Each site has its own light; of lanes only seconds are left.
        seconds = sums[len(sums) // 2 :] if switches["counts_dark"] else sums[:0]
        own = np.empty((count + len(seconds), groups, light.slots + 1))
        own[count:] = seconds
        of_lane = of_lane + (count - len(sums) // 2) * row
        sums = own
    found = Sites(
        np.empty(lanes.shape, np.int32), np.empty((count, 2), np.int64), np.empty((count, 2)), sums
    )
    arrays: dict[str, Any] = {
        "places": places, "lanes": lanes, "of_slot": times.of_slot,
        "frames": np.require(light.frames, np.float32, ["C", "A"]).reshape(len(light.frames), -1),
        "row_start": np.require(light.row_start, np.int64, ["C", "A"]),
        "frame_index": np.require(light.frame_index, np.int32, ["C", "A"]),
        "weight": np.require(light.weight, np.float64, ["C", "A"]), "of_lane": of_lane,
        "sites": found,
    }  # fmt: skip
    given: dict[str, Any] = {
        "pixels": lanes.size, "slots": light.slots, "groups": groups, "even": even, **switches
    }  # fmt: skip

    def fill(begin: int, end: int) -> None:
        laying = Laying(begin=begin, end=end, **given)
        lay_out(laying=laying, numbers=numbers, device=device, **arrays)

    in_parts(fill, count, threads, _FEWEST)
    return found
