"""The compiled loop that runs pixels through their words, in blocks.

It computes the same as `nscc_runtime.reference`, event by event instead of slot by slot: the charge
of a stretch of slots between two words is one number. Neighbours in a block that are in one segment
run each of its words together. The answer of the comparison at its end selects the next segment; a
code of fixed shutters is one segment. `nscc_runtime.execution.block_scene` prepares the
arguments."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

from nscc.arrays import Bytes, Floats, Ints, Ints32
from nscc_runtime.execution.block_draws import drawn_normals
from nscc_runtime.execution.layout import (
    WORD_BLOCK,
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
from nscc_runtime.loop import Words, Written, compiled, inlined, loop, record
from nscc_runtime.noise.keys import bits


@record
class BlockSizes:
    """Sizes for the loop. Pixels `first` to `end` - 1 run, of the `charged` pixels whose charge is
    given; these are some of the `pixels` pixels of the result. `segments`, `words`: numbers of
    those of the program. `frame`: number of the frame, from 0."""

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
    """`electrons` (stretches, charged): the electrons that fall on a pixel in each stretch of
    slots. `pace` (stretches + 1, charged): the fraction of them that is collected per microsecond
    while words run at the start of a stretch; the last row is for the words after the last slot.
    Both are flat where the loop reads them, row after row."""

    electrons: Floats
    pace: Floats


class BlockScratch(NamedTuple):
    """Working memory of a block.

    `segment`: the segment (a part of a path between two comparisons) before which each of the
    `WORD_BLOCK` pixels waits, or -1 - e if it has reached ending e. `keys`: for each word, the
    random key of its read or reset, then those of its comparison or destinations (1 + `numbered`
    keys)."""

    segment: Written[Ints]
    keys: Written[Words]


@compiled
def _set_keys(sizes: BlockSizes, keys: WordKeys, program: LoopProgram, block: BlockScratch) -> None:
    """Set `block.keys` to the random keys of the program's words in frame `sizes.frame`. Keys that
    a word does not use keep their old values."""
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
    """Draw standard normal numbers for word number `w` in `count` pixels from number `first` on.

    state.normals gets them in rows of `WORD_BLOCK` numbers: row 0 for its read or reset, row 1 for
    its comparison, or row 1 + d for its destination d. Rows of effects that are off keep their old
    numbers. The numbers depend on `block.keys` and `places` only."""
    normals, at = state.normals, w * (1 + sizes.numbered)
    if (word.resets and switches.reset_errors) or (word.reads_pix and switches.read_errors):
        drawn_normals(block.keys[at], places, first, count, normals, 0)
    if word.compares and switches.compares_noisy:
        drawn_normals(block.keys[at + 1], places, first, count, normals, WORD_BLOCK)
    is_noisy = switches.word_errors and (word.adds or numbers.move_error)
    for d in range(word.destinations if is_noisy else 0):
        drawn_normals(block.keys[at + 1 + d], places, first, count, normals, (1 + d) * WORD_BLOCK)


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
    base: int,
) -> None:
    """Add to PIX (the photodiode) the charge that `count` pixels from number `first` on collect
    until `word` ends.

    `word` runs at the start of stretch number `stretch`; the charge of all stretches from the one
    that a pixel has reached up to this falls, and with slow words a part of this one. Note in
    `state.reached` and `state.fallen_fraction` how far each pixel is. Slots of a stretch are
    counted as one number."""
    total, pixels = state.total, sizes.charged
    fallen, reached, least = state.fallen_fraction, state.reached, stretch
    for j in range(count):
        least = min(least, reached[base + j])
    for k in range(least, stretch):
        for j in range(count):
            falls_now = reached[base + j] <= k
            charge_e = charge.electrons[k * pixels + first + j] * (1.0 - fallen[base + j])
            total[j] = charge_e if falls_now else 0.0
            fallen[base + j] = 0.0 if falls_now else fallen[base + j]
        fill(switches, numbers, count, state, base)
    for j in range(count):
        reached[base + j] = stretch
    if switches.slow_words:
        # After the last slot the light goes on as in that slot.
        k = stretch - 1 if word.last else stretch
        for j in range(count):
            at = first + j
            now = word.end_us * charge.pace[stretch * pixels + at]
            total[j] = charge.electrons[k * pixels + at] * (now - fallen[base + j])
            fallen[base + j] = now
        fill(switches, numbers, count, state, base)


@compiled
def _along(
    switches: Switches,
    sizes: BlockSizes,
    numbers: Numbers,
    segment: int,
    first: int,
    base: int,
    count: int,
    places: Ints,
    program: LoopProgram,
    segments: Segments,
    charge: Charge,
    block: BlockScratch,
    state: PixelState,
) -> None:
    """Run the words of `segment` in `count` pixels from number `base` of a block on, and set the
    next segment of each.

    `first`: number of the first of these pixels among the charged pixels. `places`: places of those
    on the chip. `block` and `state` are updated. A segment is the part of a path between two
    comparisons."""
    asks = False
    for e in range(segments.start[segment], segments.start[segment + 1]):
        w = segments.word[e]
        word = program.words[w]
        if word.resets or word.reads_pix:
            stretch = segments.stretch[e]
            _fall(switches, sizes, numbers, word, stretch, first, count, charge, state, base)
        _draw(switches, sizes, numbers, word, w, places, first, count, state, block)
        if word.resets:
            reset(switches, numbers, word, count, state, base)
            continue
        add(switches, numbers, word, count, program, state, base)
        if word.compares:
            asks = True
            compare(switches, numbers, count, state, base, WORD_BLOCK)
            continue
        write(switches, numbers, word, count, program, state, base, WORD_BLOCK)
    # Without a comparison, all pixels go on as if the answer were 0.
    after_0, after_1 = segments.following[2 * segment], segments.following[2 * segment + 1]
    for j in range(count):
        block.segment[base + j] = after_1 if asks and state.total[j] > 0.0 else after_0


@inlined
def _first_waiting(sizes: BlockSizes, count: int, block: BlockScratch) -> int:
    """Return the first segment (a part of a path between two comparisons) for which one of the
    first `count` pixels of a block waits; the number of segments if all have ended."""
    segment = sizes.segments
    for i in range(count):
        waits = block.segment[i] if block.segment[i] >= 0 else sizes.segments
        segment = min(segment, waits)
    return segment


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

    Pixels `sizes.first` to `sizes.end` - 1 of the charged pixels run. `begins`: the first segment
    (a part of a path between two comparisons) of each, or -1 - e if it has reached ending e
    already. `places`: its place on the chip, which names its random numbers. `chosen`: its index in
    the results. Pixels with the same first segments run together if they are neighbours in these
    arrays. `block` and `state` are working memory."""
    _set_keys(sizes, keys, program, block)
    for first in range(sizes.first, sizes.end, WORD_BLOCK):
        count = min(WORD_BLOCK, sizes.end - first)
        begin(switches, state, count)
        for i in range(count):
            place = places[first + i]
            state.pattern[i] = patterns.error_e[place]
            state.leak[i] = patterns.leak_per_s[place]
            state.offset[i] = patterns.offset_e[place]
        for i in range(count):
            block.segment[i] = begins[first + i]
        # Answers lead only to later segments: the first for which a pixel waits is next.
        segment = _first_waiting(sizes, count, block)
        while segment < sizes.segments:
            end = 0
            while end < count:
                base = end
                while base < count and block.segment[base] != segment:
                    base += 1
                end = base
                while end < count and block.segment[end] == segment:
                    end += 1
                if base < end:
                    _along(
                        switches,
                        sizes,
                        numbers,
                        segment,
                        first + base,
                        base,
                        end - base,
                        places,
                        program,
                        segments,
                        charge,
                        block,
                        state,
                    )
            segment = _first_waiting(sizes, count, block)
        for i in range(count):
            ends[chosen[first + i]] = -1 - block.segment[i]
        read_out(
            switches, numbers, count, readouts, state, sizes.pixels, chosen, first, out, marked
        )
