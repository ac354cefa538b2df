"""Non-uniformity and linearity of the pixels' response to light."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt

import numpy as np

from nscc_runtime.calibrate.dark_fit import DarkFit
from nscc_runtime.calibrate.levels import Level, LevelMoments, Mask
from nscc_runtime.calibrate.line_fit import SURFACE_TERMS, line, shared_variance, surface

_RANGE = (0.05, 0.95)
"""Linearity is measured between these fractions of the range up to saturation (EMVA 1288)."""
_SAME = 0.01
"""Largest relative difference of flats of one light and time."""


def response_variance(
    levels: Sequence[Level],
    level_moments: Sequence[LevelMoments],
    dark: DarkFit | None,
    good_mask: Mask,
) -> tuple[float, float]:
    """Return the variance over the pixels of the response to light, relative to its mean, and its
    standard error.

    `levels` are the flats and `level_moments` their moments, in the same order; `good_mask` (rows,
    cols) marks the pixels that count. The response of a pixel is the weighted slope of its signal
    over the mean signal of the levels. If `dark` is None, each pixel has its own intercept, else
    the line passes through the fitted darks. A smooth surface, the fall-off of the light, is
    subtracted."""
    weight = np.array([moments.frames / moments.variance for moments in level_moments])
    signal = [
        level.halves - (0.0 if dark is None else dark.at(level.exposure_s)) for level in levels
    ]
    # The mean signal of both halves of the frames in each level, (2, levels).
    mean = np.array([[values[half][good_mask].mean() for values in signal] for half in (0, 1)])
    centre = 0.0 if dark is not None else (weight * mean).sum(1, keepdims=True) / weight.sum()
    share = weight * (mean - centre)
    total = np.zeros_like(signal[0])
    for level_share, values in zip(share.T, signal, strict=True):
        total += level_share[:, None, None] * values
    # `centre` cancels in every pixel: the weights of an intercept sum to 0.
    halves = total / (share * (mean - centre)).sum(axis=1)[:, None, None]
    smooth = surface((halves[0] + halves[1]) / 2, good_mask)
    return shared_variance(halves - smooth, good_mask, SURFACE_TERMS)


@dataclass(frozen=True)
class Linearity:
    """The linearity error of flats: the mean absolute deviation of their signal from a line, in
    percent, its standard error (`error_se`, in percent too), and the number of levels on the
    line."""

    error_percent: float
    error_se: float
    levels: int


def linearity(
    level_moments: Sequence[LevelMoments], dark: DarkFit | None, full: float
) -> Linearity | str:
    """Return EMVA 1288's linearity error of flats of one light and several exposure times, or a
    text with the reason why it is unknown.

    `level_moments` are those of the flats. `dark` is the fit of the frames without light, None if
    there is none. `full`: the converter code at which flats saturate. Flats between 5 % and 95 % of
    that range count; three different times are needed."""
    if dark is None:
        return "no dark tells the code without charge"
    if any(level.exposure_s is None for level in level_moments):
        return "not all flats have an exposure time"
    low, high = (dark.offset + range_share * (full - dark.offset) for range_share in _RANGE)
    inside = [
        m for m in level_moments if low <= m.mean <= high and not (m.cut_at_top or m.cut_at_zero)
    ]
    time = np.array([level.exposure_s for level in inside], np.float64)
    if len(set(time)) < 3:
        return (
            "it takes flats of one light and three exposure times or more between 5 % and 95 % of "
            f"saturation, there {'is' if len(set(time)) == 1 else 'are'} {len(set(time))}"
        )
    signal = np.array([m.mean for m in inside]) - (dark.offset + (dark.current or 0.0) * time)
    for t in set(time):
        same = signal[time == t]
        if np.ptp(same) > _SAME * same.mean():
            return "flats of the same time differ: the light was not constant"
    # Errors in proportion to the signal: EMVA 1288 minimizes relative deviations.
    fit = line(time, signal, lambda _: signal)
    fitted = fit.start + fit.slope * time
    apart = np.abs(signal - fitted) / fitted
    errors = np.array([level.mean_se for level in inside]) / fitted
    count = len(inside)
    return Linearity(100 * float(apart.mean()), 100 * sqrt(float((errors**2).sum())) / count, count)
