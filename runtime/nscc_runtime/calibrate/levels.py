"""The moments of a level: means of two halves, temporal variance, covariance of neighbours.

The noise of a level is the residual of its frames after subtracting every pixel's mean and every
frame's mean. For two frames this is half the squared difference, free of fixed patterns and of
drifts of the light. Fixed patterns are estimated by the covariance of two halves of the frames,
which is free of noise."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nscc.arrays import Bools, Floats, Ints
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.calibrate.frame_stacks import Stack

Map = Floats
Mask = Bools

QUIET = 0.24
"""Variance in squared codes below which rounding of the ADC hides the noise (EMVA 1288)."""
CLIPPED = 1e-4
"""A level is clipped if more than this fraction of its samples is at an end of the scale."""


@dataclass(frozen=True, eq=False)
class Level:
    """The moments of `frames` frames (2 or more) of one light and exposure time, in converter
    codes.

    `exposure_s`: seconds, None if unknown. `valid` (rows, cols): pixels valid in all frames.
    `halves` (2, rows, cols): the means of the even and of the odd frames. `variance` (rows, cols):
    variance over time. `beside` (rows, cols - 1), `below` (rows - 1, cols): covariance over time of
    a pixel and its neighbour. `at_zero`, `at_top` (rows, cols): number of frames in which the pixel
    had code 0 or the top code."""

    name: str
    exposure_s: float | None
    frames: int
    valid: Mask
    halves: Map
    variance: Map
    beside: Map
    below: Map
    at_zero: Ints
    at_top: Ints

    @property
    def mean_map(self) -> Map:
        """The mean of all frames, shape (rows, cols)."""
        even = (self.frames + 1) // 2
        total = self.halves[0] * even + self.halves[1] * (self.frames - even)
        return np.asarray(total / self.frames)


@dataclass(frozen=True)
class LevelMoments:
    """Moments of a level (frames of one light and exposure time) over its `pixels` good pixels, in
    converter codes.

    `exposure_s`: seconds, None if unknown. `mean_se`: standard error of `mean` from noise and
    rounding. `variance`: mean variance over time. `mean_rounding`, `rounding`: standard deviations
    that rounding adds to `mean`, and to `variance` beyond 1/12. `neighbours`: mean covariance of
    neighbouring pixels. `share_at_zero`, `share_at_top`: fractions of samples at the ends of the
    scale."""

    name: str
    exposure_s: float | None
    frames: int
    pixels: int
    mean: float
    mean_se: float
    mean_rounding: float
    variance: float
    rounding: float
    neighbours: float
    share_at_zero: float
    share_at_top: float

    @property
    def cut_at_zero(self) -> bool:
        """Whether the level is clipped at the converter code 0."""
        return self.share_at_zero > CLIPPED

    @property
    def cut_at_top(self) -> bool:
        """Whether the level is clipped at the largest converter code."""
        return self.share_at_top > CLIPPED


def level_of(stack: Stack, top_code: int) -> Level:
    """Return the moments of the frames of `stack`, whose largest possible converter code is
    `top_code`. Raises Rejected: NS0758 for a single frame, NS0757 for a frame that is repeated in a
    level with noise."""
    count = len(stack.codes)
    if count < 2:
        raise rejected(
            "NS0758",
            f"'{stack.name}' has one frame, but the noise needs at least two of the same light",
            helps=(
                "expose with --repeat K, or give a folder or an array (K, rows, cols) per level",
            ),
            data={"required": 2, "available": count},
        )
    codes = stack.codes
    halves = np.stack([codes[half::2].mean(axis=0, dtype=np.float64) for half in (0, 1)])
    mean = codes.mean(axis=0, dtype=np.float64)
    squares, beside, below = (np.zeros_like(template) for template in (mean, mean[:, 1:], mean[1:]))
    for frame in codes:
        residual = frame - mean
        residual -= residual.mean()  # light that varies between frames is no noise of pixels
        squares += residual * residual
        beside += residual[:, :-1] * residual[:, 1:]
        below += residual[:-1] * residual[1:]
    # Subtracting the means of N pixels and of the frames removes one part in N, of K - 1.
    variance = squares / (count - 1) * (mean.size / (mean.size - 1))
    removed = variance.mean() / mean.size
    level = Level(
        stack.name,
        stack.exposure_s,
        frames=count,
        valid=stack.valid,
        halves=halves,
        variance=variance,
        beside=beside / (count - 1) + removed,
        below=below / (count - 1) + removed,
        at_zero=np.count_nonzero(codes == 0, axis=0),
        at_top=np.count_nonzero(codes == top_code, axis=0),
    )
    # Frames with little noise may be equal by chance.
    noisy = not variance.mean() < QUIET
    if noisy and len({frame.tobytes() for frame in codes}) < count:
        raise rejected(
            "NS0757",
            f"'{stack.name}' has the same frame more than once",
            notes=("noise is the difference between frames: a copy makes it look smaller",),
            helps=("give each frame once; frames of the emulator need different seeds",),
        )
    return level


def moments(level: Level, good_mask: Mask) -> LevelMoments:
    """Return the moments of `level` over the pixels of `good_mask` (rows, cols). The covariance
    uses pairs of good pixels; it is 0 if there are none."""
    pixels = int(np.count_nonzero(good_mask))
    variance = float(level.variance[good_mask].mean())
    pairs = (
        level.beside[good_mask[:, :-1] & good_mask[:, 1:]],
        level.below[good_mask[:-1] & good_mask[1:]],
    )
    joined = np.concatenate(pairs)
    samples = pixels * level.frames
    spread = float(level.mean_map[good_mask].var()) - variance / level.frames
    of_mean, of_variance = _rounding(variance, max(spread, 0.0))
    return LevelMoments(
        level.name,
        level.exposure_s,
        frames=level.frames,
        pixels=pixels,
        mean=float(level.mean_map[good_mask].mean()),
        mean_se=float(np.sqrt(variance / samples + of_mean**2)),
        mean_rounding=of_mean,
        variance=variance,
        rounding=of_variance,
        neighbours=float(joined.mean()) if joined.size else 0.0,
        share_at_zero=float(level.at_zero[good_mask].sum() / samples),
        share_at_top=float(level.at_top[good_mask].sum() / samples),
    )


def _rounding(variance: float, spread: float) -> tuple[float, float]:
    """Return the standard deviations, in converter codes, that rounding adds to the mean and to the
    variance of a level. `variance` is its measured variance over time, `spread` the variance of the
    pixels' means, both in squared codes.

    For normal noise of variance v, rounded at fraction f of a code, the error of the mean is a
    sin(2 pi f) / pi and that of the variance 1/12 - a (4 v + 1 / pi^2) cos(2 pi f), a = exp(-2 pi^2
    v), without smaller terms. f is unknown. Pixels with different means have different fractions:
    their average adds a factor exp(-2 pi^2 spread)."""
    noise = max(variance - 1 / 12, 0.0)
    # 1 / sqrt(2) is the RMS of a sine over all fractions f.
    amplitude = np.exp(-2 * np.pi**2 * (noise + spread)) / np.sqrt(2)
    return float(amplitude / np.pi), float(amplitude * (4 * noise + np.pi**-2))
