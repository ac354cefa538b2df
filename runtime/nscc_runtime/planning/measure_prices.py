"""Measure the time of simulations on this machine, for comparison with the shipped prices."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from time import process_time

import numpy as np

import nscc
from nscc_runtime.effects import CannotHave, Effect, Selection, everything, selected
from nscc_runtime.execution.frames import Execution, executed
from nscc_runtime.execution.pixels import Running
from nscc_runtime.execution.program import AnalysedProgram, analysed
from nscc_runtime.light import Light
from nscc_runtime.planning.make import PlanRequest, make_plan
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.prices import SHIPPED, Work
from nscc_runtime.planning.scenes import planning_of
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.sensor import default_sensor

_TEXT = """nsl 1
frame 16 slots of 1ms
code stop : 1..16
open when n < stop
pixels stop = 1 + (5 * x + 3 * y) % 16
"""
_NEAR = 512
"""Number of pixels that run through their words."""
_ROUNDS = 5
"""Number of timed rounds of each measurement; the fastest counts."""


@dataclass(frozen=True)
class Price:
    """One measured time. `shipped`: the value that plans are chosen by; `measured`: the value on
    this machine, both in `unit`."""

    name: str
    description: str
    unit: str
    shipped: float
    measured: float


def measure_prices() -> list[Price]:
    """Measure each price on this machine, in several seconds, as the fastest of some rounds."""
    container = nscc.compile(_TEXT, level=1).container
    program = analysed(container, default_sensor(container.target))
    rows, cols = program.array.shape
    # Waves of some ten pixels, 30 to 470 electrons per slot: bright, but not saturated.
    wave = np.sin(np.arange(rows) / 7.0)[:, None] * np.sin(np.arange(cols) / 5.0)
    light = Light.of_still((250e3 + 220e3 * wave).astype(np.float32), program.slot_s)
    pixels, request = program.array.lanes.size, PlanRequest(selected("auto"), 5.0, figures=True)

    # `replace` makes a copy of the light without cached properties.
    def planned() -> Plan:
        return make_plan(planning_of(container, program.sensor, replace(light)), request)

    plan = planned()
    assert plan.cost is not None
    words = everything()
    words = words.without(*(e.name for e in words.effects if isinstance(e.words, CannotHave)))
    chosen = np.linspace(0, pixels - 1, _NEAR).astype(np.int64)
    wired, scene = program.wired(words, 0), scene_of(container, light)
    planning_ms, exposing_ms = plan.cost.planning_ms, plan.cost.total_ms - plan.cost.planning_ms
    return [
        Price("planning", f"a plan for {rows} x {cols} pixels", "ms", planning_ms,
              1e3 * _least_s(planned)),
        Price("sums", "a pixel by sums over slots, to 5 e", "ns", exposing_ms * 1e6 / pixels,
              1e9 / pixels * _least_s(lambda: _frame(program, light, plan.execution))),
        Price("words", "a pixel through its words, all effects", "ns",
              Work.of(program).words_ns(words, "nothing"),
              1e9 / _NEAR * _least_s(lambda: Running(wired, light, chosen, 1).expose(0, 0))),
        Price("reference", "a pixel and slot in the reference", "ns", SHIPPED.slot_of_reference,
              1e9 / (pixels * light.slots)
              * _least_s(lambda: program.reference.expose(scene, 0, 0, 0, 1), 1)),
        *_of_effects(program, light),
    ]  # fmt: skip


def _of_effects(program: AnalysedProgram, still: Light) -> list[Price]:
    """Return prices of effects in simulations by sums: the time saved by dropping each effect, for
    a still scene and for each further frame of light."""
    all_effects = everything()
    all_effects = all_effects.without(
        *(e.name for e in all_effects.effects if isinstance(e.sums, CannotHave))
    )
    film = Light.of_clip(np.repeat(still.frames, still.slots, axis=0), float(program.slot_s[0]))
    prices: list[Price] = []
    for effect in all_effects.effects:
        if not (effect.cost_ns and effect.sums):
            continue
        of_still, of_film = (
            _saved_ns(program, light, all_effects, effect) for light in (still, film)
        )
        prices.append(
            Price(effect.name, "a pixel by sums over slots", "ns", effect.cost_ns, of_still)
        )
        if effect.light_ns:
            of_light = max(0.0, of_film - of_still) / (film.slots - 1)
            prices.append(
                Price(effect.name, "a pixel and frame of light", "ns", effect.light_ns, of_light)
            )
    return prices


def _saved_ns(
    program: AnalysedProgram, light: Light, all_effects: Selection, effect: Effect
) -> float:
    """Return the nanoseconds per pixel that a frame by sums saves without `effect`."""
    executions = [
        Execution("sums", kept_effects, kept_effects, all_effects)
        for kept_effects in (all_effects, all_effects.without(effect.name))
    ]
    seconds = [math.inf, math.inf]
    for _ in range(_ROUNDS):
        for number, execution in enumerate(executions):
            run = partial(_frame, program, light, execution)
            seconds[number] = min(seconds[number], _least_s(run, 2))
    return max(0.0, 1e9 * (seconds[0] - seconds[1]) / program.array.lanes.size)


def _frame(program: AnalysedProgram, light: Light, execution: Execution) -> None:
    """Expose one frame on one core. The light is copied, so that no cached property is reused."""
    executed(program, replace(light), execution, threads=1).frame(0, 0)


def _least_s(run: Callable[[], object], rounds: int = _ROUNDS) -> float:
    """Return the processor seconds of the fastest round, after a warm-up round."""
    run()
    seconds = []
    for _ in range(rounds):
        begin = process_time()
        run()
        seconds.append(process_time() - begin)
    return min(seconds)
