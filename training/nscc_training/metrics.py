"""Metrics of reconstructions; the data range is always an explicit argument."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from nscc.arrays import Array, Floats
from nscc.diagnostics.arguments import as_array, shown, wrong_argument
from nscc_training.curves import MU, PU21_HIGH, PU21_LOW, mu_law, pu21

WINDOW = 11
SIGMA = 1.5
"""Standard deviation of SSIM's Gaussian windows in pixels (Wang et al. 2004)."""
K1, K2 = 0.01, 0.03


def mean_square_error(truth: Array, result: Array) -> float:
    """Return the mean of the squared differences of two arrays, computed in float64.

    Any shape is allowed, integers included. Raises WrongArgument for arrays of different shapes,
    empty arrays, and values that are not finite real numbers."""
    truth, result = _pair(truth, result)
    difference = truth.astype(np.float64) - result.astype(np.float64)
    return float(np.mean(np.square(difference)))


def psnr_of_mse(mse: float, data_range: float) -> float:
    """Return the PSNR in dB of a mean square error: 10 log10(data_range^2 / mse); +inf if the error
    is 0.

    `data_range` is the peak value, in the unit of the signal. Raises WrongArgument for an error
    below 0 or not finite, or a data range that is not a finite number above 0."""
    _check_range(data_range)
    if not 0 <= mse < math.inf:
        raise wrong_argument(f"a mean square error is a finite number from 0 on, not {mse}")
    return math.inf if mse == 0 else 20 * math.log10(data_range) - 10 * math.log10(mse)


def psnr(truth: Array, result: Array, data_range: float) -> float:
    """Compute the peak signal-to-noise ratio of two arrays.

    Parameters
    ----------
    truth, result : array
        Finite numbers of one shape.
    data_range : float
        The peak value.

    Returns
    -------
    float
        In dB; +inf for equal arrays.

    Raises
    ------
    WrongArgument
        For different shapes, empty arrays, values that are not finite, or a data range that is
        not a finite number above 0.
    """
    return psnr_of_mse(mean_square_error(truth, result), data_range)


def mu_psnr(truth: Array, result: Array, data_range: float, mu: float = MU) -> float:
    """Compute the PSNR after a mu-law tone curve.

    Parameters
    ----------
    truth, result : array
        Finite numbers of one shape; clipped to 0..data_range.
    data_range : float
        The peak value.
    mu : float
        Parameter of the curve, above 0: a larger one weights dark light more.

    Returns
    -------
    float
        In dB.

    Raises
    ------
    WrongArgument
        For different shapes, empty arrays, values that are not finite, or a data range or `mu` that
        is not a finite number above 0.
    """
    _check_range(data_range)
    if not (_is_number(mu) and 0 < mu < math.inf):
        raise wrong_argument(f"mu is a number above 0, not {shown(mu)}")
    relative = [np.clip(x.astype(np.float64) / data_range, 0.0, 1.0) for x in _pair(truth, result)]
    return psnr(mu_law(relative[0], mu), mu_law(relative[1], mu), data_range=1.0)


def pu21_psnr(truth: Array, result: Array, data_range: float, nits: float) -> float:
    """Compute the PSNR in perceptually uniform units (PU21, Mantiuk and Azimi 2021).

    Parameters
    ----------
    truth, result : array
        Finite numbers of one shape; clipped to 0..data_range.
    data_range : float
        The peak value.
    nits : float
        Luminance of `data_range` in cd/m2.

    Returns
    -------
    float
        In dB.

    Raises
    ------
    WrongArgument
        For different shapes, empty arrays, values that are not finite, an invalid data range, or
        `nits` outside the range of PU21, above 0.005 up to 10,000.
    """
    _check_range(data_range)
    if not (_is_number(nits) and PU21_LOW < nits <= PU21_HIGH):
        raise wrong_argument(
            f"PU21 needs luminances up to {PU21_HIGH:g} cd/m2 and above {PU21_LOW:g}, not "
            f"{shown(nits)}"
        )
    encoded = [
        pu21(np.clip(x.astype(np.float64) * (nits / data_range), PU21_LOW, nits))
        for x in _pair(truth, result)
    ]
    return psnr(encoded[0], encoded[1], data_range=float(pu21(np.float64(nits))))


def finite_mean(scores_db: Iterable[float]) -> float:
    """Return the mean in dB of the finite ones of `scores_db`. Scores of +inf, those of identical
    pictures, are left out.

    If all scores are +inf, so is the mean. Raises WrongArgument for an empty sequence, NaN or -inf.
    """
    scores = list(scores_db)
    if not scores or any(math.isnan(score) or score == -math.inf for score in scores):
        raise wrong_argument(f"a mean is taken of numbers of dB, not of {scores[:5]}")
    finite = [score for score in scores if math.isfinite(score)]
    return float(np.mean(finite)) if finite else math.inf


class FrameScores(NamedTuple):
    """Summary of the scores of frames in dB.

    `mean` and `sd`, the sample standard deviation (0 for fewer than two finite scores), leave out
    identical frames (infinite dB), which `infinite` counts; if all frames are identical, the mean
    is +inf. `of_mean_mse` is the PSNR of the mean square error over all frames."""

    mean: float
    sd: float
    infinite: int
    of_mean_mse: float


def frame_scores(mses: Iterable[float], data_range: float) -> FrameScores:
    """Return the summary of the PSNR of frames that have the mean square errors `mses`;
    `data_range` is the peak value.

    Raises WrongArgument if there are no frames, for an error that is negative or not finite, and
    for a data range that is not a finite number above 0."""
    errors = [float(mse) for mse in mses]
    scores = [psnr_of_mse(mse, data_range) for mse in errors]
    finite = [score for score in scores if math.isfinite(score)]
    return FrameScores(
        mean=finite_mean(scores),
        sd=float(np.std(finite, ddof=1)) if len(finite) > 1 else 0.0,
        infinite=len(errors) - len(finite),
        of_mean_mse=psnr_of_mse(math.fsum(errors) / len(errors), data_range),
    )


def ssim(truth: Array, result: Array, data_range: float) -> float:
    """Compute the mean structural similarity (Wang et al. 2004); for a clip, the mean over its
    pictures.

    Only whole windows of 11 x 11 pixels count.

    Parameters
    ----------
    truth, result : array
        Pictures (rows, cols) or clips (T, rows, cols).
    data_range : float
        The peak value.

    Returns
    -------
    float
        -1..1; 1 for equal pictures, flat pictures included.

    Raises
    ------
    WrongArgument
        For different shapes, other axes, fewer than 11 rows or columns, empty arrays, values that
        are not finite, or a data range that is not a finite number above 0.
    """
    truth, result = _pair(truth, result)
    if truth.ndim not in (2, 3) or min(truth.shape[-2:]) < WINDOW:
        raise wrong_argument(
            f"SSIM needs pictures (rows, cols) or clips (T, rows, cols) of at least {WINDOW} x "
            f"{WINDOW} pixels, not of {truth.shape}"
        )
    _check_range(data_range)
    if truth.ndim == 3:
        return float(np.mean([ssim(a, b, data_range) for a, b in zip(truth, result, strict=True)]))
    return float(np.mean(similarity(truth, result, data_range)))


def similarity(truth: Array, result: Array, data_range: float) -> Floats:
    """Return the SSIM of `truth` and `result` (rows, cols) in every whole window of 11 x 11 pixels,
    (rows - 10, cols - 10), float64. `data_range` is the peak value. The caller ensures equal
    shapes, at least 11 rows and columns, and finite values."""
    x, y = truth.astype(np.float64), result.astype(np.float64)
    # Subtract a common offset: variances do not depend on it, but their rounding errors do.
    common = 0.5 * (float(x.mean()) + float(y.mean()))
    x, y = x - common, y - common
    mean_x, mean_y = _blur(x), _blur(y)
    # A variance is at least 0; rounding could make it negative.
    var_x = np.maximum(_blur(x * x) - mean_x * mean_x, 0.0)
    var_y = np.maximum(_blur(y * y) - mean_y * mean_y, 0.0)
    # No covariance is larger in magnitude; rounding could make it so.
    most = np.sqrt(var_x * var_y)
    covariance = np.clip(_blur(x * y) - mean_x * mean_y, -most, most)
    mean_x, mean_y = mean_x + common, mean_y + common
    c1, c2 = (K1 * data_range) ** 2, (K2 * data_range) ** 2
    light = (2 * mean_x * mean_y + c1) / (mean_x * mean_x + mean_y * mean_y + c1)
    structure = (2 * covariance + c2) / (var_x + var_y + c2)
    return np.asarray(np.clip(light * structure, -1.0, 1.0))


def _blur(picture: Floats) -> Floats:
    """Return the Gaussian-weighted mean of every whole window of 11 x 11 pixels of `picture` (rows,
    cols): (rows - 10, cols - 10). The caller ensures that both sides have at least 11 pixels."""
    offsets = np.arange(WINDOW) - WINDOW // 2
    weights = np.exp(-0.5 * (offsets / SIGMA) ** 2)
    weights /= weights.sum()
    rows, cols = (side - WINDOW + 1 for side in picture.shape)
    across = sum(w * picture[:, k : k + cols] for k, w in enumerate(weights))
    return np.asarray(sum(w * across[k : k + rows] for k, w in enumerate(weights)))


def temporal_error(truth: Array, result: Array, data_range: float) -> float:
    """Compute the RMS error of the changes from frame to frame, over the data range.

    A constant error does not count; flicker does.

    Parameters
    ----------
    truth, result : array
        Clips (T, rows, cols) with T >= 2.
    data_range : float
        The peak value.

    Returns
    -------
    float
        0 for clips with the same changes.

    Raises
    ------
    WrongArgument
        For different shapes, other axes, a single frame, empty arrays, values that are not finite,
        or a data range that is not a finite number above 0.
    """
    truth, result = _pair(truth, result)
    if truth.ndim != 3 or len(truth) < 2:
        raise wrong_argument(
            f"the temporal error needs clips (T, rows, cols) of two frames or more, not of "
            f"{truth.shape}"
        )
    _check_range(data_range)
    error = result.astype(np.float64) - truth.astype(np.float64)
    return float(np.sqrt(np.mean(np.square(np.diff(error, axis=0))))) / data_range


def _pair(truth: Array, result: Array) -> tuple[Array, Array]:
    """Return `truth` and `result` as arrays. Raise WrongArgument unless they have the same shape,
    at least one value, and only finite real numbers."""
    first = as_array("a metric", "the truth", truth)
    second = as_array("a metric", "the reconstruction", result)
    if first.shape != second.shape or {first.dtype.kind, second.dtype.kind} - {*"buif"}:
        raise wrong_argument(
            "a metric compares numbers of one shape: the truth is "
            f"{shown(truth)}, the reconstruction {shown(result)}"
        )
    if first.size == 0:
        raise wrong_argument(f"a metric needs at least one value, and the arrays are {first.shape}")
    for name, values in (("truth", first), ("reconstruction", second)):
        bad_count = int(np.count_nonzero(~np.isfinite(values)))
        if bad_count:
            raise wrong_argument(
                f"{bad_count} of {values.size} values of the {name} are not finite"
            )
    return first, second


def _is_number(value: object) -> bool:
    """Return whether a value is a real number of Python or numpy. A bool and NaN are numbers, an
    array is none."""
    return isinstance(value, int | float | np.integer | np.floating)


def _check_range(data_range: float) -> None:
    """Raise WrongArgument unless the data range, the peak value of a metric, is a finite number
    above 0."""
    if not (_is_number(data_range) and 0 < data_range < math.inf):
        raise wrong_argument(
            f"the data range is the peak that errors are compared with, a number above 0, not "
            f"{shown(data_range)}",
            helps=("255 for 8-bit values, 1 for values on [0, 1], a full well for electrons",),
        )
