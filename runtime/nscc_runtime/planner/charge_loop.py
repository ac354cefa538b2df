"""What falls on a pixel in a run of slots: rates, counts spread by halving, neighbours' charge.

Part of the loop over single pixels (`nscc_runtime.planner.pixel_loop`).
"""

from __future__ import annotations

import numpy as np

from nscc_runtime.effects.spread import log_normal_in_loop
from nscc_runtime.loop import Floats, Floats32, Ints, Ints32, Words, compiled
from nscc_runtime.noise.counter import bits
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.loops import halved, uniform
from nscc_runtime.noise.poisson_law import poisson_exact
from nscc_runtime.planner.layout import Keys, Numbers, Sizes

SITES = 5
"""A pixel and its four neighbours."""
LIT, DARK = range(2)
"""Sources of charge."""


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
    sums: Floats, streams: Words, heap: Floats, stamps: Ints, kept: int,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 of one source (`LIT`, `DARK`) at a site, whose
    sums and heaps are number `kept`. A group's count is drawn when it is first asked for.
    """
    total = 0.0
    slots, whole, count = sizes.slots, sizes.whole, sizes.groups
    for group in range(count):
        row = (kept * count + group) * (slots + 1)
        inside, every = _share(sums, row, begin, stop), sums[row + slots]
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
        if heap[top + 1] <= 0.0 or (sums[row + begin] <= 0.0 and sums[row + stop] >= every):
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
def kept_at(sizes: Sizes, place: int) -> int:
    """Where the charge of a site is kept: next to those of its neighbours, never in their place."""
    if not sizes.exchanges:
        return 0
    row, col = place // sizes.cols, place % sizes.cols
    found: int = (row % 3) * sizes.kept_cols + col % sizes.kept_cols
    return found


@compiled
def charge(
    sizes: Sizes, numbers: Numbers, places: Ints, begin: int, stop: int, sums: Floats,
    streams: Words, heap: Floats, stamps: Ints,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 that falls on the pixel, smeared."""
    if begin >= stop:
        return 0.0
    own, flow = 0.0, 0.0
    for site in range(SITES if sizes.exchanges else 1):
        place = places[site]
        if place < 0:
            continue
        kept = 2 * kept_at(sizes, place)
        total = _between(
            sizes, numbers, LIT, sizes.counts_light == 1, place, begin, stop, sums, streams, heap,
            stamps, kept + LIT,
        )  # fmt: skip
        if sizes.counts_dark:
            total += _between(
                sizes, numbers, DARK, True, place, begin, stop, sums, streams, heap, stamps,
                kept + DARK,
            )  # fmt: skip
        if site == 0:
            own = total
        else:
            flow += total - own
    return own + numbers.exchanged * flow if sizes.exchanges else own


@compiled
def _summed(
    sizes: Sizes, groups: Ints32, lane: int, kept: int, n: int, rate: float, sums: Floats
) -> None:
    """Add the rate of slot n to the sums of its group, which go on without it in the others."""
    slots, mine = sizes.slots, groups[lane * sizes.slots + n]
    for group in range(sizes.groups):
        at = (kept * sizes.groups + group) * (slots + 1) + n
        before = sums[at] if n > 0 else 0.0
        sums[at] = before
        sums[at + 1] = before + rate if group == mine else before


@compiled
def lit(
    sizes: Sizes, numbers: Numbers, keys: Keys, place: int, frames: Floats32, row_start: Ints,
    frame_index: Ints32, weight: Floats, slot_s: Floats, groups: Ints32, lanes: Ints32,
    sums: Floats,
) -> None:  # fmt: skip
    """The rates of a site, added up slot by slot for each group, where they are kept."""
    pixels, lane = sizes.rows * sizes.cols, lanes[place]
    response = 1.0
    if sizes.uneven:
        response += numbers.uneven * normal(uniform(keys.uneven, place))
        response = response if response > 0.0 else 0.0
    kept = 2 * kept_at(sizes, place)
    for n in range(sizes.slots):
        total = 0.0
        for k in range(row_start[n], row_start[n + 1]):
            total += float(frames[frame_index[k] * pixels + place]) * weight[k]
        rate = float(np.float32(total))
        rate = (rate + numbers.echo * rate) * response
        rate = rate if rate > 0.0 else 0.0
        rate = rate if rate < numbers.rate_cap else numbers.rate_cap
        _summed(sizes, groups, lane, kept + LIT, n, rate, sums)
    if sizes.counts_dark:
        z = normal(uniform(keys.dark, place))
        current = numbers.dark * log_normal_in_loop(numbers.dark_variance, z)
        for n in range(sizes.slots):
            _summed(sizes, groups, lane, kept + DARK, n, slot_s[n] * current, sums)
