"""Bumps in groups of two slots, written to the masked register.

Planes hold group and place of both ends. The code of the groups lets one cube find the bumps that
start in a group and one cube those that end in it (`cube_tables`); each place is one plane. The
masked register, initially 0, holds the bumps that continue after the group.

In the first slot of a group, the open bumps are those continuing from before and those that start
in the slot. In the second slot, all bumps that start in the group are open too, except those that
ended in the first slot. So the mask is set where a bump is active in the group. There the masked
register gets "does not end in this group, or ends in its second slot", and then "does not end in
this group"."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum

import numpy as np

from nscc.logic.bumps import Bumps, two_ended
from nscc.logic.cube_tables import BumpCubes
from nscc.logic.cubes import Standing
from nscc.logic.digits import binary_planes
from nscc.logic.problem import Gates, Machine, Problem, Segment, Solution
from nscc.logic.script_walk import Script, walk
from nscc.truth import columns


class _Form(Enum):
    """The register that holds the bumps that continue after a group."""

    MASKED = "masked writes"
    TIGHT = "masked writes, no scratch but the mask"
    REGISTER = "state in a register"
    FLAG = "state in FLAG"


# Registers besides the planes of the groups' code: two places, the state, and scratch.
_BESIDE = {_Form.MASKED: 5, _Form.TIGHT: 4, _Form.REGISTER: 5, _Form.FLAG: 4}


def paired_bumps(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield solutions in all forms that suit the machine, if the cube tables have the groups and
    planes."""
    bumps = two_ended(problem)
    forms = (_Form.MASKED, _Form.TIGHT) if machine.masked else (_Form.REGISTER, _Form.FLAG)
    for form in forms:
        cubes = BumpCubes.of(machine.registers - _BESIDE[form], -(-bumps.steps // 2))
        # A second rise cube is a masked write, which needs a masked register.
        if cubes is not None and (machine.masked or all(len(rise) == 1 for rise in cubes.rises)):
            writer = _Writer(bumps, cubes, form, Gates(machine), problem.flag_lasts)
            yield from walk(problem, machine, writer.script(), steps)


class _Writer:
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
