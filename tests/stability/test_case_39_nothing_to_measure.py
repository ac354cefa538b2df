"""Hard case 39: scenes without a number in them, or without light, divide nothing by zero."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from reference_programs import LOWERINGS, SLOTS, STOPS, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.light import Light

ROWS, COLS = 8, 20


@pytest.mark.parametrize("lowering", LOWERINGS)
@pytest.mark.parametrize("effects", ["none", "shot", "all", "auto"])
@pytest.mark.parametrize("fill", [0.0, np.nan, np.inf])
def test_case_39_scenes_without_usable_light_give_a_frame_without_numeric_warnings(
    lowering: str, effects: str, fill: float
) -> None:
    container = program(STOPS, lowering, ROWS, COLS)
    light = Light.of_clip(np.full((SLOTS, ROWS, COLS), fill, np.float32))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # Light without end eats the level of a reset, and that is said.
        warnings.filterwarnings("ignore", "warning.NS0793")
        found = capture(container, light, sensor=sensor_of(container), effects=effects)
    opened = np.broadcast_to(np.arange(COLS) % 5 > 0, (ROWS, COLS))
    if fill == 0 or (fill == np.inf and effects != "none"):
        # With noise, light without end is the most that is drawn; see case 12.
        assert found.valid.all()
        assert np.isfinite(found.exposure_e).all()
    else:
        assert not found.valid[0][opened].any()
