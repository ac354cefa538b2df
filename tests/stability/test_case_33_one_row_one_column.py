"""Hard case 33: arrays of one row, of one column and of one pixel, however long."""

from __future__ import annotations

import numpy as np
import pytest
from reference_programs import SLOTS, flat, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.reference import frames

ALONG_X = """nsl 1
frame 4 slots of 1ms
code stop : 0..4
open when n < stop
pixels stop = x % 5
"""
ALONG_Y = ALONG_X.replace("x % 5", "y % 5")
LONG = 4096


def light(rows: int, cols: int) -> Light:
    values = np.random.default_rng(3).uniform(0, 3000, (SLOTS, LONG)).astype(np.float32)
    return Light.of_clip(values.reshape(SLOTS, rows, cols))


@pytest.mark.parametrize("effects", ["none", "crosstalk", "crosstalk,full_well,register"])
def test_case_33_a_row_and_a_column_give_the_same_exposures(effects: str) -> None:
    """Noise is left out, because random numbers depend on the place of a pixel."""
    row, column = program(ALONG_X, "edges", 1, LONG), program(ALONG_Y, "edges", LONG, 1)
    sensor = sensor_of(row)
    first = capture(row, light(1, LONG), sensor=sensor, effects=effects)
    second = capture(column, light(LONG, 1), sensor=sensor, effects=effects)
    np.testing.assert_allclose(
        first.exposure_e.reshape(-1), second.exposure_e.reshape(-1), rtol=1e-6
    )


@pytest.mark.parametrize("size", [(1, LONG), (LONG, 1), (1, 1)])
def test_case_33_every_effect_gives_finite_numbers(size: tuple[int, int]) -> None:
    container = program(ALONG_X.replace("x % 5", "(x + y) % 5"), "edges", *size)
    sensor = sensor_of(container)
    assert capture(container, flat(2000, *size), sensor=sensor, effects="all").valid.all()
    # Random effects draw other numbers.
    fixed = "all,-shot,-dark,-read,-reset,-analog"
    (by_words,) = frames(container, flat(2000, *size), sensor, selected(fixed))
    found = capture(container, flat(2000, *size), sensor=sensor, effects=fixed)
    assert found.valid.all()
    error = found.exposure_e - by_words.exposure_e
    assert np.sqrt(np.mean(error**2)) < 0.01
    if size != (1, 1):
        crossing = capture(container, flat(2000, *size), sensor=sensor, effects="crosstalk")
        plain = capture(container, flat(2000, *size), sensor=sensor, effects="none")
        np.testing.assert_allclose(crossing.exposure_e, plain.exposure_e, rtol=1e-9)
