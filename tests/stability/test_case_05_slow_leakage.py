"""Hard case 5: a register that loses 1e-8 a slot, over 4096 slots: exp(N log1p(-k))."""

from __future__ import annotations

from decimal import Decimal, getcontext

import numpy as np
import pytest
from reference_exposure import expose
from reference_programs import program, sensor_of

from nscc_runtime import capture
from nscc_runtime.effects import selected
from nscc_runtime.light import Light

getcontext().prec = 50
SLOTS, SLOT_US, ELECTRONS = 4096, 100.0, 10_000.0


def exposed(tau_s: float) -> float:
    """A pixel that is open in slot 0 and then waits; its charge lies in a register."""
    text = f"nsl 1\nframe {SLOTS} slots of 100us\nopen when n < 1\n"
    container = program(text, "accumulate", 1, 2)
    light = np.zeros((SLOTS, 1, 2), np.float32)
    light[0] = ELECTRONS
    sensor = sensor_of(container, leakage_tau_s=tau_s, leakage_spread_fraction=0.0)
    found = expose(container, Light.of_clip(light), sensor, selected("leakage"))
    return float(found.exposure_e[0, 0, 0])


@pytest.mark.parametrize("a_slot", [1e-8, 1e-10, 1e-4, 0.1])
def test_case_05_the_charge_left_and_the_charge_lost_are_exact(a_slot: float) -> None:
    found = exposed(SLOT_US * 1e-6 / a_slot)
    # Read at boundary 1, so 4095 slots old at the end.
    kept = (-Decimal(a_slot) * (SLOTS - 1)).exp()
    wanted = Decimal(ELECTRONS) * kept
    assert found == pytest.approx(float(wanted), rel=1e-6, abs=1e-9)
    lost = Decimal(ELECTRONS) - wanted
    assert ELECTRONS - found == pytest.approx(float(lost), rel=1e-3)


def test_case_05_plain_float32_factors_would_lose_the_leakage() -> None:
    assert np.float32(1) - np.float32(1e-8) == 1


@pytest.mark.parametrize("a_slot", [1e-8, 1e-4, 0.1])
def test_case_05_planned_frames_lose_what_leaks(a_slot: float) -> None:
    container = program(
        f"nsl 1\nframe {SLOTS} slots of 100us\nopen when n < 1\n", "accumulate", 1, 2
    )
    light = np.zeros((SLOTS, 1, 2), np.float32)
    light[0] = ELECTRONS
    sensor = sensor_of(
        container, leakage_tau_s=SLOT_US * 1e-6 / a_slot, leakage_spread_fraction=0.0
    )
    found = capture(container, light, sensor=sensor, effects="leakage").exposure_e[0, 0, 0]
    wanted = Decimal(ELECTRONS) * (-Decimal(a_slot) * (SLOTS - 1)).exp()
    assert found == pytest.approx(float(wanted), rel=1e-6, abs=1e-9)
