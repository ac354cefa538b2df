"""Select pixels: exclude defects, and check that flats are flat."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.calibrate.levels import Level, Mask, moments
from nscc_runtime.calibrate.line_fit import surface
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
