"""The loop that runs the words for single pixels: the reference, compiled, event by event.

It does what `nscc_runtime.reference` does with the same keyed numbers, but moves from word to word
instead of from slot to slot: charge between two words is found by halving counts
(`nscc_runtime.noise.thin`), so a program of few words costs little however many slots it has.

It takes bare pointers, allocates nothing and raises nothing; `nscc_runtime.plan.pixels` makes what
it is given. Importing this module imports numba.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.noise.counter import bits, compiled
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.loops import halved, uniform
from nscc_runtime.noise.poisson_law import poisson_exact
from nscc_runtime.plan.layout import ENTRY_COLUMNS, MOST_DESTINATIONS, Entry, Key, Number, Size

# Pointers; typed as arrays, which is how they are used.
Keys = NDArray[np.uint64]
Ints = NDArray[np.int64]
Ints32 = NDArray[np.int32]
Floats = NDArray[np.float64]
Frames = NDArray[np.float32]
Flags = NDArray[np.uint8]


SITES = 5
"""A pixel and its four neighbours."""
_PART_DESTINATIONS = 4
_READ, _RESET, _ANALOG = 0, 1, 2

# numba takes enum members for what they are only as plain numbers.
_S = {member.name: int(member) for member in Size}
_SLOTS, _ROWS, _COLS = _S["SLOTS"], _S["ROWS"], _S["COLS"]
_BUCKETS, _GROUPS, _REGISTERS, _WHOLE = _S["BUCKETS"], _S["GROUPS"], _S["REGISTERS"], _S["WHOLE"]
_FRAME, _SHOT, _DARK, _FULL_WELL = _S["FRAME"], _S["SHOT"], _S["DARK"], _S["FULL_WELL"]
_READS, _RESETS, _DEAD, _WORDS = _S["READ"], _S["RESET"], _S["DEAD_TIME"], _S["ANALOG"]
_SOFT, _LEAKS, _SMEARS, _UNEVEN = _S["REGISTER"], _S["LEAKAGE"], _S["CROSSTALK"], _S["PRNU"]
_KEPT_COLS = _S["KEPT_COLS"]
_N = {member.name: int(member) for member in Number}
_N_WELL, _N_MIN, _N_MAX, _N_KNEE = (
    _N["FULL_WELL"], _N["REGISTER_MIN"], _N["REGISTER_MAX"], _N["KNEE"],
)  # fmt: skip
_N_SMEAR, _N_LAG, _N_PRNU, _N_CAP = _N["CROSSTALK"], _N["LAG"], _N["PRNU"], _N["RATE_CAP"]
_N_DARK, _N_DARK_VARIANCE = _N["DARK"], _N["DARK_VARIANCE"]
_N_READ, _N_RESET, _N_GAIN = _N["READ"], _N["RESET"], _N["GAIN"]
_N_NOISE, _N_PATTERN, _N_BIAS = _N["ANALOG_NOISE"], _N["PATTERN"], _N["BIAS"]
_N_LEAK, _N_LEAK_VARIANCE = _N["LEAK"], _N["LEAK_VARIANCE"]
_K = {member.name: int(member) for member in Key}
_K_START, _K_PRNU, _K_DARK, _K_PATTERN = _K["START"], _K["PRNU"], _K["DARK"], _K["PATTERN"]
_K_LEAK, _K_COUNT, _K_THIN, _K_SUM, _K_PART = (
    _K["LEAK"], _K["COUNT"], _K["THIN"], _K["SUM"], _K["PART"],
)  # fmt: skip
_E = {member.name: int(member) for member in Entry}
_E_BOUNDARY, _E_RESETS, _E_ACTS, _E_NUMBER = (
    _E["BOUNDARY"], _E["RESETS"], _E["ACTS"], _E["NUMBER"],
)  # fmt: skip
_E_READS_PIX, _E_SOURCES, _E_DESTINATIONS = _E["READS_PIX"], _E["SOURCES"], _E["DESTINATIONS"]
_E_SOURCE, _E_DESTINATION = _E["FIRST_SOURCE"], _E["FIRST_DESTINATION"]
_E_COLUMNS, _E_DRAWS = ENTRY_COLUMNS, 1 + MOST_DESTINATIONS


@compiled
def _key(base: np.uint64, frame: int, group: np.uint64) -> np.uint64:
    """`nscc_runtime.noise.key`, from the half of it that seed, effect and source decide."""
    return bits(base, frame, group)


@compiled
def _log_normal(variance: float, z: float) -> float:
    return math.exp(math.sqrt(variance) * z - variance / 2)


@compiled
def soft(value: float, low: float, high: float, knee: float) -> float:
    """What a register holds of a value: `nscc_runtime.effects.registers.soft`."""
    limit = -low if value < 0.0 else high
    size = abs(value)
    if size <= knee * limit:
        return value
    if knee == 1.0:
        return math.copysign(limit, value)
    room = (1.0 - knee) * limit
    bend = 1.0 - 2.0 / (math.exp(2.0 * (size - knee * limit) / room) + 1.0)
    return math.copysign(knee * limit + room * bend, value)


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
    heap: Floats, stamps: Ints, stamp: int, top: int, parent: int, slots: int, whole: int,
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
    if middle < slots:
        left = _share(rates, at, groups, lane, group, start, middle)
        right = _share(rates, at, groups, lane, group, middle, end)
        drawn = halved(stream, place, parent, count, left, right)
    heap[top + 2 * parent] = drawn
    heap[top + 2 * parent + 1] = count - drawn
    stamps[top + 2 * parent] = stamp
    stamps[top + 2 * parent + 1] = stamp


@compiled
def _counted(
    heap: Floats, stamps: Ints, stamp: int, top: int, first: int, stop: int, slots: int, whole: int,
    rates: Floats, at: int, groups: Ints32, lane: int, group: int, stream: np.uint64, place: int,
) -> float:  # fmt: skip
    """The count of a group in the slots `first` .. `stop` - 1.

    `heap` from `top` on keeps the counts of the nodes that were found for this stamp.
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
                while stamps[top + (node >> depth)] != stamp:
                    depth += 1
                while depth > 0:
                    _split(
                        heap, stamps, stamp, top, node >> depth, slots, whole,
                        rates, at, groups, lane, group, stream, place,
                    )  # fmt: skip
                    depth -= 1
                total += heap[top + node]
        low //= 2
        high //= 2
    return total


@compiled
def _prepared(
    sizes: Ints, numbers: Floats, keys: Keys, source: int, place: int, stamp: int,
    rates: Floats, at: int, groups: Ints32, present: Flags, lane: int, group_ids: Keys,
    heap: Floats, stamps: Ints, first: int,
) -> None:  # fmt: skip
    """Draw the counts of a site's groups and put them at the tops of their heaps."""
    slots, whole, count = sizes[_SLOTS], sizes[_WHOLE], sizes[_GROUPS]
    for group in range(count):
        if present[lane * count + group]:
            rate = _share(rates, at, groups, lane * slots, group, 0, slots)
            rate = rate if rate < numbers[_N_CAP] else numbers[_N_CAP]
            stream = _key(keys[_K_COUNT + source], sizes[_FRAME], group_ids[group])
            top = first + 2 * whole * group + 1
            heap[top] = poisson_exact(uniform(stream, place), rate)
            stamps[top] = stamp


@compiled
def _between(
    sizes: Ints, keys: Keys, source: int, counted: bool, place: int, stamp: int, begin: int,
    stop: int, rates: Floats, at: int, groups: Ints32, present: Flags, lane: int, group_ids: Keys,
    heap: Floats, stamps: Ints, first: int,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 at a site, of one source."""
    total = 0.0
    slots, whole, count = sizes[_SLOTS], sizes[_WHOLE], sizes[_GROUPS]
    if not counted:
        for n in range(begin, stop):
            total += rates[at + n]
        return total
    for group in range(count):
        if present[lane * count + group]:
            stream = _key(keys[_K_THIN + source], sizes[_FRAME], group_ids[group])
            total += _counted(
                heap, stamps, stamp, first + 2 * whole * group, begin, stop, slots, whole,
                rates, at, groups, lane * slots, group, stream, place,
            )  # fmt: skip
    return total


@compiled
def _kept_at(sizes: Ints, place: int) -> int:
    """Where the charge of a site is kept: next to those of its neighbours, never in their place."""
    if not sizes[_SMEARS]:
        return 0
    row, col = place // sizes[_COLS], place % sizes[_COLS]
    found: int = (row % 3) * sizes[_KEPT_COLS] + col % sizes[_KEPT_COLS]
    return found


@compiled
def _charge(
    sizes: Ints, numbers: Floats, keys: Keys, places: Ints, begin: int, stop: int,
    rates: Floats, groups: Ints32, present: Flags, lanes: Ints32, group_ids: Keys,
    heap: Floats, stamps: Ints,
) -> float:  # fmt: skip
    """The charge of the slots `begin` .. `stop` - 1 that falls on the pixel, smeared."""
    if begin >= stop:
        return 0.0
    slots, room = sizes[_SLOTS], 2 * sizes[_WHOLE] * sizes[_GROUPS]
    own, flow = 0.0, 0.0
    for site in range(SITES if sizes[_SMEARS] else 1):
        place = places[site]
        if place < 0:
            continue
        kept = 2 * _kept_at(sizes, place)
        total = _between(
            sizes, keys, 0, sizes[_SHOT] == 1, place, place, begin, stop, rates, kept * slots,
            groups, present, lanes[place], group_ids, heap, stamps, kept * room,
        )  # fmt: skip
        if sizes[_DARK]:
            total += _between(
                sizes, keys, 1, sizes[_DARK] == 1, place, place, begin, stop, rates,
                (kept + 1) * slots, groups, present, lanes[place], group_ids, heap, stamps,
                (kept + 1) * room,
            )  # fmt: skip
        if site == 0:
            own = total
        else:
            flow += total - own
    return own + numbers[_N_SMEAR] * flow if sizes[_SMEARS] else own


@compiled
def _lit(
    sizes: Ints, numbers: Floats, keys: Keys, place: int,
    frames: Frames, row_start: Ints, frame_index: Ints32, weight: Floats, slot_s: Floats,
    groups: Ints32, present: Flags, lanes: Ints32, group_ids: Keys,
    rates: Floats, heap: Floats, stamps: Ints,
) -> None:  # fmt: skip
    """The rates of a site, slot by slot, and the counts of its groups, where they are kept."""
    slots, pixels = sizes[_SLOTS], sizes[_ROWS] * sizes[_COLS]
    room = 2 * sizes[_WHOLE] * sizes[_GROUPS]
    response = 1.0
    if sizes[_UNEVEN]:
        response += numbers[_N_PRNU] * normal(uniform(keys[_K_PRNU], place))
        response = response if response > 0.0 else 0.0
    kept = 2 * _kept_at(sizes, place)
    at = kept * slots
    for n in range(slots):
        total = 0.0
        for k in range(row_start[n], row_start[n + 1]):
            total += float(frames[frame_index[k] * pixels + place]) * weight[k]
        rate = float(np.float32(total))
        rate = (rate + numbers[_N_LAG] * rate) * response
        rate = rate if rate > 0.0 else 0.0
        rates[at + n] = rate if rate < numbers[_N_CAP] else numbers[_N_CAP]
    if sizes[_SHOT]:
        _prepared(
            sizes, numbers, keys, 0, place, place, rates, at, groups, present, lanes[place],
            group_ids, heap, stamps, kept * room,
        )  # fmt: skip
    if sizes[_DARK]:
        at += slots
        z = normal(uniform(keys[_K_DARK], place))
        current = numbers[_N_DARK] * _log_normal(numbers[_N_DARK_VARIANCE], z)
        for n in range(slots):
            rates[at + n] = slot_s[n] * current
        if sizes[_DARK] == 1:
            _prepared(
                sizes, numbers, keys, 1, place, place, rates, at, groups, present, lanes[place],
                group_ids, heap, stamps, (kept + 1) * room,
            )  # fmt: skip


@compiled
def _missing(
    sizes: Ints, keys: Keys, place: int, first: int, stop: int, entries: Ints, weights: Floats,
    kind: int, missing: Floats,
) -> None:  # fmt: skip
    """What the draws of the words lack of the draws of the buckets: z - Q^T x."""
    buckets = sizes[_BUCKETS]
    for bucket in range(buckets):
        stream = _key(keys[_K_SUM + kind], sizes[_FRAME], np.uint64(bucket))
        missing[kind * buckets + bucket] = normal(uniform(stream, place))
    for e in range(first, stop):
        row = e * _E_COLUMNS
        for draw in range(_E_DRAWS):
            if not _draws(entries, row, kind, draw):
                continue
            number = np.uint64(_drawn_number(entries, row, kind, draw))
            stream = _key(keys[_K_PART + kind], sizes[_FRAME], number)
            x = normal(uniform(stream, place))
            for bucket in range(buckets):
                at = (e * _E_DRAWS + draw) * buckets + bucket
                missing[kind * buckets + bucket] -= weights[at] * x


@compiled
def _draws(entries: Ints, row: int, kind: int, draw: int) -> bool:
    """Whether a word has this draw of this kind of noise."""
    if kind == _RESET:
        return draw == 0 and entries[row + _E_RESETS] == 1
    if kind == _READ:
        return draw == 0 and entries[row + _E_READS_PIX] == 1
    return draw > 0 and draw <= entries[row + _E_DESTINATIONS]


@compiled
def _drawn_number(entries: Ints, row: int, kind: int, draw: int) -> int:
    """The number under which the reference draws it."""
    number: int = entries[row + _E_NUMBER]
    return number * _PART_DESTINATIONS + draw - 1 if kind == _ANALOG else number


@compiled
def _error(
    sizes: Ints, keys: Keys, place: int, e: int, entries: Ints, weights: Floats, kind: int,
    draw: int, missing: Floats,
) -> float:  # fmt: skip
    """The unit normal error of one draw of a word."""
    buckets = sizes[_BUCKETS]
    number = np.uint64(_drawn_number(entries, e * _E_COLUMNS, kind, draw))
    stream = _key(keys[_K_PART + kind], sizes[_FRAME], number)
    found = normal(uniform(stream, place))
    for bucket in range(buckets):
        at = (e * _E_DRAWS + draw) * buckets + bucket
        found += weights[at] * missing[kind * buckets + bucket]
    return found


@compiled
def _execute(
    sizes: Ints, numbers: Floats, keys: Keys, place: int, e: int, entries: Ints, divisor: float,
    weights: Floats, signs: Floats, missing: Floats, pattern: float, registers: Floats,
) -> None:  # fmt: skip
    """Run one word. PIX is register `REGISTERS`, its reset level the next one, then IN."""
    row, pix = e * _E_COLUMNS, sizes[_REGISTERS]
    if entries[row + _E_RESETS]:
        registers[pix] = 0.0
        if sizes[_RESETS]:
            z = _error(sizes, keys, place, e, entries, weights, _RESET, 0, missing)
            registers[pix + 1] = numbers[_N_RESET] * z
        return
    total = 0.0
    for i in range(entries[row + _E_SOURCES]):
        source = entries[row + _E_SOURCE + i]
        total += registers[source]
        if source == pix:
            total += registers[pix + 1]
            if sizes[_READS]:
                z = _error(sizes, keys, place, e, entries, weights, _READ, 0, missing)
                total += numbers[_N_READ] * z
    result = total / -divisor
    for i in range(entries[row + _E_DESTINATIONS]):
        register = entries[row + _E_DESTINATION + i]
        value = result
        if sizes[_WORDS]:
            error = pattern
            if sizes[_WORDS] == 1:
                z = _error(sizes, keys, place, e, entries, weights, _ANALOG, i + 1, missing)
                error += numbers[_N_NOISE] * z
            value = numbers[_N_GAIN] * value + signs[register] * error
        if sizes[_SOFT]:
            value = soft(value, numbers[_N_MIN], numbers[_N_MAX], numbers[_N_KNEE])
        registers[register] = value


def run_pixels(
    sizes: Ints, numbers: Floats, keys: Keys, chosen: Ints, lanes: Ints32,
    frames: Frames, row_start: Ints, frame_index: Ints32, weight: Floats,
    slot_s: Floats, start_s: Floats, groups: Ints32, present: Flags, group_ids: Keys,
    entry_start: Ints, entries: Ints, times: Floats, weights: Floats, signs: Floats,
    readout_register: Ints, readout: Floats,
    rates: Floats, heap: Floats, stamps: Ints, tags: Ints, missing: Floats, registers: Floats,
    places: Ints, out: Floats,
) -> None:  # fmt: skip
    """out[b * PIXELS + i] := the exposure of pixel chosen[i] in bucket b, in electrons.

    `lanes` (rows * cols): lane of each pixel. `groups` (lanes, N): index of the group of each slot;
    `present` (lanes, GROUPS); `group_ids`: what keys call them. `entries`: the words of lane l are
    rows entry_start[l] .. entry_start[l + 1]; `times` (entries, 2): end in parts of the slot, and
    divisor; `weights` (entries, draws, buckets): of the draws in the buckets. `readout` (buckets,
    2): gain, and seconds waited. From `rates` to `places`: scratch, `stamps` and `tags` once filled
    with -1. Places in rising order find most of their neighbours' charge already there.
    """
    slots, rows, cols = sizes[_SLOTS], sizes[_ROWS], sizes[_COLS]
    buckets, pix = sizes[_BUCKETS], sizes[_REGISTERS]
    well = numbers[_N_WELL]
    for i in range(sizes[0]):
        place = chosen[i]
        row, col = place // cols, place % cols
        places[0] = place
        places[1] = place - cols if row > 0 else -1
        places[2] = place + cols if row + 1 < rows else -1
        places[3] = place - 1 if col > 0 else -1
        places[4] = place + 1 if col + 1 < cols else -1
        for site in range(SITES if sizes[_SMEARS] else 1):
            if places[site] < 0:
                continue
            kept_at = _kept_at(sizes, places[site])
            if tags[kept_at] != places[site]:
                _lit(
                    sizes, numbers, keys, places[site], frames, row_start, frame_index, weight,
                    slot_s, groups, present, lanes, group_ids, rates, heap, stamps,
                )  # fmt: skip
                tags[kept_at] = places[site]
        lane = lanes[place]
        first, stop = entry_start[lane], entry_start[lane + 1]
        if sizes[_READS]:
            _missing(sizes, keys, place, first, stop, entries, weights, _READ, missing)
        if sizes[_RESETS]:
            _missing(sizes, keys, place, first, stop, entries, weights, _RESET, missing)
        pattern, leak = 0.0, 0.0
        if sizes[_WORDS] == 1:
            _missing(sizes, keys, place, first, stop, entries, weights, _ANALOG, missing)
        if sizes[_WORDS]:
            z = normal(uniform(keys[_K_PATTERN], place))
            pattern = numbers[_N_BIAS] + numbers[_N_PATTERN] * z
        if sizes[_LEAKS]:
            z = normal(uniform(keys[_K_LEAK], place))
            leak = numbers[_N_LEAK] * _log_normal(numbers[_N_LEAK_VARIANCE], z)
        for register in range(pix + 1):
            # PIX comes first in the stream of what registers hold at the start.
            stream = np.uint64(0 if register == pix else register + 1)
            held = uniform(_key(keys[_K_START], 0, stream), place) / 2.0
            registers[register] = held * (well if register == pix else numbers[_N_MAX])
        registers[pix + 1] = 0.0
        registers[pix + 2] = 0.0
        at, fallen = 0, 0.0
        for e in range(first, stop + 1):
            boundary = slots if e == stop else entries[e * _E_COLUMNS + _E_BOUNDARY]
            if e < stop and not entries[e * _E_COLUMNS + _E_ACTS]:
                continue
            if at < boundary:
                charge = _charge(
                    sizes, numbers, keys, places, at + 1, boundary, rates, groups, present,
                    lanes, group_ids, heap, stamps,
                )  # fmt: skip
                charge += (1.0 - fallen) * _charge(
                    sizes, numbers, keys, places, at, at + 1, rates, groups, present,
                    lanes, group_ids, heap, stamps,
                )  # fmt: skip
                registers[pix] += charge
                if sizes[_FULL_WELL] and registers[pix] > well:
                    registers[pix] = well
                if sizes[_LEAKS]:
                    kept = math.exp(-leak * (start_s[boundary] - start_s[at]))
                    for register in range(pix):
                        registers[register] *= kept
                at, fallen = boundary, 0.0
            if e == stop:
                break
            if sizes[_DEAD]:
                now = times[2 * e]
                slot = at if at < slots else slots - 1
                registers[pix] += (now - fallen) * _charge(
                    sizes, numbers, keys, places, slot, slot + 1, rates, groups, present,
                    lanes, group_ids, heap, stamps,
                )  # fmt: skip
                if sizes[_FULL_WELL] and registers[pix] > well:
                    registers[pix] = well
                fallen = now
            _execute(
                sizes, numbers, keys, place, e, entries, times[2 * e + 1], weights, signs, missing,
                pattern, registers,
            )  # fmt: skip
        for bucket in range(buckets):
            value = registers[readout_register[bucket]] * readout[2 * bucket]
            if sizes[_LEAKS]:
                value *= math.exp(-leak * readout[2 * bucket + 1])
            out[bucket * sizes[0] + i] = value + 0.0


_POINTERS = {
    Ints: "int64", Floats: "float64", Keys: "uint64", Ints32: "int32", Frames: "float32",
    Flags: "uint8",
}  # fmt: skip
_TYPES = (
    Ints, Floats, Keys, Ints, Ints32, Frames, Ints, Ints32, Floats, Floats, Floats, Ints32, Flags,
    Keys, Ints, Ints, Floats, Floats, Floats, Ints, Floats, Floats, Floats, Ints, Ints, Floats,
    Floats, Ints, Floats,
)  # fmt: skip
SIGNATURE = f"void({', '.join(f'CPointer({_POINTERS[kind]})' for kind in _TYPES)})"
"""The types of `run_pixels`'s parameters, for numba."""
