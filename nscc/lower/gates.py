"""Gates for the plans of a program: searched for, priced by laying them out, the best first."""

from __future__ import annotations

from dataclasses import dataclass

from nscc.cache.results import Result, Results
from nscc.logic.generate import GeneratorFault, note_fault, solutions
from nscc.logic.problem import Machine, Solution
from nscc.lower.decoding import Decoding, problem_of
from nscc.lower.lowered import Lowered, lay_out
from nscc.lower.plan import LOWERINGS, ExposurePlan, Lowering, Misfit, Planned
from nscc.lower.timeline import Timeline
from nscc.program.program import Program

# Solutions, the best of each encoding, that are worth steps of improvement at each level.
MOST_IMPROVED = {0: 1, 1: 1, 2: 6, 3: 16}


@dataclass(frozen=True)
class Gated:
    """The plans for which gates were searched for and found, best first, and why others are none.

    `fits`: whether the words of the best one do. `faults`: exceptions of generators, which were
    left out.
    """

    program: Program
    time: Timeline
    tried: tuple[Decoding, ...]
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
    """The gates of `planned`; without `price_all`, of its plans until no better one can follow.

    `most_words` is the most that a boundary may have, None for any number.
    """
    tried: list[Lowered] = []
    misfits = dict(planned.misfits)
    faults: list[GeneratorFault] = []
    for plan in planned.plans:
        writes = plan.analog_writes[1]
        if not price_all and any(t.fits and t.plan.analog_writes[1] < writes for t in tried):
            break
        found = lower(planned, plan, level, results, most_words, faults)
        if isinstance(found, Misfit):
            misfits[plan.lowering] = found
        else:
            tried.append(found)
    tried.sort(key=_rank)
    return Gated(
        planned.program,
        planned.time,
        tuple(lowered.decoding for lowered in tried),
        {name: misfits[name] for name in LOWERINGS if name in misfits},
        bool(tried) and tried[0].fits,
        tuple(faults),
    )


def _rank(lowered: Lowered) -> tuple[bool, float, int, int, int]:
    """Fits, or how far from it; fewest analog writes on an open pixel; words; largest boundary."""
    misfit, overload, *_ = lowered.price
    total, largest = lowered.schedule.words_total, max(lowered.words_per_boundary)
    return misfit, overload, lowered.plan.analog_writes[1], total, largest


def lower(
    planned: Planned,
    plan: ExposurePlan,
    level: int,
    results: Results | None = None,
    most_words: int | None = None,
    faults: list[GeneratorFault] | None = None,
) -> Lowered | Misfit:
    """The cheapest solution of a plan, whether it fits or not; a Misfit where none was found.

    `most_words` as in Lowered. Levels 2 and 3 improve the best solutions. No level's solution is
    dearer than that of the level below, or than another one that the level finds. What is already
    known comes from `results`. `faults` as in `nscc.logic.generate.solutions`.
    """
    program, target, time = planned.program, planned.program.target, planned.time
    if most_words is not None and level >= 2:
        # Improving starts from what fits: a limit that the cheapest solution meets in the end might
        # leave out what that is made from.
        free = lower(planned, plan, level, results, None, faults)
        if isinstance(free, Misfit):
            return free
        kept = lay_out(program, free.decoding, time, most_words)
        if not kept.overfull:
            return kept
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
            other = by_encoding.get(solution.encoding)
            if other is None or candidate.price < other.price:
                by_encoding[solution.encoding] = candidate
        found = sorted(by_encoding.values(), key=lambda each: each.price)[: MOST_IMPROVED[level]]
        searched = known.known is None and bool(problem.demands)
        if level >= 2 and searched and found:
            from nscc.logic.improve import refine  # with networkx, which `check` does without

            try:
                best = refine(found, problem, machine, level, priced, target.store_words)
                found.insert(0, best)
            except Exception as error:
                note_fault(error, "improve", level, faults)
        if level > 0 and searched and (level > 1 or not found or not found[0].fits):
            # More steps end some generators elsewhere and leave out others: not always better.
            below = cheapest(level - 1)
            if below is not None:
                found.append(below)
        if not found:
            return None
        best = min(found, key=lambda each: each.price)
        if level >= 2 and searched and not faults:
            known.keep(best.solution)
        return best

    found = cheapest(level)
    if found is None:
        registers = len(target.digital_registers)
        return Misfit(f"no generator found gates in {registers} digital registers", searched=True)
    return found
