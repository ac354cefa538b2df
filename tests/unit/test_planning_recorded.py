"""Plans of programs of every kind, with all their figures, as recorded in tests/data/plans.

Other tests say whether a plan keeps its promise; these notice a plan that is another one.
`pytest --update-cases` records them again.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass

import pytest
from plan_cases import case, moving_light
from recorded import compare_with_recorded
from reference_programs import program, sensor_of

from nscc.words.container import Container
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.planning.make import MANY, PlanRequest, make_plan
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.scenes import planning_of

SLOTS = 8
LOOKS = """nsl 2
frame {slots} slots of 1ms
sense bright when light > 45% at n in [1, 4]
state closed : 0..2 = 0
next closed = looks when bright and closed == 0
open when closed == 0
read closed
"""


@dataclass(frozen=True)
class PlannedRun:
    """A program, the electrons that its light brings in a slot, and the request for a plan."""

    case: str
    electrons: float
    tolerance: str | float = 5.0
    effects: str = "auto"
    frames: int = MANY
    slot: str = "500us"
    shape: tuple[int, int] = (32, 48)

    def plan(self) -> Plan:
        if self.case == "looks":
            container: Container = program(LOOKS.format(slots=SLOTS), "auto", *self.shape)
        else:
            container = case(self.case, SLOTS, self.slot, *self.shape)
        light: Light = moving_light((SLOTS, *self.shape), self.electrons)
        scene = planning_of(container, sensor_of(container), light, 5, threads=1)
        request = PlanRequest(
            selected(self.effects), self.tolerance, self.frames, figures=self.frames == MANY
        )
        return make_plan(scene, request)


RUNS: Mapping[str, PlannedRun] = {
    "dim": PlannedRun("b edges", 400.0),
    "no tolerance to speak of": PlannedRun("b accumulate", 400.0, 0.01),
    "much tolerance": PlannedRun("b latch", 400.0, "20%"),
    "slow": PlannedRun("a", 900.0, 2.0, slot="50ms"),
    "close to full": PlannedRun("d edges", 2500.0, 30.0),
    "saturated": PlannedRun("c edges", 9000.0, "1%"),
    "books": PlannedRun("codebook", 700.0, "1noise"),
    "two buckets": PlannedRun("two buckets", 1500.0, "2lsb"),
    "late": PlannedRun("late", 700.0, 5.0, effects="shot,dark,lag,read,adc"),
    "one frame": PlannedRun("d accumulate", 700.0, frames=1),
    "a sample of the array": PlannedRun("d edges", 2500.0, 30.0, shape=(192, 256)),
    "looks": PlannedRun("looks", 2500.0, 20.0),
    "looks of a sample": PlannedRun("looks", 2500.0, 20.0, shape=(192, 256)),
    "looks of few effects": PlannedRun("looks", 2500.0, 20.0, effects="shot,comparator_noise,adc"),
}


@pytest.mark.parametrize("name", RUNS)
def test_plan(name: str, update_cases: bool) -> None:
    plan = RUNS[name].plan()
    compare_with_recorded(figures_of(plan), f"plans/{name.replace(' ', '_')}", update_cases)
    assert Plan.from_json(plan.as_json()) == plan


def figures_of(plan: Plan) -> str:
    """The table of a plan, and its figures with more digits."""
    lines = [str(plan)]
    for key, value in plan.as_json().items():
        if key == "effects":
            lines += [
                " ".join(
                    [effect["name"], *(f"{v:.6g}" for v in effect.values() if isinstance(v, float))]
                )
                for effect in value
            ]
        else:
            lines.append(f"{key} {json.dumps(value)}")
    return "\n".join(lines) + "\n"
