"""Leakage that differs from pixel to pixel: sums at a few rates, and what lies between them.

A sum of terms exp(-rate age) is a smooth function of the rate: a polynomial through a few rates
about the mean is as good as the spread of the rates is small beside the frame's own time.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.parts import Leak
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.spread import log_normal

MOST = 8
_SIGMAS = 4.0
"""Rates further out than so many standard deviations (of the logarithm) are extrapolated."""


def rates(leak: Leak, sensor: Sensor, count: int) -> NDArray[np.float64]:
    """`count` rates in 1/s: Chebyshev's nodes over the range of the pixels'; the mean alone where
    all pixels have the same.
    """
    mean = 1.0 / leak.tau_s(sensor)
    if count == 1 or leak.spread(sensor) == 0.0:
        return np.array([mean])
    low, high = _range(leak.spread(sensor))
    angle = (2 * np.arange(count) + 1) * math.pi / (2 * count)
    return mean * ((low + high) / 2 - (high - low) / 2 * np.cos(angle))


def between(nodes: NDArray[np.float64], leak: NDArray[np.float64]) -> NDArray[np.float64]:
    """Weights (nodes, pixels) with which values at `nodes` give those at the rates `leak`."""
    found = np.ones((len(nodes), len(leak)))
    for i, node in enumerate(nodes):
        for j, other in enumerate(nodes):
            if i != j:
                found[i] *= (leak - other) / (node - other)
    return found


def error(leak: Leak, sensor: Sensor, count: int, age_s: float) -> float:
    """The relative RMS error over the pixels of exp(-rate age) found so, by normal numbers."""
    z = np.linspace(-_SIGMAS, _SIGMAS, 161)
    density = np.exp(-z * z / 2)
    per_s = log_normal(leak.spread(sensor), z) / leak.tau_s(sensor)
    nodes = rates(leak, sensor, count)
    near = between(nodes, per_s).T @ np.exp(-nodes * age_s)
    return float(np.sqrt(np.average((near - np.exp(-per_s * age_s)) ** 2, weights=density)))


def _range(spread: float) -> tuple[float, float]:
    """The pixels' rates, relative to their mean."""
    sigma = math.sqrt(math.log1p(spread**2))
    return (math.exp(-_SIGMAS * sigma - sigma**2 / 2), math.exp(_SIGMAS * sigma - sigma**2 / 2))
