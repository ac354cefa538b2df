"""What training minimises. Truth and prediction are light relative to the data range (1)."""

from __future__ import annotations

from collections.abc import Callable

import torch
from torch import Tensor

from nscc_training.curves import MU, log_curve, mu_law, pu21, srgb

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


def display(prediction: Tensor, truth: Tensor) -> Tensor:
    """Mean absolute error in display encoding (sRGB), in which clips are scored."""
    return l1(srgb(prediction), srgb(truth))


def log(prediction: Tensor, truth: Tensor) -> Tensor:
    """Mean absolute error of log(1 + light / LOG_FLOOR)."""
    return l1(log_curve(prediction, LOG_FLOOR), log_curve(truth, LOG_FLOOR))


def mu(prediction: Tensor, truth: Tensor) -> Tensor:
    """Mean absolute error after mu-law with mu = 5000."""
    return l1(mu_law(prediction, MU), mu_law(truth, MU))


def psnr(prediction: Tensor, truth: Tensor) -> Tensor:
    """Minus a tenth of the PSNR in dB: every exposure counts by its own errors, as in evaluations,
    where squared errors are ruled by the worst. Patches of one exposure ([data] together) belong
    into a batch: their errors are taken together."""
    return torch.log10((prediction - truth).square().mean() + LEAST_ERROR)


def psnr_mu(prediction: Tensor, truth: Tensor) -> Tensor:
    """The same after mu-law."""
    return psnr(mu_law(prediction, MU), mu_law(truth, MU))


def psnr_display(prediction: Tensor, truth: Tensor) -> Tensor:
    """The same in display encoding."""
    return psnr(srgb(prediction), srgb(truth))


def pu21_loss(prediction: Tensor, truth: Tensor) -> Tensor:
    """Mean absolute error in PU21 units over those of the data range, `NITS` cd/m2."""
    most = pu21(torch.tensor(NITS, dtype=torch.float64)).item()
    return l1(pu21(prediction * NITS), pu21(truth * NITS)) / most


LOSSES: dict[str, Loss] = {
    "l1": l1, "display": display, "log": log, "mu-law": mu, "pu21": pu21_loss, "psnr": psnr,
    "psnr-mu": psnr_mu, "psnr-display": psnr_display,
}  # fmt: skip
"""The losses by the names that configurations use."""
