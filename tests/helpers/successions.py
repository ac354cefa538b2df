"""Successions of scenes that share plans, drawn at random: none may break the promise without a new
plan or a warning."""

from __future__ import annotations

import warnings
from collections.abc import Iterable

import numpy as np
from plan_cases import CASES, case
from promise import SCENES, difference_in_distribution, loop_pixels, rms_of, scene
from random_sensors import random_sensor
from reference_programs import sensor_of

from nscc_runtime import capture
from nscc_runtime.captured import Capture
from nscc_runtime.effects import everything
from nscc_runtime.kept_plans import KeptPlans, Turn
from nscc_runtime.light import Light
from nscc_runtime.scenes.timing import with_motion

SIDE = 64
KINDS = ("same", "flash", "motion", "dimming", "brightening", "lamp")
LOOP_FRAMES, OWN_FRAMES = 4, 8
SIGMAS = 5.0
"""Own frames and those of the loop differ if they do so by this many standard errors."""
ROUNDING_E = 1e-3
LOST = 1 | 2 | 8
"""The bits of marks of the exposure: well, register and reset level."""


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


def succession(seed: int, scenes: int = 5) -> tuple[list[str], set[str]]:
    """What broke in one succession of scenes, with a few programs in turn, and what happened to
    scenes after one that was exposed without some effects."""
    rng = np.random.default_rng([13, seed])
    slots, slot = int(rng.choice([4, 8, 16])), f"{rng.choice([100, 500, 2000])}us"
    names = rng.choice(list(CASES), int(rng.integers(1, 3)), replace=False)
    programs = [case(str(name), slots, slot, SIDE, SIDE) for name in names]
    sensor = sensor_of(programs[0])
    if rng.random() < 0.3:
        sensor = random_sensor(programs[0], rng)
    name, tolerance = str(rng.choice(list(SCENES))), str(rng.choice(["0.15noise", "5e", "50e"]))
    clip = np.array(scene(name, slots, SIDE, SIDE).frames)
    sampled, plans, broken = bool(rng.random() < 0.5), KeptPlans(), list[str]()
    kinds, before, changes = ["same"], [False] * len(programs), set[str]()
    for number in range(scenes * len(programs)):
        turn = number % len(programs)
        if turn == 0 and number:
            kinds.append(str(rng.choice(KINDS)))
            clip = changed(kinds[-1], clip, sensor.full_well_e, rng)
        if before[turn]:
            changes.add(f"{kinds[-1]}, sampled" if sampled else kinds[-1])
        container = programs[turn]
        light = with_motion(Light.of_clip(clip)) if sampled else Light.of_clip(clip)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            taken: Capture = capture(
                container,
                light,
                sensor=sensor,
                tolerance=tolerance,
                device_seed=5,
                repeat=OWN_FRAMES,
                turn=Turn(plans, number),
            )
        plan = taken.plan
        assert plan is not None
        before[turn] = bool(plan.names("dropped"))
        chip = container, light, sensor
        planned_e, marks = loop_pixels(*chip, plan.kept, LOOP_FRAMES)
        wrong = unlike(taken, planned_e, marks)
        if plan.tolerance_e is not None:
            error_e = rms_of(planned_e - loop_pixels(*chip, everything(), LOOP_FRAMES)[0])
            if error_e > 1.1 * plan.tolerance_e:
                wrong.append(f"{error_e:.4g} e, {plan!r}, reused {plan.reused}")
        if wrong:
            broken.append(
                f"seed {seed}, scene {number} of {names}, {slots} slots, {name}, {' '.join(kinds)}"
                f"{', sampled' if sampled else ''}: {'; '.join(wrong)}"
            )
    return broken, changes


def unlike(taken: Capture, loop_e: np.ndarray, loop_marks: np.ndarray) -> list[str]:
    """In what a capture of several frames differs from the loop over words with its effects,
    (frames, buckets, pixels): electrons in distribution, and how often pixels lose charge."""
    own_e = taken.exposure_e.reshape(OWN_FRAMES, *loop_e.shape[1:])
    marks = taken.saturated_by.reshape(own_e.shape)
    wrong = []
    error_e = difference_in_distribution(own_e, loop_e, SIGMAS)
    if error_e > ROUNDING_E:
        wrong.append(f"own frames differ by more than chance, and by {error_e:.4g} e more")
    lost = [(each & LOST > 0).mean(axis=0) for each in (marks, loop_marks)]
    rate = np.average(lost, axis=0, weights=[OWN_FRAMES, LOOP_FRAMES])
    chance = np.sqrt((rate * (1 - rate)).sum() * (1 / OWN_FRAMES + 1 / LOOP_FRAMES))
    if abs((lost[0] - lost[1]).sum()) > SIGMAS * chance + 1:
        wrong.append(f"{lost[0].sum():.4g} pixels lose charge, in the loop {lost[1].sum():.4g}")
    return wrong


def broken_successions(seeds: Iterable[int]) -> list[str]:
    """What broke in successions of scenes with these seeds."""
    return [text for seed in seeds for text in succession(seed)[0]]
