"""Spans: bumps of any length, from a group and an offset for each end.

Time is cut into groups. A shutter is active in the groups that it touches; inside its first group
it is closed up to its start's offset, inside its last one from its stop's offset on. Which groups
are active is stored, or a state that every group brings forward.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.logic.bumps import Bumps, bumps_of
from nscc.logic.digits import Planes, binary_planes, nor, turned_over
from nscc.logic.gray import gray
from nscc.logic.problem import Gate, Machine, Problem, Segment, Solution
from nscc.logic.walk import Script, walk
from nscc.truth import columns, set_bits


def stored_spans(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """A plane for each group: active in it. The first groups may be longer by a slot."""
    bumps = bumps_of(problem)
    for groups in range(min(machine.registers - 1, bumps.steps), 2, -1):
        # A plane a group, and two thermometers of size - 1.
        size = -(-bumps.steps // groups)
        if size < 2 or groups + 2 * (size - 1) > machine.registers - 1:
            continue
        longer = bumps.steps - groups * (size - 1)
        first, start = _split(bumps.start, size, longer)
        last, stop = _split(np.maximum(bumps.stop - 1, 0), size, longer)
        active = [(first <= k) & (k <= last) & ~bumps.never for k in range(groups)]
        held = columns(np.stack(active, axis=1))
        planes = [(plane, f"active in group {k}") for k, plane in enumerate(held)]
        planes += _offsets(bumps, start, stop, size)
        name = f"active groups of {size} and fewer, offsets of both ends"
        yield from walk(problem, machine, Script(name, planes), steps)


def _split(
    step: NDArray[np.int64], size: int, longer: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Group and place in it; `longer` groups have `size` steps, those after them one less."""
    border = size * longer
    late = step >= border
    beyond = np.maximum(step - border, 0)
    less = max(1, size - 1)
    return (
        np.where(late, longer + beyond // less, step // size),
        np.where(late, beyond % less, step % size),
    )


def counted_spans(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """A state tells whether a shutter is active; groups of both ends are held in binary."""
    bumps = bumps_of(problem)
    # Longer groups leave fewer bits for their numbers and take two planes more a slot.
    for size in range(1, 6):
        groups = -(-bumps.steps // size)
        if groups < 3:
            break
        bits = (groups - 1).bit_length()
        room = machine.registers - 2 * bits - 2 * (size - 1)
        for halved in (True, False):
            risers = _Risers.of(bits, groups, halved)
            if risers is None:
                continue
            if size == 1 and room >= 1 and problem.flag_lasts:
                script = _flag_script(bumps, bits, risers)
                yield from walk(problem, machine, script, steps)
            if room >= 3 and (problem.demands[-1].flag_kept or not halved):
                script = _register_script(bumps, size, bits, risers, exact=not halved)
                yield from walk(problem, machine, script, steps)


def _offsets(bumps: Bumps, start: NDArray[np.int64], last: NDArray[np.int64], size: int) -> Planes:
    """Thermometers of both ends' places in their groups, in the sense that a NOR reads."""
    places = np.arange(size - 1)
    starts = columns(np.where(bumps.never, 0, start)[:, None] <= places)
    lasts = columns(np.where(bumps.never, size - 1, last)[:, None] > places)
    planes = [(p, f"start's place in its group <= {m}") for m, p in enumerate(starts)]
    return planes + [(p, f"last slot's place in its group > {m}") for m, p in enumerate(lasts)]


@dataclass(frozen=True)
class _Risers:
    """How the group of a start is coded, and how each step picks out those that rise.

    Step m, 0 .. groups - 2, opens group m + 1: `flips[m]` are the bits turned over before it,
    `cubes[m]` the bits whose planes are then 0 for the shutters that rise. `codes[g]` is the code
    of group g as the planes stand when the frame starts, when group 0 is where all of them are 0;
    `back` are the bits turned over at its end.

    A cube may hold shutters that rose before, so that fewer planes are turned over, if those of
    them that have closed since are taken out right after it: the fallers of step m are at least
    the groups whose number is a submask of m.
    """

    codes: tuple[int, ...]
    flips: tuple[tuple[int, ...], ...]
    cubes: tuple[tuple[int, ...], ...]
    back: tuple[int, ...]

    @staticmethod
    def of(bits: int, groups: int, halved: bool) -> _Risers | None:
        """The code; `halved`: with half of the turns, None where there are too few bits."""
        if halved and bits < 3:
            return None
        codes, wanted, cubes = [], [], []
        every = tuple(range(bits))
        for m in range(1 << bits):
            if not halved:
                codes.append(gray(m))
                wanted.append(codes[-1])
                cubes.append(every)
                continue
            # Two low bits go through four places with one turn: a cube of fewer planes holds the
            # place and those before it, which have risen already.
            high, place = m >> 2, m & 3
            top = gray(high) << 2
            odd = high & 1
            codes.append(top | (0, 1, 3, 2)[place] ^ odd)
            wanted.append(top | (odd, odd, 1 ^ odd, 1 ^ odd)[place])
            without = ((), (0,), (1,), (0, 1))[place]
            cubes.append(tuple(bit for bit in every if bit not in without))
        # Group 0 rises at the start; of the codes that no step uses it takes the nearest one.
        first = min(range(groups - 1, 1 << bits), key=lambda v: (codes[v] ^ wanted[0]).bit_count())
        standing = codes[first]
        flips = []
        for m in range(groups - 1):
            flips.append(set_bits(standing ^ wanted[m]))
            standing = wanted[m]
        return _Risers(
            tuple(codes[v] ^ codes[first] for v in (first, *range(groups - 1))),
            tuple(flips),
            tuple(cubes[: groups - 1]),
            set_bits(standing ^ codes[first]),
        )


def _ends(bumps: Bumps, size: int, bits: int, risers: _Risers) -> Planes:
    """Planes 0 .. bits - 1: the group of the start; bits .. 2 bits - 1: that of the last slot.

    What never opens rises with group 1 and is taken out at once.
    """
    first = np.where(bumps.never, 1, bumps.start // size)
    codes = np.array(risers.codes, dtype=np.int64)[first]
    last = np.maximum(bumps.stop - 1, 0) // size
    planes = binary_planes("group of the start, bit", codes, bits)
    return planes + binary_planes("group of the last slot, bit", last, bits)


def _fallers(m: int, bits: int) -> Segment:
    """t0 := shutters whose last group is a submask of m: m itself, and some before it."""
    return nor("t0", [f"p{bits + i}" for i in range(bits) if not m >> i & 1])


def _flag_script(bumps: Bumps, bits: int, risers: _Risers) -> Script:
    """The state in FLAG, one scratch register, groups of one step."""
    # FLAG := NOR(NOR(FLAG, rising), falling) in two steps; FLAG is inverted in between.
    into_flag = (Gate("NOR", "t0", ("t0", "FLAG")), Gate("WHERE", "FLAG", ("t0",)))
    before: dict[int, tuple[Segment, ...]] = {}
    for step, i in bumps.groups():
        if not step:
            rise = nor("t0", [f"p{b}" for b in range(bits)])
            before[i] = ((*rise, Gate("WHERE", "FLAG", ("t0",))),)
            continue
        m = step - 1
        before[i] = (
            *turned_over(risers.flips[m]),
            nor("t0", [f"p{b}" for b in risers.cubes[m]]),
            into_flag,
            _fallers(m, bits),
            into_flag,
        )
    planes, closing = _ends(bumps, 1, bits, risers), turned_over(risers.back)
    name = "both ends in binary, state in FLAG"
    return Script(name, planes, 0, (), before, closing, state_in_flag=True)


def _register_script(bumps: Bumps, size: int, bits: int, risers: _Risers, *, exact: bool) -> Script:
    """The state, inverted, in a register. Unless `exact`, FLAG must still hold the demand before:
    what was open in the last slot of a group is what was active in it and goes on."""
    planes = _ends(bumps, size, bits, risers)
    planes += _offsets(bumps, bumps.start % size, (bumps.stop - 1) % size, size)
    before: dict[int, tuple[Segment, ...]] = {}
    for group, i in bumps.groups(size):
        if not group:
            before[i] = ((Gate("OR", "s0", tuple(f"p{b}" for b in range(bits))),),)
            continue
        m = group - 1
        run: list[Segment] = [nor("t0", [f"p{b}" for b in risers.cubes[m]]), _fallers(m, bits)]
        state, last = "FLAG", "OR"
        if exact:
            run.reverse()
            state, last = "s0", "NOR"
        run.insert(1, (Gate("NOR", "t1", (state, "t0")),))
        run.append((Gate(last, "s0", ("t0", "t1")),))
        before[i] = (*turned_over(risers.flips[m]), *run)
    closing = turned_over(risers.back)
    name = "both ends in binary" if size == 1 else f"groups of {size} in binary, offsets"
    return Script(f"{name}, state in a register", planes, 1, (), before, closing)
