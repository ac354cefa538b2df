"""Counts, drawn for blocks of pixels: those of the exact law where that is promised."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import ndtri
from scipy.stats import poisson as law

from nscc_runtime.execution.block_draws import DRAW_BLOCK, FORMULA_FROM, MARGIN, ROOM
from nscc_runtime.execution.count_loop import Counting, draw_counts
from nscc_runtime.noise import key, uniforms
from nscc_runtime.noise.poisson_law import SEARCH_BELOW, quantile

STREAM = key(5, 3)


def drawn(rates: np.ndarray, begin: int = 0, end: int | None = None) -> np.ndarray:
    """Counts of some rates, at the pixels 0, 1, .."""
    away = np.zeros((1, len(rates)))
    draw_counts(
        counting=Counting(
            begin=begin,
            end=len(rates) if end is None else end,
            pixels=len(rates),
            groups=1,
            accumulates=0,
        ),
        keys=np.array([STREAM], np.uint64),
        rates=rates[None],
        places=np.arange(len(rates)),
        values=np.empty(DRAW_BLOCK),
        scratch=np.empty(ROOM),
        pending_rates=np.empty(DRAW_BLOCK),
        pending_pixels=np.empty(DRAW_BLOCK, np.int64),
        away=away,
    )
    return away[0] + rates


def some_rates(kind: str, count: int) -> np.ndarray:
    rng = np.random.default_rng(6)
    if kind == "mixed":
        return rng.exponential(6.0, count)
    if kind == "rarely low":
        return np.where(rng.random(count) < 0.05, rng.uniform(0.0, 9.9, count), 400.0)
    return np.full(count, float(kind))


@pytest.mark.parametrize("kind", ["0", "0.02", "0.7", "1.99", "2", "3.3", "9.99", "mixed"])
def test_low_rates_have_the_counts_of_the_law(kind: str) -> None:
    """Below SEARCH_BELOW a count is scipy's inverse Poisson distribution of the same uniform
    number."""
    rates = some_rates(kind, 40_000)
    low = rates < SEARCH_BELOW
    u, counts = uniforms(STREAM, np.arange(len(rates))), drawn(rates)
    # A rounding error in u decides nothing here: no u of these is so near to a step.
    np.testing.assert_allclose(counts[low], law.ppf(u, rates)[low], atol=1e-9)


@pytest.mark.parametrize("kind", ["12", "15.9", "40", "mixed", "rarely low"])
def test_counts_of_every_rate_are_nowhere_far_from_the_law(kind: str) -> None:
    """At any rate a count is at most 1 beside scipy's, and that in fewer than 0.2 % of pixels."""
    rates = some_rates(kind, 40_000)
    u, counts = uniforms(STREAM, np.arange(len(rates))), drawn(rates)
    off = np.abs(np.rint(counts) - law.ppf(u, rates))
    assert off.max() <= 1.0
    assert (off > 0).mean() < 2e-3


@pytest.mark.parametrize("kind", ["mixed", "rarely low"])
def test_splitting_pixels_into_parts_changes_no_bit(kind: str) -> None:
    """3000 pixels drawn in two parts, the second from pixel 700 on, have the bytes of one part."""
    rates = some_rates(kind, 3000)
    cut = drawn(rates, 0, 700)
    cut[700:] = drawn(rates, 700)[700:]
    assert cut.tobytes() == drawn(rates).tobytes()


def test_the_formula_decides_only_where_its_error_cannot() -> None:
    """At the end of a count, the formula is within its margin of a whole number."""
    for rate in np.linspace(FORMULA_FROM, SEARCH_BELOW, 60):
        counts = np.arange(60)
        reached, left = law.cdf(counts, rate), law.sf(counts, rate)
        ends = (reached > 2.0**-53) & (left > 2.0**-53)
        z = np.where(reached < 0.5, ndtri(reached), -ndtri(left))[ends]
        error = np.abs(quantile.function(z, rate) - (counts[ends] + 1))
        assert np.all(error <= 0.8 * MARGIN * (1 + np.abs(z) ** 5) / rate**1.5)
