"""The charge of a pixel in a range of slots: rates, halved counts, exchange with neighbours.

This is part of the loop over single pixels (`nscc_runtime.execution.pixel_loop`). A site is a pixel
or one of its neighbours. Its rate in a range of slots is its scale times a difference of cumulative
sums."""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np

from nscc_runtime.execution.layout import Keys, Numbers, Sizes
from nscc_runtime.loop import Floats, Ints, Ints32, Words, Written, compiled
from nscc_runtime.noise.keys import bits
from nscc_runtime.noise.noise_loops import halved, uniform
from nscc_runtime.noise.poisson_law import poisson_exact

SITES = 5
"""Number of sites of a pixel: itself and its four neighbours."""
LIT, DARK = range(2)
"""Sources of charge."""
SURE = 9.0
"""A count is assumed to be at least its mean minus this number of standard deviations."""


class Sites(NamedTuple):
    """The light of sites. A site is a pixel or one of its neighbours.

    `rows` and `scales` have one row per site, and `number` is the row of each pixel. A row of
    `rows` contains two indices into `sums`: where the cumulative sums of the site's light and of
    its dark charge start. `scales` contains the factors on these two. `sums` has slots + 1
    cumulative sums for each group of slots."""

    number: Written[Annotated[Ints32, "rows cols"]]
    rows: Written[Annotated[Ints, "sites 2"]]
    scales: Written[Annotated[Floats, "sites 2"]]
    sums: Written[Floats]


class Away(NamedTuple):
    """Known counts. `from_mean`: their deviations from the mean (counted groups, pixels). `row`:
    the row of each group in `from_mean`, or -1."""

    row: Annotated[Ints, "groups"]
    from_mean: Floats


class CountScratch(NamedTuple):
    """Working memory: `streams`, random keys of a frame's counts; `heap`, drawn counts; `stamps`,
    the pixel of each count (-1 at first); `places`, a pixel and its neighbours."""

    streams: Written[Words]
    heap: Written[Floats]
    stamps: Written[Ints]
    places: Written[Ints]


@compiled
def _rate_between(sums: Floats, row: int, first: int, stop: int) -> float:
    """Return the rate of a group in the slots `first` to `stop` - 1 from cumulative sums."""
    rate: float = sums[row + stop] - sums[row + first]
    return rate


@compiled
def _split_node(
    sizes: Sizes, counts: CountScratch, top: int, parent: int, sums: Floats, row: int,
    stream: np.uint64, place: int,
) -> None:  # fmt: skip
    """Split the count of a tree node between the two halves of its slots."""
    heap, stamps, slots, padded_slots = counts.heap, counts.stamps, sizes.slots, sizes.padded_slots
    size, above = padded_slots, parent
    while above > 1:
        size //= 2
        above //= 2
    start = parent * size - padded_slots
    middle, end = start + size // 2, min(start + size, slots)
    count = heap[top + parent]
    drawn = count
    if count <= 0.0:
        drawn = 0.0
    elif middle < slots:
        left_rate = _rate_between(sums, row, start, middle)
        right_rate = _rate_between(sums, row, middle, end)
        drawn = halved(stream, place, parent, count, left_rate, right_rate)
    heap[top + 2 * parent] = drawn
    heap[top + 2 * parent + 1] = count - drawn
    stamps[top + 2 * parent] = place
    stamps[top + 2 * parent + 1] = place


@compiled
def _count_between(
    sizes: Sizes, counts: CountScratch, top: int, first: int, stop: int, sums: Floats, row: int,
    stream: np.uint64, place: int,
) -> float:  # fmt: skip
    """Return the count of a group in the slots `first` to `stop` - 1. The heap from index `top` on
    contains the counts of tree nodes that were already split for this pixel."""
    total = 0.0
    low, high = first + sizes.padded_slots, stop + sizes.padded_slots
    while low < high:
        for side in range(2):
            node = 0
            if side == 0 and low & 1:
                node = low
                low += 1
            elif side == 1 and high & 1:
                high -= 1
                node = high
            if node > 0:
                depth = 0
                while counts.stamps[top + (node >> depth)] != place:
                    depth += 1
                while depth > 0:
                    _split_node(sizes, counts, top, node >> depth, sums, row, stream, place)
                    depth -= 1
                total += counts.heap[top + node]
        low //= 2
        high //= 2
    return total


@compiled
def _charge_of_source(
    sizes: Sizes, numbers: Numbers, source: int, place: int, begin: int, stop: int,
    sites: Sites, counts: CountScratch, heap_number: int,
) -> float:  # fmt: skip
    """Return the charge of one source (`LIT`, `DARK`) in the slots `begin` to `stop` - 1 at a site.

    Counts are stored in heaps from `heap_number` on. Each count is drawn when it is first needed.
    """
    total, sums, heap, stamps = 0.0, sites.sums, counts.heap, counts.stamps
    slots, count = sizes.slots, sizes.groups
    counted = source == DARK or sizes.counts_light == 1
    site, heap_number = 2 * sites.number[place] + source, heap_number + source
    scale, row = sites.scales[site], sites.rows[site]
    for group in range(count):
        inside = scale * _rate_between(sums, row, begin, stop)
        group_rate = scale * sums[row + slots]
        if inside > 0.0 and not counted:
            total += inside
        elif inside > 0.0:
            top = (heap_number * count + group) * 2 * sizes.padded_slots
            if stamps[top + 1] != place:
                rate = group_rate if group_rate < numbers.rate_cap else numbers.rate_cap
                stream = counts.streams[2 * source * count + group]
                heap[top + 1] = poisson_exact(uniform(stream, place), rate)
                stamps[top + 1] = place
            # A count of 0 needs no split (most dark charge), nor does a group without other slots.
            whole_group = sums[row + begin] <= 0.0 and sums[row + stop] >= sums[row + slots]
            if heap[top + 1] <= 0.0 or whole_group:
                total += heap[top + 1]
            else:
                stream = counts.streams[(2 * source + 1) * count + group]
                total += _count_between(sizes, counts, top, begin, stop, sums, row, stream, place)
        row += slots + 1
    return total


@compiled
def streams_of(sizes: Sizes, keys: Keys, group_ids: Words, streams: Words) -> None:
    """Set `streams` to the random keys of counts and of their splits, by source and group."""
    count = sizes.groups
    for group in range(count):
        name = group_ids[group]
        streams[group] = bits(keys.count_light, sizes.frame, name)
        streams[count + group] = bits(keys.thin_light, sizes.frame, name)
        streams[2 * count + group] = bits(keys.count_dark, sizes.frame, name)
        streams[3 * count + group] = bits(keys.thin_dark, sizes.frame, name)


@compiled
def _charge_of_site(
    sizes: Sizes, numbers: Numbers, place: int, begin: int, stop: int, sites: Sites,
    counts: CountScratch,
) -> float:  # fmt: skip
    """Return the charge of a site in the slots `begin` to `stop` - 1."""
    heap_number = 0
    if sizes.exchanges and not sizes.counts_known:
        # Neighbouring sites have different heaps.
        row, col = place // sizes.cols, place % sizes.cols
        heap_number = 2 * ((row % 3) * sizes.kept_cols + col % sizes.kept_cols)
    total = _charge_of_source(sizes, numbers, LIT, place, begin, stop, sites, counts, heap_number)
    if sizes.counts_dark:
        total += _charge_of_source(
            sizes, numbers, DARK, place, begin, stop, sites, counts, heap_number
        )
    return total


@compiled
def _charge_spread_evenly(
    sizes: Sizes, numbers: Numbers, place: int, begin: int, stop: int, sites: Sites,
    away: Away,
) -> float:  # fmt: skip
    """Return the charge of a site in the slots `begin` to `stop` - 1, from known counts. The
    deviations in `away` are split between slots in proportion to their light."""
    slots, site, sums = sizes.slots, 2 * sites.number[place], sites.sums
    lit, dark, scale = sites.rows[site + LIT], sites.rows[site + DARK], sites.scales[site + LIT]
    pixels, total = sizes.rows * sizes.cols, 0.0
    for group in range(sizes.groups):
        inside, group_rate = _rate_between(sums, lit, begin, stop), sums[lit + slots]
        total += scale * inside
        # Sums have no counts for rates above the cap.
        known = scale * group_rate < numbers.rate_cap
        if sizes.counts_dark:
            in_time = _rate_between(sums, dark, begin, stop)
            total += sites.scales[site + DARK] * in_time
            if group_rate <= 0.0:
                inside, group_rate = in_time, sums[dark + slots]
        if away.row[group] >= 0 and inside > 0.0 and known:
            total += away.from_mean[away.row[group] * pixels + place] * (inside / group_rate)
        lit += slots + 1
        dark += slots + 1
    return total


@compiled
def charge(
    sizes: Sizes, numbers: Numbers, begin: int, stop: int, sites: Sites, away: Away,
    counts: CountScratch,
) -> float:  # fmt: skip
    """Return the charge of pixel counts.places[0] in slots `begin` to `stop` - 1 after
    crosstalk."""
    if begin >= stop:
        return 0.0
    own_e = _charge_of_site(sizes, numbers, counts.places[0], begin, stop, sites, counts)
    if not sizes.exchanges:
        return own_e
    flow = 0.0
    for beside in range(1, SITES):
        place = counts.places[beside]
        if place < 0:
            continue
        if sizes.counts_known:
            total = _charge_spread_evenly(sizes, numbers, place, begin, stop, sites, away)
        else:
            total = _charge_of_site(sizes, numbers, place, begin, stop, sites, counts)
        flow += total - own_e
    return own_e + numbers.exchanged * flow


@compiled
def charge_evenly(
    sizes: Sizes, numbers: Numbers, begin: int, stop: int, sites: Sites, away: Away,
    counts: CountScratch,
) -> float:  # fmt: skip
    """Return the charge like `charge`, but split the pixel's own counts in proportion to light."""
    own_e = _charge_spread_evenly(sizes, numbers, counts.places[0], begin, stop, sites, away)
    flow = 0.0
    for beside in range(1, SITES if sizes.exchanges else 1):
        place = counts.places[beside]
        if place >= 0:
            flow -= own_e
            flow += _charge_spread_evenly(sizes, numbers, place, begin, stop, sites, away)
    return own_e + numbers.exchanged * flow


@compiled
def least_charge(
    sizes: Sizes, numbers: Numbers, place: int, begin: int, stop: int, sites: Sites
) -> float:
    """Return a lower bound of the charge of a pixel in the slots `begin` to `stop` - 1. The
    probability of a smaller charge is below exp(-SURE**2 / 2), about 1e-17 (Chernoff bound)."""
    site, mean = 2 * sites.number[place] + LIT, 0.0
    row = sites.rows[site]
    for _ in range(sizes.groups):
        mean += _rate_between(sites.sums, row, begin, stop)
        row += sizes.slots + 1
    mean *= sites.scales[site]
    least = mean - SURE * math.sqrt(mean)
    kept_fraction = 1.0 - (SITES - 1) * numbers.exchanged if sizes.exchanges else 1.0
    return kept_fraction * least if least > 0.0 else 0.0
