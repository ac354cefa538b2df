"""Measure the time of simulations on this machine, for comparison with the shipped prices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from time import process_time

import numpy as np

import nscc
from nscc_runtime.effects import Selection, everything, selected
from nscc_runtime.execution.block_scene import expose_pixels, lay_out
from nscc_runtime.light import Light
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan_request import PlanRequest
from nscc_runtime.planning.planned_scene import SAMPLED, PlannedScene, trial_of
from nscc_runtime.planning.prices import SHIPPED, Work
from nscc_runtime.reference.capture import Reference, scene_of
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
    sensor = default_sensor(container.target)
    rows, cols = container.target.rows, container.target.cols
    # Waves of some ten pixels, 30 to 470 electrons per slot: bright, but not saturated.
    wave = np.sin(np.arange(rows) / 7.0)[:, None] * np.sin(np.arange(cols) / 5.0)
    slot_s = np.array(container.slot_us) * 1e-6
    still = Light.of_still((250e3 + 220e3 * wave).astype(np.float32), slot_s)
    film = Light.of_clip(np.repeat(still.frames, still.slots, axis=0), float(slot_s[0]))
    scenes = [PlannedScene(container, sensor, light, threads=1) for light in (still, film)]
    scene, all_effects = scenes[0], everything()
    work = Work.of(scene)
    places = np.linspace(0, scene.pixels - 1, _NEAR).astype(np.int64)
    laid = lay_out(container, sensor, still, all_effects, places, 0)
    reference, light = Reference.of(container, sensor, all_effects), scene_of(container, still)
    request = PlanRequest(selected("auto"), 5.0, figures=True)
    planned_ms = make_plan(scene, request).planning_ms
    reference_ns = 1e9 * _least_s(lambda: reference.expose(light, 0, 0, 0, 1), 1)
    trial = trial_of(scene, all_effects)
    return [
        Price("planning", f"a plan for {rows} x {cols} pixels", "ms", planned_ms,
              1e3 * _least_s(lambda: make_plan(scene, request))),
        Price("trial", f"{SAMPLED} pixels with one set of effects", "ms",
              work.trials_ms(1, SAMPLED), 1e3 * _least_s(lambda: trial.exposures(all_effects))),
        Price("words", "a pixel through its words, all effects", "ns", work.loop_ns(all_effects),
              1e9 / _NEAR * _least_s(lambda: expose_pixels(laid, 0, 0))),
        Price("reference", "a pixel and slot in the reference", "ns", SHIPPED.slot,
              reference_ns / (scene.pixels * still.slots)),
        *_of_sums(scenes),
    ]  # fmt: skip


def _of_sums(scenes: list[PlannedScene]) -> list[Price]:
    """Return prices of simulations by sums: a frame without effects, and the time saved by dropping
    each effect, for a still scene and for each further frame of light."""
    all_effects, nothing = everything(), selected("none")
    frames = scenes[1].light.slots - 1
    bare = [_frame_ns(scene, nothing) for scene in scenes]
    every = [_frame_ns(scene, all_effects) for scene in scenes]
    prices = [
        Price("sums", "a pixel without effects", "ns", SHIPPED.frame, bare[0]),
        Price("light", "a pixel and frame of light", "ns", SHIPPED.light,
              max(0.0, bare[1] - bare[0]) / frames),
    ]  # fmt: skip
    for effect in all_effects.effects:
        if not (effect.cost_ns and effect.sums):
            continue
        saved = [
            max(0.0, with_ns - _frame_ns(scene, all_effects.without(effect.name)))
            for scene, with_ns in zip(scenes, every, strict=True)
        ]
        prices.append(
            Price(effect.name, "a pixel by sums over slots", "ns", effect.cost_ns, saved[0])
        )
        if effect.light_ns:
            of_light = max(0.0, saved[1] - saved[0]) / frames
            prices.append(
                Price(effect.name, "a pixel and frame of light", "ns", effect.light_ns, of_light)
            )
    return prices


def _frame_ns(scene: PlannedScene, effects: Selection) -> float:
    """Return the nanoseconds per pixel of a frame on one core. The light is copied, so that no
    cached property is reused."""

    def expose() -> None:
        [_] = replace(scene, light=replace(scene.light)).frames(effects, 0, 1)

    return 1e9 / scene.pixels * _least_s(expose)


def _least_s(run: Callable[[], object], rounds: int = _ROUNDS) -> float:
    """Return the processor seconds of the fastest round, after a warm-up round."""
    run()
    seconds = []
    for _ in range(rounds):
        begin = process_time()
        run()
        seconds.append(process_time() - begin)
    return min(seconds)
