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
    """Estimate the light of a still over the whole frame, in full wells, from `frame` (batch, rows,
    cols).

    `share` is the open fraction of the frame of each pixel, of the same shape or without the batch.
    Measurements are weighted by their precision. Saturated measurements have weight 0; a saturated
    pixel gets at least the light that saturates it."""
    opened = share.clamp(min=1e-6)
    alone = frame / opened
    refuse_not_finite(frame, "frame")
    saturated = frame >= 1
    noise = READ_VARIANCE + SHOT_VARIANCE * frame.clamp(min=0)
    precision = torch.where(saturated | (share <= 0), torch.zeros_like(frame), share**2 / noise)
    guess = averaged(alone.unsqueeze(1), precision.unsqueeze(1)).squeeze(1)
    return torch.where(saturated, torch.maximum(guess, alone), guess)


def clip_guess(volume: Tensor, *opened: Tensor) -> Tensor:
    """Estimate the light of a clip slot by slot from S^T E, `volume` (batch, N, rows, cols) of
    `lifted`. `opened` (N, rows, cols) are the shutters of each bucket. A measurement is weighted by
    the inverse of the number of slots in which the pixel's bucket was open."""
    refuse_not_finite(volume, "volume")
    weight = torch.stack([shutter / shutter.sum(dim=0).clamp(min=1) for shutter in opened]).sum(
        dim=0
    )
    return averaged(volume, weight.unsqueeze(0).expand_as(volume))


def refuse_not_finite(values: Tensor, name: str) -> None:
    """Raise ValueError for values that are not finite, which averages would spread."""
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

    `weights` has the same shape. Autocast is switched off, so that the inputs' precision is kept.
    """
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
    """A self-adjoint convolution, faster than torch's gradient of single-channel convolutions."""

    @staticmethod
    def forward(_ctx: Any, x: Tensor) -> Tensor:
        """Return x convolved with a 3 x 3 tent that weights the pixel itself by `_OWN`."""
        kernel = torch.tensor([[0.25, 0.5, 0.25], [0.5, _OWN, 0.5], [0.25, 0.5, 0.25]])
        channels = x.shape[1]
        stacked = kernel.to(x).expand(channels, 1, 3, 3)
        return functional.conv2d(x, stacked, padding=1, groups=channels)

    @staticmethod
    def backward(_ctx: Any, grad: Tensor) -> Tensor:
        """Return the gradient: the filter is its own adjoint."""
        return _tent(grad)


def _tent(x: Tensor) -> Tensor:
    """Sum over 3 x 3 pixels with weights 1, 1/2, 1/4; the pixel itself counts `_OWN` times."""
    sums: Tensor = _Tent.apply(x)  # type: ignore[no-untyped-call]
    return sums
