"""Measurement of motion and texture of a clip, for the closed form."""

from __future__ import annotations

from math import log
from typing import Any

import numpy as np
from numpy.typing import NDArray

Clip = NDArray[np.floating]

_BLOCK = 32
_LEAST_CONTRAST = 0.02
"""Smallest contrast (standard deviation divided by mean) of blocks that are measured."""
_SEEN = 4.0
"""Largest displacement in pixels that phase correlation measures reliably."""
_SHARES = (0.1, 0.3, 0.5, 0.7, 0.9)
"""Quantiles of the speeds, weighted by contrast, that represent the distribution."""


def speeds_of(clip: Clip) -> tuple[float, ...]:
    """Return five representative speeds of a clip's blocks, in pixels over the whole clip.

    The clip is (T, rows, cols); speeds are measured by phase correlation. All are 0 for a clip of
    one frame or without contrast."""
    import cv2

    _, rows, cols = clip.shape
    side = min(_BLOCK, rows, cols)
    window = cv2.createHanningWindow((side, side), cv2.CV_64F) if side > 1 else None
    moves, weights = [0.0], [1e-12]
    if window is not None:
        for row in range(0, rows - side + 1, side):
            for col in range(0, cols - side + 1, side):
                block = np.asarray(clip[:, row : row + side, col : col + side], np.float64)
                contrast = float(block.std(axis=(1, 2)).mean() / max(block.mean(), 1e-30))
                if contrast < _LEAST_CONTRAST:
                    continue
                moves.append(_speed(cv2, block, window))
                weights.append(contrast)
    order = np.argsort(moves)
    share = np.cumsum(np.array(weights)[order])
    places = np.searchsorted(share / share[-1], _SHARES)
    return tuple(float(speed) * len(clip) for speed in np.array(moves)[order][places])


def texture_of(picture: NDArray[np.floating]) -> tuple[float, float]:
    """Return light's correlation length in pixels, and its contrast, sd over mean."""
    spread = float(picture.var())
    contrast = spread**0.5 / max(float(picture.mean()), 1e-30)
    steps = [np.diff(picture, axis=axis) for axis in (0, 1) if picture.shape[axis] > 1]
    if spread <= 0 or not steps:
        return 1.0, max(contrast, 0.1)
    alike = 1 - np.mean([float(np.square(step).mean()) for step in steps]) / (2 * spread)
    return float(np.clip(-1 / log(np.clip(alike, 0.1, 0.99)), 0.5, 50)), max(contrast, 0.1)


def _speed(cv2: Any, block: NDArray[np.float64], window: NDArray[Any]) -> float:
    """Return the speed of a block (T, rows, cols) in pixels per frame: the median over its frames.

    For slow motion, frames further apart are compared."""

    def median(gap: int) -> float:
        shifts = [
            np.hypot(*cv2.phaseCorrelate(earlier, later, window)[0])
            for earlier, later in zip(block[:-gap], block[gap:], strict=True)
        ]
        return float(np.median(shifts)) / gap

    last = len(block) - 1
    if last < 1:
        return 0.0
    gap = int(_SEEN / max(median(1), _SEEN / last))
    return median(max(1, gap))
