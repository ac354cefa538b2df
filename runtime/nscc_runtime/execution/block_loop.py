"""The compiled loop that runs pixels through their words, in blocks.

It computes the same as `nscc_runtime.reference`, event by event instead of slot by slot: the charge
of a stretch of slots between two words is one number. All pixels of a block that are in one segment
run each of its words together. The answer of the comparison at its end selects the next segment; a
code of fixed shutters is one segment. `nscc_runtime.execution.block_scene` prepares the
arguments."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

from nscc.arrays import Bytes, Floats, Ints, Ints32
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
from nscc_runtime.noise.gaussian import normal_fast
from nscc_runtime.noise.keys import bits
from nscc_runtime.noise.noise_loops import uniform


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

    `head`: the first pixel that waits before each segment (a part of a path between two
    comparisons), -1 if none. `behind`: the next waiting pixel after each pixel, -1 if none.
    `reached`: the stretch (slots between two reads or resets of PIX) that each pixel has reached.
    `fallen_fraction`: the fraction of this stretch that is collected. All but `head` have
    `WORD_BLOCK` numbers, and pixels are numbered from the first of the block. `keys`: for each
    word, the random key of its read or reset, then those of its comparison or destinations (1 +
    `numbered` keys)."""

    head: Written[Annotated[Ints, "segments"]]
    behind: Written[Ints]
    reached: Written[Ints]
    fallen_fraction: Written[Floats]
    keys: Written[Words]


@inlined
def _drawn(
    key: np.uint64, places: Ints, first: int, running: Ints, count: int, normals: Floats, at: int
) -> None:
    """Set normals[at + j], for j below `count`, to the standard normal number of `key` at the place
    of pixel running[j] of the block whose first pixel is `first`."""
    for j in range(count):
        normals[at + j] = uniform(key, places[first + running[j]])
    for j in range(count):
        normals[at + j] = float(normal_fast(normals[at + j]))


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
    """Draw standard normal numbers for word number `w` in the `count` pixels state.running of the
    block that begins with pixel `first`.

    state.normals gets them in rows of `WORD_BLOCK` numbers: row 0 for its read or reset, row 1 for
    its comparison, or row 1 + d for its destination d. Rows of effects that are off keep their old
    numbers. The numbers depend on `block.keys` and `places` only."""
    running, normals, at = state.running, state.normals, w * (1 + sizes.numbered)
    if (word.resets and switches.reset_errors) or (word.reads_pix and switches.read_errors):
        _drawn(block.keys[at], places, first, running, count, normals, 0)
    if word.compares and switches.compares_noisy:
        _drawn(block.keys[at + 1], places, first, running, count, normals, WORD_BLOCK)
    is_noisy = switches.word_errors and (word.adds or numbers.move_error)
    for d in range(word.destinations if is_noisy else 0):
        key = block.keys[at + 1 + d]
        _drawn(key, places, first, running, count, normals, (1 + d) * WORD_BLOCK)


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
    """Add to PIX (the photodiode) the charge that the pixels state.running[:count] collect until
    `word` ends.

    `word` runs at the start of stretch number `stretch`; the charge of all stretches from the one
    that a pixel has reached up to this falls, and with slow words a part of this one. Pixels count
    from `first`, the first of the block. Note in `block.reached` and `block.fallen_fraction` how
    far each pixel is. A stretch is the slots between two reads or resets of PIX, the photodiode."""
    pixels = sizes.charged
    for j in range(count):
        i = state.running[j]
        at = switches.registers * WORD_BLOCK + i
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
    """Queue pixel i of a block for `segment`, and return 1. If `segment` is -1 - e, the pixel has
    reached ending e: store e in ends[at], and return 0. `at` is the pixel's index in the result."""
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
    """Run the words of `segment` in all pixels of a block that wait for it, queue each for its next
    segment, and return the number of pixels that have reached an ending.

    `first`: the first pixel of the block. `places`: places of the charged pixels on the chip.
    `chosen`: their indices in the result, where `ends` gets their endings. `block` and `state` are
    updated. A segment is the part of a path between two comparisons."""
    count, i, running = 0, block.head[segment], state.running
    block.head[segment] = -1
    # The pixels that wait form a linked list; they are copied to `running`, so that loops are
    # simple.
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
            compare(switches, numbers, count, state, WORD_BLOCK)
            continue
        write(switches, numbers, word, count, program, state, WORD_BLOCK)
    ended = count
    # Without a comparison, all pixels go on as if the answer were 0.
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

    Pixels `sizes.first` to `sizes.end` - 1 of the charged pixels run. `begins`: the first segment
    (a part of a path between two comparisons) of each, or -1 - e if it has reached ending e
    already. `places`: its place on the chip, which names its random numbers. `chosen`: its index in
    the results. Pixels with the same first segments run together if they are neighbours in these
    arrays. `block` and `state` are working memory; block.head must be -1 everywhere, and is so
    again at the end."""
    _set_keys(sizes, keys, program, block)
    for first in range(sizes.first, sizes.end, WORD_BLOCK):
        count = min(WORD_BLOCK, sizes.end - first)
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
        # Answers lead only to later segments, so one pass in ascending order meets all of them.
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
