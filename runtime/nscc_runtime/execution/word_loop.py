"""The effect of analog words on pixels: the reference's words, compiled.

`nscc_runtime.execution.block_loop` adds charge to PIX and draws the normal numbers of a word before
it calls these functions. Register r of pixel i of a block is at index r * `WORD_BLOCK` + i. `count`
is the number of pixels that run the word; `state.running` names them."""

from __future__ import annotations

import math

import numpy as np

from nscc.arrays import Bytes, Floats, Ints
from nscc_runtime.effects.spread import soft_in_loop
from nscc_runtime.execution.layout import (
    WORD_BLOCK,
    LoopProgram,
    LoopWord,
    Numbers,
    PixelState,
    Readouts,
    Switches,
)
from nscc_runtime.loop import inlined

ADDED, SUBTRACTED, LEVEL = 1, 2, 4
"""PIX flags, bits of `PixelState.full`: a register contains a full PIX with positive or negative
sign, or a full PIX in the level of a reset. `read_out` turns them into saturation marks."""


@inlined
def begin(switches: Switches, state: PixelState, i: int) -> None:
    """Set the registers, PIX and IN of pixel number `i` of a block to 0, without PIX flags,
    as at the start of a frame, written at time 0. The reset level is 0. PIX is the photodiode. IN
    is the level sent to all pixels."""
    for register in range(switches.registers + 2):
        at = register * WORD_BLOCK + i
        state.value[at], state.since_s[at] = 0.0, 0.0
        state.lost_e[at], state.full[at] = 0.0, 0
    # PIX was reset before the frame: words at time 0 must not see a fresh reset.
    state.since_s[switches.registers * WORD_BLOCK + i] = -1.0
    state.level[i] = 0.0


@inlined
def fill(switches: Switches, numbers: Numbers, state: PixelState, at: int, charge_e: float) -> None:
    """Add `charge_e` electrons to the PIX (the photodiode) at index `at` of state.value; NaN makes
    it NaN. If the effect of the full well is on, PIX stops at the full well and is marked as full.
    """
    total = state.value[at] + charge_e
    if switches.well_clips and total > numbers.well:
        total = numbers.well
        state.full[at] = ADDED
    state.value[at] = total


@inlined
def reset(
    switches: Switches, numbers: Numbers, word: LoopWord, count: int, state: PixelState
) -> None:
    """Run the reset word `word` in the pixels state.running[:count]: empty PIX, clear its marks,
    note the time, and set the reset level to its error, that of pixel number j from
    state.normals[j], or to 0 without reset errors. PIX is the photodiode."""
    for j in range(count):
        i = state.running[j]
        at = switches.registers * WORD_BLOCK + i
        state.value[at], state.full[at], state.since_s[at] = 0.0, 0, word.time_s
        state.level[i] = 0.0
        if switches.reset_errors:
            state.level[i] = numbers.reset_error * state.normals[j]


@inlined
def add(
    switches: Switches,
    numbers: Numbers,
    word: LoopWord,
    count: int,
    program: LoopProgram,
    state: PixelState,
) -> None:
    """Set state.total, total_lost_e and total_full to the sum of a word's sources, of their lost
    electrons, and to the OR of their marks, for the pixels state.running[:count].

    Registers leak until the word. A read of PIX adds its reset level and an error made from
    state.normals[j]. Directly after a reset at the same boundary, PIX reads without its charge,
    unless light is let into the level. PIX is the photodiode."""
    pixels, total, pix = state.running, state.total, switches.registers
    for j in range(count):
        total[j], state.total_lost_e[j], state.total_full[j] = 0.0, 0.0, 0
    for s in range(word.sources):
        source = program.operands[word.operands + s]
        if source == pix:
            for j in range(count):
                noise = numbers.read_error * state.normals[j] if switches.read_errors else 0.0
                at = pix * WORD_BLOCK + pixels[j]
                charge, full = state.value[at], state.full[at]
                # PIX was reset at this boundary.
                if state.since_s[at] == word.time_s:
                    full = full | LEVEL if switches.lit_level and full else 0
                    charge = charge if switches.lit_level else 0.0
                total[j] += charge + state.level[pixels[j]] + noise
                state.total_full[j] |= full
        elif source > pix:
            for j in range(count):
                total[j] += word.in_e
        else:
            for j in range(count):
                at = source * WORD_BLOCK + pixels[j]
                value = state.value[at]
                if switches.leaks and state.since_s[at] != word.time_s:
                    age_s = word.time_s - state.since_s[at]
                    value *= math.exp(-state.leak[pixels[j]] * age_s)
                total[j] += value
            if switches.well_clips or switches.registers_bend:
                for j in range(count):
                    at = source * WORD_BLOCK + pixels[j]
                    state.total_full[j] |= state.full[at]
                    state.total_lost_e[j] += state.lost_e[at]


@inlined
def compare(
    switches: Switches, numbers: Numbers, count: int, state: PixelState, normals: int
) -> None:
    """Add the comparator's offset and noise to state.total[:count], as far as these effects are on;
    the noise of pixel number j is made from state.normals[normals + j]. The caller compares with
    0."""
    if switches.compares_off:
        for j in range(count):
            state.total[j] += state.offset[state.running[j]]
    if switches.compares_noisy:
        for j in range(count):
            state.total[j] += numbers.compare_noise * state.normals[normals + j]


@inlined
def write(
    switches: Switches,
    numbers: Numbers,
    word: LoopWord,
    count: int,
    program: LoopProgram,
    state: PixelState,
    normals: int,
) -> None:
    """Write -(state.total) / divisor to the destinations of a bus word in the pixels
    state.running[:count], with the marks and losses of its sources.

    With errors of words, the result has the word's gain and an error, for destination d made from
    state.normals[normals + d * WORD_BLOCK + j]. With soft registers it is bent into their range."""
    if switches.well_clips:
        for j in range(count):
            # A bus word negates, so added and subtracted are exchanged.
            full = state.total_full[j]
            exchanged = (full & ADDED) * SUBTRACTED | (full & SUBTRACTED) // SUBTRACTED
            state.total_full[j] = exchanged | full & LEVEL
    gain = numbers.gain if word.adds else numbers.move_gain
    sigma = numbers.word_error if word.adds else numbers.move_error
    for d in range(word.destinations):
        register = program.operands[word.operands + word.sources + d]
        for j in range(count):
            i, lost_e = state.running[j], state.total_lost_e[j] / word.divisor
            value = state.total[j] / -word.divisor
            if switches.word_errors:
                noise = sigma * state.normals[normals + d * WORD_BLOCK + j] if sigma else 0.0
                error = state.pattern[i] + noise if word.adds else noise
                value = gain * value + program.signs[register] * error
            if switches.registers_bend:
                bent = soft_in_loop(value, numbers.lowest, numbers.highest, numbers.knee)
                lost_e += abs(value - bent)
                value = bent
            at = register * WORD_BLOCK + i
            state.value[at], state.since_s[at] = value, word.time_s
            state.lost_e[at], state.full[at] = lost_e, state.total_full[j]


@inlined
def read_out(
    switches: Switches,
    numbers: Numbers,
    count: int,
    readouts: Readouts,
    state: PixelState,
    pixels: int,
    chosen: Ints,
    first: int,
    out: Floats,
    marked: Bytes,
) -> None:
    """Read out the first `count` pixels of a block into `out` (electrons) and `marked` (saturation
    marks), both (buckets, pixels), flat. Pixel i of the block is number chosen[first + i] of the
    `pixels` pixels there. Registers leak until their readout."""
    for bucket in range(switches.buckets):
        gain = readouts.gain[bucket]
        negative = gain < 0.0
        when_s = numbers.frame_s + readouts.wait_s[bucket]
        for i in range(count):
            at = readouts.register[bucket] * WORD_BLOCK + i
            value = state.value[at] * gain
            if switches.leaks:
                value *= math.exp(-state.leak[i] * (when_s - state.since_s[at]))
            mark = switches.registers_bit if state.lost_e[at] > numbers.least_lost else 0
            if state.full[at] & ADDED:
                mark |= switches.subtracted_bit if negative else switches.well_bit
            if state.full[at] & SUBTRACTED:
                mark |= switches.well_bit if negative else switches.subtracted_bit
            if state.full[at] & LEVEL:
                mark |= switches.level_bit
            place = bucket * pixels + chosen[first + i]
            out[place] = value + 0.0  # -0 + 0 is +0
            marked[place] = np.uint8(mark)
