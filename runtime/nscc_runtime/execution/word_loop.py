"""The effect of analog words on pixels: the reference's words, compiled.

Two loops run pixels through words: `nscc_runtime.execution.pixel_loop` runs single pixels with
fixed shutters, and `nscc_runtime.looking.path_loop` runs blocks of pixels that look. Both add
charge to PIX and draw the normal numbers of a word before they call these functions. Register r of
pixel i of a block is at index r * `block` + i. `count` is the number of pixels that run the word.
`block` and `count` are constants for single pixels, so everything here is inlined."""

from __future__ import annotations

import math

import numpy as np

from nscc_runtime.effects.registry import in_loop
from nscc_runtime.execution.layout import (
    Fixed,
    LoopProgram,
    LoopWord,
    Numbers,
    Readouts,
    RegisterContents,
    Switches,
    WordResult,
)
from nscc_runtime.loop import Bytes, Floats, inlined

ADDED, SUBTRACTED, LEVEL = 1, 2, 4
"""Saturation marks of a register: it contains a full PIX with positive or negative sign, or a full
PIX in the level of a reset."""
_bent = in_loop("bends")
"""The function in loops for soft saturation of a register."""


@inlined
def begin(switches: Switches, block: int, contents: RegisterContents, i: int) -> None:
    """Empty the registers of pixel i of a block at the start of a frame."""
    for register in range(switches.registers + 2):
        at = register * block + i
        contents.value[at], contents.since_s[at], contents.lost_e[at], contents.full[at] = (
            0.0,
            0.0,
            0.0,
            0,
        )
    contents.since_s[switches.registers * block + i] = -1.0
    contents.level[i] = 0.0


@inlined
def fill(
    switches: Switches, numbers: Numbers, contents: RegisterContents, at: int, charge_e: float
) -> None:
    """Add charge to the PIX at index `at`."""
    total = contents.value[at] + charge_e
    if switches.holds and total > numbers.well:
        total = numbers.well
        contents.full[at] = ADDED
    contents.value[at] = total


@inlined
def reset(
    switches: Switches, numbers: Numbers, word: LoopWord, block: int, count: int, contents:
    RegisterContents, result: WordResult, normals: Floats, first: int,
) -> None:  # fmt: skip
    """Reset PIX; the error of pixel j is normals[first + j]."""
    for j in range(count):
        i = result.pixels[j]
        at = switches.registers * block + i
        contents.value[at], contents.full[at], contents.since_s[at] = 0.0, 0, word.time_s
        contents.level[i] = 0.0
        if switches.reset_errors:
            contents.level[i] = numbers.reset_error * normals[first + j]


@inlined
def add(
    switches: Switches, numbers: Numbers, word: LoopWord, block: int, count: int, program:
    LoopProgram, fixed: Fixed, contents: RegisterContents, result: WordResult, normals: Floats,
    first: int,
) -> None:  # fmt: skip
    """Set `result` to the sum of a word's sources, their losses and their marks; the error of a
    read is normals[first + j]."""
    pixels, total, pix = result.pixels, result.total, switches.registers
    for j in range(count):
        total[j], result.lost_e[j], result.full[j] = 0.0, 0.0, 0
    for s in range(word.sources):
        source = program.operands[word.operands + s]
        if source == pix:
            for j in range(count):
                noise = numbers.read_error * normals[first + j] if switches.read_errors else 0.0
                at = pix * block + pixels[j]
                charge, full = contents.value[at], contents.full[at]
                if contents.since_s[at] == word.time_s:
                    full = full | LEVEL if switches.lit_level and full else 0
                    charge = charge if switches.lit_level else 0.0
                total[j] += charge + contents.level[pixels[j]] + noise
                result.full[j] |= full
        elif source > pix:
            for j in range(count):
                total[j] += word.in_e
        else:
            for j in range(count):
                at = source * block + pixels[j]
                value = contents.value[at]
                if switches.leaks and contents.since_s[at] != word.time_s:
                    age_s = word.time_s - contents.since_s[at]
                    value *= math.exp(-fixed.leak[pixels[j]] * age_s)
                total[j] += value
            if switches.holds or switches.bends:
                for j in range(count):
                    at = source * block + pixels[j]
                    result.full[j] |= contents.full[at]
                    result.lost_e[j] += contents.lost_e[at]


@inlined
def compare(
    switches: Switches, numbers: Numbers, block: int, count: int, fixed: Fixed, result: WordResult,
    normals: Floats, first: int,
) -> None:  # fmt: skip
    """Add the comparator's errors to result.total; its noise is normals[first + j]."""
    if switches.compares_off:
        for j in range(count):
            result.total[j] += fixed.offset[result.pixels[j]]
    if switches.compares_noisy:
        for j in range(count):
            result.total[j] += numbers.compare_noise * normals[first + j]


@inlined
def write(
    switches: Switches, numbers: Numbers, word: LoopWord, block: int, count: int, program:
    LoopProgram, fixed: Fixed, contents: RegisterContents, result: WordResult, normals: Floats,
    first: int, step: int,
) -> None:  # fmt: skip
    """Write a bus word's result to its destinations d, each with the error normals[first + d * step
    + j]."""
    for j in range(count):
        # A bus word negates, so added and subtracted are exchanged.
        full = result.full[j]
        exchanged = (full & ADDED) * SUBTRACTED | (full & SUBTRACTED) // SUBTRACTED
        result.full[j] = exchanged | full & LEVEL
    for d in range(word.destinations):
        register = program.operands[word.operands + word.sources + d]
        for j in range(count):
            i, lost_e = result.pixels[j], result.lost_e[j] / word.divisor
            value = result.total[j] / -word.divisor
            if switches.word_errors:
                error = fixed.pattern[i] + numbers.word_error * normals[first + d * step + j]
                value = numbers.gain * value + program.signs[register] * error
            if switches.bends:
                bent = _bent(value, numbers.lowest, numbers.highest, numbers.knee)
                lost_e += abs(value - bent)
                value = bent
            at = register * block + i
            contents.value[at], contents.since_s[at] = value, word.time_s
            contents.lost_e[at], contents.full[at] = lost_e, result.full[j]


@inlined
def read_out(
    switches: Switches, numbers: Numbers, block: int, count: int, readouts: Readouts, fixed: Fixed,
    contents: RegisterContents, pixels: int, first: int, out: Floats, marked: Bytes,
) -> None:  # fmt: skip
    """Read out the pixels of a block into `out` (electrons) and `marked` (saturation marks), from
    pixel number `first` of `pixels` on."""
    for bucket in range(switches.buckets):
        gain = readouts.gain[bucket]
        negative = gain < 0.0
        when_s = numbers.frame_s + readouts.wait_s[bucket]
        for i in range(count):
            at = readouts.register[bucket] * block + i
            value = contents.value[at] * gain
            if switches.leaks:
                value *= math.exp(-fixed.leak[i] * (when_s - contents.since_s[at]))
            mark = switches.registers_bit if contents.lost_e[at] > numbers.least_lost else 0
            if contents.full[at] & ADDED:
                mark |= switches.subtracted_bit if negative else switches.well_bit
            if contents.full[at] & SUBTRACTED:
                mark |= switches.well_bit if negative else switches.subtracted_bit
            if contents.full[at] & LEVEL:
                mark |= switches.level_bit
            out[bucket * pixels + first + i] = value + 0.0
            marked[bucket * pixels + first + i] = np.uint8(mark)
