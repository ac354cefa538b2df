"""Which of several solutions are worth how many steps of improvement, at each level of effort."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Generic, Protocol, TypeVar

from nscc.logic.cubes import Budget
from nscc.logic.improve.balance import balance, words_at
from nscc.logic.improve.enrich import enrich
from nscc.logic.improve.search import improve
from nscc.logic.problem import Machine, Problem, Solution

# Levels differ in steps only, never in seconds: the same input gives the same words everywhere.
# Every solution gets so many steps before the best go on; which is best shows only then.
FIRST_STEPS = {2: 8_000, 3: 60_000}
# Each of the best gets so many more. A hundred thousand steps are about a second.
MORE_STEPS = {2: 60_000, 3: 2_000_000}
ENRICH_STEPS = {2: 20_000, 3: 400_000}
# Where kernels are kept, the first steps are so many times more: less is left to chance.
KERNEL_SHARE = 4
# The store's share for gates when segments are given kernels of their own; the rest is for analog
# words.
ROOM_SHARE = 0.75
BEST = {2: 1, 3: 3}
# Where words do not fit, so many of the cheapest are improved with their kernels kept as well.
MOST_KEPT = 2


Price = tuple[bool, float, int, int, int]
"""Sort key of a solution: less is better; the first part is False where everything fits."""


class Priced(Protocol):
    """A solution with what it costs."""

    @property
    def solution(self) -> Solution:
        """The gates."""

    @property
    def price(self) -> Price:
        """What it costs."""

    @property
    def words_per_boundary(self) -> Sequence[int]:
        """Words, gates and all others, at each boundary 0..N."""


P = TypeVar("P", bound=Priced)


def refine(
    candidates: Sequence[P],
    problem: Problem,
    machine: Machine,
    level: int,
    priced: Callable[[Solution], P],
    store_words: int,
) -> P:
    """The best candidate, or the best that improvement makes of one; levels 2 and 3.

    `store_words` is how many words all kernels may have.
    """
    return _Refinery(problem, machine, level, priced, store_words).best(candidates)


class _Refinery(Generic[P]):
    def __init__(
        self,
        problem: Problem,
        machine: Machine,
        level: int,
        priced: Callable[[Solution], P],
        store_words: int,
    ) -> None:
        self._problem = problem
        self._machine = machine
        self._level = level
        self._priced = priced
        # With more demands than words in the store, kernels must come again and again: few of them
        # are worth more than the words that many would save.
        self._scarce = len(problem.demands) > store_words
        self._room = 0 if self._scarce else int(store_words * ROOM_SHARE)

    def best(self, candidates: Sequence[P]) -> P:
        """Improves all a little and the best of them more."""
        steps = FIRST_STEPS[self._level]
        first = sorted(
            (self._first(c, steps, i < MOST_KEPT) for i, c in enumerate(candidates)), key=_price
        )
        more = [self._more(found, kept) for _, found, kept in first[: BEST[self._level]]]
        best = min([*more, *(found for _, found, _ in first), *candidates], key=_least)
        return best if self._scarce else min(best, self._balanced(best), key=_least)

    def _first(self, candidate: P, steps: int, patient: bool) -> tuple[Price, P, bool]:
        """(price, improved, whether equal segments had to be kept equal).

        Unless `patient`, they are not: what does not fit then is given up.
        """
        if self._scarce:
            kept = self._kept(candidate.solution, steps)
            return kept.price, kept, True
        found = self._form(self._improved(candidate.solution, steps))
        if found.price[0] and patient:
            # Rewritten freely, segments share no kernels any more.
            other = self._kept(candidate.solution, KERNEL_SHARE * steps)
            if other.price < found.price:
                return other.price, other, True
        return found.price, found, False

    def _more(self, candidate: P, kept: bool) -> P:
        steps = MORE_STEPS[self._level]
        if kept:
            return self._kept(candidate.solution, steps)
        solution = self._improved(candidate.solution, steps // 2)
        budget = Budget(ENRICH_STEPS[self._level])
        richer = enrich(solution, self._problem, self._machine, budget)
        return self._form(self._improved(richer, steps // 2))

    def _improved(self, solution: Solution, steps: int) -> Solution:
        return improve(solution, self._problem, self._machine, Budget(steps))

    def _kept(self, solution: Solution, steps: int) -> P:
        """The solution improved with equal segments kept equal: with room for more of them than
        there are now, and without."""
        found = []
        for room in sorted({self._room, 0}, reverse=True):
            budget = Budget(steps)
            shorter = improve(
                solution, self._problem, self._machine, budget, keep_kernels=True, room=room
            )
            found.append(self._form(shorter))
            if not found[-1].price[0]:
                break
        return min(found, key=_least)

    def _form(self, solution: Solution) -> P:
        """The solution priced; if its words do not fit, with gates and analog words apart."""
        found = self._priced(solution)
        return min(found, self._priced(apart(solution)), key=_least) if found.price[0] else found

    def _balanced(self, candidate: P) -> P:
        """The candidate with its largest boundary made smaller."""
        solution = candidate.solution
        others = list(candidate.words_per_boundary)
        gates = words_at(solution, self._problem, self._machine, len(others) - 1)
        others = [all_ - own for all_, own in zip(others, gates, strict=True)]
        budget = Budget(FIRST_STEPS[self._level])
        return self._form(balance(solution, self._problem, self._machine, budget, others))


def apart(solution: Solution) -> Solution:
    """The solution with no gates in the segments that precede analog words: these are the same in
    every slot, and stored once."""
    answers = tuple((*answer, ()) if answer else answer for answer in solution.answers)
    return replace(solution, answers=answers)


def _price(found: tuple[Price, P, bool]) -> Price:
    return found[0]


def _least(candidate: Priced) -> Price:
    return candidate.price
