"""The improvement of solutions: steps are distributed over several, at each optimisation level."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter

from nscc.logic.cubes import Budget
from nscc.logic.improve.balance import balance, words_at
from nscc.logic.improve.search import improve
from nscc.logic.problem import Machine, Problem, Solution
from nscc.lower.lowered import Lowered

# Levels differ in steps, not in seconds, so the same input gives the same words everywhere. First
# every solution gets this many steps, because only then their order is known.
FIRST_STEPS = {2: 8_000, 3: 60_000}
# Further steps for each of the best. A hundred thousand steps take about a second.
MORE_STEPS = {2: 60_000, 3: 2_000_000}
# With kernels kept, the first steps are multiplied by this.
KERNEL_SHARE = 4
# The share of the store for gates if segments have separate kernels; the rest is for analog words.
ROOM_SHARE = 0.75
BEST = {2: 1, 3: 3}
# If words do not fit, this many of the cheapest are also improved with kernels kept.
MOST_KEPT = 2


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

    def __post_init__(self) -> None:
        # With more demands than stored words, kernels must repeat: few distinct kernels matter more
        # than few words.
        self.scarce = len(self.problem.demands) > self.store_words
        self.room = 0 if self.scarce else int(self.store_words * ROOM_SHARE)

    def best(self, candidates: Sequence[Lowered]) -> Lowered:
        """Improve all candidates a little, and the best of them more; return the best result."""
        steps = FIRST_STEPS[self.level]
        first = [self._first(c, steps, i < MOST_KEPT) for i, c in enumerate(candidates)]
        first.sort(key=lambda pair: pair[0].price)
        refined = [
            self._improve_further(improved, keep_kernels)
            for improved, keep_kernels in first[: BEST[self.level]]
        ]
        best = min([*refined, *(improved for improved, _ in first), *candidates], key=_PRICE)
        return best if self.scarce else min(best, self._balanced(best), key=_PRICE)

    def _first(self, candidate: Lowered, steps: int, patient: bool) -> tuple[Lowered, bool]:
        """Return the improved candidate, and whether equal segments had to stay equal.

        Unless `patient`, segments may differ, and a result that does not fit is given up."""
        if self.scarce:
            return self._improve_keeping_kernels(candidate.solution, steps), True
        improved = self._form(self._improved(candidate.solution, steps))
        if improved.price[0] and patient:
            # After free rewriting, segments rarely share kernels.
            with_kernels = self._improve_keeping_kernels(candidate.solution, KERNEL_SHARE * steps)
            if with_kernels.price < improved.price:
                return with_kernels, True
        return improved, False

    def _improve_further(self, candidate: Lowered, keep_kernels: bool) -> Lowered:
        steps = MORE_STEPS[self.level]
        if keep_kernels:
            return self._improve_keeping_kernels(candidate.solution, steps)
        # The second search repeats the random numbers of the first, on its result.
        once = self._improved(candidate.solution, steps // 2)
        return self._form(self._improved(once, steps // 2))

    def _improved(self, solution: Solution, steps: int) -> Solution:
        return improve(solution, self.problem, self.machine, Budget(steps))

    def _improve_keeping_kernels(self, solution: Solution, steps: int) -> Lowered:
        """Improve a solution so that equal segments stay equal, with and without room for more
        segments."""
        priced_solutions = []
        for room in sorted({self.room, 0}, reverse=True):
            budget = Budget(steps)
            shorter = improve(
                solution, self.problem, self.machine, budget, keep_kernels=True, room=room
            )
            priced_solutions.append(self._form(shorter))
            if not priced_solutions[-1].price[0]:
                break
        return min(priced_solutions, key=_PRICE)

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
