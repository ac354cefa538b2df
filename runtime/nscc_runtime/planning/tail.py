"""The largest errors of a frame, as a sample of its pixels shows them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.float64]

ONE_IN = 1000
"""One pixel in so many is beyond the error that is called that of 99.9 %."""
FRAMES = 100
"""The largest error is the one that a pixel of one frame in so many passes."""
_TAIL = 10
"""Of so many errors that were measured the largest shows how the rest go on."""


@dataclass(frozen=True)
class Worst:
    """Electrons, of the worst bucket: the error that one pixel in a thousand passes, and the
    largest."""

    p999_e: float
    max_e: float


def worst_measured(errors: Values, weights: Values, pixels: int) -> Worst:
    """Of errors (buckets, pixels measured), the others of the frame being right.

    `weights` (pixels measured,): the share of the `pixels` of a frame that each stands for. Beyond
    the largest they are taken to become rarer exponentially, as those do from which most follows:
    what pixels lack that may saturate is much for a few, so a normal tail is too short."""
    sizes = np.abs(errors)
    rare = min(1.0 / ONE_IN, 1.0 / (FRAMES * pixels * len(sizes)))
    p999_e, max_e = (
        max(_exceeded_by(share, bucket_sizes, weights) for bucket_sizes in sizes)
        for share in (1.0 / ONE_IN, rare)
    )
    return Worst(p999_e, max(max_e, float(sizes.max(initial=0.0))))


def _exceeded_by(share: float, sizes: Values, weights: Values) -> float:
    """The size that this share of the frame exceeds, by what was measured at some of its pixels."""
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
    """Of errors that were measured: sizes (pixels,) that stand for so much each."""
    order = np.argsort(sizes)
    above = np.cumsum(weight[order][::-1])[::-1]
    beyond = np.flatnonzero(above <= weight.sum() / ONE_IN)
    at = int(beyond[0]) if len(beyond) else len(sizes) - 1
    return Worst(float(sizes[order[at]]), float(sizes[order[-1]]))
