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

from nscc_runtime.noise.counter import compiled
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.loops import uniform
from nscc_runtime.plan.charge_loop import (
    SITES,
    Flags,
    Floats,
    Frames,
    Ints,
    Ints32,
    Keys,
    charge,
    kept_at,
    lit,
    log_normal,
    stream_key,
)
from nscc_runtime.plan.layout import ENTRY_COLUMNS, MOST_DESTINATIONS, Entry, Key, Number, Size

_PART_DESTINATIONS = 4
_READ, _RESET, _ANALOG = 0, 1, 2

# numba takes enum members for what they are only as plain numbers.
_S = {member.name: int(member) for member in Size}
_SLOTS, _ROWS, _COLS, _BUCKETS = _S["SLOTS"], _S["ROWS"], _S["COLS"], _S["BUCKETS"]
_REGISTERS, _FRAME, _FULL_WELL = _S["REGISTERS"], _S["FRAME"], _S["FULL_WELL"]
_READS, _RESETS, _DEAD, _WORDS = _S["READ"], _S["RESET"], _S["DEAD_TIME"], _S["ANALOG"]
_SOFT, _LEAKS, _SMEARS = _S["REGISTER"], _S["LEAKAGE"], _S["CROSSTALK"]
_N = {member.name: int(member) for member in Number}
_N_WELL, _N_MIN, _N_MAX = _N["FULL_WELL"], _N["REGISTER_MIN"], _N["REGISTER_MAX"]
_N_KNEE, _N_READ, _N_RESET, _N_GAIN = _N["KNEE"], _N["READ"], _N["RESET"], _N["GAIN"]
_N_NOISE, _N_PATTERN, _N_BIAS = _N["ANALOG_NOISE"], _N["PATTERN"], _N["BIAS"]
_N_LEAK, _N_LEAK_VARIANCE = _N["LEAK"], _N["LEAK_VARIANCE"]
_K = {member.name: int(member) for member in Key}
_K_START, _K_PATTERN, _K_LEAK = _K["START"], _K["PATTERN"], _K["LEAK"]
_K_SUM, _K_PART = _K["SUM"], _K["PART"]
_E = {member.name: int(member) for member in Entry}
_E_BOUNDARY, _E_RESETS, _E_ACTS, _E_NUMBER = (
    _E["BOUNDARY"], _E["RESETS"], _E["ACTS"], _E["NUMBER"],
)  # fmt: skip
_E_READS_PIX, _E_SOURCES, _E_DESTINATIONS = _E["READS_PIX"], _E["SOURCES"], _E["DESTINATIONS"]
_E_SOURCE, _E_DESTINATION = _E["FIRST_SOURCE"], _E["FIRST_DESTINATION"]
_E_COLUMNS, _E_DRAWS = ENTRY_COLUMNS, 1 + MOST_DESTINATIONS


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
def _missing(
    sizes: Ints, keys: Keys, place: int, first: int, stop: int, entries: Ints, weights: Floats,
    kind: int, missing: Floats,
) -> None:  # fmt: skip
    """What the draws of the words lack of the draws of the buckets: z - Q^T x."""
    buckets = sizes[_BUCKETS]
    for bucket in range(buckets):
        stream = stream_key(keys[_K_SUM + kind], sizes[_FRAME], np.uint64(bucket))
        missing[kind * buckets + bucket] = normal(uniform(stream, place))
    for e in range(first, stop):
        row = e * _E_COLUMNS
        for draw in range(_E_DRAWS):
            if not _draws(entries, row, kind, draw):
                continue
            number = np.uint64(_drawn_number(entries, row, kind, draw))
            stream = stream_key(keys[_K_PART + kind], sizes[_FRAME], number)
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
    stream = stream_key(keys[_K_PART + kind], sizes[_FRAME], number)
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
            site_at = kept_at(sizes, places[site])
            if tags[site_at] != places[site]:
                lit(
                    sizes, numbers, keys, places[site], frames, row_start, frame_index, weight,
                    slot_s, groups, present, lanes, group_ids, rates, heap, stamps,
                )  # fmt: skip
                tags[site_at] = places[site]
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
            leak = numbers[_N_LEAK] * log_normal(numbers[_N_LEAK_VARIANCE], z)
        for register in range(pix + 1):
            # PIX comes first in the stream of what registers hold at the start.
            stream = np.uint64(0 if register == pix else register + 1)
            held = uniform(stream_key(keys[_K_START], 0, stream), place) / 2.0
            registers[register] = held * (well if register == pix else numbers[_N_MAX])
        registers[pix + 1] = 0.0
        registers[pix + 2] = 0.0
        at, fallen = 0, 0.0
        for e in range(first, stop + 1):
            boundary = slots if e == stop else entries[e * _E_COLUMNS + _E_BOUNDARY]
            if e < stop and not entries[e * _E_COLUMNS + _E_ACTS]:
                continue
            if at < boundary:
                fallen_e = charge(
                    sizes, numbers, keys, places, at + 1, boundary, rates, groups, present,
                    lanes, group_ids, heap, stamps,
                )  # fmt: skip
                fallen_e += (1.0 - fallen) * charge(
                    sizes, numbers, keys, places, at, at + 1, rates, groups, present,
                    lanes, group_ids, heap, stamps,
                )  # fmt: skip
                registers[pix] += fallen_e
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
                registers[pix] += (now - fallen) * charge(
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
