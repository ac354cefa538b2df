"""Programs, scenes and sensors drawn at random, each beside the reference."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from plan_cases import CASES, case
from promise import SCENES, TOLERANCES, Outcome, full_frames, outcome, pool, scene
from reference_programs import sensor_of

from nscc.words.container import Container
from nscc_runtime.sensor import Sensor, parameters

ROWS = COLS = 64
_ZERO = 0.15
"""How often a parameter that may be 0 is."""


@dataclass(frozen=True)
class Draw:
    """One setting; `said` names it."""

    said: str
    found: Outcome


def random_sensor(container: Container, rng: np.random.Generator) -> Sensor:
    """Every figure but the readout's a tenth to ten times its default, or 0."""
    base, values = sensor_of(container), {}
    for row in parameters():
        if row.heading == "readout" or row.name == "digital_retention_us":
            continue
        default, zero, factor = getattr(base, row.name), rng.random(), 10 ** rng.uniform(-1, 1)
        value = 1 + (default - 1) * factor if row.name == "analog_gain" else default * factor
        if zero < _ZERO and row.kind.low == 0 and not row.kind.low_excluded:
            value = 0.0
        values[row.name] = min(max(value, row.kind.low), row.kind.high)
    return base.changed(**values)


def draws(seed: int) -> list[Draw]:
    """A program, a scene and a sensor, at two tolerances."""
    rng = np.random.default_rng(seed)
    program, name = rng.choice(list(CASES)), rng.choice(list(SCENES))
    slots, slot_us = int(rng.choice([4, 8, 16])), int(rng.choice([100, 500, 2000]))
    container = case(program, slots, f"{slot_us}us", ROWS, COLS)
    sensor, light = random_sensor(container, rng), scene(name, slots, ROWS, COLS)
    full = full_frames(container, light, sensor, pool(light), 3, 5)
    found = []
    for tolerance in rng.choice(TOLERANCES, 2, replace=False):
        each = outcome(container, light, sensor, float(tolerance), full)
        said = (
            f"seed {seed}: {program}, {slots} slots of {slot_us} us, {name}, {tolerance} e: "
            f"err {each.err:.4g}, predicted {each.plan.predicted_e:.4g}"
        )
        found.append(Draw(said, each))
    return found
