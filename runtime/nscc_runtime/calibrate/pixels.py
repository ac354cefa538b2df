"""Fits of single pixels: the code without charge, the dark current, and the response to light.
Defects are left out, and flats are checked to be flat."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot, sqrt

import numpy as np

from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.calibrate.levels import Level, LevelMoments, Map, Mask, moments
from nscc_runtime.calibrate.line_fit import SURFACE_TERMS, line, shared_variance, surface
from nscc_runtime.scenes.errors import size

OUTLIER = 12.0
"""A pixel further from the median than this number of robust standard deviations is a defect. A
lognormal dark current of 50 % spread exceeds this in one pixel of a hundred thousand."""
_LEAST_SCALE = 0.3
"""Minimum scale in codes, about the rounding of the ADC, for the case that all pixels are equal."""
LEAST_PIXELS = 64
"""Minimum number of pixels for surfaces, medians and standard errors."""
MOST_DEFECTS = 0.01
"""Largest fraction of pixels that may be outliers."""
MOST_UNEVEN = 0.2
"""Largest variation of a flat over the array, relative to its mean."""


def good_pixels(flats: Sequence[Level], darks: Sequence[Level]) -> Mask:
    """Return a mask (rows, cols) of the pixels that are valid in all levels (`flats` and `darks`,
    each the frames of one light and exposure time), and outliers in none. Saturated flats are not
    searched for outliers.

    Raises Rejected: NS0757 for levels of different sizes or fewer than 64 valid pixels; NS0759 if
    more than 1 % of the pixels, and more than 2, are outliers."""
    first = darks[0]
    for level in (*flats, *darks):
        if level.variance.shape != first.variance.shape:
            raise rejected(
                "NS0757",
                f"'{level.name}' is {size(level.variance.shape)}, '{first.name}' is "
                f"{size(first.variance.shape)}",
                notes=("sizes are rows x columns",),
                helps=("give frames of one array, all of the same size",),
            )
    good_mask = valid_pixels((*flats, *darks))
    start = int(np.count_nonzero(good_mask))
    if start < LEAST_PIXELS:
        raise rejected(
            "NS0757",
            f"{start} pixels are valid in all frames, but photon transfer needs at least "
            f"{LEAST_PIXELS}",
            notes=(f"the frames are {size(first.variance.shape)}",),
            helps=("use frames of the whole array; `valid` in frame files marks the valid pixels",),
            data={"required": LEAST_PIXELS, "available": start},
        )
    for level in darks:
        good_mask &= ~_outliers(level, good_mask, flat=False)
    for level in flats:
        # At the end of the scale pixels are equal: those that are not would seem to be outliers.
        if not moments(level, good_mask).share_at_top > MOST_DEFECTS:
            good_mask &= ~_outliers(level, good_mask, flat=True)
    defect_count = start - int(np.count_nonzero(good_mask))
    if defect_count > max(MOST_DEFECTS * start, 2):
        raise rejected(
            "NS0759",
            f"{defect_count} of {start} pixels are outliers: the frames are not flat",
            notes=(
                f"a pixel is an outlier if it deviates by more than {OUTLIER:g} standard "
                "deviations",
            ),
            helps=(
                "take flats of an evenly lit white surface, out of focus; darks with the cap on",
            ),
        )
    return good_mask


def valid_pixels(levels: Sequence[Level]) -> Mask:
    """Return a mask (rows, cols) of the pixels that are valid in every frame of `levels`, one or
    more of one size."""
    return np.asarray(np.logical_and.reduce([level.valid for level in levels]))


def refuse_uneven(
    flats: Sequence[Level], good_mask: Mask, zero: float, darks: Sequence[Level]
) -> None:
    """Raise NS0759 for a flat whose light varies over the array by more than 20 % of its mean.

    `good_mask` (rows, cols) marks the pixels that count. `zero`: converter code without charge. The
    mean pattern of `darks` is subtracted first."""
    dark_map = sum((level.mean_map for level in darks), np.zeros(good_mask.shape))
    pattern = (dark_map - dark_map[good_mask].mean()) / max(len(darks), 1)
    for level in flats:
        smooth = surface(level.mean_map - pattern, good_mask)
        light = float(level.mean_map[good_mask].mean()) - zero
        fall = float(np.ptp(smooth[good_mask]))
        if light > 0 and fall > MOST_UNEVEN * light:
            raise rejected(
                "NS0759",
                f"'{level.name}' is not flat: its light decreases from code "
                f"{smooth[good_mask].max():.4g} to {smooth[good_mask].min():.4g} over the "
                "array",
                notes=(
                    f"a variation up to {MOST_UNEVEN:.0%} of the mean is subtracted as a "
                    "smooth surface; EMVA 1288 allows 3 %",
                ),
                helps=("light the array evenly, or crop the frames to their even part",),
            )


def _outliers(level: Level, good_mask: Mask, flat: bool) -> Mask:
    """Return a mask (rows, cols) of the pixels of `good_mask` whose mean converter code in `level`
    differs from the median by more than `OUTLIER` standard deviations.

    The standard deviation is estimated robustly. With `flat`, a smooth surface is subtracted
    first."""
    values = level.mean_map
    if flat:
        values = values - surface(values, good_mask)
    middle = float(np.median(values[good_mask]))
    # The standard deviation, estimated by the median absolute deviation.
    scale = 1.4826 * float(np.median(np.abs(values[good_mask] - middle)))
    noise = float(np.sqrt(level.variance[good_mask].mean() / level.frames))
    far = np.abs(values - middle) > OUTLIER * max(scale, noise, _LEAST_SCALE)
    return far & good_mask


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
