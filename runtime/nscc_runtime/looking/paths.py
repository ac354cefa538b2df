"""All paths of a pixel through a frame, found by replaying digital words.

The analog words that act in a pixel depend only on its bits, and these only on the answers of its
comparisons. So the digital words run once, for all bits at the start of a frame and for all
answers. The result are segments: analog words that end with a comparison, whose answer leads to one
of two further segments or to the end of the frame. Words that influence no exposure and no
comparison are dropped, and so are comparisons whose answers lead to the same segment. A bit that
was neither loaded nor written is unknown. If a program depends on an unknown bit, there are no
paths, and the reason is returned."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from math import inf

import numpy as np

from nscc.arrays import Array, Indices, Ints
from nscc.operations import WordEffect
from nscc.words.container import Container
from nscc_runtime.caches import OfContainer
from nscc_runtime.reference.digital import UNKNOWN, Bits, Digital
from nscc_runtime.reference.trace import RunningWord, running_words

MOST = 1 << 21
"""Largest number of words x paths that are followed, some hundred megabytes."""


class Pathless(Exception):
    """Raised where the paths of a program cannot be followed; its text is the reason, without a
    final stop."""


@dataclass(frozen=True, eq=False)
class Paths:
    """The segments (parts of a path between two comparisons) of a program.

    Segment k consists of the words numbered `acting[start[k] : start[k + 1]]`; only the last may
    compare. `following` int64 (segments, 2): the next segment for the answers 0 and 1, or -1 - e
    for ending e; without a comparison both are equal. `starts`: bits (starts,) at the start of a
    frame, by loaded register. `first` int64 (starts,): the first segment of each start. `endings`:
    bits (endings,) at the end of a frame, by state register."""

    words: tuple[RunningWord, ...]
    start: Ints
    acting: Ints
    following: Ints
    starts: Mapping[str, Bits]
    first: Ints
    endings: Mapping[str, Bits]

    @classmethod
    def of(cls, container: Container, retention_us: float = inf) -> Paths:
        """Return the paths of a container (a compiled program) with a state machine.

        A digital register reads 0 if no word wrote it for more than `retention_us`. Raises Pathless
        if there are too many paths, or if an answer, a state or an exposure depends on an unknown
        bit or on the frame before."""
        by_node, nodes = start_bits(container), int(container.machine.first[1])
        bits = np.array([*by_node.values()], np.int8).reshape(-1, nodes)
        # All combinations of bits with which a frame can start, by loaded register.
        starts = dict(zip(by_node, np.unique(bits, axis=1), strict=True))
        walk = _PathReplay(container, starts, retention_us)
        words = walk.run()
        return _alive(container, words, walk, starts)

    @cached_property
    def _packed(self) -> tuple[Ints, Ints]:
        """The bits of each start as one number (see the function `_packed`), ascending, and the
        first segment of each, both (starts,). A segment is the part of a path between two
        comparisons."""
        numbers = _packed(self.starts, (len(self.first),))
        order = np.argsort(numbers)
        return numbers[order], self.first[order]

    def begins(self, loaded: Mapping[str, Array], shape: tuple[int, ...]) -> Ints:
        """Return the first segment, or -1 - e for ending e, of each pixel of an array of `shape`.
        `loaded`: bits by register, each an array of this shape; those of all `starts` are needed.
        Raises ValueError for bits that no code and no kept state has. A segment is the part of a
        path between two comparisons."""
        numbers, first = self._packed
        loaded_numbers = _packed({name: loaded[name] for name in self.starts}, shape)
        if len(numbers) == 1:
            # The usual case, without a search; a start without registers has the number 0 too.
            index = np.zeros(shape, np.intp)
        else:
            index = np.minimum(np.searchsorted(numbers, loaded_numbers), len(numbers) - 1)
        if not np.array_equal(numbers[index], loaded_numbers):
            raise ValueError("bits that no code and no kept state has")
        return first[index]


@OfContainer
def paths_of(container: Container, retention_us: float) -> Paths | str:
    """Return the paths of a container with a state machine, or the reason of `Pathless` as a text
    if they cannot be followed; cached. Digital registers keep their values for `retention_us`
    microseconds. A container is a compiled program."""
    try:
        return Paths.of(container, retention_us)
    except Pathless as why:
        return str(why)


def _packed(bits: Mapping[str, Array], shape: tuple[int, ...]) -> Ints:
    """Return for each pixel of an array of `shape` its `bits`, arrays by register, as one number:
    bit k is that of the k-th register in alphabetical order. Without registers it is 0."""
    numbers = np.zeros(shape, np.int64)
    for k, name in enumerate(sorted(bits)):
        numbers |= bits[name].astype(np.int64) << k
    return numbers


def start_bits(container: Container) -> dict[str, Bits]:
    """Return the bits with which a frame can start, by loaded register in alphabetical order:
    registers of codes and of kept states.

    Each array has a bit, 0 or 1, for each node of the state machine's first stage: a combination of
    a code's behaviour and of values of states."""
    machine = container.machine
    nodes = np.arange(machine.first[1])
    encoding = container.encoding[machine.behaviour[nodes]]
    column = {name: i for i, name in enumerate(container.target.digital_registers)}
    bits_by_register = {name: encoding[:, column[name]] for name in container.code_registers}
    for k, state in enumerate(machine.states):
        if state.is_kept:
            planes = container.state_planes[state.name]
            rows = dict(zip(planes.values, planes.bits, strict=True))
            bits = np.array([rows[value] for value in machine.values[nodes, k].tolist()])
            bits_by_register |= zip(planes.registers, bits.reshape(len(nodes), -1).T, strict=True)
    return {name: bits_by_register[name].astype(np.int8) for name in sorted(bits_by_register)}


class _PathReplay:
    """Replays a frame for all paths at once, with one lane for each path that differs so far. Here
    a lane is a set of bits with which pixels go on, and belongs to one segment; a comparison may
    merge and divide lanes. A segment is the part of a path between two comparisons."""

    def __init__(
        self, container: Container, starts: Mapping[str, Bits], retention_us: float
    ) -> None:
        """Begin with one lane and one segment for each combination of bits in `starts`: bits
        (starts,) of the registers known at the start of a frame. All others are unknown.

        A register reads 0 more than `retention_us` microseconds after it was written. A segment is
        the part of a path between two comparisons."""
        self.container, self.target = container, container.target
        self.starts = self.segments = len(next(iter(starts.values()))) if starts else 1
        unknown = np.full(self.starts, UNKNOWN)
        names = (*self.target.digital_registers, "FLAG")
        self.registers = Digital(
            self.target, {**dict.fromkeys(names, unknown), **starts}, retention_us
        )
        self.segment = np.arange(self.starts)
        self.passed: list[tuple[int, Indices, Bits]] = []
        """For each word that may act: its number, the segments, and whether it acts in them."""
        self.following: list[tuple[Indices, int, Indices]] = []
        """For each answered comparison: segments, an answer, and the next segment of each."""
        self.size = 0

    def run(self) -> tuple[RunningWord, ...]:
        """Replay all words of a frame, and return the analog ones in order, which the compiled loop
        executes. Raises Pathless if the paths cannot be followed. Call it once."""
        start_us = np.concatenate(([0.0], np.cumsum(self.container.slot_us)))
        words: list[RunningWord] = []
        for word in running_words(self.container):
            self.registers.now_us = float(start_us[word.boundary])
            if word.resets or word.compares or word.op.operation.effect is WordEffect.BUS:
                self._met(word)
                words.append(word)
            else:
                self.registers.run(word.op)
        return tuple(words)

    def distinct_endings(self) -> tuple[dict[str, Bits], Indices]:
        """Return the different endings after `run`, as bits (endings,) by state register, and the
        number of the ending of each lane, (lanes,). Raises Pathless if the bit of a state is
        unknown."""
        planes = self.container.state_planes.values()
        names = sorted({register for state_planes in planes for register in state_planes.registers})
        bits = np.array([self.registers.bits[name] for name in names], np.int8)
        bits = bits.reshape(len(names), self.registers.pixels)
        if (bits == UNKNOWN).any():
            raise Pathless("a state that is read depends on a bit that no word has set")
        endings, ending = np.unique(bits, axis=1, return_inverse=True)
        return dict(zip(names, endings, strict=True)), ending.reshape(-1)

    def _met(self, word: RunningWord) -> None:
        """Record in which segments (parts of a path between two comparisons) the analog word `word`
        acts; a comparison continues each in new segments. Raises Pathless if words times lanes
        exceed `MOST`, or if it is unknown whether a comparison acts."""
        flag = self.registers.read("FLAG")
        everywhere = (word.resets and self.target.reset_honours_flag == "no") or (
            word.compares and not self.target.where_obeys_flag
        )
        acts = np.ones_like(flag) if everywhere else flag
        self.size += len(acts)
        if self.size > MOST:
            raise Pathless("its codes, states and answers give too many paths through a frame")
        self.passed.append((word.number, self.segment.copy(), acts))
        if word.compares:
            self._answered(acts)

    def _answered(self, is_asked: Bits) -> None:
        """Continue every lane with the answer 0, and also with the answer 1 where `is_asked`
        (lanes,) is 1. The answer is written to FLAG, lanes with equal bits are merged, and each
        remaining one begins a new segment. Raises Pathless if `is_asked` is unknown in a lane. A
        segment is the part of a path between two comparisons."""
        if (is_asked == UNKNOWN).any():
            raise Pathless("a comparison is made where FLAG is unknown")
        all_lanes = np.arange(len(is_asked))
        lanes = np.concatenate([all_lanes, all_lanes[is_asked == 1]])
        answer = np.repeat([0, 1], [len(all_lanes), len(lanes) - len(all_lanes)])
        self.registers.choose(lanes)
        self.registers.write("FLAG", answer)
        before = self.segment[lanes]
        group = self.registers.merge()
        self.segment = self.segments + np.arange(self.registers.pixels)
        self.segments += self.registers.pixels
        leads = self.segment[group]
        for value in (0, 1):
            at = answer == value
            self.following.append((before[at], value, leads[at]))


def _alive(
    container: Container,
    words: tuple[RunningWord, ...],
    walk: _PathReplay,
    starts: Mapping[str, Bits],
) -> Paths:
    """Return the paths through a frame without words and comparisons that cannot change the result.

    It goes backwards through the segments: a word counts only if it writes a register that a later
    word or the readout reads (a live register). A comparison counts only if its answers lead to
    different segments (parts of a path between two comparisons). Sets of registers are integers
    with a bit for each register. A segment number of -1 - k stands for ending k.

    `words`: all analog words of a frame. `walk`: their finished replay. `starts`: see `Paths`.
    Raises Pathless if an exposure depends on an unknown bit or on registers of the frame before."""
    registers = {n: 1 << i for i, n in enumerate((*container.target.analog_registers, "PIX"))}
    reads = [_together(registers, word.sources) for word in words]
    writes = [
        _together(registers, ("PIX",) if word.resets else word.destinations) for word in words
    ]
    last = _together(registers, (readout.register for readout in container.readouts))
    endings, ending = walk.distinct_endings()
    passed, following = _by_segment(walk, ending)
    live = [0] * walk.segments
    acting: list[list[int]] = [[] for _ in range(walk.segments)]
    leads_to = [*range(walk.segments)]
    alike: dict[tuple[int, ...], int] = {}
    for segment in reversed(range(walk.segments)):
        no, yes = (leads_to[n] if n >= 0 else n for n in following[segment].tolist())
        alive = last if no < 0 else live[no]
        chosen: list[int] = []
        # From the last word to the first: `alive` are the registers that are read later.
        for number, acts in reversed(passed[segment]):
            if words[number].compares:
                if no == yes:
                    continue
                alive |= (last if yes < 0 else live[yes]) | reads[number]
            elif acts and writes[number] & alive:
                if acts == UNKNOWN:
                    raise Pathless("an exposure hangs on a bit that nothing has set")
                alive = alive & ~writes[number] | reads[number]
            else:
                continue
            chosen.insert(0, number)
        # Segments that do the same are merged. One in which nothing counts is left out: what leads
        # to it leads to the next one.
        leads_to[segment] = alike.setdefault((no, yes, *chosen), segment) if chosen else no
        if leads_to[segment] == segment:
            live[segment], following[segment], acting[segment] = alive, (no, yes), chosen
    first = np.array([leads_to[k] for k in range(walk.starts)], np.int64)
    # A register that is live at the start would be read before anything writes it.
    if any(last if k < 0 else live[k] for k in first.tolist()):
        raise Pathless("its exposures hang on what the frame before has left")
    start = np.cumsum([0, *map(len, acting)])
    numbers = np.array([*chain.from_iterable(acting)], np.int64)
    return Paths(
        words,
        start,
        acting=numbers,
        following=following,
        starts=starts,
        first=first,
        endings=endings,
    )


def _together(registers: Mapping[str, int], names: Iterable[str]) -> int:
    """Return the set of the registers `names` as a number: the sum of their bits in `registers`. A
    name that has none, such as IN (the level sent to all pixels), is ignored; a repeated name
    counts once."""
    return sum({registers[name] for name in names if name in registers})


def _by_segment(walk: _PathReplay, ending: Indices) -> tuple[list[list[tuple[int, int]]], Ints]:
    """Return for each segment (a part of a path between two comparisons) its analog words as pairs
    (number of the word, whether it acts: 0, 1 or UNKNOWN) in order, and the next segments
    (segments, 2) for the answers 0 and 1.

    `ending` (lanes,): the ending of each lane after the frame. A number -1 - k stands for ending k
    instead of a segment. Where no comparison acts, both answers lead to the same."""
    passed: list[list[tuple[int, int]]] = [[] for _ in range(walk.segments)]
    for number, segments, acts in walk.passed:
        for segment, acts_here in zip(segments.tolist(), acts.tolist(), strict=True):
            passed[segment].append((number, acts_here))
    following = np.empty((walk.segments, 2), np.int64)
    for before, answer, leads in walk.following:
        following[before, answer] = leads
        if answer == 0:
            # Replaced by the next entry where the answer 1 is possible.
            following[before, 1] = leads
    following[walk.segment] = -1 - ending[:, None]
    return passed, following
