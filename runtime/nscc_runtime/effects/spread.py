"""Lognormal factors that differ from pixel to pixel."""

from __future__ import annotations

import math

import numpy as np

from nscc_runtime.effects.views import Values
from nscc_runtime.loop import compiled


def log_variance(fraction: float) -> float:
    """Return the variance of the logarithm of a lognormal with relative spread `fraction`."""
    return float(np.log1p(fraction * fraction))


def log_normal(fraction: float, z: Values) -> Values:
    """Return lognormal factors of mean 1, standard deviation `fraction`, from normal numbers z."""
    variance = log_variance(fraction)
    return np.asarray(np.exp(np.sqrt(variance) * z - variance / 2))


@compiled
def log_normal_in_loop(variance: float, z: float) -> float:
    """Return a lognormal factor of mean 1 in loops. `variance`: variance of its logarithm."""
    return math.exp(math.sqrt(variance) * z - variance / 2)
