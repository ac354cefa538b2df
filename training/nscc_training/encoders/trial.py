"""Trials: codes moved to either side of what they are, by draws that mirror each other.

What a trial says of a code's parameters is the difference of the losses of both sides, times
`moved / (2 spread^2)`: the gradient of the loss that normal noise of that spread smooths. Where
only a sign decides, as for a digit, `moved` is the mean of all draws that decide alike (Dong, Mnih
and Tucker, NeurIPS 2020, do so for logistic noise): the same gradient from less scattered numbers.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import torch
from torch import Tensor

from nscc_training.draws import normal, uniform

Over = Callable[[Tensor], Tensor]
"""Takes anything of a tile, (any, rows, cols), to the pixels of a patch."""


@dataclass(frozen=True, eq=False)
class CodeTrial:
    """Codes moved to either side: `fields` (fields, rows, cols) of the patch, with their gradient,
    how far they were `moved`, and the `spread` of that; `shutters` (N, rows, cols) of both sides.
    A field is credited with the losses of its pixel and of those up to `reach` pixels away. Only
    a random `share` of the pixels is moved.
    """

    fields: Tensor
    moved: Tensor
    spread: Tensor
    shutters: tuple[Tensor, Tensor]
    reach: int
    share: float


def drawn(fields: Tensor, generator: torch.Generator, share: float) -> Tensor:
    """Standard normal numbers for a `share` of the pixels, 0 for the others."""
    numbers = normal(fields, generator)
    if share < 1:
        numbers *= uniform(fields, generator, fields.shape[-2:]) < share
    return numbers


def decided(
    margins: Tensor, spread: Tensor, generator: torch.Generator, share: float
) -> tuple[Tensor, Tensor, Tensor]:
    """Decisions for what has a margin above 0, tried by a share of pixels with noise of a spread.

    Returns both sides' decisions and how far, in the mean of draws that decide so, the first side
    was moved: not at all where both decide alike.
    """
    noise = spread * drawn(margins, generator, share)
    first, second = margins + noise > 0, margins - noise > 0
    beyond = margins.abs() / spread
    # the mean of a standard normal number that is larger than `beyond`
    mean = math.sqrt(2 / math.pi) / torch.special.erfcx(beyond / math.sqrt(2))
    return first, second, spread * mean * (first.to(mean.dtype) - second.to(mean.dtype))
