"""Hard case 2: 1e8 electrons followed by 4095 single ones: all are counted, in any order."""

from __future__ import annotations

import numpy as np
import pytest
from reference_exposure import expose as by_reference
from reference_programs import LOWERINGS, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light

SLOTS, LARGE = 4096, 10**8
PLACES = (0, 1, 2047, 4094, 4095)
"""In which slot the large one falls, by column."""
OPEN = f"nsl 1\nframe {SLOTS} slots of 100us\nopen when n < {SLOTS}\n"
LATE = f"nsl 1\nframe {SLOTS} slots of 100us\nopen when n >= 1\n"


def light() -> Light:
    frames = np.ones((SLOTS, 1, len(PLACES)), np.float32)
    for column, place in enumerate(PLACES):
        frames[place, 0, column] = LARGE
    return Light.of_clip(frames)


def test_case_02_a_plain_float32_sum_would_lose_the_small_slots() -> None:
    assert light().frames.sum(axis=0)[0, 0] == LARGE


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_case_02_all_slots_open_give_the_exact_sum(lowering: str) -> None:
    found = expose(program(OPEN, lowering, 1, len(PLACES)), light()).exposure_e[0, 0]
    np.testing.assert_allclose(found, LARGE + SLOTS - 1, rtol=1e-12)
    assert np.all(np.rint(found) == LARGE + SLOTS - 1)


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
def test_case_02_large_charge_before_the_shutter_opens_is_subtracted_exactly(lowering: str) -> None:
    """Charge from before the shutter opens is subtracted, and the single electrons remain."""
    found = expose(program(LATE, lowering, 1, len(PLACES)), light()).exposure_e[0, 0]
    wanted = [SLOTS - 1, *[LARGE + SLOTS - 2] * (len(PLACES) - 1)]
    np.testing.assert_allclose(found, wanted, rtol=1e-6)


def test_case_02_the_reference_and_the_truth_keep_the_small_slots() -> None:
    container = program(OPEN, "edges", 1, len(PLACES))
    found = by_reference(container, light(), sensor_of(container), selected("none"))
    np.testing.assert_allclose(found.exposure_e[0, 0], LARGE + SLOTS - 1, rtol=1e-12)
    np.testing.assert_array_equal(light().total_e(), LARGE + SLOTS - 1)


@pytest.mark.parametrize("text", [OPEN, LATE])
def test_case_02_planned_frames_are_exact(text: str) -> None:
    opened = light().frames[1 if text == LATE else 0 :].astype(np.float64).sum(axis=0)
    found = capture(program(text, "edges", 1, len(PLACES)), light(), effects="none").exposure_e[0]
    np.testing.assert_allclose(found, opened, rtol=1e-6)
