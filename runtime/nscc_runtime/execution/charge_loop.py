"""What falls on a pixel in a run of slots: rates, counts spread by halving, neighbours' charge.

Part of the loop over single pixels (`nscc_runtime.execution.pixel_loop`). The rate of a site, a
pixel or one beside it, in a run of slots is its scale times a difference of sums over the slots.
"""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np

from nscc_runtime.execution.layout import Keys, Numbers, Sizes
from nscc_runtime.loop import Floats, Ints, Ints32, Words, Written, compiled
from nscc_runtime.noise.counter import bits
from nscc_runtime.noise.noise_loops import halved, uniform
from nscc_runtime.noise.poisson_law import poisson_exact

SITES = 5
"""A pixel and its four neighbours."""
LIT, DARK = range(2)
"""Sources of charge."""
SURE = 9.0
"""Standard deviations below which a count does not come."""


class Sites(NamedTuple):
    """The light of pixels and of those beside them: the `number` of each place that was asked for
    in `rows` and `scales` (sites, 2), which say where in `sums`, a row of slots + 1 for each group,
    the light and the dark charge of each begin, and by what they are multiplied."""

    number: Written[Annotated[Ints32, "rows cols"]]
    rows: Written[Annotated[Ints, "sites 2"]]
    scales: Written[Annotated[Floats, "sites 2"]]
    sums: Written[Floats]


class Away(NamedTuple):
    """Counts that are given: how far they are `from_mean` (counted groups, pixels), and in which of
    these rows each group's are, -1: in none."""

    row: Annotated[Ints, "groups"]
    from_mean: Floats


class Counts(NamedTuple):
    """Scratch: the keys of a frame's counts, the counts that were drawn, and of which pixel each
    is (-1 at first); a pixel's place and those of its neighbours."""

    streams: Written[Words]
    heap: Written[Floats]
    stamps: Written[Ints]
    places: Written[Ints]


@compiled
def stream_key(base: np.uint64, frame: int, group: np.uint64) -> np.uint64:
    """`nscc_runtime.noise.key`, from the half of it that seed, effect and source decide."""
    return bits(base, frame, group)


@compiled
def _share(sums: Floats, row: int, first: int, stop: int) -> float:
    """The rates of a group in the slots `first` .. `stop` - 1, from their sums up to each slot."""
    found: float = sums[row + stop] - sums[row + first]
    return found


@compiled
def _split(
    sizes: Sizes, counts: Counts, top: int, parent: int, sums: Floats, row: int,
    stream: np.uint64, place: int,
) -> None:  # fmt: skip
    """Halve the count of a node."""
    heap, stamps, slots, whole = counts.heap, counts.stamps, sizes.slots, sizes.whole
    size, above = whole, parent
    while above > 1:
        size //= 2
        above //= 2
    start = parent * size - whole
    middle, end = start + size // 2, min(start + size, slots)
    count = heap[top + parent]
    drawn = count
    if count <= 0.0:
        drawn = 0.0
    elif middle < slots:
        left, right = _share(sums, row, start, middle), _share(sums, row, middle, end)
        drawn = halved(stream, place, parent, count, left, right)
    heap[top + 2 * parent] = drawn
    heap[top + 2 * parent + 1] = count - drawn
    stamps[top + 2 * parent] = place
    stamps[top + 2 * parent + 1] = place


@compiled
def _counted(
    sizes: Sizes, counts: Counts, top: int, first: int, stop: int, sums: Floats, row: int,
    stream: np.uint64, place: int,
) -> float:  # fmt: skip
    """The count of a group in the slots `first` .. `stop` - 1. `heap` from `top` on keeps the
    counts of the nodes that were found for this pixel."""
    total = 0.0
    low, high = first + sizes.whole, stop + sizes.whole
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
                    _split(sizes, counts, top, node >> depth, sums, row, stream, place)
                    depth -= 1
                total += counts.heap[top + node]
        low //= 2
        high //= 2
    return total


@compiled
def _between(
    sizes: Sizes, numbers: Numbers, source: int, place: int, begin: int, stop: int,
    sites: Sites, counts: Counts, kept: int,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 of one source (`LIT`, `DARK`) at a site, whose
    counts are kept in heaps from number `kept` on. A group's count is drawn when it is first asked
    for.
    """
    total, sums, heap, stamps = 0.0, sites.sums, counts.heap, counts.stamps
    slots, count = sizes.slots, sizes.groups
    counted = source == DARK or sizes.counts_light == 1
    site, kept = 2 * sites.number[place] + source, kept + source
    scale, row = sites.scales[site], sites.rows[site]
    for group in range(count):
        inside, every = scale * _share(sums, row, begin, stop), scale * sums[row + slots]
        if inside > 0.0 and not counted:
            total += inside
        elif inside > 0.0:
            top = (kept * count + group) * 2 * sizes.whole
            if stamps[top + 1] != place:
                rate = every if every < numbers.rate_cap else numbers.rate_cap
                stream = counts.streams[2 * source * count + group]
                heap[top + 1] = poisson_exact(uniform(stream, place), rate)
                stamps[top + 1] = place
            # Where nothing was counted there is nothing to spread: so it is with most dark charge.
            # Nor is there where no slot of the group is left out.
            whole_group = sums[row + begin] <= 0.0 and sums[row + stop] >= sums[row + slots]
            if heap[top + 1] <= 0.0 or whole_group:
                total += heap[top + 1]
            else:
                stream = counts.streams[(2 * source + 1) * count + group]
                total += _counted(sizes, counts, top, begin, stop, sums, row, stream, place)
        row += slots + 1
    return total


@compiled
def streams_of(sizes: Sizes, keys: Keys, group_ids: Words, streams: Words) -> None:
    """The keys of a frame's counts and of how they spread, of each source, for each group."""
    count = sizes.groups
    for group in range(count):
        name = group_ids[group]
        streams[group] = stream_key(keys.count_light, sizes.frame, name)
        streams[count + group] = stream_key(keys.thin_light, sizes.frame, name)
        streams[2 * count + group] = stream_key(keys.count_dark, sizes.frame, name)
        streams[3 * count + group] = stream_key(keys.thin_dark, sizes.frame, name)


@compiled
def _heaps_at(sizes: Sizes, place: int) -> int:
    """Where a site's counts are kept: next to those of its neighbours, never in their place."""
    if not sizes.exchanges or sizes.given:
        return 0
    row, col = place // sizes.cols, place % sizes.cols
    found: int = (row % 3) * sizes.kept_cols + col % sizes.kept_cols
    return found


@compiled
def _of_site(
    sizes: Sizes, numbers: Numbers, place: int, begin: int, stop: int, sites: Sites,
    counts: Counts,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 at a site."""
    kept = 2 * _heaps_at(sizes, place)
    total = _between(sizes, numbers, LIT, place, begin, stop, sites, counts, kept)
    if sizes.counts_dark:
        total += _between(sizes, numbers, DARK, place, begin, stop, sites, counts, kept)
    return total


@compiled
def _taken_evenly(
    sizes: Sizes, numbers: Numbers, place: int, begin: int, stop: int, sites: Sites,
    away: Away,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 at a site whose counts are so far `away` from
    their means, spread as its light is."""
    slots, site, sums = sizes.slots, 2 * sites.number[place], sites.sums
    lit, dark, scale = sites.rows[site + LIT], sites.rows[site + DARK], sites.scales[site + LIT]
    pixels, total = sizes.rows * sizes.cols, 0.0
    for group in range(sizes.groups):
        inside, every = _share(sums, lit, begin, stop), sums[lit + slots]
        total += scale * inside
        # Of rates beyond the cap, sums know no count.
        known = scale * every < numbers.rate_cap
        if sizes.counts_dark:
            in_time = _share(sums, dark, begin, stop)
            total += sites.scales[site + DARK] * in_time
            if every <= 0.0:
                inside, every = in_time, sums[dark + slots]
        if away.row[group] >= 0 and inside > 0.0 and known:
            total += away.from_mean[away.row[group] * pixels + place] * (inside / every)
        lit += slots + 1
        dark += slots + 1
    return total


@compiled
def charge(
    sizes: Sizes, numbers: Numbers, begin: int, stop: int, sites: Sites, away: Away,
    counts: Counts,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 that falls on the pixel, smeared."""
    if begin >= stop:
        return 0.0
    own = _of_site(sizes, numbers, counts.places[0], begin, stop, sites, counts)
    if not sizes.exchanges:
        return own
    flow = 0.0
    for beside in range(1, SITES):
        place = counts.places[beside]
        if place < 0:
            continue
        if sizes.given:
            total = _taken_evenly(sizes, numbers, place, begin, stop, sites, away)
        else:
            total = _of_site(sizes, numbers, place, begin, stop, sites, counts)
        flow += total - own
    return own + numbers.exchanged * flow


@compiled
def charge_evenly(
    sizes: Sizes, numbers: Numbers, begin: int, stop: int, sites: Sites, away: Away,
    counts: Counts,
) -> float:  # fmt: skip
    """As `charge`, the pixel's own counts spread as light is, too."""
    own = _taken_evenly(sizes, numbers, counts.places[0], begin, stop, sites, away)
    flow = 0.0
    for beside in range(1, SITES if sizes.exchanges else 1):
        place = counts.places[beside]
        if place >= 0:
            flow -= own
            flow += _taken_evenly(sizes, numbers, place, begin, stop, sites, away)
    return own + numbers.exchanged * flow


@compiled
def least_charge(
    sizes: Sizes, numbers: Numbers, place: int, begin: int, stop: int, sites: Sites
) -> float:
    """What falls on a pixel in these slots for sure: less with a chance below 1e-17, by Chernoff's
    bound of counts, exp(-SURE**2 / 2)."""
    site, mean = 2 * sites.number[place] + LIT, 0.0
    row = sites.rows[site]
    for _ in range(sizes.groups):
        mean += _share(sites.sums, row, begin, stop)
        row += sizes.slots + 1
    mean *= sites.scales[site]
    least = mean - SURE * math.sqrt(mean)
    kept = 1.0 - (SITES - 1) * numbers.exchanged if sizes.exchanges else 1.0
    return kept * least if least > 0.0 else 0.0
