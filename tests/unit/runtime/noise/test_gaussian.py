"""Normal numbers: accurate and increasing over the whole range of the uniform ones."""

from __future__ import annotations

import math

import numpy as np
from scipy import stats
from scipy.special import ndtri

from nscc_runtime.noise import key, normals, uniforms
from nscc_runtime.noise.gaussian import normal

STEP = 2.0**-53


def quantiles(values):
    return np.array([normal(float(value)) for value in values])


def test_the_relative_error_is_small_from_end_to_end():
    """At the least numbers, in the tail and in the middle, the error against scipy is below 1e-12.
    The median is exactly 0."""
    few = STEP * np.arange(1, 2000, 2)
    tail = 2.0 ** np.linspace(-53, -1, 40_001)[:-1]
    middle = 0.5 - 2.0 ** np.linspace(-53, -2, 4001)
    for u in (few, tail, middle):
        truth = ndtri(u)
        assert np.abs(quantiles(u) / truth - 1).max() < 1e-12
    assert normal(0.5) == 0.0


def test_quantiles_are_symmetric_to_the_bit():
    u = (2 * np.floor(2.0 ** np.linspace(0, 51, 5001)) + 1) * STEP
    assert np.array_equal(quantiles(u), -quantiles(1 - u))


def test_quantiles_never_decrease_where_cells_meet():
    for octave in range(1, 53):
        edges = 2.0**-octave * (1 + np.arange(32) / 32) / 2
        steps = np.arange(-8, 9) * max(STEP, 2.0 ** -(octave + 54))
        around = edges[:, None] + np.unique(np.round(steps / STEP) * STEP)
        for row in np.clip(around, STEP, 0.5):
            assert np.all(np.diff(quantiles(row)) >= 0)


def test_quantiles_never_decrease_from_one_number_to_the_next():
    """Of 39 neighbouring numbers at 200 places, no quantile is below the one before it. Above one
    half the order is the mirrored one."""
    rng = np.random.default_rng(3)
    for start in rng.random(200) * 0.5:
        run = np.floor(start / STEP) * STEP + STEP * np.arange(1, 40)
        assert np.all(np.diff(quantiles(run)) >= 0)
        assert np.all(np.diff(quantiles(1 - run)) <= 0)


def test_arrays_take_the_quantile_of_the_uniform_number():
    pixels = np.arange(3000)
    stream = key(3, 1)
    assert np.array_equal(normals(stream, pixels), quantiles(uniforms(stream, pixels)))


def test_gaussian_numbers_have_the_moments_of_a_normal_distribution():
    """A million numbers pass a Kolmogorov-Smirnov test and have mean 0, variance 1 and fourth
    moment 3."""
    n = 1_000_000
    found = normals(key(11, 2), np.arange(n))
    assert stats.kstest(found, "norm").pvalue > 1e-3
    # Within five standard errors: 1, 2 and 96 are the variances of x, x^2 and x^4.
    assert abs(found.mean()) < 5 / math.sqrt(n)
    assert abs(found.var() - 1) < 5 * math.sqrt(2 / n)
    assert abs((found**4).mean() - 3) < 5 * math.sqrt(96 / n)
