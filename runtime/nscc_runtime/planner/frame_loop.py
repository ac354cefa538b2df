"""The loops for frames by weighted sums: counts, what they and the noise of words make of the mean
exposures, and the converter's codes.

What all frames of a scene have in common comes ready made (`nscc_runtime.planner.summed`).
"""

from __future__ import annotations

from typing import Annotated

from nscc_runtime.loop import (
    Bytes,
    Floats,
    Floats32,
    Ints,
    Ints32,
    Words,
    Written,
    compiled,
    loop,
    record,
)
from nscc_runtime.planner.drawn import BLOCK, counted, drawn_normals, read_out

UP, DOWN, LEFT, RIGHT = range(4)
"""Neighbours, in the order of `nscc_runtime.planner.overlap`."""


@record
class Counting:
    """Which of all `pixels` are counted; `more`: beside what another source has left in `away`,
    which has room for `room` pixels from number `from_` on."""

    begin: int
    end: int
    pixels: int
    room: int
    from_: int
    groups: int
    more: int
    rate_cap: float


@loop
def draw_counts(
    counting: Counting,
    keys: Annotated[Words, "groups"],
    rates: Annotated[Floats, "groups pixels"],
    values: Written[Floats],
    scratch: Written[Floats],
    few: Written[Floats],
    places: Written[Ints],
    away: Written[Annotated[Floats, "groups room"]],
) -> None:
    """away[g, p - from_] := how far a count of rates[g, p] is from its mean, or so much more.

    `values`, `few`, `places`: scratch for `BLOCK` pixels; `scratch` for four times as many.
    """
    for first in range(counting.begin, counting.end, BLOCK):
        stop = min(first + BLOCK, counting.end)
        for group in range(counting.groups):
            at, to = group * counting.pixels + first, group * counting.room + first - counting.from_
            for i in range(stop - first):
                values[i] = rates[at + i]
            counted(keys[group], counting.rate_cap, first, stop, values, scratch, few, places)
            if counting.more:
                for i in range(stop - first):
                    away[to + i] += values[i] - rates[at + i]
            else:
                for i in range(stop - first):
                    away[to + i] = values[i] - rates[at + i]


@record
class Adding:
    """The rows from `begin` to `end` - 1, and what is added up there; `away` has `room` pixels from
    number `from_` on."""

    begin: int
    end: int
    rows: int
    cols: int
    pixels: int
    room: int
    from_: int
    buckets: int
    lane_count: int
    groups: int
    """Whose charge is counted; 0: of none."""
    sources: int
    """Of small errors."""
    exchanges: int
    """Whether neighbours exchange counts; so on with the switches below."""
    clipped: int
    patterned: int
    well_bit: int
    """What marks pixels that are clipped: those above `full` times their limit."""
    fraction: float
    full: float


@compiled
def _own(
    adding: Adding, lanes: Ints32, weights: Floats, away: Floats, first: int, stop: int,
    total: Floats,
) -> None:  # fmt: skip
    """total[b, i] := what the groups' deviations at pixel first + i make of its exposures."""
    for bucket in range(adding.buckets):
        at = bucket * BLOCK
        for i in range(stop - first):
            total[at + i] = 0.0
        for group in range(adding.groups):
            source = group * adding.room + first - adding.from_
            row = (group * adding.buckets + bucket) * adding.lane_count
            for i in range(stop - first):
                total[at + i] += weights[row + lanes[first + i]] * away[source + i]


@compiled
def _beside(
    adding: Adding, direction: int, group: int, bucket: int, first: int, stop: int,
    own: Floats32, neighbours: Floats32, away: Floats, total: Floats,
) -> None:  # fmt: skip
    """total[b, i] += what neighbours in one direction give, less what goes to them."""
    rows, cols, pixels = adding.rows, adding.cols, adding.pixels
    row, begin, end = first // cols, first, stop
    step = -cols
    if direction == UP:
        end = stop if row > 0 else first
    elif direction == DOWN:
        step, end = cols, stop if row + 1 < rows else first
    elif direction == LEFT:
        step, begin = -1, first if first % cols else first + 1
    else:
        step, end = 1, stop if stop % cols else stop - 1
    here = group * adding.room - adding.from_
    mine = (group * adding.buckets + bucket) * pixels
    other = ((group * 4 + direction) * adding.buckets + bucket) * pixels
    at = bucket * BLOCK - first
    for p in range(begin, end):
        given = own[mine + p] * away[here + p]
        taken = neighbours[other + p] * away[here + p + step]
        total[at + p] += adding.fraction * (taken - given)


@compiled
def _exchanged(
    adding: Adding, first: int, stop: int, own: Floats32, neighbours: Floats32, away: Floats,
    total: Floats,
) -> None:  # fmt: skip
    """As `_own`, where pixels that touch exchange their counts."""
    for bucket in range(adding.buckets):
        at = bucket * BLOCK - first
        for p in range(first, stop):
            total[at + p] = 0.0
        for group in range(adding.groups):
            mine = (group * adding.buckets + bucket) * adding.pixels
            here = group * adding.room - adding.from_
            for p in range(first, stop):
                total[at + p] += own[mine + p] * away[here + p]
            for direction in range(4):
                _beside(adding, direction, group, bucket, first, stop, own, neighbours, away, total)


@loop
def add_up(
    adding: Adding,
    noise_keys: Annotated[Words, "sources"],
    lanes: Annotated[Ints32, "pixels"],
    expected: Annotated[Floats, "buckets pixels"],
    away: Annotated[Floats, "groups room"],
    weights: Annotated[Floats, "groups buckets lane_count"],
    own: Floats32,
    neighbours: Floats32,
    limits: Floats,
    patterns: Floats,
    sigma: Annotated[Floats, "sources buckets lane_count"],
    total: Written[Floats],
    drawn: Written[Floats],
    exposure: Written[Annotated[Floats, "buckets pixels"]],
    marked: Written[Annotated[Bytes, "buckets pixels"]],
) -> None:
    """Exposures of some rows of a frame from their means and from deviations of counts; `marked`
    is `well_bit` where they are clipped, else 0.

    Weights of deviations: `weights` where pixels keep to themselves, else `own` (groups, buckets,
    pixels) and `neighbours` (groups, 4, buckets, pixels). `limits` and `patterns` (buckets, pixels)
    where they are asked for. Scratch: `total` for `BLOCK` pixels a bucket, `drawn` for `BLOCK`.
    """
    pixels, cols, end = adding.pixels, adding.cols, adding.end * adding.cols
    first = adding.begin * cols
    while first < end:
        # Rows one by one only where what is beside a pixel matters.
        last = (first // cols + 1) * cols if adding.exchanges else end
        stop = min(first + BLOCK, last)
        if adding.exchanges:
            _exchanged(adding, first, stop, own, neighbours, away, total)
        else:
            _own(adding, lanes, weights, away, first, stop, total)
        for bucket in range(adding.buckets):
            at, here = bucket * BLOCK, bucket * pixels + first
            for i in range(stop - first):
                total[at + i] += expected[here + i]
            for i in range(stop - first):
                marked[here + i] = 0
            if adding.clipped:
                for i in range(stop - first):
                    most, value = limits[here + i], total[at + i]
                    marked[here + i] = adding.well_bit if value > most * adding.full else 0
                    total[at + i] = most if value > most else value
            if adding.patterned:
                for i in range(stop - first):
                    total[at + i] += patterns[here + i]
        for source in range(adding.sources):
            drawn_normals(noise_keys[source], first, stop - first, drawn)
            for bucket in range(adding.buckets):
                at = bucket * BLOCK
                size = (source * adding.buckets + bucket) * adding.lane_count
                for i in range(stop - first):
                    total[at + i] += sigma[size + lanes[first + i]] * drawn[i]
        for bucket in range(adding.buckets):
            at, here = bucket * BLOCK, bucket * pixels + first
            for i in range(stop - first):
                exposure[here + i] = total[at + i] + 0.0
        first = stop


@record
class Reading:
    """Which of all `pixels` are read out, and the converter: see `read_out`. `last_bit` marks the
    codes that are the last of the scale.
    """

    begin: int
    end: int
    pixels: int
    buckets: int
    noisy: int
    last_bit: int
    electrons_per_code: float
    offset: float
    top: float
    readout_noise: float


@loop
def convert(
    reading: Reading,
    keys: Annotated[Words, "buckets"],
    exposure: Annotated[Floats, "buckets pixels"],
    scratch: Written[Floats],
    frame: Written[Annotated[Bytes, "buckets pixels"]],
    valid: Written[Annotated[Bytes, "buckets pixels"]],
    marked: Written[Annotated[Bytes, "buckets pixels"]],
) -> None:
    """frame := the codes of exposures, 0 of what is no number; valid := whether they are finite.

    `scratch` is room for `BLOCK` pixels.
    """
    for first in range(reading.begin, reading.end, BLOCK):
        stop = min(first + BLOCK, reading.end)
        for bucket in range(reading.buckets):
            at = bucket * reading.pixels
            read_out(
                reading.noisy, reading.readout_noise, keys[bucket], reading.electrons_per_code,
                reading.offset, reading.top, first, stop - first, exposure, at + first, scratch,
                frame, at + first,
            )  # fmt: skip
            for p in range(at + first, at + stop):
                value = exposure[p]
                valid[p] = 1 if value - value == 0.0 else 0
                marked[p] |= reading.last_bit if frame[p] == reading.top else 0
