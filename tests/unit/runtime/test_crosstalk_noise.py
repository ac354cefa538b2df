"""The noise of neighbours that exchange counts, against covariances that numpy computes."""

from __future__ import annotations

import numpy as np
import pytest
from plan_cases import case, moving_light
from reference_programs import sensor_of

from nscc.words.container import Container
from nscc_runtime.effects import selected
from nscc_runtime.effects.crosstalk import smeared
from nscc_runtime.emulator.capture import expose
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.execution.frames import frame_source, word_reasons
from nscc_runtime.light import Light

SLOTS, ROWS, COLS, DEVICE, FRAMES = 8, 5, 8, 5, 3000


def slots_seen(container: Container) -> np.ndarray:
    """Which slots (N, buckets, pixels) each bucket sees: exposures of one lit slot each, without
    effects."""
    lit = np.zeros((SLOTS, SLOTS, ROWS, COLS), np.float32)
    lit[range(SLOTS), range(SLOTS)] = 1.0
    seen = [expose(container, Light.of_clip(slots)).exposure_e for slots in lit]
    return np.array(seen).reshape(SLOTS, -1, ROWS * COLS)


def covariance_e2(container: Container, light: Light, fraction: float) -> np.ndarray:
    """The covariance of all exposures (buckets x pixels): Poisson counts of each slot, of which
    each pixel gives a fraction to each neighbour."""
    given = smeared(np.eye(ROWS * COLS).reshape(-1, ROWS, COLS), fraction)
    moved = given.reshape(ROWS * COLS, -1).T  # from the second pixel to the first
    seen, total = slots_seen(container), 0.0
    for slot, means in zip(seen, light.dense().reshape(SLOTS, -1), strict=True):
        charge = (moved * means) @ moved.T
        exposures = slot.reshape(-1)
        total = total + exposures[:, None] * exposures * np.tile(charge, (len(slot), len(slot)))
    return np.asarray(total)


def frames_of(
    simulator: str, container: Container, light: Light, fraction: float, effects: str
) -> np.ndarray:
    """Frames (frames, buckets x pixels) of a run, or of the loop over words."""
    sensor = sensor_of(container, crosstalk_fraction=fraction)
    chip = container, sensor, light, selected(effects)
    if simulator == "run":
        source = frame_source(*chip, DEVICE, 1)
        frames = [source.expose(3, number).exposure_e for number in range(FRAMES)]
    else:
        scene = prepare_pixels(*chip, np.arange(ROWS * COLS), DEVICE)
        frames = [expose_pixels(scene, 3, number).exposure_e for number in range(FRAMES)]
    return np.array(frames).reshape(FRAMES, -1)


@pytest.mark.parametrize("moving", [False, True])
@pytest.mark.parametrize("name", ["b edges", "c accumulate", "codebook", "two buckets"])
@pytest.mark.parametrize(
    ("simulator", "fraction"),
    [("run", 0.01), ("loop", 0.01), ("run", 0.05), ("run", 0.2), ("loop", 0.2)],
)
def test_every_covariance_of_pixels_and_buckets_is_that_of_their_counts(
    simulator: str, fraction: float, name: str, moving: bool
) -> None:
    container = case(name, SLOTS, rows=ROWS, cols=COLS)
    # Weak crosstalk of bright pixels to dark ones is an approximation.
    least_e = 0.0 if fraction > 0.01 else 100.0
    frames = moving_light((SLOTS, ROWS, COLS), 100.0).dense() + np.float32(least_e)
    light = Light.of_clip(frames if moving else np.repeat(frames[:1], SLOTS, axis=0))
    wanted = covariance_e2(container, light, fraction)
    away = frames_of(simulator, container, light, fraction, "shot,crosstalk")
    away = away - away.mean(axis=0)
    variance_e2 = np.diag(wanted)
    error_e2 = np.sqrt((np.outer(variance_e2, variance_e2) + wanted**2) / FRAMES)
    lit = variance_e2 > 0
    z = ((away.T @ away / (FRAMES - 1) - wanted)[lit][:, lit] / error_e2[lit][:, lit]).ravel()
    assert np.abs(z).max() < 5.5
    # Of neighbours and of the pixels themselves alone, deviations of one sign would add up.
    correlated = (np.abs(wanted) > 0)[lit][:, lit].ravel()
    assert np.sqrt((z[correlated] ** 2).mean()) < 1.15


@pytest.mark.parametrize("name", ["b edges", "codebook"])
@pytest.mark.parametrize("fraction", [0.01, 0.05])
def test_pixels_keep_their_counts_if_crosstalk_is_left_out(name: str, fraction: float) -> None:
    """Otherwise the measured error of leaving it out would contain all shot noise."""
    container = case(name, SLOTS, rows=ROWS, cols=COLS)
    light = moving_light((SLOTS, ROWS, COLS), 100.0)
    full, without = (
        frames_of("loop", container, light, fraction, effects)
        for effects in ("shot,crosstalk", "shot")
    )
    assert (full - without).std(axis=0).mean() < 6 * fraction * full.std(axis=0).mean()


def test_strong_crosstalk_of_counts_runs_all_pixels_through_their_words() -> None:
    container = case("codebook", SLOTS, rows=ROWS, cols=COLS)
    light = moving_light((SLOTS, ROWS, COLS), 100.0)
    for fraction, effects, count in (
        (0.01, "all", 0),
        (0.011, "all", ROWS * COLS),
        (0.011, "prnu,crosstalk", 0),
        (0.011, "all,-crosstalk", 0),
    ):
        sensor, chosen = sensor_of(container, crosstalk_fraction=fraction), selected(effects)
        assert len(frame_source(container, sensor, light, chosen, DEVICE, 1).near) == count
        reasons = word_reasons(container, sensor, [light], chosen, DEVICE)
        assert reasons == (("crosstalk is above 1%",) if count else ())
