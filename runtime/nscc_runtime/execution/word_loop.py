"""The effect of analog words on pixels: the reference's words, compiled.

Two loops run pixels through words: `nscc_runtime.execution.pixel_loop` runs single pixels with
fixed shutters, and `nscc_runtime.looking.path_loop` runs blocks of pixels that look. Both add
charge to PIX and draw the normal numbers of a word before they call these functions. Register r of
pixel i of a block is at index r * `block` + i. `count` is the number of pixels that run the word.
`block` and `count` are constants for single pixels, so everything here is inlined.

Small errors of single words of `pixel_loop` are consistent with the sum of errors that frames by
sums draw at once."""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np

from nscc_runtime.effects.spread import soft_in_loop
from nscc_runtime.execution.layout import (
    LoopProgram,
    LoopWord,
    Numbers,
    OfWords,
    PixelState,
    Readouts,
    Sizes,
    Switches,
)
from nscc_runtime.loop import Bytes, Floats, Ints, Ints32, Words, Written, compiled, inlined
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.keys import bits
from nscc_runtime.noise.noise_loops import uniform

ADDED, SUBTRACTED, LEVEL = 1, 2, 4
"""Saturation marks of a register: it contains a full PIX with positive or negative sign, or a full
PIX in the level of a reset."""


@inlined
def begin(switches: Switches, block: int, state: PixelState, i: int) -> None:
    """Empty the registers of pixel i of a block at the start of a frame."""
    for register in range(switches.registers + 2):
        at = register * block + i
        state.value[at], state.since_s[at] = 0.0, 0.0
        state.lost_e[at], state.full[at] = 0.0, 0
    state.since_s[switches.registers * block + i] = -1.0
    state.level[i] = 0.0


@inlined
def fill(switches: Switches, numbers: Numbers, state: PixelState, at: int, charge_e: float) -> None:
    """Add charge to the PIX at index `at`."""
    total = state.value[at] + charge_e
    if switches.holds and total > numbers.well:
        total = numbers.well
        state.full[at] = ADDED
    state.value[at] = total


@inlined
def reset(
    switches: Switches, numbers: Numbers, word: LoopWord, block: int, count: int, state: PixelState,
    normals: Floats, first: int,
) -> None:  # fmt: skip
    """Reset PIX; the error of pixel j is normals[first + j]."""
    for j in range(count):
        i = state.running[j]
        at = switches.registers * block + i
        state.value[at], state.full[at], state.since_s[at] = 0.0, 0, word.time_s
        state.level[i] = 0.0
        if switches.reset_errors:
            state.level[i] = numbers.reset_error * normals[first + j]


@inlined
def add(
    switches: Switches, numbers: Numbers, word: LoopWord, block: int, count: int,
    program: LoopProgram, state: PixelState, normals: Floats, first: int,
) -> None:  # fmt: skip
    """Set the totals of `state` to the sum of a word's sources, their losses and their marks; the
    error of a read is normals[first + j]."""
    pixels, total, pix = state.running, state.total, switches.registers
    for j in range(count):
        total[j], state.total_lost_e[j], state.total_full[j] = 0.0, 0.0, 0
    for s in range(word.sources):
        source = program.operands[word.operands + s]
        if source == pix:
            for j in range(count):
                noise = numbers.read_error * normals[first + j] if switches.read_errors else 0.0
                at = pix * block + pixels[j]
                charge, full = state.value[at], state.full[at]
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
                at = source * block + pixels[j]
                value = state.value[at]
                if switches.leaks and state.since_s[at] != word.time_s:
                    age_s = word.time_s - state.since_s[at]
                    value *= math.exp(-state.leak[pixels[j]] * age_s)
                total[j] += value
            if switches.holds or switches.bends:
                for j in range(count):
                    at = source * block + pixels[j]
                    state.total_full[j] |= state.full[at]
                    state.total_lost_e[j] += state.lost_e[at]


@inlined
def compare(
    switches: Switches, numbers: Numbers, block: int, count: int, state: PixelState,
    normals: Floats, first: int,
) -> None:  # fmt: skip
    """Add the comparator's errors to state.total; its noise is normals[first + j]."""
    if switches.compares_off:
        for j in range(count):
            state.total[j] += state.offset[state.running[j]]
    if switches.compares_noisy:
        for j in range(count):
            state.total[j] += numbers.compare_noise * normals[first + j]


@inlined
def write(
    switches: Switches, numbers: Numbers, word: LoopWord, block: int, count: int,
    program: LoopProgram, state: PixelState, normals: Floats, first: int, step: int,
) -> None:  # fmt: skip
    """Write a bus word's result to its destinations d, each with the error normals[first + d * step
    + j]."""
    for j in range(count):
        # A bus word negates, so added and subtracted are exchanged.
        full = state.total_full[j]
        exchanged = (full & ADDED) * SUBTRACTED | (full & SUBTRACTED) // SUBTRACTED
        state.total_full[j] = exchanged | full & LEVEL
    for d in range(word.destinations):
        register = program.operands[word.operands + word.sources + d]
        for j in range(count):
            i, lost_e = state.running[j], state.total_lost_e[j] / word.divisor
            value = state.total[j] / -word.divisor
            if switches.word_errors:
                error = state.pattern[i] + numbers.word_error * normals[first + d * step + j]
                value = numbers.gain * value + program.signs[register] * error
            if switches.bends:
                bent = soft_in_loop(value, numbers.lowest, numbers.highest, numbers.knee)
                lost_e += abs(value - bent)
                value = bent
            at = register * block + i
            state.value[at], state.since_s[at] = value, word.time_s
            state.lost_e[at], state.full[at] = lost_e, state.total_full[j]


@inlined
def read_out(
    switches: Switches, numbers: Numbers, block: int, count: int, readouts: Readouts,
    state: PixelState, pixels: int, first: int, out: Floats, marked: Bytes,
) -> None:  # fmt: skip
    """Read out the pixels of a block into `out` (electrons) and `marked` (saturation marks), from
    pixel number `first` of `pixels` on."""
    for bucket in range(switches.buckets):
        gain = readouts.gain[bucket]
        negative = gain < 0.0
        when_s = numbers.frame_s + readouts.wait_s[bucket]
        for i in range(count):
            at = readouts.register[bucket] * block + i
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
            out[bucket * pixels + first + i] = value + 0.0
            marked[bucket * pixels + first + i] = np.uint8(mark)


READS, RESETS, WORDS = 0, 1, 2
ERRORS = 3
"""Number of kinds of small errors."""
_UNKNOWN = np.uint64(0)


class Lanes(NamedTuple):
    """The words of each lane (code number).

    `of_pixel`: the lane of each pixel. The words of lane l are at start[l] to start[l + 1] - 1 of
    `word` (their index among the program's words), `flags`, and `weights` (the weights of their
    draws in the buckets)."""

    of_pixel: Annotated[Ints32, "rows cols"]
    start: Annotated[Ints, "lanes+1"]
    word: Annotated[Ints32, "listed"]
    flags: Annotated[Bytes, "listed"]
    weights: Annotated[Floats, "listed draws buckets"]


class ErrorScratch(NamedTuple):
    """Working memory: `streams`, cached random keys (0 at first); `missing`, the part of the
    buckets' draws that words do not explain; `drawn`, the errors of the words of a lane. `draws`,
    `keys` and `normals` are the indices, keys and values of draws that are made together."""

    streams: Written[Words]
    missing: Written[Floats]
    drawn: Written[Floats]
    draws: Written[Ints]
    keys: Written[Words]
    normals: Written[Floats]


@compiled
def _stream_of(
    sizes: Sizes, base: np.uint64, at: int, number: np.uint64, streams: Words
) -> np.uint64:
    """Return the random key of draw `number` in this frame, cached in streams[at]."""
    if streams[at] == _UNKNOWN:
        streams[at] = bits(base, sizes.frame, number)
    stream: np.uint64 = streams[at]
    return stream


@compiled
def draw_errors(
    sizes: Sizes, buckets: int, of_sum: np.uint64, of_part: np.uint64, place: int, lane: int,
    lanes: Lanes, words: OfWords, kind: int, errors: ErrorScratch,
) -> None:  # fmt: skip
    """Draw the standard normal errors of one kind for each word of a lane into `errors.drawn`.

    Q (z - Q^T x) is added to the draws x of the words, where z are the draws of the buckets and Q
    are their weights. The weighted sum of the errors then equals z."""
    # The streams of a kind are those of the buckets, then those of the words.
    row = kind * (buckets + sizes.words * sizes.numbered)
    count, first = 0, lanes.start[lane]
    for bucket in range(buckets):
        stream = _stream_of(sizes, of_sum, row + bucket, np.uint64(bucket), errors.streams)
        errors.missing[bucket] = normal(uniform(stream, place))
    for e in range(first, lanes.start[lane + 1]):
        word = words[lanes.word[e]]
        for draw in range(sizes.draws):
            if _draws(word, kind, draw):
                number = word.number
                if kind == WORDS:
                    number = number * sizes.numbered + draw - 1
                at = row + buckets + number
                errors.keys[count] = _stream_of(
                    sizes, of_part, at, np.uint64(number), errors.streams
                )
                errors.draws[count] = (e - first) * sizes.draws + draw
                count += 1
    # A separate loop over all draws, so that LLVM vectorises it.
    for i in range(count):
        errors.normals[i] = normal(uniform(errors.keys[i], place))
    for i in range(count):
        at = (first * sizes.draws + errors.draws[i]) * buckets
        for bucket in range(buckets):
            errors.missing[bucket] -= lanes.weights[at + bucket] * errors.normals[i]
    for i in range(count):
        at = (first * sizes.draws + errors.draws[i]) * buckets
        error = errors.normals[i]
        for bucket in range(buckets):
            error += lanes.weights[at + bucket] * errors.missing[bucket]
        errors.drawn[errors.draws[i]] = error


@compiled
def _draws(word: LoopWord, kind: int, draw: int) -> bool:
    """Return whether a word has this draw of this kind of noise."""
    if kind == RESETS:
        return draw == 0 and word.resets == 1
    if kind == READS:
        return draw == 0 and word.reads_pix == 1
    return draw > 0 and draw <= word.destinations
