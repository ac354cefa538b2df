"""Levels from events: a register holds whether the shutter is open.

For shutters with few edges, the times of the edges are stored in Gray code
(`nscc.logic.encodings.gray_times`). Each equality test sets or clears the state, so that every slot
costs the same few words. The state is a register, or FLAG itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from operator import itemgetter

from nscc.logic.cubes import Budget, Cube, Encoding, Standing
from nscc.logic.digits import unzipped
from nscc.logic.encodings import covered_fields, gray_index, gray_times
from nscc.logic.problem import Demand, Gate, Gates, GaveUp, Machine, Problem, Segment, Solution


def state_register(problem: Problem, machine: Machine, budget: Budget) -> Solution:
    """Return the solution with the state of each bucket in its own register."""
    return _solve(problem, machine, budget, in_flag=False)


def state_in_flag(problem: Problem, machine: Machine, budget: Budget) -> Solution:
    """Return the solution with the state of a single bucket in FLAG, which must keep it for the
    frame."""
    if not problem.flag_lasts or len(problem.opens) != 1:
        raise GaveUp("FLAG cannot keep the state")
    return _solve(problem, machine, budget, in_flag=True)


def _solve(problem: Problem, machine: Machine, budget: Budget, *, in_flag: bool) -> Solution:
    if any(d.edge != "open" for d in problem.demands):
        raise GaveUp("the demands are events already")
    # If no shutter opens after slot 0, all start open, including never-open ones.
    from_open = [not any(b & ~a for a, b in pairwise(levels)) for levels in problem.opens]
    events, needed_before = _events(problem, from_open)
    inner = replace(problem, demands=tuple(events), flag_lasts=False)
    states = 0 if in_flag else len(problem.opens)
    encoding = _times(inner, machine, budget, machine.registers - 1 - states)
    planes = len(encoding.planes)
    free_registers = machine.registers - planes - states
    if machine.masked and free_registers > 1:
        free_registers -= 1  # every plane changes in the frame, so the masked register stays empty
    if free_registers < 1:
        raise GaveUp(f"{planes} planes and {states} states leave no register to compute with")
    walker = _Walker(machine, planes, min(free_registers, 2), in_flag)
    opening = walker.start(from_open)
    answers = []
    for demand, (first, end) in zip(problem.demands, pairwise((0, *needed_before)), strict=True):
        segments: list[Segment] = []
        for i in range(first, end):
            segments += walker.event(events[i], encoding.cubes[i])
        if not in_flag:
            segments.append((Gate("WHERE", "FLAG", (f"s{demand.bucket}",)),))
        answers.append(tuple(segments))
    return Solution(
        encoding.name + (", state in FLAG" if in_flag else ", state in a register"),
        *unzipped(encoding.planes), states, walker.scratch, opening, tuple(answers),
        walker.planes.restore(), in_flag,
    )  # fmt: skip


def _times(problem: Problem, machine: Machine, budget: Budget, room: int) -> Encoding:
    """Return events in at most `room` planes: as times, values of fields, or shutter numbers."""
    for encode in (gray_times, covered_fields):
        try:
            encoding = encode(problem, machine, budget)
        except GaveUp:
            continue
        if len(encoding.planes) <= room and not any(encoding.inverted):
            return encoding
    return gray_index(problem, machine, budget)


def _events(problem: Problem, from_open: Sequence[bool]) -> tuple[list[Demand], list[int]]:
    """Return rises and falls in time order, and the number of them before each demand.

    The demand at boundary n + 1 requires the level of slot n, so the events of boundaries 0..n come
    before it. A bucket starts open or closed in all pixels (`from_open`)."""
    events: list[Demand] = []
    needed: list[int] = []
    boundary = 0
    for demand in problem.demands:
        while boundary < demand.boundary:
            for bucket, levels in enumerate(problem.opens):
                start = problem.everything if from_open[bucket] else 0
                before = levels[boundary - 1] if boundary else start
                after = levels[boundary]
                for edge, vector in (("fall", before & ~after), ("rise", after & ~before)):
                    if vector:
                        events.append(Demand(boundary, edge, bucket, vector, False))
            boundary += 1
        needed.append(len(events))
    return events, needed


class _Walker:
    """The gates of events and levels, under construction."""

    def __init__(self, machine: Machine, planes: int, scratch: int, in_flag: bool) -> None:
        self._machine = machine
        self._in_flag = in_flag
        self._gates = Gates(machine)
        self.planes = Standing(self._gates, planes)
        self.scratch = scratch

    def start(self, from_open: Sequence[bool]) -> tuple[Segment, ...]:
        """Return segments that set or clear the states of all buckets."""
        if self._in_flag:
            if from_open[0]:
                return ()  # FLAG is 1 everywhere after the setup
            return ((Gate("CLR", "t0", ()), Gate("WHERE", "FLAG", ("t0",))),)
        closed_first = sorted(enumerate(from_open), key=itemgetter(1))
        return (tuple(Gate("SET" if o else "CLR", f"s{b}", ()) for b, o in closed_first),)

    def event(self, event: Demand, cubes: Sequence[Cube]) -> list[Segment]:
        """Return segments that open or close the shutters of one event."""
        segments = []
        change = self._flag if self._in_flag else self._register
        for cube in cubes:
            segments += self.planes.turn(cube)
            change(event, [f"p{plane}" for plane, _ in cube])
            segments.append(self._gates.take())
        return segments

    def _register(self, event: Demand, equal: list[str]) -> None:
        state = f"s{event.bucket}"
        # A rise is OR, a fall AND NOT: NOR(NOT state, equal), for which the state is inverted
        # first.
        self._gates.nor("t0", equal)
        if event.edge == "rise":
            self._gates.or_(state, [state, "t0"])
        elif self.scratch > 1:
            self._gates.nor("t1", [state])
            self._gates.nor(state, ["t0", "t1"])
        else:
            self._gates.invert(state)
            self._gates.nor(state, [state, "t0"])

    def _flag(self, event: Demand, equal: list[str]) -> None:
        if event.edge == "rise":
            self._gates.nor("t0", equal)
            if self._machine.where_reads_flag:
                self._gates.load_flag(["FLAG", "t0"], "t0")
                return
            self._gates.or_("t0", ["t0", "FLAG"])
        else:
            self._gates.nor("t0", ["FLAG"])
            self._gates.load_flag(["t0"], None)
            self._gates.nor("t0", equal)
            self._gates.nor("t0", ["t0", "FLAG"])
        self._gates.load_flag(["t0"], None)
