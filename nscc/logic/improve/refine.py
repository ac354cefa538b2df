"""Which of several solutions are worth how many steps of improvement, at each level of effort."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

from nscc.logic.cubes import Budget
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


def refine[P: Priced](
    candidates: Sequence[P],
    problem: Problem,
    machine: Machine,
    level: int,
    priced: Callable[[Solution], P],
) -> P:
    """The best candidate, or the best that improvement makes of one; levels 2 and 3."""

    def shorter(candidate: P, steps: int) -> P:
        return priced(improve(candidate.solution, problem, machine, Budget(steps)))

    def alike(candidate: P, steps: int) -> P:
        budget = Budget(steps)
        return priced(
            improve(candidate.solution, problem, machine, budget, keep_kernels=True)
        )  # fmt: skip

    first = []
    for candidate in candidates:
        found = shorter(candidate, FIRST_STEPS[level])
        if found.price[0]:
            # Rewritten apart, its segments take more store than there is.
            found = min(found, alike(candidate, FIRST_STEPS[level]), key=lambda p: p.price)
        first.append(found)
    first.sort(key=lambda p: p.price)
    more = [shorter(found, MORE_STEPS[level]) for found in first[: BEST[level]]]
    return min([*more, *first, *candidates], key=lambda p: p.price)
