"""Hard case 21: identical images are infinitely good, and must not make a mean infinite."""

from __future__ import annotations

import math

import numpy as np
import pytest

from nscc_training import metrics
from nscc_training.metrics import mean_square_error


def test_psnr_is_infinite_for_equal_images_and_finite_one_ulp_apart() -> None:
    x = np.random.default_rng(0).random((32, 32)).astype(np.float32)
    assert metrics.psnr(x, x, 1.0) == math.inf
    near = np.nextafter(x, np.float32(2))
    steps = [float(b) - float(a) for a, b in zip(x.flat, near.flat, strict=True)]
    mse = math.fsum(s * s for s in steps) / x.size
    assert metrics.psnr(x, near, 1.0) == pytest.approx(-10 * math.log10(mse), abs=0.01)


def test_a_score_counts_infinite_frames_and_leaves_them_out() -> None:
    rng = np.random.default_rng(1)
    truth = rng.random((4, 16, 16))
    result = truth.copy()
    result[1] += 0.1
    result[3] += 0.01
    found = metrics.frame_scores(
        [mean_square_error(a, b) for a, b in zip(truth, result, strict=True)], 1.0
    )
    assert found.mean == pytest.approx((20 + 40) / 2, abs=1e-9)
    assert found.infinite == 2
    assert found.of_mean_mse == pytest.approx(-10 * math.log10((0.01 + 0.0001) / 4), abs=1e-9)


def test_psnr_of_equal_frames_only_is_infinite() -> None:
    found = metrics.frame_scores([0.0, 0.0], 1.0)
    assert (found.mean, found.infinite, found.of_mean_mse) == (math.inf, 2, math.inf)
