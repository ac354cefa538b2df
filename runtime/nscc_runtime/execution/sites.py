"""The light of pixels that run through their words and of their neighbours, shared by all frames of
a scene on a chip."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.execution.charge_loop import Sites
from nscc_runtime.execution.layout import Numbers, OnDevice
from nscc_runtime.execution.overlap import NEIGHBOURS
from nscc_runtime.execution.site_loop import Laying, lay_out
from nscc_runtime.light import Light
from nscc_runtime.pool import in_parts

_FEWEST = 256
"""Smallest number of sites per thread."""
_SPARSE = 64
"""If fewer than one pixel in this number is chosen, a list is faster than a mask."""
_MOST_KEPT = 1 << 21
"""Largest table of the slots of all lanes that is cached for other scenes."""


def needed_places(
    chosen: NDArray[np.int64], shape: tuple[int, int], beside: bool
) -> NDArray[np.int64]:
    """Return the distinct `chosen` places (row * cols + col) in ascending order; with `beside`,
    also the places of their neighbours."""
    if beside and len(chosen) * _SPARSE < shape[0] * shape[1]:
        row, col = np.divmod(chosen, shape[1])
        rows = np.clip(np.stack([row, row - 1, row + 1, row, row]), 0, shape[0] - 1)
        cols = np.clip(np.stack([col, col, col, col - 1, col + 1]), 0, shape[1] - 1)
        return np.unique(rows * shape[1] + cols)
    inside = np.zeros(shape, np.bool_)
    inside.reshape(-1)[chosen] = True
    is_needed = inside.copy()
    if beside:
        for pixels, neighbours in NEIGHBOURS:
            is_needed[pixels] |= inside[neighbours]
    return np.flatnonzero(is_needed)


@dataclass(frozen=True, eq=False)
class Times:
    """The slots of lanes. `of_slot` (lanes, N): the group of each slot. `groups`: number of groups.
    `slot_s` (N,): slot lengths in seconds."""

    of_slot: NDArray[np.int32]
    groups: int
    slot_s: NDArray[np.float64]

    @cached_property
    def all_tables(self) -> tuple[NDArray[np.float64], NDArray[np.int64]] | None:
        """The result of `tables` for all lanes; None if it is too large to be cached."""
        lanes, slots = self.of_slot.shape
        if 2 * lanes * self.groups * (slots + 1) > _MOST_KEPT:
            return None
        return self.tables(np.arange(lanes))

    def tables(self, used: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Return cumulative sums over the slots of each group, and where the sums of each lane
        begin.

        The sums (rows, groups, N + 1) are numbers of slots for the `used` lanes, then seconds. The
        starts (lanes, 2) are indices into the flattened sums."""
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
    """Return the sites at `places`, of a chip whose pixels have these `lanes` (rows, cols).
    `switches`: the fields of `Laying` that effects set."""
    count, even, groups = len(places), light.even, times.groups
    row = groups * (light.slots + 1)
    tables = times.all_tables
    if tables is None:
        tables = times.tables(np.unique(lanes.reshape(-1)[places]))
    sums, of_lane = tables
    if not even:
        # Each site has its own light; lanes only provide seconds.
        seconds = sums[len(sums) // 2 :] if switches["counts_dark"] else sums[:0]
        site_sums = np.empty((count + len(seconds), groups, light.slots + 1))
        site_sums[count:] = seconds
        of_lane = of_lane + (count - len(sums) // 2) * row
        sums = site_sums
    sites = Sites(
        np.empty(lanes.shape, np.int32), np.empty((count, 2), np.int64), np.empty((count, 2)), sums
    )
    arrays: dict[str, Any] = {
        "places": places, "lanes": lanes, "of_slot": times.of_slot,
        "light": light.matrix, "of_lane": of_lane, "sites": sites,
    }  # fmt: skip
    laying_sizes: dict[str, Any] = {
        "pixels": lanes.size, "slots": light.slots, "groups": groups, "even": even, **switches
    }  # fmt: skip

    def fill(begin: int, end: int) -> None:
        laying = Laying(begin=begin, end=end, **laying_sizes)
        lay_out(laying=laying, numbers=numbers, device=device, **arrays)

    in_parts(fill, count, threads, _FEWEST)
    return sites
