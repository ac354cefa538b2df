"""Hard case 4: one frame that spans 1e-6 .. 1e8 electrons: finite and accurate at every pixel."""

from __future__ import annotations

from math import fsum

import numpy as np
import pytest
from reference_exposure import expose as by_reference
from reference_programs import LOWERINGS, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import optional, selected
from nscc_runtime.emulator import expose
from nscc_runtime.frame_file import read_out
from nscc_runtime.light import Light
from nscc_runtime.reference import frames as by_reference_read_out

ROWS, COLS, SLOTS = 12, 60, 4
TEXT = "nsl 1\nframe 4 slots of 1ms\ncode stop : 1..4\nopen when n < stop\npixels stop = 1 + x % 4"


def light() -> Light:
    """Every decade in every row; from slot to slot each pixel changes by five decades."""
    decades = np.linspace(-6, 8, ROWS * COLS).reshape(COLS, ROWS).T
    change = np.array([0.0, -5.0, 3.0, 1.0])[:, None, None]
    return Light.of_clip((10.0 ** np.clip(decades + change, -6, 8)).astype(np.float32))


def truth() -> np.ndarray:
    values = light().frames.astype(float)
    sums = np.zeros((ROWS, COLS))
    for y, x in np.ndindex(ROWS, COLS):
        sums[y, x] = fsum(values[: 1 + x % 4, y, x])
    return sums


def test_case_04_float16_could_not_hold_the_light() -> None:
    halves = light().frames.astype(np.float32)
    assert halves.max() > np.finfo(np.float16).max
    assert halves.min() < np.finfo(np.float16).smallest_subnormal * 20


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_case_04_exposures_are_exact(lowering: str) -> None:
    container = program(TEXT, lowering, ROWS, COLS)
    for found in (
        expose(container, light()),
        by_reference(container, light(), sensor_of(container), selected("none")),
    ):
        assert found.valid.all()
        # Light that falls on a closed shutter is subtracted: it counts with its rounding alone.
        slack = 1e-15 * light().total_e()
        assert (np.abs(found.exposure_e[0] - truth()) <= 1e-6 * truth() + slack).all()


def test_case_04_codes_are_exact() -> None:
    container = program(TEXT, "accumulate", ROWS, COLS)
    frame = read_out(expose(container, light()), container.target)
    expected = np.minimum(np.rint(truth() / (30000 / 255)), 255)
    assert np.abs(frame.frame[0] - expected).max() == 0


@pytest.mark.parametrize("effect", [*optional(), "all"])
def test_case_04_every_effect_stays_finite(effect: str) -> None:
    container = program(TEXT, "edges", ROWS, COLS)
    chosen = selected(f"none,{effect}" if effect != "all" else "all")
    (found,) = by_reference_read_out(container, light(), sensor_of(container), chosen)
    assert np.isfinite(found.exposure_e).all()
    assert found.valid.all()


# The brightest pixels are black suns, and that is said.
@pytest.mark.filterwarnings("ignore:warning.NS0793")
@pytest.mark.parametrize("lowering", LOWERINGS)
def test_case_04_planned_frames_are_exact(lowering: str) -> None:
    container = program(TEXT, lowering, ROWS, COLS)
    plain = capture(container, light(), effects="none")
    assert plain.valid.all()
    np.testing.assert_allclose(plain.exposure_e[0], truth(), rtol=1e-6)
    # Everything kept, counted, saturated: no warning of numpy, no number that is none.
    with np.errstate(all="raise", under="ignore"):
        found = capture(container, light(), tolerance="0.5e")
    assert found.valid.all()
    assert np.isfinite(found.exposure_e).all()
