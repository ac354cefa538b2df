"""Cubes over code planes: covers, and the gates that compute an OR of cubes in FLAG.

A cube is a set of literals (plane, value); it is 1 where every plane has its value. NOR reads
complements, so a literal with value 1 needs an inverted plane. The emitter inverts planes in place
and tracks their polarity, so that consecutive demands share inversions (with a Gray counter one per
step). At the end of the frame all polarities are restored."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.logic.digits import Planes, unzipped
from nscc.logic.problem import Gates, GaveUp, Machine, Problem, Segment, Solution
from nscc.record import Record

Cube = tuple[tuple[int, int], ...]
"""Literals (plane, value), in ascending order of planes."""


class Encoding(Record):
    """The content of the planes, and each demand's predicate as an OR of cubes (NORs of registers).

    `name` describes the encoding in words. `cubes[i]` cover demand i, or its complement if
    `inverted[i]`; an empty `inverted` means that none is. A demand is a set of shutters that FLAG
    must select at a boundary."""

    name: str
    planes: Planes
    cubes: tuple[tuple[Cube, ...], ...]
    inverted: tuple[bool, ...] = ()


# Above this number the cubes of a predicate stay unsorted, since sorting takes too long.
_MOST_SORTED = 128


class Budget:
    """A number of search steps, of which `left` remain; the same input always takes the same
    number, so results do not depend on the speed of the machine."""

    def __init__(self, steps: int) -> None:
        """Begin with this number of steps."""
        self.left = steps

    def spend(self, steps: int) -> None:
        """Subtract `steps`; raise GaveUp if more are spent than there were."""
        self.left -= steps
        if self.left < 0:
            raise GaveUp("the search used up its steps")


def cover(
    on: int,
    planes: Sequence[int],
    everything: int,
    budget: Budget,
    free: int = 0,
    standing: Sequence[int] = (),
) -> list[Cube]:
    """Return prime cubes (NORs of registers) whose union is the predicate `on`, a truth vector;
    none if it is empty.

    `planes` are truth vectors, `everything` that of all shutters. Codes without a shutter are
    don't-cares, and so are the shutters `free`. With 13 planes there are too many primes to
    enumerate (Quine, McCluskey). Each cube starts as the code of one uncovered shutter and is
    expanded greedily by newly covered shutters (like Espresso, Brayton et al., 1984); of equal
    literals, those that differ from `standing`, the polarities of the planes, are dropped first.
    Raises GaveUp if a shutter in `on` and one outside have the same code, or if the budget is used
    up. A predicate is a set of shutters."""
    literals = [(everything & ~plane, plane) for plane in planes]
    cubes: list[Cube] = []
    uncovered, off = on, everything & ~(on | free)
    while uncovered:
        seed = uncovered & -uncovered
        cube = [(i, 1 if plane & seed else 0) for i, plane in enumerate(planes)]
        if standing:  # `_expand` drops the first of equal literals
            cube.sort(key=lambda literal: standing[literal[0]] == literal[1])
        cube = _expand(cube, literals, uncovered, off, everything, budget)
        covered = everything
        for i, value in cube:
            covered &= literals[i][value]
        if covered & off:
            raise GaveUp("two shutters have the same code in these planes")
        cubes.append(tuple(sorted(cube)))
        uncovered &= ~covered
    return cubes


def _expand(
    cube: list[tuple[int, int]],
    literals: list[tuple[int, int]],
    uncovered: int,
    off: int,
    everything: int,
    budget: Budget,
) -> list[tuple[int, int]]:
    """Drop literals of `cube`, in place, each time the one whose removal adds most of the shutters
    `uncovered`, while the cube avoids the shutters `off`; return it.

    `literals[plane]` are the truth vectors (integers with one bit for each shutter) of the plane's
    literals with value 0 and 1; the other vectors are of shutters, too. Of equal literals the first
    is dropped. Raises GaveUp if the budget is used up. A cube is a NOR of registers."""
    while cube:
        budget.spend(len(cube) * (1 + everything.bit_length() // 512))
        # The cube without each literal: the product of those before and after it.
        after = [everything] * (len(cube) + 1)
        for i in range(len(cube) - 1, -1, -1):
            plane, value = cube[i]
            after[i] = after[i + 1] & literals[plane][value]
        before, best, choice = everything, -1, -1
        for i, (plane, value) in enumerate(cube):
            without = before & after[i + 1]
            if not without & off:
                gain = (without & uncovered).bit_count()
                if gain > best:
                    best, choice = gain, i
            before &= literals[plane][value]
        if choice < 0:
            return cube
        del cube[choice]
    return cube


def emit(problem: Problem, machine: Machine, encoding: Encoding) -> Solution:
    """Return the solution whose gates compute an encoding's cubes (NORs of registers) in FLAG,
    demand by demand.

    Raises GaveUp if there are more planes than registers, or too few registers for intermediate
    results. A demand is a set of shutters that FLAG must select at a boundary."""
    planes = len(encoding.planes)
    free_registers = machine.registers - planes
    if free_registers < 0:
        raise GaveUp(f"{planes} code planes are more than {machine.registers} registers")
    solution = _emit_with(problem, machine, encoding, free_registers)
    if (
        machine.masked
        and free_registers > 1
        and solution.scratch == free_registers
        and all(solution.writes())
    ):
        # Only a constant plane may be in the masked register, and there is none.
        solution = _emit_with(problem, machine, encoding, free_registers - 1)
    return solution


def _emit_with(problem: Problem, machine: Machine, encoding: Encoding, scratch: int) -> Solution:
    """Return the solution of an encoding with `scratch` registers for intermediate results, of
    which `Solution.scratch` counts those that are used.

    Raises GaveUp if these are too few."""
    emitter = _Emitter(machine, len(encoding.planes), scratch)
    inverted = encoding.inverted or (False,) * len(encoding.cubes)
    answers = tuple(
        () if problem.answered(i) else emitter.answer(cubes, inverted[i])
        for i, cubes in enumerate(encoding.cubes)
    )
    closing = emitter.planes.restore()
    planes, holders = unzipped(encoding.planes)
    return Solution(encoding.name, planes, holders, 0, emitter.used, (), answers, closing)


class Standing:
    """The polarity of each plane (the content of a code register) while gates are emitted:
    `inverted[plane]` is 1 if the register now holds the inverse of what it held at the start, else
    0."""

    def __init__(self, gates: Gates, planes: int) -> None:
        """Begin with all planes (contents of code registers) not inverted."""
        self._gates = gates
        self.inverted = [0] * planes

    def flip(self, number: int) -> Segment:
        """Invert the plane with this number in place, and record its new polarity; return the
        segment (gates that run together), which begins with the gates that wait in the list."""
        self.inverted[number] ^= 1
        self._gates.invert(f"p{number}")
        return self._gates.take()

    def turn(self, cube: Cube) -> list[Segment]:
        """Invert the planes of `cube` so that their NOR is the cube, that is, so that each holds 0
        where its literal is met. Return the segments (groups of gates that run together) of the
        inversions, one for each plane; none if all have the right polarity. A cube is a NOR of
        registers."""
        return [self.flip(plane) for plane, value in cube if self.inverted[plane] != value]

    def restore(self) -> tuple[Segment, ...]:
        """Give every plane its polarity at the start of the frame, and return the segments (groups
        of gates that run together) that do so. A plane is the content of a code register."""
        return tuple(self.turn(tuple((plane, 0) for plane in range(len(self.inverted)))))


class _Emitter:
    """A list of gates under construction, with the polarities of planes (contents of code
    registers); `used` counts the scratch registers used so far, up to the highest number. A scratch
    register holds an intermediate result."""

    def __init__(self, machine: Machine, planes: int, scratch: int) -> None:
        """Begin with all planes (contents of code registers) as stored, not inverted, and `scratch`
        free registers."""
        self._machine = machine
        self._scratch = [f"t{i}" for i in range(scratch)]
        self._gates = Gates(machine)
        self.planes = Standing(self._gates, planes)
        self.used = 0

    def answer(self, cubes: Sequence[Cube], inverted: bool) -> tuple[Segment, ...]:
        """Return segments (groups of gates that run together) that compute the OR of `cubes`, or
        its complement, in FLAG.

        Without cubes (NORs of registers) the OR is 0. The polarities of planes may change. Raises
        GaveUp if the registers do not suffice."""
        segments: list[Segment] = []
        single = [cube[0] for cube in cubes if len(cube) == 1]
        wide = [cube for cube in cubes if len(cube) != 1]
        terms: list[str] = []
        ones = {cube: sum(value << plane for plane, value in cube) for cube in wide}
        read = {cube: sum(1 << plane for plane, _ in cube) for cube in wide}
        while wide:
            # The next cube is the one with the fewest inversions, which may also serve other cubes.
            if len(wide) <= _MOST_SORTED:
                now = sum(bit << plane for plane, bit in enumerate(self.planes.inverted))
                wide.sort(key=lambda cube: ((ones[cube] ^ now) & read[cube]).bit_count())
            cube = wide.pop(0)
            # Make room first: inverting the plane in the masked register overwrites its mask, a
            # scratch register that may hold a term.
            terms = self._make_room(terms)
            self._close(segments)
            segments += self.planes.turn(cube)
            target = self._free(terms)
            self._gates.nor(target, [f"p{plane}" for plane, _ in cube])
            terms.append(target)
        # Single planes are read with their final polarity; one with the wrong polarity is inverted
        # into scratch, or in place if there is none.
        standing = self.planes.inverted
        terms += [f"p{plane}" for plane, value in single if standing[plane] != value]
        for plane, value in single:
            if standing[plane] == value:
                terms = self._negate(plane, terms, segments)
        self._finish(terms, inverted)
        segments.append(self._gates.take())
        return tuple(segments)

    def _close(self, segments: list[Segment]) -> None:
        """End a segment (gates that run together) if there are pending gates."""
        if pending := self._gates.take():
            segments.append(pending)

    def _free(self, terms: Sequence[str]) -> str:
        """Return the first scratch register (for intermediate results) that none of the `terms`
        (names of registers) occupies, and count it as used; raise GaveUp if there is none."""
        for i, name in enumerate(self._scratch):
            if name not in terms:
                self.used = max(self.used, i + 1)
                return name
        raise GaveUp("no register is left to compute with")

    def _make_room(self, terms: list[str]) -> list[str]:
        """Return terms whose OR is unchanged and which leave a scratch register free.

        `terms` are names of registers. If all scratch registers hold terms, these are combined by
        an OR, or are kept in FLAG if there is only one. Raises GaveUp if no scratch register
        exists. A scratch register holds an intermediate result. FLAG is the bit that lets a pixel
        act."""
        scratch_terms = [name for name in terms if name in self._scratch]
        if len(scratch_terms) < len(self._scratch):
            return terms
        if not scratch_terms:
            raise GaveUp("no register is left to compute with")
        stored_terms = [name for name in terms if name not in scratch_terms and name != "FLAG"]
        flag = ["FLAG"] if "FLAG" in terms else []
        if len(scratch_terms) == 1:
            # With one scratch register, the partial sum is kept in FLAG.
            self._load_flag([*flag, scratch_terms[0]])
            return ["FLAG", *stored_terms]
        self._gates.or_(scratch_terms[0], [*flag, *scratch_terms])
        return [scratch_terms[0], *stored_terms]

    def _negate(self, number: int, terms: list[str], segments: list[Segment]) -> list[str]:
        """Make the inverse of the plane with this number readable, and return the terms with the
        register that holds it.

        `terms` are names of registers. The inverse is computed in a scratch register (for
        intermediate results). Without scratch registers, the plane is inverted in place, and the
        gates so far are appended to `segments` first. Raises GaveUp if the plane itself is a term.
        """
        name = f"p{number}"
        if name in terms:
            raise GaveUp("a plane is needed both ways round at once")
        if not self._scratch:
            self._close(segments)
            segments.append(self.planes.flip(number))
            return [*terms, name]
        terms = self._make_room(terms)
        target = self._free(terms)
        self._gates.nor(target, [name])
        return [*terms, target]

    def _load_flag(self, terms: list[str]) -> None:
        """Append the gates that load FLAG with the OR of the registers `terms`, one of which may be
        FLAG itself.

        Raises GaveUp if this needs a scratch register (for intermediate results) and none is free.
        FLAG is the bit that lets a pixel act."""
        spare = next((name for name in self._scratch if name in terms), None)
        limit = self._machine.where_sources
        if spare is None and limit is not None and len(terms) > limit:
            spare = self._free(terms)
        if "FLAG" in terms and not self._machine.where_reads_flag:
            scratch_terms = [name for name in terms if name in self._scratch]
            into = scratch_terms[0] if scratch_terms else self._free(terms)
            self._gates.or_(into, ["FLAG", into] if scratch_terms else ["FLAG"])
            terms = [into, *(name for name in terms if name not in ("FLAG", into))]
            spare = into
        self._gates.load_flag(terms, spare)

    def _finish(self, terms: list[str], inverted: bool) -> None:
        """Append the gates that load FLAG with the OR of the registers `terms`, or with their NOR
        if `inverted`.

        The NOR overwrites a term if no scratch register (for intermediate results) is free. Raises
        GaveUp if there is no scratch register. FLAG is the bit that lets a pixel act."""
        if not inverted:
            self._load_flag(terms)
            return
        scratch_terms = [name for name in terms if name in self._scratch]
        target = (
            scratch_terms[0]
            if scratch_terms and len(scratch_terms) == len(self._scratch)
            else self._free(terms)
        )
        self._gates.nor(target, terms)
        self._gates.load_flag([target], None)
