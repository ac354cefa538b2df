"""Search for the gates of a program's exposure plans: the best gates of each, and their order."""

from __future__ import annotations

from dataclasses import replace
from math import inf

from nscc.cache.results import Results
from nscc.logic.generate import GeneratorFault
from nscc.lower.decoding import Decoding, problem_of
from nscc.lower.exposure_plan import LOWERINGS, ExposurePlan, Lowering, Misfit, Planned, Timeline
from nscc.lower.gate_search import ROUNDS, GateSearch
from nscc.lower.lowered import Lowered
from nscc.program.program import Program
from nscc.record import Record

# A plan with more words a slot is compared with plans of more analog writes. It loses to one with
# so many times fewer words, if the rule of that one is composed, or if it has at most so many times
# more writes.
_MOST_WORDS_A_SLOT = 14
_DEAR = 1.25
_MANY_WRITES = 1.5


class Gated(Record):
    """The exposure plans with gates, best first (`decodings`, empty if no plan has gates), and why
    other plans have none (`misfits`).

    `fits` says whether the words of the best plan fit. `faults` are exceptions of generators
    (methods that find gates), which were left out."""

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
    """Return the gates of all exposure plans of `planned`; without `price_all`, stop when no better
    plan can follow.

    `level` is the optimisation level, 0 to 3. A plan with fewer analog writes is better, except if
    it takes far more words than a composed rule, or than one with little more writes. Known
    solutions are read from `results`, and new ones stored there (None: neither). `most_words` is
    the largest allowed number of words at a boundary, None for any. Plans without gates are in
    `misfits`. Raises Rejected (NS0905) for an invalid generator (a method that finds gates) of
    another package."""
    lowerings: list[Lowered] = []
    misfits = dict(planned.misfits)
    faults: list[GeneratorFault] = []
    for plan in planned.plans:
        writes = plan.analog_writes[1]
        better = [t for t in lowerings if t.fits and t.plan.analog_writes[1] < writes]
        if better and not price_all:
            slots = plan.slots * len(planned.opens)
            words = min(t.schedule.words_total for t in better)
            if words <= _MOST_WORDS_A_SLOT * slots or not _may_win(planned, plan):
                break
        outcome = lower(planned, plan, level, results, most_words, faults)
        if isinstance(outcome, Misfit):
            misfits[plan.lowering] = outcome
        else:
            lowerings.append(outcome)
    least = min(
        (t.schedule.words_total for t in lowerings if t.fits and _may_win(planned, t.plan)),
        default=inf,
    )
    # Best first: fits, or distance from fitting; far more words than a composed rule; analog writes
    # of an open pixel; words; peak.
    lowerings.sort(
        key=lambda lowered: (
            *lowered.price[:2],
            lowered.schedule.words_total > _DEAR * least,
            lowered.plan.analog_writes[1],
            lowered.schedule.words_total,
            max(lowered.words_per_boundary),
        )
    )
    return Gated(
        planned.program,
        planned.time,
        decodings=tuple(lowered.decoding for lowered in lowerings),
        misfits={name: misfits[name] for name in LOWERINGS if name in misfits},
        fits=bool(lowerings) and lowerings[0].fits,
        faults=tuple(faults),
    )


def _may_win(planned: Planned, plan: ExposurePlan) -> bool:
    """Return whether a solution with few words may make up for the analog writes of `plan`, one of
    the exposure plans of `planned`.

    That is true if its writes are at most _MANY_WRITES times the fewest. It is also true if its
    demands are those of a rule composed of parts, which needs few gates. A demand is a set of
    shutters that FLAG must select at a boundary."""
    if plan.analog_writes[1] <= _MANY_WRITES * planned.plans[0].analog_writes[1]:
        return True
    from nscc.logic.rule_parts import composition  # few programs need it

    problem, _ = problem_of(planned.program, plan, planned.time, planned.opens)
    return composition(problem) is not None


def lower(
    planned: Planned,
    plan: ExposurePlan,
    level: int,
    results: Results | None = None,
    most_words: int | None = None,
    faults: list[GeneratorFault] | None = None,
) -> Lowered | Misfit:
    """Return the cheapest gates of an exposure plan with their words, whether they fit or not; a
    Misfit if no gates were found.

    `most_words` is as in `Lowered`. Levels 2 and 3 improve the best solutions. The solution of a
    level is never more expensive than that of the level below, or than another solution of this
    level. Known solutions come from `results`, where new ones are stored, except after a fault of a
    generator (a method that finds gates). `faults` is as in `nscc.logic.generate.solutions`: None
    lets unexpected exceptions propagate."""
    program = planned.program
    problem, actions = problem_of(program, plan, planned.time, planned.opens)
    search = GateSearch(program, plan, planned.time, problem, actions, most_words, faults)
    # Improvement needs fitting solutions as input; a limit that only the final solution meets would
    # exclude them. So the search is first without the limit.
    if most_words is None or level not in ROUNDS:
        best = search.cheapest(level, results)
    else:
        best = replace(search, most_words=None).cheapest(level, results)
        if best is not None and replace(best, most_words=most_words).overfull:
            best = search.cheapest(level, results)
    if best is None:
        count = len(program.target.digital_registers)
        return Misfit(f"no generator found gates with {count} digital registers", searched=True)
    return best
