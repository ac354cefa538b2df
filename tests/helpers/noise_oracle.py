"""What the noise must be, by other means than the noise's own."""

from __future__ import annotations

import numpy as np
from scipy.special import ndtr
from scipy.stats import poisson as law

from nscc_runtime.noise.keys import philox
from nscc_runtime.noise.poisson_law import SEARCH_BELOW, SETTLED_ABOVE, quantile

HALF = 1 << 32


def uniform_of(key: int, pixel: int) -> float:
    """The uniform number of a key at a pixel, by whole numbers alone."""
    words = philox((pixel % HALF, pixel // HALF, 0, 0), (key % HALF, key // HALF))
    return (2 * ((words[0] + HALF * words[1]) >> 12) + 1) * 2.0**-53


def fast_distribution(rate: float, counts: np.ndarray) -> np.ndarray:
    """The probability that the fast sampler gives at most each of `counts`, in theory.

    The formula is turned round by bisection: the chance is that of all normal numbers up to the one
    where the formula reaches the next count.
    """
    if rate < SEARCH_BELOW:
        return law.cdf(counts, rate)
    low, high = np.full(len(counts), -8.3), np.full(len(counts), 8.3)
    for _ in range(80):
        middle = (low + high) / 2
        over = quantile.function(middle, rate) >= counts + 1
        low, high = np.where(over, low, middle), np.where(over, middle, high)
    reached = ndtr(high)
    if rate < SETTLED_ABOVE:
        reached = np.minimum(reached, law.cdf(counts, SEARCH_BELOW))
    return reached
