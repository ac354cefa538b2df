"""Hard case 16: -1, 256, 300, NaN and infinities become 8 bits by clamping; NaN is flagged."""

from __future__ import annotations

import numpy as np
import pytest
from emulator_programs import target_of

from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.frame_file import read_out
from nscc_runtime.sensor import default_sensor

# A full well is a step of IN: exposures are spread over the codes without a rest.
TARGET = target_of(
    (1, 1), full_well_e=255.0, register_max_e=127 * 255.0, register_min_e=-127 * 255.0
)
VALUES = np.array([-1.0, 256.0, 300.0, np.nan, np.inf, -np.inf, 1e300, -1e300, 65536.0, -0.0])
EXPECTED = [0, 255, 255, 0, 255, 0, 255, 0, 255, 0]


@pytest.mark.parametrize("noisy", [False, True])
def test_case_16_values_outside_the_codes_are_clamped_and_flagged(noisy: bool) -> None:
    shaped = VALUES.reshape(1, 1, -1)
    noise = np.zeros(shaped.shape) if noisy else 0.0
    exposure = Exposure(shaped, np.isfinite(shaped))
    with np.errstate(all="raise"):
        found = read_out(exposure, TARGET, default_sensor(TARGET), noise)
    assert found.frame.dtype == np.uint8
    assert found.frame[0, 0].tolist() == EXPECTED
    assert found.valid[0, 0].tolist() == np.isfinite(VALUES).tolist()


def test_case_16_nan_is_flagged_even_where_the_exposure_was_not() -> None:
    shaped = VALUES.reshape(1, 1, -1)
    found = read_out(Exposure(shaped, np.ones(shaped.shape, bool)), TARGET)
    assert found.valid[0, 0].tolist() == (~np.isnan(VALUES)).tolist()


@pytest.mark.parametrize("offset", [-65536.0, -3.0, 10.0, 65536.0])
def test_case_16_values_with_an_offset_are_clamped(offset: float) -> None:
    sensor = default_sensor(TARGET).changed(adc_offset_lsb=offset)
    levels = np.arange(-300.0, 600.0).reshape(1, 1, -1)
    found = read_out(Exposure(levels, np.ones(levels.shape, bool)), TARGET, sensor).frame
    expected = [min(max(int(level + offset), 0), 255) for level in levels.reshape(-1)]
    assert found[0, 0].tolist() == expected
