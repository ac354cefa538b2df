"""Binomial counts from one uniform number, for distributing a count over slots.

The count never decreases in the uniform number u, in the probability p of a success or in the
number n of trials while the other two stay, up to rounding (see `nscc_runtime.noise.poisson_law`).
"""

from __future__ import annotations

import math

import numpy as np

from nscc_runtime.loop import compiled
from nscc_runtime.noise.gaussian import normal
from nscc_runtime.noise.poisson_law import INVERSE, SEARCHED, deviance, stirling_error

SEARCH_BELOW = 10.0
"""Below this mean (of the rarer outcome) the search starts from 0."""

EXACT_BELOW = 1e8
"""Variance from which on only the formula is used. It differs from the search with a probability of
about 1e-15 n p, by rounding."""


@compiled
def _log1p(x: float) -> float:
    """Return log(1 + x) for x > -1, to a few units in the last place (Kahan's quotient)."""
    w = 1.0 + x
    return x if w == 1.0 else x * (math.log(w) / (w - 1.0))


@compiled
def _mass(k: float, n: float, p: float, q: float) -> float:
    """Return the probability of k by Loader's saddle-point expansion (2000)."""
    if k == 0.0:
        return math.exp(n * _log1p(-p))
    if k == n:
        return math.exp(n * math.log(p))
    failures = n - k
    log_mass = stirling_error(n) - stirling_error(k) - stirling_error(failures)
    log_mass -= deviance(k, n * p) + deviance(failures, n * q)
    return math.exp(log_mass) * math.sqrt(n / (2.0 * np.pi * k * failures))


@compiled
def _up_to(k: float, n: float, odds: float, mass: float) -> float:
    """Return the probability of at most k from the probability `mass` of k; `odds` is p / q."""
    total, term, j = mass, mass, k
    while j > 0.0 and term > 1e-17 * total:
        term *= j / ((n - j + 1.0) * odds)
        total += term
        j -= 1.0
    return total


@compiled
def _above(k: float, n: float, odds: float, mass: float) -> float:
    """Return the probability of more than k from the probability `mass` of k; `odds` is p / q."""
    if k >= n:
        return 0.0
    j = k + 1.0
    term = mass * (n - k) * odds / j
    total = term
    while j < n and term > 1e-17 * total:
        term *= (n - j) * odds / (j + 1.0)
        total += term
        j += 1.0
    return total


@compiled
def _search(u: float, n: float, p: float) -> float:
    """Return the smallest count whose distribution function reaches u, for n p <= SEARCH_BELOW."""
    odds = p / (1.0 - p)
    mass = math.exp(n * _log1p(-p))
    total, k = mass, 0
    while u > total and k < SEARCHED - 1 and k < n:
        mass *= (n - k) * odds * INVERSE[k + 1]
        if total + mass == total:
            break
        total += mass
        k += 1
    return float(k)


@compiled
def _walk(u: float, n: float, p: float, start: float) -> float:
    """Return the smallest count whose distribution function reaches u, searching from `start`."""
    q = 1.0 - p
    odds = p / q
    k = min(max(start, 0.0), n)
    mass = _mass(k, n, p, q)
    if u < 0.5:
        total = _up_to(k, n, odds, mass)
        while k > 0.0 and total - mass >= u:
            total -= mass
            mass *= k / ((n - k + 1.0) * odds)
            k -= 1.0
        while k < n and total < u:
            mass *= (n - k) * odds / (k + 1.0)
            total += mass
            k += 1.0
        return k
    v = 1.0 - u
    total = _above(k, n, odds, mass)
    while k > 0.0 and total + mass <= v:
        total += mass
        mass *= k / ((n - k + 1.0) * odds)
        k -= 1.0
    while k < n and total > v:
        mass *= (n - k) * odds / (k + 1.0)
        total -= mass
        k += 1.0
    return k


@compiled
def quantile(z: float, n: float, p: float) -> float:
    """Return a real number that, rounded down, is the count at the normal quantile z, for n p of at
    least SEARCH_BELOW.

    It is the Cornish-Fisher expansion, to order 1 / sigma, of the smooth distribution that agrees
    at all k + 1/2 (Sheppard's correction of the cumulants)."""
    q = 1.0 - p
    spread = n * p * q
    variance = spread - 1 / 12
    sigma = math.sqrt(variance)
    skew = spread * (q - p) / (variance * sigma)
    excess = (spread * (1.0 - 6.0 * p * q) + 1 / 120) / (variance * variance)
    square = z * z
    shape = skew * (square - 1.0) / 6 + z * (square - 3.0) * excess / 24
    shape -= skew * skew * z * (2.0 * square - 5.0) / 36
    return n * p + 0.5 + sigma * (z + shape)


@compiled
def _rarer(u: float, n: float, p: float) -> float:
    """Return the number of successes in n trials for p up to 1/2 (see `binomial`)."""
    if n * p < SEARCH_BELOW:
        return _search(u, n, p)
    z = normal(u)
    x = quantile(z, n, p)
    k = math.floor(x)
    variance = n * p * (1.0 - p)
    if variance < EXACT_BELOW:
        square = z * z
        error = 0.02 * (1.0 + square * square) / variance + 1e-15 * n * p
        if x - k <= error or x - k >= 1.0 - error:
            return _walk(u, n, p, k)
    return min(max(k, 0.0), n)


@compiled
def binomial(u: float, n: float, p: float) -> float:
    """Return the number of successes in n trials with probability p for a uniform number u: the
    smallest count whose distribution function reaches u. n is a whole number from 0 to 2**53, p
    lies in [0, 1], u in [2**-53, 1 - 2**-53]."""
    if n <= 0.0 or p <= 0.0:
        return 0.0
    if p >= 1.0:
        return n
    if p <= 0.5:
        return _rarer(u, n, p)
    return n - _rarer(1.0 - u, n, 1.0 - p)
