"""Peak signal to noise ratios, and how those of several frames become one number."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc_training.curves import MU, PU21_HIGH, PU21_LOW, mu_law, pu21


def mean_square_error(truth: NDArray[Any], result: NDArray[Any]) -> float:
    """Mean of squared differences, in float64 whatever the arrays are."""
    if truth.shape != result.shape:
        raise ValueError(f"{truth.shape} and {result.shape}")
    difference = truth.astype(np.float64) - result.astype(np.float64)
    return float(np.mean(np.square(difference)))


def psnr_of_mse(mse: float, data_range: float) -> float:
    """10 log10(data_range^2 / mse) in dB; +inf where nothing differs."""
    if not data_range > 0:
        raise ValueError(f"data range {data_range}")
    return math.inf if mse == 0 else 20 * math.log10(data_range) - 10 * math.log10(mse)


def psnr(truth: NDArray[Any], result: NDArray[Any], data_range: float) -> float:
    """PSNR of two arrays of one shape, in dB."""
    return psnr_of_mse(mean_square_error(truth, result), data_range)


def mu_psnr(truth: NDArray[Any], result: NDArray[Any], data_range: float, mu: float = MU) -> float:
    """PSNR after mu-law of both, clipped to 0..data_range; the curve's range is 1."""
    curves = [
        mu_law(np.clip(x.astype(np.float64) / data_range, 0.0, 1.0), mu) for x in (truth, result)
    ]
    return psnr(curves[0], curves[1], 1.0)


def pu21_psnr(truth: NDArray[Any], result: NDArray[Any], data_range: float, nits: float) -> float:
    """PSNR in perceptually uniform units, where `data_range` is a luminance of `nits` cd/m2.

    Both are clipped to 0..data_range first; the peak is the encoding of `nits`.
    """
    if not PU21_LOW < nits <= PU21_HIGH:
        raise ValueError(f"{nits} cd/m2")
    encoded = [
        pu21(np.clip(x.astype(np.float64) * (nits / data_range), PU21_LOW, nits))
        for x in (truth, result)
    ]
    return psnr(encoded[0], encoded[1], float(pu21(np.float64(nits))))


@dataclass(frozen=True)
class FrameScores:
    """Per-frame dB as one score.

    `mean` and `sd` leave out frames of infinite dB (identical ones), which `infinite` counts; with
    no other frame the mean is +inf. `of_mean_mse` is the dB of the mean error of all frames.
    """

    mean: float
    sd: float
    infinite: int
    of_mean_mse: float


def frame_scores(mses: Iterable[float], data_range: float) -> FrameScores:
    """The scores of frames with these mean square errors."""
    errors = [float(mse) for mse in mses]
    if not errors:
        raise ValueError("no frames")
    finite = [psnr_of_mse(mse, data_range) for mse in errors if mse > 0]
    return FrameScores(
        mean=float(np.mean(finite)) if finite else math.inf,
        sd=float(np.std(finite, ddof=1)) if len(finite) > 1 else 0.0,
        infinite=len(errors) - len(finite),
        of_mean_mse=psnr_of_mse(math.fsum(errors) / len(errors), data_range),
    )
