"""Stills from frames of any code: neighbours say what a pixel's own exposure does not.

A still is denoised as `log(1 + light / floor)`, where errors of bright and dark pixels weigh alike.
Its frames have masks of one slot: the part of the frame that each pixel was open for.
"""

from __future__ import annotations

from math import log

import numpy as np
import torch
from torch import Tensor

from nscc_training.any_code.stages import Denoiser
from nscc_training.decoders.guess import averaged
from nscc_training.measured import Measured

STILL_STAGES = 1
"""More add nothing, with the weights that are shipped."""
_SIGMA = (0.05, 0.02)
"""How wrong the logarithm is taken to be before the first stage and before the last of several."""
_FLOOR = 1e-3
"""Of the light that is 1: about what fills a well over the whole frame."""
_SPAN = log(1 + 200 / _FLOOR)
"""The logarithm of light that few scenes reach; 1 for the denoiser."""


def started_still(measured: Measured[Tensor]) -> Tensor:
    """Light over the frame (batch, rows, cols): every pixel's is the mean of what it and those
    around it say, each by its precision; a saturated pixel has at least the light that saturates
    it.
    """
    mask = measured.mask[:, :, 0]
    opened = (mask > 0).expand_as(measured.value)
    alone = torch.where(opened, measured.value / mask.clamp(min=1e-9), 0.0)
    precision = mask.square() / measured.variance.clamp(min=1e-20)
    precision = torch.where(opened & ~measured.saturated, precision, 0.0)
    total = precision.sum(dim=1)
    pixel_light = (precision * alone).sum(dim=1) / total.clamp(min=1e-20)
    # Relative to the frame's own scale, so that a measurement counts more than wide surroundings.
    scale = measured.value.abs().amax(dim=(1, 2, 3)).clamp(min=1e-9).square().reshape(-1, 1, 1)
    light = averaged(pixel_light.unsqueeze(1), (total * scale).unsqueeze(1)).squeeze(1)
    least = torch.where(opened & measured.saturated, alone, 0.0).amax(dim=1)
    return torch.maximum(light, least)


def still_schedule(count: int) -> list[float]:
    """Sigma of each of `count` stages."""
    return [float(sigma) for sigma in np.linspace(*_SIGMA, count)]


def still_stage(
    measured: Measured[Tensor], denoiser: Denoiser, light: Tensor, sigma: float
) -> Tensor:
    """Light after a stage: the most likely one between what it was and what the frames say, then
    denoised. The unit is such that a well is filled by light of about 1."""
    spread = sigma * _SPAN * (light + _FLOOR)
    mask = measured.mask[:, :, 0]
    data_precision = mask.square() / measured.variance.clamp(min=1e-12)
    gap = measured.missing(mask * light.unsqueeze(1), measured.value)
    # What saturated pixels have anyhow tells nothing more.
    data_precision = torch.where(measured.saturated & (gap <= 0), 0.0, data_precision)
    step = (data_precision * gap / mask.clamp(min=1e-9)).sum(dim=1)
    light = (light + step / (spread.pow(-2) + data_precision.sum(dim=1))).clamp(min=0)
    level = light.new_full((len(light),), sigma)
    denoised = denoiser(coded_light(light).unsqueeze(1), _planes(measured), level)[:, 0]
    return light_of(denoised)


def coded_light(light: Tensor) -> Tensor:
    """The logarithm of light, as the denoiser has it."""
    return torch.log1p(light.clamp(min=0) / _FLOOR) / _SPAN


def light_of(coded: Tensor) -> Tensor:
    """The inverse of `coded_light`."""
    return torch.expm1(coded.float().clamp(0, 1.5) * _SPAN) * _FLOOR


def _planes(measured: Measured[Tensor]) -> Tensor:
    """(batch, 3, 1, rows, cols): how long pixels were open, what they say alone, and how sure that
    is, all as logarithms; where several frames say something, the surest."""
    mask = measured.mask[:, :, 0]
    opened = mask > 0
    alone = torch.where(opened, measured.value / mask.clamp(min=1e-9), 0.0).clamp(min=0)
    noise = measured.variance.sqrt() / mask.clamp(min=1e-9) / (alone + _FLOOR) / _SPAN
    noise = torch.where(opened & ~measured.saturated, noise.clamp(max=0.5), 1.0)
    noise, best = noise.min(dim=1, keepdim=True)
    share = torch.log2(mask.clamp(min=2.0**-12)).expand_as(alone) / 12 + 1
    planes = [share.gather(1, best), coded_light(alone.gather(1, best)), noise]
    return torch.stack(planes, dim=1)
