"""The two ways in which the product draws Poisson counts of pixels, for tests of both."""

from __future__ import annotations

import numpy as np

from nscc_runtime.execution.block_draws import DRAW_BLOCK, ROOM
from nscc_runtime.execution.count_loop import Counting, draw_counts
from nscc_runtime.noise import poisson


def by_plan(stream: np.uint64, pixels: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """Counts of frames by weighted sums, for rates below the cap."""
    pixels, rates = np.ravel(pixels), np.ravel(rate)
    away = np.zeros((1, len(rates)))
    draw_counts(
        counting=Counting(begin=0, end=len(rates), pixels=len(rates), groups=1, accumulates=0),
        keys=np.array([stream], np.uint64),
        rates=rates[None],
        places=pixels,
        values=np.empty(DRAW_BLOCK),
        scratch=np.empty(ROOM),
        pending_rates=np.empty(DRAW_BLOCK),
        pending_pixels=np.empty(DRAW_BLOCK, np.int64),
        away=away,
    )
    # A rate that is not finite has no deviation.
    with np.errstate(invalid="ignore"):
        counts = np.where(np.isfinite(rates), np.rint(away[0] + rates), 0.0)
    return counts.reshape(np.shape(rate)) + 0.0


def by_reference(stream: np.uint64, pixels: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """Counts of the reference."""
    return poisson(stream, pixels, rate)[0]


BOTH = (by_reference, by_plan)
