"""Stages of the decoder: a projection towards the frames followed by denoising."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from torch import Tensor

from nscc_training.baselines.gap_tv import gap_step
from nscc_training.measured import Measured

Denoiser = Callable[[Tensor, Tensor, Tensor], Tensor]
"""A function of a clip, measurement planes and sigma; see `ClipDenoiser`."""

STAGES = 12
_SIGMA = (16 / 255, 12 / 255)
"""Assumed standard deviation of the clip's error before the first and before the last stage."""
_LEFT = 4 / 255
"""Assumed standard deviation of the clip's error after the last stage."""
_MIRRORS = ((), (-1,), (-2,), (-2, -1))
"""Axes along which clips are mirrored in successive stages: rows, columns."""


def schedule(count: int) -> list[float]:
    """Return the assumed error (sigma) before each of `count` stages."""
    return [float(sigma) for sigma in np.linspace(*_SIGMA, count)]


def stage(
    measured: Measured[Tensor], denoiser: Denoiser, clip: Tensor, target: Tensor, sigma: float
) -> tuple[Tensor, Tensor]:
    """Return clip and target after one stage of accelerated GAP (Liao, Li and Carin 2014).

    The target is the frames plus the residuals of earlier stages, which accelerates convergence."""
    level = clip.new_full((len(clip),), sigma)
    clip, target = gap_step(measured, clip, target, level)
    return denoiser(clip, measured.planes(), level), target


def mirrored(denoiser: Denoiser, number: int) -> Denoiser:
    """Return the denoiser for stage `number`, which sees the clip mirrored.

    Alternating mirrors prevents directional errors of the network from accumulating. This gains 0.2
    dB and takes no time."""
    axes = _MIRRORS[number % len(_MIRRORS)]

    def denoised(clip: Tensor, planes: Tensor, level: Tensor) -> Tensor:
        return denoiser(clip.flip(axes), planes.flip(axes), level).flip(axes)

    return denoised


def led(measured: Measured[Tensor], clip: Tensor) -> Tensor:
    """Return the last stage's clip, corrected once towards the frames."""
    gap = measured.missing(measured.of(clip), measured.value)
    return clip + measured.correction(gap, clip.new_full((len(clip),), _LEFT))
