"""A solution as one straight run of operations on numbered registers, and back again.

Registers are numbered: planes, states, scratch, FLAG last. Because the shutters are known, what a
register holds at any point is a truth vector, or None where nothing is known about it. There are no
branches and no loops, so running the code once over truth vectors says all there is to know: two
values are equal if and only if their vectors are, and whether a change is right is seen by running
on from it. No Boolean reasoning about gates is needed anywhere in this folder.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from nscc.logic.problem import Gate, Machine, Problem, Segment, Solution, quietest
from nscc.truth import set_bits

Content = int | None
"""What a register holds: a truth vector, None if unknown."""

OPENING, CLOSING = -1, -2
"""Places of operations that belong to no answer."""

REFRESH_WORDS = 2
"""What the schedule adds at the end of a frame for every plane that the frame does not write."""


class Illegal(Exception):
    """Operations that do not meet the problem, or that hang on what nobody knows."""


@dataclass(frozen=True, slots=True)
class Op:
    """destination := OR(sources), or NOR if `inverted`; sources in rising order, without doubles.

    `place` is the answer to which the operation belongs, OPENING or CLOSING, and `segment` its
    segment there. `reads` is the set of sources as a bit mask.
    """

    inverted: bool
    destination: int
    sources: tuple[int, ...]
    place: int
    segment: int
    reads: int

    @property
    def function(self) -> tuple[bool, int, int]:
        """What the operation does, wherever it stands."""
        return self.inverted, self.destination, self.reads


@dataclass(frozen=True, slots=True)
class Check:
    """A point where FLAG must equal `need` (if not None), and what is unknown after it.

    It ends `place`. `forgets` is a bit mask of registers.
    """

    need: int | None
    forgets: int
    place: int


Item = Op | Check


def op(inverted: bool, destination: int, sources: Iterable[int], place: int, segment: int) -> Op:
    """An operation; sources in any order."""
    reads = 0
    for source in sources:
        reads |= 1 << source
    return Op(inverted, destination, set_bits(reads), place, segment, reads)


@dataclass(frozen=True)
class Frame:
    """What does not change while a solution is improved: problem, registers, limits, first state.

    `masked` is the plane that lives in the masked register, if one does: a write to it costs a word
    more and destroys t0 (`mask`). `ends` is None for a whole frame, at whose end the planes must be
    as they were; for a part of one, the registers (a bit mask) that are read after it.
    """

    solution: Solution
    problem: Problem
    machine: Machine
    planes: int
    states: int
    scratch: int
    everything: int
    start: tuple[Content, ...]
    masked: int | None
    ends: int | None = None

    @property
    def flag(self) -> int:
        """The number of FLAG."""
        return self.planes + self.states + self.scratch

    @property
    def mask(self) -> int | None:
        """The number of t0; None if there is no scratch."""
        return self.planes + self.states if self.scratch else None

    @property
    def unscathed(self) -> int:
        """Registers, as a bit mask, whose content matters at the end."""
        return (1 << self.planes) - 1 if self.ends is None else self.ends

    def words(self, item: Item) -> int:
        """ICWs that an item takes."""
        if isinstance(item, Check):
            return 0
        target = item.destination
        in_place = target != self.flag and item.reads >> target & 1
        return 1 + in_place + (target == self.masked)

    def total(self, items: Sequence[Item]) -> int:
        """ICWs of a frame, with those that refresh planes nobody writes."""
        left_alone = self.writes(items).count(0) if self.ends is None else 0
        return sum(map(self.words, items)) + REFRESH_WORDS * left_alone

    def value(self, item: Op, state: Sequence[Content]) -> Content:
        """What an operation writes in a state; None where a source is unknown."""
        some = 0
        for source in item.sources:
            content = state[source]
            if content is None:
                return None
            some |= content
        return some ^ self.everything if item.inverted else some

    def legal(self, item: Op) -> bool:
        """Whether the machine has a word, or a pair, for an operation."""
        count = len(item.sources)
        if item.destination == self.flag:
            limit = self.machine.where_sources
            reads_flag = item.reads >> self.flag & 1
            if item.inverted or not count or (reads_flag and not self.machine.where_reads_flag):
                return False
            return limit is None or count <= limit
        if item.destination == self.masked and (self.mask is None or item.reads >> self.mask & 1):
            return False
        limit = self.machine.or_sources
        # A register copied onto itself would be a refresh, which is none of the gates' business.
        alone = count == 1 and item.reads >> item.destination & 1
        return (limit is None or count <= max(limit, 1)) and (item.inverted or not alone)

    def apply(self, item: Item, state: list[Content]) -> None:
        """Brings a state from before an item to after it."""
        if isinstance(item, Check):
            for register in set_bits(item.forgets):
                state[register] = None
        else:
            self.store(item, self.value(item, state), state)

    def store(self, item: Op, value: Content, state: list[Content]) -> None:
        """Writes what an operation has computed."""
        state[item.destination] = value
        if item.destination == self.masked and self.mask is not None:
            state[self.mask] = None

    def writes(self, items: Iterable[Item]) -> list[int]:
        """How often items write each plane."""
        times = [0] * self.planes
        for item in items:
            if isinstance(item, Op) and item.destination < self.planes:
                times[item.destination] += 1
        return times

    def quiet(self, writes: Sequence[int]) -> bool:
        """Whether the masked register goes to the plane for which it is meant, if planes are
        written so often."""
        masked = self.masked
        return masked is None or writes[masked] == 0 or quietest(writes) == masked

    def names(self) -> list[str]:
        """The names of all registers."""
        kinds = (("p", self.planes), ("s", self.states), ("t", self.scratch))
        return [*(f"{kind}{i}" for kind, count in kinds for i in range(count)), "FLAG"]


def flatten(solution: Solution, problem: Problem, machine: Machine) -> tuple[Frame, list[Item]]:
    """A solution as items, with as much scratch as the machine leaves room for."""
    planes, states = len(solution.planes), solution.states
    scratch, masked = _scratch(solution, machine)
    everything = problem.everything
    flag: Content = everything if solution.state_in_flag else None
    frame = Frame(
        solution, problem, machine, planes, states, scratch, everything,
        (*solution.planes, *[None] * (states + scratch), flag), masked,
    )  # fmt: skip
    number = {name: i for i, name in enumerate(frame.names())}
    items: list[Item] = []

    def add(segments: Sequence[Segment], place: int) -> None:
        for index, segment in enumerate(segments):
            for gate in segment:
                inverted = gate.name in ("NOR", "NOT", "SET")
                sources = (number[name] for name in gate.sources)
                items.append(op(inverted, number[gate.destination], sources, place, index))

    add(solution.opening, OPENING)
    items.append(Check(None, _forgotten(frame, 0), OPENING))
    for index, (demand, answer) in enumerate(zip(problem.demands, solution.answers, strict=True)):
        add(answer, index)
        items.append(Check(demand.predicate, _forgotten(frame, index + 1), index))
    add(solution.closing, CLOSING)
    return frame, items


def _scratch(solution: Solution, machine: Machine) -> tuple[int, int | None]:
    """How many scratch registers there may be, and the plane in the masked register if any."""
    planes, states, scratch = len(solution.planes), solution.states, solution.scratch
    room = machine.registers - planes - states
    if not machine.masked or not planes:
        return max(scratch, room - (machine.masked and not planes)), None
    writes = solution.writes()
    quiet = quietest(writes)
    # Where all registers are taken, or a plane is never written, the masked register holds a plane
    # and every other one is free; else it stays empty, as every write to it destroys its mask.
    if scratch == room or (writes[quiet] == 0 and room > 0):
        return room, quiet
    return max(scratch, room - 1), None


def _forgotten(frame: Frame, coming: int) -> int:
    """Registers of which nothing is known when the answer `coming` begins."""
    demands = frame.problem.demands
    forgets = 0
    if frame.solution.state_in_flag:
        # Analog words meanwhile may keep FLAG in t0.
        forgets |= 1 << frame.mask if frame.mask is not None else 0
    elif coming == len(demands) or not demands[coming].flag_kept:
        forgets |= 1 << frame.flag
    # Only planes and states are refreshed in a frame that is longer than memory lasts.
    last = coming == len(demands)
    kept = frame.problem.flag_lasts if last else demands[coming].scratch_kept
    return forgets if kept else forgets | ((1 << frame.scratch) - 1) << frame.planes + frame.states


def unflatten(frame: Frame, items: Sequence[Item]) -> Solution:
    """Items as a solution again; raises Illegal where no answer is left for a demand's segment."""
    solution = frame.solution
    runs = {OPENING: solution.opening, CLOSING: solution.closing}
    runs |= dict(enumerate(solution.answers))
    parts: dict[int, list[list[Gate]]] = {place: [[] for _ in run] for place, run in runs.items()}
    names = frame.names()
    used = 0
    for item in items:
        if isinstance(item, Check):
            continue
        segments = parts[item.place]
        # An operation that moved stays behind those that it follows now.
        last = max((i for i, segment in enumerate(segments) if segment), default=0)
        while len(segments) <= item.segment:
            segments.append([])
        segments[max(last, item.segment)].append(_gate(item, names, frame.flag))
        used |= item.reads | 1 << item.destination
    spare = used >> (frame.planes + frame.states) & ((1 << frame.scratch) - 1)
    return replace(
        solution,
        scratch=max(spare.bit_length(), 1 if solution.state_in_flag else 0),
        opening=_kept(parts[OPENING]),
        answers=tuple(_kept(parts[i]) for i in range(len(solution.answers))),
        closing=_kept(parts[CLOSING]),
    )


def _kept(segments: Sequence[Sequence[Gate]]) -> tuple[Segment, ...]:
    return tuple(tuple(segment) for segment in segments if segment)


def _gate(item: Op, names: Sequence[str], flag: int) -> Gate:
    sources = tuple(names[i] for i in item.sources)
    if item.destination == flag:
        return Gate("WHERE", "FLAG", sources)
    kinds = ("SET", "NOT", "NOR") if item.inverted else ("CLR", "MOV", "OR")
    return Gate(kinds[min(len(sources), 2)], names[item.destination], sources)


def states_before(frame: Frame, items: Sequence[Item]) -> list[tuple[Content, ...]]:
    """The state before every item, and after the last; raises Illegal on anything wrong."""
    state = list(frame.start)
    found = []
    for item in items:
        found.append(tuple(state))
        if isinstance(item, Check):
            if item.need is not None and state[frame.flag] != item.need:
                raise Illegal("FLAG is not what the demand asks for")
        elif not frame.legal(item):
            raise Illegal("the machine has no such word")
        frame.apply(item, state)
        if isinstance(item, Op) and state[item.destination] is None:
            raise Illegal("an operation reads what nobody knows")
    found.append(tuple(state))
    if frame.ends is not None:
        return found
    if state[: frame.planes] != list(frame.start[: frame.planes]):
        raise Illegal("the planes are not as they were")
    if not frame.quiet(frame.writes(items)):
        raise Illegal("another plane would get the masked register")
    return found
