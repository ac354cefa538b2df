"""The words of a program as segments for the block loop, with the stretches of slots between them.

A code of fixed shutters is one segment, whose words follow from replaying the digital words of that
code. Pixels that look have a segment for every answer (`nscc_runtime.looking.paths`)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from nscc.arrays import Bools, Floats, Ints, Ints32
from nscc.words.container import Container
from nscc_runtime.caches import OfContainer
from nscc_runtime.effects import CannotHave, Selection, everything
from nscc_runtime.effects.in_loops import figures, switches
from nscc_runtime.effects.parts import Exchange
from nscc_runtime.effects.registry import of_registered
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.layout import (
    LoopProgram,
    LoopWord,
    Numbers,
    Readouts,
    Segments,
    Switches,
)
from nscc_runtime.execution.overlap import MOST_EXCHANGED, NEIGHBOURS
from nscc_runtime.execution.stretch_loop import Stretches
from nscc_runtime.looking.paths import Paths, paths_of
from nscc_runtime.reference.trace import (
    AnalogWord,
    RunningWord,
    analog_words,
    readout_waits_s,
    retention_us,
)
from nscc_runtime.reference.weights import error_sign
from nscc_runtime.reference.words import most_destinations
from nscc_runtime.run_kinds import KINDS

_WORD = np.dtype(LoopWord)
AROUND_WORDS = {
    "scene",
    "light",
    "response",
    "count",
    "charge",
    "neighbours",
    "converter",
    "codes",
}
"""Stages before and after the words of a frame, at which the loop is not involved."""


@dataclass(frozen=True, eq=False)
class BlockProgram:
    """A program for the block loop.

    Attributes
    ----------
    words, segments, readouts
        Arguments of the loop.
    stretches : Stretches
        The stretches of slots of each lane.
    lane : int32, shape (rows, cols)
        The number of the lane whose stretches each pixel has; 0 for all pixels that look.
    counted : int32, shape (rows, cols)
        The number of the lane in whose stretches the electrons of each pixel are counted; usually
        `lane` itself.
    first_segment : int64, shape (rows, cols)
        The segment with which each pixel starts, or -1 - e for ending e of a pixel that looks.
    numbered : int
        Difference between the draw numbers of consecutive words.
    most_stretches : int
        Largest number of stretches of a lane.
    """

    words: LoopProgram
    segments: Segments
    readouts: Readouts
    stretches: Stretches
    lane: Ints32
    counted: Ints32
    first_segment: Ints
    numbered: int

    @cached_property
    def most_stretches(self) -> int:
        """The largest number of stretches (groups of slots between reads or resets of PIX) of a
        lane (the pixels of one distinct shutter)."""
        return int(np.diff(self.stretches.start).max()) - 1


@OfContainer
def lacks(container: Container, sensor: Sensor, effects: Selection) -> tuple[str, ...]:
    """Return the reasons, each a text, why only the reference simulates a program with these
    effects; empty if the block loop does. There is one for each effect that the loop lacks, and one
    if the program has too many paths of answers."""
    reasons = [
        f"{effect.name}: only the reference has it ({effect.words.reason})"
        for effect in effects.effects
        if isinstance(effect.words, CannotHave) and not effect.reference.keys() <= AROUND_WORDS
    ]
    if not KINDS.of(container).open_times_known:
        paths = paths_of(container, retention_us(effects, sensor))
        reasons += [f"the words run one by one: {paths}"] if isinstance(paths, str) else []
    return tuple(reasons)


@OfContainer
def block_program(container: Container, sensor: Sensor, effects: Selection) -> BlockProgram:
    """Return a program for the block loop with these effects; cached with the container (a compiled
    program).

    All sets of effects count in the same stretches, so that they have the same random numbers, with
    one exception: without decay of digital registers, words may run that otherwise do not.
    Raises Rejected if a word is no operation of the chip
    (`nscc_runtime.reference.trace.analog_words`), and ValueError if pixels look and their paths
    cannot be listed."""
    strongest = everything().find_part(Exchange)
    jointly = strongest is not None and strongest.fraction(sensor) > MOST_EXCHANGED
    return _program(container, retention_us(effects, sensor), effects.without_effects, jointly)


@OfContainer
def _program(container: Container, kept_us: float, every_slot: bool, jointly: bool) -> BlockProgram:
    """Return a program for the block loop, cached with the container (a compiled program).

    `kept_us`: how long digital registers keep values, in microseconds. `every_slot`: whether each
    slot of a program that looks is a stretch of its own, so that light is added in the order in
    which exposures are defined; ignored for fixed shutters. `jointly`: whether electrons are
    counted in the stretches that a pixel or any of its neighbours distinguishes. Slots of a stretch
    are counted as one number."""
    if KINDS.of(container).open_times_known:
        program = _of_codes(container, analog_words(container, kept_us))
        return _counting_jointly(program) if jointly else program
    paths = paths_of(container, kept_us)
    if isinstance(paths, str):
        raise ValueError(paths)
    return _of_paths(container, paths, every_slot)


def _of_codes(container: Container, words: tuple[AnalogWord, ...]) -> BlockProgram:
    """Return the program in which each lane is a segment: the `words` that act in it, and the
    stretches of slots between those that read or reset PIX (the photodiode). `words`: all bus and
    reset words of a frame in order. A segment is the part of a path between two comparisons."""
    assert container.pixel_codes is not None
    lanes, slots = len(container.encoding), container.slots
    acts = np.array([word.lanes for word in words], np.bool_).reshape(-1, lanes)
    table = program_of(container, words)
    resets, reads = (table.words[name].astype(np.bool_) for name in ("resets", "reads_pix"))
    lane, word = np.nonzero(acts.T)
    lane, word = _in_use(lane, word, resets, reads)
    turns = resets | reads  # a new stretch begins at the boundary of such a word
    boundary = np.array([each.boundary for each in words], np.int64)[word]
    # A boundary of a lane as one number: ascending by lane, then by slot.
    numbers = lane * (slots + 1) + boundary
    ends = np.arange(lanes) * (slots + 1)
    known = np.unique(np.concatenate([numbers[turns[word]], ends, ends + slots]))
    lane_start = np.searchsorted(known, np.append(ends, lanes * (slots + 1))).astype(np.int64)
    stretch = np.searchsorted(known, numbers) - lane_start[lane]
    segments = Segments(
        start=np.searchsorted(lane, np.arange(lanes + 1)).astype(np.int64),
        word=word.astype(np.int32),
        stretch=stretch.astype(np.int32),
        following=np.full((lanes, 2), -1, np.int64),
    )
    stretches = Stretches.of(
        lane_start, (known % (slots + 1)).astype(np.int32), _start_s(container)
    )
    pixel_lane = container.table.shutter_of_code[container.pixel_codes]
    lane_of_pixel = np.require(pixel_lane, np.int32, ["C"])
    return BlockProgram(
        table,
        segments,
        readouts_of(container, words),
        stretches,
        lane_of_pixel,
        lane_of_pixel,
        np.require(pixel_lane, np.int64, ["C"]),
        most_destinations(container.target),
    )


def _counting_jointly(program: BlockProgram) -> BlockProgram:
    """Return the program with stretches of slots for the counts of electrons: those of each pixel
    begin at all boundaries of its own lane and of its neighbours', so that what it gives to each
    stretch of a neighbour is counted. A lane is the pixels of one distinct shutter."""
    stretches, lane = program.stretches, program.lane
    lanes, slots = len(stretches.start) - 1, len(stretches.start_s) - 1
    begins = np.zeros((lanes, slots + 1), np.bool_)
    begins[np.repeat(np.arange(lanes), np.diff(stretches.start)), stretches.boundary] = True
    packed = np.packbits(begins, axis=1)
    joint = packed[lane]
    for to, source in NEIGHBOURS:
        joint[to] |= packed[lane[source]]
    distinct, number = np.unique(joint.reshape(lane.size, -1), axis=0, return_inverse=True)
    of_joint, boundary = np.nonzero(np.unpackbits(distinct, axis=1, count=slots + 1))
    start = len(stretches.boundary) + np.cumsum(np.bincount(of_joint))
    counted = Stretches.of(
        np.concatenate([stretches.start, start]),
        np.concatenate([stretches.boundary, boundary.astype(np.int32)]),
        stretches.start_s,
    )
    counted_lane = (lanes + number.reshape(lane.shape)).astype(np.int32)
    return replace(program, stretches=counted, counted=counted_lane)


def _in_use(
    lane: Ints,
    word: Ints,
    resets: Bools,
    reads: Bools,
) -> tuple[Ints, Ints]:
    """Return the two arrays without resets of PIX (the photodiode) that no read follows before the
    lane's next reset: nothing depends on them.

    `lane`, `word`: entry i says that word number word[i] acts in lane lane[i]; sorted by lane (the
    pixels of one distinct shutter), then by word. `resets`, `reads` (words,): whether a word resets
    PIX, or reads it."""
    on_pix = np.flatnonzero(resets[word] | reads[word])
    is_read = np.zeros(len(on_pix), np.bool_)
    is_read[:-1] = reads[word[on_pix[1:]]] & (lane[on_pix[1:]] == lane[on_pix[:-1]])
    unused = on_pix[resets[word[on_pix]] & ~is_read]
    return np.delete(lane, unused), np.delete(word, unused)


def _of_paths(container: Container, paths: Paths, every_slot: bool) -> BlockProgram:
    """Return the program of pixels that look: its segments are those of `paths`, which end with a
    comparison or at the end of the frame.

    All pixels have the same stretches of slots, which begin at the boundaries where words run, or
    with `every_slot` at all boundaries. Pixels begin in the segment of their code."""
    assert container.pixel_codes is not None
    slots, shape = container.slots, container.pixel_codes.shape
    bounds = range(slots + 1) if every_slot else (word.boundary for word in paths.words)
    boundaries = np.unique([0, slots, *bounds])
    of_word = np.searchsorted(boundaries, [word.boundary for word in paths.words])
    segments = Segments(
        start=paths.start,
        word=paths.acting.astype(np.int32),
        stretch=of_word[paths.acting].astype(np.int32),
        following=paths.following,
    )
    stretches = Stretches.of(
        np.array([0, len(boundaries)], np.int64), boundaries.astype(np.int32), _start_s(container)
    )
    loaded = {name: plane.astype(np.bool_) for name, plane in container.planes().items()}
    lane = np.zeros(shape, np.int32)
    return BlockProgram(
        program_of(container, paths.words),
        segments,
        readouts_of(container, paths.words),
        stretches,
        lane,
        lane,
        np.ascontiguousarray(paths.begins(loaded, shape)),
        most_destinations(container.target),
    )


def _start_s(container: Container) -> Floats:
    """Return the times in seconds, (slots + 1,), at which each slot begins, then the end of the
    last one; the frame begins at 0."""
    return np.concatenate(([0.0], np.cumsum(container.slot_us))) * 1e-6


def program_of(container: Container, words: Sequence[RunningWord]) -> LoopProgram:
    """Return the `words` as a table of numbers for the compiled loop, in their order. Its operands
    are numbers of the analog registers in use, then of PIX (the photodiode) and of IN: for each
    word the sources, then the destinations. IN is the level sent to all pixels."""
    names = registers_of(container, words)
    registers = (*names, "PIX", "IN")
    slots, slot_us, start_s = container.slots, container.slot_us, _start_s(container)
    rows: list[tuple[float, ...]] = []
    operands: list[int] = []
    for word in words:
        last = word.boundary == slots
        row = {
            "resets": word.resets,
            "compares": word.compares,
            "reads_pix": "PIX" in word.sources,
            "adds": word.adds,
            "sources": len(word.sources),
            "destinations": len(word.destinations),
            "operands": len(operands),
            "last": last,
            "end_us": word.after_us if last else min(word.after_us, slot_us[word.boundary]),
            "time_s": start_s[word.boundary],
            "divisor": word.op.operation.divisor,
            "in_e": word.in_e,
        }
        rows.append(tuple(row[name] for name in _WORD.names or ()))
        operands += [registers.index(name) for name in word.sources + word.destinations]
    signs = [error_sign(name, container) for name in names]
    return LoopProgram(np.array(rows, _WORD), np.array(operands, np.int64), np.array(signs))


def registers_of(container: Container, words: Sequence[RunningWord]) -> list[str]:
    """Return the analog registers that any of the `words` names or that are read out, in the
    target's order: few, so that those of a block of pixels fit into the fastest cache."""
    named = {readout.register for readout in container.readouts}
    named.update(name for word in words for name in (*word.sources, *word.destinations))
    return [name for name in container.target.analog_registers if name in named]


def readouts_of(container: Container, words: Sequence[RunningWord]) -> Readouts:
    """Return for each bucket, in the container's order, the number of the analog register that is
    read out, the gain, and the time (s) from the end of the exposure to its readout. `words`: of
    the program. Raises KeyError for a bucket that is not read out."""
    of_bucket = {readout.bucket: readout for readout in container.readouts}
    readouts = [of_bucket[bucket] for bucket in container.buckets]
    place = registers_of(container, words).index
    return Readouts(
        np.array([place(readout.register) for readout in readouts], np.int64),
        np.array([float(readout.gain) for readout in readouts]),
        readout_waits_s(container),
    )


@OfContainer
def numbers_of(container: Container, sensor: Sensor, effects: Selection) -> Numbers:
    """Return the parameters of `effects` for the compiled loop, with the values of `sensor`; 0 for
    effects that are off. `frame_s`, the sum of the slots, is always set."""
    mark = effects.marking("registers")
    return Numbers(
        least_lost=mark.least_e(sensor) if mark else 0.0,
        frame_s=float(np.cumsum(container.slot_us)[-1]) * 1e-6,
        **figures(sensor, effects),
    )


@of_registered
def switches_of(registers: int, buckets: int, effects: Selection) -> Switches:
    """Return which effects the compiled loop simulates, the bits of their saturation marks (0 for
    marks that no effect sets), and the numbers of analog registers in use and of buckets."""
    marks = {at: effects.marking(at) for at in ("well", "subtracted", "level", "registers")}
    return Switches(
        registers=registers,
        buckets=buckets,
        **switches(effects),
        **{f"{at}_bit": mark.bit if mark else 0 for at, mark in marks.items()},
    )
