"""Formulas of effects in compiled loops: lognormal factors of pixels, and soft saturation."""

from __future__ import annotations

import math

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.loop import compiled
from nscc_runtime.noise.poisson_law import exp_minus


def log_normal(fraction: float, z: Floats) -> Floats:
    """Return lognormal factors of mean 1 and standard deviation `fraction` (at least 0), one for
    each standard normal number in `z`, in its shape."""
    variance = float(np.log1p(fraction * fraction))
    return np.asarray(np.exp(np.sqrt(variance) * z - variance / 2))


@compiled
def soft_in_loop(value: float, low: float, high: float, knee: float) -> float:
    """Return the content of a register after `value` is written, with soft saturation.

    All are electrons but `knee`, a fraction. Up to `knee` times the limit (`low`, below 0, or
    `high`) it is exact; beyond, it approaches the limit. NaN stays NaN.
    `nscc_runtime.effects.register.soft` does the same for arrays."""
    limit = -low if value < 0.0 else high
    size = abs(value)
    if not size > knee * limit:  # also for NaN
        return value
    # With a knee of 1 there is no room: the quotient is infinite, and the result the limit.
    room = (1.0 - knee) * limit
    rest = exp_minus(2.0 * (size - knee * limit) / room)
    bend = (1.0 - rest) / (1.0 + rest)
    return math.copysign(knee * limit + room * bend, value)
