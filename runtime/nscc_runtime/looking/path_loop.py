"""The compiled loop that takes pixels along their paths through a frame.

It computes the same as `nscc_runtime.reference.looks`, with the same keyed random numbers. All
pixels of a block that are in one segment run each of its words together. The answer of the
comparison at its end selects the next segment. `nscc_runtime.looking.looking_program` prepares the
arguments."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

from nscc_runtime.effects.spread import log_normal_in_loop
from nscc_runtime.execution.layout import (
    LoopProgram,
    LoopWord,
    Numbers,
    OnDevice,
    PixelState,
    Readouts,
    Switches,
)
from nscc_runtime.execution.word_loop import (
    add,
    begin,
    compare,
    fill,
    read_out,
    reset,
    write,
)
from nscc_runtime.loop import (
    Bytes,
    Floats,
    Ints,
    Ints32,
    Words,
    Written,
    compiled,
    inlined,
    loop,
    record,
)
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.keys import bits
from nscc_runtime.noise.noise_loops import uniform

BLOCK = 512
"""Number of pixels of a block."""


@record
class PathSizes:
    """Sizes for the loop over paths."""

    pixels: int
    first_place: int
    """The place of the first pixel; the places of the others follow."""
    intervals: int
    segments: int
    steps: int
    """Number of analog words of a frame."""
    numbered: int
    """Difference between the draw numbers of consecutive words."""
    paces: int
    """1 if all pixels have the same pace, else the number of pixels."""
    frame: int


@record
class PathKeys:
    """First halves of a frame's random keys: of reads and resets of PIX, words, comparisons."""

    reads: np.uint64
    resets: np.uint64
    words: np.uint64
    compares: np.uint64


class Segments(NamedTuple):
    """Segments of paths. The words of segment k are acting[start[k] : start[k + 1]]. Pixels whose
    comparison has the answer a continue with following[k, a]: a segment, or -1 - e for ending e."""

    start: Annotated[Ints, "segments+1"]
    acting: Ints
    following: Annotated[Ints, "segments 2"]


class Charge(NamedTuple):
    """The electrons of each interval, and the fraction collected per microsecond (`pace`)."""

    electrons: Annotated[Floats, "intervals pixels"]
    pace: Annotated[Floats, "intervals+1 paces"]


class WordKeys(NamedTuple):
    """Working memory: the random keys of a frame. `reads`, `resets`, `compares`: one key for each
    analog word. `words`: one for each draw."""

    reads: Written[Annotated[Words, "steps"]]
    resets: Written[Annotated[Words, "steps"]]
    compares: Written[Annotated[Words, "steps"]]
    words: Written[Words]


class BlockScratch(NamedTuple):
    """Working memory of a block.

    `head`: the first pixel that waits before each segment, -1 if none. `behind`: the next waiting
    pixel after each pixel. `reached`: the interval that each pixel has reached. `fallen_fraction`:
    the fraction of this interval that is collected. `normals`: the normal numbers of a word, by
    draw."""

    head: Written[Annotated[Ints, "segments"]]
    behind: Written[Ints]
    reached: Written[Ints]
    fallen_fraction: Written[Floats]
    normals: Written[Floats]


@inlined
def _drawn(
    key: np.uint64, first_place: int, running: Ints, count: int, normals: Floats, at: int
) -> None:
    """Set normals[at + j] to the normal number of a key at the pixel running[j] of a block."""
    for j in range(count):
        normals[at + j] = uniform(key, first_place + running[j])
    for j in range(count):
        normals[at + j] = normal(normals[at + j])


@compiled
def _begin(
    switches: Switches, numbers: Numbers, device: OnDevice, place: int, count: int, running: Ints,
    state: PixelState, block: BlockScratch,
) -> None:  # fmt: skip
    """Set the fixed patterns of the pixels of a block, and empty their registers."""
    for i in range(count):
        running[i] = i
        block.reached[i], block.fallen_fraction[i] = 0, 0.0
        begin(switches, BLOCK, state, i)
    if switches.word_errors:
        _drawn(device.pattern, place, running, count, state.pattern, 0)
        for i in range(count):
            state.pattern[i] = numbers.bias + numbers.pattern * state.pattern[i]
    if switches.leaks:
        _drawn(device.leak, place, running, count, state.leak, 0)
        for i in range(count):
            state.leak[i] = numbers.leak * log_normal_in_loop(numbers.leak_variance, state.leak[i])
    if switches.compares_off:
        _drawn(device.offset, place, running, count, state.offset, 0)
        for i in range(count):
            state.offset[i] = numbers.compare_offset * state.offset[i]


@compiled
def _fall(
    switches: Switches, sizes: PathSizes, numbers: Numbers, word: LoopWord, first: int,
    running: Ints, count: int, charge: Charge, state: PixelState, block: BlockScratch,
) -> None:  # fmt: skip
    """Add to PIX the charge that is collected until a word ends."""
    pixels, last = sizes.pixels, sizes.intervals - 1
    for j in range(count):
        i = running[j]
        at = switches.registers * BLOCK + i
        for k in range(block.reached[i], word.begins):
            charge_e = charge.electrons[k * pixels + first + i] * (1.0 - block.fallen_fraction[i])
            fill(switches, numbers, state, at, charge_e)
            block.fallen_fraction[i] = 0.0
        block.reached[i] = word.begins
        if switches.slow_words:
            k = word.begins if word.begins < last else last
            pace = word.begins * sizes.paces + (first + i if sizes.paces > 1 else 0)
            now = word.end_us * charge.pace[pace]
            charge_e = charge.electrons[k * pixels + first + i] * (now - block.fallen_fraction[i])
            fill(switches, numbers, state, at, charge_e)
            block.fallen_fraction[i] = now


@inlined
def _hand_on(segment: int, first: int, i: int, block: BlockScratch, ends: Ints32) -> None:
    """Queue pixel i for `segment`; a negative number is an ending, which is stored in `ends`."""
    if segment < 0:
        ends[first + i] = -1 - segment
    else:
        block.behind[i] = block.head[segment]
        block.head[segment] = i


@compiled
def _name(sizes: PathSizes, keys: PathKeys, of_word: WordKeys) -> None:
    """Compute the random keys of this frame's draws, by word."""
    for w in range(sizes.steps):
        number = np.uint64(w)
        of_word.reads[w] = bits(keys.reads, sizes.frame, number)
        of_word.resets[w] = bits(keys.resets, sizes.frame, number)
        of_word.compares[w] = bits(keys.compares, sizes.frame, number)
        for d in range(w * sizes.numbered, (w + 1) * sizes.numbered):
            of_word.words[d] = bits(keys.words, sizes.frame, np.uint64(d))


@compiled
def _draw(
    switches: Switches, sizes: PathSizes, word: LoopWord, w: int, of_word: WordKeys, place: int,
    running: Ints, count: int, normals: Floats,
) -> None:  # fmt: skip
    """Draw the normal numbers of a word: its read or reset, its comparison or destinations."""
    if word.resets and switches.reset_errors:
        _drawn(of_word.resets[w], place, running, count, normals, 0)
    if word.reads_pix and switches.read_errors:
        _drawn(of_word.reads[w], place, running, count, normals, 0)
    if word.compares and switches.compares_noisy:
        _drawn(of_word.compares[w], place, running, count, normals, BLOCK)
    for d in range(word.destinations if switches.word_errors else 0):
        key = of_word.words[w * sizes.numbered + d]
        _drawn(key, place, running, count, normals, (1 + d) * BLOCK)


@compiled
def _along(
    switches: Switches, sizes: PathSizes, numbers: Numbers, segment: int, first: int,
    program: LoopProgram, segments: Segments, charge: Charge, of_word: WordKeys,
    block: BlockScratch, state: PixelState, ends: Ints32,
) -> None:  # fmt: skip
    """Run a segment's words in all pixels of a block that wait for it, and queue each for its next
    segment."""
    count, i, place, running = 0, block.head[segment], sizes.first_place + first, state.running
    block.head[segment] = -1
    while i >= 0:
        running[count] = i
        count += 1
        i = block.behind[i]
    asks, normals = False, block.normals
    for e in range(segments.start[segment], segments.start[segment + 1]):
        w = segments.acting[e]
        word = program.words[w]
        if word.resets or word.reads_pix:
            _fall(switches, sizes, numbers, word, first, running, count, charge, state, block)
        _draw(switches, sizes, word, w, of_word, place, running, count, normals)
        if word.resets:
            reset(switches, numbers, word, BLOCK, count, state, normals, 0)
            continue
        add(switches, numbers, word, BLOCK, count, program, state, normals, 0)
        if word.compares:
            asks = True
            compare(switches, numbers, BLOCK, count, state, normals, BLOCK)
            continue
        write(switches, numbers, word, BLOCK, count, program, state, normals, BLOCK, BLOCK)
    for j in range(count):
        answer = 1 if asks and state.total[j] > 0.0 else 0
        _hand_on(segments.following[2 * segment + answer], first, running[j], block, ends)


@loop
def run_paths(
    switches: Switches,
    sizes: PathSizes,
    numbers: Numbers,
    device: OnDevice,
    keys: PathKeys,
    program: LoopProgram,
    segments: Segments,
    readouts: Readouts,
    begins: Annotated[Ints, "pixels"],
    charge: Charge,
    of_word: WordKeys,
    block: BlockScratch,
    state: PixelState,
    out: Written[Annotated[Floats, "buckets pixels"]],
    marked: Written[Annotated[Bytes, "buckets pixels"]],
    ends: Written[Annotated[Ints32, "pixels"]],
) -> None:
    """Set out[b, i] to the exposure of pixel i in bucket b in electrons, marked[b, i] to its
    saturation marks, and ends[i] to its ending.

    `begins`: the first segment of each pixel, or -1 - e for ending e. `of_word` to `state` are
    working memory."""
    _name(sizes, keys, of_word)
    for first in range(0, sizes.pixels, BLOCK):
        count, place = min(BLOCK, sizes.pixels - first), sizes.first_place + first
        _begin(switches, numbers, device, place, count, state.running, state, block)
        for i in range(count):
            _hand_on(begins[first + i], first, i, block, ends)
        for segment in range(sizes.segments):
            if block.head[segment] >= 0:
                _along(
                    switches, sizes, numbers, segment, first, program, segments, charge, of_word,
                    block, state, ends,
                )  # fmt: skip
        read_out(switches, numbers, BLOCK, count, readouts, state, sizes.pixels, first, out, marked)
