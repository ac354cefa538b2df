"""The loop for plans without slot loops under which a pixel's open slots have one weight: light is
added up, counted, made noisy, clipped and read out while it is in the cache.

`nscc_runtime.planner.fused` makes what it is given.
"""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc_runtime.loop import (
    Bytes,
    Floats,
    Floats32,
    Ints,
    Ints32,
    Words,
    Written,
    compiled,
    inlined,
    loop,
    record,
)
from nscc_runtime.planner.drawn import BLOCK, counted, drawn_normals, read_out
from nscc_runtime.planner.masks import Masks

_EXACT_SLOTS = 8
"""Frames added up in float32 before float64 takes over: an error of 4e-7 at most."""

_LARGE = 1e30
"""Sums from here on are made once more, in float64."""

SKIPPED, EVEN, MASKED, TABLED = Masks.SKIPPED, Masks.EVEN, Masks.MASKED, Masks.TABLED


@compiled
def _added(
    frames: Floats32, pixels: int, k: int, kind: int, frame_weight: Floats32, mask_row: Ints,
    masks: Bytes, table: Floats32, lane_count: int, lanes: Ints32, first: int, stop: int,
    part: Floats32,
) -> None:  # fmt: skip
    """part[i] += a frame's light at pixel first + i."""
    row, weight, mask = k * pixels, frame_weight[k], mask_row[k] * pixels
    if kind == EVEN:
        for p in range(first, stop):
            part[p - first] += weight * frames[row + p]
    elif kind == MASKED:
        for p in range(first, stop):
            part[p - first] += weight * frames[row + p] * np.float32(masks[mask + p])
    else:
        for p in range(first, stop):
            part[p - first] += frames[row + p] * table[k * lane_count + lanes[p]]


@compiled
def _added_four(
    frames: Floats32, pixels: int, k: int, kind: int, frame_weight: Floats32, mask_row: Ints,
    masks: Bytes, first: int, stop: int, part: Floats32,
) -> None:  # fmt: skip
    """The same of four frames of one kind and weight, for one time through `part`."""
    weight = frame_weight[k]
    a, b, c, d = k * pixels, (k + 1) * pixels, (k + 2) * pixels, (k + 3) * pixels
    if kind == EVEN:
        for p in range(first, stop):
            four = (frames[a + p] + frames[b + p]) + (frames[c + p] + frames[d + p])
            part[p - first] += weight * four
        return
    e, f = mask_row[k] * pixels, mask_row[k + 1] * pixels
    g, h = mask_row[k + 2] * pixels, mask_row[k + 3] * pixels
    for p in range(first, stop):
        two = frames[a + p] * np.float32(masks[e + p]) + frames[b + p] * np.float32(masks[f + p])
        four = frames[c + p] * np.float32(masks[g + p]) + frames[d + p] * np.float32(masks[h + p])
        part[p - first] += weight * (two + four)


@compiled
def _alike(kinds: Ints, frame_weight: Floats32, k: int, count: int) -> bool:
    """Whether four frames from k on are even or masked alike, with one weight."""
    if k + 4 > count or (kinds[k] != EVEN and kinds[k] != MASKED):
        return False
    for other in range(k + 1, k + 4):
        if kinds[other] != kinds[k] or frame_weight[other] != frame_weight[k]:
            return False
    return True


@compiled
def _summed(
    frames: Floats32, pixels: int, count: int, kinds: Ints, frame_weight: Floats32, mask_row: Ints,
    masks: Bytes, table: Floats32, lane_count: int, lanes: Ints32, p: int,
) -> float:  # fmt: skip
    """The light of one pixel in float64: what float32 has no room for."""
    total = 0.0
    for k in range(count):
        light, weight = float(frames[k * pixels + p]), float(frame_weight[k])
        if kinds[k] == EVEN:
            total += weight * light
        elif kinds[k] == MASKED:
            total += weight * light * masks[mask_row[k] * pixels + p]
        elif kinds[k] == TABLED:
            total += light * float(table[k * lane_count + lanes[p]])
    return total


@compiled
def _noisy(
    stream: np.uint64, sigma: Floats, row: int, lanes: Ints32, first: int, stop: int,
    values: Floats, scratch: Floats,
) -> None:  # fmt: skip
    """values[i] += a normal number times the lane's sigma."""
    drawn_normals(stream, first, stop - first, scratch)
    for i in range(stop - first):
        values[i] += sigma[row + lanes[first + i]] * scratch[i]


@record
class Simple:
    """What a simple plan does to one bucket of one frame.

    Of all `pixels` those from `begin` to `end` - 1 are to be done; `sources` are those of noise.
    Numbers in codes are `offset`, `top` (the highest code) and `readout_noise`.
    """

    pixels: int
    begin: int
    end: int
    count: int
    lane_count: int
    sources: int
    uneven: int
    """Whether the response is given; so on with the switches below."""
    counted: int
    clipped: int
    patterned: int
    readout_noisy: int
    read_out: int
    well_bit: int
    """What marks pixels that are clipped: those above `full` times their limit."""
    full: float
    factor: float
    """Of all light."""
    rate_cap: float
    electrons_per_code: float
    offset: float
    top: float
    readout_noise: float
    count_key: np.uint64
    readout_key: np.uint64


@inlined
def _lit(
    plan: Simple, frames: Floats32, kinds: Ints, frame_weight: Floats32, mask_row: Ints,
    masks: Bytes, table: Floats32, lanes: Ints32, first: int, stop: int, part: Floats32,
    values: Floats, valid: Bytes,
) -> None:  # fmt: skip
    """values[i] := the light of pixel first + i, `valid` 0 where that is no number."""
    pixels, count, lane_count = plan.pixels, plan.count, plan.lane_count
    for i in range(stop - first):
        values[i] = 0.0
        part[i] = np.float32(0.0)
    added, k = 0, 0
    while k < count:
        if kinds[k] == SKIPPED:
            k += 1
            continue
        if _alike(kinds, frame_weight, k, count):
            _added_four(
                frames, pixels, k, kinds[k], frame_weight, mask_row, masks, first, stop, part
            )
            added += 4
            k += 4
        else:
            _added(
                frames, pixels, k, kinds[k], frame_weight, mask_row, masks, table, lane_count,
                lanes, first, stop, part,
            )  # fmt: skip
            added += 1
            k += 1
        if added >= _EXACT_SLOTS:
            for i in range(stop - first):
                values[i] += float(part[i])
                part[i] = np.float32(0.0)
            added = 0
    large = 0
    for i in range(stop - first):
        values[i] += float(part[i])
        large += not values[i] < _LARGE
    if large:
        for i in range(stop - first):
            if not values[i] < _LARGE:
                valid[first + i] = values[i] == values[i]
                values[i] = _summed(
                    frames, pixels, count, kinds, frame_weight, mask_row, masks, table,
                    lane_count, lanes, first + i,
                )  # fmt: skip


@loop
def fused(
    plan: Simple,
    noise_keys: Annotated[Words, "sources"],
    frames: Annotated[Floats32, "count pixels"],
    kinds: Annotated[Ints, "count"],
    frame_weight: Annotated[Floats32, "count"],
    mask_row: Annotated[Ints, "count"],
    masks: Bytes,
    table: Floats32,
    lanes: Annotated[Ints32, "pixels"],
    response: Floats,
    gain: Annotated[Floats, "lane_count"],
    limit: Annotated[Floats, "lane_count"],
    pattern: Floats,
    sigma: Annotated[Floats, "sources lane_count"],
    part: Written[Floats32],
    values: Written[Floats],
    scratch: Written[Floats],
    few: Written[Floats],
    places: Written[Ints],
    exposure: Written[Annotated[Floats, "pixels"]],
    frame: Written[Annotated[Bytes, "pixels"]],
    valid: Written[Annotated[Bytes, "pixels"]],
    marked: Written[Annotated[Bytes, "pixels"]],
) -> None:
    """One bucket of one frame.

    `masks` (rows, pixels) and `table` (frames, lanes) where a frame's kind asks for them,
    `response` and `pattern` (pixels,) where they are asked for. `gain`: of a lane's open slots.
    `part`, `values`, `few`, `places`: scratch for `BLOCK`
    pixels; `scratch` for four times as many. `valid` comes filled with 1, and is 0 where light is
    no number; `marked` with 0, and is `well_bit` where it is clipped.
    """
    lane_count = plan.lane_count
    for first in range(plan.begin, plan.end, BLOCK):
        stop = min(first + BLOCK, plan.end)
        _lit(
            plan, frames, kinds, frame_weight, mask_row, masks, table, lanes, first, stop, part,
            values, valid,
        )  # fmt: skip
        for i in range(stop - first):
            values[i] *= plan.factor
        if plan.uneven:
            for i in range(stop - first):
                values[i] *= response[first + i]
        if plan.counted:
            counted(plan.count_key, plan.rate_cap, first, stop, values, scratch, few, places)
        for i in range(stop - first):
            values[i] *= gain[lanes[first + i]]
        if plan.clipped:
            for i in range(stop - first):
                most = limit[lanes[first + i]]
                marked[first + i] = plan.well_bit if values[i] > most * plan.full else 0
                values[i] = values[i] if values[i] < most else most
        if plan.patterned:
            for i in range(stop - first):
                values[i] += pattern[first + i]
        for source in range(plan.sources):
            _noisy(
                noise_keys[source], sigma, source * lane_count, lanes, first, stop, values, scratch
            )
        for i in range(stop - first):
            exposure[first + i] = values[i] + 0.0
        if plan.read_out:
            read_out(
                plan.readout_noisy, plan.readout_noise, plan.readout_key, plan.electrons_per_code,
                plan.offset, plan.top, first, stop - first, values, 0, scratch, frame, first,
            )  # fmt: skip
