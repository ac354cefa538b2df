"""The effect of analog words on pixels: the reference's words, compiled.

`nscc_runtime.execution.block_loop` adds charge to PIX and draws the normal numbers of a word before
it calls these functions. `count` pixels run the word; register r of the first of them is at index
r * `WORD_BLOCK` + `base`, and the others follow. Loops are short, because LLVM vectorises only
loops over few arrays."""

from __future__ import annotations

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
from nscc_runtime.noise.poisson_law import exp_minus

ADDED, SUBTRACTED, LEVEL = 1, 2, 4
"""PIX flags, bits of `PixelState.full`: a register contains a full PIX with positive or negative
sign, or a full PIX in the level of a reset. `read_out` turns them into saturation marks."""


@inlined
def begin(switches: Switches, state: PixelState, count: int) -> None:
    """Set the registers and PIX (the photodiode) of the first `count` pixels of a block to 0,
    without PIX flags, as at the start of a frame, written at time 0. The reset level is 0, and no
    charge has fallen."""
    for register in range(switches.registers + 1):
        # PIX was reset before the frame: words at time 0 must not see a fresh reset.
        since_s = -1.0 if register == switches.registers else 0.0
        for at in range(register * WORD_BLOCK, register * WORD_BLOCK + count):
            state.value[at], state.since_s[at] = 0.0, since_s
            state.lost_e[at], state.full[at] = 0.0, 0
    for i in range(count):
        state.level[i], state.fallen_fraction[i], state.reached[i] = 0.0, 0.0, 0


@inlined
def fill(switches: Switches, numbers: Numbers, count: int, state: PixelState, base: int) -> None:
    """Add state.total, in electrons, to PIX (the photodiode) of the pixels; NaN makes it NaN. If
    the effect of the full well is on, PIX stops at the full well and is marked as full."""
    pix = switches.registers * WORD_BLOCK + base
    for j in range(count):
        state.value[pix + j] += state.total[j]
    for j in range(count if switches.well_clips else 0):
        is_full = state.value[pix + j] > numbers.well
        state.full[pix + j] = ADDED if is_full else state.full[pix + j]
        state.value[pix + j] = numbers.well if is_full else state.value[pix + j]


@inlined
def reset(
    switches: Switches, numbers: Numbers, word: LoopWord, count: int, state: PixelState, base: int
) -> None:
    """Run the reset word `word` in the pixels: empty PIX, clear its marks, note the time, and set
    the reset level to its error, that of pixel number j from state.normals[j], or to 0 without
    reset errors. PIX is the photodiode."""
    pix = switches.registers * WORD_BLOCK + base
    for j in range(count):
        state.value[pix + j], state.full[pix + j] = 0.0, 0
        state.since_s[pix + j], state.level[base + j] = word.time_s, 0.0
    for j in range(count if switches.reset_errors else 0):
        state.level[base + j] = numbers.reset_error * state.normals[j]


@inlined
def add(
    switches: Switches,
    numbers: Numbers,
    word: LoopWord,
    count: int,
    program: LoopProgram,
    state: PixelState,
    base: int,
) -> None:
    """Set state.total, total_lost_e and total_full to the sum of a word's sources, of their lost
    electrons, and to the OR of their marks, for the pixels. Registers leak until the word.

    A read of PIX (the photodiode) adds its reset level and an error made from state.normals[j].
    Directly after a reset at the same boundary, PIX reads without its charge, unless light is let
    into the level."""
    total = state.total
    for j in range(count):
        total[j], state.total_lost_e[j], state.total_full[j] = 0.0, 0.0, 0
    for s in range(word.sources):
        source = program.operands[word.operands + s]
        at = source * WORD_BLOCK + base
        if source == switches.registers:
            lit = switches.lit_level
            for j in range(count):
                is_read = lit or state.since_s[at + j] != word.time_s
                total[j] += (state.value[at + j] if is_read else 0.0) + state.level[base + j]
            for j in range(count if switches.read_errors else 0):
                total[j] += numbers.read_error * state.normals[j]
            for j in range(count if switches.well_clips else 0):
                full = state.full[at + j]
                of_level = full | LEVEL if lit and full else 0
                state.total_full[j] |= of_level if state.since_s[at + j] == word.time_s else full
        elif source > switches.registers:
            for j in range(count):
                total[j] += word.in_e
        else:
            older = 0
            for j in range(count if switches.leaks else 0):
                older += state.since_s[at + j] != word.time_s
            if older:
                for j in range(count):
                    decay = state.leak[base + j] * (word.time_s - state.since_s[at + j])
                    total[j] += state.value[at + j] * exp_minus(decay)
            else:
                for j in range(count):
                    total[j] += state.value[at + j]
            for j in range(count if switches.well_clips else 0):
                state.total_full[j] |= state.full[at + j]
            for j in range(count if switches.registers_bend else 0):
                state.total_lost_e[j] += state.lost_e[at + j]


@inlined
def compare(
    switches: Switches, numbers: Numbers, count: int, state: PixelState, base: int, normals: int
) -> None:
    """Add the comparator's offset and noise to state.total[:count], as far as these effects are on;
    the noise of pixel number j is made from state.normals[normals + j]. The caller compares with
    0."""
    for j in range(count if switches.compares_off else 0):
        state.total[j] += state.offset[base + j]
    for j in range(count if switches.compares_noisy else 0):
        state.total[j] += numbers.compare_noise * state.normals[normals + j]


@inlined
def write(
    switches: Switches,
    numbers: Numbers,
    word: LoopWord,
    count: int,
    program: LoopProgram,
    state: PixelState,
    base: int,
    normals: int,
) -> None:
    """Write -(state.total) / divisor to the destinations of a bus word in the pixels, with the
    marks and losses of its sources.

    With errors of words, the result has the word's gain and an error, for destination d made from
    state.normals[normals + d * WORD_BLOCK + j]. With soft registers it is bent into their range."""
    if switches.well_clips:
        for j in range(count):
            # A bus word negates, so added and subtracted are exchanged.
            full = state.total_full[j]
            exchanged = (full & ADDED) * SUBTRACTED | (full & SUBTRACTED) // SUBTRACTED
            state.total_full[j] = exchanged | full & LEVEL
    for j in range(count if word.divisor != 1.0 else 0):
        state.total[j] /= word.divisor
        state.total_lost_e[j] /= word.divisor
    # Factors of the total, of the pixel's fixed error and of a normal number.
    gain, fixed, sigma = 1.0, 0.0, 0.0
    if switches.word_errors:
        gain = numbers.gain if word.adds else numbers.move_gain
        fixed = 1.0 if word.adds else 0.0
        sigma = numbers.word_error if word.adds else numbers.move_error
    for d in range(word.destinations):
        register = program.operands[word.operands + word.sources + d]
        at, drawn, sign = (
            register * WORD_BLOCK + base,
            normals + d * WORD_BLOCK,
            program.signs[register],
        )
        for j in range(count):
            error = sign * (fixed * state.pattern[base + j])
            state.value[at + j] = error - gain * state.total[j]
        for j in range(count if sigma else 0):
            state.value[at + j] += sign * (sigma * state.normals[drawn + j])
        for j in range(count):
            state.since_s[at + j] = word.time_s
            state.lost_e[at + j] = state.total_lost_e[j]
            state.full[at + j] = state.total_full[j]
        low, high, beyond = numbers.knee * numbers.lowest, numbers.knee * numbers.highest, 0
        for j in range(count if switches.registers_bend else 0):
            beyond += state.value[at + j] < low or state.value[at + j] > high
        for j in range(count if beyond else 0):
            value = state.value[at + j]
            bent = soft_in_loop(value, numbers.lowest, numbers.highest, numbers.knee)
            state.lost_e[at + j] += abs(value - bent)
            state.value[at + j] = bent


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
    total, marks = state.total, state.total_full
    for bucket in range(switches.buckets):
        gain, at = readouts.gain[bucket], readouts.register[bucket] * WORD_BLOCK
        added_bit = switches.subtracted_bit if gain < 0.0 else switches.well_bit
        subtracted_bit = switches.well_bit if gain < 0.0 else switches.subtracted_bit
        when_s = numbers.frame_s + readouts.wait_s[bucket]
        for i in range(count):
            total[i] = state.value[at + i] * gain
        for i in range(count if switches.leaks else 0):
            decay = state.leak[i] * (when_s - state.since_s[at + i])
            total[i] *= exp_minus(decay)
        for i in range(count):
            full = state.full[at + i]
            mark = switches.registers_bit if state.lost_e[at + i] > numbers.least_lost else 0
            mark |= added_bit if full & ADDED else 0
            mark |= subtracted_bit if full & SUBTRACTED else 0
            marks[i] = mark | (switches.level_bit if full & LEVEL else 0)
        for i in range(count):
            place = bucket * pixels + chosen[first + i]
            out[place] = total[i] + 0.0  # -0 + 0 is +0
            marked[place] = np.uint8(marks[i])
