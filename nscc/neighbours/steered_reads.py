"""Planes that read bits of neighbours under conditions, so that one word reads all of them.

R1 to R4 choose neighbours in each pixel for itself. The word DNEWS then gives each pixel the OR of
the chosen bits: for `s and s[0, 1] or not s and s[0, -1]`, R1 is `s` and R3 is `not s`."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce

from nscc.operations import STEERING
from nscc.record import Record
from nscc.words import pictures as p

_OF_STEP = {step: name for name, step in STEERING.items()}
Term = tuple[tuple[p.Condition, ...], p.Condition]
"""Conditions, and a condition that counts where all of them are 1."""


class SteeredRead(Record):
    """A plane: the OR of bits of nearest neighbours, each where its guard is 1, and of `rest`.

    The bits are those of `source`. `guards` has the register of R1 to R4 that chooses a neighbour,
    with the condition where it does so. `rest` is None if nothing else is 1."""

    source: p.Condition
    guards: Mapping[str, p.Condition]
    rest: p.Condition | None

    @property
    def conditions(self) -> tuple[p.Condition, ...]:
        """All conditions that its words compute."""
        rest = () if self.rest is None else (self.rest,)
        return self.source, *self.guards.values(), *rest


def steered_read(node: p.Condition) -> SteeredRead | None:
    """Return a condition as one steered read: R1 to R4 choose the neighbours whose bits are ORed.

    Return None if it reads no nearest neighbour, or one without a condition, if it reads bits of
    several planes, or if a guard reads neighbours itself."""
    guards: dict[str, p.Condition] = {}
    sources, rest = [], []
    for conditions, term in _terms(node):
        if not isinstance(term, p.At) or (term.right, term.down) not in _OF_STEP:
            rest.append(reduce(_both, conditions, term))
        elif not conditions:
            return None
        else:
            name, guard = _OF_STEP[term.right, term.down], reduce(_both, conditions)
            guards[name] = p.Joined("or", guards[name], guard) if name in guards else guard
            sources.append(term.condition)
    if len({*sources}) != 1 or any(map(_reads_neighbours, guards.values())):
        return None
    total = reduce(lambda first, second: p.Joined("or", first, second), rest) if rest else None
    return SteeredRead(sources[0], guards, total)


def _both(first: p.Condition, second: p.Condition) -> p.Condition:
    """Return the condition that holds where both `first` and `second` hold."""
    return p.Neither(p.inverse_of(first), p.inverse_of(second))


def _reads_neighbours(node: p.Condition) -> bool:
    """Return whether the words of a condition need R1 to R4."""
    return any(isinstance(part, p.READS_NEIGHBOURS) for part in p.subexpressions(node))


def _terms(node: p.Condition) -> list[Term]:
    """Return terms whose OR is the condition, divided as far as bits of neighbours stand alone."""
    if not _reads_neighbours(node):
        return [((), node)]
    match node:
        case p.Joined(op="or"):
            return _terms(node.first) + _terms(node.second)
        case p.Neither():
            first, second = p.inverse_of(node.first), p.inverse_of(node.second)
            for guard, inner in ((first, second), (second, first)):
                if not _reads_neighbours(guard):
                    return _guarded(guard, inner)
        case p.ChosenPlane():
            otherwise = _guarded(p.inverse_of(node.condition), node.otherwise)
            return _guarded(node.condition, node.then) + otherwise
    return [((), node)]


def _guarded(guard: p.Condition, node: p.Condition) -> list[Term]:
    """Return the terms of `guard and node`."""
    return [((guard, *conditions), term) for conditions, term in _terms(node)]
