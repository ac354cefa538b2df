"""The improvement of solutions: steps are distributed over several, at each optimisation level."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter

from nscc.logic.cubes import Budget
from nscc.logic.improve.search import balance, improve, words_at
from nscc.logic.problem import Machine, Problem, Solution
from nscc.lower.lowered import Lowered

# Levels differ in steps, not in seconds, so the same input gives the same words everywhere. In each
# round, the first number of best solutions get the second number of steps each. In the first round
# all get some, because only then their order is known. 100,000 steps take about a second.
ROUNDS = {
    2: ((6, 8_000), (3, 10_000), (1, 30_000)),
    3: ((16, 60_000), (3, 1_000_000), (3, 1_000_000)),
}

_PRICE = attrgetter("price")


@dataclass
class Refinery:
    """Improvement at levels 2 and 3; `store_words` is the number of words that all kernels may
    take."""

    problem: Problem
    machine: Machine
    level: int
    priced: Callable[[Solution], Lowered]
    store_words: int

    def best(self, candidates: Sequence[Lowered]) -> Lowered:
        """Improve all candidates a little, and the best of them more; return the best result."""
        if len(self.problem.demands) > self.store_words:
            # Kernels must repeat to fit the store, and improvement makes equal segments different.
            return min(candidates, key=_PRICE)
        known, current = list(candidates), list(candidates)
        for count, steps in ROUNDS[self.level]:
            current = [self._improved(best, steps) for best in sorted(current, key=_PRICE)[:count]]
            known = [*current, *known]
        best = min(known, key=_PRICE)
        return min(best, self._balanced(best), key=_PRICE)

    def _improved(self, candidate: Lowered, steps: int) -> Lowered:
        # A further search repeats the random numbers of the one before, on its result.
        solution = improve(candidate.solution, self.problem, self.machine, Budget(steps))
        return self._form(solution)

    def _form(self, solution: Solution) -> Lowered:
        """Compute a solution's costs; if it does not fit, also with gates and analog words
        separated."""
        priced = self.priced(solution)
        return min(priced, self.priced(apart(solution)), key=_PRICE) if priced.price[0] else priced

    def _balanced(self, candidate: Lowered) -> Lowered:
        """Reduce the words of the candidate's largest boundary."""
        solution = candidate.solution
        other_words = list(candidate.words_per_boundary)
        gates = words_at(solution, self.problem, self.machine, len(other_words) - 1)
        other_words = [
            all_ - gate_words for all_, gate_words in zip(other_words, gates, strict=True)
        ]
        budget = Budget(ROUNDS[self.level][0][1])
        return self._form(balance(solution, self.problem, self.machine, budget, other_words))


def apart(solution: Solution) -> Solution:
    """Return the solution with gates separated from the segments before analog words.

    These segments are then equal in all slots and stored once."""
    answers = tuple((*answer, ()) if answer else answer for answer in solution.answers)
    return replace(solution, answers=answers)
