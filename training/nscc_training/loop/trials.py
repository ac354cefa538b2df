"""Gradients of codes by trials: the change of the loss when pixels open at other times.

A gradient through the capture shows the effect of a little more light on a measurement. It does not
show that a saturated pixel carries no more information, nor what information its neighbours then
lack. A trial does. Every pixel of a patch moves its code by independent normal noise, in both
directions, with everything else equal. It is credited with the difference of the losses around it.
This is the gradient of the loss smoothed by that noise (Nesterov and Spokoiny, Foundations of
Computational Mathematics 2017), with one trial per pixel and step.

The decoder learns from the first side, so that it also decodes the codes that are tried. Regular
patterns then appear worse than they are; to reduce this, only a share of the pixels moves in a
step. The encoder chooses what moves, and how far (`nscc_training.encoders.trial`)."""

from __future__ import annotations

import torch
from torch import Tensor
from torch.nn import functional

from nscc_training.data import Batch
from nscc_training.draws import generator_of
from nscc_training.encoders import CodeTrial, Encoder
from nscc_training.loop.setup import TrainingSetup
from nscc_training.loop.steps import changes_of, compared, decoded, window
from nscc_training.sensor_model import laid


def trial_of(
    encoder: Encoder, rows: int, cols: int, seed: tuple[int, ...], place: tuple[int, ...]
) -> CodeTrial:
    """Return a trial for patches of rows x cols; `place` seeds the random part of free codes."""

    def over(tile: Tensor) -> Tensor:
        return laid(window(tile, rows, cols, place), rows, cols)

    return encoder.trial(over, generator_of(next(encoder.parameters()).device, *seed))


def pull(
    setup: TrainingSetup, batch: Batch, trial: CodeTrial, prediction: Tensor, noise: torch.Generator
) -> Tensor:
    """Return a scalar 0 whose gradient with respect to the codes is the gradient of the loss.

    `prediction` is the decoder's output for the first side of the trial. `noise` must be a
    generator in the state that it had before that prediction."""
    with torch.no_grad():
        other_prediction = decoded(setup, batch.light, trial.shutters[1], setup.model, noise)
    sides = [prediction.detach().requires_grad_(), other_prediction.requires_grad_()]
    losses = torch.stack([setup.loss(*compared(estimate, batch)) for estimate in sides])
    # The difference of the losses, distributed over pixels by the trapezoidal rule
    # between both sides; exact for squared errors.
    gradient, other_gradient = torch.autograd.grad(losses.sum(), sides)
    with torch.no_grad():
        gain = (gradient + other_gradient) / 2 * (sides[0] - sides[1])
        gain = gain.sum(dim=tuple(range(gain.ndim - 2)))
        side = 2 * trial.reach + 1
        around = side**2 * functional.avg_pool2d(gain[None], side, 1, trial.reach)
        if weight := setup.settings.shutter.words_weight:
            # Words are credited to the pixel itself.
            first, second = map(changes_of, trial.shutters)
            around += weight * (first - second) / first.numel()
        slope = trial.moved * around / (2 * trial.spread**2 * trial.share)
    pulled = (trial.fields * slope).sum()
    return pulled - pulled.detach()
