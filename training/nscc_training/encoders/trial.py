"""Trials: codes moved to either side by antithetic draws.

The gradient of a parameter is the difference of the losses of both sides times `moved / (2
spread^2)`: the gradient of the loss smoothed by normal noise of that spread. Where only a sign
matters, as for a digit, `moved` is the mean of all draws that give the same decision (Dong, Mnih
and Tucker, NeurIPS 2020, do so for logistic noise): the same gradient with less variance.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import torch
from torch import Tensor

from nscc_training.draws import normal, uniform

Over = Callable[[Tensor], Tensor]
"""Maps values of a tile, (any, rows, cols), to the pixels of a patch."""


@dataclass(frozen=True, eq=False)
class CodeTrial:
    """Codes moved to either side.

    `fields` (fields, rows, cols) of the patch, with their gradient; `moved`, their displacement,
    and `spread`, its standard deviation; `shutters` (N, rows, cols) of both sides. A field is
    credited with the losses within `reach` pixels. Only a random `share` of the pixels is moved.
    """

    fields: Tensor
    moved: Tensor
    spread: Tensor
    shutters: tuple[Tensor, Tensor]
    reach: int
    share: float


def drawn(fields: Tensor, generator: torch.Generator, share: float) -> Tensor:
    """Return standard normal numbers for a `share` of the pixels, 0 for the rest."""
    numbers = normal(fields, generator)
    if share < 1:
        numbers *= uniform(fields, generator, fields.shape[-2:]) < share
    return numbers


def decided(
    margins: Tensor, spread: Tensor, generator: torch.Generator, share: float
) -> tuple[Tensor, Tensor, Tensor]:
    """Return decisions for margins above 0, tried by a share of pixels with noise of a spread.
    Returns the decisions of both sides, and the displacement of the first side averaged over all
    draws with that decision: 0 where both sides decide alike."""
    noise = spread * drawn(margins, generator, share)
    first, second = margins + noise > 0, margins - noise > 0
    beyond = margins.abs() / spread
    # the mean of a standard normal number above `beyond`
    mean = math.sqrt(2 / math.pi) / torch.special.erfcx(beyond / math.sqrt(2))
    return first, second, spread * mean * (first.to(mean.dtype) - second.to(mean.dtype))
