"""The parts of rules that are composed by `and`, `or` and `xor` from parts that read different
fields.

The parts are found in the predicates: a rule `A and B` opens exactly the shutters that are open in
the projections on the fields of A and of B. Each demand (a set of shutters that FLAG must select at
a boundary) may join the same parts by another operator, as buckets and rules with a condition on n
do."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np

from nscc.arrays import Bools, Indices, Ints
from nscc.logic.problem import Problem
from nscc.truth import rows

Open = Bools
"""Whether each shutter satisfies a part of the rule at each demand, (shutters, demands)."""
Operator = Literal["and", "or", "xor", "first", "second"]
"""How a demand joins two parts; "first" and "second" mean that it reads only that part."""
Fields = dict[str, Ints]

_MOST_FIELDS = 5
"""Largest number of fields of a rule that is taken apart."""


@dataclass(frozen=True)
class RulePart:
    """A part of a rule: what it opens, and the fields that it reads.

    `open`, bool (shutters, demands), is the part's value, or its inverse at the demands where
    `inverted`, bool (demands,), is true. `fields` gives the value of each field in every shutter
    (shutters,). A demand is a set of shutters that FLAG must select at a boundary."""

    open: Open
    inverted: Bools
    fields: Fields


@dataclass(frozen=True)
class Composition:
    """Two parts, which read different fields, and for each demand the operator that joins what they
    open. A part may be composed, too. A demand is a set of shutters that FLAG must select at a
    boundary."""

    operators: tuple[Operator, ...]
    first: Rule
    second: Rule


Rule = RulePart | Composition


def composition(problem: Problem) -> Rule | None:
    """Return the parts of the rule of `problem`.

    None for events, for problems without demands, for more than _MOST_FIELDS fields, and for a rule
    of a single part in which shutters open and close again. A demand is a set of shutters that FLAG
    must select at a boundary."""
    levels_only = all(demand.edge == "open" for demand in problem.demands)
    if not (levels_only and problem.demands and len(problem.values) <= _MOST_FIELDS):
        return None
    is_open = rows([demand.predicate for demand in problem.demands], problem.shutters)
    codes = problem.codes
    if codes is None:
        rule = decomposed(is_open, dict(problem.values))
    else:  # with all codes, every value of a part occurs beside every value of the others
        rule = decomposed(is_open[codes.shutters], dict(codes.values))
        rule = _restricted(rule, codes.rows)
    return rule if isinstance(rule, Composition) or monotone(rule.open) else None


def _restricted(rule: Rule, codes: Indices) -> Rule:
    """Return a rule for some of the codes: row i of the result is row `codes[i]` of `rule`, in all
    parts."""
    if isinstance(rule, Composition):
        parts = _restricted(rule.first, codes), _restricted(rule.second, codes)
        return Composition(rule.operators, *parts)
    fields = {name: of[codes] for name, of in rule.fields.items()}
    return RulePart(rule.open[codes], rule.inverted, fields)


def decomposed(is_open: Open, fields: Fields) -> Rule:
    """Return a rule as a composition of parts with different fields; a single part if no operators
    join parts. Each part is divided again until no operators join its fields.

    `is_open`, bool (shutters, demands), is what the rule opens; `fields` gives for each field its
    value in every shutter (shutters,). The smallest groups of fields are tried first. Of divisions
    into groups of one size, the one whose larger part only opens or closes is taken. A demand is a
    set of shutters that FLAG must select at a boundary."""
    names = sorted(fields)
    for size in range(1, len(names) // 2 + 1):
        splits = []
        for chosen in combinations(names, size):
            first = {name: fields[name] for name in chosen}
            second = {name: fields[name] for name in names if name not in chosen}
            if _number(first).max() < _number(second).max():
                first, second = second, first
            split = _split(is_open, _number(first), _number(second))
            if split is not None:
                operators, a, b = split
                nested = monotone(a ^ inversions(a))
                splits.append((nested * (_number(first).max() + 1), operators, a, b, first, second))
        if splits:
            _, operators, a, b, first, second = max(splits, key=lambda split: split[0])
            if set(operators) == {"first"}:
                return decomposed(a, first)
            if set(operators) == {"second"}:
                return decomposed(b, second)
            return Composition(operators, decomposed(a, first), decomposed(b, second))
    inverted = inversions(is_open)
    return RulePart(is_open ^ inverted, inverted, fields)


def _number(fields: Fields) -> Indices:
    """Return the number of each shutter's combination of values among all combinations that occur
    in these fields, (shutters,), from 0."""
    _, number = np.unique(np.stack([*fields.values()]), axis=1, return_inverse=True)
    return number.reshape(-1)


def _split(
    is_open: Open, first: Indices, second: Indices
) -> tuple[tuple[Operator, ...], Open, Open] | None:
    """Return (operators, a, b) such that a and b, joined by an operator for each demand, are
    `is_open`. Here a depends on `first` only, and b on `second` only. None if there are no such
    parts.

    `first` and `second`, (shutters,), number the combinations of values of two groups of fields. An
    exclusive or is found only if all pairs of numbers occur. A demand is a set of shutters that
    FLAG must select at a boundary."""
    found: list[tuple[Bools, Operator, Open, Open]] = []
    for operator, a, b in _joins(is_open, first, second):
        joined = {"and": a & b, "or": a | b, "xor": a ^ b, "first": a, "second": b}[operator]
        found.append((np.all(joined == is_open, axis=0), operator, a, b))
    # An exclusive or that serves all demands, and that some need, comes first, because a state may
    # hold it; then parts that are read alone, then the operator of most demands.
    others = np.any([fits for fits, operator, *_ in found if operator != "xor"], axis=0)
    found.sort(
        key=lambda item: (
            not (item[1] == "xor" and item[0].all() and not others.all()),
            item[1] not in ("first", "second"),
            -int(item[0].sum()),
        )
    )
    choice = np.full(is_open.shape[1], -1)
    for index, (fits, *_) in enumerate(found):
        choice[fits & (choice < 0)] = index
    if np.any(choice < 0):
        return None
    a, b = np.zeros_like(is_open), np.zeros_like(is_open)
    unknown_a, unknown_b = np.zeros_like(is_open), np.zeros_like(is_open)
    for index, (_, operator, a_, b_) in enumerate(found):
        at = choice == index
        a[:, at], b[:, at] = a_[:, at], b_[:, at]
        # Where the other part decides alone, a part may be anything.
        if operator in ("and", "or"):
            decided = operator == "or"
            unknown_a[:, at] = ~_any_of(b_[:, at] ^ decided, first)
            unknown_b[:, at] = ~_any_of(a_[:, at] ^ decided, second)
        unknown_a[:, at] |= operator == "second"
        unknown_b[:, at] |= operator == "first"
    operators = tuple(found[index][1] for index in choice)
    return operators, _filled(a, unknown_a), _filled(b, unknown_b)


def _joins(is_open: Open, first: Indices, second: Indices) -> Iterator[tuple[Operator, Open, Open]]:
    """Yield for each operator the only parts (a, b) that it can join to `is_open`; whether it does
    is still to be tested. Arguments are as for `_split`."""
    any_a, any_b = _any_of(is_open, first), _any_of(is_open, second)
    yield "first", any_a, any_b
    yield "second", any_a, any_b
    yield "and", any_a, any_b
    yield "or", ~_any_of(~is_open, first), ~_any_of(~is_open, second)
    # With all pairs of values, the first values determine an exclusive or, up to a constant at each
    # demand.
    shape = first.max() + 1, second.max() + 1
    _, at = np.unique(first * shape[1] + second, return_index=True)
    if len(at) == shape[0] * shape[1]:
        pairs = is_open[at].reshape(*shape, -1)
        yield "xor", pairs[:, 0][first], (pairs[0] ^ pairs[0, :1])[second]


def only_opens(bits: Open) -> bool:
    """Return whether no shutter closes again after it has opened. `bits` is bool (shutters,
    demands); the demands (sets of shutters that FLAG must select at boundaries) are in time order.
    FLAG is the bit that lets a pixel act."""
    return not np.any(bits[:, :-1] & ~bits[:, 1:])


def monotone(bits: Open) -> bool:
    """Return whether all shutters only open, or all only close. `bits` is as in `only_opens`."""
    return only_opens(bits) or only_opens(~bits)


def _any_of(bits: Open, number: Indices) -> Open:
    """Return for each shutter, at each demand, whether a bit is set in any shutter of the same
    number.

    `bits` is bool (shutters, demands), as is the result; `number` is (shutters,). A demand is a set
    of shutters that FLAG must select at a boundary."""
    order = np.argsort(number, kind="stable")
    starts = np.flatnonzero(np.diff(number[order], prepend=-1))
    joined: Open = np.logical_or.reduceat(bits[order], starts, axis=0)[number]
    return joined


def inversions(bits: Open, unknown: Open | None = None) -> Bools:
    """Return the demands, bool (demands,), at which `bits` are inverted, so that few shutters
    differ from one demand to the next.

    None are if shutters only close, or only open. Each demand is compared with the one before it:
    the inverse is taken if fewer shutters differ. Bits where `unknown` is true do not count. A
    demand is a set of shutters that FLAG must select at a boundary."""
    known = np.ones_like(bits) if unknown is None else ~unknown
    inverted = np.zeros(bits.shape[1], dtype=np.bool_)
    if _nested(bits, known) is not None:
        return inverted
    read = np.flatnonzero(known.any(axis=0))
    before, after = read[:-1], read[1:]
    both = known[:, before] & known[:, after]
    differ = ((bits[:, before] ^ bits[:, after]) & both).sum(axis=0)
    inverted[after] = np.logical_xor.accumulate(2 * differ > both.sum(axis=0))
    return inverted


def _nested(bits: Open, known: Open) -> Open | None:
    """Return bits that only fall over the demands, or else only rise, and equal `bits` where
    `known` is true; None if there are none. All are bool (shutters, demands). A demand is a set of
    shutters that FLAG must select at a boundary."""
    ones = bits & known
    # Accumulated backwards in time: 1 until the last demand with a 1, so the bits only fall.
    falling = np.logical_or.accumulate(ones[:, ::-1], axis=1)[:, ::-1]
    for nested in (falling, np.logical_or.accumulate(ones, axis=1)):
        if np.array_equal(nested & known, ones):
            return nested
    return None


def _filled(bits: Open, unknown: Open) -> Open:
    """Return `bits`, bool (shutters, demands), with other values where `unknown` is true, so that
    each shutter's bits only fall over the demands, or else only rise, except for demands at which
    all are inverted.

    Falling is tried first. If neither is possible, demands with unknown bits only repeat the
    demand before them. A demand is a set of shutters that FLAG must select at a boundary."""
    if not unknown.any():
        return bits
    inverted = inversions(bits, unknown)
    nested = _nested(bits ^ inverted, ~unknown)
    if nested is not None:
        return nested ^ inverted
    source = np.maximum.accumulate(np.where(unknown.all(axis=0), 0, np.arange(bits.shape[1])))
    return bits[:, source]
