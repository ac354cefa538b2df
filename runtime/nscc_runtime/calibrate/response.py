"""Non-uniformity and linearity of the pixels' response to light."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt

import numpy as np

from nscc_runtime.calibrate.dark_fit import DarkFit
from nscc_runtime.calibrate.levels import Level, LevelMoments, Map, Mask
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
    halves = np.stack([_response(levels, level_moments, dark, good_mask, half) for half in (0, 1)])
    smooth = surface((halves[0] + halves[1]) / 2, good_mask)
    return shared_variance(halves - smooth, good_mask, SURFACE_TERMS)


def _response(
    levels: Sequence[Level],
    level_moments: Sequence[LevelMoments],
    dark: DarkFit | None,
    good_mask: Mask,
    half: int,
) -> Map:
    """Return each pixel's response to light relative to the mean, (rows, cols), from one `half` of
    the frames: 0 for even and 1 for odd ones.

    `levels` are the flats and `level_moments` their moments, in the same order; `good_mask` (rows,
    cols) marks the pixels of the mean. The response is the slope of a weighted least-squares line
    of the pixel's signal over the mean signal. If `dark` is None, the line has an intercept."""
    weight = np.array([moments.frames / moments.variance for moments in level_moments])
    signal = [
        level.halves[half] - (0.0 if dark is None else dark.at(level.exposure_s)[half])
        for level in levels
    ]
    mean = np.array([values[good_mask].mean() for values in signal])
    centre = float((weight * mean).sum() / weight.sum()) if dark is None else 0.0
    share = weight * (mean - centre)
    total = np.zeros_like(signal[0])
    for level_share, values in zip(share, signal, strict=True):
        total += level_share * values
    # `centre` cancels in every pixel: the weights of an intercept sum to 0.
    return np.asarray(total / (share * (mean - centre)).sum())


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
