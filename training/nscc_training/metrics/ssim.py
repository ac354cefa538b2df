"""Structural similarity (Wang et al. 2004): Gaussian windows of 11 x 11, sigma 1.5."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

WINDOW = 11
SIGMA = 1.5
K1, K2 = 0.01, 0.03

Picture = NDArray[np.float64]


def ssim(truth: NDArray[Any], result: NDArray[Any], data_range: float) -> float:
    """Mean SSIM of two pictures (rows, cols) or of the frames of two clips (T, rows, cols).

    Only windows that lie inside count, so both sides are at least `WINDOW`. Always within -1..1,
    and 1 for equal pictures, flat ones too.
    """
    if truth.shape != result.shape or truth.ndim not in (2, 3):
        raise ValueError(f"{truth.shape} and {result.shape}")
    if min(truth.shape[-2:]) < WINDOW:
        raise ValueError(f"smaller than a window: {truth.shape}")
    if not data_range > 0:
        raise ValueError(f"data range {data_range}")
    if truth.ndim == 3:
        return float(np.mean([ssim(a, b, data_range) for a, b in zip(truth, result, strict=True)]))
    return float(np.mean(similarity(truth, result, data_range)))


def similarity(truth: NDArray[Any], result: NDArray[Any], data_range: float) -> Picture:
    """The SSIM of every window, (rows - 10, cols - 10), in float64."""
    x, y = truth.astype(np.float64), result.astype(np.float64)
    # Variances do not depend on a common pedestal, but their rounding errors do: take it away.
    base = 0.5 * (float(x.mean()) + float(y.mean()))
    x, y = x - base, y - base
    mean_x, mean_y = _blur(x), _blur(y)
    var_x = np.maximum(_blur(x * x) - mean_x * mean_x, 0.0)
    var_y = np.maximum(_blur(y * y) - mean_y * mean_y, 0.0)
    most = np.sqrt(var_x * var_y)
    covariance = np.clip(_blur(x * y) - mean_x * mean_y, -most, most)
    mean_x, mean_y = mean_x + base, mean_y + base
    c1, c2 = (K1 * data_range) ** 2, (K2 * data_range) ** 2
    light = (2 * mean_x * mean_y + c1) / (mean_x * mean_x + mean_y * mean_y + c1)
    structure = (2 * covariance + c2) / (var_x + var_y + c2)
    return np.asarray(np.clip(light * structure, -1.0, 1.0))


def _blur(picture: Picture) -> Picture:
    """Gaussian means of all whole windows."""
    offsets = np.arange(WINDOW) - WINDOW // 2
    weights = np.exp(-0.5 * (offsets / SIGMA) ** 2)
    weights /= weights.sum()
    rows, cols = (side - WINDOW + 1 for side in picture.shape)
    across = sum(w * picture[:, k : k + cols] for k, w in enumerate(weights))
    return np.asarray(sum(w * across[k : k + rows] for k, w in enumerate(weights)))
