"""Hard case 32: 4096 slots, 1e8 electrons and 0.1 by turns: the small ones are not lost."""

from __future__ import annotations

import math

import numpy as np
import pytest
from reference_exposure import expose as reference
from reference_programs import LOWERINGS, program, sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.emulator import expose
from nscc_runtime.light import Light

SLOTS = 4096
LARGE, SMALL = np.float32(1e8), np.float32(0.1)
OPEN = f"nsl 1\nframe {SLOTS} slots of 100us\nopen when n < {SLOTS}\n"
ODD = f"nsl 1\nframe {SLOTS} slots of 100us\nopen when n % 2 == 1\n"


def light() -> Light:
    frames = np.empty((SLOTS, 2, 3), np.float32)
    frames[0::2], frames[1::2] = LARGE, SMALL
    return Light.of_clip(frames)


@pytest.mark.parametrize("lowering", LOWERINGS)
def test_case_32_the_sum_is_exact(lowering: str) -> None:
    container = program(OPEN, lowering, 2, 3)
    wanted = math.fsum([float(LARGE), float(SMALL)] * (SLOTS // 2))
    for found in (expose(container, light()), capture(container, light(), effects="none")):
        np.testing.assert_allclose(found.exposure_e, wanted, rtol=1e-12)
        lost = wanted - found.exposure_e
        assert np.abs(lost).max() < 0.01 * float(SMALL) * SLOTS / 2


def test_case_32_small_slots_are_exact_between_large_closed_ones() -> None:
    """The shutter is closed in the large slots, and PIX is reset in between. The error is bounded
    by a fraction of the light of the whole frame."""
    container = program(ODD, "accumulate", 2, 3)
    wanted = math.fsum([float(SMALL)] * (SLOTS // 2))
    total = math.fsum([float(LARGE)] * (SLOTS // 2))
    found = capture(container, light(), effects="none")
    np.testing.assert_allclose(found.exposure_e, wanted, rtol=0, atol=1e-13 * total)
    by_words = reference(container, light(), sensor_of(container), selected("none"))
    np.testing.assert_allclose(by_words.exposure_e, wanted, rtol=1e-12)
