"""Generator for rules composed by `and`, `or` and `xor` from parts that read different fields.

The parts are found in the predicates: a rule `A and B` opens exactly the shutters that are open in
the projections on the fields of A and of B. Each part takes one of several forms (`part_forms`):
its values are covered by cubes of its planes, kept in a state that changes, or compared with the
time. Each slot then joins the parts by one or more gates. Of the combinations of forms for which
registers suffice, the one with the fewest words is taken.

On a chip with a masked register, that register holds one of the states. A change then takes two
words: a NOR selects the shutters that change, and a masked gate writes the state in these only. The
exclusive or of such a state and a part of cubes is also kept in the masked register: from one
demand to the next, a masked NOT inverts it where the value of the cubes changes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import chain, product

import numpy as np

from nscc.arrays import Ints
from nscc.logic.cubes import Cube, Standing
from nscc.logic.digits import Planes
from nscc.logic.part_forms import (
    Change,
    ComparedPart,
    CoveredPart,
    Form,
    StatePart,
    bit_runs,
    compared_code,
    covered,
    forms,
    oriented,
    shifted,
)
from nscc.logic.problem import MASK, Gate, Gates, GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.rule_parts import Composition, Operator, Rule, RulePart, composition
from nscc.logic.script import Script
from nscc.truth import columns, union

# Combinations of forms that are written, for each number of registers that they leave.
_MOST_WRITTEN = 3
# Registers that are left to compute with, beyond which more do not matter.
_MOST_SCRATCH = 3


def composed(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield the solutions of a composed rule: the shortest script, and the shortest in which the
    same words are repeated, if it is another.

    A rule is composed if it joins conditions on different fields by `and`, `or` or `xor`. `steps`
    is the number of search steps (`Budget`) for the gates of each solution; a solution that needs
    more is left out. Raises GaveUp for a rule that is not composed, or if no solution is left,
    usually because registers do not suffice."""
    rule = composition(problem)
    if rule is None:
        raise GaveUp("the rule is not composed from parts with different fields")
    from nscc.logic.script_walk import walk  # few rules are composed, so checks need no covers

    parts = [*_leaf_parts(rule)]
    choices = [forms(part, machine.registers - 1) for part in parts]
    solutions: list[Solution] = []
    written: set[tuple[int, ...]] = set()
    for varied in (True, False):
        scripts: list[tuple[int, tuple[int, ...], Script]] = []
        for chosen in _combinations(choices, machine, varied):
            by_part = {id(part): form for part, form in zip(parts, chosen, strict=True)}
            key = tuple(map(id, chosen))
            for kept in (False, True):
                with suppress(GaveUp):
                    script = _Writer(problem, machine, by_part, kept).script(rule)
                    scripts.append((_words(script), key, script))
        if scripts:
            _, key, script = min(scripts, key=lambda item: item[0])
            if key not in written:
                solutions += walk(problem, machine, script, steps)
            written.add(key)
    if not solutions:
        raise GaveUp("no register is left to compute with")
    yield from solutions


def _leaf_parts(rule: Rule) -> Iterator[RulePart]:
    """Yield the parts of a rule, in order."""
    if isinstance(rule, RulePart):
        yield rule
    else:
        yield from _leaf_parts(rule.first)
        yield from _leaf_parts(rule.second)


def _combinations(
    choices: Sequence[Sequence[Form]], machine: Machine, varied: bool
) -> Iterator[tuple[Form, ...]]:
    """Yield the cheapest combinations of one form for each part that leave a register to compute
    with; without `varied`, only of forms whose words are repeated."""
    fitting: dict[int, list[tuple[Form, ...]]] = {}
    allowed = [[form for form in each if varied or not form.varied] for each in choices]
    for chosen in product(*allowed):
        scratch = machine.registers - sum(form.registers for form in chosen)
        if scratch > 0:
            fitting.setdefault(min(scratch, _MOST_SCRATCH), []).append(chosen)
    for combinations in fitting.values():
        combinations.sort(key=lambda chosen: sum(form.words for form in chosen))
        yield from combinations[:_MOST_WRITTEN]


def _words(script: Script) -> int:
    """Return the words of a script's gates."""
    segments = chain.from_iterable((*script.before.values(), script.closing))
    return sum(gate.words for segment in segments for gate in segment)


@dataclass
class _Held:
    """A state in a register, such as s0.

    `masked` tells whether it is the masked register. The register now holds the inverse of the
    state if `inverse`. `ahead` are the values that later changes write, in order. With `second` the
    register holds the exclusive or with that part. `steps` are the disjoint parts in which `second`
    then differs from its value at the demand before. A demand is a set of shutters that FLAG must
    select at a boundary."""

    register: str
    masked: bool
    state: StatePart
    inverse: bool
    ahead: list[bool]
    second: CoveredPart | None = None
    steps: tuple[CoveredPart, ...] = ()


_Joined = tuple[tuple[Operator, ...], "_Planned", "_Planned"]
_Planned = _Held | CoveredPart | ComparedPart | _Joined


@dataclass
class _Writer:
    """The planes (contents of code registers), states and gates of one frame, under construction;
    make a new one for each script.

    `chosen` is the form of each part, by the identity of the part. With `kept`, an exclusive or is
    kept in the masked register."""

    problem: Problem
    machine: Machine
    chosen: Mapping[int, Form]
    kept: bool
    planes: Planes = field(default_factory=list)
    states: list[_Held] = field(default_factory=list)

    def script(self, rule: Rule) -> Script:
        """Return the script that computes a rule at each demand: planes, state updates and the
        gates of the rule. Call it once; it fills the writer's planes and states.

        Raises GaveUp if no register is left for intermediate results. A demand is a set of shutters
        that FLAG must select at a boundary."""
        count = len(self.problem.demands)
        planned = self._planned(rule, np.zeros(count, dtype=np.int64))
        if self.kept and not any(state.second for state in self.states):
            raise GaveUp("no exclusive or can be kept")
        self.gates = Gates(self.machine)
        self.standing = Standing(self.gates, len(self.planes))
        opening = tuple(
            (Gate("SET" if held.state.start != held.inverse else "CLR", held.register, ()),)
            for held in self.states
        )
        before: dict[int, tuple[Segment, ...]] = {}
        for index in range(count):
            self.segments: list[Segment] = []
            self.flag_busy = False
            for held in self.states:
                self._advance(held, index)
            self.free = self._scratch()
            if not self.problem.answered(index):
                self._turn_ahead(planned, index)
                self._load_flag(self._sources(planned, index, inverse=False))
                self._end_segment()
            before[index] = tuple(self.segments)
        closing = self.standing.restore()
        repeated = "" if any(form.varied for form in self.chosen.values()) else ", repeated words"
        name = f"parts of the rule{repeated}"
        return Script(name, self.planes, len(self.states), opening, before, closing)

    def _planned(self, rule: Rule, inverse: Ints) -> _Planned:
        """Add the planes and states of all parts of a rule to the writer, and return the rule with
        its parts replaced by plans.

        `inverse`, (demands,), is 1 where the gates will read the rule's inverse, 0 where its value,
        and -1 where neither; a state in the masked register, and planes, are stored for most. A
        plane is the content of a code register. A demand is a set of shutters that FLAG must select
        at a boundary."""
        if isinstance(rule, RulePart):
            form = self.chosen[id(rule)]
            if isinstance(form.plan, CoveredPart):
                form = oriented(form, form.plan, inverse.tolist(), self.problem.everything)
            plan = shifted(form.plan, len(self.planes))
            self.planes += form.planes
            if not isinstance(plan, StatePart):
                return plan
            masked = self.machine.masked and not self.states
            ahead = [c.value for run in plan.changes for c in run if isinstance(c.value, bool)]
            if not masked and len(ahead) < sum(map(len, plan.changes)):
                raise GaveUp("only a masked register takes the bit of a plane")
            # Outside the masked register, a value is written by an OR: 1 into the state, or 0 as a
            # 1 into its inverse.
            wanted = (inverse ^ rule.inverted)[inverse >= 0]
            low = 2 * int(wanted.sum()) > len(wanted) if masked else ahead[:1] == [False]
            self.states.append(_Held(f"s{len(self.states)}", masked, plan, low, ahead))
            return self.states[-1]
        only_xor = set(rule.operators) == {"xor"}
        inner = rule.second
        nested = isinstance(inner, Composition) and inner.operators == rule.operators
        if self.kept and only_xor and nested:
            assert isinstance(inner, Composition)
            # One of the parts of the second may be kept with the first.
            first_two = Composition(rule.operators, rule.first, inner.first)
            rule = Composition(rule.operators, first_two, inner.second)
        # An `and` is the NOR of its parts' inverses, an `or` the OR of their values.
        operators = np.array(rule.operators)
        inverse = np.where(operators == "and", 1, np.where(operators == "or", 0, inverse))
        first = self._planned(rule.first, np.where(operators == "second", -1, inverse))
        second = self._planned(rule.second, np.where(operators == "first", -1, inverse))
        # The masked register can hold the exclusive or of its state and a part of cubes.
        if self.kept and only_xor and isinstance(first, _Held):
            alone = first.masked and first.second is None
            if alone and isinstance(second, CoveredPart) and isinstance(rule.second, RulePart):
                values = columns(rule.second.open ^ rule.second.inverted)
                steps = [now ^ was for was, now in zip([0, *values[:-1]], values, strict=True)]
                planes = {plane for cubes in second.cubes for cube in cubes for plane, _ in cube}
                first.steps, first.second = self._disjoint(steps, sorted(planes)), second
                return first
        return rule.operators, first, second

    def _disjoint(self, predicates: list[int], planes: Sequence[int]) -> tuple[CoveredPart, ...]:
        """Return parts whose exclusive or is open in `predicates`, each with at most one cube (a
        NOR of registers), or its inverse, at each demand; none if all predicates are empty.

        `predicates` are truth vectors, one for each demand (a set of shutters that FLAG must select
        at a boundary); `planes` are the numbers of the planes that cubes may read."""
        parts: list[CoveredPart] = []
        while any(predicates):
            vectors = [self.planes[plane][0] for plane in planes]
            local, _ = covered(predicates, vectors, self.problem.everything)
            part = CoveredPart(
                [
                    [tuple((planes[plane], value) for plane, value in cube) for cube in cubes]
                    for cubes in local.cubes
                ],
                local.inverted,
            )
            rest = [0] * len(predicates)
            for index, cubes in enumerate(part.cubes):
                if len(cubes) > 1:
                    first = [] if part.inverted[index] else cubes[:1]
                    part.cubes[index] = first
                    rest[index] = predicates[index] ^ self._vector(first[0] if first else ())
            predicates = rest
            parts.append(part)
        return tuple(parts)

    def _vector(self, cube: Cube) -> int:
        """Return the truth vector (an integer with one bit for each shutter) of a cube, from the
        planes as stored at the start. The empty cube is 1 everywhere. A plane is the content of a
        code register."""
        zeros = union(self.planes[p][0] ^ (self.problem.everything * value) for p, value in cube)
        return self.problem.everything ^ zeros

    def _advance(self, held: _Held, index: int) -> None:
        """Append the gates that update a state before demand `index`: first the inversions where
        its second part changes, then the changes of its own shutters, if any. A demand is a set of
        shutters that FLAG must select at a boundary."""
        # The changes may run before the inversions, when the second part still has its last value.
        second = held.second if index else None
        before = second and self._dear(second, index - 1) < self._dear(second, index)
        if before:
            self._change(held, index, index - 1)
        for step in held.steps:
            if step.cubes[index] or step.inverted[index]:
                # Scratch values end with an update, so each begins with all registers free.
                self.free = self._scratch()
                inverse = self._direct(step, index)
                (self.gates.nor if inverse else self.gates.or_)(
                    MASK, self._cubes(step, index, inverse)
                )
                # A masked NOT inverts the state where the value of the cubes changes.
                self.gates.nor(held.register, [held.register], masked=True)
                self._end_segment()
        if not before:
            self._change(held, index, index)

    def _scratch(self) -> list[str]:
        """Return the names of all scratch registers (for intermediate results)."""
        count = self.machine.registers - len(self.planes) - len(self.states)
        return [f"t{number}" for number in range(count)]

    def _dear(self, second: CoveredPart, index: int) -> tuple[bool, int]:
        """Return a key that orders the values of a part at demands by the words that it takes to
        write them where a mask is 1. A demand is a set of shutters that FLAG must select at a
        boundary."""
        cubes = second.cubes[index]
        inverted = self.standing.inverted
        turns = sum(inverted[plane] != v for cube in cubes if len(cube) > 1 for plane, v in cube)
        return len(cubes) > 1, turns

    def _change(self, held: _Held, index: int, second_index: int) -> None:
        """Append the gates that change a state in its own shutters before demand `index`.
        `second_index` is the demand whose value the second part has now, if there is one. A demand
        is a set of shutters that FLAG must select at a boundary."""
        for change in held.state.changes[index]:
            if held.masked:
                self._write_changed(held, second_index, change)
            else:
                self._select(change.cube)
                self._gather_changed(held)
            self._end_segment()

    def _select(self, cube: Cube) -> None:
        """Append the gates that set the mask in the shutters of a cube (a NOR of registers)."""
        names = self._literals(cube)
        (self.gates.nor if self._is_low([cube]) else self.gates.or_)(MASK, names)

    def _gather_changed(self, held: _Held) -> None:
        """Append gates that change a state, outside the masked register, in the shutters of the
        mask.

        The register takes the OR with the mask, so it must hold the inverse of the state if the
        state becomes 0. If the next change is of the other kind, the gate also inverts."""
        value, held.ahead = held.ahead[0], held.ahead[1:]
        if held.inverse == value:
            self.gates.nor(held.register, [held.register])
            held.inverse = not value
        turns = held.ahead[:1] == [not value]
        (self.gates.nor if turns else self.gates.or_)(held.register, [held.register, MASK])
        held.inverse ^= turns

    def _write_changed(self, held: _Held, index: int, change: Change) -> None:
        """Append masked gates that write a state in the shutters that change.

        If the state also holds the exclusive or with a second part, its new content depends on the
        cubes (NORs of registers) of that part at demand `index`. A demand is a set of shutters that
        FLAG must select at a boundary."""
        if not isinstance(change.value, bool):
            self._select(change.cube)
            inverse = self._is_low([(change.value,)]) != held.inverse
            names = [f"p{change.value[0]}"]
            if held.second is not None:  # all shutters of the cube change
                inverse, names = True, [held.register]
            (self.gates.nor if inverse else self.gates.or_)(held.register, names, masked=True)
            return
        cubes, content = list[Cube](), change.value != held.inverse
        if held.second is not None:
            cubes, content = held.second.cubes[index], content ^ held.second.inverted[index]
        if len(cubes) == 1:
            names = self._literals(cubes[0])
            self._select(change.cube)
            inverse = self._is_low(cubes) != content
            (self.gates.nor if inverse else self.gates.or_)(held.register, names, masked=True)
            return
        if cubes:
            self._turn(change.cube)
        self._select(change.cube)
        self.gates.add(Gate("SET" if content else "CLR", held.register, (), masked=True))
        for cube in cubes:
            self._turn(cube)
            self.gates.nor(MASK, [f"p{plane}" for plane, _ in (*change.cube, *cube)])
            self.gates.add(Gate("CLR" if content else "SET", held.register, (), masked=True))

    def _end_segment(self) -> None:
        """Add the gates so far as a segment (gates that run together), if there are any."""
        if pending := self.gates.take():
            self.segments.append(pending)

    def _load_flag(self, sources: Sequence[str]) -> None:
        """Add the gates that set FLAG to the OR of the registers `sources`, of which FLAG may be
        one.

        Raises GaveUp if WHERE takes fewer sources and no scratch register (for intermediate
        results) is free to gather them. FLAG is the bit that lets a pixel act."""
        limit = self.machine.where_sources
        # FLAG as a source of WHERE is not possible on every chip, so a register takes the OR first.
        if "FLAG" in sources:
            sources = [self._joined("OR", sources)]
        spare = next((name for name in (*sources, *self.free) if name[0] == "t"), None)
        if spare is None and limit is not None and len(sources) > limit:
            raise GaveUp("no register is left to compute with")
        self.gates.load_flag(sources, spare)

    def _joined(self, name: str, sources: Sequence[str], kept: Sequence[str] = ()) -> str:
        """Add the gate `name` (OR or NOR) of the registers `sources`, and return the register that
        it writes: free scratch, or a scratch source that is not in `kept`.

        The other scratch registers among the sources become free, except those in `kept`, which are
        read later. Raises GaveUp if no register is left. A scratch register holds an intermediate
        result."""
        spent = [s for s in dict.fromkeys(sources) if s[0] == "t" and s not in kept]
        target = next(iter([*self.free, *spent]), None)
        if target is None:
            raise GaveUp("no register is left to compute with")
        (self.gates.nor if name == "NOR" else self.gates.or_)(target, sources)
        self.flag_busy &= "FLAG" not in sources or "FLAG" in kept
        self.free = [t for t in [*self.free, *spent] if t != target]
        return target

    def _sources(self, planned: _Planned, index: int, inverse: bool) -> list[str]:
        """Add gates for a rule at demand number `index`; return registers whose OR is the value of
        the rule, or with `inverse` the inverse of the value.

        `planned` is the rule as `_planned` returns it. Raises GaveUp if no register is left. A
        demand is a set of shutters that FLAG must select at a boundary."""
        if isinstance(planned, CoveredPart):
            return self._cubes(planned, index, inverse)
        if isinstance(planned, ComparedPart):
            return self._comparison(planned, index, inverse)
        if isinstance(planned, _Held):
            direct = self._direct(planned, index) == inverse
            return [planned.register if direct else self._joined("NOR", [planned.register])]
        operators, first, second = planned
        operator = operators[index]
        if operator in ("first", "second"):
            return self._sources(first if operator == "first" else second, index, inverse)
        if operator == "xor":
            # Each part is read as its value or its inverse, whichever takes fewer gates; every
            # inverse inverts the exclusive or.
            directs = self._direct(first, index), self._direct(second, index)
            a, b = (
                self._sources(part, index, direct)
                for part, direct in zip((first, second), directs, strict=True)
            )
            neither = [self._joined("NOR", [*a, *b], kept=[*a, *b])]
            # `only_a` needs a register, and no source gives one back: `neither` leaves its own.
            if not self.free and not any(name[0] == "t" for name in b):
                neither = self._in_flag(neither)
            # `neither` is 1 where both are 0, so this is 1 where only the first is 1.
            only_a = self._joined("NOR", [*neither, *b], kept=neither)
            only_b = self._joined("NOR", [*neither, *a])
            joined, direct = [only_a, only_b], directs[0] ^ directs[1]
        else:
            # A NOR joins the inverses of the parts of an `and`.
            joined, direct = [], operator == "and"
            for part in (first, second):
                # The next part needs a register, so FLAG takes over those of the parts before it.
                if not self.free and self._needs_scratch(part, index, direct):
                    joined = self._in_flag(joined)
                joined += self._sources(part, index, direct)
        return joined if direct == inverse else [self._joined("NOR", joined)]

    def _in_flag(self, names: list[str]) -> list[str]:
        """Move the OR of the scratch registers among `names` to FLAG, and return the names with
        FLAG instead of them. The scratch registers (for intermediate results) are then free.

        Raises GaveUp if none of the names is scratch, or if FLAG (the bit that lets a pixel act) is
        in use."""
        scratch = [name for name in names if name[0] == "t"]
        if not scratch or self.flag_busy:
            raise GaveUp("no register is left to compute with")
        self.gates.load_flag(scratch, scratch[0])
        self.free += scratch
        self.flag_busy = True
        return ["FLAG", *(name for name in names if name not in scratch)]

    def _needs_scratch(self, planned: _Planned, index: int, inverse: bool) -> bool:
        """Return whether the gates that `_sources` adds for a rule at demand `index`, inverted if
        `inverse`, write a scratch register (for intermediate results). A demand is a set of
        shutters that FLAG must select at a boundary."""
        if self._direct(planned, index) != inverse:
            return True
        match planned:
            case CoveredPart():
                return len(planned.cubes[index]) > 1
            case ComparedPart():
                return len(bit_runs(planned.thresholds[index], planned.width)) > 1
            case _Held():
                return False
        operators, first, second = planned
        match operators[index]:
            case "first":
                return self._needs_scratch(first, index, inverse)
            case "second":
                return self._needs_scratch(second, index, inverse)
            case "xor":
                return True
        return any(self._needs_scratch(part, index, inverse) for part in (first, second))

    def _direct(self, planned: _Planned, index: int) -> bool:
        """Return whether registers with the inverse of a rule, at demand number `index`, take fewer
        gates than those with its value. For an exclusive or the result is False. A demand is a set
        of shutters that FLAG must select at a boundary."""
        match planned:
            case _Held():
                return planned.inverse ^ planned.state.inverted[index]
            case CoveredPart():
                return self._is_low(planned.cubes[index]) ^ planned.inverted[index]
            case ComparedPart():
                runs = bit_runs(planned.thresholds[index], planned.width)
                return (bool(runs) and runs[-1][0]) ^ planned.inverted[index]
        operators, first, second = planned
        match operators[index]:
            case "first":
                return self._direct(first, index)
            case "second":
                return self._direct(second, index)
            case operator:
                return operator == "and"

    def _turn_ahead(self, planned: _Planned, index: int) -> None:
        """Append the inversions of planes that the gates of a rule at demand `index` need.

        They come before all gates, because the inversion of a plane in the masked register needs
        the mask, which is scratch. A part with several cubes needs inversions between them."""
        match planned:
            case CoveredPart():
                for cube in planned.cubes[index]:
                    if len(planned.cubes[index]) == 1 and len(cube) > 1:
                        self._turn(cube)
            case ComparedPart():
                code = compared_code(planned.thresholds[index])
                places = range(1, planned.width)
                self._turn(tuple((planned.base + i, code >> i & 1) for i in places))
            case (operators, first, second):
                if operators[index] != "second":
                    self._turn_ahead(first, index)
                if operators[index] != "first":
                    self._turn_ahead(second, index)

    def _comparison(self, compared: ComparedPart, index: int, inverse: bool) -> list[str]:
        """Add gates that compare a number with the threshold of demand `index`, and return
        registers whose OR is the part's value, or with `inverse` its inverse.

        The planes are now the exclusive or of both codes. In the highest plane that is 1, number
        and threshold differ: the number is larger if that bit of the threshold is 0. So, from the
        lowest bit up, bits that are 0 in the threshold are joined to the result by an OR, and those
        that are 1 to its inverse. Raises GaveUp if no register is left."""
        inverse ^= compared.inverted[index]
        names: list[str] = []
        # The OR of `names` is the result for the bits so far, or its inverse if `low`. Equal
        # numbers count as larger.
        low = True
        for ones, bits in bit_runs(compared.thresholds[index], compared.width):
            carried = [self._joined("NOR", names)] if names else []
            names = [*(f"p{compared.base + bit}" for bit in bits), *carried]
            low = ones
        return names if low == inverse else [self._joined("NOR", names)]

    def _is_low(self, cubes: Sequence[Cube]) -> bool:
        """Return whether the registers that are read for `cubes` hold the inverse of their OR. They
        do for one cube of several planes (a NOR is still to come), and for a single plane whose
        register holds the inverse of the literal; not for several cubes (NORs of registers), nor
        for none. A plane is the content of a code register."""
        if len(cubes) != 1 or len(cubes[0]) != 1:
            return len(cubes) == 1
        ((plane, value),) = cubes[0]
        return bool(self.standing.inverted[plane] == value)

    def _cubes(self, covered: CoveredPart, index: int, inverse: bool) -> list[str]:
        """Add gates for a part at demand number `index`, and return registers whose OR is the value
        of the part, or with `inverse` its inverse.

        The part is an OR of cubes, or the inverse of one; a cube is the NOR of its planes. Planes
        are inverted first where needed. Raises GaveUp if no register is left. A demand is a set of
        shutters that FLAG must select at a boundary."""
        cubes, low = covered.cubes[index], self._is_low(covered.cubes[index])
        inverse ^= covered.inverted[index]
        names = self._literals(cubes[0]) if len(cubes) == 1 else []
        for cube in cubes if len(cubes) > 1 else ():
            self._turn(cube)
            if names and not self.free:
                names = self._in_flag(names)
            names.append(self._joined("NOR", [f"p{plane}" for plane, _ in cube]))
            # Joined at once, which frees a register for the next cube.
            names = [self._joined("OR", names)] if len(names) > 1 else names
        return names if low == inverse else [self._joined("NOR", names)]

    def _literals(self, cube: Cube) -> list[str]:
        """Return the names of the planes (contents of code registers) of a cube (a NOR of
        registers), whose NOR is the cube. Planes of several are first inverted where needed; a
        single plane stays as it is."""
        if len(cube) > 1:
            self._turn(cube)
        return [f"p{plane}" for plane, _ in cube]

    def _turn(self, cube: Cube) -> None:
        """Append the gates, if any, that invert planes (contents of code registers) so that a cube
        is their NOR. They end the segment (gates that run together) before them and are segments of
        their own."""
        if any(self.standing.inverted[plane] != value for plane, value in cube):
            self._end_segment()
            self.segments += self.standing.turn(cube)
