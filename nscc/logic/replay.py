"""Check of a solution against its problem: runs the gates on truth vectors of all shutters.

Contents on which no pass may rely (scratch at the start, FLAG after other words, registers without
refresh) are unknown, and no gate may read them."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.logic.problem import MASK, Gate, Machine, Problem, Segment, Solution

_SOURCES = {
    "WHERE": (1, None),
    "OR": (1, None),
    "NOR": (1, None),
    "NOT": (1, 1),
    "MOV": (1, 1),
    "SET": (0, 0),
    "CLR": (0, 0),
}
"""Fewest and most sources of each gate; None is the machine's limit."""


class _Wrong(Exception):
    """Raised for an invalid solution; the text is the reason."""


def fault(problem: Problem, machine: Machine, solution: Solution) -> str | None:
    """Return why `solution` does not solve `problem` on `machine`, in words; None if it does.

    Only the first fault is named: numbers of registers, planes (contents of code registers) and
    answers are checked first, then each gate, then the frame. A solution whose fields have wrong
    types may raise other exceptions."""
    try:
        planes, states, scratch = len(solution.planes), solution.states, solution.scratch
        # Only a plane or a masked state may be in the masked register.
        masked_state = solution.masked_state() if machine.masked else None
        empty = machine.masked and not planes and masked_state is None
        room = machine.registers - empty
        if min(states, scratch) < 0 or planes + states + scratch > room:
            raise _Wrong(f"{planes} planes, {states} states, {scratch} scratch in {room} registers")
        if len(solution.holders) != planes:
            raise _Wrong(f"{len(solution.holders)} holders of {planes} planes")
        if len(solution.answers) != len(problem.demands):
            raise _Wrong(f"{len(solution.answers)} answers to {len(problem.demands)} demands")
        if not all(type(p) is int and 0 <= p <= problem.everything for p in solution.planes):
            raise _Wrong("a plane is not a truth vector of the shutters")
        registers = {*_names("p", planes), *_names("s", states), *_names("t", scratch)}
        for gate in dict.fromkeys(gate for segment in solution.segments() for gate in segment):
            if not _possible(gate, registers, machine):
                raise _Wrong(f"the machine has no gate {gate}")
            if gate.masked and gate.destination != masked_state:
                raise _Wrong(f"{gate} does not write the masked register")
        _Frame(problem, machine, solution).replay()
    except _Wrong as wrong:
        return str(wrong)
    return None


def _names(kind: str, count: int) -> list[str]:
    """Return `count` names of registers of a kind: p0, p1, .."""
    return [f"{kind}{i}" for i in range(count)]


def _possible(gate: Gate, registers: set[str], machine: Machine) -> bool:
    """Return whether the machine has this gate: known name, legal registers and number of sources.

    `registers` are the names of the solution's registers, without FLAG (the bit that lets a pixel
    act). FLAG is written by WHERE only, and WHERE reads it only if the machine can."""
    if gate.name not in _SOURCES:
        return False
    is_where = gate.name == "WHERE"
    least, most = _SOURCES[gate.name]
    if most is None:
        # Without a limit a gate may read all registers and FLAG.
        most = (machine.where_sources if is_where else machine.or_sources) or len(registers) + 1
    destinations = {"FLAG"} if is_where else registers
    readable = registers if is_where and not machine.where_reads_flag else registers | {"FLAG"}
    return (
        gate.destination in destinations
        and readable.issuperset(gate.sources)
        and least <= len(gate.sources) <= most
    )


class _Frame:
    """One frame of a solution; `contents` are truth vectors (integers with one bit for each
    shutter) by register, None if unknown. `masked` is the virtual register in the masked register,
    None if there is none."""

    def __init__(self, problem: Problem, machine: Machine, solution: Solution) -> None:
        """Set the registers as they are before a frame: planes known, states and scratch unknown. A
        plane is the content of a code register."""
        self.problem = problem
        self.solution = solution
        self.scratch = _names("t", solution.scratch)
        self.contents: dict[str, int | None] = dict.fromkeys(_names("s", solution.states))
        self.contents |= dict(zip(_names("p", len(solution.planes)), solution.planes, strict=True))
        # Each write of the masked register but a masked one sets the mask, which overwrites t0.
        registers = machine.registers
        self.masked = solution.in_masked_register(registers) if machine.masked else None
        self._forget(self.scratch)
        self.contents["FLAG"] = None

    def replay(self) -> None:
        """Run the frame; raise _Wrong at the first unmet demand (a set of shutters that FLAG must
        select at a boundary), or unknown content that a gate reads. At the end, every plane must
        hold its code again. FLAG is the bit that lets a pixel act."""
        solution, demands = self.solution, self.problem.demands
        self._run(solution.opening)
        for index, (demand, answer) in enumerate(zip(demands, solution.answers, strict=True)):
            self._wait(demand.flag_kept, demand.scratch_kept)
            self._run(answer)
            if self.contents["FLAG"] != demand.predicate:
                raise _Wrong(f"FLAG does not hold what demand {index} asks for")
        self._wait(flag_kept=False, scratch_kept=self.problem.flag_lasts)
        self._run(solution.closing)
        for name, plane in zip(_names("p", len(solution.planes)), solution.planes, strict=True):
            if self.contents[name] != plane:
                raise _Wrong(f"{name} does not hold its code when the frame ends")

    def _wait(self, flag_kept: bool, scratch_kept: bool) -> None:
        """Make FLAG unknown unless it is kept until the next demand, and the scratch registers
        unless they are kept. A demand is a set of shutters that FLAG must select at a boundary. A
        scratch register holds an intermediate result."""
        if not flag_kept:
            self._forget(("FLAG",))
        if not scratch_kept:
            self._forget(self.scratch)

    def _forget(self, registers: Sequence[str]) -> None:
        """Make the contents of these registers unknown."""
        self.contents |= dict.fromkeys(registers)

    def _known(self, name: str, gate: Gate) -> int:
        """Return the content of the register `name`, a truth vector (an integer with one bit for
        each shutter); raise _Wrong if it is unknown. The message names `gate`, which reads it."""
        content = self.contents[name]
        if content is None:
            raise _Wrong(f"{gate} reads {name}, whose contents are unknown")
        return content

    def _run(self, segments: Sequence[Segment]) -> None:
        """Run the gates of `segments`, in order, on the truth vectors (integers with one bit for
        each shutter) of all registers. Writing the masked register by a gate that is not masked
        makes t0 unknown.

        Raises _Wrong if a gate reads unknown contents, or no register is free for the mask."""
        contents, everything, masked = self.contents, self.problem.everything, self.masked
        for segment in segments:
            for gate in segment:
                known = {name: self._known(name, gate) for name in gate.reads}
                contents[gate.destination] = gate.result(known, everything)
                if gate.destination == masked and not gate.masked:
                    if not self.scratch:
                        raise _Wrong(f"{gate} writes the register that needs a free mask")
                    contents[MASK] = None
