"""The improvement of solutions: steps are distributed over several, at each optimisation level."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter

from nscc.logic.cubes import Budget
from nscc.logic.improve.search import balance, improve, words_at
from nscc.logic.problem import Machine, Problem, Solution
from nscc.lower.lowered import Lowered

# Levels differ in steps, not in seconds, so the same input gives the same words everywhere. First
# every solution gets this many steps, because only then their order is known.
FIRST_STEPS = {2: 8_000, 3: 60_000}
# Further steps for each of the best. A hundred thousand steps take about a second.
MORE_STEPS = {2: 60_000, 3: 2_000_000}
BEST = {2: 1, 3: 3}


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
        steps = FIRST_STEPS[self.level]
        first = [self._form(self._improved(c.solution, steps)) for c in candidates]
        first.sort(key=_PRICE)
        refined = [self._improve_further(improved) for improved in first[: BEST[self.level]]]
        best = min([*refined, *first, *candidates], key=_PRICE)
        return min(best, self._balanced(best), key=_PRICE)

    def _improve_further(self, candidate: Lowered) -> Lowered:
        steps = MORE_STEPS[self.level] // 2
        # The second search repeats the random numbers of the first, on its result.
        once = self._improved(candidate.solution, steps)
        return self._form(self._improved(once, steps))

    def _improved(self, solution: Solution, steps: int) -> Solution:
        return improve(solution, self.problem, self.machine, Budget(steps))

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
        budget = Budget(FIRST_STEPS[self.level])
        return self._form(balance(solution, self.problem, self.machine, budget, other_words))


def apart(solution: Solution) -> Solution:
    """Return the solution with gates separated from the segments before analog words.

    These segments are then equal in all slots and stored once."""
    answers = tuple((*answer, ()) if answer else answer for answer in solution.answers)
    return replace(solution, answers=answers)
