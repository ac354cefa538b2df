"""Bumps in long frames: start and last slot in binary, using nearly all registers.

The frame has two halves of 2^b slots. 2 b planes hold start and last slot modulo 2^b, one plane the
half of the last slot, and the mask the half of the start. The masked register, initially 0, holds
the open bumps. The NOR of the planes at which a number n has a 0 selects the bumps whose number is
a submask of n: n itself, and smaller numbers. A bump with a smaller start or end is already open or
closed, so no plane is ever inverted."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from nscc.logic.bumps import Bumps, two_ended
from nscc.logic.digits import binary_planes
from nscc.logic.problem import Gates, GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.script_walk import Script, walk
from nscc.truth import columns


def halved_bumps(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield the solution that stores the start and the last slot of a bump as binary numbers, if
    the demands are bumps and the solution fits.

    The frame is divided into two halves. One bit tells in which half the start is (in the mask
    register), another bit tells it for the last slot (in a plane). Further planes contain the bits
    of both positions within their halves."""
    bumps = two_ended(problem)
    bits = (bumps.steps - 1).bit_length() - 1
    if bits < 1 or 2 * bits + 3 > machine.registers:
        raise GaveUp("too few slots for two halves, or too many for the registers")
    if machine.where_sources == 1:
        raise GaveUp("no register is left to gather the sources of WHERE")
    flag_kept = [demand.flag_kept for demand in problem.demands]
    script = _Writer(bumps, bits, flag_kept, Gates(machine)).script()
    yield from walk(problem, machine, script, steps)


class _Writer:
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
