"""Weighted line fits, error propagation, and variances from two halves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import sqrt

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.calibrate.levels import Map, Mask

Vector = Floats


IMPROBABLE = 1e-4
"""Probability of a misfit below which the points are said to deviate from the line."""


@dataclass(frozen=True, eq=False)
class Line:
    """A fitted line y = start + slope x, with the covariance (2, 2) of (start, slope).

    `misfit`: chi squared. `freedom`: degrees of freedom, the number of points less 2. `apart`: root
    mean square distance of the points, relative to the fitted y."""

    start: float
    slope: float
    covariance: Vector
    misfit: float
    freedom: int
    apart: float

    @property
    def chance(self) -> float:
        """Probability of at least this misfit if the points lie on a line and their errors are
        right; 1 for two points."""
        if self.freedom < 1:
            return 1.0
        from scipy.special import gammaincc

        return float(gammaincc(self.freedom / 2, self.misfit / 2))

    @property
    def excess(self) -> float:
        """Factor on the variance of the points' errors; 1 unless `chance` is below `IMPROBABLE`."""
        return self.misfit / self.freedom if self.chance < IMPROBABLE else 1.0


def line(x: Vector, y: Vector, errors: Callable[[Vector], Vector]) -> Line:
    """Fit a line to points `x`, `y` (one axis, two or more different x) by weighted least squares.
    `errors` is a function that returns the points' standard errors, above 0, for fitted y.

    Weights use the fitted y instead of the measured y, because points that are low by chance would
    get more weight and bias the line."""
    fitted = y
    # The weights depend on the fit; after five rounds they change no more that matters.
    for _ in range(5):
        weight = 1.0 / errors(fitted) ** 2
        total = weight.sum()
        centre = float((weight * x).sum() / total)
        spread = float((weight * (x - centre) ** 2).sum())
        slope = float((weight * (x - centre) * y).sum() / spread)
        start = float((weight * y).sum() / total) - slope * centre
        fitted = start + slope * x
    covariance = np.array(
        [[1 / total + centre**2 / spread, -centre / spread], [-centre / spread, 1 / spread]]
    )
    misfit = float((((y - fitted) / errors(fitted)) ** 2).sum())
    apart = float(np.sqrt(((y / fitted - 1) ** 2).mean()))
    return Line(start, slope, covariance, misfit, freedom=len(x) - 2, apart=apart)


def propagated(
    function: Callable[[Vector], float], values: Sequence[float], covariance: Vector
) -> tuple[float, float]:
    """Return `function` of uncertain `values` (n of them), and its standard error to first order.
    `covariance` (n, n) is that of the values; a value of variance 0 is exact."""
    point = np.array(values, np.float64)
    gradient = np.zeros(len(point))
    for i, error in enumerate(np.sqrt(np.diag(covariance))):
        if error > 0:
            step = np.zeros(len(point))
            step[i] = error * 1e-3  # small beside the error, so that the slope is that at `values`
            gradient[i] = (function(point + step) - function(point - step)) / (2 * step[i])
    return float(function(point)), sqrt(max(float(gradient @ covariance @ gradient), 0.0))


def shared_variance(maps: Map, good_mask: Mask, parameter_count: int = 1) -> tuple[float, float]:
    """Return the variance over the good pixels of the common pattern of two maps, and its standard
    error. The variance may be negative by chance.

    `maps` is (2, rows, cols); independent noise of the two cancels in the mean of their product.
    `good_mask` (rows, cols) marks the pixels that count. `parameter_count`: number of parameters
    fitted and subtracted before, including the mean; there must be more pixels."""
    even, odd = (half_map[good_mask] - half_map[good_mask].mean() for half_map in maps)
    product = even * odd
    count = len(product)
    return float(product.sum() / (count - parameter_count)), float(product.std() / sqrt(count))


def root(variance: float, error: float) -> tuple[float, float]:
    """Return the square root of a `variance` and its standard error; `error` is that of the
    variance. A negative variance counts as 0. Near 0 the error is the increase of the root if the
    variance grows by its error."""
    value = sqrt(max(variance, 0.0))
    if value > 0 and variance > error:
        return value, error / (2 * value)
    return value, sqrt(max(variance, 0.0) + error) - value if error > 0 else 0.0


def surface(values: Map, good_mask: Mask) -> Map:
    """Return the quadratic surface (rows, cols) with six parameters that fits `values` (rows, cols)
    at the pixels in `good_mask` with the least squared error. It covers all pixels."""
    rows, cols = values.shape
    x, y = np.meshgrid(np.linspace(-1, 1, cols), np.linspace(-1, 1, rows))
    terms = np.stack([np.ones_like(x), x, y, x * y, x * x, y * y], axis=-1)
    solved = np.linalg.lstsq(terms[good_mask], values[good_mask], rcond=None)[0]
    return np.asarray(terms @ solved)


SURFACE_TERMS = 6
"""Number of parameters of `surface`."""
