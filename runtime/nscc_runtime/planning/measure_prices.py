"""Measure the time of simulations on this machine, for comparison with the shipped prices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from time import process_time
from timeit import repeat

import numpy as np

import nscc
from nscc_runtime.effects import Selection, everything, selected
from nscc_runtime.light import Light
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
    reference = Reference.of(container, sensor, all_effects)
    light = reference_scene(container, still)
    # Without an effect that costs little, so that the exposures are not those of the trial itself.
    trial, dim = trial_of(scene), all_effects.without("lag")

    def frame(effects: Selection) -> Callable[[], object]:
        """Return a function that exposes the first frame of the scene with `effects`. The light is
        copied for each frame, so that none of its cached properties is reused."""
        return lambda: [*replace(scene, light=replace(still)).frames(effects, 0, 1)]

    pixel_ns = 1e9 / scene.pixels
    trial_s, words_s, sums_s, every_s, reference_s = map(
        _least_s,
        (
            lambda: replace(trial).exposed(dim),
            lambda: trial.frames(1),
            frame(selected("none")),
            frame(all_effects),
            lambda: reference.expose(light, 0, 0, 0, 1),
        ),
    )
    sampled, slot_ns = len(trial.sample.places), pixel_ns / still.slots
    words_text, one_set = "a pixel through its words, all effects", "pixels with one set of effects"
    prices = [
        Price("trial", f"{SAMPLED} {one_set}", "ms", work.trial_ms(SAMPLED), 1e3 * trial_s),
        Price("words", words_text, "ns", work.loop_ns(all_effects), 1e9 * words_s / sampled),
        Price("reference", "a pixel and slot", "ns", SLOT_NS, slot_ns * reference_s),
        Price("sums", "a pixel without effects", "ns", FRAME_NS, pixel_ns * sums_s),
    ]
    # What dropping an effect saves of the first frame by sums, for effects that cost something.
    for effect in all_effects.effects:
        if effect.cost_ns and isinstance(effect.sums, tuple):
            saved_s = every_s - _least_s(frame(all_effects.without(effect.name)))
            measured_ns = max(0.0, pixel_ns * saved_s)
            prices.append(
                Price(effect.name, "a pixel by sums over slots", "ns", effect.cost_ns, measured_ns)
            )
    return prices


def _least_s(run: Callable[[], object]) -> float:
    """Return the processor seconds of the fastest of `_ROUNDS` calls of `run`, after one more call
    to warm up."""
    run()
    return min(repeat(run, timer=process_time, repeat=_ROUNDS, number=1))
