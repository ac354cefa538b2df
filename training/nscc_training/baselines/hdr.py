"""High dynamic range from one coded frame without learning: weighted means of neighbours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.float64]

_OWN = 8.0
"""Weight of a pixel's own measurement relative to that of a direct neighbour."""


def merged(
    frame: NDArray[np.floating], open_share: Picture, electrons_per_lsb: float,
    saturated: NDArray[np.bool_], read_noise_e: float,
) -> Picture:  # fmt: skip
    """Estimate the light over the whole frame in electrons (rows, cols), from codes above the
    offset.

    `open_share` is the open fraction of the frame of each pixel. The light of a pixel is the mean
    of the measurements around it, weighted by precision; saturated measurements have weight 0. The
    neighbourhood grows until it contains a measurement. A saturated pixel has at least the light
    that saturates it."""
    exposure = frame.astype(np.float64) * electrons_per_lsb
    share = np.where(open_share > 0, open_share, 1.0)
    usable = ~saturated & (open_share > 0)
    # Noise may give a dark pixel less than the offset, but photons have no negative variance.
    variance = (np.maximum(exposure, 0) + read_noise_e**2 + electrons_per_lsb**2 / 12) / share**2
    precision = np.where(usable, 1.0 / variance, 0.0)
    light = exposure / share
    return merge_neighbours(
        light, precision, np.where(saturated & (open_share > 0), light, -np.inf)
    )


def merge_neighbours(light: Picture, precision: Picture, least: Picture) -> Picture:
    """Return the mean of the light around each pixel, weighted by precision, and at least `least`.

    The neighbourhood of a pixel grows until it holds a measurement of a precision above 0."""
    weighted = precision * light
    result = np.full(light.shape, np.nan)
    reach = 2
    while np.isnan(result).any() and reach <= 2 * max(light.shape):
        total = tent_sums(precision, reach) + (_OWN - 1) * precision
        value = tent_sums(weighted, reach) + (_OWN - 1) * weighted
        fillable = np.isnan(result) & (total > 0)
        result[fillable] = value[fillable] / total[fillable]
        reach *= 2
    return np.maximum(np.where(np.isnan(result), light, result), least)


def tent_sums(values: Picture, reach: int) -> Picture:
    """Sum over windows with weights that fall linearly to 0 at `reach` pixels."""
    weights = 1 - np.abs(np.arange(1 - reach, reach)) / reach
    sums = values
    for axis in (0, 1):
        length = values.shape[axis]
        padded = np.pad(sums, [(reach, reach) if a == axis else (0, 0) for a in (0, 1)])
        sums = np.zeros_like(values)
        for k, weight in enumerate(weights):
            shifted = np.take(padded, np.arange(k + 1, k + 1 + length), axis=axis)
            sums = sums + weight * shifted
    return sums
