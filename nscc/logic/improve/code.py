"""A solution as straight-line code on numbered registers, and back.

Registers are numbered in the order planes, states, scratch, FLAG. Since all shutters are known, the
content of a register is a truth vector, or None if it is unknown. The code has no branches, so one
run over truth vectors is exact: two values are equal if and only if their vectors are equal, and a
change is checked by running on from it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from nscc.logic.problem import Gate, Machine, Problem, Segment, Solution, quietest
from nscc.truth import set_bits

Content = int | None
"""The content of a register: a truth vector, None if unknown."""

OPENING, CLOSING = -1, -2
"""Places of operations that belong to no demand: before the first and after the last one."""

REFRESH_WORDS = 2
"""Words that the schedule adds for every plane that the frame does not write."""


class Illegal(Exception):
    """Raised for operations that do not solve the problem, or that depend on unknown contents."""


@dataclass(frozen=True, slots=True)
class GateOp:
    """An operation destination := OR(sources), or NOR if `inverted`; sources are numbers of
    registers, ascending and distinct. Without sources it writes 0, or 1 if `inverted`.

    `demand_index` is that of the demand for which the operation runs, or OPENING or CLOSING;
    `segment` is the index of its segment there. `reads` is the bit mask of its sources. A segment
    is a group of gates that run together. A demand is a set of shutters that FLAG must select at a
    boundary."""

    inverted: bool
    destination: int
    sources: tuple[int, ...]
    demand_index: int
    segment: int
    reads: int


@dataclass(frozen=True, slots=True)
class Check:
    """A point at which FLAG must equal the truth vector `need` (None: anything). `demand_index` is
    as in `GateOp`.

    `forgets` is the bit mask of registers whose contents are unknown afterwards. A truth vector is
    an integer with one bit for each shutter. FLAG is the bit that lets a pixel act."""

    need: int | None
    forgets: int
    demand_index: int


Item = GateOp | Check


@dataclass(frozen=True)
class FrameContext:
    """The constants of an improvement: problem, registers, limits, initial state.

    `solution` is the one that is improved. `planes`, `states` and `scratch` count registers,
    `everything` is the truth vector of all shutters, and `start` the content of every register
    before the frame. An operation that writes register `masked` (if not None) takes one word more,
    which sets the first scratch register (for intermediate results) as its mask. A truth vector is
    an integer with one bit for each shutter."""

    solution: Solution
    problem: Problem
    machine: Machine
    planes: int
    states: int
    scratch: int
    everything: int
    start: tuple[Content, ...]
    masked: int | None

    @property
    def flag(self) -> int:
        """The register number of FLAG (the bit that lets a pixel act)."""
        return self.first_scratch + self.scratch

    @property
    def first_scratch(self) -> int:
        """The register number of the first scratch register (for intermediate results); FLAG's if
        there is none."""
        return self.planes + self.states

    def words(self, item: Item) -> int:
        """Return how many words an item takes: one for an operation, one more in place, and one
        more to set the mask of the masked register; 0 for a check. A WHERE that reads FLAG (the bit
        that lets a pixel act) is not in place."""
        if isinstance(item, Check):
            return 0
        in_place = item.destination != self.flag and item.destination in item.sources
        return 1 + in_place + (item.destination == self.masked)

    def total(self, items: Sequence[Item]) -> int:
        """Return the words of a frame, including refresh of planes (contents of code registers)
        that are not written."""
        left_alone = self.writes(items).count(0)
        return sum(map(self.words, items)) + REFRESH_WORDS * left_alone

    def op(
        self,
        inverted: bool,
        destination: int,
        sources: Iterable[int],
        demand_index: int,
        segment: int,
    ) -> GateOp:
        """Return an operation; the sources (numbers of registers) may be in any order and repeat.

        `inverted` is True for a NOR, False for an OR; without sources these are 1 and 0.
        `demand_index` and `segment` are those of `GateOp`."""
        sources = tuple(sorted(set(sources)))
        reads = sum(1 << source for source in sources)
        return GateOp(inverted, destination, sources, demand_index, segment, reads)

    def value(self, item: GateOp, contents: Sequence[Content]) -> Content:
        """Return the content of the destination after an operation; None if a source is unknown.

        `contents` holds the content of each register before it. The masked register is treated like
        any other, because its mask is set in all shutters."""
        disjunction = 0
        for source in item.sources:
            content = contents[source]
            if content is None:
                return None
            disjunction |= content
        return disjunction ^ self.everything if item.inverted else disjunction

    def legal(self, item: GateOp) -> bool:
        """Return whether the machine has a word, or a pair of words, for the operation `item`: few
        enough sources, a WHERE that is no NOR, a mask for the masked register, and no copy of a
        register to itself."""
        count = len(item.sources)
        if item.destination == self.flag:
            limit = self.machine.where_sources
            reads_flag = item.reads >> self.flag & 1
            if item.inverted or not count or (reads_flag and not self.machine.where_reads_flag):
                return False
            return limit is None or count <= limit
        if item.destination == self.masked and not self.scratch:
            return False
        limit = self.machine.or_sources
        # Copying a register to itself would be a refresh, which is not the gates' task.
        alone = item.sources == (item.destination,)
        return (limit is None or count <= max(limit, 1)) and (item.inverted or not alone)

    def apply(self, item: Item, contents: list[Content]) -> None:
        """Update the contents in `contents`, in place, by an operation or a check. A check makes
        registers unknown; whether its demand is met is not looked at."""
        if isinstance(item, Check):
            for register in set_bits(item.forgets):
                contents[register] = None
            return
        contents[item.destination] = self.value(item, contents)

    def writes(self, items: Iterable[Item]) -> list[int]:
        """Return, for each plane (the content of a code register) by its number, how often the
        items write it."""
        times = [0] * self.planes
        for item in items:
            if isinstance(item, GateOp) and item.destination < self.planes:
                times[item.destination] += 1
        return times

    def names(self) -> list[str]:
        """Return the names of all registers."""
        kinds = (("p", self.planes), ("s", self.states), ("t", self.scratch))
        return [*(f"{kind}{i}" for kind, count in kinds for i in range(count)), "FLAG"]


def flatten(
    solution: Solution, problem: Problem, machine: Machine
) -> tuple[FrameContext, list[Item]]:
    """Return a solution as items, with as many scratch registers (for intermediate results) as the
    machine allows.

    A write to the masked register first overwrites its mask, which the items forget before it. A
    masked gate (it writes a state only where the mask t0 is 1) becomes an operation that writes in
    all shutters. The number of its words is right, but the content of its state is not."""
    planes, states = len(solution.planes), solution.states
    scratch, masked = _room(solution, machine)
    everything = problem.everything
    frame = FrameContext(
        solution,
        problem,
        machine,
        planes,
        states,
        scratch,
        everything,
        (*solution.planes, *[None] * (states + scratch + 1)),
        masked,
    )
    number = {name: i for i, name in enumerate(frame.names())}
    items: list[Item] = []

    def add(segments: Sequence[Segment], demand_index: int) -> None:
        """Append the gates of segments (groups of gates that run together) to `items` as operations
        on numbered registers.

        `demand_index` is that of the demand (a set of shutters that FLAG must select at a boundary)
        that they belong to, OPENING or CLOSING. A write of the masked register is preceded by an
        item that makes its mask, the first scratch register, unknown."""
        for index, segment in enumerate(segments):
            for gate in segment:
                # Every gate is an OR or a NOR: MOV and NOT of one source, CLR and SET of none.
                inverted = gate.name in ("NOR", "NOT", "SET")
                sources = [number[name] for name in gate.sources]
                target = number[gate.destination]
                if target == masked:
                    items.append(Check(None, 1 << frame.first_scratch, demand_index))
                items.append(frame.op(inverted, target, sources, demand_index, index))

    add(solution.opening, OPENING)
    items.append(Check(None, _forgotten(frame, 0), OPENING))
    for index, (demand, answer) in enumerate(zip(problem.demands, solution.answers, strict=True)):
        add(answer, index)
        items.append(Check(demand.predicate, _forgotten(frame, index + 1), index))
    add(solution.closing, CLOSING)
    return frame, items


def _room(solution: Solution, machine: Machine) -> tuple[int, int | None]:
    """Return the number of possible scratch registers (for intermediate results), and the number of
    the plane that goes into the masked register, or None.

    The number is at least that which the solution uses. The masked register is written only where
    its mask is 1, so it suits a plane that is rarely written. A plane is the content of a code
    register."""
    planes, scratch = len(solution.planes), solution.scratch
    room = machine.registers - planes - solution.states
    if not machine.masked or not planes:
        return max(scratch, room - (machine.masked and not planes)), None
    writes = solution.writes()
    quiet = quietest(writes)
    # If all registers are used, or a plane is never written, the masked register holds a plane and
    # all others are free; otherwise it is empty.
    if scratch == room or (writes[quiet] == 0 and room > 0):
        return room, quiet
    return max(scratch, room - 1), None


def _forgotten(frame: FrameContext, coming: int) -> int:
    """Return the bit mask of the registers whose contents are unknown when the gates for demand
    number `coming` begin; after the last demand (a set of shutters that FLAG must select at a
    boundary), when the closing gates begin. FLAG is the bit that lets a pixel act."""
    demands = frame.problem.demands
    last = coming == len(demands)
    flag = 0 if not last and demands[coming].flag_kept else 1 << frame.flag
    # In a frame longer than the retention, only planes and states are refreshed.
    scratch_kept = frame.problem.flag_lasts if last else demands[coming].scratch_kept
    return flag if scratch_kept else flag | ((1 << frame.scratch) - 1) << frame.first_scratch


def unflatten(frame: FrameContext, items: Sequence[Item]) -> Solution:
    """Return the solution of these items, with the encoding of the frame's solution.

    Empty segments (groups of gates that run together) are left out. A gate gets the name for its
    number of sources, such as NOT for a NOR of one. The caller checks the result: items that do not
    meet the demands raise nothing. A demand is a set of shutters that FLAG must select at a
    boundary."""
    solution = frame.solution
    runs = {OPENING: solution.opening, CLOSING: solution.closing}
    runs |= dict(enumerate(solution.answers))
    segments_at: dict[int, list[list[Gate]]] = {
        demand_index: [[] for _ in run] for demand_index, run in runs.items()
    }
    names = frame.names()
    used = 0
    for item in items:
        if isinstance(item, Check):
            continue
        segments = segments_at[item.demand_index]
        # A moved operation stays after the operations that precede it.
        last = max((i for i, segment in enumerate(segments) if segment), default=0)
        while len(segments) <= item.segment:
            segments.append([])
        sources = tuple(names[i] for i in item.sources)
        if item.destination == frame.flag:
            gate = Gate("WHERE", "FLAG", sources)
        else:
            # By the number of sources: none, one, more.
            kinds = ("SET", "NOT", "NOR") if item.inverted else ("CLR", "MOV", "OR")
            gate = Gate(kinds[min(len(sources), 2)], names[item.destination], sources)
            if item.destination == frame.masked:
                # The write also takes the mask, which its SET overwrites.
                used |= 1 << frame.first_scratch
        segments[max(last, item.segment)].append(gate)
        used |= item.reads | 1 << item.destination
    spare = used >> frame.first_scratch & ((1 << frame.scratch) - 1)
    written_segments = {
        demand_index: tuple(tuple(segment) for segment in segments if segment)
        for demand_index, segments in segments_at.items()
    }
    return replace(
        solution,
        scratch=spare.bit_length(),
        opening=written_segments[OPENING],
        answers=tuple(written_segments[i] for i in range(len(solution.answers))),
        closing=written_segments[CLOSING],
    )


def states_before(frame: FrameContext, items: Sequence[Item]) -> list[tuple[Content, ...]]:
    """Return the contents of all registers, by number, before each of `items`, and after the last:
    one tuple more than items.

    Raises Illegal for an operation that the machine lacks or that reads unknown contents, for a
    demand that FLAG does not meet, and for code planes that are not as at the start when the frame
    ends. A demand is a set of shutters that FLAG must select at a boundary. FLAG is the bit that
    lets a pixel act."""
    contents = list(frame.start)
    states = []
    for item in items:
        states.append(tuple(contents))
        if isinstance(item, Check):
            if item.need is not None and contents[frame.flag] != item.need:
                raise Illegal("FLAG is not what the demand asks for")
        elif not frame.legal(item):
            raise Illegal("the machine has no such word")
        frame.apply(item, contents)
        if isinstance(item, GateOp) and contents[item.destination] is None:
            raise Illegal("an operation reads what nobody knows")
    states.append(tuple(contents))
    if contents[: frame.planes] != list(frame.start[: frame.planes]):
        raise Illegal("the planes are not as they were")
    return states
