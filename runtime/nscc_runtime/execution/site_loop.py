"""The light of pixels that run through their words and of their neighbours, shared by all frames of
a scene on a chip."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.spread import log_normal_in_loop
from nscc_runtime.execution.charge_loop import DARK, LIT, Sites
from nscc_runtime.execution.layout import Numbers, OnDevice
from nscc_runtime.execution.overlap import NEIGHBOURS
from nscc_runtime.light import Light
from nscc_runtime.loop import (
    Floats,
    Ints,
    Ints32,
    compiled,
    loop,
    record,
)
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.noise_loops import uniform
from nscc_runtime.pool import in_parts
from nscc_runtime.sizes_loop import LightMatrix

_TOGETHER = 16
"""Number of sites that are processed together: adjacent sites share a cache line of each frame."""


@record
class Laying:
    """The range of sites `begin` to `end` - 1 to prepare, sizes, and three switches (0: off)."""

    begin: int
    end: int
    pixels: int
    slots: int
    groups: int
    even: int
    """Whether all slots have the same light."""
    uneven: int
    """Whether pixels differ in their response. `counts_dark`: whether to count dark electrons."""
    counts_dark: int


@compiled
def _rate(numbers: Numbers, total: float, response: float) -> float:
    """Return the rate of a slot with light `total`, rounded to float32."""
    rate = float(np.float32(total))
    rate = (rate + numbers.echo * rate) * response
    rate = rate if rate > 0.0 else 0.0
    return rate if rate < numbers.rate_cap else numbers.rate_cap


@compiled
def _light(light: LightMatrix, n: int, pixels: int, place: int) -> float:
    """Return the light of slot n at a place, in electrons."""
    total = 0.0
    for k in range(light.row_start[n], light.row_start[n + 1]):
        total += float(light.frames[light.frame_index[k] * pixels + place]) * light.weight[k]
    return total


@compiled
def _draw(laying: Laying, key: np.uint64, places: Ints, at: int, scales: Floats) -> None:
    """Set scales[i, at] to the normal number of places[i], in a loop that LLVM vectorises."""
    for i in range(laying.begin, laying.end):
        scales[2 * i + at] = normal(uniform(key, places[i]))


@loop
def lay_out(
    laying: Laying,
    numbers: Numbers,
    device: OnDevice,
    places: Annotated[Ints, "sites"],
    lanes: Annotated[Ints32, "rows cols"],
    light: LightMatrix,
    of_slot: Annotated[Ints32, "lanes slots"],
    of_lane: Annotated[Ints, "lanes 2"],
    sites: Sites,
) -> None:
    """Prepare the sites at `places`: fill `number`, `rows`, `scales` and `sums` of `sites`.

    If all slots have the same light (`laying.even`), the scale of a site is the light of a slot,
    and its sums are those of its lane. Otherwise each site has its own sums of light, shape (sites,
    groups, N + 1) at the beginning of `sums`, and scale 1. `of_lane`: where the sums of each lane
    begin. `of_slot`: the group of each slot."""
    pixels, slots, count = laying.pixels, laying.slots, laying.groups
    number, rows, scales, sums = sites.number, sites.rows, sites.scales, sites.sums
    for i in range(laying.begin, laying.end):
        place = places[i]
        lane = lanes[place]
        number[place] = i
        rows[2 * i + LIT] = of_lane[2 * lane + LIT] if laying.even else i * count * (slots + 1)
        rows[2 * i + DARK] = of_lane[2 * lane + DARK]
        scales[2 * i + LIT], scales[2 * i + DARK] = 1.0, 0.0
    if laying.uneven:
        _draw(laying, device.uneven, places, LIT, scales)
        for i in range(laying.begin, laying.end):
            response = 1.0 + numbers.uneven * scales[2 * i + LIT]
            scales[2 * i + LIT] = response if response > 0.0 else 0.0
    if laying.even:
        for i in range(laying.begin, laying.end):
            total = _light(light, 0, pixels, places[i])
            scales[2 * i + LIT] = _rate(numbers, total, scales[2 * i + LIT])
    if laying.counts_dark:
        _draw(laying, device.dark, places, DARK, scales)
        for i in range(laying.begin, laying.end):
            z = scales[2 * i + DARK]
            scales[2 * i + DARK] = numbers.dark * log_normal_in_loop(numbers.dark_variance, z)
    for first in range(laying.begin, laying.begin if laying.even else laying.end, _TOGETHER):
        stop = min(first + _TOGETHER, laying.end)
        for n in range(slots):
            for i in range(first, stop):
                place = places[i]
                total = _light(light, n, pixels, place)
                rate = _rate(numbers, total, scales[2 * i + LIT])
                mine = of_slot[lanes[place] * slots + n]
                for group in range(count):
                    at = (i * count + group) * (slots + 1) + n
                    if n == 0:
                        sums[at] = 0.0
                    sums[at + 1] = sums[at] + rate if group == mine else sums[at]
        for i in range(first, stop):
            scales[2 * i + LIT] = 1.0


_FEWEST = 256
"""Smallest number of sites per thread."""
_MOST_KEPT = 1 << 21
"""Largest table of the slots of all lanes that is cached for other scenes."""


def needed_places(
    chosen: NDArray[np.int64], shape: tuple[int, int], beside: bool
) -> NDArray[np.int64]:
    """Return the distinct `chosen` places (row * cols + col) in ascending order; with `beside`,
    also the places of their neighbours."""
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
