"""Hard case 23: the variance of float32 values whose mean is 1e5 and whose spread is 1."""

from __future__ import annotations

import math

import numpy as np
import pytest

from nscc_training.statistics import Moments


@pytest.mark.parametrize("blocks", [1, 7, 1000])
def test_variance_on_a_pedestal(blocks: int) -> None:
    x = (1e5 + np.random.default_rng(4).standard_normal(20000)).astype(np.float32)
    moments = Moments()
    for block in np.array_split(x, blocks):
        moments.add(block)
    exact = [float(v) for v in x]
    mean = math.fsum(exact) / len(exact)
    variance = math.fsum((v - mean) ** 2 for v in exact) / (len(exact) - 1)
    assert moments.mean == pytest.approx(mean, rel=1e-9)
    assert moments.variance == pytest.approx(variance, rel=1e-3)
