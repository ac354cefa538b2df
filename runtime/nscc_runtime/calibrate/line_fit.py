"""Weighted lines, errors of what is computed from fitted values, and spreads from two halves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.calibrate.levels import Map, Mask

Vector = NDArray[np.float64]


IMPROBABLE = 1e-4


@dataclass(frozen=True, eq=False)
class Line:
    """y = start + slope x, with the covariance (2, 2) of (start, slope).

    `misfit` is chi squared, `freedom` the number of points less two; `apart` the root mean square
    distance of the points, relative to the fitted y.
    """

    start: float
    slope: float
    covariance: Vector
    misfit: float
    freedom: int
    apart: float

    @property
    def chance(self) -> float:
        """How probable a misfit as large is if the points lie on a line; 1 for two points."""
        if self.freedom < 1:
            return 1.0
        from scipy.special import gammaincc

        return float(gammaincc(self.freedom / 2, self.misfit / 2))

    @property
    def excess(self) -> float:
        """How much larger the points' errors are than given, in variance, where that is certain.

        1 unless a misfit as large has a chance below `IMPROBABLE`.
        """
        return self.misfit / self.freedom if self.chance < IMPROBABLE else 1.0


def line(x: Vector, y: Vector, errors: Callable[[Vector], Vector]) -> Line:
    """The weighted least-squares line; `errors` gives the points' standard errors from fitted y.

    Weights follow from the fit and not from the points: a point that came out low by chance would
    weigh more, and pull the line down.
    """
    fitted = y
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
    return Line(start, slope, covariance, misfit, len(x) - 2, apart)


def propagated(
    function: Callable[[Vector], float], values: Sequence[float], covariance: Vector
) -> tuple[float, float]:
    """The function of uncertain values, and its standard error to first order."""
    at = np.array(values, np.float64)
    gradient = np.zeros(len(at))
    for i, error in enumerate(np.sqrt(np.diag(covariance))):
        if error > 0:
            step = np.zeros(len(at))
            step[i] = error * 1e-3
            gradient[i] = (function(at + step) - function(at - step)) / (2 * step[i])
    return float(function(at)), sqrt(max(float(gradient @ covariance @ gradient), 0.0))


def shared_variance(maps: Map, good_mask: Mask, parameter_count: int = 1) -> tuple[float, float]:
    """The variance over the good pixels of what two maps have in common, and its standard error.

    `maps` is (2, rows, cols). Their own noise is independent and cancels in the mean. `taken` is
    how many parameters of their shape were fitted and subtracted before, their mean included.
    """
    even, odd = (half_map[good_mask] - half_map[good_mask].mean() for half_map in maps)
    product = even * odd
    count = len(product)
    return float(product.sum() / (count - parameter_count)), float(product.std() / sqrt(count))


def root(variance: float, error: float) -> tuple[float, float]:
    """The square root of a variance that may have come out negative, and its standard error.

    Near 0 the error is what the root gains when the variance grows by its own error.
    """
    value = sqrt(max(variance, 0.0))
    if value > 0 and variance > error:
        return value, error / (2 * value)
    return value, sqrt(max(variance, 0.0) + error) - value if error > 0 else 0.0


def robust_scale(values: Vector) -> tuple[float, float]:
    """Median, and standard deviation from the median absolute deviation."""
    middle = float(np.median(values))
    return middle, 1.4826 * float(np.median(np.abs(values - middle)))


def surface(values: Map, good_mask: Mask) -> Map:
    """The quadratic surface (rows, cols) through the good pixels: six parameters."""
    rows, cols = values.shape
    x, y = np.meshgrid(np.linspace(-1, 1, cols), np.linspace(-1, 1, rows))
    terms = np.stack([np.ones_like(x), x, y, x * y, x * x, y * y], axis=-1)
    solved = np.linalg.lstsq(terms[good_mask], values[good_mask], rcond=None)[0]
    fitted: Map = terms @ solved
    return fitted


SURFACE_TERMS = 6
