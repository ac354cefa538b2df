"""Hard case 8: 0.01 electrons on top of 30000: PIX less its reset level is right to 1e-6."""

from __future__ import annotations

import numpy as np
import pytest
from reference_exposure import expose as by_reference
from reference_programs import program, sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light

SMALL, LARGE = np.float32(0.01), np.float32(30_000)
TEXT = "nsl 1\nframe 8 slots of 1ms\nopen when {}\n"
LIGHT = {
    "n >= 5 and n < 6": (LARGE, 5),
    "n >= 7": (LARGE, 7),
    "n < 1": (LARGE, 0),
}


def light(place: int) -> Light:
    """The small charge in slot `place`, the large one all around it."""
    frames = np.full((8, 2, 3), LARGE, np.float32)
    frames[place] = SMALL
    return Light.of_clip(frames)


@pytest.mark.parametrize("rule", LIGHT)
@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
def test_case_08_a_small_exposure_is_exact_beside_much_light(rule: str, lowering: str) -> None:
    _, place = LIGHT[rule]
    container = program(TEXT.format(rule), lowering, 2, 3)
    for seed in range(5):
        found = expose(container, light(place), device_seed=seed).exposure_e[0]
        np.testing.assert_allclose(found, SMALL, rtol=1e-6)
        found = by_reference(
            container, light(place), sensor_of(container), selected("none"), device_seed=seed
        ).exposure_e[0]
        np.testing.assert_allclose(found, SMALL, rtol=1e-6)


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
def test_case_08_a_noisy_reset_level_is_subtracted_exactly(lowering: str) -> None:
    """Reset noise is subtracted with the level: the same charge comes out."""
    container = program(TEXT.format("n < 1"), "edges", 2, 3)
    sensor = sensor_of(container, reset_noise_e=30_000.0)
    frames = np.zeros((8, 2, 3), np.float32)
    frames[0] = SMALL
    found = by_reference(container, Light.of_clip(frames), sensor, selected("reset"))
    np.testing.assert_allclose(found.exposure_e[0], SMALL, rtol=1e-6)


def test_case_08_plain_float32_arithmetic_would_fail() -> None:
    assert abs((LARGE + SMALL - LARGE) / SMALL - 1) > 0.02


@pytest.mark.parametrize("rule", LIGHT)
@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
def test_case_08_planned_frames_are_exact(rule: str, lowering: str) -> None:
    container = program(TEXT.format(rule), lowering, 2, 3)
    found = capture(container, light(LIGHT[rule][1]), effects="none").exposure_e[0]
    np.testing.assert_allclose(found, SMALL, rtol=1e-6)
