"""What falls on a pixel in a run of slots: rates, counts spread by halving, neighbours' charge.

Part of the loop over single pixels (`nscc_runtime.execution.pixel_loop`). The rate of a site, a
pixel
or one beside it, in a run of slots is its `scales` times a difference of `sums` over the slots,
whose rows, one a group, begin at its `rows`: two of each, of light and of dark charge.
"""

from __future__ import annotations

import math

import numpy as np

from nscc_runtime.execution.layout import Keys, Numbers, Sizes
from nscc_runtime.loop import Floats, Ints, Ints32, Words, compiled
from nscc_runtime.noise.counter import bits
from nscc_runtime.noise.noise_loops import halved, uniform
from nscc_runtime.noise.poisson_law import poisson_exact

SITES = 5
"""A pixel and its four neighbours."""
LIT, DARK = range(2)
"""Sources of charge."""
SURE = 9.0
"""Standard deviations below which a count does not come."""


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
    heap: Floats, stamps: Ints, top: int, parent: int, slots: int, whole: int,
    sums: Floats, row: int, stream: np.uint64, place: int,
) -> None:  # fmt: skip
    """Halve the count of a node."""
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
    heap: Floats, stamps: Ints, top: int, first: int, stop: int, slots: int, whole: int,
    sums: Floats, row: int, stream: np.uint64, place: int,
) -> float:  # fmt: skip
    """The count of a group in the slots `first` .. `stop` - 1.

    `heap` from `top` on keeps the counts of the nodes that were found for this pixel.
    """
    total = 0.0
    low, high = first + whole, stop + whole
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
                while stamps[top + (node >> depth)] != place:
                    depth += 1
                while depth > 0:
                    _split(heap, stamps, top, node >> depth, slots, whole, sums, row, stream, place)
                    depth -= 1
                total += heap[top + node]
        low //= 2
        high //= 2
    return total


@compiled
def _between(
    sizes: Sizes, numbers: Numbers, source: int, counted: bool, place: int, begin: int, stop: int,
    scale: float, sums: Floats, rows: int, streams: Words, heap: Floats, stamps: Ints, kept: int,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 of one source (`LIT`, `DARK`) at a site, whose
    heaps are number `kept`. A group's count is drawn when it is first asked for.
    """
    total = 0.0
    slots, whole, count = sizes.slots, sizes.whole, sizes.groups
    for group in range(count):
        row = rows + group * (slots + 1)
        inside, every = scale * _share(sums, row, begin, stop), scale * sums[row + slots]
        if inside <= 0.0:
            continue
        if not counted:
            total += inside
            continue
        top = (kept * count + group) * 2 * whole
        if stamps[top + 1] != place:
            rate = every if every < numbers.rate_cap else numbers.rate_cap
            stream = streams[2 * source * count + group]
            heap[top + 1] = poisson_exact(uniform(stream, place), rate)
            stamps[top + 1] = place
        # Where nothing was counted there is nothing to spread: so it is with most dark charge. Nor
        # is there where no slot of the group is left out.
        whole_group = sums[row + begin] <= 0.0 and sums[row + stop] >= sums[row + slots]
        if heap[top + 1] <= 0.0 or whole_group:
            total += heap[top + 1]
            continue
        stream = streams[(2 * source + 1) * count + group]
        total += _counted(
            heap, stamps, top, begin, stop, slots, whole, sums, row, stream, place
        )  # fmt: skip
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
    sizes: Sizes, numbers: Numbers, place: int, begin: int, stop: int, sites: Ints32,
    rows: Ints, scales: Floats, sums: Floats, streams: Words, heap: Floats,
    stamps: Ints,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 at a site."""
    lit, kept = 2 * sites[place] + LIT, 2 * _heaps_at(sizes, place)
    dark = lit - LIT + DARK
    total = _between(
        sizes, numbers, LIT, sizes.counts_light == 1, place, begin, stop, scales[lit], sums,
        rows[lit], streams, heap, stamps, kept + LIT,
    )  # fmt: skip
    if sizes.counts_dark:
        total += _between(
            sizes, numbers, DARK, True, place, begin, stop, scales[dark], sums, rows[dark],
            streams, heap, stamps, kept + DARK,
        )  # fmt: skip
    return total


@compiled
def _taken_evenly(
    sizes: Sizes, numbers: Numbers, place: int, begin: int, stop: int, sites: Ints32,
    rows: Ints, scales: Floats, sums: Floats, away: Floats, of_group: Ints,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 at a site whose counts are so far `away` from
    their means, spread as its light is."""
    slots, site = sizes.slots, sites[place]
    lit, dark = rows[2 * site + LIT], rows[2 * site + DARK]
    pixels, total = sizes.rows * sizes.cols, 0.0
    for group in range(sizes.groups):
        inside, every = _share(sums, lit, begin, stop), sums[lit + slots]
        total += scales[2 * site + LIT] * inside
        if sizes.counts_dark:
            in_time = _share(sums, dark, begin, stop)
            total += scales[2 * site + DARK] * in_time
            if every <= 0.0:
                inside, every = in_time, sums[dark + slots]
        # Of rates beyond the cap, sums know no count.
        known = scales[2 * site + LIT] * sums[lit + slots] < numbers.rate_cap
        if of_group[group] >= 0 and inside > 0.0 and known:
            total += away[of_group[group] * pixels + place] * (inside / every)
        lit += slots + 1
        dark += slots + 1
    return total


@compiled
def charge(
    sizes: Sizes, numbers: Numbers, places: Ints, begin: int, stop: int, sites: Ints32,
    rows: Ints, scales: Floats, sums: Floats, away: Floats, of_group: Ints,
    streams: Words, heap: Floats, stamps: Ints,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 that falls on the pixel, smeared."""
    if begin >= stop:
        return 0.0
    own = _of_site(
        sizes, numbers, places[0], begin, stop, sites, rows, scales, sums, streams, heap,
        stamps,
    )  # fmt: skip
    if not sizes.exchanges:
        return own
    flow = 0.0
    for beside in range(1, SITES):
        place = places[beside]
        if place < 0:
            continue
        if sizes.given:
            total = _taken_evenly(
                sizes, numbers, place, begin, stop, sites, rows, scales, sums, away, of_group
            )
        else:
            total = _of_site(
                sizes, numbers, place, begin, stop, sites, rows, scales, sums, streams,
                heap, stamps,
            )  # fmt: skip
        flow += total - own
    return own + numbers.exchanged * flow


@compiled
def charge_evenly(
    sizes: Sizes, numbers: Numbers, places: Ints, begin: int, stop: int, sites: Ints32,
    rows: Ints, scales: Floats, sums: Floats, away: Floats, of_group: Ints,
) -> float:  # fmt: skip
    """As `charge`, the pixel's own counts spread as light is, too."""
    own = _taken_evenly(
        sizes, numbers, places[0], begin, stop, sites, rows, scales, sums, away, of_group
    )  # fmt: skip
    flow = 0.0
    for beside in range(1, SITES if sizes.exchanges else 1):
        if places[beside] >= 0:
            flow -= own
            flow += _taken_evenly(
                sizes, numbers, places[beside], begin, stop, sites, rows, scales, sums, away,
                of_group,
            )  # fmt: skip
    return own + numbers.exchanged * flow


@compiled
def least_charge(
    sizes: Sizes, numbers: Numbers, place: int, begin: int, stop: int, sites: Ints32,
    rows: Ints, scales: Floats, sums: Floats,
) -> float:  # fmt: skip
    """What falls on a pixel in these slots for sure: less with a chance below 1e-17, by Chernoff's
    bound of counts, exp(-SURE**2 / 2)."""
    slots, site = sizes.slots, sites[place]
    row, mean = rows[2 * site + LIT], 0.0
    for _ in range(sizes.groups):
        mean += _share(sums, row, begin, stop)
        row += slots + 1
    mean *= scales[2 * site + LIT]
    least = mean - SURE * math.sqrt(mean)
    kept = 1.0 - (SITES - 1) * numbers.exchanged if sizes.exchanges else 1.0
    return kept * least if least > 0.0 else 0.0
