"""Hard case 36: slots of a millisecond beside slots of minutes: dark charge follows time."""

from __future__ import annotations

import math

import numpy as np
import pytest
from reference_programs import program, sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.reference import frames

TIMES_US = [1e3, 3e8, 1e3, 7e3, 1e8, 2e3, 1e3, 5e7]
TEXT = "nsl 1\nframe slots [{}]\nopen when n {}\n"
DARK_E_PER_S = 40.0


def text(when: str) -> str:
    return TEXT.format(", ".join(f"{time:.0f}us" for time in TIMES_US), when)


@pytest.mark.parametrize(
    ("when", "slots"), [("< 8", range(8)), (">= 2", range(2, 8)), ("== 3", [3])]
)
def test_case_36_dark_charge_follows_the_open_time(when: str, slots) -> None:
    """Means over many pixels, of the reference and of a plan, against time itself."""
    container = program(text(when), "accumulate", 64, 64)
    sensor = sensor_of(container, dark_current_e_per_s=DARK_E_PER_S, dark_spread_fraction=0.0)
    dark = Light.of_clip(np.zeros((8, 64, 64), np.float32))
    wanted = DARK_E_PER_S * math.fsum(TIMES_US[n] for n in slots) * 1e-6
    sigma = math.sqrt(wanted / 64**2)
    (by_words,) = frames(container, dark, sensor, selected("dark"))
    for found in (by_words, capture(container, dark, sensor=sensor, effects="dark")):
        assert abs(found.exposure_e.mean() - wanted) < 5 * sigma + 1e-9
        assert found.exposure_e.min() >= 0
