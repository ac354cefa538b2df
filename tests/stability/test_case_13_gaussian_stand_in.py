"""Hard case 13: where the fast sampler is a formula of a normal number, it is nearly Poisson.

Every rate: below its crossover the fast sampler is exact. The moments are worked out from the
distribution of the sampler, not from draws.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from drawn_counts import by_plan, by_reference
from noise_oracle import fast_distribution
from scipy.stats import poisson as law

from nscc_runtime.noise import key


@pytest.mark.parametrize("rate", [10.0, 10.2, 11.0, 13.0, 15.99, 16.0, 20.0, 80.0, 1000.0, 30000.0])
def test_case_13_the_approximation_is_near_the_poisson_law(rate):
    counts = np.arange(int(rate + 9 * math.sqrt(rate) + 30))
    reached = fast_distribution(rate, counts)
    masses = np.diff(reached, prepend=0.0)
    mean = (counts * masses).sum()
    variance = ((counts - mean) ** 2 * masses).sum()
    assert abs(mean - rate) < 1e-3 * math.sqrt(rate)
    assert abs(variance / rate - 1) < 0.01
    assert np.abs(masses - law.pmf(counts, rate)).sum() / 2 < 5e-3


def test_case_13_a_small_rate_is_drawn_exactly():
    n = 200_000
    for rate in (0.5, 5.0, 9.99):
        rates = np.full(n, rate)
        fast, exact = (drawn(key(1, 1), np.arange(n), rates) for drawn in (by_plan, by_reference))
        assert np.array_equal(fast, exact)
        assert abs(fast.mean() - rate) < 5 * math.sqrt(rate / n)
