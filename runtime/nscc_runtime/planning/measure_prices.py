"""Measure the time of simulations on this machine, for comparison with the shipped prices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from time import process_time

import numpy as np

import nscc
from nscc_runtime.effects import Selection, everything, selected
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.light import Light
from nscc_runtime.planning.make import make_plan
from nscc_runtime.planning.plan import PlanRequest, effects_of_exposure
from nscc_runtime.planning.planned_scene import SAMPLED, PlannedScene, trial_of
from nscc_runtime.planning.prices import FRAME_NS, SLOT_NS, Work
from nscc_runtime.reference.capture import Reference, reference_scene
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
    """One measured time. `shipped`: the value that plans (choices of the effects that are
    simulated) are chosen by; `measured`: the value on this machine, both in `unit`."""

    name: str
    description: str
    unit: str
    shipped: float
    measured: float


def measure_prices() -> list[Price]:
    """Measure each price on this machine, as the processor time of the fastest of some rounds, and
    return them with the shipped ones. It takes several seconds of one core."""
    container = nscc.compile(_TEXT, level=1).container
    sensor = default_sensor(container.target)
    rows, cols = container.target.rows, container.target.cols
    # Waves of some ten pixels, 30 to 470 electrons per slot: bright, but not saturated.
    wave = np.sin(np.arange(rows) / 7.0)[:, None] * np.sin(np.arange(cols) / 5.0)
    slot_s = np.array(container.slot_us) * 1e-6
    still = Light.of_still((250e3 + 220e3 * wave).astype(np.float32), slot_s)
    scene, all_effects = PlannedScene(container, sensor, still, threads=1), everything()
    work = Work.of(scene)
    places = np.linspace(0, scene.pixels - 1, _NEAR).astype(np.int64)
    prepared = prepare_pixels(container, sensor, still, all_effects, places, 0)
    reference, light = (
        Reference.of(container, sensor, all_effects),
        reference_scene(container, still),
    )
    request = PlanRequest(selected("auto"), 5.0, figures=True)
    reference_ns = 1e9 * _least_s(lambda: reference.expose(light, 0, 0, 0, 1), 1)
    # Without an effect that costs little, so that the exposures are not those of the trial itself.
    trial, dim = trial_of(scene), all_effects.without("lag")
    return [
        Price(
            "planning",
            f"a plan for {rows} x {cols} pixels",
            "ms",
            work.trials_ms(3 + len(effects_of_exposure()), SAMPLED),
            1e3 * _least_s(lambda: make_plan(scene, request)),
        ),
        Price(
            "trial",
            f"{SAMPLED} pixels with one set of effects",
            "ms",
            work.trials_ms(1, SAMPLED),
            1e3 * _least_s(lambda: replace(trial).exposures(dim)),
        ),
        Price(
            "words",
            "a pixel through its words, all effects",
            "ns",
            work.loop_ns(all_effects),
            1e9 / _NEAR * _least_s(lambda: expose_pixels(prepared, 0, 0)),
        ),
        Price(
            "reference",
            "a pixel and slot in the reference",
            "ns",
            SLOT_NS,
            reference_ns / (scene.pixels * still.slots),
        ),
        *_of_sums(scene),
    ]


def _of_sums(scene: PlannedScene) -> list[Price]:
    """Return the measured times of the first frame of `scene` by sums, per pixel: without effects,
    and what dropping each effect saves, for effects that cost something there; at least 0."""
    all_effects = everything()
    every_ns = _frame_ns(scene, all_effects)
    bare_ns = _frame_ns(scene, selected("none"))
    return [
        Price("sums", "a pixel without effects", "ns", FRAME_NS, bare_ns),
        *(
            Price(
                effect.name,
                "a pixel by sums over slots",
                "ns",
                effect.cost_ns,
                max(0.0, every_ns - _frame_ns(scene, all_effects.without(effect.name))),
            )
            for effect in all_effects.effects
            if effect.cost_ns and isinstance(effect.sums, tuple)
        ),
    ]


def _frame_ns(scene: PlannedScene, effects: Selection) -> float:
    """Return the time of the first frame of `scene` with `effects`, in nanoseconds per pixel on one
    core. The light is copied for each frame, so that none of its cached properties is reused."""

    def expose() -> None:
        """Expose one frame, without stored sums of its light."""
        [_] = replace(scene, light=replace(scene.light)).frames(effects, 0, 1)

    return 1e9 / scene.pixels * _least_s(expose)


def _least_s(run: Callable[[], object], rounds: int = _ROUNDS) -> float:
    """Return the processor seconds of the fastest of `rounds` calls of `run`, after one more call
    to warm up."""
    run()
    seconds = []
    for _ in range(rounds):
        begin = process_time()
        run()
        seconds.append(process_time() - begin)
    return min(seconds)
