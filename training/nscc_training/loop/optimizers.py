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
    """`torch.optim.Muon` for convolution weights (out, ...), viewed as matrices."""

    def __init__(self, weights: Iterable[Tensor], lr: float) -> None:
        """Begin; each weight is updated as a matrix with a row for each output."""
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
    """Return values in the shape of a weight as a matrix with a row for each output, columns in the
    order of the weight's memory: 3D networks have channels last."""
    order = sorted(range(weight.ndim), key=weight.stride, reverse=True)
    return values.permute(order).reshape(len(weight), -1)


def optimizers_of(setup: TrainingSetup) -> list[torch.optim.Optimizer]:
    """Return the optimizers of a run: of the decoder, and of the codes if they learn.

    The key `base` of a parameter group is its initial rate. Codes that do not learn lose their
    gradient."""
    settings = setup.settings
    decoder = dict(setup.decoder.named_parameters())
    kernels = [name for name, weight in decoder.items() if weight.ndim >= 4]
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
