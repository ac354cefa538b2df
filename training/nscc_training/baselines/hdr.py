"""High dynamic range from one coded frame without learning: each pixel asks its neighbours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.float64]

_OWN = 8.0
"""A pixel's own measurement counts so much more than a direct neighbour's."""


def merged(
    frame: NDArray[np.floating], open_share: Picture, electrons_per_lsb: float,
    saturated: NDArray[np.bool_], read_noise_e: float,
) -> Picture:  # fmt: skip
    """Light over the whole frame in electrons (rows, cols), from a frame's codes above the offset.

    `open_share` is the part of the frame for which each pixel was open. Every pixel's light is the
    mean of the measurements around it, weighted by their precision; saturated ones have none. The
    neighbourhood grows until a measurement is found. A saturated pixel has at least the light that
    saturates it.
    """
    exposure = frame.astype(np.float64) * electrons_per_lsb
    share = np.where(open_share > 0, open_share, 1.0)
    usable = ~saturated & (open_share > 0)
    variance = (exposure + read_noise_e**2 + electrons_per_lsb**2 / 12) / share**2
    precision = np.where(usable, 1.0 / variance, 0.0)
    light = exposure / share
    return merge_neighbours(
        light, precision, np.where(saturated & (open_share > 0), light, -np.inf)
    )


def merge_neighbours(light: Picture, precision: Picture, least: Picture) -> Picture:
    """Return the mean of the light around each pixel, weighted by precision, and at least `least`.

    The neighbourhood of a pixel grows until it holds a measurement of a precision above 0.
    """
    weighted = precision * light
    found = np.full(light.shape, np.nan)
    reach = 2
    while np.isnan(found).any() and reach <= 2 * max(light.shape):
        total = _tent(precision, reach) + (_OWN - 1) * precision
        value = _tent(weighted, reach) + (_OWN - 1) * weighted
        here = np.isnan(found) & (total > 0)
        found[here] = value[here] / total[here]
        reach *= 2
    return np.maximum(np.where(np.isnan(found), light, found), least)


def _tent(values: Picture, reach: int) -> Picture:
    """Sums over windows with weights that fall linearly to 0 at `reach` pixels."""
    weights = 1 - np.abs(np.arange(1 - reach, reach)) / reach
    found = values
    for axis in (0, 1):
        length = values.shape[axis]
        padded = np.pad(found, [(reach, reach) if a == axis else (0, 0) for a in (0, 1)])
        found = np.zeros_like(values)
        for k, weight in enumerate(weights):
            part = np.take(padded, np.arange(k + 1, k + 1 + length), axis=axis)
            found = found + weight * part
    return found
