"""What training minimises. Truth and prediction are light relative to the data range (1)."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import torch
from torch import Tensor

from nscc_training.curves import log_curve, mu_law, pu21, srgb

Loss = Callable[[Tensor, Tensor], Tensor]
"""(prediction, truth) of one shape to a scalar."""

LOG_FLOOR = 1e-3
"""The log loss counts relative errors above this part of the data range."""
LEAST_ERROR = 1e-7
"""Squared errors less than that, 70 dB, count as that."""
NITS = 1000.0
"""The luminance in cd/m2 that PU21 takes the data range for, as protocol hdr-v1 does."""


def l1(prediction: Tensor, truth: Tensor) -> Tensor:
    """Mean absolute error of linear light, as in the paper. Bright pixels rule it."""
    return (prediction - truth).abs().mean()


def psnr(prediction: Tensor, truth: Tensor) -> Tensor:
    """Minus a tenth of the PSNR in dB: every exposure counts by its own errors, as in evaluations,
    where squared errors are ruled by the worst. Patches of one exposure ([data] together) belong
    into a batch: their errors are taken together."""
    return torch.log10((prediction - truth).square().mean() + LEAST_ERROR)


def pu21_loss(prediction: Tensor, truth: Tensor) -> Tensor:
    """Mean absolute error in PU21 units over those of the data range, `NITS` cd/m2."""
    most = pu21(torch.tensor(NITS, dtype=torch.float64)).item()
    return l1(pu21(prediction * NITS), pu21(truth * NITS)) / most


def after(curve: Callable[[Tensor], Tensor], loss: Loss) -> Loss:
    """The loss of both after a curve; that of one truth in a row is computed once."""
    known: list[Tensor] = []

    def both(prediction: Tensor, truth: Tensor) -> Tensor:
        if truth.requires_grad:
            return loss(curve(prediction), curve(truth))
        if not known or known[0] is not truth:
            known[:] = truth, curve(truth)
        return loss(curve(prediction), known[1])

    return both


LOSSES: dict[str, Loss] = {
    "l1": l1,
    "display": after(srgb, l1),  # the encoding in which clips are scored
    "log": after(partial(log_curve, floor=LOG_FLOOR), l1),
    "mu-law": after(mu_law, l1),
    "pu21": pu21_loss,
    "psnr": psnr,
    "psnr-mu": after(mu_law, psnr),
    "psnr-display": after(srgb, psnr),
}
"""The losses by the names that configurations use."""
