"""Hard case 22: SSIM of flat pictures, on a pedestal of 1e4, and without a data range."""

from __future__ import annotations

import math

import numpy as np
import pytest

from nscc_training import metrics


def test_ssim_of_equal_flat_pictures_is_1() -> None:
    for level in (0.0, 1e-30, 0.5, 1e4, 1e8):
        flat = np.full((16, 16), level, np.float32)
        assert metrics.ssim(flat, flat, 1.0) == 1.0


@pytest.mark.parametrize("pedestal", [0.0, 1e4, 1e6])
def test_ssim_is_exact_for_float32_values_far_from_zero(pedestal: float) -> None:
    """The expected value comes from exact sums (`fsum`), after each window's mean is subtracted."""
    rng = np.random.default_rng(2)
    x, y = ((pedestal + rng.standard_normal((12, 12)) * 0.25).astype(np.float32) for _ in range(2))
    weight = [math.exp(-0.5 * (k / 1.5) ** 2) for k in range(-5, 6)]
    total = sum(weight)
    exact = []
    for r in range(2):
        for c in range(2):
            parts = [p[r : r + 11, c : c + 11].astype(np.float64).ravel().tolist() for p in (x, y)]
            w = [a * b / total**2 for a in weight for b in weight]
            ma, mb = (math.fsum(u * v for u, v in zip(w, p, strict=True)) for p in parts)
            da, db = [v - ma for v in parts[0]], [v - mb for v in parts[1]]
            va = math.fsum(u * v * v for u, v in zip(w, da, strict=True))
            vb = math.fsum(u * v * v for u, v in zip(w, db, strict=True))
            vab = math.fsum(u * p * q for u, p, q in zip(w, da, db, strict=True))
            exact.append(
                (2 * ma * mb + 1e-4)
                / (ma * ma + mb * mb + 1e-4)
                * (2 * vab + 9e-4)
                / (va + vb + 9e-4)
            )
    assert metrics.ssim(x, y, 1.0) == pytest.approx(math.fsum(exact) / 4, abs=1e-4)


def test_ssim_lies_between_minus_one_and_one() -> None:
    rng = np.random.default_rng(3)
    for _ in range(40):
        scale = 10.0 ** rng.uniform(-6, 8, 2)
        x = (rng.standard_normal((12, 12)) * scale[0] + scale[1]).astype(np.float32)
        for y in (x, -x, x + np.float32(1), x[::-1]):
            assert -1.0 <= metrics.ssim(x, y, 1.0) <= 1.0


@pytest.mark.parametrize("data_range", [0.0, -1.0, math.nan])
def test_ssim_refuses_an_invalid_data_range(data_range: float) -> None:
    flat = np.ones((12, 12))
    with pytest.raises(ValueError, match="data range"):
        metrics.ssim(flat, flat, data_range)
