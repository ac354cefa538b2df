"""The loop that runs the words for single pixels: the reference, compiled, event by event.

It does what `nscc_runtime.reference` does with the same keyed numbers, but moves from word to word
instead of from slot to slot: charge between two words is found by halving counts
(`nscc_runtime.noise.thin`), so a program of few words costs little however many slots it has.

`nscc_runtime.execution.pixels` makes what it is given.
"""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np

from nscc_runtime.effects.registry import in_loop
from nscc_runtime.effects.spread import log_normal_in_loop
from nscc_runtime.execution.charge_loop import (
    charge,
    charge_evenly,
    least_charge,
    stream_key,
    streams_of,
)
from nscc_runtime.execution.error_loop import READS, RESETS, WORDS, Entries, error_of, missing_of
from nscc_runtime.execution.layout import ACTS, SEEN, Entry, Keys, Numbers, Sizes
from nscc_runtime.loop import Bytes, Floats, Ints, Ints32, Words, Written, compiled, loop
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.noise_loops import uniform

_ADDED, _SUBTRACTED, _LEVEL, _OLD = 1, 2, 4, 8
"""Of what a register holds: it has a full PIX in it, or that of a reset's level; or it is the part
that is left of what it held when the frame began."""
_bent = in_loop("bends")
"""What a register holds of a value, by the effect that bends it."""


@compiled
def _held(
    numbers: Numbers, keys: Keys, place: int, register: int, registers: Floats, full: Ints
) -> float:  # fmt: skip
    """What a register holds."""
    if full[register] & _OLD:
        stream = stream_key(keys.start, 0, np.uint64(register + 1))
        registers[register] *= uniform(stream, place) / 2.0 * numbers.register_start
        full[register] = 0
    held: float = registers[register]
    return held


@compiled
def _execute(
    sizes: Sizes, numbers: Numbers, keys: Keys, place: int, e: int, first: int,
    entry: Entry, operands: Ints, weights: Floats, signs: Floats, missing: Floats, drawn: Floats,
    pattern: float, registers: Floats, full: Ints, lost: Floats, fresh: bool,
) -> None:  # fmt: skip
    """Run one word. PIX is register `registers`, its reset level the next one, then IN. `fresh`:
    PIX was reset at this boundary."""
    pix = sizes.registers
    unseen = fresh and not sizes.lit_level
    if entry.resets:
        registers[pix] = 0.0
        full[pix] = 0
        if sizes.reset_errors:
            z = error_of(sizes, e, first, weights, RESETS, 0, missing, drawn)
            registers[pix + 1] = numbers.reset_error * z
        return
    total, gathered, lost_e = 0.0, 0, 0.0
    for i in range(entry.sources):
        source = operands[entry.operands + i]
        if not (source == pix and unseen):
            total += _held(numbers, keys, place, source, registers, full)
            gathered |= full[source]
            if source == pix and fresh and full[source]:
                gathered |= _LEVEL
        lost_e += lost[source]
        if source == pix:
            total += registers[pix + 1]
            if sizes.read_errors:
                z = error_of(sizes, e, first, weights, READS, 0, missing, drawn)
                total += numbers.read_error * z
    result = total / -entry.divisor
    lost_e /= entry.divisor
    for i in range(entry.destinations):
        register = operands[entry.operands + entry.sources + i]
        value, here_e = result, lost_e
        if sizes.word_errors:
            z = error_of(sizes, e, first, weights, WORDS, i + 1, missing, drawn)
            error = pattern + numbers.word_error * z
            value = numbers.gain * value + signs[register] * error
        if sizes.bends:
            held = _bent(value, numbers.lowest, numbers.highest, numbers.knee)
            here_e += abs(value - held)
            value = held
        registers[register] = value
        # What is added of the negative was subtracted.
        exchanged = (gathered & _ADDED) * _SUBTRACTED | (gathered & _SUBTRACTED) // _SUBTRACTED
        full[register] = exchanged | gathered & _LEVEL
        lost[register] = here_e


@compiled
def _surround(sizes: Sizes, place: int, places: Ints) -> None:
    """places := the pixel and its neighbours up, down, left and right; -1 where there is none."""
    rows, cols = sizes.rows, sizes.cols
    row, col = place // cols, place % cols
    places[0] = place
    places[1] = place - cols if row > 0 else -1
    places[2] = place + cols if row + 1 < rows else -1
    places[3] = place - 1 if col > 0 else -1
    places[4] = place + 1 if col + 1 < cols else -1


@compiled
def _begin(
    sizes: Sizes, numbers: Numbers, keys: Keys, place: int, registers: Floats, full: Ints,
    lost: Floats,
) -> None:  # fmt: skip
    """What registers hold when a frame begins."""
    pix = sizes.registers
    for register in range(pix):
        # Most are written before they are read: what they held is drawn when somebody asks.
        registers[register], full[register], lost[register] = 1.0, _OLD, 0.0
    for register in range(pix, pix + 3):
        registers[register], full[register], lost[register] = 0.0, 0, 0.0
    held = uniform(stream_key(keys.start, 0, np.uint64(0)), place) / 2.0
    registers[pix] = held * numbers.pix_start


@compiled
def _fall(
    sizes: Sizes, numbers: Numbers, charge_e: float, registers: Floats, full: Ints
) -> None:  # fmt: skip
    """Charge falls on PIX."""
    pix = sizes.registers
    registers[pix] += charge_e
    if sizes.holds and registers[pix] > numbers.well:
        registers[pix] = numbers.well
        full[pix] = _ADDED


@compiled
def _of_slot(
    sizes: Sizes, numbers: Numbers, places: Ints, n: int, sites: Ints32, rows: Ints,
    scales: Floats, sums: Floats, away: Floats, of_group: Ints, streams: Words, heap: Floats,
    stamps: Ints,
) -> float:  # fmt: skip
    """The charge of one slot, of which words see a part."""
    if sizes.given:
        return charge_evenly(
            sizes, numbers, places, n, n + 1, sites, rows, scales, sums, away, of_group
        )
    return charge(
        sizes, numbers, places, n, n + 1, sites, rows, scales, sums, away, of_group, streams,
        heap, stamps,
    )  # fmt: skip


@compiled
def _fallen(
    sizes: Sizes, numbers: Numbers, places: Ints, at: int, stop: int, gone: float,
    of_slot: float, sites: Ints32, rows: Ints, scales: Floats, sums: Floats, away: Floats,
    of_group: Ints, streams: Words, heap: Floats, stamps: Ints, held: float,
) -> float:  # fmt: skip
    """The charge of the slots `at` .. `stop` - 1 less a part `gone` of the first, whose charge is
    `of_slot`; or so much that PIX, which holds `held`, is full with it for sure."""
    begin = at if gone == 0.0 else at + 1
    if sizes.holds:
        least = least_charge(sizes, numbers, places[0], begin, stop, sites, rows, scales, sums)
        if held + least > numbers.well:
            return 2.0 * numbers.well
    if sizes.given:
        # The whole run of slots is seldom a part of a group: nothing has to be halved.
        begin = at
    found = charge(
        sizes, numbers, places, begin, stop, sites, rows, scales, sums, away, of_group, streams,
        heap, stamps,
    )  # fmt: skip
    if gone == 0.0:
        return found
    found += (0.0 if sizes.given else of_slot) - gone * of_slot
    return found if found > 0.0 else 0.0


@compiled
def _run(
    sizes: Sizes, numbers: Numbers, keys: Keys, place: int, leak: float,
    first: int, stop: int, start_s: Floats, entry_of: Ints32, flags: Bytes, entries: Entries,
    operands: Ints, weights: Floats, signs: Floats, sites: Ints32, rows: Ints, scales: Floats,
    sums: Floats, away: Floats,
    of_group: Ints, streams: Words, heap: Floats, stamps: Ints, missing: Floats, drawn: Floats,
    registers: Floats, full: Ints, lost: Floats, places: Ints,
) -> None:  # fmt: skip
    """Run a pixel through its words, the charge of the slots falling meanwhile."""
    slots, pix, pattern = sizes.slots, sizes.registers, 0.0
    if sizes.word_errors:
        z = normal(uniform(keys.pattern, place))
        pattern = numbers.bias + numbers.pattern * z
    at, fallen, fresh = 0, 0.0, False
    single, of_single = -1, 0.0
    for e in range(first, stop + 1):
        # Behind the last word stands the end of the frame: nothing is asked of `entry` there.
        entry, flag = entries[entry_of[e]], flags[e] if e < stop else 0
        boundary = slots if e == stop else entry.boundary
        if e < stop and not flag & ACTS:
            continue
        # Of charge that nothing reads before PIX is reset, or the frame ends, nothing is asked; nor
        # of what falls on a PIX that is full.
        seen = flag & SEEN > 0
        if at < boundary:
            if seen and not full[pix] & _ADDED:
                if fallen > 0.0 and single != at:
                    single, of_single = at, _of_slot(
                        sizes, numbers, places, at, sites, rows, scales, sums, away, of_group,
                        streams, heap, stamps,
                    )  # fmt: skip
                fallen_e = _fallen(
                    sizes, numbers, places, at, boundary, fallen, of_single, sites, rows,
                    scales, sums, away, of_group, streams, heap, stamps, registers[pix],
                )  # fmt: skip
                _fall(sizes, numbers, fallen_e, registers, full)
            if sizes.leaks:
                kept = math.exp(-leak * (start_s[boundary] - start_s[at]))
                for register in range(sizes.registers):
                    registers[register] *= kept
            at, fallen, fresh = boundary, 0.0, False
        if e == stop:
            break
        if sizes.slow_words:
            now = entry.end
            if seen and not full[pix] & _ADDED and now > fallen:
                slot = at if at < slots else slots - 1
                if single != slot:
                    single, of_single = slot, _of_slot(
                        sizes, numbers, places, slot, sites, rows, scales, sums, away, of_group,
                        streams, heap, stamps,
                    )  # fmt: skip
                _fall(sizes, numbers, (now - fallen) * of_single, registers, full)
            fallen = now
        _execute(
            sizes, numbers, keys, place, e, first, entry, operands, weights, signs, missing,
            drawn, pattern, registers, full, lost, fresh,
        )  # fmt: skip
        fresh = fresh or entry.resets == 1


@compiled
def _read_out(
    sizes: Sizes, numbers: Numbers, keys: Keys, place: int, at: int, leak: float,
    readout_register: Ints, readout_gain: Floats, readout_wait_s: Floats, registers: Floats,
    full: Ints, lost: Floats, out: Floats, marked: Bytes,
) -> None:  # fmt: skip
    """out[at + bucket * pixels] := the exposures of a pixel: what its registers hold when their
    turn has come."""
    for bucket in range(sizes.buckets):
        register = readout_register[bucket]
        value = _held(numbers, keys, place, register, registers, full) * readout_gain[bucket]
        negative = readout_gain[bucket] < 0.0
        bits = sizes.registers_bit if lost[register] > numbers.least_lost else 0
        if full[register] & _ADDED:
            bits |= sizes.subtracted_bit if negative else sizes.well_bit
        if full[register] & _SUBTRACTED:
            bits |= sizes.well_bit if negative else sizes.subtracted_bit
        if full[register] & _LEVEL:
            bits |= sizes.level_bit
        marked[at + bucket * sizes.pixels] = np.uint8(bits)
        if sizes.leaks:
            value *= math.exp(-leak * readout_wait_s[bucket])
        out[at + bucket * sizes.pixels] = value + 0.0


@loop
def run_pixels(
    sizes: Sizes,
    numbers: Numbers,
    keys: Keys,
    chosen: Annotated[Ints, "pixels"],
    lanes: Annotated[Ints32, "rows cols"],
    sites: Annotated[Ints32, "rows cols"],
    rows: Ints,
    scales: Floats,
    sums: Floats,
    away: Floats,
    of_group: Annotated[Ints, "groups"],
    start_s: Annotated[Floats, "slots+1"],
    group_ids: Annotated[Words, "groups"],
    entry_start: Annotated[Ints, "lanes+1"],
    entry_of: Annotated[Ints32, "listed+1"],
    flags: Annotated[Bytes, "listed"],
    entries: Entries,
    operands: Ints,
    weights: Annotated[Floats, "listed draws buckets"],
    signs: Annotated[Floats, "registers+1"],
    readout_register: Annotated[Ints, "buckets"],
    readout_gain: Annotated[Floats, "buckets"],
    readout_wait_s: Annotated[Floats, "buckets"],
    streams: Written[Words],
    found: Written[Words],
    heap: Written[Floats],
    stamps: Written[Ints],
    missing: Written[Floats],
    drawn: Written[Floats],
    draws: Written[Ints],
    draw_keys: Written[Words],
    normals: Written[Floats],
    registers: Written[Annotated[Floats, "registers+3"]],
    full: Written[Annotated[Ints, "registers+3"]],
    lost: Written[Annotated[Floats, "registers+3"]],
    places: Written[Ints],
    out: Written[Annotated[Floats, "buckets pixels"]],
    marked: Written[Annotated[Bytes, "buckets pixels"]],
) -> None:
    """out[b, i] := the exposure of pixel chosen[i] in bucket b, in electrons, and marked[b, i] what
    cut it off.

    `lanes`: the lane of each pixel. `sites`: the number of each place in `rows` and `scales`, see
    `nscc_runtime.execution.charge_loop`. `group_ids`: what keys call the groups of slots;
    `away` (counted groups, pixels), if neighbours' counts are given: how far they are from their
    means, `of_group` says in which row, -1 in none. The words of lane l stand at entry_start[l] ..
    entry_start[l + 1] - 1 of `entry_of`, which says where they are in `entries`, of `flags`, and of
    `weights`, those of their draws in the buckets. From `streams` to `places`: scratch, `found`
    once filled with 0, `stamps` with -1. Places in rising order find most of their neighbours'
    counts already there.
    """
    streams_of(sizes, keys, group_ids, streams)
    for i in range(sizes.pixels):
        place, lane = chosen[i], lanes[chosen[i]]
        _surround(sizes, place, places)
        first, stop = entry_start[lane], entry_start[lane + 1]
        if sizes.read_errors:
            missing_of(
                sizes, keys.sum_reads, keys.part_reads, place, first, stop, entry_of, entries,
                weights, READS, missing, drawn, found, draws, draw_keys, normals,
            )  # fmt: skip
        if sizes.reset_errors:
            missing_of(
                sizes, keys.sum_resets, keys.part_resets, place, first, stop, entry_of, entries,
                weights, RESETS, missing, drawn, found, draws, draw_keys, normals,
            )  # fmt: skip
        leak = 0.0
        if sizes.word_errors:
            missing_of(
                sizes, keys.sum_words, keys.part_words, place, first, stop, entry_of, entries,
                weights, WORDS, missing, drawn, found, draws, draw_keys, normals,
            )  # fmt: skip
        if sizes.leaks:
            z = normal(uniform(keys.leak, place))
            leak = numbers.leak * log_normal_in_loop(numbers.leak_variance, z)
        _begin(sizes, numbers, keys, place, registers, full, lost)
        _run(
            sizes, numbers, keys, place, leak, first, stop, start_s, entry_of, flags, entries,
            operands, weights, signs, sites, rows, scales, sums, away, of_group, streams, heap,
            stamps, missing, drawn, registers, full, lost, places,
        )  # fmt: skip
        _read_out(
            sizes, numbers, keys, place, i, leak, readout_register, readout_gain, readout_wait_s,
            registers, full, lost, out, marked,
        )  # fmt: skip
