"""Successions of scenes that share plans, drawn at random: none may break the promise without a new
plan or a warning."""

from __future__ import annotations

import warnings
from collections.abc import Iterable

import numpy as np
from plan_cases import CASES, case
from promise import SCENES, error_of, full_frames, scene
from random_sensors import random_sensor
from reference_programs import sensor_of

from nscc_runtime import capture
from nscc_runtime.captured import Capture
from nscc_runtime.kept_plans import KeptPlans, Turn
from nscc_runtime.light import Light
from nscc_runtime.scenes.timing import with_motion

SIDE = 64


def changed(kind: str, clip: np.ndarray, full_e: float, rng: np.random.Generator) -> np.ndarray:
    """The light of the next scene (slots, rows, cols): what happened to it is the `kind`."""
    slots = len(clip)
    if kind == "flash":  # some pixels get all their light in one slot
        flashing = rng.random(clip.shape[1:]) < rng.choice([0.001, 0.02, 0.3])
        when, total = int(rng.integers(slots)), clip.sum(axis=0)
        clip = np.where(flashing, 0.0, clip)
        clip[when][flashing] = total[flashing]
    elif kind == "motion":
        step = int(rng.integers(1, 6))
        clip = np.stack([np.roll(clip[n], step * n, axis=1) for n in range(slots)])
    elif kind == "dimming":
        clip = clip * rng.uniform(0.1, 1.0)
    elif kind == "brightening":
        clip = clip * rng.uniform(1.0, 3.0)
    elif kind == "lamp":
        row, col = rng.integers(0, SIDE, 2)
        clip = clip.copy()
        clip[:, row : row + 2, col : col + 2] += full_e / slots * 10 ** rng.uniform(-1, 1.5)
    return clip.astype(np.float32)


def succession(seed: int, scenes: int = 5) -> list[str]:
    """What broke in one succession of scenes, with a few programs in turn."""
    rng = np.random.default_rng([13, seed])
    slots, slot = int(rng.choice([4, 8, 16])), f"{rng.choice([100, 500, 2000])}us"
    names = rng.choice(list(CASES), int(rng.integers(1, 3)), replace=False)
    programs = [case(str(name), slots, slot, SIDE, SIDE) for name in names]
    sensor = sensor_of(programs[0])
    if rng.random() < 0.3:
        sensor = random_sensor(programs[0], rng)
    name, tolerance = str(rng.choice(list(SCENES))), str(rng.choice(["0.15noise", "5e", "50e"]))
    clip = np.array(scene(name, slots, SIDE, SIDE).frames)
    moves, plans, broken = bool(rng.random() < 0.5), KeptPlans(), []
    kinds = ["same"]
    for number in range(scenes * len(programs)):
        if number % len(programs) == 0 and number:
            kinds.append(
                str(rng.choice(["same", "flash", "motion", "dimming", "brightening", "lamp"]))
            )
            clip = changed(kinds[-1], clip, sensor.full_well_e, rng)
        container = programs[number % len(programs)]
        light = with_motion(Light.of_clip(clip)) if moves else Light.of_clip(clip)
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            taken: Capture = capture(
                container,
                light,
                sensor=sensor,
                tolerance=tolerance,
                device_seed=5,
                turn=Turn(plans, number),
            )
        plan = taken.plan
        assert plan is not None
        if plan.tolerance_e is None or any("NS0749" in str(each.message) for each in said):
            continue
        full = full_frames(container, light, sensor, 4)
        error = error_of(plan, full, container, light, sensor)
        if error > 1.1 * plan.tolerance_e:
            broken.append(
                f"seed {seed}, scene {number} of {names}, {slots} slots, {name}, {' '.join(kinds)}"
                f"{', sampled' if moves else ''}: {error:.4g} e, {plan!r}, reused {plan.reused}"
            )
    return broken


def broken_successions(seeds: Iterable[int]) -> list[str]:
    """What broke in successions of scenes with these seeds."""
    return [text for seed in seeds for text in succession(seed)]
