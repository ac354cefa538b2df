"""Estimate the largest errors of a frame from a sample of its pixels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.float64]

ONE_IN = 1000
"""One pixel in this number has an error above the 99.9 % quantile."""
FRAMES = 100
"""In one frame of this number, some pixel exceeds the estimated largest error."""
_TAIL = 10
"""Number of errors from which one tail parameter is estimated."""


@dataclass(frozen=True)
class Worst:
    """The 99.9 % quantile and the maximum of the error in the worst bucket, in electrons."""

    p999_e: float
    max_e: float


def worst_measured(errors: Values, weights: Values, pixels: int) -> Worst:
    """Estimate the largest errors of a frame from `errors` (buckets, sampled pixels).

    `weights` (sampled pixels,): the fraction of the `pixels` of a frame that each sampled pixel
    represents. An exponential tail is fitted beyond the sample: losses near saturation are large
    for a few pixels, so a normal tail is too short."""
    sizes = np.abs(errors)
    rare = min(1.0 / ONE_IN, 1.0 / (FRAMES * pixels * len(sizes)))
    p999_e, max_e = (
        max(_exceeded_by(share, bucket_sizes, weights) for bucket_sizes in sizes)
        for share in (1.0 / ONE_IN, rare)
    )
    return Worst(p999_e, max(max_e, float(sizes.max(initial=0.0))))


def _exceeded_by(share: float, sizes: Values, weights: Values) -> float:
    """Return the size that a fraction `share` of the frame exceeds, extrapolated beyond the sample
    if necessary; 0 if a small sample contains no such size."""
    order = np.argsort(-sizes, kind="stable")
    falling, upto, count = sizes[order], np.cumsum(weights[order]), len(sizes)
    if count < 2 * _TAIL or upto[0] <= share:
        at = int(np.searchsorted(upto, share, side="right"))
        return float(falling[at]) if at < count else 0.0
    ranks = np.arange(1, count // _TAIL) if count >= 4 * _TAIL else np.array([count // 4])
    beyond = np.cumsum(falling * weights[order])[ranks - 1] / upto[ranks - 1]
    excess = beyond - falling[ranks]
    return float(np.max(falling[ranks] + excess * np.log(upto[ranks] / share)))


def largest(sizes: Values, weight: Values) -> Worst:
    """Return the 99.9 % quantile and the maximum of weighted `sizes` (pixels,)."""
    order = np.argsort(sizes)
    above = np.cumsum(weight[order][::-1])[::-1]
    beyond = np.flatnonzero(above <= weight.sum() / ONE_IN)
    at = int(beyond[0]) if len(beyond) else len(sizes) - 1
    return Worst(float(sizes[order[at]]), float(sizes[order[-1]]))
