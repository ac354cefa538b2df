"""Hard case 27: compiled loops keep the meaning of NaN and of infinity, to the pixel."""

from __future__ import annotations

import numpy as np
import pytest
from reference_programs import LOWERINGS, program, sensor_of

from nscc_runtime.effects import selected
from nscc_runtime.emulator import expose
from nscc_runtime.frame_file import read_out
from nscc_runtime.light import Light
from nscc_runtime.noise import key, normals, poisson
from nscc_runtime.reference import frames as by_reference

ROWS, COLS, SLOTS = 9, 70, 4
TEXT = "nsl 1\nframe 4 slots of 1ms\ncode stop : 0..4\nopen when n < stop\npixels stop = x % 5\n"
BAD = (np.nan, -np.nan, np.inf)


def light(bad: float, slot: int) -> tuple[Light, np.ndarray]:
    """Ordinary light with `bad` in every seventh pixel of one slot; where that is."""
    values = np.random.default_rng(1).uniform(1, 1000, (SLOTS, ROWS, COLS)).astype(np.float32)
    where = np.arange(ROWS * COLS).reshape(ROWS, COLS) % 7 == 3
    values[slot][where] = bad
    return Light.of_clip(values), where


@pytest.mark.parametrize("bad", BAD, ids=["nan", "-nan", "inf"])
@pytest.mark.parametrize("slot", range(SLOTS))
@pytest.mark.parametrize("lowering", LOWERINGS)
def test_case_27_the_emulator_marks_pixels_that_nan_or_infinity_reaches(
    lowering: str, slot: int, bad: float
) -> None:
    container = program(TEXT, lowering, ROWS, COLS)
    seen, where = light(bad, slot)
    found = expose(container, seen)
    stop = np.arange(COLS)[None, :] % 5 + np.zeros((ROWS, 1), int)
    reached = where & (slot < stop)
    assert not found.valid[0][reached].any()
    assert found.valid[0][~where].all()
    clean = np.where(np.arange(SLOTS)[:, None, None] < stop, seen.frames.astype(float), 0.0)
    good = ~where
    np.testing.assert_allclose(found.exposure_e[0][good], clean.sum(axis=0)[good], rtol=1e-9)
    # A pixel that never opens is +0, whatever falls on it.
    assert np.array_equal(found.exposure_e[0][stop == 0], np.zeros((stop == 0).sum()))
    frame = read_out(found, container.target)
    numbers = np.isnan(found.exposure_e)
    assert np.all(frame.frame[numbers] == 0)
    assert not frame.valid[numbers].any()


@pytest.mark.parametrize("effects", ["shot", "shot,dark,prnu", "all,-crosstalk"])
def test_case_27_the_reference_marks_pixels_that_nan_reaches(effects: str) -> None:
    container = program(TEXT, "edges", ROWS, COLS)
    seen, where = light(np.nan, 0)
    (found,) = by_reference(container, seen, sensor_of(container), selected(effects))
    opened = np.arange(COLS)[None, :] % 5 > 0
    assert not found.valid[0][where & opened].any()
    assert found.valid[0][~where].all()
    assert np.isfinite(found.exposure_e[0][~where]).all()


def test_case_27_samplers_mark_counts_of_nan_rates() -> None:
    rates = np.full(1000, 5.0)
    rates[::3], rates[1::3] = np.nan, np.inf
    counts, valid = poisson(key(1, 1), np.arange(1000), rates)
    assert not valid[::3].any()
    assert valid[1::3].all()
    assert valid[2::3].all()
    assert np.isfinite(counts[valid]).all()
    assert np.isfinite(normals(key(1, 1), np.arange(10_000))).all()
