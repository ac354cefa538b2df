"""Losses of training; truth and prediction are light relative to the data range."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import torch
from torch import Tensor
from torch.nn import functional

from nscc_training.curves import log_curve, mu_law, pu21, srgb
from nscc_training.protocols import CLASS

Loss = Callable[[Tensor, Tensor], Tensor]
"""A function of prediction and truth, of the same shape, that returns a scalar."""

LOG_FLOOR = 1e-3
"""Fraction of the data range above which the log loss measures relative errors."""
LEAST_ERROR = 1e-7
"""Lower limit of mean squared errors: 70 dB."""
NITS = 1000.0
"""Luminance in cd/m2 of the data range for PU21, as in protocol hdr-v1."""


def l1(prediction: Tensor, truth: Tensor) -> Tensor:
    """Return the mean absolute error of linear light over all values, a scalar; bright pixels
    dominate it."""
    return (prediction - truth).abs().mean()


def psnr(prediction: Tensor, truth: Tensor) -> Tensor:
    """Return minus a tenth of the PSNR in dB: log10 of the mean squared error of linear light.

    The error is raised by `LEAST_ERROR`, so that equal arrays give -7 and finite gradients. Errors
    are averaged over the batch, so patches of one exposure ([data] together) belong in one batch.
    """
    return torch.log10((prediction - truth).square().mean() + LEAST_ERROR)


def pu21_loss(prediction: Tensor, truth: Tensor) -> Tensor:
    """Return the mean absolute error in PU21 units, a perceptually uniform scale, relative to the
    value of `NITS` cd/m2. Light of 1 has that luminance; brighter light is compared on the curve's
    straight continuation."""
    most = pu21(torch.tensor(NITS, dtype=torch.float64)).item()
    return l1(pu21(prediction * NITS), pu21(truth * NITS)) / most


def after(curve: Callable[[Tensor], Tensor], loss: Loss) -> Loss:
    """Return a loss that maps prediction and truth by `curve` before it compares them."""
    return lambda prediction, truth: loss(curve(prediction), curve(truth))


LOSSES: dict[str, Loss] = {
    "l1": l1,
    "display": after(srgb, l1),  # the encoding in which clips are scored
    "log": after(partial(log_curve, floor=LOG_FLOOR), l1),
    "mu-law": after(mu_law, l1),
    "pu21": pu21_loss,
    "psnr": psnr,
    "psnr-mu": after(mu_law, psnr),
    "psnr-display": after(srgb, psnr),
    CLASS: functional.cross_entropy,  # of logarithms of likelihoods (batch, classes)
}
"""The losses by the names that configurations use."""
