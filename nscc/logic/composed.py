"""Generator for rules composed by `and`, `or` and `xor` from parts that read different fields.

The parts are found in the predicates: a rule `A and B` opens exactly the shutters that are open in
the projections on the fields of A and of B. A part that only closes, or only opens, is a state that
collects the shutters that have changed. Any other part is computed from cubes of its own planes.
Each slot then joins the parts by one or more gates.

On a chip with a masked register, that register holds one of the states. A change then takes two
words: a NOR selects the shutters that change, and a masked gate writes the state in these only. The
exclusive or of such a state and a part of cubes is also kept in the masked register: from one
demand to the next, a masked NOT inverts it where the value of the cubes changes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import chain, product
from typing import Literal, get_args

import numpy as np

from nscc.logic.cubes import Budget, Cube, Standing, cover
from nscc.logic.digits import Planes, binary_planes, cycle, gray
from nscc.logic.problem import MASK, Gate, Gates, GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.rule_parts import (
    Operator,
    Rule,
    RulePart,
    composition,
    only_opens,
)
from nscc.logic.script import Script
from nscc.truth import columns, union

# Limits: cubes of a part at one demand, and low bits of a state whose cubes are submasks (more of
# them need fewer inversions, but a larger store).
_MOST_CUBES = 4
_SUBMASK_BITS = (13, 4)


def composed(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield the solutions of a composed rule, from the shortest script for each number of submask
    bits.

    A rule is composed if it joins conditions on different fields by `and`, `or` or `xor`. `steps`
    is the number of search steps (`Budget`) for the gates of each solution; a solution that needs
    more is left out. Raises GaveUp for a rule that is not composed, or if no solution is left,
    usually because registers do not suffice."""
    rule = composition(problem)
    if rule is None:
        raise GaveUp("the rule is not composed from parts with different fields")
    from nscc.logic.script_walk import walk  # few rules are composed, so checks need no covers

    solutions: list[Solution] = []
    for submask_bits in _SUBMASK_BITS:
        scripts: list[Script] = []
        for code, kept in product(get_args(_Code), (False, True)):
            with suppress(GaveUp):
                scripts.append(_Writer(problem, machine, submask_bits, code, kept).script(rule))
        if scripts:
            solutions += walk(problem, machine, min(scripts, key=_words), steps)
    if not solutions:
        raise GaveUp("no register is left to compute with")
    yield from solutions


def _words(script: Script) -> int:
    """Return the words of a script's gates."""
    segments = chain.from_iterable((*script.before.values(), script.closing))
    return sum(gate.words for segment in segments for gate in segment)


_Code = Literal["values", "gray", "binary"]
"""The planes of a part of cubes: its values at the demands, or its number."""


@dataclass
class _Covered:
    """A part whose values are ORs of `cubes[i]` at demand i, or the inverse of that OR if
    `inverted[i]`. An empty list is 0. A demand is a set of shutters that FLAG must select at a
    boundary."""

    cubes: list[list[Cube]]
    inverted: list[bool]


@dataclass
class _State:
    """A part that only closes or only opens, as a state that collects changed shutters.

    `register` is a name such as s0, and `masked` tells whether it is the masked register. The
    register holds the part's value if `positive`, else its inverse. `closes`: the part only closes,
    else it only opens. `changes` maps the index of the demand (a set of shutters that FLAG must
    select at a boundary) at which shutters change to their number. The NOR of the planes (numbers
    `planes`, lowest bit first) at which a number has a 0 selects the number and its submasks, which
    have changed before. So it is for the `low_bits` lowest planes; higher planes are in Gray code
    and inverted over time. With `second` the register holds the exclusive or with that part.
    `steps` are the disjoint parts in which `second` then differs from its value at the demand
    before. FLAG is the bit that lets a pixel act."""

    register: str
    masked: bool
    positive: bool
    closes: bool
    changes: dict[int, int]
    planes: range
    low_bits: int
    second: _Covered | None = None
    steps: tuple[_Covered, ...] = ()


_Planned = _State | _Covered | tuple[Operator, "_Planned", "_Planned"]


@dataclass
class _Writer:
    """The planes (contents of code registers), states and gates of one frame, under construction;
    make a new one for each script.

    `submask_bits` is the most low bits of a state's number whose cubes (NORs of registers) are
    submasks. `code` chooses the planes of parts that cubes cover. With `kept`, an exclusive or is
    kept in the masked register."""

    problem: Problem
    machine: Machine
    submask_bits: int
    code: _Code
    kept: bool
    planes: Planes = field(default_factory=list)
    states: list[_State] = field(default_factory=list)

    def script(self, rule: Rule) -> Script:
        """Return the script that computes a rule at each demand: planes, state updates and the
        gates of the rule. Call it once; it fills the writer's planes and states.

        Raises GaveUp if no register is left for intermediate results, or if a part takes too many
        cubes (NORs of registers). A demand is a set of shutters that FLAG must select at a
        boundary."""
        planned = self._planned(rule, inverse=False)
        scratch = self.machine.registers - len(self.planes) - len(self.states)
        if scratch < 1:
            raise GaveUp("the parts leave no register to compute with")
        self.gates = Gates(self.machine)
        self.standing = Standing(self.gates, len(self.planes))
        # At first no shutter has changed, so each register holds the opposite of its content after
        # a change.
        opening = tuple(
            (Gate("CLR" if _after(state) else "SET", state.register, ()),) for state in self.states
        )
        before: dict[int, tuple[Segment, ...]] = {}
        for index in range(len(self.problem.demands)):
            self.segments: list[Segment] = []
            self.flag_busy = False
            for state in self.states:
                self.free = [f"t{number}" for number in range(scratch)]
                # Scratch values end with the update of a state, so each begins with all registers
                # free.
                self._advance(state, index)
            self.free = [f"t{number}" for number in range(scratch)]
            if not self.problem.answered(index):
                self._load_flag(self._sources(planned, index, inverse=False))
                self._end_segment()
            before[index] = tuple(self.segments)
        name = f"parts of the rule, {min(self.submask_bits, len(self.planes))} submask bits"
        closing = self.standing.restore()
        return Script(name, self.planes, len(self.states), opening, before, closing)

    def _planned(self, rule: Rule, inverse: bool) -> _Planned:
        """Choose planes and states for all parts of a rule, add them to the writer, and return the
        rule with its parts replaced.

        A part that only opens or only closes becomes a state that counts to its time of change; any
        other part is covered by cubes (NORs of registers). With `inverse`, the gates will read the
        rule's inverse, so a state in the masked register is stored inverted. Raises GaveUp if a
        part takes too many cubes. A plane is the content of a code register."""
        if isinstance(rule, RulePart):
            for closes in (True, False):
                if only_opens(~rule.open if closes else rule.open):
                    return self._state(rule, closes, inverse)
            return self._covered(columns(rule.open), self._part_planes(rule))
        # An `and` is the NOR of its parts' inverses, an `or` the OR of their values.
        if rule.operator != "xor":
            inverse = rule.operator == "and"
        first, second = self._planned(rule.first, inverse), self._planned(rule.second, inverse)
        # The masked register can hold the exclusive or of its state and a part of cubes.
        if not (self.kept and rule.operator == "xor" and isinstance(first, _State)):
            return rule.operator, first, second
        alone = first.masked and first.second is None
        if alone and isinstance(second, _Covered) and isinstance(rule.second, RulePart):
            values = columns(rule.second.open)
            steps = [now ^ was for was, now in zip([0, *values[:-1]], values, strict=True)]
            planes = {plane for cubes in second.cubes for cube in cubes for plane, _ in cube}
            first.steps, first.second = self._disjoint(steps, sorted(planes)), second
            return first
        return rule.operator, first, second

    def _state(self, part: RulePart, closes: bool, inverse: bool) -> _State:
        """Add a state for a part, with planes (contents of code registers) that hold the number of
        a shutter's change, and return it.

        `closes`: the part only closes, else it only opens. `inverse`: its gates read the inverse.
        The first state goes into the masked register, if there is one, where both polarities take
        one word."""
        base = len(self.planes)
        # A shutter changes after as many demands as it keeps its first value.
        changed_at, numbers = np.unique(
            (part.open if closes else ~part.open).sum(axis=1), return_inverse=True
        )
        width = int(len(changed_at) - 1).bit_length()
        # The `low` lowest bits are binary: a submask is a smaller number. The others are Gray code.
        low = min(self.submask_bits, width)
        coded = gray(numbers >> low) << low | numbers & (1 << low) - 1
        self.planes += binary_planes(f"{' and '.join(part.fields)}, change, bit", coded, width)
        masked = self.machine.masked and not self.states
        positive = not inverse if masked else not closes
        changes = {int(demand): number for number, demand in enumerate(changed_at)}
        planes = range(base, base + width)
        state = _State(f"s{len(self.states)}", masked, positive, closes, changes, planes, low)
        self.states.append(state)
        return state

    def _part_planes(self, part: RulePart) -> range:
        """Add the planes of a part that cubes cover, in the writer's `code`, and return their
        numbers.

        The part's values at the demands are stored as they are, whatever the code, if that takes no
        more planes than numbers of its kinds of shutters. A cube is a NOR of registers. A demand is
        a set of shutters that FLAG must select at a boundary."""
        base, name = len(self.planes), " and ".join(part.fields)
        # Kinds of shutters are numbered in the order of field values, the first field first:
        # `lexsort` takes the most significant key last.
        order = np.lexsort([*part.fields.values()][::-1])
        _, first, kinds = np.unique(
            part.open[order], axis=0, return_index=True, return_inverse=True
        )
        numbers = np.empty(len(order), dtype=np.int64)
        # `np.unique` sorts kinds by content; they are numbered by their first shutter instead.
        numbers[order] = np.argsort(np.argsort(first))[kinds.reshape(-1)]
        everything = self.problem.everything
        # A value and its inverse need one plane: the one with fewer shutters.
        values = dict.fromkeys(
            min(value, value ^ everything, key=lambda v: (v.bit_count(), v))
            for value in columns(part.open)
        )
        stored = [value for value in values if value]
        if (
            sum(value.bit_count() for value in stored) == self.problem.shutters
            and union(stored) == everything
        ):
            stored.pop()  # it is the NOR of the others
        count = int(numbers.max()) + 1
        width = (count - 1).bit_length()
        if self.code == "values" or len(stored) <= width:
            self.planes += [(value, f"{name}, value {i}") for i, value in enumerate(stored)]
        elif self.code == "gray":
            codes = np.array(cycle(count, width))
            self.planes += binary_planes(f"{name}, Gray bit", codes[numbers], width)
        else:
            self.planes += binary_planes(f"{name}, bit", numbers, width)
        return range(base, len(self.planes))

    def _covered(self, predicates: Sequence[int], planes: Sequence[int]) -> _Covered:
        """Return for each predicate (a truth vector) the cheaper cover by cubes: of itself, or of
        its complement; of itself if both are equal.

        Cubes read the planes with the numbers `planes`. Raises GaveUp if these do not distinguish a
        predicate's shutters from the others, if a predicate needs more than `_MOST_CUBES`, or if
        the search takes too many steps. A cube is a NOR of registers. A predicate is a set of
        shutters."""
        vectors, everything = [self.planes[p][0] for p in planes], self.problem.everything
        # A part whose covers take more steps than this is given up.
        budget = Budget(20_000 * len(predicates))
        known: dict[int, tuple[list[Cube], bool]] = {}
        for predicate in dict.fromkeys(predicates):
            covers = [
                [tuple((planes[plane], value) for plane, value in cube) for cube in found]
                for found in (
                    cover(predicate, vectors, everything, budget),
                    cover(everything & ~predicate, vectors, everything, budget),
                )
            ]
            inverted = len(covers[1]) < len(covers[0])
            if len(covers[inverted]) > _MOST_CUBES:
                raise GaveUp(f"a part of the rule takes more than {_MOST_CUBES} cubes")
            known[predicate] = covers[inverted], inverted
        chosen = [known[predicate] for predicate in predicates]
        return _Covered([cubes for cubes, _ in chosen], [inverted for _, inverted in chosen])

    def _disjoint(self, predicates: list[int], planes: Sequence[int]) -> tuple[_Covered, ...]:
        """Return parts whose exclusive or is open in `predicates`, each with at most one cube (a
        NOR of registers), or its inverse, at each demand; none if all predicates are empty.

        `predicates` are truth vectors, one for each demand (a set of shutters that FLAG must select
        at a boundary); `planes` are the numbers of the planes that cubes may read."""
        parts: list[_Covered] = []
        while any(predicates):
            part = self._covered(predicates, planes)
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

    def _advance(self, state: _State, index: int) -> None:
        """Append the gates that update a state before demand `index`: first the inversions where
        its second part changes, then the change of its own shutters, if any. A demand is a set of
        shutters that FLAG must select at a boundary."""
        for step in state.steps:
            if step.cubes[index] or step.inverted[index]:
                inverse = self._direct(step, index)
                (self.gates.nor if inverse else self.gates.or_)(
                    MASK, self._cubes(step, index, inverse)
                )
                # A masked NOT inverts the state where the value of the cubes changes.
                self.gates.nor(state.register, [state.register], masked=True)
                self._end_segment()
        if index not in state.changes:
            return
        number = state.changes[index]
        # Where the low bits begin again at 0, the high bits count on: one bit of their Gray code.
        if number and not number & (1 << state.low_bits) - 1:
            high = number >> state.low_bits
            # The Gray codes of `high` - 1 and `high` differ in the bit of the lowest 1 of `high`.
            flipped = (high & -high).bit_length() - 1 + state.low_bits
            self.segments.append(self.standing.flip(state.planes[flipped]))
        changed = [
            f"p{plane}"
            for bit, plane in enumerate(state.planes)
            if bit >= state.low_bits or not number >> bit & 1
        ]
        if state.masked:
            self._write_changed(state, index, changed)
        else:
            self.gates.nor(MASK, changed)
            self.gates.or_(state.register, [state.register, MASK])
        self._end_segment()

    def _write_changed(self, state: _State, index: int, changed: Sequence[str]) -> None:
        """Append masked gates that write a state, before demand `index`, in the changed shutters:
        those in which all planes `changed` (names) are 0.

        If the state also holds the exclusive or with a second part, its new content depends on the
        cubes (NORs of registers) of that part. A demand is a set of shutters that FLAG must select
        at a boundary."""
        cubes, content = list[Cube](), _after(state)
        if state.second is not None:
            cubes, content = state.second.cubes[index], content ^ state.second.inverted[index]
        if len(cubes) == 1:
            names = self._literals(cubes[0])
            self.gates.nor(MASK, changed)
            inverse = self._is_low(cubes) != content
            (self.gates.nor if inverse else self.gates.or_)(state.register, names, masked=True)
            return
        self.gates.nor(MASK, changed)
        self.gates.add(Gate("SET" if content else "CLR", state.register, (), masked=True))
        for cube in cubes:
            self._turn(cube)
            self.gates.nor(MASK, [*changed, *(f"p{plane}" for plane, _ in cube)])
            self.gates.add(Gate("CLR" if content else "SET", state.register, (), masked=True))

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
        if isinstance(planned, _Covered):
            return self._cubes(planned, index, inverse)
        if isinstance(planned, _State):
            name = planned.register
            return [name] if planned.positive != inverse else [self._joined("NOR", [name])]
        operator, first, second = planned
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
        if isinstance(planned, tuple):
            parts = planned[1:]
            return planned[0] == "xor" or any(self._needs_scratch(p, index, inverse) for p in parts)
        return isinstance(planned, _Covered) and len(planned.cubes[index]) > 1

    def _direct(self, planned: _Planned, index: int) -> bool:
        """Return whether registers with the inverse of a rule, at demand number `index`, take fewer
        gates than those with its value. For an exclusive or the result is False. A demand is a set
        of shutters that FLAG must select at a boundary."""
        if isinstance(planned, _State):
            return not planned.positive
        if isinstance(planned, _Covered):
            return self._is_low(planned.cubes[index]) ^ planned.inverted[index]
        return planned[0] == "and"

    def _is_low(self, cubes: Sequence[Cube]) -> bool:
        """Return whether the registers that are read for `cubes` hold the inverse of their OR. They
        do for one cube of several planes (a NOR is still to come), and for a single plane whose
        register holds the inverse of the literal; not for several cubes (NORs of registers), nor
        for none. A plane is the content of a code register."""
        if len(cubes) != 1 or len(cubes[0]) > 1:
            return len(cubes) == 1
        ((plane, value),) = cubes[0]
        return bool(self.standing.inverted[plane] == value)

    def _cubes(self, covered: _Covered, index: int, inverse: bool) -> list[str]:
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


def _after(state: _State) -> bool:
    """Return the content of a state's register after the change."""
    return state.closes != state.positive
