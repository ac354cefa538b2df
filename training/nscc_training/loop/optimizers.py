"""The optimizers of a run: Adam, or Muon for the inner convolutions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import torch
from torch import Tensor

from nscc_training.loop.setup import TrainingSetup

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
