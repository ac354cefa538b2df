"""Sums, words in the block loop, and the reference: equal means, variances and covariances."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
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
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import KeptRegisters, PicturedProgram
from nscc_runtime.reference.capture import Reference, reference_scene
from nscc_runtime.sensor import Sensor

ROWS, COLS, DEVICE = 8, 12, 5
SIDE = {"far_shift": 66, "stabilise": 36}
"""Rows and columns of examples with long shifts; others have `COLS`."""
EXAMPLES = sorted((ROOT / "examples").glob("*.nsl"))
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


def variances(frames: np.ndarray) -> np.ndarray:
    """The variance of all pixels, one sample a frame."""
    return ((frames - frames.mean(axis=0)) ** 2).mean(axis=(1, 2, 3))[None]


SECOND_MOMENTS = variances, neighbours, buckets


def agree(
    found: np.ndarray,
    full: np.ndarray,
    second_moments: Sequence[Callable[[np.ndarray], np.ndarray]] = SECOND_MOMENTS,
) -> None:
    """Means of every pixel, variances in all, and covariances, within 5 sigma."""
    counts = [len(frames) for frames in (found, full)]
    spread = sum(frames.var(axis=0) / len(frames) for frames in (found, full))
    z = (found.mean(axis=0) - full.mean(axis=0)) / np.sqrt(spread + 1e-12)
    assert np.abs(z).max() < 5.5
    assert np.sqrt((z**2).mean()) < 1.4
    for samples in second_moments:
        mine, other = samples(found), samples(full)
        error = np.sqrt(mine.var(axis=1) / counts[0] + other.var(axis=1) / counts[1])
        away = np.abs(mine.mean(axis=1) - other.mean(axis=1))
        assert (away <= 5 * error + 1e-3 * np.abs(other.mean(axis=1))).all()


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


@pytest.mark.parametrize(
    ("tau_s", "spread", "slot"),
    [(0.1, 0.3, "500us"), (0.05, 0.5, "500us"), (2.7, 0.13, "11ms"), (10.0, 0.1, "500us")],
)
def test_leakage_of_every_pixel_is_that_of_the_reference(
    tau_s: float, spread: float, slot: str
) -> None:
    """Two buckets of about 40,000 electrons, on chips whose leakage differs much or little."""
    container = case("two buckets", 8, slot, rows=30, cols=40)
    leakage = {"leakage_tau_s": tau_s, "leakage_spread_fraction": spread}
    sensor = sensor_of(container, **leakage, analog_noise_lsb=0.0)
    light = moving_light((8, 30, 40), 9000.0, zeros=False)
    arguments = container, light, sensor, selected("leakage,prnu,analog")
    full, found = (expose(*arguments)(0) for expose in (by_reference, by_sums))
    assert np.sqrt(((found - full) ** 2).mean()) < 0.1
    assert np.abs(found - full).max() < 1.0
    arguments = container, light.scaled(0.01), sensor, selected("shot,dark,leakage")
    agree(
        np.array([*map(by_sums(*arguments), range(200))]),
        np.array([*map(by_reference(*arguments), range(200))]),
    )


@pytest.mark.parametrize("effects", ["none", "shot,dark", "crosstalk,prnu", "all"])
def test_light_that_is_not_a_number_makes_its_pixel_alone_invalid(effects: str) -> None:
    """With crosstalk its neighbours get nothing from it; a saturated lamp beside it is marked."""
    container = case("d edges", rows=12, cols=16)
    light = moving_light((8, 12, 16), 300.0)
    light.frames[0, 3, 4] = np.nan
    light.frames[:, 3, 5] = 1e6
    sensor = sensor_of(container, **SMALL_WELL)
    arguments = container, sensor, light, selected(effects)
    exposed = [
        Reference.of(container, sensor, arguments[3]).expose(
            reference_scene(container, light), 4, DEVICE
        ),
        frame_source(*arguments, DEVICE, 1).expose(3, 0),
    ]
    words = expose_pixels(prepare_pixels(*arguments, np.arange(192), DEVICE), 3, 0)
    exposure_e = words.exposure_e.reshape(-1, 12, 16)
    marks = words.saturated_by.reshape(exposure_e.shape)
    exposed.append(Exposure(exposure_e, np.isfinite(exposure_e), marks))
    for found in exposed:
        assert np.argwhere(~found.valid[0]).tolist() == [[3, 4]]
        assert np.argwhere(np.isnan(found.exposure_e[0])).tolist() == [[3, 4]]
        if effects in ("none", "crosstalk,prnu"):
            np.testing.assert_allclose(
                found.exposure_e[found.valid], exposed[0].exposure_e[found.valid], rtol=1e-6
            )
        assert bool(found.saturated_by[0, 3, 5]) is (effects == "all")


def by_images(
    container: Container, light: Light, sensor: Sensor, effects: Selection, by_words: bool
) -> Exposing:
    """Frame number -> buckets, images and planes (arrays, rows, cols) of a first frame."""
    program = PicturedProgram(container, sensor, effects, 1, by_words)
    expose, start = program.exposer_of(light, DEVICE), KeptRegisters.at_start(container)

    def outputs(number: int) -> np.ndarray:
        # The words of images draw by seed, too.
        seed = 4 if by_words else 3
        frame, _ = program.next_frame(expose(seed, number), start, None, (seed, DEVICE), number)
        told = frame.told.items()
        read = [x for name, x in told if name.removeprefix("image_") in program.pictures.reads]
        planes = [x for name, x in told if name.startswith("plane_")]
        return np.array([*frame.exposure_e, *read, *planes], np.float64)

    return outputs


def example(path: Path) -> Container:
    """The example on a small array of its chip."""
    source = Source(path.name, path.read_text())
    whole = compile_source(source, path.parent, Options(level=0, cache=False)).container
    side = SIDE.get(path.stem, COLS)
    small = replace(whole.target, rows=side, cols=side)
    options = Options(level=0, target=small, cache=False)
    return compile_source(source, path.parent, options).container


@pytest.mark.slow
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_all_simulators_agree_on_every_example(path: Path) -> None:
    """2,000 frames of few pixels, 200 of many, some of them saturated, with every effect: buckets,
    or what the program reads of buckets, images and planes."""
    container = example(path)
    if not container.target.has_logic:
        pytest.skip("chips without logic have the reference only")
    sensor, every = sensor_of(container), selected("all")
    shape = container.target.rows, container.target.cols
    wells = np.random.default_rng(2).lognormal(-1.0, 1.0, shape)
    rate = (wells * sensor.full_well_e / container.slot_s.sum()).astype(np.float32)
    light = Light.of_still(rate, container.slot_s)
    count = 2000 if shape == (COLS, COLS) else 200
    if not container.pictures.reads:
        simulators = by_reference, by_words if container.machine.stages else by_sums
    else:
        simulators = partial(by_images, by_words=True), partial(by_images, by_words=False)
    full, found = (
        np.array([*map(expose(container, light, sensor, every), range(count))])
        for expose in simulators
    )
    if not container.pictures.reads:
        agree(found, full)
    else:  # one by one, because sizes of buckets, images and planes differ
        for output in range(full.shape[1]):
            agree(found[:, [output]], full[:, [output]], (variances,))
