"""A few stages of projection and denoising: from frames of any code to a clip."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from torch import Tensor

from nscc_training.baselines.gap_tv import gap_step
from nscc_training.measured import Measured

Denoiser = Callable[[Tensor, Tensor, Tensor], Tensor]
"""From a clip, planes of what is measured, and sigma: see `ClipDenoiser`."""

STAGES = 12
_SIGMA = (16 / 255, 12 / 255)
"""How wrong a clip is taken to be before the first stage and before the last."""
_LEFT = 4 / 255
"""The same of what the last stage gives."""
_MIRRORS = ((), (-1,), (-2,), (-2, -1))
"""Axes of clips along which stage after stage is mirrored: rows, columns."""


def schedule(count: int) -> list[float]:
    """Sigma of each of `count` stages."""
    return [float(sigma) for sigma in np.linspace(*_SIGMA, count)]


def stage(
    measured: Measured[Tensor], denoiser: Denoiser, clip: Tensor, target: Tensor, sigma: float
) -> tuple[Tensor, Tensor]:
    """Clip and target after a stage of accelerated GAP (Liao, Li and Carin 2014), from those that
    the one before or `gap_tv_of` left: what frames still lack is asked for again and again."""
    level = clip.new_full((len(clip),), sigma)
    clip, target = gap_step(measured, clip, target, level)
    return denoiser(clip, measured.planes(), level), target


def mirrored(denoiser: Denoiser, number: int) -> Denoiser:
    """The denoiser as stage `number` has it: it sees the clip mirrored, each stage in another way.
    What it has learned of left and right by chance is then not added to the clip again and again:
    worth 0.2 dB, and no time."""
    axes = _MIRRORS[number % len(_MIRRORS)]

    def denoised(clip: Tensor, planes: Tensor, level: Tensor) -> Tensor:
        return denoiser(clip.flip(axes), planes.flip(axes), level).flip(axes)

    return denoised


def led(measured: Measured[Tensor], clip: Tensor) -> Tensor:
    """The clip of the last stage led to what the frames say of it, and asked for no more."""
    gap = measured.missing(measured.of(clip), measured.value)
    return clip + measured.correction(gap, clip.new_full((len(clip),), _LEFT))
