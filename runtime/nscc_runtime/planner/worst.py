"""The worst pixels of a frame: the error that one pixel in a thousand passes, and the largest.

The error of a pixel is normal, with a mean and a variance of its own, or skewed by its third moment
(E. A. Cornish and R. A. Fisher, Moments and cumulants in the specification of distributions, 1938);
that of a frame is the mixture over a sample of its pixels. Where errors were measured at some
pixels, once each, their tail is told from the largest of them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

from nscc_runtime.planner.accounts import Errors

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
_EVEN = 0.05
"""A skewness that changes nothing worth telling."""
_STEPS = 40
_PRECISE = 1e-3


@dataclass(frozen=True)
class Worst:
    """Electrons, of the worst bucket: the error that one pixel in a thousand passes, and the
    largest."""

    p999_e: float
    max_e: float


class _Sides(NamedTuple):
    """Errors of pixels of a sample above and below 0: their means, standard deviations, skewness
    (None: all are normal), and the part of the frame that each stands for."""

    mean: Values
    sigma: Values
    skewness: Values | None
    part: Values

    def some(self, which: NDArray[np.int64] | slice) -> _Sides:
        """Those of some pixels."""
        skewness = None if self.skewness is None else self.skewness[which]
        return _Sides(self.mean[which], self.sigma[which], skewness, self.part[which])

    def up_to(self, z: float) -> Values:
        """The error of each that is as likely to be passed as `z` standard deviations."""
        g = self.skewness
        if g is None:
            return self.mean + z * self.sigma
        # The formula turns round where the tail ends that is cut short.
        short = z / 2.0 - g / 6.0
        return self.mean + self.sigma * np.where(z * g < -3.0, short, z + g / 6.0 * (z * z - 1.0))

    def passing(self, limit: float) -> float:
        """The share of the frame whose error passes a limit."""
        y, g = (limit - self.mean) / self.sigma, self.skewness
        if g is None:
            return float(self.part @ ndtr(-y))
        t = y + g / 6.0
        z = 2.0 * t / (1.0 + np.sqrt(np.maximum(1.0 + g * t / 1.5, 0.0)))
        # Without a count errors are as the others are: so rare counts make no tail of their own.
        return float(self.part @ np.minimum(ndtr(-z), ndtr(-y) + 1.0 / np.maximum(g * g, 1e-9)))


def worst_of(errors: Errors, weight: Values, pixels: int) -> Worst:
    """Of errors (buckets, pixels of a sample).

    `weight` (pixels of the sample,): how many of the `pixels` of a frame each stands for. Of a
    frame's largest error a sample shows little, as it lacks most of the pixels that are bright and
    have much of a fixed pattern: beyond that of 99.9 % errors are taken to become rarer at least as
    slowly as exponentially, at the pace of the errors before it.
    """
    mean, variance, third = errors
    if not (mean.any() or variance.any()):
        return Worst(0.0, 0.0)
    part = weight / weight.sum()
    sigma = np.sqrt(np.maximum(variance, 1e-12))
    skewness = third / sigma**3 * np.where(mean < 0.0, -1.0, 1.0)
    common, rare = 1.0 / ONE_IN, min(1.0 / ONE_IN, 1.0 / (FRAMES * pixels * len(mean)))
    found = [Worst(0.0, 0.0)]
    for size, spread, skew in zip(np.abs(mean), sigma, skewness, strict=True):
        skewed = np.append(skew, -skew) if np.abs(skew).max() > _EVEN else None
        sides = _Sides(
            np.append(size, -size), np.append(spread, spread), skewed, np.append(part, part)
        )
        p999_e = _passed_by(common, sides)
        pace_e = (p999_e - _passed_by(_COMMONER * common, sides)) / math.log(_COMMONER)
        max_e = p999_e + pace_e * math.log(common / rare)
        if _may_pass(max_e, sides, rare).passing(max_e) > rare:
            max_e = _passed_by(rare, sides)
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


def _may_pass(limit: float, sides: _Sides, share: float) -> _Sides:
    """Those that pass a limit often enough to be seen in this share of a frame; all, if most do."""
    may = np.flatnonzero(sides.up_to(-ndtri(_UNSEEN * share)) > limit)
    return sides if 2 * len(may) > len(sides.mean) else sides.some(may)


def _passed_by(share: float, sides: _Sides) -> float:
    """The error that this share of the frame passes."""
    if not math.isfinite(float((sides.mean + sides.sigma).max())):
        return 0.0
    # So many pixels pass it with all but what `rarely` comes that these are enough; and the errors
    # of all but half of the share stay that far below it that theirs are no more than the rest.
    rarely, upper = min(_RARELY * share, 0.5), sides
    if sides.skewness is None:  # the side above 0 reaches farther
        upper = sides.some(slice(len(sides.mean) // 2))
    low = _quantile(share / rarely, upper.up_to(-ndtri(rarely)), upper.part)
    high = _quantile(share / 2.0, upper.up_to(-ndtri(share / 4.0)), upper.part)

    wanted = _deviations(share)

    def beyond(limit: float) -> float:
        """By how much more pixels pass it than should, in standard deviations."""
        return wanted - _deviations(some.passing(limit))

    some = _may_pass(low, sides, share)
    at_low, at_high = beyond(low), beyond(high)
    if at_low < 0:  # counts are so rare that fewer pass it
        low, some = 0.0, sides
        at_low = beyond(low)
    # Straight for normal errors that are all alike, and nearly so else: false position, with half
    # of what was found at the end that stays twice (Illinois).
    stays = 0
    for _ in range(_STEPS):
        if at_high >= 0 or high - low <= _PRECISE * high:
            break
        pace = (at_low - at_high) / (high - low)
        middle = high + at_high / pace
        found = beyond(middle)
        if abs(found) <= pace * _PRECISE / 2.0 * high:
            return middle
        if found > 0:
            low, at_low, stays = middle, found, max(stays, 0) + 1
            at_high *= 0.5 if stays > 1 else 1.0
        else:
            high, at_high, stays = middle, found, min(stays, 0) - 1
            at_low *= 0.5 if stays < -1 else 1.0
    return high


def _deviations(share: float) -> float:
    """How many standard deviations a normal error passes so often."""
    return -float(ndtri(min(max(share, 1e-300), 1.0 - 1e-12)))


def _quantile(share: float, sizes: Values, part: Values) -> float:
    """The least of these sizes that no more than this share of the frame is beyond; 0 at a share
    of all."""
    if share >= 1.0:
        return 0.0
    order = sizes.argsort()
    upto = part[order].cumsum()
    last = min(int(np.searchsorted(upto, upto[-1] - share)), len(order) - 1)
    return float(sizes[order[last]])
