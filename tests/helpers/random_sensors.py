"""Programs, scenes, sensors and tolerances drawn at random, each beside the reference."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from plan_cases import CASES, case
from promise import SCENES, TOLERANCES, Outcome, full_frames, outcome, pool, scene
from reference_programs import sensor_of

from nscc.words.container import Container
from nscc_runtime.light import Light
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
    full = full_frames(container, light, sensor, pool(light))
    found = []
    for tolerance in rng.choice(TOLERANCES, 2, replace=False):
        each = outcome(container, light, sensor, float(tolerance), full)
        said = (
            f"seed {seed}: {program}, {slots} slots of {slot_us} us, {name}, {tolerance} e: "
            f"err {each.err:.4g}, predicted {each.plan.predicted_e:.4g}"
        )
        found.append(Draw(said, each))
    return found


def promises(seed: int, plans: int = 4, side: int = 48, frames: int = 6) -> list[Draw]:
    """A program on a scene of its own, at `plans` tolerances of every kind."""
    rng = np.random.default_rng([7, seed])
    program, slots = rng.choice(list(CASES)), int(rng.choice([4, 8, 16]))
    container = case(program, slots, f"{rng.choice([100, 500, 2000])}us", side, side)
    sensor = random_sensor(container, rng) if rng.random() < 0.4 else sensor_of(container)
    name, light = _any_scene(rng, slots, side, sensor.full_well_e)
    full = full_frames(container, light, sensor, frames)
    found = []
    for number in range(plans):
        tolerance = rng.choice(["0.1noise", "0.3noise", "1%", "0.05lsb", "5e", "50e"])
        if tolerance == "1%" and not light.total_e().any():
            tolerance = "5e"
        each = outcome(container, light, sensor, str(tolerance), full, figures=number % 2 == 0)
        said = (
            f"seed {seed}: {program}, {slots} slots, {name}, {tolerance}: "
            f"{each.err:.4g} e, {each.plan!r}"
        )
        found.append(Draw(said, each))
    return found


def _any_scene(rng: np.random.Generator, slots: int, side: int, full_e: float) -> tuple[str, Light]:
    """A scene by its name, dimmer or brighter; one at about a full well; or one with suns."""
    kind = rng.choice(["known", "known", "well", "suns"])
    name = str(rng.choice(list(SCENES)))
    frames = np.array(scene(name, slots, side, side).frames) * np.float32(10 ** rng.uniform(-1, 1))
    if kind == "well":
        frames[...] = full_e / slots * rng.uniform(0.97, 1.03)
        return "at a full well", Light.of_clip(frames)
    if kind == "suns":
        rows, cols = rng.integers(0, side, (2, 5))
        frames[:, rows, cols] = np.float32(full_e * 10 ** rng.uniform(0, 6))
    return f"{name}{', suns' if kind == 'suns' else ''}", Light.of_clip(frames)


def rare_pixels(seed: int, side: int = 256) -> Draw:
    """A plan for a dim scene with lamps, with pixels that flash once, with suns, or with a disk:
    few pixels have most of the error."""
    rng = np.random.default_rng([11, seed])
    program, slots = str(rng.choice(list(CASES))), int(rng.choice([4, 8, 16]))
    container = case(program, slots, f"{rng.choice([100, 500, 2000])}us", side, side)
    sensor, kind = sensor_of(container), str(rng.choice(["lamps", "flashes", "suns", "disk"]))
    name = str(rng.choice(["dim", "mid", "hdr"]))
    frames = np.array(scene(name, slots, side, side).frames)
    rows, cols = rng.integers(0, side, (2, int(rng.choice([1, 5, 60, 600]))))
    bright_e = np.float32(sensor.full_well_e * 10 ** rng.uniform(-1, 1))
    if kind == "lamps":
        frames[:, rows, cols] += bright_e / slots
    elif kind == "flashes":
        frames[rng.integers(0, slots, len(rows)), rows, cols] += bright_e
    elif kind == "suns":
        frames[:, rows[:5], cols[:5]] = bright_e * np.float32(10 ** rng.uniform(1, 6))
    else:
        y, x = np.mgrid[:side, :side]
        disk = (y - rows[0]) ** 2 + (x - cols[0]) ** 2 < rng.uniform(1, 12) ** 2
        frames[:, disk] += bright_e / slots
    tolerance = str(rng.choice(["0.1noise", "0.15noise", "5e", "50e"]))
    full = full_frames(container, Light.of_clip(frames), sensor, 2)
    found = outcome(
        container, Light.of_clip(frames), sensor, tolerance, full, figures=seed % 2 == 0
    )
    said = (
        f"seed {seed}: {program}, {slots} slots, {name} with {len(rows)} of {kind}, {tolerance}: "
        f"{found.err:.4g} e, {found.plan!r}"
    )
    return Draw(said, found)
