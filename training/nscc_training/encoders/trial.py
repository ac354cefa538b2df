"""Gradients of discrete codes by antithetic trials: losses of codes moved in both directions.

The gradient of a parameter is the loss difference of both sides times `moved / (2 spread^2)`. This
is the gradient of the loss smoothed by normal noise with the standard deviation `spread`. If only a
sign matters, as for a digit, `moved` is the mean over all draws with the same decision, which has
less variance (Dong, Mnih and Tucker, NeurIPS 2020, for logistic noise)."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import torch
from torch import Tensor

from nscc_training.draws import normal, uniform

Over = Callable[[Tensor], Tensor]
"""A function that repeats the values of a tile, (any, rows, cols), over the pixels of a patch."""


@dataclass(frozen=True, eq=False)
class CodeTrial:
    """Codes moved in both directions.

    `fields` (fields, rows, cols) of the patch have gradients; `moved` is their displacement,
    `spread` its standard deviation. `shutters` are the shutters (N, rows, cols) of both sides. A
    field is credited with the losses within `reach` pixels. Only a random fraction `share` of the
    pixels moves."""

    fields: Tensor
    moved: Tensor
    spread: Tensor
    shutters: tuple[Tensor, Tensor]
    reach: int
    share: float


def drawn(fields: Tensor, generator: torch.Generator, share: float) -> Tensor:
    """Return standard normal numbers for a random `share` of the pixels, and 0 for the others."""
    numbers = normal(fields, generator)
    if share < 1:
        numbers *= uniform(fields, generator, fields.shape[-2:]) < share
    return numbers


def decided(
    margins: Tensor, spread: Tensor, generator: torch.Generator, share: float
) -> tuple[Tensor, Tensor, Tensor]:
    """Decide whether noisy margins are above 0, on both sides of an antithetic draw.

    Only a `share` of the pixels gets noise, with the standard deviation `spread`. Returns both
    decisions and the displacement of the first side, averaged over all draws with this decision; it
    is 0 if both sides decide alike."""
    noise = spread * drawn(margins, generator, share)
    first, second = margins + noise > 0, margins - noise > 0
    beyond = margins.abs() / spread
    # the mean of a standard normal number above `beyond`
    mean = math.sqrt(2 / math.pi) / torch.special.erfcx(beyond / math.sqrt(2))
    return first, second, spread * mean * (first.to(mean.dtype) - second.to(mean.dtype))
