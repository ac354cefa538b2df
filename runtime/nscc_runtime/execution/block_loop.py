"""The compiled loop that runs pixels through their words, in blocks.

It computes the same as `nscc_runtime.reference`, event by event instead of slot by slot: the charge
of a stretch of slots between two words is one number. All pixels of a block that are in one segment
run each of its words together. The answer of the comparison at its end selects the next segment; a
code of fixed shutters is one segment. `nscc_runtime.execution.block_scene` prepares the
arguments."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

from nscc_runtime.execution.layout import (
    BLOCK,
    FixedPatterns,
    LoopProgram,
    LoopWord,
    Numbers,
    PixelState,
    Readouts,
    Segments,
    Switches,
    WordKeys,
)
from nscc_runtime.execution.word_loop import add, begin, compare, fill, read_out, reset, write
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
from nscc_runtime.noise.gaussian import normal_fast
from nscc_runtime.noise.keys import bits, unit

_FIRST_LANE = np.uint64(0)


@record
class BlockSizes:
    """Sizes for the loop: pixels `first` to `end` - 1 of `charged` pixels with charge run, which
    belong to `pixels` pixels of the result."""

    first: int
    end: int
    charged: int
    pixels: int
    segments: int
    words: int
    numbered: int
    """Difference between the draw numbers of consecutive words."""
    frame: int


class Charge(NamedTuple):
    """The electrons of each stretch, and the fraction of them that is collected per microsecond
    while words run (`pace`; the last row is for the words after the last slot)."""

    electrons: Floats
    pace: Floats


class BlockScratch(NamedTuple):
    """Working memory of a block.

    `head`: the first pixel that waits before each segment, -1 if none. `behind`: the next waiting
    pixel after each pixel. `reached`: the stretch that each pixel has reached. `fallen_fraction`:
    the fraction of this stretch that is collected. `keys`: the random keys of each word: of its
    read or reset, then of its comparison or destinations."""

    head: Written[Annotated[Ints, "segments"]]
    behind: Written[Ints]
    reached: Written[Ints]
    fallen_fraction: Written[Floats]
    keys: Written[Words]


@inlined
def _drawn(
    key: np.uint64, places: Ints, first: int, running: Ints, count: int, normals: Floats, at: int
) -> None:
    """Set normals[at + j] to the normal number of a key at the pixel running[j] of a block."""
    for j in range(count):
        normals[at + j] = unit(bits(key, places[first + running[j]], _FIRST_LANE))
    for j in range(count):
        normals[at + j] = float(normal_fast(normals[at + j]))


@compiled
def _set_keys(sizes: BlockSizes, keys: WordKeys, program: LoopProgram, block: BlockScratch) -> None:
    """Set the random keys of the words in this frame."""
    for w in range(sizes.words):
        word, at = program.words[w], w * (1 + sizes.numbered)
        stream = keys.resets if word.resets else keys.reads
        block.keys[at] = bits(stream, sizes.frame, np.uint64(w))
        if word.compares:
            block.keys[at + 1] = bits(keys.compares, sizes.frame, np.uint64(w))
        for d in range(word.destinations):
            number = np.uint64(w * sizes.numbered + d)
            block.keys[at + 1 + d] = bits(keys.words, sizes.frame, number)


@compiled
def _draw(
    switches: Switches,
    sizes: BlockSizes,
    numbers: Numbers,
    word: LoopWord,
    w: int,
    places: Ints,
    first: int,
    count: int,
    state: PixelState,
    block: BlockScratch,
) -> None:
    """Draw normal numbers for word number `w`, for its read or reset, its comparison and each of
    its destinations, into `state.normals`.

    The numbers of the pixels first + state.running[:count] depend on `block.keys` and `places`
    only."""
    running, normals, at = state.running, state.normals, w * (1 + sizes.numbered)
    if (word.resets and switches.reset_errors) or (word.reads_pix and switches.read_errors):
        _drawn(block.keys[at], places, first, running, count, normals, 0)
    if word.compares and switches.compares_noisy:
        _drawn(block.keys[at + 1], places, first, running, count, normals, BLOCK)
    is_noisy = switches.word_errors and (word.adds or numbers.move_error)
    for d in range(word.destinations if is_noisy else 0):
        key = block.keys[at + 1 + d]
        _drawn(key, places, first, running, count, normals, (1 + d) * BLOCK)


@compiled
def _fall(
    switches: Switches,
    sizes: BlockSizes,
    numbers: Numbers,
    word: LoopWord,
    stretch: int,
    first: int,
    count: int,
    charge: Charge,
    state: PixelState,
    block: BlockScratch,
) -> None:
    """Add to PIX the charge that the pixels state.running[:count] collect until `word` ends, which
    is in stretch number `stretch`. Advances `block`."""
    pixels = sizes.charged
    for j in range(count):
        i = state.running[j]
        at = switches.registers * BLOCK + i
        for k in range(block.reached[i], stretch):
            charge_e = charge.electrons[k * pixels + first + i] * (1.0 - block.fallen_fraction[i])
            fill(switches, numbers, state, at, charge_e)
            block.fallen_fraction[i] = 0.0
        block.reached[i] = stretch
        if switches.slow_words:
            # After the last slot the light goes on as in that slot.
            k = stretch - 1 if word.last else stretch
            now = word.end_us * charge.pace[stretch * pixels + first + i]
            charge_e = charge.electrons[k * pixels + first + i] * (now - block.fallen_fraction[i])
            fill(switches, numbers, state, at, charge_e)
            block.fallen_fraction[i] = now


@inlined
def _hand_on(segment: int, at: int, i: int, block: BlockScratch, ends: Ints32) -> int:
    """Queue pixel i for `segment`, and return 1. A negative number is an ending, which is stored in
    ends[at]; return 0 for it."""
    if segment < 0:
        ends[at] = -1 - segment
        return 0
    block.behind[i] = block.head[segment]
    block.head[segment] = i
    return 1


@compiled
def _along(
    switches: Switches,
    sizes: BlockSizes,
    numbers: Numbers,
    segment: int,
    first: int,
    places: Ints,
    chosen: Ints,
    program: LoopProgram,
    segments: Segments,
    charge: Charge,
    block: BlockScratch,
    state: PixelState,
    ends: Ints32,
) -> int:
    """Run a segment's words in all pixels of a block that wait for it, queue each for its next
    segment, and return the number of pixels that have ended."""
    count, i, running = 0, block.head[segment], state.running
    block.head[segment] = -1
    while i >= 0:
        running[count] = i
        count += 1
        i = block.behind[i]
    asks = False
    for e in range(segments.start[segment], segments.start[segment + 1]):
        w = segments.word[e]
        word = program.words[w]
        if word.resets or word.reads_pix:
            stretch = segments.stretch[e]
            _fall(switches, sizes, numbers, word, stretch, first, count, charge, state, block)
        _draw(switches, sizes, numbers, word, w, places, first, count, state, block)
        if word.resets:
            reset(switches, numbers, word, count, state)
            continue
        add(switches, numbers, word, count, program, state)
        if word.compares:
            asks = True
            compare(switches, numbers, count, state, BLOCK)
            continue
        write(switches, numbers, word, count, program, state, BLOCK)
    ended = count
    for j in range(count):
        answer = 1 if asks and state.total[j] > 0.0 else 0
        at = chosen[first + running[j]]
        ended -= _hand_on(segments.following[2 * segment + answer], at, running[j], block, ends)
    return ended


@loop
def run_blocks(
    switches: Switches,
    sizes: BlockSizes,
    numbers: Numbers,
    keys: WordKeys,
    program: LoopProgram,
    segments: Segments,
    readouts: Readouts,
    begins: Annotated[Ints, "charged"],
    places: Ints,
    chosen: Annotated[Ints, "charged"],
    patterns: FixedPatterns,
    charge: Charge,
    block: BlockScratch,
    state: PixelState,
    out: Written[Annotated[Floats, "buckets pixels"]],
    marked: Written[Annotated[Bytes, "buckets pixels"]],
    ends: Written[Annotated[Ints32, "pixels"]],
) -> None:
    """Run pixels through their words: set out[b, chosen[i]] to the exposure of pixel i in bucket b
    in electrons, marked[b, chosen[i]] to its saturation marks, and ends[chosen[i]] to its ending.

    `begins`: the first segment of each pixel, or -1 - e for ending e. `places`: its place on the
    chip, which names its random numbers. Pixels with the same first segments run together if they
    are neighbours in these arrays. `block` and `state` are working memory."""
    _set_keys(sizes, keys, program, block)
    for first in range(sizes.first, sizes.end, BLOCK):
        count = min(BLOCK, sizes.end - first)
        for i in range(count):
            block.reached[i], block.fallen_fraction[i] = 0, 0.0
            begin(switches, state, i)
            state.pattern[i] = patterns.error_e[first + i]
            state.leak[i] = patterns.leak_per_s[first + i]
            state.offset[i] = patterns.offset_e[first + i]
        waiting, segment = 0, sizes.segments
        for i in range(count):
            waiting += _hand_on(begins[first + i], chosen[first + i], i, block, ends)
            if 0 <= begins[first + i] < segment:
                segment = begins[first + i]
        # Answers lead only to later segments.
        while waiting > 0:
            if block.head[segment] >= 0:
                waiting -= _along(
                    switches,
                    sizes,
                    numbers,
                    segment,
                    first,
                    places,
                    chosen,
                    program,
                    segments,
                    charge,
                    block,
                    state,
                    ends,
                )
            segment += 1
        read_out(
            switches, numbers, count, readouts, state, sizes.pixels, chosen, first, out, marked
        )
