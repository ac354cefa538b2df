"""Poisson counts from one uniform number: the inverse of the distribution function.

The counts never decrease with the uniform number for a fixed rate, nor with the
rate for a fixed uniform number. So a small change of the rate is a small change of the counts. This
holds up to rounding: if u is within about 1e-13 of a step of the distribution function, the order
of rates that differ by less than that may be reversed. Rates are finite and at least 0; u lies in
[2**-53, 1 - 2**-53]."""

from __future__ import annotations

import math

import numpy as np

from nscc_runtime.loop import compiled, inlined
from nscc_runtime.noise.gaussian import normal

RATE_CAP = 1e12
"""Upper limit of rates, infinity included. No well contains this number of electrons."""

SEARCH_BELOW = 10.0
"""Below this rate counts are searched from 0 upwards."""

SETTLED_ABOVE = 16.0
"""Rate from which on `quantile` rounded down is never below the search at SEARCH_BELOW."""

EXACT_BELOW = 1e6
"""Rate from which on only the formula is used. It differs from the search with a probability of
about 1e-15 rate, by rounding."""

SEARCHED = 80
"""Upper limit of the counts of the search, sufficient for rates up to SEARCH_BELOW."""
INVERSE = np.array([0.0, *(1.0 / k for k in range(1, SEARCHED))])

# Stirling's error log(k!) - log(sqrt(2 pi k) (k/e)**k), exact for small k, a series above.
_STIRLING_TABLE = 16
_STIRLING = np.array(
    [0.0]
    + [
        math.log(math.factorial(k)) - (k + 0.5) * math.log(k) + k - 0.5 * math.log(2 * math.pi)
        for k in range(1, _STIRLING_TABLE)
    ]
)


@inlined
def exp_minus(x: float) -> float:
    """Return exp(-x) for x of at least 0, to 2e-16, without branches, so that LLVM vectorises it.
    Beyond 700 it is that of 700."""
    x = min(x, 700.0)
    n = np.floor(0.5 - x * 1.4426950408889634)
    r = -x - n * 0.6931471803691238 - n * 1.9082149292705877e-10
    p = 1.0 / 6227020800.0
    p = p * r + 1.0 / 479001600.0
    p = p * r + 1.0 / 39916800.0
    p = p * r + 1.0 / 3628800.0
    p = p * r + 1.0 / 362880.0
    p = p * r + 1.0 / 40320.0
    p = p * r + 1.0 / 5040.0
    p = p * r + 1.0 / 720.0
    p = p * r + 1.0 / 120.0
    p = p * r + 1.0 / 24.0
    p = p * r + 1.0 / 6.0
    p = p * r + 0.5
    p = p * r + 1.0
    p = p * r + 1.0
    power = np.int64((np.int64(n) + np.int64(1023)) << np.int64(52)).view(np.float64)
    exponential: float = p * power
    return exponential


@compiled
def stirling_error(k: float) -> float:
    """Return log(k!) minus Stirling's formula, for whole k >= 1."""
    if k < _STIRLING_TABLE:
        return float(_STIRLING[np.int64(k)])
    r = 1.0 / (k * k)
    return (1 / 12 - r * (1 / 360 - r * (1 / 1260 - r * (1 / 1680 - r * (1 / 1188))))) / k


@compiled
def deviance(x: float, mean: float) -> float:
    """Return x log(x / mean) + mean - x without cancellation, for x and mean above 0."""
    # Near the mean, where the formula cancels, a series in (x - mean) / (x + mean).
    if abs(x - mean) >= 0.1 * (x + mean):
        return x * math.log(x / mean) + mean - x
    v = (x - mean) / (x + mean)
    total, power = (x - mean) * v, 2.0 * x * v
    for j in range(1, 20):
        power *= v * v
        total += power / (2 * j + 1)
    return total


@compiled
def _mass(k: float, rate: float) -> float:
    """Return the Poisson probability of the whole number k >= 0 at the mean `rate` above 0, by
    Loader's saddle-point expansion (2000)."""
    if k == 0.0:
        return math.exp(-rate)
    scale = math.sqrt(2.0 * np.pi * k)
    return math.exp(-stirling_error(k) - deviance(k, rate)) / scale


@compiled
def _up_to(k: float, rate: float, mass: float) -> float:
    """Return the Poisson probability of at most k, a whole number, at the mean `rate`. `mass`: the
    probability of k itself. Terms too small to change the sum are left out."""
    total, term, j = mass, mass, k
    while j > 0.0 and term > 1e-17 * total:
        term *= j / rate
        total += term
        j -= 1.0
    return total


@compiled
def _above(k: float, rate: float, mass: float) -> float:
    """Return the Poisson probability of more than k, a whole number, at the mean `rate`. `mass`:
    the probability of k itself. Terms too small to change the sum are left out."""
    j = k + 1.0
    term = mass * rate / j
    total = term
    while term > 1e-17 * total:
        j += 1.0
        term *= rate / j
        total += term
    return total


@compiled
def search(u: float, rate: float) -> float:
    """Return the smallest count whose Poisson distribution function reaches u in (0, 1), for a mean
    `rate` of at most SEARCH_BELOW."""
    # exp(-rate) >= 1 - rate, which is cheaper to compute.
    if u <= 1.0 - rate:
        return 0.0
    mass = math.exp(-rate)
    total, k = mass, 0
    while u > total and k < SEARCHED - 1:
        mass *= rate * INVERSE[k + 1]
        if total + mass == total:
            break  # rounding keeps the sum below u: no further count would reach it
        total += mass
        k += 1
    return float(k)


@compiled
def _walk(u: float, rate: float, start: float) -> float:
    """Return the smallest count whose Poisson distribution function at the mean `rate` reaches u in
    (0, 1). `start`: a whole number near it, with which the search begins. The smaller tail is added
    up, so that both tails are as accurate as the middle."""
    k = max(start, 0.0)
    mass = _mass(k, rate)
    if u < 0.5:
        total = _up_to(k, rate, mass)
        while k > 0.0 and total - mass >= u:
            total -= mass
            mass *= k / rate
            k -= 1.0
        while total < u and mass > 0.0:
            k += 1.0
            mass *= rate / k
            total += mass
        return k
    v = 1.0 - u
    total = _above(k, rate, mass)
    while k > 0.0 and total + mass <= v:
        total += mass
        mass *= k / rate
        k -= 1.0
    while total > v and mass > 0.0:
        k += 1.0
        mass *= rate / k
        total -= mass
    return k


@inlined
def quantile(z: float, rate: float) -> float:
    """Return a real number that, rounded down, is the count at the normal quantile z, for rates of
    at least SEARCH_BELOW.

    It is the Cornish-Fisher expansion to order 1/rate (Giles, "Algorithm 955: approximation of the
    inverse Poisson cumulative distribution function", ACM TOMS 42 (2016)). Its error is below 0.012
    (1 + |z|**5) / rate**1.5 where the result is above 1/2 (measured to |z| = 8.2)."""
    root, square = math.sqrt(rate), z * z
    inverse = 1.0 / root
    order_1 = 1 / 3 + square * (1 / 6)
    order_2 = z * (1 / 36 + square * (1 / 72))
    order_3 = square * (7 / 810 + square * (1 / 270)) - 8 / 405
    return rate + root * z + order_1 + (order_3 * inverse - order_2) * inverse


@compiled
def poisson_exact(u: float, rate: float) -> float:
    """Return the count that the reference draws: the smallest whose Poisson distribution function
    at the mean `rate` reaches u in (0, 1).

    Below SEARCH_BELOW it is searched from 0. Above, it is `quantile` rounded down; if that is so
    close to a whole number that its error may matter, the distribution function decides. From
    EXACT_BELOW on only the formula is used."""
    if rate < SEARCH_BELOW:
        return search(u, rate)
    z = normal(u)
    x = quantile(z, rate)
    k = math.floor(x)
    if rate < EXACT_BELOW:
        square = z * z
        error = 0.02 * (1.0 + abs(z) * square * square) / (rate * math.sqrt(rate)) + 1e-15 * rate
        if x - k <= error or x - k >= 1.0 - error:
            return _walk(u, rate, k)
    return max(k, 0.0)
