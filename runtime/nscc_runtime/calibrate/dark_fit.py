"""Fit of darks (frames without light): the converter code without charge and the dark current of
each pixel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot, sqrt

import numpy as np

from nscc_runtime.calibrate.levels import Level, LevelMoments, Map, Mask


@dataclass(frozen=True, eq=False)
class DarkFit:
    """The result of fitting the darks (frames without light), in converter codes.

    `offset`: mean code without charge. `offset_se`: its standard error from temporal noise.
    `offset_spread_se`: its standard error including the spread over the pixels. `offsets` (2, rows,
    cols): code without charge of each pixel, from its even and from its odd frames. `times_s`: the
    exposure times of the darks used, in ascending order, empty if unknown.

    `current`: dark current in codes per second. `current_se`: its standard error including the
    spread. `currents` (2, rows, cols): that of each pixel, like `offsets`. If all exposure times
    are equal, or one is unknown, these three are None, and `offset` includes the dark charge."""

    offset: float
    offset_se: float
    offset_spread_se: float
    offsets: Map
    times_s: tuple[float, ...]
    current: float | None = None
    current_se: float | None = None
    currents: Map | None = None

    def at(self, exposure_s: float | None) -> Map:
        """Return the mean converter codes (2, rows, cols) of even and odd frames without light
        after `exposure_s` seconds. If `exposure_s` or the dark current is unknown, return
        `offsets`."""
        if self.currents is None or exposure_s is None:
            return self.offsets
        return self.offsets + self.currents * exposure_s


def dark_of(
    levels: Sequence[Level], level_moments: Sequence[LevelMoments], good_mask: Mask
) -> DarkFit | None:
    """Fit the converter code of each pixel over exposure time through the unclipped darks (frames
    without light); return None if all are clipped.

    `levels` are the darks, `level_moments` their means and variances in the same order, and
    `good_mask` (rows, cols) marks the pixels that are not defects. Without two known exposure
    times, the darks with the time of the darkest one are averaged."""
    usable = [
        (level, moments)
        for level, moments in zip(levels, level_moments, strict=True)
        if not (moments.cut_at_zero or moments.cut_at_top)
    ]
    if not usable:
        return None
    usable_levels = [level for level, _ in usable]
    known = [level.exposure_s for level in usable_levels if level.exposure_s is not None]
    pixels = int(np.count_nonzero(good_mask))
    if len(known) < len(usable_levels) or len(set(known)) < 2:
        # Without times the darkest frames approximate zero charge.
        level, moments = min(usable, key=lambda pair: pair[1].mean)
        times = () if level.exposure_s is None else (level.exposure_s,)
        same = [
            usable_level for usable_level in usable_levels if usable_level.exposure_s in times
        ] or [level]
        weight = _frames(same)
        halves = _combined(same, weight / weight.sum())
        mean, spread = _mean(halves, good_mask)
        spread_se = hypot(spread / sqrt(pixels), moments.mean_rounding)
        return DarkFit(
            mean,
            offset_se=moments.mean_se,
            offset_spread_se=spread_se,
            offsets=halves,
            times_s=times,
        )
    time, weight = np.array(known), _frames(usable_levels)
    centre = float((weight * time).sum() / weight.sum())
    moment = float((weight * (time - centre) ** 2).sum())
    # The weights of the levels in the slope and in the intercept of a least-squares line.
    slopes = weight * (time - centre) / moment
    starts = weight / weight.sum() - centre * slopes
    currents, offsets = _combined(usable_levels, slopes), _combined(usable_levels, starts)
    offset, offset_spread = _mean(offsets, good_mask)
    current, current_spread = _mean(currents, good_mask)
    errors = np.array([moments.mean_se for _, moments in usable])
    rounding = np.array([moments.mean_rounding for _, moments in usable])
    offset_spread_se = hypot(offset_spread / sqrt(pixels), _size(starts * rounding))
    current_se = hypot(current_spread / sqrt(pixels), _size(slopes * rounding))
    return DarkFit(
        offset,
        offset_se=_size(starts * errors),
        offset_spread_se=offset_spread_se,
        offsets=offsets,
        times_s=tuple(sorted(set(known))),
        current=current,
        current_se=current_se,
        currents=currents,
    )


def _frames(levels: Sequence[Level]) -> np.ndarray:
    """Return the number of frames of each of `levels`, as an array in their order."""
    return np.array([level.frames for level in levels], np.float64)


def _size(terms: np.ndarray) -> float:
    """Return the square root of the sum of the squares of `terms`: independent errors add up so."""
    return sqrt(float((terms**2).sum()))


def _combined(levels: Sequence[Level], weights: np.ndarray) -> Map:
    """Return the weighted sum of the levels' `halves`, (2, rows, cols). `weights` has a weight for
    each of `levels`, in the same order."""
    terms = (weight * level.halves for level, weight in zip(levels, weights, strict=True))
    return sum(terms, start=np.zeros_like(levels[0].halves))


def _mean(halves: Map, good_mask: Mask) -> tuple[float, float]:
    """Return the mean and the standard deviation over the pixels in `good_mask` (rows, cols) of the
    mean of both `halves` (2, rows, cols)."""
    both = (halves[0][good_mask] + halves[1][good_mask]) / 2
    return float(both.mean()), float(both.std())
