"""Frames drawn from the moments of a scene: one count and one normal number for each pixel and
bucket."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from nscc.arrays import Floats, Ints
from nscc.mappings import NamedValues
from nscc_runtime.execution.block_draws import DRAW_BLOCK, ROOM
from nscc_runtime.execution.frame_loop import ROWS_KEPT, Adding, add_up
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
    # Errors of words are drawn for all words of a pixel together.
    count_draws, (error_draws, _, lanes) = len(moments.count_means), moments.error_e.shape
    exposure = np.empty((buckets, pixels))
    sizes: NamedValues = {
        "rows": rows,
        "cols": cols,
        "pixels": pixels,
        "buckets": buckets,
        "lane_count": lanes,
        "count_draws": count_draws,
        "error_draws": error_draws,
        "exchanges": moments.exchanged > 0 and count_draws > 0,
        "fraction": moments.exchanged,
    }
    shared: NamedValues = {
        "count_keys": keys(seed, SUMS, COUNTS, number, count_draws),
        "noise_keys": keys(seed, SUMS, ERRORS, number, error_draws),
        "lanes": moments.lane.reshape(-1),
        "places": _places(pixels),
        "expected": moments.mean_e,
        "count_means": moments.count_means,
        "own_weights": moments.own_weights,
        "neighbour_weights": moments.neighbour_weights,
        "sigma": moments.error_e,
        "exposure": exposure,
    }

    def run(begin: int, end: int) -> None:
        """Draw the exposures of the rows from `begin` up to before `end` into `exposure`."""
        add_up(
            adding=Adding(begin=begin, end=end, **sizes),
            **shared,
            values=np.empty(DRAW_BLOCK),
            scratch=np.empty(ROOM),
            pending_rates=np.empty(DRAW_BLOCK),
            pending_pixels=np.empty(DRAW_BLOCK, np.int64),
            away=np.empty(ROWS_KEPT * count_draws * cols),
            drawn=np.empty(cols),
        )

    in_parts(run, rows, threads)
    return exposure
