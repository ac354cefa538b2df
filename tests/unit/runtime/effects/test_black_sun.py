"""Light that falls between a reset and the word that reads its level: the black sun."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from plan_cases import CASES, case
from reference_programs import program, sensor_of

import nscc_runtime
from nscc.words.container import Container
from nscc_runtime.captured import Capture
from nscc_runtime.effects import marks
from nscc_runtime.light import Light

SLOTS, ROWS, COLS = 8, 6, 8
SUN = 2, 3
FULL_E = 30000.0
COUNTLESS = "all,-shot,-dark"
"""Counts are drawn for other intervals than in the reference."""
EXACT = "full_well,dead_time,black_sun"
LOOKING = """nsl 2
frame 8 slots of 500us
sense bright when light > 45% at n in [1, 4]
state closed : 0..2 = 0
next closed = looks when bright and closed == 0
open when closed == 0
read closed
"""


def sun(slot_e: float) -> Light:
    """A dim scene with one bright pixel, electrons a slot."""
    frames = np.full((SLOTS, ROWS, COLS), 100.0, np.float32)
    frames[:, *SUN] = slot_e
    return Light.of_clip(frames)


def taken(
    container: Container, slot_e: float, effects: str, said: str = "", **options: object
) -> Capture:
    """A capture, which warns of black suns in these words or not at all."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = nscc_runtime.capture(
            container, sun(slot_e), sensor=sensor_of(container), effects=effects, **options
        )  # type: ignore[arg-type]
    found_words = [str(each.message).splitlines()[0] for each in caught]
    assert found_words == ([f"warning[NS0793]: {said}"] if said else [])
    return found


ONE = (
    "1 pixel reads less than it received, possibly 0: light had filled PIX before the reset level "
    "was read"
)


def test_the_level_holds_the_light_since_the_reset_and_at_most_a_full_well() -> None:
    """The subtracted level grows with the light until PIX is full when it is read."""
    container, exact = case("a", SLOTS, rows=ROWS, cols=COLS), {"fidelity": "reference"}

    def lost_e(slot_e: float, said: str = "") -> float:
        with_it = taken(container, slot_e, EXACT, said, **exact)
        without = taken(container, slot_e, EXACT.replace(",black_sun", ""), **exact)
        return float((without.exposure_e - with_it.exposure_e)[0, *SUN])

    part = lost_e(1000.0) / 1000.0
    assert 0.0 < part < 0.01
    for slot_e in (1e4, 1e6):
        assert lost_e(slot_e) == pytest.approx(part * slot_e, rel=1e-6)
    eaten_e = FULL_E / part
    assert lost_e(0.99 * eaten_e) == pytest.approx(0.99 * FULL_E, rel=1e-6)
    for slot_e in (1.01 * eaten_e, 1e12):
        assert lost_e(slot_e, ONE) == pytest.approx(FULL_E, rel=1e-9)


@pytest.mark.parametrize("effects", [f"{COUNTLESS},-black_sun", EXACT, "dead_time", COUNTLESS])
@pytest.mark.parametrize("name", ["b edges", "d accumulate", "two buckets"])
def test_loops_do_to_a_sun_what_the_reference_does(name: str, effects: str) -> None:
    """The planned loop and the word-by-word reference agree on a very bright pixel. It turns black
    only where `black_sun` acts."""
    container = case(name, SLOTS, rows=ROWS, cols=COLS)
    black = effects in (COUNTLESS, EXACT)
    words = taken(container, 3e8, effects, ONE if black else "", fidelity="reference")
    planned = taken(container, 3e8, effects, ONE if black else "", tolerance=1e-6)
    # Pixels far from saturation draw the noise of their words at once.
    np.testing.assert_allclose(
        planned.exposure_e[:, *SUN], words.exposure_e[:, *SUN], rtol=1e-9, atol=1e-3
    )
    np.testing.assert_array_equal(planned.saturated_by, words.saturated_by)
    bit = marks()["level"].bit
    black_pixels = np.argwhere((words.saturated_by & bit).any(axis=0))
    assert black_pixels.tolist() == ([[*SUN]] if black else [])


@pytest.mark.parametrize("effects", [f"{COUNTLESS},-black_sun", COUNTLESS])
def test_pixels_that_look_show_the_black_sun(effects: str) -> None:
    """In a program whose pixels look at the light, plan and reference agree, with the effect
    `black_sun` and without."""
    container = program(LOOKING, rows=ROWS, cols=COLS)
    said = ONE if effects == COUNTLESS else ""
    words = taken(container, 3e9, effects, said, fidelity="reference")
    planned = taken(container, 3e9, effects, said, tolerance=1e-6)
    np.testing.assert_allclose(planned.exposure_e, words.exposure_e, rtol=1e-9, atol=1e-3)
    np.testing.assert_array_equal(planned.saturated_by, words.saturated_by)


@pytest.mark.parametrize("name", CASES)
def test_plans_predict_the_error_of_leaving_out_the_black_sun(name: str) -> None:
    """In dim light the prediction equals the difference of frames with and without the effect."""
    container = case(name, SLOTS, rows=ROWS, cols=COLS)
    plan = nscc_runtime.plan(container, sun(2000.0), sensor=sensor_of(container), tolerance="5e")
    [row] = [each for each in plan.decisions if each.name == "black_sun"]
    full, less = (
        taken(container, 2000.0, effects, fidelity="reference").exposure_e
        for effects in ("all", "all,-black_sun")
    )
    rms = np.sqrt(((full - less) ** 2).mean(axis=(1, 2))).max()
    assert row.predicted_rms_e == pytest.approx(rms, rel=0.05, abs=1e-3)


@pytest.mark.filterwarnings("ignore:warning.NS0793")
def test_a_plan_has_a_sun_in_a_dim_scene() -> None:
    """One pixel loses a full well, which exceeds the tolerance."""
    container = case("b edges", SLOTS, rows=ROWS, cols=COLS)
    sensor = sensor_of(container, crosstalk_fraction=0.0)
    bright = nscc_runtime.plan(container, sun(3e9), sensor=sensor, tolerance="20e")
    assert "black_sun" in bright.kept.on
    planned = nscc_runtime.capture(container, sun(3e9), sensor=sensor, plan=bright, audit=True)
    assert planned.audit.holds
    assert (planned.saturated_by & marks()["level"].bit).any(axis=0).sum() == 1
