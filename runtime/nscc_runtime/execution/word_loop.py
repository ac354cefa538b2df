"""What analog words do to pixels: the reference's words, compiled.

Two loops run pixels through words: `nscc_runtime.execution.pixel_loop` those of fixed shutters, one
by one, and `nscc_runtime.looking.way_loop` those that look, in blocks. They bring charge to PIX and
draw the normal numbers of a word before it runs here. The register r of pixel i of a block is at
r * `block` + i; `block` and `count`, how many pixels run the word, are constants where pixels come
one by one, and all of this is inlined for that.
"""

from __future__ import annotations

import math

import numpy as np

from nscc_runtime.effects.registry import in_loop
from nscc_runtime.execution.layout import (
    Fixed,
    Held,
    Numbers,
    Program,
    Readouts,
    Result,
    Switches,
    Word,
)
from nscc_runtime.loop import Bytes, Floats, inlined

ADDED, SUBTRACTED, LEVEL = 1, 2, 4
"""Of what a register holds: it has a full PIX in it, or that of a reset's level."""
_bent = in_loop("bends")
"""What a register holds of a value, by the effect that bends it."""


@inlined
def begin(switches: Switches, block: int, held: Held, i: int) -> None:
    """What the registers of pixel i of a block hold when a frame begins: nothing."""
    for register in range(switches.registers + 2):
        at = register * block + i
        held.value[at], held.since_s[at], held.lost[at], held.full[at] = 0.0, 0.0, 0.0, 0
    held.since_s[switches.registers * block + i] = -1.0
    held.level[i] = 0.0


@inlined
def fill(switches: Switches, numbers: Numbers, held: Held, at: int, charge_e: float) -> None:
    """Charge falls on the PIX at `at`."""
    total = held.value[at] + charge_e
    if switches.holds and total > numbers.well:
        total = numbers.well
        held.full[at] = ADDED
    held.value[at] = total


@inlined
def reset(
    switches: Switches, numbers: Numbers, word: Word, block: int, count: int, held: Held,
    result: Result, normals: Floats, first: int,
) -> None:  # fmt: skip
    """PIX is emptied; its error is normals[first + j]."""
    for j in range(count):
        i = result.some[j]
        at = switches.registers * block + i
        held.value[at], held.full[at], held.since_s[at] = 0.0, 0, word.time_s
        held.level[i] = 0.0
        if switches.reset_errors:
            held.level[i] = numbers.reset_error * normals[first + j]


@inlined
def add(
    switches: Switches, numbers: Numbers, word: Word, block: int, count: int, program: Program,
    fixed: Fixed, held: Held, result: Result, normals: Floats, first: int,
) -> None:  # fmt: skip
    """The sum of a word's sources, what they have lost, and which full PIX is in it; the error of a
    read is normals[first + j]."""
    some, total, pix = result.some, result.total, switches.registers
    for j in range(count):
        total[j], result.lost[j], result.full[j] = 0.0, 0.0, 0
    for s in range(word.sources):
        source = program.operands[word.operands + s]
        if source == pix:
            for j in range(count):
                noise = numbers.read_error * normals[first + j] if switches.read_errors else 0.0
                at = pix * block + some[j]
                charge, full = held.value[at], held.full[at]
                if held.since_s[at] == word.time_s:
                    full = full | LEVEL if switches.lit_level and full else 0
                    charge = charge if switches.lit_level else 0.0
                total[j] += charge + held.level[some[j]] + noise
                result.full[j] |= full
        elif source > pix:
            for j in range(count):
                total[j] += word.in_e
        else:
            for j in range(count):
                at = source * block + some[j]
                value = held.value[at]
                if switches.leaks and held.since_s[at] != word.time_s:
                    age_s = word.time_s - held.since_s[at]
                    value *= math.exp(-fixed.leak[some[j]] * age_s)
                total[j] += value
            if switches.holds or switches.bends:
                for j in range(count):
                    at = source * block + some[j]
                    result.full[j] |= held.full[at]
                    result.lost[j] += held.lost[at]


@inlined
def compare(
    switches: Switches, numbers: Numbers, block: int, count: int, fixed: Fixed, result: Result,
    normals: Floats, first: int,
) -> None:  # fmt: skip
    """result.total := what a comparison with 0 sees of it; its error is normals[first + j]."""
    if switches.compares_off:
        for j in range(count):
            result.total[j] += fixed.offset[result.some[j]]
    if switches.compares_noisy:
        for j in range(count):
            result.total[j] += numbers.compare_noise * normals[first + j]


@inlined
def write(
    switches: Switches, numbers: Numbers, word: Word, block: int, count: int, program: Program,
    fixed: Fixed, held: Held, result: Result, normals: Floats, first: int, step: int,
) -> None:  # fmt: skip
    """The destinations of a bus word get its result; the error of number d is
    normals[first + d * step + j]."""
    for j in range(count):
        # What is added of the negative was subtracted.
        full = result.full[j]
        exchanged = (full & ADDED) * SUBTRACTED | (full & SUBTRACTED) // SUBTRACTED
        result.full[j] = exchanged | full & LEVEL
    for d in range(word.destinations):
        register = program.operands[word.operands + word.sources + d]
        for j in range(count):
            i, lost_e = result.some[j], result.lost[j] / word.divisor
            value = result.total[j] / -word.divisor
            if switches.word_errors:
                error = fixed.pattern[i] + numbers.word_error * normals[first + d * step + j]
                value = numbers.gain * value + program.signs[register] * error
            if switches.bends:
                bent = _bent(value, numbers.lowest, numbers.highest, numbers.knee)
                lost_e += abs(value - bent)
                value = bent
            at = register * block + i
            held.value[at], held.since_s[at] = value, word.time_s
            held.lost[at], held.full[at] = lost_e, result.full[j]


@inlined
def read_out(
    switches: Switches, numbers: Numbers, block: int, count: int, readouts: Readouts, fixed: Fixed,
    held: Held, pixels: int, first: int, out: Floats, marked: Bytes,
) -> None:  # fmt: skip
    """The exposures of a block whose pixels are number `first` and following of `pixels`: what its
    registers hold when their turn has come. And `marked`, what cut them off."""
    for bucket in range(switches.buckets):
        gain = readouts.gain[bucket]
        negative = gain < 0.0
        when_s = numbers.frame_s + readouts.wait_s[bucket]
        for i in range(count):
            at = readouts.register[bucket] * block + i
            value = held.value[at] * gain
            if switches.leaks:
                value *= math.exp(-fixed.leak[i] * (when_s - held.since_s[at]))
            found = switches.registers_bit if held.lost[at] > numbers.least_lost else 0
            if held.full[at] & ADDED:
                found |= switches.subtracted_bit if negative else switches.well_bit
            if held.full[at] & SUBTRACTED:
                found |= switches.well_bit if negative else switches.subtracted_bit
            if held.full[at] & LEVEL:
                found |= switches.level_bit
            out[bucket * pixels + first + i] = value + 0.0
            marked[bucket * pixels + first + i] = np.uint8(found)
