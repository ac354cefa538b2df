"""The parts of rules that are composed by `and`, `or` and `xor` from parts that read different
fields.

The parts are found in the predicates: a rule `A and B` opens exactly the shutters that are open in
the projections on the fields of A and of B."""

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
Operator = Literal["and", "or", "xor"]
Fields = dict[str, Ints]

_MOST_FIELDS = 5
"""Largest number of fields of a rule that is taken apart."""


@dataclass(frozen=True)
class RulePart:
    """A part of a rule: what it opens, bool (shutters, demands), and the fields that it reads, each
    with its value in every shutter (shutters,). A demand is a set of shutters that FLAG must select
    at a boundary."""

    open: Open
    fields: Fields


@dataclass(frozen=True)
class Composition:
    """Two parts, which read different fields, and the operator that joins what they open. A part
    may be composed, too."""

    operator: Operator
    first: Rule
    second: Rule


Rule = RulePart | Composition


def composition(problem: Problem) -> Composition | None:
    """Return the parts of the rule of `problem`.

    None for events, for problems without demands, for fewer than two or more than _MOST_FIELDS
    fields, and for a rule that is not composed. A demand is a set of shutters that FLAG must select
    at a boundary."""
    levels_only = all(demand.edge == "open" for demand in problem.demands)
    if not (levels_only and problem.demands and 2 <= len(problem.values) <= _MOST_FIELDS):
        return None
    is_open = rows([demand.predicate for demand in problem.demands], problem.shutters)
    codes = problem.codes
    if codes is None:
        rule = decomposed(is_open, dict(problem.values))
    else:  # with all codes, every value of a part occurs beside every value of the others
        rule = decomposed(is_open[codes.shutters], dict(codes.values))
        rule = _restricted(rule, codes.rows)
    return rule if isinstance(rule, Composition) else None


def _restricted(rule: Rule, codes: Indices) -> Rule:
    """Return a rule for some of the codes: row i of the result is row `codes[i]` of `rule`, in all
    parts."""
    if isinstance(rule, Composition):
        parts = _restricted(rule.first, codes), _restricted(rule.second, codes)
        return Composition(rule.operator, *parts)
    return RulePart(rule.open[codes], {name: of[codes] for name, of in rule.fields.items()})


def decomposed(is_open: Open, fields: Fields) -> Rule:
    """Return a rule as a composition of parts with different fields; a single part if no operator
    joins parts. Each part is divided again until no operator joins its fields.

    `is_open`, bool (shutters, demands), is what the rule opens; `fields` gives for each field its
    value in every shutter (shutters,). The smallest groups of fields are tried first, and the first
    division that works is taken. A demand is a set of shutters that FLAG must select at a boundary.
    """
    names = sorted(fields)
    for size in range(1, len(names)):
        for chosen in combinations(names, size):
            first = {name: fields[name] for name in chosen}
            second = {name: fields[name] for name in names if name not in chosen}
            if _number(first).max() < _number(second).max():
                # `_splits` makes its first group a part that only opens or closes, if it can.
                first, second = second, first
            splits = [*_splits(is_open, _number(first), _number(second))]
            # A part that only opens or closes is the cheapest.
            splits.sort(key=lambda split: not (only_opens(split[1]) or only_opens(~split[1])))
            for operator, a, b in splits[:1]:
                return Composition(operator, decomposed(a, first), decomposed(b, second))
    return RulePart(is_open, fields)


def _number(fields: Fields) -> Indices:
    """Return the number of each shutter's combination of values among all combinations that occur
    in these fields, (shutters,), from 0."""
    _, number = np.unique(np.stack([*fields.values()]), axis=1, return_inverse=True)
    return number.reshape(-1)


def _splits(
    is_open: Open, first: Indices, second: Indices
) -> Iterator[tuple[Operator, Open, Open]]:
    """Yield (operator, a, b) such that `is_open` is a and b, a or b, or a xor b. Here a depends on
    `first` only, and b on `second` only. Yield nothing if there are no such parts.

    `first` and `second`, (shutters,), number the combinations of values of two groups of fields.
    The caller passes as `first` the group with at least as many combinations. If possible, the part
    a only opens or only closes over the demands. An exclusive or is found only if all pairs of
    numbers occur. A demand is a set of shutters that FLAG must select at a boundary."""
    for operator, bits in (("and", is_open), ("or", ~is_open)):
        a, b = _any_of(bits, first), _any_of(bits, second)
        if np.array_equal(a & b, bits):
            # Where the other part is closed in all shutters of a number, a part may be anything.
            a = _filled(a, ~_any_of(b, first))
            b = _filled(b, ~_any_of(a, second))
            yield ("and", a, b) if operator == "and" else ("or", ~a, ~b)
    # With all pairs of values, the first values determine an exclusive or, up to a constant at each
    # demand.
    shape = first.max() + 1, second.max() + 1
    _, at = np.unique(first * shape[1] + second, return_index=True)
    if len(at) == shape[0] * shape[1]:
        pairs = is_open[at].reshape(*shape, -1)
        a, b = pairs[:, 0][first], (pairs[0] ^ pairs[0, :1])[second]
        if np.array_equal(a ^ b, is_open):
            constants = [a[first == number][:1] for number in (first.max(), 0)]
            # Of the constants, one with which the first part only opens or closes is best.
            nested = [c for c in constants if only_opens(a ^ c) or only_opens(~(a ^ c))]
            constant = nested[0] if nested else constants[0]
            yield "xor", a ^ constant, b ^ constant


def only_opens(bits: Open) -> bool:
    """Return whether no shutter closes again after it has opened. `bits` is bool (shutters,
    demands); the demands (sets of shutters that FLAG must select at boundaries) are in time order.
    FLAG is the bit that lets a pixel act."""
    return not np.any(bits[:, :-1] & ~bits[:, 1:])


def _any_of(bits: Open, number: Indices) -> Open:
    """Return for each shutter, at each demand, whether a bit is set in any shutter of the same
    number.

    `bits` is bool (shutters, demands), as is the result; `number` is (shutters,). A demand is a set
    of shutters that FLAG must select at a boundary."""
    order = np.argsort(number, kind="stable")
    starts = np.flatnonzero(np.diff(number[order], prepend=-1))
    joined: Open = np.logical_or.reduceat(bits[order], starts, axis=0)[number]
    return joined


def _filled(bits: Open, unknown: Open) -> Open:
    """Return `bits`, bool (shutters, demands), with other values where `unknown` is true, so that
    each shutter's bits only fall over the demands, or else only rise.

    All shutters fall or all rise; falling is tried first. If neither is possible, return `bits`
    unchanged. A demand is a set of shutters that FLAG must select at a boundary."""
    # Accumulated backwards in time: 1 until the last demand with a 1, so the bits only fall.
    later = np.logical_or.accumulate(bits[:, ::-1], axis=1)[:, ::-1]
    earlier = np.logical_or.accumulate(bits, axis=1)
    for nested in (later, earlier):
        if np.array_equal(nested & ~unknown, bits & ~unknown):
            return nested
    return bits
