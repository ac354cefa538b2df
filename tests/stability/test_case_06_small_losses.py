"""Hard case 6: 1 - exp(-x) at x = 1e-9 is -expm1(-x), in what leaks away and in what is counted."""

from __future__ import annotations

from decimal import Decimal, getcontext

import numpy as np
import pytest
from reference_exposure import expose
from reference_programs import program, sensor_of

from nscc_runtime.effects import selected
from nscc_runtime.effects.spread import log_normal
from nscc_runtime.light import Light
from nscc_runtime.noise.poisson_law import poisson_exact

getcontext().prec = 50
ELECTRONS = 20_000.0


def lost_part(x: float) -> float:
    """1 - exp(-x) from fifty digits."""
    return float(1 - (-Decimal(x)).exp())


@pytest.mark.parametrize("x", [1e-9, 1e-8, 1e-6, 1e-3])
def test_case_06_the_charge_that_leaks_is_exact(x: float) -> None:
    text = "nsl 1\nframe 2 slots of 1ms\nopen when n < 1\n"
    container = program(text, "accumulate", 1, 2)
    light = np.array([[[ELECTRONS] * 2], [[0.0] * 2]], np.float32)
    # Written at boundary 1: one slot of 1 ms passes before the readout.
    sensor = sensor_of(container, leakage_tau_s=1e-3 / x, leakage_spread_fraction=0.0)
    kept, whole = (
        expose(container, Light.of_clip(light), sensor, selected(effects)).exposure_e[0, 0, 0]
        for effects in ("leakage", "none")
    )
    assert whole == ELECTRONS
    assert ELECTRONS - kept == pytest.approx(ELECTRONS * lost_part(x), rel=1e-6)


@pytest.mark.parametrize("x", [1e-9, 1e-6, 1e-3])
def test_case_06_the_chance_of_any_electron_is_exact(x: float) -> None:
    """The uniform number from which on a rate of x gives no electron."""
    low, high = 0.0, 1.0
    # A count is monotone in the uniform number, up or down: bisect for where it leaves 0.
    rising = poisson_exact(1.0 - 2.0**-53, x) > 0
    for _ in range(200):
        middle = (low + high) / 2
        if (poisson_exact(middle, x) > 0) == rising:
            high = middle
        else:
            low = middle
    chance = 1 - high if rising else low
    assert chance == pytest.approx(lost_part(x), rel=1e-6)


@pytest.mark.parametrize("fraction", [1e-9, 1e-6, 1e-3])
def test_case_06_narrow_lognormal_spreads_keep_their_digits(fraction: float) -> None:
    """The lognormal spread of dark currents takes log1p of a square that 1 + would lose."""
    z = np.array([-2.0, -1.0, 1.0, 2.0])
    np.testing.assert_allclose(
        log_normal(fraction, z) - 1, fraction * z, rtol=2 * fraction + 1e-15 / fraction
    )
