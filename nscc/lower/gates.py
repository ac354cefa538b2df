"""Search for the gates of a program's plans, with their costs after layout."""

from __future__ import annotations

from nscc.cache.results import Results
from nscc.logic.generate import GeneratorFault, note_fault, solutions
from nscc.logic.problem import Machine, Solution
from nscc.lower.decoding import Decoding, problem_of
from nscc.lower.exposure_plan import LOWERINGS, ExposurePlan, Lowering, Misfit, Planned, Timeline
from nscc.lower.lowered import Lowered, lay_out
from nscc.program.program import Program
from nscc.record import Record

# Number of solutions to improve at each level, the best of each encoding.
MOST_IMPROVED = {0: 1, 1: 1, 2: 6, 3: 16}


class Gated(Record):
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
        key: str = ""
        known: Solution | None = None
        if results is not None:
            key, known = results.find(problem, machine, level, plan, time, target, most_words)
        by_encoding: dict[str, Lowered] = {}
        for solution in solutions(problem, machine, level, faults) if known is None else (known,):
            candidate = priced(solution)
            rival = by_encoding.get(solution.encoding)
            if rival is None or candidate.price < rival.price:
                by_encoding[solution.encoding] = candidate
        ranked = sorted(by_encoding.values(), key=lambda lowered: lowered.price)[
            : MOST_IMPROVED[level]
        ]
        searched = known is None and bool(problem.demands)
        if level >= 2 and searched and ranked:
            from nscc.lower.refinery import Refinery  # `check` does not need it

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
        if results is not None and searched and not faults:
            results.keep(key, best.solution)
        return best

    cheapest_lowered = cheapest(level)
    if cheapest_lowered is None:
        registers = len(target.digital_registers)
        return Misfit(f"no generator found gates with {registers} digital registers", searched=True)
    return cheapest_lowered
