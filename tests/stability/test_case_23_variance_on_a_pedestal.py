"""Hard case 23: the spread of float32 values whose mean is 1e5 and whose spread is 1."""

from __future__ import annotations

import math

import numpy as np
import pytest

from nscc_training.measures import summary


def test_variance_of_values_far_from_zero_is_exact() -> None:
    x = (1e5 + np.random.default_rng(4).standard_normal(20000)).astype(np.float32)
    exact = [float(v) for v in x]
    moments = summary(exact, ["scene"] * len(exact))
    mean = math.fsum(exact) / len(exact)
    variance = math.fsum((v - mean) ** 2 for v in exact) / (len(exact) - 1)
    assert moments.mean == pytest.approx(mean, rel=1e-9)
    assert moments.sd**2 == pytest.approx(variance, rel=1e-3)
