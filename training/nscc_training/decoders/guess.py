"""First guesses from a frame and its code, without training, which networks improve.

Each pixel is a weighted mean of the measurements around it (normalised averaging). Where weights
are small, wider neighbourhoods count more. Gradients pass."""

from __future__ import annotations

from typing import Any

import torch
from torch import Tensor
from torch.autograd import Function
from torch.nn import functional

READ_VARIANCE = 7.5e-6
"""Variance of the readout, in codes over the top code: 0.65 LSB of noise and the rounding of 8
bits."""
SHOT_VARIANCE = 1 / 30000
"""Variance of photon noise per unit of the frame, at a full well of 30,000 e."""
_OWN = 8.0
"""Weight of a pixel's own measurement relative to that of a direct neighbour."""
_FAINT = 0.01
"""Weight of the wider neighbourhood, smaller than that of any measurement of a still."""


def still_guess(frame: Tensor, share: Tensor) -> Tensor:
    """Estimate the light of a still over the whole frame, (batch, rows, cols) in full wells.

    `frame` (batch, rows, cols) is in full wells, and saturated from 1. `share` is the open fraction
    of the frame of each pixel, of the same shape or without the batch. Each pixel is the mean
    around it, weighted by precision. Saturated measurements have weight 0; a saturated pixel gets
    at least the light that saturates it, and one that never opens its neighbours' light. Raises
    ValueError for values that are not finite."""
    opened = share.clamp(min=1e-6)
    pixel_light = frame / opened
    refuse_not_finite(frame, "frame")
    saturated = frame >= 1
    noise = READ_VARIANCE + SHOT_VARIANCE * frame.clamp(min=0)
    precision = torch.where(saturated | (share <= 0), torch.zeros_like(frame), share**2 / noise)
    guess = averaged(pixel_light.unsqueeze(1), precision.unsqueeze(1)).squeeze(1)
    return torch.where(saturated, torch.maximum(guess, pixel_light), guess)


def clip_guess(volume: Tensor, *opened: Tensor) -> Tensor:
    """Estimate the light of a clip (batch, N, rows, cols) slot by slot.

    `volume` (batch, N, rows, cols) is S^T E, the frame copied to the slots in which each pixel was
    open (`lifted`). `opened` are the shutters (N, rows, cols) of each bucket. Each slot is the
    weighted mean of the pixels that are open in it. The weight of a pixel is the inverse of the
    number of its open slots. Raises ValueError for values that are not finite."""
    refuse_not_finite(volume, "volume")
    weight = torch.stack([shutter / shutter.sum(dim=0).clamp(min=1) for shutter in opened]).sum(
        dim=0
    )
    return averaged(volume, weight.unsqueeze(0).expand_as(volume))


def refuse_not_finite(values: Tensor, name: str) -> None:
    """Raise ValueError if any value is not finite; an average would spread it over the picture.
    `name` names the values in the message."""
    if torch.compiler.is_compiling():  # compiled code cannot branch on values
        return
    count = int((~torch.isfinite(values.detach())).sum())
    if count:
        raise ValueError(
            f"{count} of {values.numel()} values of the {name} are not finite; "
            "leave these pixels out, for instance as never open (share 0)"
        )


def averaged(values: Tensor, weights: Tensor) -> Tensor:
    """Return the weighted mean around every pixel of `values` (batch, channels, rows, cols).

    `weights`, at least 0, has the same shape; where all weights are 0, so is the mean. The mean is
    over the 3 x 3 neighbours; where their weights are small, over wider neighbourhoods, up to the
    whole picture. Autocast is switched off, so that the inputs' precision is kept."""
    with torch.autocast(values.device.type, enabled=False):
        totals = [tuple(_tent(plane) for plane in (values * weights, weights))]
        while max(totals[-1][0].shape[-2:]) > 1:
            totals.append(
                tuple(functional.avg_pool2d(plane, 2, ceil_mode=True) for plane in totals[-1])
            )
        value, weight = totals.pop()
        mean = value / weight.clamp(min=1e-12)
        while totals:
            value, weight = totals.pop()
            wide = functional.interpolate(
                mean, size=value.shape[-2:], mode="bilinear", align_corners=False
            )
            mean = (value + _FAINT * wide) / (weight + _FAINT)
        return mean


class _Tent(Function):
    """A convolution with a tent of 3 x 3 pixels. Its own gradient is faster than torch's for
    convolutions of single channels."""

    @staticmethod
    def forward(_ctx: Any, x: Tensor) -> Tensor:
        """Return x (batch, channels, rows, cols) convolved, channel by channel, with a 3 x 3 tent
        that weights the pixel itself by `_OWN`."""
        kernel = torch.tensor([[0.25, 0.5, 0.25], [0.5, _OWN, 0.5], [0.25, 0.5, 0.25]])
        channels = x.shape[1]
        stacked = kernel.to(x).expand(channels, 1, 3, 3)
        return functional.conv2d(x, stacked, padding=1, groups=channels)

    @staticmethod
    def backward(_ctx: Any, grad: Tensor) -> Tensor:
        """Return the gradient of x: the tent is symmetric, so it is the tent of the gradient."""
        return _tent(grad)


def _tent(x: Tensor) -> Tensor:
    """Return the weighted sum over the 3 x 3 pixels around each pixel of (batch, channels, rows,
    cols).

    Direct neighbours have the weight 1/2, diagonal ones 1/4, the pixel itself `_OWN`. Beyond the
    border values are 0."""
    sums: Tensor = _Tent.apply(x)  # type: ignore[no-untyped-call]
    return sums
