"""High dynamic range from one coded frame without learning: weighted means of neighbours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools, Floats
from nscc_training.baselines.tent_loop import tent_sums

Picture = Floats

_OWN = 8.0
"""Weight of a pixel's own measurement relative to that of a direct neighbour."""


def merged(
    frame: NDArray[np.floating],
    open_share: Picture,
    electrons_per_lsb: float,
    saturated: Bools,
    read_noise_e: float,
) -> Picture:
    """Estimate the light over the whole frame in electrons (rows, cols), as if every pixel had
    always been open.

    All arrays are (rows, cols): `frame` are converter codes above the offset, each of
    `electrons_per_lsb`; `open_share` is the open fraction of the frame of each pixel, and
    `saturated` marks codes that are lower limits. `read_noise_e` is the standard deviation of the
    readout in electrons. The light of a pixel is the mean of the measurements around it, weighted
    by precision; saturated measurements have weight 0. The neighbourhood grows until it contains a
    measurement. A saturated pixel has at least the light that saturates it; one that never opens
    has its neighbours' light."""
    exposure = frame.astype(np.float64) * electrons_per_lsb
    share = np.where(open_share > 0, open_share, 1.0)
    usable = ~saturated & (open_share > 0)
    # Noise may give a dark pixel less than the offset, but photons have no negative variance.
    # Rounding to whole codes adds the variance 1 / 12 of a squared code.
    variance = (np.maximum(exposure, 0) + read_noise_e**2 + electrons_per_lsb**2 / 12) / share**2
    precision = np.where(usable, 1.0 / variance, 0.0)
    light = exposure / share
    return merge_neighbours(
        light, precision, np.where(saturated & (open_share > 0), light, -np.inf)
    )


def merge_neighbours(light: Picture, precision: Picture, least: Picture) -> Picture:
    """Return the mean of `light` (rows, cols) around each pixel, weighted by `precision`, and at
    least `least`.

    The neighbourhood of a pixel doubles until it holds a pixel with a precision above 0. If no
    pixel of the picture has one, the larger of `light` and `least` is returned. All are (rows,
    cols); `least` may be -inf."""
    weighted = precision * light
    result = light.copy()
    missing = np.full(light.shape, bool((precision > 0).any()))
    reach = 2
    while missing.any() and reach <= 2 * max(light.shape):
        # Sums are needed around the missing pixels only.
        part = tuple(_from_first_to_last(np.any(missing, axis=axis), reach) for axis in (1, 0))
        own, own_weighted = precision[part], weighted[part]
        # `tent_sums` counts a pixel itself once; the second term makes that `_OWN` times.
        total = tent_sums(own, reach) + (_OWN - 1) * own
        value = tent_sums(own_weighted, reach) + (_OWN - 1) * own_weighted
        fillable = missing[part] & (total > 0)
        result[part][fillable] = value[fillable] / total[fillable]
        missing[part] &= ~fillable
        reach *= 2
    return np.maximum(result, least)


def _from_first_to_last(marked: Bools, margin: int) -> slice:
    """Return the slice from the first to the last true element of `marked`, with `margin` more
    elements at both ends where the array has them. At least one element is true."""
    indices = np.flatnonzero(marked)
    return slice(max(0, int(indices[0]) - margin), int(indices[-1]) + margin + 1)
