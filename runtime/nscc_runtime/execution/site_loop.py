"""The loop that prepares the light of sites (pixels and their neighbours) for `charge_loop`, once
for all frames."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc_runtime.effects.spread import log_normal_in_loop
from nscc_runtime.execution.charge_loop import DARK, LIT, Sites
from nscc_runtime.execution.layout import Numbers, OnDevice
from nscc_runtime.light_matrix import LightMatrix
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
