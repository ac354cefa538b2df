"""Which lowering a program gets: the one that fits, then the one that disturbs the light least."""

from __future__ import annotations

from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from typing import Literal

from nscc.cache.results import Results
from nscc.lower.lowered import Lowered, analog_writes, lower
from nscc.lower.plan import LOWERINGS, ExposurePlan, Lowering, Misfit, levels, plan_exposure
from nscc.program.program import Program

LoweringOption = Lowering | Literal["auto"]


@dataclass(frozen=True)
class Choice:
    """The lowerings that were tried, best first, and why others are none."""

    tried: tuple[Lowered, ...]
    misfits: dict[Lowering, Misfit]

    @property
    def best(self) -> Lowered | None:
        """The best lowering, whether it fits or not; None if there is none at all."""
        return self.tried[0] if self.tried else None


def rank(lowered: Lowered) -> tuple[bool, float, int, int, int]:
    """Fits, or how far from it; fewest analog writes on an open pixel; words; largest boundary."""
    misfit, overload, *_ = lowered.price
    total, largest = lowered.schedule.words_total, max(lowered.words_per_boundary)
    return misfit, overload, lowered.analog_writes[1], total, largest


def choose(
    program: Program,
    wanted: LoweringOption,
    level: int,
    *,
    price_all: bool,
    results: Results | None = None,
    most_words: int | None = None,
) -> Choice:
    """Lowers `program` as wanted; without `price_all`, only until no better choice can follow.

    `most_words` is the most that a boundary may have, None for any number. Lowerings wait in the
    order of their analog writes, or of a bound until they are planned.
    """
    opens = levels(program)
    misfits: dict[Lowering, Misfit] = {}
    tried: list[Lowered] = []
    plans: dict[Lowering, tuple[ExposurePlan, tuple[int, int]]] = {}
    waiting = [
        (_fewest_writes(program, name), LOWERINGS.index(name), name)
        for name in (LOWERINGS if wanted == "auto" else (wanted,))
    ]
    heapify(waiting)
    while waiting:
        writes, order, name = heappop(waiting)
        if not price_all and any(t.fits and t.analog_writes[1] < writes for t in tried):
            break
        if name not in plans:
            plan = plan_exposure(program, name, opens)
            if isinstance(plan, Misfit):
                misfits[name] = plan
            else:
                plans[name] = plan, analog_writes(program, plan)
                heappush(waiting, (plans[name][1][1], order, name))
            continue
        result = lower(program, plans[name][0], level, opens, plans[name][1], results, most_words)
        if isinstance(result, Misfit):
            misfits[name] = result
        else:
            tried.append(result)
    in_order = {name: misfits[name] for name in LOWERINGS if name in misfits}
    return Choice(tuple(sorted(tried, key=rank)), in_order)


def _fewest_writes(program: Program, lowering: Lowering) -> int:
    """A bound, found without a plan, on the most analog words that a pixel executes."""
    if lowering == "accumulate":
        return 2 * int(program.table.shutters.sum(axis=(1, 2)).max(initial=0))
    return 0
