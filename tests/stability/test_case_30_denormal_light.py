"""Hard case 30: light far below an electron, denormals included, is counted or is nothing."""

from __future__ import annotations

import numpy as np
import pytest
from reference_programs import LOWERINGS, SLOTS, STOPS, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.light import Light

ROWS, COLS = 3, 10
TINY = np.float32([1e-45, 5e-39, 1.2e-38, 1e-30])
"""The least denormal, one in the middle, a number beside the least normal one, and a normal one."""


def light(electrons: np.float32) -> Light:
    return Light.of_clip(np.full((SLOTS, ROWS, COLS), electrons, np.float32))


@pytest.mark.parametrize("lowering", LOWERINGS)
@pytest.mark.parametrize("electrons", TINY)
def test_case_30_denormal_light_is_counted_without_effects(
    lowering: str, electrons: np.float32
) -> None:
    container = program(STOPS, lowering, ROWS, COLS)
    found = capture(container, light(electrons), effects="none").exposure_e[0]
    wanted = np.arange(COLS) % 5 * float(electrons)
    np.testing.assert_allclose(found, np.broadcast_to(wanted, found.shape), rtol=1e-12, atol=0)


@pytest.mark.parametrize("lowering", LOWERINGS)
@pytest.mark.parametrize("effects", ["shot", "all", "auto"])
def test_case_30_denormal_light_counts_as_dark_under_effects(lowering: str, effects: str) -> None:
    container = program(STOPS, lowering, ROWS, COLS)
    sensor = sensor_of(container)
    dark = capture(container, light(np.float32(0)), sensor=sensor, effects=effects)
    for electrons in TINY:
        found = capture(container, light(electrons), sensor=sensor, effects=effects)
        assert found.valid.all()
        assert np.array_equal(found.frame, dark.frame)
        np.testing.assert_allclose(found.exposure_e, dark.exposure_e, atol=0.05)
