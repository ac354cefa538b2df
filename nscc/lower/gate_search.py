"""The search for the cheapest gates of one exposure plan: generators (methods that find gates),
then improvement of the best results.

Levels differ in steps, not in seconds, so the same input gives the same words everywhere."""

from __future__ import annotations

from dataclasses import dataclass
from operator import attrgetter

from nscc.cache.results import Results
from nscc.logic.cubes import Budget
from nscc.logic.generate import GeneratorFault, note_fault, solutions
from nscc.logic.problem import Machine, Problem, Solution
from nscc.lower.decoding import Before, Decoding
from nscc.lower.exposure_plan import ExposurePlan, Timeline
from nscc.lower.lowered import Lowered, lay_out
from nscc.program.program import Program

# Number of solutions to improve at each level, the best of each encoding.
MOST_IMPROVED = {0: 1, 1: 1, 2: 6, 3: 16}

# In each round, the first number of best solutions get the second number of steps each. In the
# first round all get some, because only then their order is known. 100,000 steps take about a
# second.
ROUNDS = {
    2: ((6, 8_000), (3, 10_000), (1, 30_000)),
    3: ((16, 60_000), (3, 1_000_000), (3, 1_000_000)),
}

_PRICE = attrgetter("price")


@dataclass
class GateSearch:
    """The search for gates that answer the demands (sets of shutters that FLAG must select at
    boundaries) of an exposure plan.

    `problem` has the demands, and `actions` say how each step of the plan obtains FLAG.
    `most_words` is the largest allowed number of words at a boundary (None: any). `faults` collects
    unexpected exceptions of generators (methods that find gates); with None they propagate."""

    program: Program
    plan: ExposurePlan
    time: Timeline
    problem: Problem
    actions: tuple[Before, ...]
    most_words: int | None
    faults: list[GeneratorFault] | None

    @property
    def machine(self) -> Machine:
        """The costs and limits of gates on the program's chip."""
        return Machine.of(self.program.target)

    def priced(self, solution: Solution) -> Lowered:
        """Lay out the words of a solution, which gives its costs. The caller ensures that it solves
        the problem; it may take too many words."""
        decoding = Decoding(self.plan, self.problem, self.actions, solution)
        return lay_out(self.program, decoding, self.time, self.most_words)

    def cheapest(self, level: int, results: Results | None) -> Lowered | None:
        """Return the cheapest solution of a level and the levels below, whether it fits or not;
        None if none was found.

        A known solution comes from `results` (None: none is known), where a new one is stored,
        except after a fault of a generator (a method that finds gates)."""
        if results is None or not self.problem.demands:
            return self._best(level)
        context = (self.plan, self.time, self.program.target, self.most_words)
        key, known = results.find(self.problem, self.machine, level, *context)
        if known is not None:
            return self.priced(known)
        best = self._best(level)
        if best is not None and not self.faults:
            results.keep(key, best.solution)
        return best

    def _best(self, level: int) -> Lowered | None:
        """Return the cheapest solution of a level and the levels below, whether it fits or not;
        None if none was found.

        More steps change where generators stop, so the result of a level is not always better than
        that of the level below. Level 0 is only searched if nothing fits, or if `level` is 0. A
        problem without demands needs one level only. A demand is a set of shutters that FLAG must
        select at a boundary. A generator is a method that finds gates."""
        known: list[Lowered] = []
        for searched in range(level, -1, -1):
            known += sorted(self._of_level(searched), key=_PRICE)[:1]
            fits = any(each.fits for each in known)
            if not self.problem.demands or (searched == 1 and fits):
                break
        # Refresh counts here, so that more effort never costs words.
        return min(
            known,
            key=lambda each: (each.price[:2], each.schedule.words_total, each.price),
            default=None,
        )

    def _of_level(self, level: int) -> list[Lowered]:
        """Return the best solutions of the generators (methods that find gates) at a level of
        optimisation, one for each encoding, cheapest first; at levels with ROUNDS, the improved
        best one before them. Empty if every generator gave up.

        If the improvement raises an exception, it is noted in `faults` (raised if that is None),
        and the unimproved solutions are returned."""
        by_encoding: dict[str, Lowered] = {}
        for solution in solutions(self.problem, self.machine, level, self.faults):
            candidate = self.priced(solution)
            rival = by_encoding.get(solution.encoding)
            if rival is None or candidate.price < rival.price:
                by_encoding[solution.encoding] = candidate
        ranked = sorted(by_encoding.values(), key=_PRICE)[: MOST_IMPROVED[level]]
        if level in ROUNDS and ranked and self.problem.demands:
            try:
                ranked.insert(0, self.improved_best(ranked, level))
            except Exception as error:
                note_fault(error, "improve", level, self.faults)
        return ranked

    def improved_best(self, candidates: list[Lowered], level: int) -> Lowered:
        """Improve all candidates a little, and the best of them more; return the best result.

        `candidates` are sorted by price, at least one. Solutions with masked gates stay as they
        are."""
        from nscc.logic.improve.search import balance, improve, words_at  # `check` does not need it

        current = [each for each in candidates if each.solution.masked_state() is None]
        known = [*candidates]
        for count, steps in ROUNDS[level]:
            # A further search repeats the random numbers of the one before, on its result.
            current = [
                self.priced(improve(each.solution, self.problem, self.machine, Budget(steps)))
                for each in sorted(current, key=_PRICE)[:count]
            ]
            known = [*current, *known]
        best = min(known, key=_PRICE)
        if best.solution.masked_state() is not None:
            return best
        # The words of the largest boundary are reduced last.
        gates = words_at(best.solution, self.problem, self.machine, self.plan.slots)
        analog = [a - b for a, b in zip(best.words_per_boundary, gates, strict=True)]
        budget = Budget(ROUNDS[level][0][1])
        balanced = balance(best.solution, self.problem, self.machine, budget, analog)
        return min(best, self.priced(balanced), key=_PRICE)
