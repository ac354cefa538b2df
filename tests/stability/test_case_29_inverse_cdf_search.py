"""Hard case 29: the search ends, and the variance is right as well as the mean."""

from __future__ import annotations

import math

import numpy as np
import pytest
from drawn_counts import BOTH, by_reference

from nscc_runtime.noise import key
from nscc_runtime.noise.poisson_law import poisson_exact

BLOCK = 1_000_000


def check_moments(rate, blocks, drawn):
    rates = np.full(BLOCK, rate)
    total = squares = 0.0
    for block in range(blocks):
        pixels = np.arange(block * BLOCK, (block + 1) * BLOCK)
        counts = drawn(key(29, 1), pixels, rates)
        total += counts.sum()
        squares += (counts * counts).sum()
    n = blocks * BLOCK
    mean = total / n
    variance = squares / n - mean * mean
    assert abs(mean - rate) < 5 * math.sqrt(rate / n)
    assert abs(variance - rate) < 5 * math.sqrt((rate + 2 * rate * rate) / n)


@pytest.mark.slow
@pytest.mark.parametrize("drawn", BOTH)
@pytest.mark.parametrize("rate", [1e-3, 0.1, 1.0, 12.0])
def test_case_29_moments_of_50_million_counts_equal_the_law(rate, drawn):
    check_moments(rate, 50, drawn)


@pytest.mark.parametrize("rate", [1e-3, 0.1, 1.0, 12.0])
def test_case_29_moments_are_those_of_the_law(rate):
    check_moments(rate, 3, by_reference)


def test_case_29_the_search_ends_at_every_rate_and_at_both_ends_of_the_uniform_number():
    ends = [2.0**-k for k in range(1, 54)]
    for rate in (
        0.0,
        5e-324,
        1e-300,
        1e-17,
        1e-16,
        0.1,
        9.999999,
        10.0,
        11.0,
        999_999.0,
        1e6,
        1e12,
    ):
        for u in ends:
            low, high = poisson_exact(u, rate), poisson_exact(1 - u, rate)
            assert 0 <= low <= high <= rate + 9 * math.sqrt(rate) + 15 + (16 if rate > 1 else 0)
