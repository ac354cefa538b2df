"""Generator for rules composed by `and`, `or` and `xor` from parts that read different fields.

The parts are found in the predicates: a rule `A and B` opens exactly the shutters that are open in
the projections on the fields of A and of B. A part that only closes, or only opens, is a state that
collects the shutters that have changed. Any other part is computed from cubes of its own planes.
Each slot then joins the parts by one or more gates."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import permutations

import numpy as np

from nscc.logic.cubes import Budget, Cube, Standing, cover
from nscc.logic.digits import Planes, binary_planes, gray
from nscc.logic.problem import Gate, Gates, GaveUp, Machine, Problem, Segment, Solution
from nscc.logic.rule_parts import (
    Composition,
    Operator,
    Rule,
    composition,
    only_opens,
)
from nscc.logic.script import Script
from nscc.truth import columns

Value = tuple[str, bool]
"""A register, and whether it holds a value itself (true) or its inverse."""

# Limits: cubes of a part at one demand, and low bits of a counted part whose
# cubes are submasks (more of them need fewer inversions, but a larger store).
_MOST_CUBES = 4
_SUBMASK_BITS = (13, 4)


def composed(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """Yield the solutions of a composed rule; raise GaveUp for a rule that is not composed.
    `steps` limits the search for gates. A rule is composed if it joins conditions on different
    fields by `and`, `or` or `xor`."""
    rule = composition(problem)
    if rule is None:
        raise GaveUp("the rule is not composed from parts with different fields")
    from nscc.logic.script_walk import walk  # few rules are composed, so checks need no covers

    for submask_bits in _SUBMASK_BITS:
        writer = _Writer(problem, machine, submask_bits)
        yield from walk(problem, machine, writer.script(rule), steps)


@dataclass
class _Counted:
    """A part that only closes or only opens, as a state that collects changed shutters.

    `changes` maps the demand of a change to its number. The NOR of the planes at which a number has
    a 0 selects the number and its submasks, which have changed before. Higher planes are in Gray
    code and inverted over time."""

    state: str
    closes: bool
    changes: dict[int, int]
    planes: range
    low_bits: int


@dataclass
class _Covered:
    """A part whose values are ORs of `cubes` at each demand, or inverses of an OR if `inverted`."""

    cubes: list[list[Cube]]
    inverted: list[bool]


@dataclass
class _Writer:
    """The planes, states and gates of one frame, under construction."""

    problem: Problem
    machine: Machine
    submask_bits: int
    planes: Planes = field(default_factory=list)
    states: int = 0

    def script(self, rule: Rule) -> Script:
        """Return the script that computes a rule at each demand: planes, state updates and the
        gates of the rule.

        Raises GaveUp if no register is left for intermediate results."""
        planned = self._planned(rule)
        scratch = self.machine.registers - len(self.planes) - self.states
        if scratch < 1:
            raise GaveUp("the parts leave no register to compute with")
        self.gates = Gates(self.machine)
        self.standing = Standing(self.gates, len(self.planes))
        opening = tuple((Gate("CLR", f"s{state}", ()),) for state in range(self.states))
        before: dict[int, tuple[Segment, ...]] = {}
        for index in range(len(self.problem.demands)):
            self.free = [f"t{number}" for number in range(scratch)]
            self.segments: list[Segment] = []
            for leaf in _leaves(planned):
                self._advance(leaf, index)
            if not self.problem.answered(index):
                self._load_flag(planned, index)
                self._end_segment()
            before[index] = tuple(self.segments)
        name = f"parts of the rule, {min(self.submask_bits, len(self.planes))} submask bits"
        closing = self.standing.restore()
        return Script(name, self.planes, self.states, opening, before, closing)

    def _planned(self, rule: Rule) -> _Planned:
        """Choose planes and states for all parts of a rule, add them to the writer, and return the
        rule with its parts replaced.

        A part that only opens or only closes becomes a state that counts to its time of change; any
        other part is covered by cubes."""
        if isinstance(rule, Composition):
            return rule.operator, self._planned(rule.first), self._planned(rule.second)
        is_open, base = rule.open, len(self.planes)
        text = " and ".join(rule.fields)
        for closes in (True, False):
            if only_opens(~is_open if closes else is_open):
                changed_at, numbers = np.unique(
                    (is_open if closes else ~is_open).sum(axis=1), return_inverse=True
                )
                width = int(len(changed_at) - 1).bit_length()
                low = min(self.submask_bits, width)
                coded = gray(numbers >> low) << low | numbers & (1 << low) - 1
                self.planes += binary_planes(f"{text}, change, bit", coded, width)
                self.states += 1
                changes = {int(demand): number for number, demand in enumerate(changed_at)}
                planes = range(base, base + width)
                return _Counted(f"s{self.states - 1}", closes, changes, planes, low)
        order = np.lexsort([*rule.fields.values()][::-1])
        _, first, kinds = np.unique(is_open[order], axis=0, return_index=True, return_inverse=True)
        numbers = np.empty(len(order), dtype=np.int64)
        numbers[order] = np.argsort(np.argsort(first))[kinds.reshape(-1)]
        self.planes += binary_planes(
            f"{text}, Gray bit", gray(numbers), int(numbers.max()).bit_length()
        )
        return self._covered(columns(is_open), base)

    def _covered(self, predicates: Sequence[int], base: int) -> _Covered:
        """Return for each predicate the cheaper cover by cubes: of itself, or of its complement.

        Cubes read the planes from number `base` on. Raises GaveUp if a predicate needs more than
        `_MOST_CUBES`."""
        vectors, everything = [p for p, _ in self.planes[base:]], self.problem.everything
        budget = Budget(20_000 * len(predicates))
        known: dict[int, tuple[list[Cube], bool]] = {}
        for predicate in dict.fromkeys(predicates):
            covers = [
                [tuple((base + plane, value) for plane, value in cube) for cube in found]
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

    def _end_segment(self) -> None:
        """Add the gates so far as a segment, if there are any."""
        if pending := self.gates.take():
            self.segments.append(pending)

    def _scratch(self) -> str:
        """Return a free scratch register, which is then in use; raise GaveUp if there is none."""
        if not self.free:
            raise GaveUp("no register is left to compute with")
        return self.free.pop(0)

    def _advance(self, leaf: _Counted | _Covered, index: int) -> None:
        """Append the gates that a part needs before demand `index`: invert the planes that it
        reads, and update its state."""
        if isinstance(leaf, _Covered):
            for cube in leaf.cubes[index][:1]:
                self.segments += self.standing.turn(cube if len(cube) > 1 else ())
        elif index in leaf.changes:
            number = leaf.changes[index]
            if number and not number & (1 << leaf.low_bits) - 1:
                high = number >> leaf.low_bits
                flipped = (high & -high).bit_length() - 1 + leaf.low_bits
                self.segments.append(self.standing.flip(leaf.planes[flipped]))
            sources = [
                f"p{plane}"
                for bit, plane in enumerate(leaf.planes)
                if bit >= leaf.low_bits or not number >> bit & 1
            ]
            self.gates.nor(self.free[0], sources)
            self.gates.or_(leaf.state, [leaf.state, self.free[0]])
            self._end_segment()

    def _load_flag(self, planned: _Planned, index: int) -> None:
        """Add the gates that set FLAG to the value of a rule.

        With one scratch register, FLAG holds the first part of an `or` meanwhile."""
        operator, *parts = planned if isinstance(planned, tuple) else ("", planned)
        alone = len(self.free) == 1
        if alone and operator == "xor" and (pair := _state_and_cover(parts)):
            self._load_difference(*pair, index)
            return
        if alone and operator == "or" and not isinstance(parts[1], tuple):
            terms = self._terms(parts[0], index)
            if terms == ["t0"]:
                self.gates.load_flag(terms, None)
                self.free = ["t0"]
                terms = [self._joined("OR", ["FLAG", *self._terms(parts[1], index)])]
            else:
                terms += self._terms(parts[1], index)
        else:
            terms = self._terms(planned, index)
        self.gates.load_flag(terms, next((t for t in terms if t[0] == "t"), None))

    def _load_difference(self, counted: _Counted, covered: _Covered, index: int) -> None:
        """Add the gates that set FLAG to the exclusive or of two parts with one scratch register.

        The state holds the second term of the exclusive or while FLAG is set, then the state is
        computed again from the two terms: for the state s and the second part c, the terms are
        t = not s and c, and s and not c; s = not (t or not (c or (s and not c)))."""
        if len(covered.cubes[index]) > 1:
            raise GaveUp("one register is too few for a part of several cubes")
        state, scratch = counted.state, self.free[0]
        second, inverted = self._planes_of(covered, index)
        equal = counted.closes ^ inverted
        self.gates.nor(scratch, [state, *second])
        self.gates.load_flag([scratch], None)
        self.gates.nor(scratch, [state, "FLAG"])
        self.gates.nor(state, [*second, "FLAG"])
        if equal:
            self.gates.nor(scratch, [scratch, state])
        self.gates.load_flag([scratch] if equal else [scratch, state], None)
        if equal:
            self.gates.nor(scratch, [scratch, state])
        self.gates.nor(state, [state, *second])
        self.gates.nor(state, [state, scratch])

    def _planes_of(self, covered: _Covered, index: int) -> tuple[list[str], bool]:
        """Return planes whose OR is a part of at most one cube, or its inverse (true).

        `_advance` has given the planes of a cube the polarity of a NOR."""
        planes = [literal for cube in covered.cubes[index] for literal in cube]
        # Of several planes, the OR is the inverse of the cube.
        low = len(planes) > 1 or any(self.standing.inverted[p] == value for p, value in planes)
        return [f"p{plane}" for plane, _ in planes], low ^ covered.inverted[index]

    def _terms(self, planned: _Planned, index: int) -> list[str]:
        """Append gates for a rule at demand `index`; return registers whose OR is its value."""
        if isinstance(planned, tuple) and planned[0] == "or":
            return [*self._terms(planned[1], index), *self._terms(planned[2], index)]
        if isinstance(planned, tuple) and planned[0] == "xor":
            # A covered part comes last, because either polarity takes the same words.
            first, second = sorted(planned[1:], key=lambda part: isinstance(part, _Covered))
            value = self._value(first, index)
            only_one, equal = self._difference([value, self._value(second, index, value[1])])
            return only_one if equal else [self._joined("NOR", only_one)]
        register, positive = self._value(planned, index)
        return [register] if positive else [self._joined("NOR", [register])]

    def _inverse(self, planned: _Planned, index: int) -> list[str]:
        """Add gates for a rule at a demand; return the register that holds its inverse."""
        register, positive = self._value(planned, index)
        return [self._joined("NOR", [register]) if positive else register]

    def _joined(self, name: str, sources: Sequence[str]) -> str:
        """Add the gate `name` (OR or NOR) of the registers `sources`, and return its register: free
        scratch, or a scratch source in place.

        Scratch registers among the sources become free. Raises GaveUp if no register is left."""
        spent = [source for source in dict.fromkeys(sources) if source[0] == "t"]
        target = self.free.pop(0) if self.free else next(iter(spent), None)
        if target is None:
            raise GaveUp("no register is left to compute with")
        (self.gates.nor if name == "NOR" else self.gates.or_)(target, sources)
        self.free += [source for source in spent if source != target]
        return target

    def _value(self, planned: _Planned, index: int, wanted: bool | None = None) -> Value:
        """Add gates for a rule at a demand, and return its value.

        The register holds the value itself (`wanted` is true) or its inverse if that takes no more
        words."""
        if isinstance(planned, _Counted):
            return planned.state, not planned.closes
        if isinstance(planned, _Covered):
            return self._cubes(planned.cubes[index], not planned.inverted[index], wanted)
        operator, first, second = planned
        if operator == "or":
            return self._joined("OR", self._terms(planned, index)), True
        if operator == "and":
            pair = _state_and_cover((first, second))
            if pair and not pair[0].closes and len(pair[1].cubes[index]) == 1:
                planes, inverted = self._planes_of(pair[1], index)
                if inverted:  # s and not c = not (not (s or c) or c)
                    neither = self._joined("NOR", [pair[0].state, *planes])
                    return self._joined("NOR", [neither, *planes]), True
            return self._joined(
                "NOR", [*self._inverse(first, index), *self._inverse(second, index)]
            ), True
        values = [self._value(first, index), self._value(second, index)]
        only_one, equal = self._difference(values)
        return self._joined("NOR", only_one), not equal

    def _difference(self, values: Sequence[Value]) -> tuple[list[str], bool]:
        """Add gates whose OR is the exclusive or of two registers.

        The second result says whether that is the exclusive or of the values, not its inverse."""
        (a, a_positive), (b, b_positive) = values
        neither = self._scratch()
        self.gates.nor(neither, [a, b])
        only_a = b if b[0] == "t" and not self.free else self._scratch()
        self.gates.nor(only_a, [neither, b])
        only_b = self._joined("NOR", [neither, a])
        return [only_a, only_b], a_positive == b_positive

    def _cubes(self, cubes: Sequence[Cube], positive: bool, wanted: bool | None) -> Value:
        """Add gates for an OR of cubes, and return its value, or its inverse if not `positive`.

        A single cube is a NOR, and its inverse an OR; `wanted` is as in `_value`."""
        if len(cubes) == 1 and len(cubes[0]) == 1:
            ((plane, value),) = cubes[0]
            return f"p{plane}", (value != self.standing.inverted[plane]) == positive
        terms = [] if cubes else [self._joined("OR", [])]
        for cube in cubes:
            self._end_segment()
            self.segments += self.standing.turn(cube)
            target = self._scratch()
            as_or = len(cubes) == 1 and wanted == (not positive)
            gate = self.gates.or_ if as_or else self.gates.nor
            gate(target, [f"p{plane}" for plane, _ in cube])
            positive ^= as_or
            terms.append(target)
            if len(terms) > 1:
                terms = [self._joined("OR", terms)]
        return terms[0], positive


def _state_and_cover(parts: Sequence[_Planned]) -> tuple[_Counted, _Covered] | None:
    """Return the counted and the covered one of `parts`; None if there is not one of each."""
    for first, second in permutations(parts):
        if isinstance(first, _Counted) and isinstance(second, _Covered):
            return first, second
    return None


_Planned = _Counted | _Covered | tuple[Operator, "_Planned", "_Planned"]


def _leaves(planned: _Planned) -> Iterator[_Counted | _Covered]:
    """Yield the parts of the composed rule `planned` from left to right: counted ones and covered
    ones."""
    if isinstance(planned, tuple):
        yield from _leaves(planned[1])
        yield from _leaves(planned[2])
    else:
        yield planned
