"""The loop that takes pixels along their ways through a frame: the reference, compiled.

It does what `nscc_runtime.reference.looks` does with the same keyed numbers. Pixels of a block that
are in one segment run each of its words together, so that their draws are made side by side; the
answers of its comparison hand them on. `nscc_runtime.looking.pixels` makes what it is given.
"""

from __future__ import annotations

import math
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.registry import in_loop
from nscc_runtime.effects.spread import log_normal_in_loop
from nscc_runtime.looking.layout import Keys, Numbers, Sizes, Word
from nscc_runtime.loop import Bytes, Floats, Ints, Ints32, Words, Written, compiled, inlined, loop
from nscc_runtime.noise.counter import bits
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.noise_loops import uniform

BLOCK = 512
"""Pixels that are taken along together."""
_ADDED, _SUBTRACTED, _LEVEL = 1, 2, 4
"""Of what a register holds: it has a full PIX in it, or that of a reset's level."""
_bent = in_loop("bends")
"""What a register holds of a value, by the effect that bends it."""

OfWords = Annotated[NDArray[Any], Word]


@inlined
def _drawn(key: np.uint64, first_place: int, some: Ints, count: int, z: Floats) -> None:
    """z[j] := the normal number of a key at the pixel some[j] of a block."""
    for j in range(count):
        z[j] = uniform(key, first_place + some[j])
    for j in range(count):
        z[j] = normal(z[j])


@compiled
def _device(
    sizes: Sizes, numbers: Numbers, keys: Keys, first: int, count: int, every: Ints,
    pattern: Floats, leak: Floats, offset: Floats,
) -> None:  # fmt: skip
    """What is fixed of the pixels of a block."""
    place = sizes.first_place + first
    if sizes.word_errors:
        _drawn(keys.pattern, place, every, count, pattern)
        for i in range(count):
            pattern[i] = numbers.bias + numbers.pattern * pattern[i]
    if sizes.leaks:
        _drawn(keys.leak, place, every, count, leak)
        for i in range(count):
            leak[i] = numbers.leak * log_normal_in_loop(numbers.leak_variance, leak[i])
    if sizes.compares_off:
        _drawn(keys.offset, place, every, count, offset)
        for i in range(count):
            offset[i] = numbers.compare_offset * offset[i]


@compiled
def _fallen(
    sizes: Sizes, numbers: Numbers, word: Word, first: int, some: Ints, count: int,
    charge: Floats, pace: Floats, pix: Floats, full: Ints, reached: Ints, part: Floats,
) -> None:  # fmt: skip
    """PIX gets the charge that has fallen when a word ends."""
    pixels, last = sizes.pixels, sizes.intervals - 1
    for j in range(count):
        i = some[j]
        held, was_full = pix[i], full[sizes.registers * BLOCK + i]
        for k in range(reached[i], word.interval):
            held += charge[k * pixels + first + i] * (1.0 - part[i])
            part[i] = 0.0
            if sizes.holds and held > numbers.well:
                held, was_full = numbers.well, _ADDED
        reached[i] = word.interval
        if sizes.slow_words:
            k = word.interval if word.interval < last else last
            at = word.interval * sizes.paces + (first + i if sizes.paces > 1 else 0)
            now = word.end_us * pace[at]
            held += charge[k * pixels + first + i] * (now - part[i])
            part[i] = now
            if sizes.holds and held > numbers.well:
                held, was_full = numbers.well, _ADDED
        pix[i], full[sizes.registers * BLOCK + i] = held, was_full


@compiled
def _total(
    sizes: Sizes, numbers: Numbers, word: Word, read_key: np.uint64, place: int, some: Ints,
    count: int, operands: Ints, leak: Floats, pix: Floats, level: Floats, value: Floats,
    stamp: Floats, z: Floats, total: Floats,
) -> None:  # fmt: skip
    """total[j] := the sum of a word's sources at the pixel some[j] of a block. The stamp of PIX is
    when it was reset."""
    for j in range(count):
        total[j] = 0.0
    for s in range(word.sources):
        source = operands[word.operands + s]
        if source == sizes.registers:
            if sizes.read_errors:
                _drawn(read_key, place, some, count, z)
            for j in range(count):
                noise = numbers.read_error * z[j] if sizes.read_errors else 0.0
                charge = pix[some[j]]
                if not sizes.lit_level and stamp[source * BLOCK + some[j]] == word.time_s:
                    charge = 0.0
                total[j] += charge + level[some[j]] + noise
        elif source > sizes.registers:
            for j in range(count):
                total[j] += word.in_e
        else:
            for j in range(count):
                at = source * BLOCK + some[j]
                held = value[at]
                if sizes.leaks and stamp[at] != word.time_s:
                    held *= math.exp(-leak[some[j]] * (word.time_s - stamp[at]))
                total[j] += held


@compiled
def _gathered(
    sizes: Sizes, word: Word, some: Ints, count: int, operands: Ints, stamp: Floats, lost: Floats,
    full: Ints, much: Floats, marks: Ints,
) -> None:  # fmt: skip
    """What a bus word's result has lost, and which full PIX it has in it, by its sources."""
    for j in range(count):
        found, lost_e = 0, 0.0
        for s in range(word.sources):
            source = operands[word.operands + s]
            at = source * BLOCK + some[j]
            fresh = source == sizes.registers and stamp[at] == word.time_s
            if sizes.lit_level or not fresh:
                found |= full[at]
            if sizes.lit_level and fresh and full[at]:
                found |= _LEVEL
            lost_e += lost[at]
        # What is added of the negative was subtracted.
        exchanged = (found & _ADDED) * _SUBTRACTED | (found & _SUBTRACTED) // _SUBTRACTED
        marks[j] = exchanged | found & _LEVEL
        much[j] = lost_e / word.divisor


@compiled
def _written(
    sizes: Sizes, numbers: Numbers, word: Word, w: int, write_keys: Words, place: int, some: Ints,
    count: int, operands: Ints, signs: Floats, pattern: Floats, much: Floats, marks: Ints,
    value: Floats, stamp: Floats, lost: Floats, full: Ints, z: Floats, total: Floats,
) -> None:  # fmt: skip
    """The destinations of a bus word get its result, of sources that sum to `total`."""
    for d in range(word.destinations):
        register = operands[word.operands + word.sources + d]
        if sizes.word_errors:
            _drawn(write_keys[w * sizes.numbered + d], place, some, count, z)
        for j in range(count):
            i, lost_e = some[j], much[j]
            result = total[j] / -word.divisor
            if sizes.word_errors:
                error = pattern[i] + numbers.word_error * z[j]
                result = numbers.gain * result + signs[register] * error
            if sizes.bends:
                held = _bent(result, numbers.lowest, numbers.highest, numbers.knee)
                lost_e += abs(result - held)
                result = held
            at = register * BLOCK + i
            value[at], stamp[at] = result, word.time_s
            lost[at], full[at] = lost_e, marks[j]


@compiled
def _reset(
    sizes: Sizes, numbers: Numbers, word: Word, reset_key: np.uint64, place: int, some: Ints,
    count: int, pix: Floats, level: Floats, stamp: Floats, full: Ints, z: Floats,
) -> None:  # fmt: skip
    """PIX is emptied."""
    if sizes.reset_errors:
        _drawn(reset_key, place, some, count, z)
    for j in range(count):
        i = some[j]
        pix[i] = 0.0
        level[i] = numbers.reset_error * z[j] if sizes.reset_errors else 0.0
        full[sizes.registers * BLOCK + i] = 0
        stamp[sizes.registers * BLOCK + i] = word.time_s


@compiled
def _asked(
    sizes: Sizes, numbers: Numbers, ask_key: np.uint64, place: int, some: Ints, count: int,
    offset: Floats, z: Floats, total: Floats,
) -> None:  # fmt: skip
    """total[j] := what a comparison with 0 sees of it."""
    if sizes.compares_off:
        for j in range(count):
            total[j] += offset[some[j]]
    if sizes.compares_noisy:
        _drawn(ask_key, place, some, count, z)
        for j in range(count):
            total[j] += numbers.compare_noise * z[j]


@compiled
def _read_out(
    sizes: Sizes, numbers: Numbers, first: int, count: int, readout_register: Ints,
    readout_gain: Floats, readout_wait_s: Floats, leak: Floats, value: Floats, stamp: Floats,
    lost: Floats, full: Ints, out: Floats, marked: Bytes,
) -> None:  # fmt: skip
    """The exposures of a block: what its registers hold when their turn has come."""
    for bucket in range(sizes.buckets):
        negative = readout_gain[bucket] < 0.0
        when_s = numbers.frame_s + readout_wait_s[bucket]
        for i in range(count):
            at = readout_register[bucket] * BLOCK + i
            held = value[at] * readout_gain[bucket]
            if sizes.leaks:
                held *= math.exp(-leak[i] * (when_s - stamp[at]))
            found = sizes.registers_bit if lost[at] > numbers.least_lost else 0
            if full[at] & _ADDED:
                found |= sizes.subtracted_bit if negative else sizes.well_bit
            if full[at] & _SUBTRACTED:
                found |= sizes.well_bit if negative else sizes.subtracted_bit
            if full[at] & _LEVEL:
                found |= sizes.level_bit
            out[bucket * sizes.pixels + first + i] = held + 0.0
            marked[bucket * sizes.pixels + first + i] = np.uint8(found)


@inlined
def _hand_on(segment: int, first: int, i: int, head: Ints, behind: Ints, ends: Ints32) -> None:
    """Pixel i of a block waits before a segment, or has come to an end."""
    if segment < 0:
        ends[first + i] = -1 - segment
    else:
        behind[i] = head[segment]
        head[segment] = i


@compiled
def _name(
    sizes: Sizes, keys: Keys, read_keys: Words, reset_keys: Words, ask_keys: Words,
    write_keys: Words,
) -> None:  # fmt: skip
    """The keys of this frame's draws, word by word."""
    for w in range(sizes.steps):
        number = np.uint64(w)
        read_keys[w] = bits(keys.reads, sizes.frame, number)
        reset_keys[w] = bits(keys.resets, sizes.frame, number)
        ask_keys[w] = bits(keys.compares, sizes.frame, number)
        for d in range(w * sizes.numbered, (w + 1) * sizes.numbered):
            write_keys[d] = bits(keys.words, sizes.frame, np.uint64(d))


@compiled
def _along(
    sizes: Sizes, numbers: Numbers, segment: int, first: int, words: OfWords, operands: Ints,
    start: Ints, acting: Ints, following: Ints, signs: Floats, charge: Floats, pace: Floats,
    read_keys: Words, reset_keys: Words, ask_keys: Words, write_keys: Words, head: Ints,
    behind: Ints, some: Ints, reached: Ints, marks: Ints, full: Ints, pattern: Floats,
    leak: Floats, offset: Floats, pix: Floats, level: Floats, part: Floats, much: Floats,
    z: Floats, total: Floats, value: Floats, stamp: Floats, lost: Floats, ends: Ints32,
) -> None:  # fmt: skip
    """The pixels of a block that wait before a segment run its words, and are handed on."""
    count, i, place = 0, head[segment], sizes.first_place + first
    head[segment] = -1
    while i >= 0:
        some[count] = i
        count += 1
        i = behind[i]
    asks = False
    for e in range(start[segment], start[segment + 1]):
        w = acting[e]
        word = words[w]
        if word.touches_pix:
            _fallen(
                sizes, numbers, word, first, some, count, charge, pace, pix, full, reached, part
            )
        if word.resets:
            _reset(
                sizes, numbers, word, reset_keys[w], place, some, count, pix, level, stamp, full, z
            )
            continue
        _total(
            sizes, numbers, word, read_keys[w], place, some, count, operands, leak, pix, level,
            value, stamp, z, total,
        )  # fmt: skip
        if word.compares:
            asks = True
            _asked(sizes, numbers, ask_keys[w], place, some, count, offset, z, total)
            continue
        _gathered(sizes, word, some, count, operands, stamp, lost, full, much, marks)
        _written(
            sizes, numbers, word, w, write_keys, place, some, count, operands, signs, pattern,
            much, marks, value, stamp, lost, full, z, total,
        )  # fmt: skip
    for j in range(count):
        answer = 1 if asks and total[j] > 0.0 else 0
        _hand_on(following[2 * segment + answer], first, some[j], head, behind, ends)


@loop
def run_ways(
    sizes: Sizes,
    numbers: Numbers,
    keys: Keys,
    words: Annotated[OfWords, "steps"],
    operands: Ints,
    start: Annotated[Ints, "segments+1"],
    acting: Ints,
    following: Annotated[Ints, "segments 2"],
    begins: Annotated[Ints, "pixels"],
    signs: Annotated[Floats, "registers"],
    readout_register: Annotated[Ints, "buckets"],
    readout_gain: Annotated[Floats, "buckets"],
    readout_wait_s: Annotated[Floats, "buckets"],
    charge: Annotated[Floats, "intervals pixels"],
    pace: Annotated[Floats, "intervals+1 paces"],
    read_keys: Written[Annotated[Words, "steps"]],
    reset_keys: Written[Annotated[Words, "steps"]],
    ask_keys: Written[Annotated[Words, "steps"]],
    write_keys: Written[Words],
    head: Written[Annotated[Ints, "segments"]],
    behind: Written[Ints],
    some: Written[Ints],
    reached: Written[Ints],
    marks: Written[Ints],
    full: Written[Ints],
    pattern: Written[Floats],
    leak: Written[Floats],
    offset: Written[Floats],
    pix: Written[Floats],
    level: Written[Floats],
    part: Written[Floats],
    much: Written[Floats],
    z: Written[Floats],
    total: Written[Floats],
    value: Written[Floats],
    stamp: Written[Floats],
    lost: Written[Floats],
    out: Written[Annotated[Floats, "buckets pixels"]],
    marked: Written[Annotated[Bytes, "buckets pixels"]],
    ends: Written[Annotated[Ints32, "pixels"]],
) -> None:
    """out[b, i] := the exposure of pixel i in bucket b, in electrons, marked[b, i] what cut it off,
    and ends[i] its ending.

    The words of segment k are `acting[start[k] : start[k + 1]]`; `begins` is where pixels begin;
    -1 - e, there and in `following`, is ending e. From `read_keys` to `lost`: scratch, `head` once
    filled with -1, those without a shape of `BLOCK` pixels, the last four for each register and two
    more; `write_keys` for each word and number of a draw.
    """
    _name(sizes, keys, read_keys, reset_keys, ask_keys, write_keys)
    for first in range(0, sizes.pixels, BLOCK):
        count = min(BLOCK, sizes.pixels - first)
        for i in range(count):
            some[i] = i
        _device(sizes, numbers, keys, first, count, some, pattern, leak, offset)
        for i in range(count):
            pix[i], level[i], part[i], reached[i] = 0.0, 0.0, 0.0, 0
            for register in range(sizes.registers + 2):
                at = register * BLOCK + i
                value[at], stamp[at], lost[at], full[at] = 0.0, 0.0, 0.0, 0
            stamp[sizes.registers * BLOCK + i] = -1.0
            _hand_on(begins[first + i], first, i, head, behind, ends)
        for segment in range(sizes.segments):
            if head[segment] >= 0:
                _along(
                    sizes, numbers, segment, first, words, operands, start, acting, following,
                    signs, charge, pace, read_keys, reset_keys, ask_keys, write_keys, head, behind,
                    some, reached, marks, full, pattern, leak, offset, pix, level, part, much, z,
                    total, value, stamp, lost, ends,
                )  # fmt: skip
        _read_out(
            sizes, numbers, first, count, readout_register, readout_gain, readout_wait_s, leak,
            value, stamp, lost, full, out, marked,
        )  # fmt: skip
