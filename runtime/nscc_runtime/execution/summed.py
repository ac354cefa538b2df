"""Frames drawn from the moments of a scene: one count and one normal number for each pixel and
bucket."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from nscc.arrays import Floats, Ints
from nscc.mappings import NamedValues
from nscc_runtime.execution.block_draws import DRAW_BLOCK
from nscc_runtime.execution.count_loop import draw_deviations
from nscc_runtime.execution.frame_loop import Adding, add_up
from nscc_runtime.execution.moments import Moments
from nscc_runtime.noise import keys
from nscc_runtime.pool import in_parts

SUMS, COUNTS, ERRORS = 0, 1, 2
"""Random stream of frames by sums (effects have streams from 1), and its source numbers."""


@lru_cache(2)
def _places(pixels: int) -> Ints:
    """Return the places 0 to `pixels` - 1, cached; callers must not change them."""
    return np.arange(pixels, dtype=np.int64)


def draw_exposures(moments: Moments, seed: int, number: int, threads: int) -> Floats:
    """Return the exposures of frame `number`, in electrons, (buckets, pixels), drawn from the
    moments of its scene without saturation.

    `seed`: of the noise. Results do not depend on `threads`."""
    (rows, cols), (buckets, pixels) = moments.lane.shape, moments.mean_e.shape
    places = _places(pixels)
    # Deviations of photon and dark counts, which the loop spreads over buckets and neighbours.
    away = np.empty((0, pixels))
    if len(moments.count_means):
        sources = [(SUMS, COUNTS, moments.count_means)]
        away = draw_deviations(sources, places, seed, number, threads)
    # Errors of words are drawn for all words of a pixel together.
    error_draws, _, lanes = moments.error_e.shape
    noise_keys = keys(seed, SUMS, ERRORS, number, error_draws)
    sizes: NamedValues = {
        "rows": rows,
        "cols": cols,
        "pixels": pixels,
        "buckets": buckets,
        "lane_count": lanes,
        "count_draws": len(away),
        "error_draws": error_draws,
        "exchanges": moments.exchanged > 0 and len(away) > 0,
        "fraction": moments.exchanged,
    }
    exposure = np.empty((buckets, pixels))

    def run(begin: int, end: int) -> None:
        """Draw the exposures of the rows from `begin` up to before `end` into `exposure`."""
        add_up(
            adding=Adding(begin=begin, end=end, **sizes),
            noise_keys=noise_keys,
            lanes=moments.lane.reshape(-1),
            places=places,
            expected=moments.mean_e,
            away=away,
            own_weights=moments.own_weights,
            neighbour_weights=moments.neighbour_weights,
            sigma=moments.error_e,
            total=np.empty(DRAW_BLOCK * buckets),
            drawn=np.empty(DRAW_BLOCK),
            exposure=exposure,
        )

    in_parts(run, rows, threads)
    return exposure
