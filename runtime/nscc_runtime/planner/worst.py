"""The worst pixels of a frame: the error that one pixel in a thousand passes, and the largest.

The error of a pixel is normal, with a mean and a variance of its own; that of a frame is the
mixture over a sample of its pixels. Where errors were measured at some pixels, once each, their
tail is told from the largest of them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

Values = NDArray[np.float64]

ONE_IN = 1000
"""One pixel in so many is beyond the error that is called that of 99.9 %."""
FRAMES = 100
"""The largest error is the one that a pixel of one frame in so many passes."""
_COMMONER = 10
"""Beside the error that one pixel in a thousand passes, that of so many more shows how errors go on
beyond it."""
_TAIL = 10
"""Of so many errors that were measured the largest shows how the rest go on."""
_UNSEEN = 1e-6
"""Of a share: a pixel that passes an error more rarely adds nothing to it."""
_RARELY = 50.0
"""Times the share of the frame that passes an error: how likely a fiftieth of it is to pass it."""
_STEPS = 40
_PRECISE = 1e-3


@dataclass(frozen=True)
class Worst:
    """Electrons, of the worst bucket: the error that one pixel in a thousand passes, and the
    largest."""

    p999_e: float
    max_e: float


class _Sides(NamedTuple):
    """Normal errors, of pixels of a sample above and below 0: their means, standard deviations, and
    the part of the frame that each stands for."""

    mean: Values
    sigma: Values
    part: Values


def worst_of(mean: Values, variance: Values, weight: Values, pixels: int) -> Worst:
    """Of errors with these means and variances (buckets, pixels of a sample).

    `weight` (pixels of the sample,): how many of the `pixels` of a frame each stands for. Of a
    frame's largest error a sample shows little, as it lacks most of the pixels that are bright and
    have much of a fixed pattern: beyond that of 99.9 % errors are taken to become rarer at least as
    slowly as exponentially, at the pace of the errors before it.
    """
    if not (mean.any() or variance.any()):
        return Worst(0.0, 0.0)
    part = weight / weight.sum()
    sigma = np.sqrt(np.maximum(variance, 1e-12))
    common, rare = 1.0 / ONE_IN, min(1.0 / ONE_IN, 1.0 / (FRAMES * pixels * len(mean)))
    found = [Worst(0.0, 0.0)]
    for size, spread in zip(np.abs(mean), sigma, strict=True):
        sides = _Sides(np.append(size, -size), np.append(spread, spread), np.append(part, part))
        each = size, spread, part, sides
        p999_e = _passed_by(common, *each)
        pace_e = (p999_e - _passed_by(_COMMONER * common, *each)) / math.log(_COMMONER)
        max_e = p999_e + pace_e * math.log(common / rare)
        if _passing(max_e, _may_pass(max_e, sides, rare)) > rare:
            max_e = _passed_by(rare, *each)
        found.append(Worst(p999_e, max_e))
    return Worst(max(each.p999_e for each in found), max(each.max_e for each in found))


def worst_measured(errors: Values, part: Values, pixels: int) -> Worst:
    """Of errors (buckets, pixels measured), the others of the frame being right.

    `part` (pixels measured,): the share of the `pixels` of a frame that each stands for. Beyond the
    largest they are taken to become rarer exponentially, as those do from which most follows: what
    pixels lack that may saturate is much for a few, so a normal tail is too short.
    """
    sizes = np.abs(errors)
    rare = min(1.0 / ONE_IN, 1.0 / (FRAMES * pixels * len(sizes)))
    p999_e, max_e = (
        max(_exceeded_by(share, each, part) for each in sizes) for share in (1.0 / ONE_IN, rare)
    )
    return Worst(p999_e, max(max_e, float(sizes.max(initial=0.0))))


def _exceeded_by(share: float, sizes: Values, part: Values) -> float:
    """The size that this share of the frame exceeds, by what was measured at some of its pixels."""
    order = np.argsort(-sizes, kind="stable")
    falling, upto, count = sizes[order], np.cumsum(part[order]), len(sizes)
    if count < 2 * _TAIL or upto[0] <= share:
        at = int(np.searchsorted(upto, share, side="right"))
        return float(falling[at]) if at < count else 0.0
    ranks = np.arange(1, count // _TAIL) if count >= 4 * _TAIL else np.array([count // 4])
    beyond = np.cumsum(falling * part[order])[ranks - 1] / upto[ranks - 1]
    excess = beyond - falling[ranks]
    return float(np.max(falling[ranks] + excess * np.log(upto[ranks] / share)))


def largest(sizes: Values, weight: Values) -> Worst:
    """Of errors that were measured: sizes (pixels,) that stand for so much each."""
    order = np.argsort(sizes)
    above = np.cumsum(weight[order][::-1])[::-1]
    beyond = np.flatnonzero(above <= weight.sum() / ONE_IN)
    at = int(beyond[0]) if len(beyond) else len(sizes) - 1
    return Worst(float(sizes[order[at]]), float(sizes[order[-1]]))


def _passing(limit: float, sides: _Sides) -> float:
    """The share of the frame whose error passes a limit."""
    mean, sigma, part = sides
    return float(part @ ndtr((mean - limit) / sigma))


def _may_pass(limit: float, sides: _Sides, share: float) -> _Sides:
    """Those that pass a limit often enough to be seen in this share of a frame; all, if most do."""
    mean, sigma, part = sides
    may = np.flatnonzero(mean - ndtri(_UNSEEN * share) * sigma > limit)
    if 2 * len(may) > len(mean):
        return sides
    return _Sides(mean[may], sigma[may], part[may])


def _passed_by(share: float, size: Values, sigma: Values, part: Values, sides: _Sides) -> float:
    """The error that this share of the frame passes."""
    if not math.isfinite(float((size + sigma).max())):
        return 0.0
    # So many pixels pass it with all but what `rarely` comes that these are enough; and the errors
    # of all but half of the share stay that far below it that theirs are no more than the rest.
    rarely = min(_RARELY * share, 0.5)
    low = _quantile(share / rarely, size - sigma * ndtri(rarely), part)
    high = _quantile(share / 2.0, size - sigma * ndtri(share / 4.0), part)

    def beyond(middle: float) -> float:
        """By how much more pixels pass it than should, as a logarithm."""
        return math.log(max(_passing(middle, some), 1e-300) / share)

    # The logarithm is nearly straight: false position, with the end that stays halved (Illinois).
    some = _may_pass(low, sides, share)
    at_low, at_high = beyond(low), beyond(high)
    for _ in range(_STEPS):
        if at_high >= 0 or high - low <= _PRECISE * high:
            break
        middle = high - at_high * (high - low) / (at_high - at_low)
        found = beyond(middle)
        if found > 0:
            low, at_low, at_high = middle, found, at_high / 2
            some = _may_pass(low, some, share)
        else:
            high, at_high, at_low = middle, found, at_low / 2
    return high


def _quantile(share: float, sizes: Values, part: Values) -> float:
    """The least of these sizes that no more than this share of the frame is beyond; 0 at a share
    of all."""
    if share >= 1.0:
        return 0.0
    order = sizes.argsort()
    upto = part[order].cumsum()
    last = min(int(np.searchsorted(upto, 1.0 - share)), len(order) - 1)
    return float(sizes[order[last]])
