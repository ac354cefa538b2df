"""Gradients of codes by trial: what becomes of the loss if pixels open a little longer or shorter.

A gradient through the capture knows what a little more light does to a measurement, but not that a
pixel which saturates has nothing more to say, nor what its neighbours then miss. A trial does:
every pixel of a patch moves its edges by normal noise of its own, once to one side and once to the
other, everything else being equal, and is credited with the difference of the losses around it.
This is the gradient of the loss smoothed by that noise (Nesterov and Spokoiny, Foundations of
Computational Mathematics 2017), with as many trials a step as there are pixels. The decoder learns
from the first side, so that it knows codes like those that are tried.
"""

from __future__ import annotations

from dataclasses import dataclass

import torch
from torch import Tensor
from torch.nn import functional

from nscc_training.data import Batch
from nscc_training.encoders.bumps import Bump
from nscc_training.loop.setup import Parts
from nscc_training.loop.steps import compared, decoded, generator_of, window
from nscc_training.sensor_model import laid

_REACH = 2
"""How far, in pixels, a trial is credited with losses."""


@dataclass(frozen=True, eq=False)
class Trial:
    """Codes moved to either side: `fields` (fields, rows, cols) of the patch, with their gradient,
    how far they were `moved`, and the `spread` of that; `shutters` (N, rows, cols) of both sides.
    """

    fields: Tensor
    moved: Tensor
    spread: Tensor
    shutters: tuple[Tensor, Tensor]


def trial_of(
    encoder: Bump, rows: int, cols: int, seed: tuple[int, ...], place: tuple[int, ...]
) -> Trial:
    """A trial for patches of that size; `place` is what `window` draws a part of free codes by."""
    fields = laid(window(encoder.fields(None), rows, cols, place), rows, cols)
    with torch.no_grad():
        spread = encoder.tried(fields)
        drawn = torch.randn(fields.shape, generator=generator_of(*seed), dtype=fields.dtype)
        moved = spread * drawn.to(fields.device)
        first, second = (
            encoder.opened_by(encoder.within(fields + sign * moved)) for sign in (1, -1)
        )
    return Trial(fields, moved, spread, (first, second))


def pull(
    parts: Parts, batch: Batch, trial: Trial, prediction: Tensor, noise: torch.Generator
) -> Tensor:
    """A scalar 0 whose gradient is that of the loss in the codes.

    `prediction` is the decoder's of the trial's first side; `noise` is drawn from as for it.
    """
    with torch.no_grad():
        other = decoded(parts, batch.light, trial.shutters[1], parts.model, noise)
    sides = [prediction.detach().requires_grad_(), other.requires_grad_()]
    losses = torch.stack([parts.loss(*compared(made, batch)) for made in sides])
    # What a loss gains at a pixel, also where it is no sum over pixels: by the trapezoidal rule
    # between both sides, exact for squared errors.
    one, two = torch.autograd.grad(losses.sum(), sides)
    with torch.no_grad():
        gain = (one + two) / 2 * (sides[0] - sides[1])
        gain = gain.sum(dim=tuple(range(gain.ndim - 2)))
        side = 2 * _REACH + 1
        around = side**2 * functional.avg_pool2d(gain[None], side, 1, _REACH)
        slope = trial.moved * around / (2 * trial.spread**2)
    pulled = (trial.fields * slope).sum()
    return pulled - pulled.detach()
