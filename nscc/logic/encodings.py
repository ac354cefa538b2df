"""Encodings: contents of the code planes with which a problem's predicates are cheap to compute.

Each function depends only on the predicates. It raises GaveUp if they do not suit the encoding or
if its planes leave too few registers.

For shutters with few edges, the times of the edges can be stored in Gray code (`gray_times`), and a
register, or FLAG itself, holds whether the shutter is open. Each equality test sets or clears this
state, so that every slot costs the same few words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from nscc.logic.cubes import Budget, Cube, Encoding, Standing, cover
from nscc.logic.digits import Planes, binary_planes, gray, unzipped
from nscc.logic.problem import Demand, Gate, Gates, GaveUp, Machine, Problem, Segment, Solution
from nscc.truth import members, union


def stored_predicates(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return one plane for each distinct predicate (raw bits, thermometer codes): one word per
    demand."""
    distinct = list(dict.fromkeys(d.predicate for d in problem.demands))
    if len(distinct) > machine.registers:
        raise GaveUp(f"{len(distinct)} different predicates, {machine.registers} registers")
    place = {predicate: i for i, predicate in enumerate(distinct)}
    cubes = tuple((((place[d.predicate], 1),),) for d in problem.demands)
    first = {d.predicate: describe_demand(d) for d in reversed(problem.demands)}
    planes = [(predicate, first[predicate]) for predicate in distinct]
    return Encoding("one register for each predicate", planes, cubes)


def describe_demand(demand: Demand) -> str:
    """Return a demand in words."""
    if demand.edge == "open":
        return f"open in slot {demand.boundary - 1}"
    return f"{demand.edge} at boundary {demand.boundary}"


def one_hot(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return one plane for each shutter; every predicate is an OR of planes."""
    if problem.shutters > machine.registers:
        raise GaveUp(f"{problem.shutters} shutters, {machine.registers} registers")
    used = union(demand.predicate for demand in problem.demands)
    place = {int(shutter): i for i, shutter in enumerate(members(used, problem.shutters))}
    cubes = tuple(
        tuple(((place[int(m)], 1),) for m in members(d.predicate, problem.shutters))
        for d in problem.demands
    )
    planes = [(1 << shutter, f"shutter {shutter}") for shutter in place]
    return Encoding("one register for each shutter", planes, cubes)


def gray_times(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return event times in Gray code, stored as time XOR now: an event is a test for 0, one NOR.

    The times of the k-th events of one kind (rise or fall of a bucket) form a field. Its planes
    hold the Gray code of the event number. One in-place NOT before each event updates "now"."""
    planes: Planes = []
    cubes: list[list[Cube]] = [[] for _ in problem.demands]
    fields = event_fields(problem, machine.registers - 1)
    for (edge, bucket, rank), events in fields.items():
        # Shutters without such an event keep the number after the last, which never occurs.
        numbers = np.full(problem.shutters, len(events), dtype=np.int64)
        for number, (_, shutters) in enumerate(events):
            numbers[shutters] = number
        width = max(1, int(numbers.max()).bit_length())
        base = len(planes)
        if base + width > machine.registers - 1:
            raise GaveUp(f"event times need {base + width} registers and one of scratch")
        label = event_name(edge, bucket, rank, fields)
        planes += binary_planes(f"{label}, Gray bit", gray(numbers), width)
        for number, (demand, _) in enumerate(events):
            cubes[demand].append(_equality(gray(number), base, width))
    return Encoding(
        "event times in Gray code", planes, tuple(tuple(demand_cubes) for demand_cubes in cubes)
    )


def event_name(edge: str, bucket: int, rank: int, fields: Events) -> str:
    """Return the name of a field of events, such as `fall time`, with rank and bucket if needed."""
    rank_text = f" {rank + 1}" if (edge, bucket, 1) in fields else ""
    bucket_text = f" of bucket {bucket}" if len({b for _, b, _ in fields}) > 1 else ""
    return f"{edge} time{rank_text}{bucket_text}"


def _equality(code: int, base: int, width: int) -> Cube:
    """Return the cube of the shutters whose planes base .. base + width - 1 hold `code`."""
    return tuple((base + bit, code >> bit & 1) for bit in range(width))


Events = dict[tuple[str, int, int], list[tuple[int, NDArray[np.intp]]]]


def event_fields(problem: Problem, most: int) -> Events:
    """Return for each kind and rank of events the pairs (demand, shutters) in time order.

    Demands that FLAG already meets are omitted. Raises GaveUp if there are more than `most` fields.
    """
    event_counts: dict[tuple[str, int], NDArray[np.int64]] = {}
    fields: Events = {}
    for i, demand in enumerate(problem.demands):
        if problem.answered(i):
            continue
        kind = (demand.edge, demand.bucket)
        if kind not in event_counts:
            event_counts[kind] = np.zeros(problem.shutters, dtype=np.int64)
        shutters = members(demand.predicate, problem.shutters)
        ranks = event_counts[kind][shutters]
        event_counts[kind][shutters] += 1
        for rank in sorted(set(ranks.tolist())):
            fields.setdefault((*kind, rank), []).append((i, shutters[ranks == rank]))
        if len(fields) > most:
            raise GaveUp(f"shutters have events of more than {most} kinds")
    return dict(sorted(fields.items()))


def _index_planes(problem: Problem, machine: Machine) -> Planes:
    """Return planes with the Gray code of every shutter's number, as few as possible."""
    numbers = np.arange(problem.shutters, dtype=np.int64)
    width = max(1, (problem.shutters - 1).bit_length())
    if width > machine.registers - 1:
        raise GaveUp(f"{problem.shutters} shutters leave no register to compute with")
    return binary_planes("shutter number, Gray bit", gray(numbers), width)


def gray_index(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return shutter numbers in Gray code; each shutter of a predicate is one test for equality.

    This is useful for long programs, whose kernels must repeat to fit the store: one kernel serves
    all equality tests, and one kernel inverts each plane."""
    if len({(d.edge, d.bucket) for d in problem.demands}) == 1:
        raise GaveUp("one kind of event is one field of times")
    # Every member is a separate equality test of at least two words; for more than a few, other
    # encodings are cheaper.
    if _members(problem) > 4 * len(problem.demands):
        raise GaveUp("predicates hold too many shutters for an equality each")
    return _index_equalities(problem, machine)


def gray_index_wide(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the encoding of `gray_index` for any predicates: many words and much time, but few
    stored words."""
    budget.spend(_STEPS_A_MEMBER * _members(problem))
    return _index_equalities(problem, machine)


def _index_equalities(problem: Problem, machine: Machine) -> Encoding:
    planes = _index_planes(problem, machine)
    cubes = tuple(
        tuple(
            _equality(gray(int(shutter)), 0, len(planes))
            for shutter in members(d.predicate, problem.shutters)
        )
        for d in problem.demands
    )
    return Encoding("shutter number in Gray code, equalities", planes, cubes)


# Equality tests need no search, but emitting their gates takes about as long as this many steps.
_STEPS_A_MEMBER = 100


def _members(problem: Problem) -> int:
    return sum(demand.predicate.bit_count() for demand in problem.demands)


def covered_gray_index(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return shutter numbers in Gray code; each predicate is covered by cubes."""
    planes = _index_planes(problem, machine)
    return _covered(problem, "shutter number in Gray code", planes, budget)


def covered_both_polarities(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the encoding of `covered_gray_index` with both polarities of every bit, without
    inversions."""
    half = _index_planes(problem, machine)
    if 2 * len(half) > machine.registers - 2:
        raise GaveUp("no room for both polarities and two scratch registers")
    encoding = _covered(problem, "shutter number in Gray code, both polarities", half, budget)
    # Plane 2i holds bit i, 2i + 1 its complement; a NOR reads the complement of each literal, so
    # the literal (i, value) is (2i + value, 0), and alone it is the plane that equals it.
    planes: Planes = []
    for plane, bit in half:
        planes += [(plane, bit), (problem.everything & ~plane, f"{bit}, inverted")]
    cubes = tuple(
        tuple(
            tuple(
                (2 * plane + value, 0) if len(cube) > 1 else (2 * plane + 1 - value, 1)
                for plane, value in cube
            )
            for cube in predicate
        )
        for predicate in encoding.cubes
    )
    return replace(encoding, planes=planes, cubes=cubes)


def covered_fields(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the values of the code's fields in Gray code; each predicate is covered by cubes.

    Rules are written in fields, so events of one field are equality tests. Shutters that differ
    otherwise, for example those that never open, cost a few cubes at a few boundaries."""
    if len(problem.values) < 2:
        raise GaveUp("one field is as good as the shutters' numbers")
    planes: Planes = []
    for name, values in problem.values.items():
        _, rank = np.unique(values, return_inverse=True)
        planes += binary_planes(f"{name}, Gray bit", gray(rank), int(rank.max()).bit_length())
    if len(planes) > machine.registers - 1:
        raise GaveUp(f"{len(planes)} bits of fields leave no register to compute with")
    return _covered(problem, "fields in Gray code", planes, budget)


def covered_levels(problem: Problem, machine: Machine, budget: Budget) -> Encoding:
    """Return the open shutters of every slot as planes; an edge is one cube of two neighbouring
    slots."""
    distinct = dict.fromkeys(level for bucket in problem.opens for level in bucket)
    levels = [level for level in distinct if level not in (0, problem.everything)]
    if len(levels) > machine.registers - 1:
        raise GaveUp(f"{len(levels)} different levels leave no register to compute with")
    planes = [(level, f"level {i}") for i, level in enumerate(levels)]
    return _covered(problem, "open slots, edges made from them", planes, budget)


def _covered(problem: Problem, name: str, planes: Planes, budget: Budget) -> Encoding:
    predicates = [demand.predicate for demand in problem.demands]
    vectors = [plane for plane, _ in planes]
    covers: dict[int, tuple[tuple[Cube, ...], bool]] = {}
    for predicate in dict.fromkeys(predicates):
        direct = cover(predicate, vectors, problem.everything, budget)
        covers[predicate] = tuple(direct), False
        if len(direct) > 1:
            # The complement costs one more gate.
            complement = problem.everything & ~predicate
            of_complement = cover(complement, vectors, problem.everything, budget)
            if len(of_complement) + 1 < len(direct):
                covers[predicate] = tuple(of_complement), True
    cubes, inverted = zip(*(covers[predicate] for predicate in predicates), strict=True)
    return Encoding(name, planes, cubes, inverted)


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
