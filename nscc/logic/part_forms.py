"""Forms of a part of a composed rule: what its registers hold, and the gates that compute it.

* covered: planes hold a number of each kind of shutter, or the part's values themselves; each
  value is an OR of cubes of these planes
* state: a register holds the part's value, and cubes select the shutters in which it changes
* compared: for a part that only closes or only opens, the number of the change is compared with
  the time, bit by bit; this takes most words, but no register for a state

A kind of shutters are those with equal values at all demands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import combinations, groupby
from math import comb
from typing import NamedTuple

import numpy as np

from nscc.arrays import Indices, Ints
from nscc.logic.cubes import Budget, Cube, cover
from nscc.logic.digits import Numbers, Planes, binary_planes, cycle, gray
from nscc.logic.problem import GaveUp
from nscc.logic.rule_parts import RulePart, monotone, only_opens
from nscc.truth import columns, number_planes, rows, union

# Limits: cubes of a value or a change, and kinds of shutters whose values are covered.
_MOST_CUBES = 4
_MOST_COVERED_KINDS = 512
# Forms of a part that may be better than another in all respects: words are estimates.
_MOST_RIVALS = 2
# Low bits of a binary number whose cubes are submasks; the others are in Gray code. With fewer, the
# same words are repeated more often, so that a smaller store holds them.
_SUBMASK_BITS = (13, 4)


class Change(NamedTuple):
    """The shutters of `cube`, in which a state becomes `value`: a constant, or whether a plane
    holds a bit, as (plane, bit)."""

    value: bool | tuple[int, int]
    cube: Cube


@dataclass(frozen=True)
class CoveredPart:
    """A part whose values are ORs of `cubes[i]` at demand i, or the inverse of that OR if
    `inverted[i]`. An empty list is 0. A demand is a set of shutters that FLAG must select at a
    boundary."""

    cubes: list[list[Cube]]
    inverted: list[bool]


@dataclass(frozen=True)
class StatePart:
    """A part whose value is a state that begins with `start`; `changes[i]` run before demand i.

    The part's value is the state, or its inverse if `inverted[i]`. A demand is a set of shutters
    that FLAG must select at a boundary."""

    start: bool
    changes: list[list[Change]]
    inverted: list[bool]


@dataclass(frozen=True)
class ComparedPart:
    """A part whose value at demand i is whether a number is at least `thresholds[i]`, or the
    inverse of that if `inverted[i]`.

    The planes from number `base` on, `width` of them, hold `compared_code` of the number, lowest
    bit first. A demand is a set of shutters that FLAG must select at a boundary."""

    base: int
    width: int
    thresholds: list[int]
    inverted: list[bool]


Plan = StatePart | CoveredPart | ComparedPart


@dataclass(frozen=True)
class Form:
    """A form of a part: its planes, and a plan that reads them as planes 0, 1, ...

    `words` estimates the words of a frame that the part takes on its own. `varied` tells whether
    many of them differ, so that a small store may not hold them."""

    planes: Planes
    plan: Plan
    words: float
    varied: bool = False

    @property
    def registers(self) -> int:
        """The number of registers that the form occupies all the time."""
        return len(self.planes) + isinstance(self.plan, StatePart)


@dataclass
class _Kinds:
    """The kinds of shutters of a part: the number of each shutter's kind (shutters,), from 0, and
    the set of kinds with value 1 at each demand, as integers with one bit for each kind."""

    number: Indices
    count: int
    values: list[int]
    inverted: list[bool]
    fields: str
    nested: bool

    @property
    def everything(self) -> int:
        """The set of all kinds."""
        return (1 << self.count) - 1


def forms(part: RulePart, most_planes: int) -> list[Form]:
    """Return the forms of a part with at most `most_planes` planes, those with the fewest words
    first. A form is left out if `_MOST_RIVALS` others are better in words and in registers, or if
    one of these takes no words."""
    kinds = _kinds(part)
    fitting = [form for form in _forms(kinds, most_planes) if len(form.planes) <= most_planes]
    kept: list[Form] = []
    for form in sorted(fitting, key=lambda form: (form.words, form.registers)):
        rivals = [
            rival
            for rival in kept
            if rival.registers <= form.registers and rival.varied <= form.varied
        ]
        if len(rivals) < _MOST_RIVALS and all(rival.words for rival in rivals):
            kept.append(form)
    return kept


def _kinds(part: RulePart) -> _Kinds:
    """Return the kinds of shutters of a part. Kinds that only close, or only open, are in the order
    of their change; others in the order of field values, the first field first."""
    order = np.lexsort([*part.fields.values()][::-1])
    _, first, kinds = np.unique(part.open[order], axis=0, return_index=True, return_inverse=True)
    rank = np.argsort(np.argsort(first))
    nested = monotone(part.open)
    if nested:
        change = (part.open if not only_opens(part.open) else ~part.open).sum(axis=1)
        rank = np.argsort(np.argsort(change[order][first], kind="stable"))
    number = np.empty(len(order), dtype=np.int64)
    number[order] = rank[kinds.reshape(-1)]
    at = np.empty(len(first), dtype=np.int64)
    at[rank] = order[first]
    names = " and ".join(part.fields)
    inverted = [bool(bit) for bit in part.inverted]
    return _Kinds(number, len(first), columns(part.open[at]), inverted, names, nested)


def _forms(kinds: _Kinds, most_planes: int) -> Iterator[Form]:
    """Yield forms of a part; some may have more than `most_planes` planes."""
    yield from _stored(kinds, most_planes)
    width = max(1, (kinds.count - 1).bit_length())
    if width > most_planes:
        return
    numbers = np.arange(kinds.count)
    codes: list[tuple[str, Ints, int]] = []
    if kinds.nested:
        for most_low in _SUBMASK_BITS if width > _SUBMASK_BITS[1] else _SUBMASK_BITS[:1]:
            low = min(most_low, width)
            code = gray(numbers >> low) << low | numbers & (1 << low) - 1
            yield from _state(kinds, "change, bit", code, width, low)
        yield _compared(kinds, width)
    else:
        codes.append(("Gray bit", np.array(cycle(kinds.count, width)), width))
        codes += [*_places(kinds.count, most_planes), *_phases(kinds, most_planes)]
        for name, code, bits in codes:
            yield from _state(kinds, name, code, bits, bits)
    if kinds.count <= _MOST_COVERED_KINDS:
        for name, code, bits in (*codes, ("bit", numbers, width)):
            vectors = number_planes(code, bits)
            yield from _covered_by(kinds, _planes(kinds, name, code, bits), vectors)


def _places(count: int, most_planes: int) -> Iterator[tuple[str, Ints, int]]:
    """Yield codes of `count` numbers, with their width, whose low bits are places: codes with
    equally many ones, so that the NOR of the planes that are 0 in one of them selects no other. The
    high bits number the group in Gray code."""
    for bits in range(4):
        size, places = -(-count >> bits), 2
        while comb(places, places // 2) < size:
            places += 1
        if bits + places > most_planes or size < 2:
            continue
        ones = combinations(range(places), places // 2)
        codes = np.array([sum(1 << bit for bit in chosen) for chosen in ones])
        numbers = np.arange(count)
        groups = np.array(cycle(-(-count // size), bits) if bits else (0,))
        code = groups[numbers // size] << places | codes[numbers % size]
        yield "place or group, bit", code, bits + places


def _phases(kinds: _Kinds, most_planes: int) -> Iterator[tuple[str, Ints, int]]:
    """Yield codes of windows, with their width: the start is divided by the most common length. The
    remainder is in the low bits, and the quotient in Gray code.

    A window closes when the next one with the same remainder opens. Both are then one cube."""
    counts = rows(kinds.values, kinds.count).sum(axis=1)
    # The part may be the inverse of windows.
    length = int(np.bincount(np.minimum(counts, len(kinds.values) - counts)).argmax())
    quotients = -(-kinds.count // max(length, 1))
    if not 2 <= length <= kinds.count // 2:
        return
    numbers, high = np.arange(kinds.count), (quotients - 1).bit_length()
    groups = np.array(cycle(quotients, high))
    low = max(1, (length - 1).bit_length())
    phases = [("", np.array(cycle(length, low)), low), *_places(length, most_planes - high)]
    for _, codes, width in phases:
        if high + width <= most_planes:
            code = groups[numbers // length] << width | codes[numbers % length]
            yield "phase or window, bit", code, high + width


def _planes(kinds: _Kinds, name: str, codes: Ints, width: int) -> Planes:
    """Return the planes that hold the code of each shutter's kind."""
    return binary_planes(f"{kinds.fields}, {name}", codes[kinds.number], width)


def _stored(kinds: _Kinds, most_planes: int) -> Iterator[Form]:
    """Yield the form whose planes hold the part's different values as they are."""
    # A value and its inverse need one plane: the one with fewer kinds.
    values = dict.fromkeys(
        min(value, value ^ kinds.everything, key=lambda v: (v.bit_count(), v))
        for value in kinds.values
    )
    stored = [value for value in values if value]
    if sum(v.bit_count() for v in stored) == kinds.count and union(stored) == kinds.everything:
        stored = stored[:-1] or stored  # it is the NOR of the others
    if len(stored) > most_planes:
        return
    of_shutters = columns(rows(stored, kinds.count)[kinds.number])
    planes = [(plane, f"{kinds.fields}, value {i}") for i, plane in enumerate(of_shutters)]
    yield from _covered_by(kinds, planes, stored)


def _covered_by(kinds: _Kinds, planes: Planes, vectors: Sequence[int]) -> Iterator[Form]:
    """Yield the form with these planes, whose contents in each kind are `vectors`, if no value
    takes too many cubes."""
    with suppress(GaveUp):
        plan, words = covered(kinds.values, vectors, kinds.everything)
        inverted = [a != b for a, b in zip(plan.inverted, kinds.inverted, strict=True)]
        yield Form(planes, CoveredPart(plan.cubes, inverted), words)


def covered(
    values: Sequence[int], vectors: Sequence[int], everything: int
) -> tuple[CoveredPart, float]:
    """Return the plan that covers `values`, one for each demand, by cubes of the planes `vectors`,
    and an estimate of its words.

    The values, planes and `everything` are sets of shutters, or of kinds of them. Raises GaveUp if
    the planes do not distinguish the shutters of a value from the others, if a value takes too many
    cubes, or if the search takes too many steps."""
    turned, words = _Turned(len(vectors)), 0.0
    cubes: list[list[Cube]] = []
    inverted: list[bool] = []
    # A part whose covers take more steps than this is given up.
    budget = Budget(2_000 * len(values))
    known: dict[tuple[int, tuple[int, ...]], tuple[list[Cube], bool]] = {}
    for value in values:
        key = value, tuple(turned.polarity)
        if key not in known:
            direct = cover(value, vectors, everything, budget, standing=turned.polarity)
            known[key] = direct, False
            if len(direct) > 1:
                outside = everything & ~value
                other = cover(outside, vectors, everything, budget, standing=turned.polarity)
                if len(other) < len(direct):
                    known[key] = other, True
            if len(known[key][0]) > _MOST_CUBES:
                raise GaveUp(f"a part of the rule takes more than {_MOST_CUBES} cubes")
        chosen, inverse = known[key]
        words += sum(2 * turned.to(cube) + 1 for cube in chosen if len(cube) > 1)
        # With one scratch register, FLAG holds the cubes before the last.
        words += 3 * max(0, len(chosen) - 1)
        cubes.append(chosen)
        inverted.append(inverse)
    return CoveredPart(cubes, inverted), words


class _Turned:
    """The polarity of planes over a frame: `polarity[plane]` is 1 if a plane is inverted."""

    def __init__(self, planes: int) -> None:
        """Begin with planes as they are stored."""
        self.polarity = [0] * planes

    def to(self, cube: Cube) -> int:
        """Invert planes so that a cube is their NOR, and return their number."""
        count = 0
        for plane, value in cube:
            count += self.polarity[plane] != value
            self.polarity[plane] = value
        return count


def _state(kinds: _Kinds, name: str, codes: Ints, width: int, low_bits: int) -> Iterator[Form]:
    """Yield the form that keeps the value in a state, whose changes are cubes of the planes of a
    code, if no change takes too many cubes.

    A cube may also contain kinds that have the new value already, if they have the same bits above
    the `low_bits` lowest."""
    vectors, everything = number_planes(codes, width), kinds.everything
    high = codes >> low_bits
    groups = columns(high[:, None] == np.unique(high))
    start = 2 * kinds.values[0].bit_count() > kinds.count
    now, turned, words = everything * start, _Turned(width), 0.0
    budget = Budget(20_000 * len(kinds.values))
    changes: list[list[Change]] = []
    with suppress(GaveUp):
        for value in kinds.values:
            chosen: list[Change] = []
            both = _exchanged(value & ~now, now & ~value, vectors, everything, turned, budget)
            if both is not None:
                words += 2 * turned.to(both.cube) + 2
                changes.append([both])
                now = value
                continue
            for after, on, same in (
                (False, now & ~value, everything & ~value),
                (True, value & ~now, value),
            ):
                for group in groups if on else ():
                    if on & group:
                        cubes = cover(
                            on & group,
                            vectors,
                            everything,
                            budget,
                            free=same & group,
                            standing=turned.polarity,
                        )
                        for cube in cubes:
                            words += 2 * turned.to(cube) + 2
                        chosen += [Change(after, cube) for cube in cubes]
            if len(chosen) > _MOST_CUBES:
                return
            changes.append(chosen)
            now = value
        varied = kinds.nested and low_bits > _SUBMASK_BITS[1]
        yield Form(
            _planes(kinds, name, codes, width),
            StatePart(start, changes, kinds.inverted),
            words,
            varied,
        )


def _exchanged(
    opening: int,
    closing: int,
    vectors: Sequence[int],
    everything: int,
    turned: _Turned,
    budget: Budget,
) -> Change | None:
    """Return the change that opens kinds and closes others at the same time, if one cube contains
    just these and a plane distinguishes them."""
    planes = [
        (plane, int(not opening & ~vector))
        for plane, vector in enumerate(vectors)
        if (opening & vector, closing & vector) in ((opening, 0), (0, closing))
    ]
    if not (opening and closing and planes):
        return None
    cubes = cover(opening | closing, vectors, everything, budget, standing=turned.polarity)
    return Change(planes[0], cubes[0]) if len(cubes) == 1 else None


def _compared(kinds: _Kinds, width: int) -> Form:
    """Return the form that compares the number of a kind, in the order of changes, with the number
    of changes so far."""
    # Kinds with value 1 are all above a threshold, or all below it.
    above = [value.bit_length() == kinds.count for value in kinds.values]
    thresholds = [
        kinds.count - value.bit_count() if high else value.bit_count()
        for value, high in zip(kinds.values, above, strict=True)
    ]
    inverted = [high == out for high, out in zip(above, kinds.inverted, strict=True)]
    # One plane is inverted in every second slot, and each run of bits but one takes a gate, which
    # writes over its own source from the second on.
    words = sum(1.0 + max(0, 2 * len(bit_runs(t, width)) - 3) for t in thresholds)
    numbers = compared_code(np.arange(kinds.count))
    planes = _planes(kinds, "change, bit", numbers, width)
    return Form(planes, ComparedPart(0, width, thresholds, inverted), words, varied=True)


def oriented(form: Form, plan: CoveredPart, inverse: Sequence[int], everything: int) -> Form:
    """Return a form, with the plan `plan`, whose planes hold what most gates read.

    At demand i, the gates read the part's value if `inverse[i]` is 0, its inverse if it is 1, and
    neither if it is -1. A value that is a single plane takes no gate if the plane holds just that.
    `everything` is the truth vector of all shutters. Planes that are also read by cubes of
    several are left as they are, because they are inverted over time."""
    wide = {plane for cubes in plan.cubes for cube in cubes if len(cube) > 1 for plane, _ in cube}
    votes = [0] * len(form.planes)
    for cubes, inverted, read in zip(plan.cubes, plan.inverted, inverse, strict=True):
        if read >= 0 and len(cubes) == 1 and len(cubes[0]) == 1:
            ((plane, value),) = cubes[0]
            votes[plane] += 1 if value != (inverted != read) else -1
    turned = [vote < 0 and plane not in wide for plane, vote in enumerate(votes)]
    planes = [
        (plane ^ everything * turn, f"{name}, inverted" if turn else name)
        for (plane, name), turn in zip(form.planes, turned, strict=True)
    ]
    cubes_as_stored = [
        [tuple((plane, value ^ turned[plane]) for plane, value in cube) for cube in run]
        for run in plan.cubes
    ]
    return replace(form, planes=planes, plan=CoveredPart(cubes_as_stored, plan.inverted))


def compared_code(number: Numbers) -> Numbers:
    """Return the code of a number, or of each number of an array, that is compared with the code of
    a threshold.

    Above the lowest bit it is the Gray code, so that the next threshold differs in one bit. The
    lowest bit is read for odd thresholds only, so its plane is never inverted: it is 0 where the
    number is odd, too."""
    return gray(number >> 1) << 1 | (number & 1 ^ 1)


def bit_runs(threshold: int, width: int) -> list[tuple[bool, list[int]]]:
    """Return the runs of equal bits of a number of `width` bits, as (value, positions), from the
    lowest 1 up.

    >>> bit_runs(0b0110, 4)
    [(True, [1, 2]), (False, [3])]
    """
    found = [
        (value, [*bits])
        for value, bits in groupby(range(width), lambda bit: bool(threshold >> bit & 1))
    ]
    return found[not threshold & 1 :]


def shifted(plan: Plan, base: int) -> Plan:
    """Return a plan that reads its planes from number `base` on."""

    def cube_at(cube: Cube) -> Cube:
        return tuple((base + plane, value) for plane, value in cube)

    if isinstance(plan, ComparedPart):
        return ComparedPart(base, plan.width, plan.thresholds, plan.inverted)
    if isinstance(plan, CoveredPart):
        return CoveredPart([[cube_at(c) for c in cubes] for cubes in plan.cubes], plan.inverted)
    changes = [
        [
            Change(v if isinstance(v, bool) else (base + v[0], v[1]), cube_at(cube))
            for v, cube in run
        ]
        for run in plan.changes
    ]
    return StatePart(plan.start, changes, plan.inverted)
