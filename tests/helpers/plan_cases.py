"""Programs, scenes and plans for tests of execution and planning."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from reference_programs import program

from nscc.words.container import Container
from nscc_runtime.effects import registered, selected
from nscc_runtime.light import Light
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import Decision, Plan, PlanRequest
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.sensor import Sensor

ANY_STOP = """nsl 1
frame {slots} slots of {slot}
code stop : 1..N
open when n < stop
pixels stop = 1 + (5 * x + 3 * y) % N
"""
"""Class b."""

WHOLE = """nsl 1
frame {slots} slots of {slot}
open when true
"""
"""Class a: every shutter is open all the time."""

BUMP = """nsl 1
frame {slots} slots of {slot}
let len = N / 4
code start : 0..N - len
open when start <= n < start + len
pixels start = (3 * x + 5 * y) % (N - len + 1)
"""
"""Class c."""

ANY_BUMP = """nsl 1
frame {slots} slots of {slot}
code start : 0..N - 1
code stop : 1..N
require start < stop
open when start <= n < stop
pixels start = (3 * x + y) % (N / 2)
pixels stop = N / 2 + 1 + (x + 2 * y) % (N / 2)
"""
"""Class d."""

BOOK = """nsl 1
frame {slots} slots of {slot}
shutters book [{rows[0]}, {rows[1]}, {rows[2]}, {rows[3]}]
code id : row of book
open when book[id]
pixels id = tile [[0, 1], [2, 3]]
"""

TWO_BUCKETS = """nsl 1
frame {slots} slots of {slot}
let period = N / 2
code phase : 0..period - 1
bucket even open when (n + phase) % period < period / 2
bucket odd open when (n + phase) % period >= period / 2
pixels phase = (x + 2 * y) % period
"""

LATE = """nsl 1
frame {slots} slots of {slot}
let first = N / 4
let end = 3 * N / 4
open when first <= n < end
"""
"""Class a: every shutter is shut when the frame begins, and when it ends."""

CASES: Mapping[str, tuple[str, str]] = {
    "a": (WHOLE, "auto"),
    "b edges": (ANY_STOP, "edges"),
    "b accumulate": (ANY_STOP, "accumulate"),
    "b latch": (ANY_STOP, "latch"),
    "c edges": (BUMP, "edges"),
    "c accumulate": (BUMP, "accumulate"),
    "d edges": (ANY_BUMP, "edges"),
    "d accumulate": (ANY_BUMP, "accumulate"),
    "codebook": (BOOK, "auto"),
    "two buckets": (TWO_BUCKETS, "auto"),
}
"""Text and lowering of a program of every kind."""
RARER: Mapping[str, tuple[str, str]] = {"late": (LATE, "auto")}
"""Others, which programs at random do not draw."""


def case(
    name: str, slots: int = 8, slot: str = "500us", rows: int = 12, cols: int = 16
) -> Container:
    """The compiled program of `CASES` or `RARER` on a small SCAMP-5; `slots` a multiple of 4."""
    text, lowering = {**CASES, **RARER}[name]
    shown = text.format(slots=slots, slot=slot, rows=book_rows(slots))
    return program(shown, lowering, rows, cols)


def book_rows(slots: int) -> list[str]:
    """The shutters of `BOOK`."""
    made = np.random.default_rng(7).integers(0, 2, (4, slots))
    return ["".join(map(str, row)) for row in made]


def moving_light(
    shape: tuple[int, int, int], electrons: float, seed: int = 1, zeros: bool = True
) -> Light:
    """Light (N, rows, cols) about so strong in each slot; a tenth of it dark."""
    rng = np.random.default_rng(seed)
    frames = (electrons * rng.exponential(1.0, shape)).astype(np.float32)
    if zeros:
        frames[rng.random(shape) < 0.1] = 0.0
    return Light.of_clip(frames)


def plan_of(effects: str, tolerance_e: float = 5.0, **values: Any) -> Plan:
    """A plan that keeps exactly these effects, all forced."""
    on = selected(effects)
    decisions = tuple(
        Decision(
            effect.name,
            effect.kind,
            "kept" if effect in on else "dropped",
            not effect.always,
            "",
            0.0,
            0.0,
            0.0,
            0.0,
        )
        for effect in registered()
    )
    plan = Plan(
        tolerance=f"{tolerance_e:g}e",
        tolerance_e=tolerance_e,
        predicted_e=0.0,
        bound_e=0.0,
        worst_e=0.0,
        slot_loop=False,
        slot_loop_reasons=(),
        sampled_fraction=0.5,
        total_ms=1.0,
        all_ms=2.0,
        decisions=decisions,
    )
    return replace(plan, **values)


def measured_plan(
    container: Container,
    light: Light,
    sensor: Sensor,
    tolerance: str | float,
    effects: str = "auto",
    device_seed: int = 5,
) -> Plan:
    """A plan with every figure of its table."""
    scene = PlannedScene(container, sensor, light, device_seed, threads=1)
    return make_plan(scene, PlanRequest(selected(effects), tolerance, figures=True))
