"""Hard case 14: charge at full well -1 ulp, 0, +1 ulp is monotone, the top code, never wraps."""

from __future__ import annotations

import numpy as np
import pytest
from reference_programs import exposures, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.reference import frames

OPEN = "nsl 1\nframe 4 slots of 1ms\nopen when n < 4\n"
WELL = 30000.0


def light_near_the_well() -> Light:
    """All of it in slot 0: the neighbours of the full well in float32, and far beyond it."""
    well = np.float32(WELL)
    below, above = np.nextafter(well, np.float32(0)), np.nextafter(well, np.float32(np.inf))
    row = np.array([below, well, above, 2 * well, 100 * well, 1e15, 1e30], np.float32)
    values = np.zeros((4, 3, len(row)), np.float32)
    values[0] = row
    return Light.of_clip(values)


@pytest.mark.parametrize("lowering", ["accumulate", "latch", "edges"])
@pytest.mark.parametrize("effects", ["full_well", "full_well,register", "full_well,shot"])
def test_case_14_codes_never_fall_around_the_full_well(lowering: str, effects: str) -> None:
    container = program(OPEN, lowering, 3, 7)
    light = light_near_the_well()
    (frame,) = frames(container, light, sensor_of(container), selected(effects))
    if "shot" not in effects:
        assert np.all(np.diff(frame.exposure_e[0], axis=1) >= 0)
        assert np.all(np.diff(frame.frame[0].astype(int), axis=1) >= 0)
    assert frame.valid.all()
    assert frame.exposure_e.max() <= WELL
    # Beyond twice the well no noise brings the charge back below it.
    beyond = frame.frame[0, :, 3:]
    assert np.all(beyond == beyond.max())
    if "register" not in effects:
        assert np.all(beyond == 255)
    # Only the well acts: a charge just below it is kept to the bit.
    if effects == "full_well":
        assert np.all(frame.frame[0] == 255)
        assert frame.exposure_e[0, 0, 0] == light.frames[0, 0, 0]
        assert np.all(frame.exposure_e[0, :, 1:] == WELL)


def test_case_14_an_exposure_without_effects_keeps_all_light() -> None:
    container = program(OPEN, "accumulate", 3, 7)
    light = light_near_the_well()
    found = exposures(container, light, sensor_of(container), "prnu,-prnu")[0, 0]
    np.testing.assert_allclose(found, light.frames[0], rtol=1e-9)


@pytest.mark.parametrize("lowering", ["accumulate", "latch", "edges"])
@pytest.mark.parametrize("effects", ["full_well", "full_well,register", "full_well,shot"])
def test_case_14_planned_frames_stay_within_the_well(lowering: str, effects: str) -> None:
    container = program(OPEN, lowering, 3, 7)
    light, sensor = light_near_the_well(), sensor_of(container)
    (by_words,) = frames(container, light, sensor, selected(effects))
    found = capture(container, light, sensor=sensor, effects=effects)
    assert found.valid.all()
    assert found.exposure_e.max() <= WELL
    assert np.all(found.frame[0, :, 3:] == by_words.frame[0, :, 3:])
    # Counts by formula may differ by one electron from those of the reference.
    np.testing.assert_allclose(found.exposure_e, by_words.exposure_e, atol=1.001)
