"""Hard case 31: slots near the largest float32 add up to more than it holds."""

from __future__ import annotations

import numpy as np
import pytest
from reference_programs import LOWERINGS, SLOTS, STOPS, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.light import Light

ROWS, COLS, MUCH = 3, 10, np.float32(3e38)
STOP = np.broadcast_to(np.arange(COLS) % 5, (ROWS, COLS))


def light() -> Light:
    return Light.of_clip(np.full((SLOTS, ROWS, COLS), MUCH, np.float32))


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_case_31_sums_are_exact(lowering: str) -> None:
    found = capture(program(STOPS, lowering, ROWS, COLS), light(), effects="none")
    assert found.valid.all()
    np.testing.assert_allclose(found.exposure_e[0], STOP * float(MUCH), rtol=1e-12)
    assert np.array_equal(found.frame[0], np.where(STOP > 0, 255, 0))


@pytest.mark.filterwarnings("ignore:warning.NS0793")
@pytest.mark.parametrize("lowering", LOWERINGS)
@pytest.mark.parametrize("effects", ["shot", "full_well", "shot,full_well,prnu", "all"])
def test_case_31_the_brightest_light_is_saturated_and_finite_under_effects(
    lowering: str, effects: str
) -> None:
    """Codes that mean something are the top one; others are marked."""
    container = program(STOPS, lowering, ROWS, COLS)
    found = capture(container, light(), sensor=sensor_of(container), effects=effects)
    assert found.valid.all()
    assert np.isfinite(found.exposure_e).all()
    opened = STOP > 0
    assert (found.saturated[0] | ~opened).all()
    told = opened & (found.saturated_by[0] & 8 == 0)
    if "all" not in effects:
        assert (found.frame[0][told] == 255).all()
