"""Hard case 9: Poisson rate 0, -0.0, -1e-12, NaN: 0, 0, clamped, flagged."""

from __future__ import annotations

import math

import numpy as np
import pytest
from drawn_counts import BOTH

from nscc_runtime.noise import key, poisson


@pytest.mark.parametrize("drawn", BOTH)
@pytest.mark.parametrize("beside", [1.0, 1000.0], ids=["few", "many"])
def test_case_09_zero_negative_and_nan_rates_give_no_count(drawn, beside):
    odd = [0.0, -0.0, -1e-12, -10.0, -math.inf, 5e-324, math.nan]
    rate = np.array([*odd * 1000, beside])
    counts = drawn(key(1, 1), np.arange(len(rate)), rate)
    assert not counts[:-1].any()
    assert not np.signbit(counts).any()
    assert np.array_equal(poisson(key(1, 1), np.arange(len(rate)), rate)[1], ~np.isnan(rate))
    assert counts[-1] == drawn(key(1, 1), np.array([7000]), rate[-1:])
