"""Bumps (shutters that open and close once) in the level demands of one bucket: their recognition,
and generators for bumps with two ends."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from nscc.logic.cube_tables import BumpCubes
from nscc.logic.cubes import Standing
from nscc.logic.digits import binary_planes
from nscc.logic.problem import Gates, GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.script_walk import Script, walk
from nscc.record import Record
from nscc.truth import columns, rows


class Bumps(Record):
    """Bumps: shutter k is open in steps start[k] .. stop[k] - 1.

    A shutter that never opens has start[k] = stop[k] = 0. Both arrays are (shutters,) in 0 ..
    steps. Demand i belongs to step `step[i]`; consecutive demands with equal predicates belong to
    the same step."""

    start: NDArray[np.int64]
    stop: NDArray[np.int64]
    step: tuple[int, ...]
    steps: int

    def groups(self, size: int = 1) -> list[tuple[int, int]]:
        """Return (group, demand) for every group of `size` steps, with the first demand of the
        group."""
        first: dict[int, int] = {}
        for demand, step in enumerate(self.step):
            first.setdefault(step // size, demand)
        return list(first.items())

    @property
    def length(self) -> int:
        """The number of steps of the longest bump."""
        return int((self.stop - self.start).max(initial=0))

    @property
    def never(self) -> NDArray[np.bool_]:
        """Whether each shutter never opens, (shutters,)."""
        return np.asarray(self.start == self.stop)


# Limit on shutters times demands, as a matrix of bytes: 32 MB.
_MOST_CELLS = 1 << 25


def bumps_of(problem: Problem) -> Bumps:
    """Return the bumps of a problem; raise GaveUp if some shutter is not a bump."""
    if len({(d.edge, d.bucket) for d in problem.demands}) != 1:
        raise GaveUp("demands of several kinds")
    if problem.demands[0].edge != "open":
        raise GaveUp("the demands are events")
    if problem.shutters * len(problem.demands) > _MOST_CELLS:
        raise GaveUp("too many shutters and demands to look at")
    predicates: list[int] = []
    step: list[int] = []
    for demand in problem.demands:
        if not predicates or demand.predicate != predicates[-1]:
            predicates.append(demand.predicate)
        step.append(len(predicates) - 1)
    open_in_step = rows(predicates, problem.shutters)
    start = open_in_step.argmax(axis=1).astype(np.int64)
    count = open_in_step.sum(axis=1).astype(np.int64)
    stop = start + count
    # argmax of booleans is the first 1. A row is one bump if its number of 1s equals the distance
    # of its ends.
    last = open_in_step.shape[1] - open_in_step[:, ::-1].argmax(axis=1)
    if np.any((count > 0) & (last != stop)):
        raise GaveUp("some shutter opens more than once")
    start[count == 0] = 0
    stop[count == 0] = 0
    return Bumps(start, stop, tuple(step), len(predicates))


def two_ended(problem: Problem) -> Bumps:
    """Return the bumps of a problem.

    Raises GaveUp if some shutter is not a bump, or if one end of all bumps determines the other."""
    bumps = bumps_of(problem)
    start, stop = bumps.start[~bumps.never], bumps.stop[~bumps.never]
    # The end of the frame may cut bumps of one length.
    cut = stop == bumps.steps
    if any(np.all(values == values[:1]) for values in (start, stop, (stop - start)[~cut])):
        raise GaveUp("one end of each bump follows from the other")
    return bumps


class _Form(Enum):
    """The register that holds the bumps that continue after a group."""

    MASKED = "masked writes"
    TIGHT = "masked writes, no scratch but the mask"
    REGISTER = "state in a register"
    FLAG = "state in FLAG"


# Registers besides the planes of the groups' code: two places, the state, and scratch.
_BESIDE = {_Form.MASKED: 5, _Form.TIGHT: 4, _Form.REGISTER: 5, _Form.FLAG: 4}


def paired_bumps(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield solutions in groups of two slots, in all forms that suit the machine, if the cube
    tables have the groups and planes.

    Planes hold group and place of both ends. The code of the groups lets one cube find the bumps
    that start in a group and one cube those that end in it (`cube_tables`); each place is one
    plane. The masked register, initially 0, holds the bumps that continue after the group.

    In the first slot of a group, the open bumps are those continuing from before and those that
    start in the slot. In the second slot, all bumps that start in the group are open too, except
    those that ended in the first slot. So the mask is set where a bump is active in the group.
    There the masked register gets "does not end in this group, or ends in its second slot", and
    then "does not end in this group"."""
    bumps = two_ended(problem)
    forms = (_Form.MASKED, _Form.TIGHT) if machine.masked else (_Form.REGISTER, _Form.FLAG)
    for form in forms:
        cubes = BumpCubes.of(machine.registers - _BESIDE[form], -(-bumps.steps // 2))
        # A second rise cube is a masked write, which needs a masked register.
        if cubes is not None and (machine.masked or all(len(rise) == 1 for rise in cubes.rises)):
            writer = _PairsWriter(bumps, cubes, form, Gates(machine), problem.flag_lasts)
            yield from walk(problem, machine, writer.script(), steps)


class _PairsWriter:
    """The gates of one frame, under construction.

    `on` holds the bumps that continue after a group; `scratch` is for intermediate values. If it
    keeps its content (`lasts`), planes may move into it."""

    def __init__(
        self, bumps: Bumps, cubes: BumpCubes, form: _Form, gates: Gates, lasts: bool
    ) -> None:
        self.bumps, self.cubes, self.form, self.gates = bumps, cubes, form, gates
        self.masked = form in (_Form.MASKED, _Form.TIGHT)
        self.start_place, self.last_place, state = (f"p{cubes.planes + k}" for k in range(3))
        self.on = state if form is not _Form.FLAG else "t1"
        self.spare = "t1" if form is _Form.MASKED else "t0"
        moves = lasts and form is not _Form.TIGHT
        self.planes = Standing(gates, cubes.planes, self.spare if moves else None)

    @property
    def scratch(self) -> str:
        """The register that is free between the gates of a slot."""
        return self.planes.free or self.spare

    def script(self) -> Script:
        """Return the script with all planes and gates."""
        bumps, cubes = self.bumps, self.cubes
        # A never-open shutter has its last slot before its start.
        start = np.where(bumps.never, 1, bumps.start)
        last = np.where(bumps.never, 0, bumps.stop - 1)
        ends, number = np.unique(
            np.stack([start // 2, last // 2], axis=1), axis=0, return_inverse=True
        )
        codes = np.array([cubes.code(int(i), int(j)) for i, j in ends])[number.reshape(-1)]
        places = columns(np.stack([start % 2 == 1, (last % 2 == 1) == self.masked], axis=1))
        planes = [
            *binary_planes("groups of both ends, code bit", codes, cubes.planes),
            (places[0], "start in the second slot of its group"),
            (places[1], f"last slot the {'second' if self.masked else 'first'} one of its group"),
        ]
        if self.form is not _Form.FLAG:
            planes.append((0, "open"))
        before = {demand: self._slot(step) for step, demand in bumps.groups()}
        name = f"both ends in groups of two, a cube each, {self.form.value}"
        return Script(name, planes, before=before, closing=self.planes.restore())

    def _slot(self, step: int) -> tuple[Segment, ...]:
        """Return the gates of one slot."""
        group, second = divmod(step, 2)
        # Alternating order, so that no plane is inverted between the two slots.
        rises = self.cubes.rises[group][:: -1 if second else 1]
        falls = self.cubes.falls[group] if group < len(self.cubes.falls) else ()
        gates = self.gates
        segments: list[Segment] = []
        place = [] if second else [self.start_place]
        for rise in rises[:-1]:
            segments += self.planes.turn(rise)
            gates.nor("t0", [*self.planes.read_by(rise), *place])
            gates.nor(self.on, [], "t0")
        segments += self.planes.turn(rises[-1])
        gates.nor(self.scratch, [*self.planes.read_by(rises[-1]), *place])
        if second:
            # Bumps start in the group. If t0 is the mask, it holds the active bumps, and t1 or FLAG
            # the others.
            match self.form:
                case _Form.MASKED:
                    gates.or_("t0", [self.on, self.scratch])
                case _Form.TIGHT:
                    gates.nor(self.on, [], "t0")
                    gates.or_("t0", [self.on])
                case _Form.REGISTER:
                    gates.nor("t1", [self.on, self.scratch])
                case _Form.FLAG:
                    gates.nor("t1", ["FLAG", self.scratch])
                    gates.load_flag(["t1"], None)
            segments += [gates.take(), *self.planes.turn(falls)]
            self._end(self.planes.read_by(falls))
        else:
            # Continuing bumps and those that start in the group's first slot are open.
            gates.load_flag([self.on, self.scratch] if step else [self.scratch], self.scratch)
            if step == self.bumps.steps - 1 and self.form is not _Form.FLAG:
                if self.masked:
                    gates.nor("t0", [])
                gates.or_(self.on, [], "t0" if self.masked else None)
        return (*segments, gates.take())

    def _end(self, ends: list[str]) -> None:
        """Add the gates of a group's second slot.

        Active bumps are open except those that ended in the first slot; then the bumps that end in
        the group are removed."""
        gates, on, place, scratch = self.gates, self.on, self.last_place, self.scratch
        if self.masked:
            gates.or_(on, [*ends, place], "t0")
            gates.load_flag([on], None)
            gates.or_(on, ends, "t0")
            return
        idle = "t1" if self.form is _Form.REGISTER else "FLAG"
        gates.nor(scratch, ends)
        gates.nor(on, [idle, scratch])
        gates.nor(scratch, [idle, *ends, place])
        gates.load_flag([on, scratch], scratch)


def halved_bumps(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield the solution that stores the start and the last slot of a bump as binary numbers, if
    the demands are bumps and the solution fits, for long frames.

    The frame has two halves of 2^b slots. 2 b planes hold start and last slot modulo 2^b, one plane
    the half of the last slot, and the mask the half of the start. The masked register, initially 0,
    holds the open bumps. The NOR of the planes at which a number n has a 0 selects the bumps whose
    number is a submask of n: n itself, and smaller numbers. A bump with a smaller start or end is
    already open or closed, so no plane is ever inverted."""
    bumps = two_ended(problem)
    bits = (bumps.steps - 1).bit_length() - 1
    if bits < 1 or 2 * bits + 3 > machine.registers:
        raise GaveUp("too few slots for two halves, or too many for the registers")
    if machine.where_sources == 1:
        raise GaveUp("no register is left to gather the sources of WHERE")
    flag_kept = [demand.flag_kept for demand in problem.demands]
    script = _HalvesWriter(bumps, bits, flag_kept, Gates(machine)).script()
    yield from walk(problem, machine, script, steps)


class _HalvesWriter:
    """The gates of one frame, under construction.

    `half` is a plane, `masked` the masked register and `mask` its mask. In the first half, `half`
    holds the bumps that end in the second half, and `mask` those that have not ended. In the second
    half, `half` holds the bumps that started in the first half. `flag_kept` says for each demand
    whether FLAG has kept its value since the previous demand."""

    def __init__(self, bumps: Bumps, bits: int, flag_kept: list[bool], gates: Gates) -> None:
        self.bumps, self.bits, self.flag_kept, self.gates = bumps, bits, flag_kept, gates
        self.half, self.mask, self.masked = (f"p{2 * bits + k}" for k in range(3))

    def script(self) -> Script:
        """Return the script with all planes and gates."""
        border = 1 << self.bits
        # A never-open shutter has its last slot before its start.
        start = np.where(self.bumps.never, 1, self.bumps.start)
        last = np.where(self.bumps.never, 0, self.bumps.stop - 1)
        halves = columns(np.stack([last >= border, start < border], axis=1))
        planes = [
            *binary_planes("start in its half, bit", start % border, self.bits),
            *binary_planes("last slot in its half, bit", last % border, self.bits),
            (halves[0], "last slot in the second half"),
            (halves[1], "start in the first half"),
            (0, "open"),
        ]
        before: dict[int, tuple[Segment, ...]] = {}
        for step, demand in self.bumps.groups():
            if step < border:
                self._first_half(step, self.flag_kept[demand])
            elif step == border:
                self._border()
            elif (step - border) % 2:
                self._from_waiting(step)
            else:
                self._from_done(step)
            before[demand] = (self.gates.take(),)
        self._restore(waiting=(self.bumps.steps - border) % 2 == 1)
        name = "both ends in binary in two halves, masked writes"
        return Script(name, planes, before=before, closing=(self.gates.take(),))

    def _starts(self, step: int) -> list[str]:
        """Return the planes whose NOR selects starts that are submasks of `step`."""
        return [f"p{i}" for i in range(self.bits) if not step >> i & 1]

    def _ends(self, step: int) -> list[str]:
        """Return the planes whose NOR selects last slots that are submasks of `step` - 1."""
        return [f"p{self.bits + i}" for i in range(self.bits) if not step - 1 >> i & 1]

    def _first_half(self, step: int, flag_kept: bool) -> None:
        gates, masked, mask = self.gates, self.masked, self.mask
        if step and not flag_kept:
            gates.load_flag([masked], None)
        if step:
            gates.or_(masked, [self.half, *self._ends(step)], mask)
            gates.or_(mask, [masked])
        gates.nor(masked, self._starts(step), mask)
        if step:
            gates.or_(masked, [masked, "FLAG"], mask)
        gates.load_flag([masked], None)

    def _border(self) -> None:
        """Add the gates of the first step of the second half.

        Afterwards `mask` holds the bumps that wait for their start, or that ended in the first
        half."""
        gates, masked, mask, half = self.gates, self.masked, self.mask, self.half
        gates.load_flag([mask], None)
        gates.nor(mask, [half])
        gates.or_(masked, [], mask)
        gates.or_(half, [mask, "FLAG"])
        gates.nor(mask, [*self._starts(0), half])
        gates.nor(masked, [], mask)
        gates.nor(mask, [masked])
        gates.load_flag([masked], None)

    def _from_waiting(self, step: int) -> None:
        """Add the gates of a step after which `mask` holds the bumps that ended in this half.

        Before the step, `mask` holds the waiting bumps."""
        gates, masked, mask = self.gates, self.masked, self.mask
        gates.load_flag([mask], None)
        gates.nor(masked, [*self._starts(step), self.half], mask)
        gates.or_(mask, [masked])
        gates.or_(masked, self._ends(step), mask)
        gates.nor(mask, ["FLAG", masked])
        gates.load_flag([masked], None)

    def _from_done(self, step: int) -> None:
        """Add the gates of a step after which `mask` holds the waiting bumps.

        Before the step, `mask` holds the bumps that ended in this half."""
        gates, masked, mask = self.gates, self.masked, self.mask
        gates.load_flag([mask, masked], None)
        gates.nor(mask, [*self._starts(step), self.half, "FLAG"])
        gates.or_(mask, [mask, masked])
        gates.or_(masked, self._ends(step), mask)
        gates.nor(mask, ["FLAG", masked])
        gates.load_flag([masked], None)

    def _restore(self, waiting: bool) -> None:
        """Add the gates that restore the planes at the end of the frame.

        Then the waiting bumps are those that ended in the first half."""
        gates, masked, mask, half = self.gates, self.masked, self.mask, self.half
        gates.load_flag([half], None)
        gates.nor(half, [mask]) if waiting else gates.or_(half, [mask, masked])
        gates.or_(mask, [masked])
        gates.or_(masked, [], mask)
        gates.or_(mask, ["FLAG"])
