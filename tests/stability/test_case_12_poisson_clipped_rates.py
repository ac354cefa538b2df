"""Hard case 12: rates 1e15, 1e19, inf: clipped at the stated cap before a count is drawn."""

from __future__ import annotations

import math
import sys

import numpy as np

from nscc_runtime.noise import RATE_CAP, key, poisson


def test_case_12_rates_above_the_cap_give_the_counts_of_the_cap():
    n = 5000
    pixels = np.arange(n)
    expected, _ = poisson(key(1, 1), pixels, np.full(n, RATE_CAP))
    assert np.all(np.abs(expected - RATE_CAP) < 10 * math.sqrt(RATE_CAP))
    assert expected.std() > 0.9 * math.sqrt(RATE_CAP)
    for rate in (math.nextafter(RATE_CAP, math.inf), 1e15, 1e19, sys.float_info.max, math.inf):
        counts, valid = poisson(key(1, 1), pixels, np.full(n, rate))
        assert valid.all()
        assert np.array_equal(counts, expected)
