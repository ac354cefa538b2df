"""Search for the gates of a program's plans, with their costs after layout.

The steps of improvement are distributed over several solutions, at each optimisation level."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter

from nscc.cache.results import Result, Results
from nscc.logic.cubes import Budget
from nscc.logic.generate import GeneratorFault, note_fault, solutions
from nscc.logic.improve.balance import balance, words_at
from nscc.logic.improve.enrich import enrich
from nscc.logic.improve.search import improve
from nscc.logic.problem import Machine, Problem, Solution
from nscc.lower.decoding import Decoding, problem_of
from nscc.lower.exposure_plan import LOWERINGS, ExposurePlan, Lowering, Misfit, Planned
from nscc.lower.lowered import Lowered, lay_out
from nscc.lower.timeline import Timeline
from nscc.program.program import Program

# Levels differ in steps, not in seconds, so the same input gives the same words everywhere. First
# every solution gets this many steps, because only then their order is known.
FIRST_STEPS = {2: 8_000, 3: 60_000}
# Further steps for each of the best. A hundred thousand steps take about a second.
MORE_STEPS = {2: 60_000, 3: 2_000_000}
ENRICH_STEPS = {2: 20_000, 3: 400_000}
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
        solution = self._improved(candidate.solution, steps // 2)
        budget = Budget(ENRICH_STEPS[self.level])
        richer = enrich(solution, self.problem, self.machine, budget)
        return self._form(self._improved(richer, steps // 2))

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


# Number of solutions to improve at each level, the best of each encoding.
MOST_IMPROVED = {0: 1, 1: 1, 2: 6, 3: 16}


@dataclass(frozen=True)
class Gated:
    """The plans with gates, best first, and why others have none.

    `fits` says whether the words of the best plan fit. `faults` are exceptions of generators, which
    were ignored."""

    program: Program
    time: Timeline
    decodings: tuple[Decoding, ...]
    misfits: dict[Lowering, Misfit]
    fits: bool
    faults: tuple[GeneratorFault, ...] = ()


def find_gates(
    planned: Planned,
    level: int,
    *,
    price_all: bool = False,
    results: Results | None = None,
    most_words: int | None = None,
) -> Gated:
    """Return the gates of all plans; without `price_all`, stop when no better plan can follow.

    `most_words` is the largest allowed number of words at a boundary, None for any."""
    lowerings: list[Lowered] = []
    misfits = dict(planned.misfits)
    faults: list[GeneratorFault] = []
    for plan in planned.plans:
        writes = plan.analog_writes[1]
        if not price_all and any(t.fits and t.plan.analog_writes[1] < writes for t in lowerings):
            break
        outcome = lower(planned, plan, level, results, most_words, faults)
        if isinstance(outcome, Misfit):
            misfits[plan.lowering] = outcome
        else:
            lowerings.append(outcome)
    # Best first: fits, or distance from fitting; analog writes of an open pixel; words; peak.
    lowerings.sort(
        key=lambda lowered: (
            *lowered.price[:2], lowered.plan.analog_writes[1], lowered.schedule.words_total,
            max(lowered.words_per_boundary),
        )
    )  # fmt: skip
    return Gated(
        planned.program,
        planned.time,
        tuple(lowered.decoding for lowered in lowerings),
        {name: misfits[name] for name in LOWERINGS if name in misfits},
        bool(lowerings) and lowerings[0].fits,
        tuple(faults),
    )


def lower(
    planned: Planned,
    plan: ExposurePlan,
    level: int,
    results: Results | None = None,
    most_words: int | None = None,
    faults: list[GeneratorFault] | None = None,
) -> Lowered | Misfit:
    """Return the cheapest solution of a plan, whether it fits or not; a Misfit if none was found.

    `most_words` is as in Lowered. Levels 2 and 3 improve the best solutions. The solution of a
    level is never more expensive than that of the level below, or than another solution of this
    level. Known solutions come from `results`. `faults` is as in `nscc.logic.generate.solutions`.
    """
    program, target, time = planned.program, planned.program.target, planned.time
    if most_words is not None and level >= 2:
        # Improvement needs fitting solutions as input; a limit that only the final solution meets
        # would exclude them.
        free = lower(planned, plan, level, results, None, faults)
        if isinstance(free, Misfit):
            return free
        unlimited = lay_out(program, free.decoding, time, most_words)
        if not unlimited.overfull:
            return unlimited
    problem, actions = problem_of(program, plan, time, planned.opens)
    machine = Machine.of(target)

    def priced(solution: Solution) -> Lowered:
        return lay_out(program, Decoding(plan, problem, actions, solution), time, most_words)

    def cheapest(level: int) -> Lowered | None:
        known = Result()
        if results is not None:
            known = results.find(problem, machine, level, plan, time, target, most_words)
        by_encoding: dict[str, Lowered] = {}
        for solution in known.or_else(solutions(problem, machine, level, faults)):
            candidate = priced(solution)
            rival = by_encoding.get(solution.encoding)
            if rival is None or candidate.price < rival.price:
                by_encoding[solution.encoding] = candidate
        ranked = sorted(by_encoding.values(), key=lambda lowered: lowered.price)[
            : MOST_IMPROVED[level]
        ]
        searched = known.known is None and bool(problem.demands)
        if level >= 2 and searched and ranked:
            from nscc.lower.gates import Refinery  # imports networkx, which `check` does not need

            refinery = Refinery(problem, machine, level, priced, target.store_words)
            try:
                ranked.insert(0, refinery.best(ranked))
            except Exception as error:
                note_fault(error, "improve", level, faults)
        if level > 0 and searched and (level > 1 or not ranked or not ranked[0].fits):
            # More steps change where generators stop, so the result is not always better.
            below = cheapest(level - 1)
            if below is not None:
                ranked.append(below)
        if not ranked:
            return None
        best = min(ranked, key=lambda lowered: lowered.price)
        if level >= 2 and searched and not faults:
            known.keep(best.solution)
        return best

    cheapest_lowered = cheapest(level)
    if cheapest_lowered is None:
        registers = len(target.digital_registers)
        return Misfit(f"no generator found gates with {registers} digital registers", searched=True)
    return cheapest_lowered
