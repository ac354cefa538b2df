"""The compiled loop that runs single pixels through their words, event by event.

It computes the same as `nscc_runtime.reference`, with the same keyed random numbers, but moves from
word to word instead of from slot to slot. The charge between two words results from halving counts
(`nscc_runtime.noise.thin`), so programs with few words are fast for any number of slots.
`nscc_runtime.execution.pixels` prepares the arguments."""

from __future__ import annotations

from typing import Annotated

from nscc_runtime.effects.spread import log_normal_in_loop
from nscc_runtime.execution.charge_loop import (
    Away,
    CountScratch,
    Sites,
    charge,
    charge_evenly,
    least_charge,
    streams_of,
)
from nscc_runtime.execution.layout import (
    ACTS,
    SEEN,
    Keys,
    LoopProgram,
    LoopWord,
    Numbers,
    OnDevice,
    PixelState,
    Readouts,
    Sizes,
    Switches,
)
from nscc_runtime.execution.word_loop import (
    ADDED,
    READS,
    RESETS,
    WORDS,
    ErrorScratch,
    Lanes,
    add,
    begin,
    draw_errors,
    fill,
    read_out,
    reset,
    write,
)
from nscc_runtime.loop import Bytes, Floats, Ints, Words, Written, compiled, loop
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.noise_loops import uniform


@compiled
def _surround(sizes: Sizes, place: int, places: Ints) -> None:
    """Set `places` to a pixel and its neighbours above, below, left, right; -1 outside."""
    rows, cols = sizes.rows, sizes.cols
    row, col = place // cols, place % cols
    places[0] = place
    places[1] = place - cols if row > 0 else -1
    places[2] = place + cols if row + 1 < rows else -1
    places[3] = place - 1 if col > 0 else -1
    places[4] = place + 1 if col + 1 < cols else -1


@compiled
def _begin(
    switches: Switches, sizes: Sizes, numbers: Numbers, device: OnDevice, start_keys: Words,
    place: int, state: PixelState,
) -> None:  # fmt: skip
    """Set a pixel's fixed patterns and initial registers. `start_keys` begins with PIX's key."""
    begin(switches, 1, state, 0)
    if sizes.stale:
        for register in range(switches.registers):
            start = uniform(start_keys[register + 1], place) / 2.0
            state.value[register] = start * numbers.register_start
        state.value[switches.registers] = uniform(start_keys[0], place) / 2.0 * numbers.pix_start
    if switches.word_errors:
        z = normal(uniform(device.pattern, place))
        state.pattern[0] = numbers.bias + numbers.pattern * z
    if switches.leaks:
        z = normal(uniform(device.leak, place))
        state.leak[0] = numbers.leak * log_normal_in_loop(numbers.leak_variance, z)


@compiled
def _of_slot(
    sizes: Sizes, numbers: Numbers, n: int, sites: Sites, away: Away, counts: CountScratch
) -> float:
    """Return the charge of slot n, during which words run."""
    if sizes.counts_known:
        return charge_evenly(sizes, numbers, n, n + 1, sites, away, counts)
    return charge(sizes, numbers, n, n + 1, sites, away, counts)


@compiled
def _fallen(
    switches: Switches, sizes: Sizes, numbers: Numbers, at: int, stop: int, gone: float,
    of_slot: float, sites: Sites, away: Away, counts: CountScratch, pix_e: float,
) -> float:  # fmt: skip
    """Return the charge of the slots `at` to `stop` - 1, except the fraction `gone` of the first
    slot.

    `of_slot`: the charge of the first slot. If PIX, which contains `pix_e`, certainly becomes full,
    the returned charge is larger than the full well instead."""
    first = at if gone == 0.0 else at + 1
    if switches.holds:
        least = least_charge(sizes, numbers, counts.places[0], first, stop, sites)
        if pix_e + least > numbers.well:
            return 2.0 * numbers.well
    if sizes.counts_known:
        # The range of slots is usually a whole group, so no count has to be halved.
        first = at
    charge_e = charge(sizes, numbers, first, stop, sites, away, counts)
    if gone == 0.0:
        return charge_e
    charge_e += (0.0 if sizes.counts_known else of_slot) - gone * of_slot
    return charge_e if charge_e > 0.0 else 0.0


@compiled
def _execute(
    switches: Switches, numbers: Numbers, word: LoopWord, program: LoopProgram, state: PixelState,
    drawn: Floats, first: int,
) -> None:  # fmt: skip
    """Run one word, whose errors are drawn[first] and following."""
    if word.resets:
        reset(switches, numbers, word, 1, 1, state, drawn, first)
        return
    add(switches, numbers, word, 1, 1, program, state, drawn, first)
    write(switches, numbers, word, 1, 1, program, state, drawn, first + 1, 1)


@compiled
def _run(
    switches: Switches, sizes: Sizes, numbers: Numbers, lane: int, slot_us: Floats, lanes: Lanes,
    program: LoopProgram, sites: Sites, away: Away, counts: CountScratch, drawn: Floats,
    state: PixelState,
) -> None:  # fmt: skip
    """Run a pixel through its words, and add the charge of the slots between them."""
    slots, pix, first = sizes.slots, switches.registers, lanes.start[lane]
    at, gone = 0, 0.0
    single, of_single = -1, 0.0
    for e in range(first, lanes.start[lane + 1]):
        if not lanes.flags[e] & ACTS:
            continue
        word = program.words[lanes.word[e]]
        # Charge that is not read before PIX is reset, and charge on a full PIX, is not computed.
        is_read = lanes.flags[e] & SEEN > 0
        if at < word.begins:
            if is_read and not state.full[pix] & ADDED:
                if gone > 0.0 and single != at:
                    single = at
                    of_single = _of_slot(sizes, numbers, at, sites, away, counts)
                charge_e = _fallen(
                    switches, sizes, numbers, at, word.begins, gone, of_single, sites, away, counts,
                    state.value[pix],
                )  # fmt: skip
                fill(switches, numbers, state, pix, charge_e)
            at, gone = word.begins, 0.0
        if switches.slow_words:
            slot = at if at < slots else slots - 1
            now = word.end_us / slot_us[slot]
            if is_read and not state.full[pix] & ADDED and now > gone:
                if single != slot:
                    single = slot
                    of_single = _of_slot(sizes, numbers, slot, sites, away, counts)
                fill(switches, numbers, state, pix, (now - gone) * of_single)
            gone = now
        _execute(switches, numbers, word, program, state, drawn, (e - first) * sizes.draws)


@loop
def run_pixels(
    switches: Switches,
    sizes: Sizes,
    numbers: Numbers,
    device: OnDevice,
    keys: Keys,
    chosen: Annotated[Ints, "pixels"],
    slot_us: Annotated[Floats, "slots"],
    group_ids: Annotated[Words, "groups"],
    start_keys: Annotated[Words, "registers+1"],
    lanes: Lanes,
    program: LoopProgram,
    readouts: Readouts,
    sites: Sites,
    away: Away,
    counts: CountScratch,
    errors: ErrorScratch,
    state: PixelState,
    out: Written[Annotated[Floats, "buckets pixels"]],
    marked: Written[Annotated[Bytes, "buckets pixels"]],
) -> None:
    """Set out[b, i] to the exposure of pixel chosen[i] in bucket b in electrons, and marked[b, i]
    to its saturation marks.

    `group_ids`: numbers of the groups of slots in random keys. `start_keys`: random keys of
    register contents at the start of a frame. `counts` to `state` are working memory. Places in
    ascending order find most of their neighbours' counts in the cache."""
    streams_of(sizes, keys, group_ids, counts.streams)
    buckets, words = switches.buckets, program.words
    for i in range(sizes.pixels):
        place = chosen[i]
        lane = lanes.of_pixel[place]
        _surround(sizes, place, counts.places)
        if switches.read_errors:
            draw_errors(
                sizes, buckets, keys.sum_reads, keys.part_reads, place, lane, lanes, words, READS,
                errors,
            )  # fmt: skip
        if switches.reset_errors:
            draw_errors(
                sizes, buckets, keys.sum_resets, keys.part_resets, place, lane, lanes, words,
                RESETS, errors,
            )  # fmt: skip
        if switches.word_errors:
            draw_errors(
                sizes, buckets, keys.sum_words, keys.part_words, place, lane, lanes, words, WORDS,
                errors,
            )  # fmt: skip
        _begin(switches, sizes, numbers, device, start_keys, place, state)
        _run(
            switches, sizes, numbers, lane, slot_us, lanes, program, sites, away, counts,
            errors.drawn, state,
        )  # fmt: skip
        read_out(switches, numbers, 1, 1, readouts, state, sizes.pixels, i, out, marked)
