"""Which of several solutions are worth how many steps of improvement, at each level of effort."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol, TypeVar

from nscc.logic.cubes import Budget
from nscc.logic.improve.balance import balance, words_at
from nscc.logic.improve.search import improve
from nscc.logic.problem import Machine, Problem, Solution

# Every solution gets so many steps before the best go on; which is best shows only then.
FIRST_STEPS = {2: 20_000, 3: 60_000}
# Each of the best gets so many more. A hundred thousand steps are about a second.
MORE_STEPS = {2: 250_000, 3: 2_000_000}
BEST = {2: 2, 3: 3}


class Priced(Protocol):
    """A solution with what it costs."""

    @property
    def solution(self) -> Solution:
        """The gates."""

    @property
    def price(self) -> tuple[bool, int, int]:
        """Sort key: less is better; the first part is False where everything fits."""

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
) -> P:
    """The best candidate, or the best that improvement makes of one; levels 2 and 3.

    Rewritten freely, a solution's segments share no kernels any more; where they then take more
    store than there is, those that were equal are kept so.
    """

    def improved(candidate: P, steps: int, *, keep_kernels: bool) -> P:
        budget = Budget(steps)
        solution = candidate.solution
        return priced(improve(solution, problem, machine, budget, keep_kernels=keep_kernels))

    first = []
    for candidate in candidates:
        found, kept = improved(candidate, FIRST_STEPS[level], keep_kernels=False), False
        if found.price[0]:
            other = improved(candidate, FIRST_STEPS[level], keep_kernels=True)
            if other.price < found.price:
                found, kept = other, True
        first.append((found, kept))
    first.sort(key=lambda pair: pair[0].price)
    more = [
        improved(found, MORE_STEPS[level], keep_kernels=kept)
        for found, kept in first[: BEST[level]]
    ]
    best = min([*more, *(found for found, _ in first), *candidates], key=lambda p: p.price)
    return min(best, _balanced(best, problem, machine, level, priced), key=lambda p: p.price)


def _balanced(
    candidate: P, problem: Problem, machine: Machine, level: int, priced: Callable[[Solution], P]
) -> P:
    """The candidate with its largest boundary made smaller."""
    solution = candidate.solution
    others = list(candidate.words_per_boundary)
    for n, words in enumerate(words_at(solution, problem, machine, len(others) - 1)):
        others[n] -= words
    budget = Budget(FIRST_STEPS[level])
    return priced(balance(solution, problem, machine, budget, others))
