"""Poisson counts: exact where promised, near enough where not, and never out of order."""

from __future__ import annotations

import math

import numpy as np
import pytest
from drawn_counts import BOTH
from noise_oracle import fast_distribution
from scipy import stats
from scipy.special import gammainc, gammaincc, ndtr, ndtri
from scipy.stats import poisson as law

from nscc_runtime.noise import key, poisson, uniforms
from nscc_runtime.noise.poisson_law import (
    SEARCH_BELOW,
    SETTLED_ABOVE,
    poisson_exact,
    quantile,
    search,
)

STEP = 2.0**-53
RATES = (1e-6, 0.3, 1.0, 4.5, 9.999, 10.0, 10.5, 13.0, 16.0, 31.0, 100.0, 3000.0, 5e5)


def some_uniforms():
    """Numbers everywhere, and far more than their share at both ends."""
    rng = np.random.default_rng(17)
    ends = 2.0 ** rng.uniform(-52, -1, 1500)
    return np.concatenate([[STEP, 1 - STEP, 0.5], rng.random(3000), ends, 1 - ends]).clip(STEP)


@pytest.mark.parametrize("rate", RATES)
def test_exact_is_the_smallest_count_that_reaches_u(rate):
    """The count's distribution reaches u, and that of the count before it does not, by scipy's
    tails."""
    for u in some_uniforms():
        count = poisson_exact(u, rate)
        # On either side the smaller tail, which is the one that is known accurately.
        if u < 0.5:
            assert law.cdf(count, rate) >= u * (1 - 1e-10)
            assert count == 0 or law.cdf(count - 1, rate) < u * (1 + 1e-10)
        else:
            margin = 1e-10 * (1 - u) + 4 * STEP
            assert law.sf(count, rate) <= 1 - u + margin
            assert count == 0 or law.sf(count - 1, rate) > 1 - u - margin


@pytest.mark.parametrize("rate", [10.0, 11.0, 20.0, 60.0, 200.0, 5000.0])
def test_error_of_the_formula_is_as_stated(rate):
    z = np.linspace(-8.2, 8.2, 165)
    low, high = np.full(len(z), 1e-9), np.full(len(z), rate + 20 * math.sqrt(rate) + 60)
    for _ in range(100):
        middle = (low + high) / 2
        over = np.where(
            z < 0, gammaincc(middle, rate) >= ndtr(z), gammainc(middle, rate) <= ndtr(-z)
        )
        low, high = np.where(over, low, middle), np.where(over, middle, high)
    error = np.abs(quantile.function(z, rate) - high)
    bound = 0.012 * (1 + np.abs(z) ** 5) / rate**1.5
    assert np.all((error <= bound)[high > 0.5])
    # Where the count is 0 the formula must say so too.
    assert np.all(quantile.function(z, rate)[high <= 0.5] < 1)


@pytest.mark.parametrize("rate", [10.0, 10.001, 10.5, 12.0, 15.999, 16.0, 20.0, 50.0, 1000.0])
def test_total_variation_of_the_fast_sampler_is_as_stated(rate):
    """The fast sampler's probabilities differ from the law's by less than 2e-4 in sum, from a rate
    of 10 on."""
    counts = np.arange(int(rate + 12 * math.sqrt(rate) + 20))
    masses = np.diff(fast_distribution(rate, counts), prepend=0.0)
    variation = np.abs(masses - law.pmf(counts, rate)).sum() / 2
    assert variation < 2e-4


def test_distribution_never_grows_with_the_rate():
    """A count reached at one rate is reached at each greater one: for every u, not for some."""
    counts = np.arange(80)
    rates = np.concatenate(
        [
            np.linspace(9, SEARCH_BELOW, 50)[:-1],
            SEARCH_BELOW + np.logspace(-12, 0, 60),
            np.linspace(11, SETTLED_ABOVE, 200)[1:-1],
            SETTLED_ABOVE + np.array([-1e-9, 0.0, 1e-9]),
            np.linspace(SETTLED_ABOVE + 0.01, 60, 400),
        ]
    )
    reached = np.array([fast_distribution(rate, counts) for rate in rates])
    assert np.all(np.diff(reached, axis=0) <= 1e-14)


def test_searching_at_the_crossover_never_passes_the_formula_above():
    for rate in np.linspace(SETTLED_ABOVE, 40, 25):
        for u in some_uniforms():
            formula = math.floor(quantile.function(ndtri(u), rate))
            assert search(u, SEARCH_BELOW) <= max(formula, 0)


@pytest.mark.parametrize("drawn", BOTH)
@pytest.mark.parametrize("rate", [0.02, 0.7, 3.0, 9.5, 10.0, 14.0, 16.0, 40.0, 900.0])
def test_drawn_counts_have_the_poisson_distribution(rate, drawn):
    n = 300_000
    counts = drawn(key(21, 4), np.arange(n), np.full(n, rate))
    assert np.array_equal(counts, np.floor(counts))
    assert abs(counts.mean() - rate) < 5 * math.sqrt(rate / n)
    assert abs(counts.var() - rate) < 5 * math.sqrt((rate + 2 * rate * rate) / n)
    edges = np.unique(law.ppf(np.linspace(0.02, 0.98, 25), rate))
    expected = np.diff(np.concatenate([[0.0], law.cdf(edges, rate), [1.0]])) * n
    found = np.bincount(np.searchsorted(edges, counts), minlength=len(expected))
    assert stats.chisquare(found, expected).pvalue > 1e-4


def test_arrays_take_the_sampler_of_each_pixel():
    rng = np.random.default_rng(2)
    rates = 10.0 ** rng.uniform(-3, 7, (40, 50))
    pixels = rng.permutation(2000).reshape(40, 50)
    counts, _ = poisson(key(1, 9), pixels, rates)
    u = uniforms(key(1, 9), pixels)
    expected = [poisson_exact(float(a), float(b)) for a, b in zip(u.flat, rates.flat, strict=True)]
    assert counts.reshape(-1).tolist() == expected
