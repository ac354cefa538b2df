"""Steps for the weights of convolutions: two to three times as far as Adam's from as many clips."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import torch
from torch import Tensor, nn

_MOMENTUM = 0.95
_TURNS = 5
"""Iterations after which all singular values are between about 0.7 and 1.2."""
_TERMS = (3.4445, -4.7750, 2.0315)
_RMS = 0.8
"""Of the steps at rate 1: with it, the rate of Adam for the other weights serves for all."""


class Muon(torch.optim.Optimizer):
    """Momentum whose steps are made orthogonal (K. Jordan and others 2024, with the scale of Liu
    and others, arXiv 2502.16982): every direction of a weight (out, ...) is led equally far."""

    def __init__(self, weights: Iterable[Tensor], lr: float = 1e-3) -> None:
        super().__init__(weights, {"lr": lr})

    @torch.no_grad()
    def step(self, closure: Any = None) -> None:  # type: ignore[override]
        """One step along the gradients there are; `closure` is not used."""
        for group in self.param_groups:
            for weight in group["params"]:
                state = self.state[weight]
                mean = state.setdefault("mean", torch.zeros_like(weight))
                mean.lerp_(weight.grad, 1 - _MOMENTUM)
                ahead = weight.grad.lerp(mean, _MOMENTUM).flatten(1)
                scale = _RMS * max(ahead.shape) ** 0.5
                weight.add_(orthogonal(ahead).view_as(weight), alpha=-group["lr"] * scale)


def orthogonal(matrix: Tensor) -> Tensor:
    """Nearly the orthogonal matrix (rows, cols) nearest to one: its singular values become about
    1, by a polynomial of fifth order applied again and again (Newton-Schulz)."""
    first, second, third = _TERMS
    wide = matrix.shape[0] <= matrix.shape[1]
    found = matrix if wide else matrix.mT
    found = found / (found.norm() + 1e-12)
    for _ in range(_TURNS):
        square = found @ found.mT
        found = first * found + (second * square + third * square @ square) @ found
    made: Tensor = found if wide else found.mT
    return made


def optimizers(network: nn.Module) -> list[torch.optim.Optimizer]:
    """Muon for the convolutions within a network, Adam for its first and last and for biases."""
    inner: list[Tensor] = []
    others: list[Tensor] = []
    for name, weight in network.named_parameters():
        is_inner = weight.ndim == 4 and not name.startswith(("first.", "last."))
        (inner if is_inner else others).append(weight)
    return [Muon(inner), torch.optim.Adam(others)]
