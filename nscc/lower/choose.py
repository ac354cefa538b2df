"""Which lowering a program gets: the one that fits, then the one that disturbs the light least."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from nscc.lower.lowered import Lowered, analog_writes, lower
from nscc.lower.plan import LOWERINGS, ExposurePlan, Lowering, Misfit, levels, plan_exposure
from nscc.program.model import Program

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


def rank(lowered: Lowered) -> tuple[bool, int, int, int]:
    """Fits; fewest analog writes on an open pixel; words a frame; largest boundary."""
    late, total, largest = lowered.price
    return late, lowered.analog_writes[1], total, largest


def choose(program: Program, wanted: LoweringOption, level: int, *, price_all: bool) -> Choice:
    """Lowers `program` as wanted; without `price_all`, only until no better choice can follow."""
    opens = levels(program)
    misfits: dict[Lowering, Misfit] = {}
    plans: list[tuple[tuple[int, int], ExposurePlan]] = []
    for name in LOWERINGS if wanted == "auto" else (wanted,):
        plan = plan_exposure(program, name, opens)
        if isinstance(plan, Misfit):
            misfits[name] = plan
        else:
            plans.append((analog_writes(program, plan), plan))
    plans.sort(key=lambda entry: (entry[0][1], LOWERINGS.index(entry[1].lowering)))
    tried: list[Lowered] = []
    for writes, plan in plans:
        if not price_all and any(t.fits and t.analog_writes[1] < writes[1] for t in tried):
            break
        result = lower(program, plan, level, opens, writes)
        if isinstance(result, Misfit):
            misfits[plan.lowering] = result
        else:
            tried.append(result)
    return Choice(tuple(sorted(tried, key=rank)), misfits)
