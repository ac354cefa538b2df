"""What falls on a pixel in a run of slots: rates, counts spread by halving, neighbours' charge.

Part of the loop over single pixels (`nscc_runtime.planner.pixel_loop`).
"""

from __future__ import annotations

import numpy as np

from nscc_runtime.effects.spread import log_normal_in_loop
from nscc_runtime.loop import Bytes, Floats, Floats32, Ints, Ints32, Words, compiled
from nscc_runtime.noise.counter import bits
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.loops import halved, uniform
from nscc_runtime.noise.poisson_law import poisson_exact
from nscc_runtime.planner.layout import Keys, Numbers, Sizes

SITES = 5
"""A pixel and its four neighbours."""


@compiled
def stream_key(base: np.uint64, frame: int, group: np.uint64) -> np.uint64:
    """`nscc_runtime.noise.key`, from the half of it that seed, effect and source decide."""
    return bits(base, frame, group)


@compiled
def _share(
    rates: Floats, at: int, groups: Ints32, lane: int, group: int, first: int, stop: int
) -> float:
    """The rates of a group in the slots `first` .. `stop` - 1."""
    total = 0.0
    for n in range(first, stop):
        if groups[lane + n] == group:
            total += rates[at + n]
    return total


@compiled
def _split(
    heap: Floats, stamps: Ints, top: int, parent: int, slots: int, whole: int,
    rates: Floats, at: int, groups: Ints32, lane: int, group: int, stream: np.uint64, place: int,
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
        left = _share(rates, at, groups, lane, group, start, middle)
        right = _share(rates, at, groups, lane, group, middle, end)
        drawn = halved(stream, place, parent, count, left, right)
    heap[top + 2 * parent] = drawn
    heap[top + 2 * parent + 1] = count - drawn
    stamps[top + 2 * parent] = place
    stamps[top + 2 * parent + 1] = place


@compiled
def _counted(
    heap: Floats, stamps: Ints, top: int, first: int, stop: int, slots: int, whole: int,
    rates: Floats, at: int, groups: Ints32, lane: int, group: int, stream: np.uint64, place: int,
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
                    _split(
                        heap, stamps, top, node >> depth, slots, whole,
                        rates, at, groups, lane, group, stream, place,
                    )  # fmt: skip
                    depth -= 1
                total += heap[top + node]
        low //= 2
        high //= 2
    return total


@compiled
def _prepared(
    sizes: Sizes, numbers: Numbers, of_count: np.uint64, place: int, rates: Floats, at: int,
    groups: Ints32, present: Bytes, lane: int, group_ids: Words, heap: Floats, stamps: Ints,
    first: int,
) -> None:  # fmt: skip
    """Draw the counts of a site's groups and put them at the tops of their heaps."""
    slots, whole, count = sizes.slots, sizes.whole, sizes.groups
    for group in range(count):
        if present[lane * count + group]:
            rate = _share(rates, at, groups, lane * slots, group, 0, slots)
            rate = rate if rate < numbers.rate_cap else numbers.rate_cap
            stream = stream_key(of_count, sizes.frame, group_ids[group])
            top = first + 2 * whole * group + 1
            heap[top] = poisson_exact(uniform(stream, place), rate)
            stamps[top] = place


@compiled
def _between(
    sizes: Sizes, of_thin: np.uint64, counted: bool, place: int, begin: int, stop: int,
    rates: Floats, at: int, groups: Ints32, present: Bytes, lane: int, group_ids: Words,
    heap: Floats, stamps: Ints, first: int,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 at a site, of one source."""
    total = 0.0
    slots, whole, count = sizes.slots, sizes.whole, sizes.groups
    if not counted:
        for n in range(begin, stop):
            total += rates[at + n]
        return total
    for group in range(count):
        # Where nothing was counted there is nothing to spread: so it is with most dark charge.
        if present[lane * count + group] and heap[first + 2 * whole * group + 1] > 0.0:
            stream = stream_key(of_thin, sizes.frame, group_ids[group])
            total += _counted(
                heap, stamps, first + 2 * whole * group, begin, stop, slots, whole,
                rates, at, groups, lane * slots, group, stream, place,
            )  # fmt: skip
    return total


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
    sizes: Sizes, numbers: Numbers, keys: Keys, places: Ints, begin: int, stop: int,
    rates: Floats, groups: Ints32, present: Bytes, lanes: Ints32, group_ids: Words,
    heap: Floats, stamps: Ints,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 that falls on the pixel, smeared."""
    if begin >= stop:
        return 0.0
    slots, room = sizes.slots, 2 * sizes.whole * sizes.groups
    own, flow = 0.0, 0.0
    for site in range(SITES if sizes.exchanges else 1):
        place = places[site]
        if place < 0:
            continue
        kept = 2 * kept_at(sizes, place)
        total = _between(
            sizes, keys.thin_light, sizes.counts_light == 1, place, begin, stop, rates,
            kept * slots, groups, present, lanes[place], group_ids, heap, stamps, kept * room,
        )  # fmt: skip
        if sizes.counts_dark:
            total += _between(
                sizes, keys.thin_dark, True, place, begin, stop, rates,
                (kept + 1) * slots, groups, present, lanes[place], group_ids, heap, stamps,
                (kept + 1) * room,
            )  # fmt: skip
        if site == 0:
            own = total
        else:
            flow += total - own
    return own + numbers.exchanged * flow if sizes.exchanges else own


@compiled
def lit(
    sizes: Sizes, numbers: Numbers, keys: Keys, place: int,
    frames: Floats32, row_start: Ints, frame_index: Ints32, weight: Floats, slot_s: Floats,
    groups: Ints32, present: Bytes, lanes: Ints32, group_ids: Words,
    rates: Floats, heap: Floats, stamps: Ints,
) -> None:  # fmt: skip
    """The rates of a site, slot by slot, and the counts of its groups, where they are kept."""
    slots, pixels = sizes.slots, sizes.rows * sizes.cols
    room = 2 * sizes.whole * sizes.groups
    response = 1.0
    if sizes.uneven:
        response += numbers.uneven * normal(uniform(keys.uneven, place))
        response = response if response > 0.0 else 0.0
    kept = 2 * kept_at(sizes, place)
    at = kept * slots
    for n in range(slots):
        total = 0.0
        for k in range(row_start[n], row_start[n + 1]):
            total += float(frames[frame_index[k] * pixels + place]) * weight[k]
        rate = float(np.float32(total))
        rate = (rate + numbers.echo * rate) * response
        rate = rate if rate > 0.0 else 0.0
        rates[at + n] = rate if rate < numbers.rate_cap else numbers.rate_cap
    if sizes.counts_light:
        _prepared(
            sizes, numbers, keys.count_light, place, rates, at, groups, present, lanes[place],
            group_ids, heap, stamps, kept * room,
        )  # fmt: skip
    if sizes.counts_dark:
        at += slots
        z = normal(uniform(keys.dark, place))
        current = numbers.dark * log_normal_in_loop(numbers.dark_variance, z)
        for n in range(slots):
            rates[at + n] = slot_s[n] * current
        _prepared(
            sizes, numbers, keys.count_dark, place, rates, at, groups, present, lanes[place],
            group_ids, heap, stamps, (kept + 1) * room,
        )  # fmt: skip
