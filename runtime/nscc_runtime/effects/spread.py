"""Factors that differ from pixel to pixel."""

from __future__ import annotations

import math

import numpy as np

from nscc_runtime.effects.views import Values
from nscc_runtime.loop import compiled


def log_variance(fraction: float) -> float:
    """Return the variance of the logarithm of lognormal numbers with a relative standard
    deviation."""
    return float(np.log1p(fraction * fraction))


def log_normal(fraction: float, z: Values) -> Values:
    """Return positive factors of mean 1 and standard deviation `fraction` from normal numbers."""
    variance = log_variance(fraction)
    return np.asarray(np.exp(np.sqrt(variance) * z - variance / 2))


@compiled
def log_normal_in_loop(variance: float, z: float) -> float:
    """Return such a factor in loops, from the variance of the logarithm."""
    return math.exp(math.sqrt(variance) * z - variance / 2)
