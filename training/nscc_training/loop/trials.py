"""Gradients of codes by trial: what becomes of the loss if pixels open otherwise.

A gradient through the capture knows what a little more light does to a measurement, but not that a
pixel which saturates has nothing more to say, nor what its neighbours then miss. A trial does:
every pixel of a patch moves its code by normal noise of its own, once to one side and once to the
other, everything else being equal, and is credited with the difference of the losses around it.
This is the gradient of the loss smoothed by that noise (Nesterov and Spokoiny, Foundations of
Computational Mathematics 2017), with as many trials a step as there are pixels. The decoder learns
from the first side, so that it knows codes like those that are tried. That makes regular patterns
worth less than they are: where it matters, only a share of the pixels moves in a step. What moves,
and how far, is the encoder's to say (`nscc_training.encoders.trial`).
"""

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
    """A trial for patches of that size; `place` is what `window` draws a part of free codes by."""

    def over(tile: Tensor) -> Tensor:
        return laid(window(tile, rows, cols, place), rows, cols)

    return encoder.trial(over, generator_of(next(encoder.parameters()).device, *seed))


def pull(
    setup: TrainingSetup, batch: Batch, trial: CodeTrial, prediction: Tensor, noise: torch.Generator
) -> Tensor:
    """A scalar 0 whose gradient is that of the loss in the codes.

    `prediction` is the decoder's of the trial's first side; `noise` is drawn from as for it.
    """
    with torch.no_grad():
        other_prediction = decoded(setup, batch.light, trial.shutters[1], setup.model, noise)
    sides = [prediction.detach().requires_grad_(), other_prediction.requires_grad_()]
    losses = torch.stack([setup.loss(*compared(estimate, batch)) for estimate in sides])
    # What a loss gains at a pixel, also where it is no sum over pixels: by the trapezoidal rule
    # between both sides, exact for squared errors.
    gradient, other_gradient = torch.autograd.grad(losses.sum(), sides)
    with torch.no_grad():
        gain = (gradient + other_gradient) / 2 * (sides[0] - sides[1])
        gain = gain.sum(dim=tuple(range(gain.ndim - 2)))
        side = 2 * trial.reach + 1
        around = side**2 * functional.avg_pool2d(gain[None], side, 1, trial.reach)
        if weight := setup.settings.shutter.words_weight:
            # A pixel's words are its own.
            first, second = map(changes_of, trial.shutters)
            around += weight * (first - second) / first.numel()
        slope = trial.moved * around / (2 * trial.spread**2 * trial.share)
    pulled = (trial.fields * slope).sum()
    return pulled - pulled.detach()
