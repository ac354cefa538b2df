"""Hard case 11: rate 1e9: mean and variance are the rate."""

from __future__ import annotations

import math

import numpy as np
import pytest
from drawn_counts import BOTH

from nscc_runtime.noise import key


@pytest.mark.parametrize("drawn", BOTH)
def test_case_11_mean_and_variance_equal_the_rate(drawn):
    n, rate = 200_000, 1e9
    counts = drawn(key(1, 1), np.arange(n), np.full(n, rate))
    assert np.array_equal(counts, np.floor(counts))
    assert abs(counts.mean() - rate) < 5 * math.sqrt(rate / n)
    assert abs(counts.var() / rate - 1) < 0.016
