"""Binomial counts and the spreading of a count over slots."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import stats
from scipy.stats import binom as law

from nscc_runtime.noise import key, poisson, thin
from nscc_runtime.noise.binomial_law import binomial, quantile

STEP = 2.0**-53
CASES = (
    (1.0, 0.3), (2.0, 0.5), (7.0, 0.9), (19.0, 0.5), (20.0, 0.5), (40.0, 0.3), (33.0, 0.6),
    (200.0, 0.04), (200.0, 0.06), (1000.0, 0.25), (1000.0, 0.999), (5000.0, 0.5),
    (1e5, 1e-5), (1e5, 3e-4), (1e6, 0.125), (1e6, 1 - 1e-6),
)  # fmt: skip

COMPARED = (
    (25.0, 0.4), (25.0, 0.5), (100.0, 0.1), (100.0, 0.25), (100.0, 0.5), (1000.0, 0.01),
    (1000.0, 0.1), (1000.0, 0.4), (1e4, 0.001), (1e4, 0.01), (1e4, 0.25), (1e4, 0.5),
)  # fmt: skip


def some_uniforms():
    rng = np.random.default_rng(19)
    ends = 2.0 ** rng.uniform(-52, -1, 600)
    return np.concatenate([[STEP, 1 - STEP, 0.5], rng.random(1200), ends, 1 - ends]).clip(STEP)


@pytest.mark.parametrize(("n", "p"), CASES)
def test_the_smallest_count_that_reaches_u(n, p):
    for u in some_uniforms():
        count = binomial(u, n, p)
        if u < 0.5:
            margin = 1e-9 * u + 4 * STEP
            assert law.cdf(count, n, p) >= u - margin
            assert count == 0 or law.cdf(count - 1, n, p) < u + margin
        else:
            margin = 1e-9 * (1 - u) + 4 * STEP
            assert law.sf(count, n, p) <= 1 - u + margin
            assert count == 0 or law.sf(count - 1, n, p) > 1 - u - margin


@pytest.mark.parametrize(("n", "p"), COMPARED)
def test_error_of_the_formula_is_within_what_is_checked(n, p):
    counts = np.arange(int(n))
    below, above = law.cdf(counts, n, p), law.sf(counts, n, p)
    inside = (below > 2e-16) & (above > 2e-16)
    z = np.where(below < 0.5, stats.norm.ppf(below), stats.norm.isf(above))[inside]
    error = np.abs(quantile.function(z, n, p) - (counts[inside] + 1))
    # Half of what the sampler allows for.
    assert np.all(error <= 0.01 * (1 + z**4) / (n * p * (1 - p)) + 1e-12 * n)


def test_certain_outcomes():
    for u in (STEP, 0.5, 1 - STEP):
        assert binomial(u, 0.0, 0.5) == 0
        assert binomial(u, 9.0, 0.0) == 0
        assert binomial(u, 9.0, 1.0) == 9
        assert 0 <= binomial(u, 2.0**53, 0.5) <= 2.0**53
        assert binomial(u, 2.0**53, 1e-320) == 0


def test_rows_sum_to_the_counts():
    rng = np.random.default_rng(5)
    counts = np.floor(10.0 ** rng.uniform(-1, 12, 3000))
    shares = 10.0 ** rng.uniform(-12, 6, (3000, 9)) * (rng.random((3000, 9)) < 0.7)
    shares[:, 4] += 1e-3
    spread = thin(key(4, 4), np.arange(3000), counts, shares)
    assert np.array_equal(spread.sum(axis=1), counts)
    assert np.all(spread >= 0)
    assert np.array_equal(spread, np.floor(spread))
    assert not spread[shares == 0].any()


def test_common_shares_are_those_of_every_pixel():
    counts = np.arange(500.0)
    shares = np.array([0.5, 0.0, 3.0, 1e-9])
    common = thin(key(4, 5), np.arange(500), counts, shares)
    each = thin(key(4, 5), np.arange(500), counts, np.tile(shares, (500, 1)))
    assert np.array_equal(common, each)


@pytest.mark.parametrize("count", [3.0, 60.0, 5000.0])
def test_each_slot_has_its_binomial_distribution(count):
    n, shares = 100_000, np.array([1.0, 5.0, 0.5, 3.5])
    spread = thin(key(6, 1), np.arange(n), np.full(n, count), shares)
    for slot, part in enumerate(shares / shares.sum()):
        edges = np.unique(law.ppf(np.linspace(0.02, 0.98, 20), count, part))
        expected = np.diff(np.concatenate([[0.0], law.cdf(edges, count, part), [1.0]])) * n
        found = np.bincount(np.searchsorted(edges, spread[:, slot]), minlength=len(expected))
        kept = expected > 1
        assert (
            stats.chisquare(
                found[kept], expected[kept] * (found[kept].sum() / expected[kept].sum())
            ).pvalue
            > 1e-4
        )
    covariance = np.cov(spread[:, 0], spread[:, 1])[0, 1]
    expected = -count * 0.1 * 0.5
    assert abs(covariance - expected) < 6 * count * math.sqrt(0.1 * 0.5 / n)


def test_slots_of_a_poisson_count_are_independent_poisson_counts():
    n, rates = 200_000, np.array([0.4, 2.0, 7.6, 20.0])
    pixels = np.arange(n)
    counts, _ = poisson(key(8, 1), pixels, np.full(n, rates.sum()))
    spread = thin(key(8, 2), pixels, counts, rates)
    for slot, rate in enumerate(rates):
        assert abs(spread[:, slot].mean() - rate) < 5 * math.sqrt(rate / n)
        assert abs(spread[:, slot].var() - rate) < 5 * math.sqrt((rate + 2 * rate * rate) / n)
    away = np.corrcoef(spread.T)[np.triu_indices(4, 1)]
    assert np.all(np.abs(away) < 5 / math.sqrt(n))


def test_thinning_does_not_reuse_the_numbers_of_its_key():
    """The same key for a count and for its spreading is a slip that must not tie the two."""
    n, stream = 200_000, key(9, 1)
    counts, _ = poisson(stream, np.arange(n), np.full(n, 50.0))
    share = thin(stream, np.arange(n), counts, np.ones(2))[:, 0] / np.maximum(counts, 1)
    assert abs(np.corrcoef(counts, share)[0, 1]) < 5 / math.sqrt(n)
