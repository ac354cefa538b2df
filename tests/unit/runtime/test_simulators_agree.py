"""Sums, words in the block loop, and the reference: equal means, variances and covariances."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from plan_cases import case, moving_light
from reference_programs import sensor_of

from nscc.compiler import compile_source
from nscc.pipeline import Options
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.effects import Selection, selected
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.execution.frames import frame_source
from nscc_runtime.execution.moments import scene_moments
from nscc_runtime.execution.program import analysed
from nscc_runtime.light import Light
from nscc_runtime.reference.capture import Reference, reference_scene
from nscc_runtime.sensor import Sensor

ROWS, COLS, DEVICE = 8, 12, 5
FAR = ("far_shift", "stabilise")
"""Examples with shifts that are longer than this array."""
EXAMPLES = sorted(p for p in (ROOT / "examples").glob("*.nsl") if p.stem not in FAR)
Exposing = Callable[[int], np.ndarray]
"""Frame number -> exposures (buckets, rows, cols)."""


def by_reference(
    container: Container, light: Light, sensor: Sensor, effects: Selection
) -> Exposing:
    reference, scene = Reference.of(container, sensor, effects), reference_scene(container, light)
    return lambda number: reference.expose(scene, 4, DEVICE, number, 1).exposure_e


def by_sums(container: Container, light: Light, sensor: Sensor, effects: Selection) -> Exposing:
    scene = frame_source(container, sensor, light, effects, DEVICE, 1)
    return lambda number: scene.expose(3, number).exposure_e


def by_words(container: Container, light: Light, sensor: Sensor, effects: Selection) -> Exposing:
    shape = light.shape
    places = np.arange(shape[0] * shape[1])
    scene = prepare_pixels(container, sensor, light, effects, places, DEVICE)
    return lambda number: expose_pixels(scene, 3, number).exposure_e.reshape(-1, *shape)


def neighbours(frames: np.ndarray) -> np.ndarray:
    """The covariance of neighbours, one sample a frame: in rows, and in columns."""
    away = frames - frames.mean(axis=0)
    return np.stack(
        [
            (away[..., :-1] * away[..., 1:]).mean(axis=(1, 2, 3)),
            (away[..., :-1, :] * away[..., 1:, :]).mean(axis=(1, 2, 3)),
        ]
    )


def buckets(frames: np.ndarray) -> np.ndarray:
    """The covariance of the first two buckets, one sample a frame and column."""
    away = frames - frames.mean(axis=0)
    return np.moveaxis((away[:, 0] * away[:, -1]).mean(axis=1), 0, 1)


def agree(found: np.ndarray, full: np.ndarray) -> None:
    """Means and variances of every pixel, variances in all, and covariances, within 5 sigma."""
    counts = [len(frames) for frames in (found, full)]
    spread = sum(frames.var(axis=0) / len(frames) for frames in (found, full))
    z = (found.mean(axis=0) - full.mean(axis=0)) / np.sqrt(spread + 1e-12)
    assert np.abs(z).max() < 5.5
    assert np.sqrt((z**2).mean()) < 1.4
    for samples in (
        lambda frames: ((frames - frames.mean(axis=0)) ** 2).mean(axis=(1, 2, 3))[None],
        neighbours,
        buckets,
    ):
        mine, other = samples(found), samples(full)
        error = np.sqrt(mine.var(axis=1) / counts[0] + other.var(axis=1) / counts[1])
        away = np.abs(mine.mean(axis=1) - other.mean(axis=1))
        assert (away < 5 * error + 1e-3 * np.abs(other.mean(axis=1))).all()


SMALL_WELL = {
    "full_well_e": 2500.0,
    "register_min_e": -3000.0,
    "register_max_e": 3000.0,
    "electrons_per_lsb": 10.0,
}
STRONG = {
    "crosstalk_fraction": 0.03,
    "dark_current_e_per_s": 20000.0,
    "leakage_tau_s": 0.2,
    "prnu_fraction": 0.05,
}


@pytest.mark.parametrize("effects", ["shot,dark,crosstalk", "all"])
@pytest.mark.parametrize("name", ["b edges", "c accumulate", "codebook", "two buckets"])
@pytest.mark.parametrize("simulator", [by_sums, by_words])
def test_frames_by_sums_and_by_words_have_the_moments_of_the_reference(
    simulator: Callable[..., Exposing], name: str, effects: str
) -> None:
    container = case(name, rows=ROWS, cols=COLS)
    light = moving_light((8, ROWS, COLS), 300.0)
    # Pixels that saturate run through their words by both.
    values = STRONG if simulator is by_sums else {**STRONG, **SMALL_WELL}
    arguments = container, light, sensor_of(container, **values), selected(effects)
    full = np.array([*map(by_reference(*arguments), range(300))])
    agree(np.array([*map(simulator(*arguments), range(600))]), full)


@pytest.mark.parametrize("name", ["b edges", "c edges", "two buckets"])
def test_predicted_means_are_those_of_2000_frames(name: str) -> None:
    container = case(name, rows=ROWS, cols=COLS)
    light, sensor = moving_light((8, ROWS, COLS), 300.0), sensor_of(container, **STRONG)
    program, every = analysed(container, sensor), selected("all")
    moments = scene_moments(program, light, every, DEVICE)
    frames = np.array([*map(by_sums(container, light, sensor, every), range(2000))])
    mean_e, variance_e2 = frames.mean(axis=0), frames.var(axis=0, ddof=1)
    z = (mean_e - moments.mean_e.reshape(mean_e.shape)) / np.sqrt(variance_e2 / 2000)
    assert np.abs(z).max() < 5


def example(path: Path) -> Container:
    """The example on a small array of its chip."""
    source = Source(path.name, path.read_text())
    whole = compile_source(source, path.parent, Options(level=0, cache=False)).container
    small = replace(whole.target, rows=COLS, cols=COLS)
    options = Options(level=0, target=small, cache=False)
    return compile_source(source, path.parent, options).container


@pytest.mark.slow
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_all_simulators_agree_on_every_example(path: Path) -> None:
    """2,000 frames of few pixels, some of them saturated, with every effect."""
    container = example(path)
    if not container.target.has_logic:
        pytest.skip("chips without logic have the reference only")
    sensor, every = sensor_of(container), selected("all")
    wells = np.random.default_rng(2).lognormal(-1.0, 1.0, (COLS, COLS))
    rate = (wells * sensor.full_well_e / container.slot_s.sum()).astype(np.float32)
    light = Light.of_still(rate, container.slot_s)
    simulator = by_words if container.machine.stages else by_sums
    full, found = (
        np.array([*map(expose(container, light, sensor, every), range(2000))])
        for expose in (by_reference, simulator)
    )
    agree(found, full)
