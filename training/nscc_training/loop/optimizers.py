"""Optimizers of a training run, and their rates and other settings by step."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterable
from typing import Any

import torch
from torch import Tensor
from torch.optim import Optimizer

from nscc_training.loop.setup import TrainingSetup
from nscc_training.settings import RunSettings

_MUON_RATE = 4.0
"""Factor on Adam's rate; steps then have 0.8 of that rate as root mean square."""


class Muon(torch.optim.Muon):
    """The optimizer `torch.optim.Muon`, which needs matrices, for the weights of convolutions
    (outputs, ...)."""

    def __init__(self, weights: Iterable[Tensor], lr: float) -> None:
        """Prepare to update each of the `weights` as a matrix with a row for each output. `lr` is
        the learning rate.

        The matrices are views, so that updates change the weights in place."""
        self.weights = list(weights)
        self.matrices = [_in_rows(weight.detach(), weight) for weight in self.weights]
        super().__init__(self.matrices, lr, weight_decay=0.0, adjust_lr_fn="match_rms_adamw")

    @torch.no_grad()
    def step(self, closure: Any = None) -> None:  # type: ignore[override]
        """Take a step with the current gradients; `closure` is not used."""
        for weight, matrix in zip(self.weights, self.matrices, strict=True):
            matrix.grad = None if weight.grad is None else _in_rows(weight.grad, weight)
        super().step()  # type: ignore[no-untyped-call]


def _in_rows(values: Tensor, weight: Tensor) -> Tensor:
    """Return `values`, which have the shape of `weight`, as a matrix with a row for each output.

    Columns are in the order of the weight's memory, so that the matrix is a view: 3D networks have
    channels last."""
    order = sorted(range(weight.ndim), key=weight.stride, reverse=True)
    return values.permute(order).reshape(len(weight), -1)


def optimizers_of(setup: TrainingSetup) -> list[torch.optim.Optimizer]:
    """Return the optimizers of a run: Adam for the decoder and, if they learn, for the codes; with
    `muon`, also Muon for the inner convolutions of the decoder.

    The key `base` of a parameter group is its rate before the schedule. The rate of codes is
    relative to their range. If codes do not learn, their parameters no longer receive gradients."""
    settings = setup.settings
    decoder = dict(setup.decoder.named_parameters())
    kernels = [name for name, weight in decoder.items() if weight.ndim >= 4]
    # Muon suits weights between hidden channels; Adam keeps the first and the last convolution.
    inside = kernels[1:-1] if settings.train.optimizer == "muon" else []
    inner = [decoder[name] for name in inside]
    outer = [weight for name, weight in decoder.items() if name not in inside]
    groups = [(outer, settings.train.rate)]
    if settings.shutter.learn:
        spans = {id(p): high - low for p, (low, high) in setup.encoder.ranges()}
        for parameter in setup.encoder.parameters():
            span = spans.get(id(parameter), 1.0)
            groups.append(([parameter], settings.train.code_rate * span))
    else:
        setup.encoder.requires_grad_(False)
    adam_groups = [{"params": group, "base": rate, "lr": rate} for group, rate in groups if group]
    optimizers: list[torch.optim.Optimizer] = (
        [torch.optim.Adam(adam_groups, fused=True)] if adam_groups else []
    )
    if inner:
        rate = _MUON_RATE * settings.train.rate
        optimizers.append(Muon(inner, rate))
        optimizers[-1].param_groups[0]["base"] = rate
    return optimizers


_WARM_UP, _SHARE = 20, 50
"""Most steps in which the rates rise; they are at most one in `_SHARE` of a cycle's steps."""


def settling_step(settings: RunSettings) -> int:
    """Return the step from which the codes stay as they are and only the decoder learns; the number
    of steps if the run has no such phase."""
    # Rounded first: an error of floating point must not add a step.
    return math.ceil(round((1 - settings.settle_share) * settings.train.steps, 6))


def _starts(settings: RunSettings) -> int:
    """Return in how many cycles the codes learn: one, and one more for each restart. It is 1 if
    codes are not learned."""
    return 1 + settings.shutter.restarts if settings.shutter.learn else 1


def cycle_of(settings: RunSettings, step: int) -> tuple[int, int]:
    """Return the first step of the cycle that contains `step`, and the first step after that cycle.

    A cycle is the time between two restarts of the codes, or the time in which they are settled. A
    step beyond the last belongs to the last cycle."""
    settled, starts = settling_step(settings), _starts(settings)
    bounds = [settled * number // starts for number in range(starts + 1)]
    if settled < settings.train.steps:
        bounds.append(settings.train.steps)
    # Limited, so that steps before the first and beyond the last have a cycle, too.
    after = min(max(1, bisect_right(bounds, step)), len(bounds) - 1)
    return bounds[after - 1], bounds[after]


def codes_learn(settings: RunSettings, step: int) -> bool:
    """Return whether the codes change in this step (0 is the first); never if `settings` do not let
    them learn. They stay as they are in the fraction `warm_up` of a cycle after each start, so that
    the decoder adapts first, and from `settling_step` on."""
    first, last = cycle_of(settings, step)
    waiting = settings.shutter.warm_up * settings.train.steps / _starts(settings)
    learning = settings.shutter.learn and last <= settling_step(settings)
    return learning and first + waiting <= step < last


def anneal(setup: TrainingSetup, step: int) -> None:
    """Set temperature (softness of relaxed codes) and noise of the encoder of `setup` for a step.
    While the codes settle, both have their last values. Within a cycle, the temperature falls
    geometrically from its first to its last value, and the noise linearly to 0."""
    settings = setup.settings
    first, last = cycle_of(settings, step)
    settled = step >= settling_step(settings)
    progress_share = 1.0 if settled else (step - first) / max(1, last - first - 1)
    warm, cold = settings.shutter.temperature
    setup.encoder.temperature = warm * (cold / warm) ** progress_share
    setup.encoder.noise = settings.shutter.noise * (1 - progress_share)


def set_rates(optimizers: Iterable[Optimizer], settings: RunSettings, step: int) -> None:
    """Set the learning rates of the optimizers for a step, in place, from the rate `base` of each
    parameter group.

    They rise from 0 in the first steps of a cycle, at most `_WARM_UP`, and with the schedule
    `cosine` fall to 0 at its end. They rise because Adam's first steps have the size of the rate
    whatever the gradient: all weights of a wide network together would drive its output out of
    range."""
    first, last = cycle_of(settings, step)
    factor = min(1.0, (step - first + 1) / (1 + min(_WARM_UP, (last - first) // _SHARE)))
    if settings.train.schedule == "cosine":
        factor *= 0.5 * (1 + math.cos(math.pi * (step - first) / (last - first)))
    for optimizer in optimizers:
        for group in optimizer.param_groups:
            group["lr"] = group["base"] * factor
