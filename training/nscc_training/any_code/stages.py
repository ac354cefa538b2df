"""A few stages of projection and denoising: from frames of any code to a clip."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from nscc_training.any_code.measured import Measured
from nscc_training.baselines.tv import tv_denoise

Denoiser = Callable[[Tensor, Tensor, Tensor], Tensor]
"""From a clip, planes of what is measured, and sigma: see `ClipDenoiser`."""

STAGES = 12
START = 20
"""Iterations of GAP-TV that the stages begin with."""
_SIGMA = (16 / 255, 12 / 255)
"""How wrong a clip is taken to be before the first stage and before the last."""
_LEFT = 4 / 255
"""The same of what the last stage gives."""
_TV_WEIGHT, _TV_INNER, _TV_TIME = 0.1, 5, 0.3
_MIRRORS = ((), (-1,), (-2,), (-2, -1))
"""Axes of clips along which stage after stage is mirrored: rows, columns."""
_FAR = 1.0
"""What a clip is taken to be wrong by while GAP-TV runs: frames are believed as they are."""


def started(measured: Measured, iterations: int = START) -> tuple[Tensor, Tensor]:
    """GAP-TV of so many iterations: the clip (batch, N, rows, cols), and its target as `stage`
    takes it. Frames in several buckets, saturated and noisy ones too.

    It begins with a clip in which nothing moves, each pixel's light spread over the frame. From a
    dark one light would come only to slots that are open, and by smoothing to those near them: of
    64 slots, of which some are open nowhere, these would stay a fifth too dark.
    """
    far = measured.value.new_full((len(measured.value),), _FAR)
    target = measured.value
    clip = measured.mean().unsqueeze(1).expand(-1, measured.mask.shape[2], -1, -1)
    for _ in range(iterations):
        clip, target = _stepped(measured, clip, target, far)
        clip = torch.from_numpy(np.stack([_smoothed(part) for part in clip.cpu().numpy()])).to(clip)
    return clip, target


def schedule(count: int) -> list[float]:
    """Sigma of each of `count` stages."""
    return [float(sigma) for sigma in np.linspace(*_SIGMA, count)]


def stage(
    measured: Measured, denoiser: Denoiser, clip: Tensor, target: Tensor, sigma: float
) -> tuple[Tensor, Tensor]:
    """Clip and target after a stage of accelerated GAP (Liao, Li and Carin 2014), from those that
    the one before or `started` left: what frames still lack is asked for again and again."""
    level = clip.new_full((len(clip),), sigma)
    clip, target = _stepped(measured, clip, target, level)
    return denoiser(clip, measured.planes(), level), target


def mirrored(denoiser: Denoiser, number: int) -> Denoiser:
    """The denoiser as stage `number` has it: it sees the clip mirrored, each stage in another way.
    What it has learned of left and right by chance is then not added to the clip again and again:
    worth 0.2 dB, and no time."""
    axes = _MIRRORS[number % len(_MIRRORS)]

    def denoised(clip: Tensor, planes: Tensor, level: Tensor) -> Tensor:
        return denoiser(clip.flip(axes), planes.flip(axes), level).flip(axes)

    return denoised


def led(measured: Measured, clip: Tensor) -> Tensor:
    """The clip of the last stage led to what the frames say of it, and asked for no more."""
    gap = measured.missing(measured.of(clip), measured.value)
    return clip + measured.correction(gap, clip.new_full((len(clip),), _LEFT))


def _smoothed(clip: NDArray[np.float32]) -> NDArray[np.float32]:
    return tv_denoise(clip, _TV_WEIGHT, _TV_INNER, _TV_TIME)


def _stepped(
    measured: Measured, clip: Tensor, target: Tensor, sigma: Tensor
) -> tuple[Tensor, Tensor]:
    """A clip led towards the frames, and the frames as they are asked for from now on."""
    seen = measured.of(clip)
    target = target + measured.missing(seen, measured.value) * measured.trust(sigma)
    return clip + measured.correction(measured.missing(seen, target), sigma), target
