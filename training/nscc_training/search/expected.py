"""Expected information of a code about moving light, in closed form, and measurement of motion.

The light is modelled as a Gaussian texture that moves uniformly. Its correlation falls as exp(-d /
L) with the distance d that remains after the motion is undone. The light is estimated from a frame
by linear least squares (Wiener) under the sensor's noise, for a decoder that knows the speed but
not the direction. The decibels are averaged over several speeds."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from math import log
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Array, Floats

_WINDOW, _STEP = 8, 4
"""Side of a window of measurements, and side of its middle, whose light is estimated, in places."""
_MOST_WINDOWS = 4
"""Most windows of a tile that are computed; their results are averaged."""
_MOST_SLOTS = 16
"""Most time steps; longer frames are averaged to this number."""
_HEADINGS = 0.3 + np.arange(8) * np.pi / 4
"""Directions of motion in radians, none along an axis or diagonal, where patterns would
coincide."""


class Motion(NamedTuple):
    """A model of moving light, whose correlation falls exponentially with distance.

    `speeds` are in pixels per frame time, with equal probability. `length` is the distance in
    pixels at which the correlation is 1 / e. `contrast` is the standard deviation of the light
    divided by its mean. `noise` is the variance of a frame's value, and `counts` its increase per
    unit of light; both are relative to the squared mean light of all slots."""

    speeds: tuple[float, ...]
    length: float = 12.0
    contrast: float = 0.8
    noise: float = 1e-4
    counts: float = 1e-4


def told_db(opened: NDArray[np.floating], motion: Motion) -> float:
    """Return by how many dB a frame with these shutters reduces the variance of the estimated light
    of one slot, averaged over the speeds of `motion`.

    `opened` (N, rows, cols), 0 to 1, is a tile; more than `_MOST_SLOTS` slots are averaged to that
    number."""
    # At most `_MOST_SLOTS` time steps: longer frames are averaged.
    groups = np.array_split(np.asarray(opened, np.float64), min(len(opened), _MOST_SLOTS))
    windows = _windows(np.stack([group.mean(axis=0) for group in groups]))
    decibels = []
    for speed in motion.speeds:
        alike = _alike(len(windows[0]), speed, motion.length)
        unknown_share = np.mean([_unknown_share(window, alike, motion) for window in windows])
        decibels.append(-10 * np.log10(unknown_share))
    return float(np.mean(decibels))


def _unknown_share(opened: Floats, alike: Floats, motion: Motion) -> float:
    """Return the variance of the light in a window's middle that remains after the measurement, as
    a fraction of its variance before.

    `opened` (N, pixels) are the shutters in the window. `alike` (N, N, pixels, pixels) is the
    correlation of light between pairs of slots and of pixels. `motion` gives noise and contrast."""
    # Covariance of light and measurements (slot, place, measurement), and of measurements.
    covariance = np.einsum("tspq,sq->tpq", alike, opened)
    frame = np.einsum("tp,tpq->pq", opened, covariance)
    slots = len(opened)
    # All are relative to the square of a slot's mean light times the contrast.
    noise = motion.noise + motion.counts * opened.sum(axis=0) / slots
    # 1e-9 keeps the matrix regular where pixels never open.
    inverse = np.linalg.inv(frame + np.diag(noise * (slots / motion.contrast) ** 2 + 1e-9))
    middle = covariance[:, _MIDDLE].reshape(-1, len(inverse))
    return float(1 - np.einsum("aq,aq->a", middle @ inverse, middle).mean())


@cache
def _alike(slots: int, speed: float, length: float) -> Floats:
    """Return the correlation of light between the pixels of a window in all pairs of slots, (slots,
    slots, pixels, pixels). The light moves at `speed` (pixels per frame time) in one of eight
    directions.

    `length` is the distance in pixels at which the correlation falls to 1 / e."""
    lag = np.subtract.outer(np.arange(slots), np.arange(slots))[:, :, None, None] / slots
    y, x = np.divmod(np.arange(_WINDOW**2), _WINDOW)
    away_y, away_x = np.subtract.outer(y, y), np.subtract.outer(x, x)
    correlation = np.zeros((slots, slots, _WINDOW**2, _WINDOW**2))
    for down, right in speed * np.stack([np.sin(_HEADINGS), np.cos(_HEADINGS)], axis=1):
        correlation += np.exp(-np.hypot(away_y - down * lag, away_x - right * lag) / length)
    return correlation / len(_HEADINGS)


def _windows(opened: Floats) -> Sequence[Floats]:
    """Return at most `_MOST_WINDOWS` windows of the shutters, each (N, pixels), evenly spaced over
    the repeating tile `opened` (N, rows, cols). Pixels are row by row, and windows continue beyond
    the edge of the tile with its repetition."""
    _, rows, cols = opened.shape
    origins = [(y, x) for y in range(0, rows, _STEP) for x in range(0, cols, _STEP)]
    stride = -(-len(origins) // _MOST_WINDOWS)
    side = np.arange(_WINDOW)
    return [
        opened[:, (y + side[:, None]) % rows, (x + side) % cols].reshape(len(opened), -1)
        for y, x in origins[::stride]
    ]


_INNER = np.abs(np.arange(_WINDOW) - (_WINDOW - 1) / 2) < _STEP / 2
_MIDDLE = np.flatnonzero(_INNER[:, None] & _INNER)
"""The pixels of the middle of a window."""


_BLOCK = 32
"""Side in pixels of the blocks whose speed is measured."""
_LEAST_CONTRAST = 0.02
"""Smallest contrast (standard deviation divided by mean) of blocks that are measured."""
_SEEN = 4.0
"""Largest displacement in pixels that phase correlation measures reliably."""
_SHARES = (0.1, 0.3, 0.5, 0.7, 0.9)
"""Quantiles of the speeds, weighted by contrast, that represent the distribution."""


def speeds_of(clip: NDArray[np.floating]) -> tuple[float, ...]:
    """Return five representative speeds of the blocks of a clip (T, rows, cols), in pixels over the
    whole clip.

    They are quantiles, weighted by contrast, of speeds that phase correlation measures. They
    increase. All are 0 for a clip of one frame or without contrast; pixels beyond whole blocks are
    left out."""
    import cv2

    _, rows, cols = clip.shape
    side = min(_BLOCK, rows, cols)
    window = cv2.createHanningWindow((side, side), cv2.CV_64F) if side > 1 else None
    # One block at rest with almost no weight: all quantiles are 0 if no block has contrast.
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
    indices = np.searchsorted(share / share[-1], _SHARES)
    return tuple(float(speed) * len(clip) for speed in np.array(moves)[order][indices])


def texture_of(picture: NDArray[np.floating]) -> tuple[float, float]:
    """Return the correlation length of a picture (rows, cols) in pixels, 0.5 to 50, and its
    contrast, the standard deviation divided by the mean, at least 0.1. A picture of equal pixels,
    or of one, has the length 1."""
    spread = float(picture.var())
    contrast = spread**0.5 / max(float(picture.mean()), 1e-30)
    steps = [np.diff(picture, axis=axis) for axis in (0, 1) if picture.shape[axis] > 1]
    if spread <= 0 or not steps:
        return 1.0, max(contrast, 0.1)
    # For unit distance: the mean squared difference of neighbours is 2 variance (1 - correlation).
    alike = 1 - np.mean([float(np.square(step).mean()) for step in steps]) / (2 * spread)
    return float(np.clip(-1 / log(np.clip(alike, 0.1, 0.99)), 0.5, 50)), max(contrast, 0.1)


def _speed(cv2: Any, block: Floats, window: Array) -> float:
    """Return the speed of a block (T, rows, cols) in pixels per frame: the median over its frames;
    0 for a single frame.

    For slow motion, frames further apart are compared, because phase correlation measures whole
    pixels best. `window` weights the pixels of the block. `cv2` is the imported package, which is
    loaded only when needed."""

    def median(gap: int) -> float:
        """Return the median shift between frames that are `gap` apart, divided by `gap`: pixels per
        frame."""
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
