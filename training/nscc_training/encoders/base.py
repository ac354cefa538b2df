"""The base class of encoders: a tile of codes, hard and soft shutters, starts and projections."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor, nn

from nscc.arrays import Ints
from nscc_training.code_choices import RELAXATIONS, SLOPED
from nscc_training.code_choices import ShutterSpec as ShutterSpec
from nscc_training.draws import normal, uniform

Ranges = list[tuple[Tensor, tuple[float, float]]]
"""Parameters with their lowest and highest legal value."""
Over = Callable[[Tensor], Tensor]
"""A function that repeats the values of a tile, (any, rows, cols), over the pixels of a patch."""


@dataclass(frozen=True, eq=False)
class CodeTrial:
    """Codes moved in both directions, whose losses give a gradient.

    The gradient of a parameter is the loss difference of both sides times `moved / (2 spread^2)`:
    the gradient of the loss smoothed by normal noise with the standard deviation `spread`. If only
    a sign matters, as for a digit, `moved` is the mean over all draws with the same decision, which
    has less variance (Dong, Mnih and Tucker, NeurIPS 2020, for logistic noise).

    `fields` (fields, rows, cols) of the patch have gradients; `moved` is their displacement,
    `spread` its standard deviation. `shutters` are the shutters (N, rows, cols) of both sides."""

    fields: Tensor
    moved: Tensor
    spread: Tensor
    shutters: tuple[Tensor, Tensor]


def drawn(fields: Tensor, generator: torch.Generator, share: float) -> Tensor:
    """Return standard normal numbers in the shape of `fields` (.., rows, cols), and 0 for all
    pixels but a random fraction `share`, the same pixels in all fields."""
    numbers = normal(fields, generator)
    if share < 1:
        numbers *= uniform(fields, generator, fields.shape[-2:]) < share
    return numbers


def decided(
    margins: Tensor, spread: Tensor, generator: torch.Generator, share: float
) -> tuple[Tensor, Tensor, Tensor]:
    """Decide whether noisy margins are above 0, on both sides of an antithetic draw: with the noise
    added, and with it subtracted.

    Only the fraction `share` of the pixels gets noise, of the standard deviation `spread`. Returns
    both decisions, and the displacement of the first side: the mean of the noise over all draws
    with this decision. It is 0 if both sides decide alike."""
    noise = spread * drawn(margins, generator, share)
    first, second = margins + noise > 0, margins - noise > 0
    beyond = margins.abs() / spread
    # the mean of a standard normal number above `beyond`
    mean = math.sqrt(2 / math.pi) / torch.special.erfcx(beyond / math.sqrt(2))
    return first, second, spread * mean * (first.to(mean.dtype) - second.to(mean.dtype))


Codes = dict[str, Ints]
"""Field values at every pixel of the tile, by field name, each (rows, cols). A codebook also has
its rows of N digits, `book`."""


class Encoder(nn.Module, ABC):
    """Learned shutters of one class on a tile.

    `jitter_unit` is the unit of random moves of the start, in the unit of the parameters.

    Calling an encoder returns the shutters for training, (N, rows, cols) of the tile: exactly 0
    and 1 with `straight-through`, values between them with a relaxation. `hard()` returns the
    shutters that are compiled. Call `project()` after every optimiser step: it clips parameters to
    their legal range.

    Parameters
    ----------
    spec : ShutterSpec
        Class, number of slots and tile.
    relaxation : str
        One of `nscc_training.code_choices.RELAXATIONS`.
    """

    jitter_unit = 0.0
    reach = 0
    """Radius in pixels within which losses are credited to a trial; 0 if the reconstruction of a
    pixel depends on that pixel alone."""

    def __init__(self, spec: ShutterSpec, relaxation: str = "straight-through") -> None:
        """Begin without parameters, which the classes of encoders add. Raise ValueError for an
        unknown relaxation."""
        super().__init__()
        if relaxation not in RELAXATIONS:
            raise ValueError(
                f"the relaxation {relaxation!r} is not one of {', '.join(RELAXATIONS)}"
            )
        self.spec = spec
        self.relaxation = relaxation
        self.temperature = 1.0
        self.noise = 0.0
        """Standard deviation of the noise on parameters while training, in their own unit."""
        self.tried_share = 1.0
        """The fraction of the pixels that a trial moves."""

    @abstractmethod
    def codes(self) -> Codes:
        """Return the legal codes of the current parameters, int64, by field."""

    def check_finite(self) -> None:
        """Raise ValueError if any parameter has a value that is not finite, with the name of the
        parameter and the number of such values."""
        for name, parameter in self.named_parameters():
            count = int((~torch.isfinite(parameter)).sum())
            if count:
                raise ValueError(
                    f"{count} of {parameter.numel()} values of the parameter `{name}` are not "
                    "finite, and stand for no code: lower the learning rate, or load other codes"
                )

    @abstractmethod
    def load_codes(self, codes: Mapping[str, Ints]) -> None:
        """Set the parameters to codes.

        Parameters
        ----------
        codes : mapping of str to array of int64
            Values (rows, cols) of each field on the tile.

        Raises
        ------
        ValueError
            For wrong names, shapes or values.
        """

    @abstractmethod
    def start_random(self, generator: np.random.Generator) -> None:
        """Set independent codes, uniform over the legal codes of the class.

        Parameters
        ----------
        generator : numpy.random.Generator
        """

    @abstractmethod
    def start_uniform(self) -> None:
        """Set the same shutter at all pixels."""

    @abstractmethod
    def start_quad(self) -> None:
        """Begin with four codes, one for each pixel of 2 x 2: for stills with exposure times in a
        geometric sequence, for clips open in consecutive intervals."""

    @abstractmethod
    def shutters(self, generator: torch.Generator | None, soft: bool) -> Tensor:
        """Return the shutters of the current parameters.

        Parameters
        ----------
        generator : torch.Generator or None
            Adds noise to the parameters.
        soft : bool
            Return the shutters for training instead of the hard ones.

        Returns
        -------
        Tensor
            (N, rows, cols), values 0..1.
        """

    @abstractmethod
    def trial(self, over: Over, generator: torch.Generator) -> CodeTrial:
        """Return shutters for codes moved in both directions, with independent random moves of
        every pixel.

        Parameters
        ----------
        over : Over
            Repeats values of the tile over the batch of the trial.
        generator : torch.Generator

        Returns
        -------
        CodeTrial
        """

    def forward(self, generator: torch.Generator | None = None) -> Tensor:
        """Return the shutters of a training step.

        Parameters
        ----------
        generator : torch.Generator, optional
            Adds noise to the parameters.

        Returns
        -------
        Tensor
            (N, rows, cols), values 0..1.
        """
        if self.relaxation not in SLOPED:
            return self.hard()
        return self.shutters(generator, soft=self.relaxation != "straight-through")

    def hard(self) -> Tensor:
        """Return the shutters of the current codes, without gradient or noise.

        Returns
        -------
        Tensor
            (N, rows, cols), exactly 0 and 1.
        """
        with torch.no_grad():
            return self.shutters(None, soft=False)

    @torch.no_grad()
    def project(self) -> None:
        """Clip the parameters to their legal range."""
        for parameter, (low, high) in self.ranges():
            parameter.clamp_(low, high)

    @torch.no_grad()
    def jitter(self, amount: float, generator: np.random.Generator) -> None:
        """Move all parameters by normal noise, whose standard deviation is `amount` units.

        Places with equal codes have equal gradients, so they would stay equal.

        Parameters
        ----------
        amount : float
            In units of `jitter_unit`.
        generator : numpy.random.Generator
        """
        for parameter, _ in self.ranges():
            moves = generator.normal(0.0, amount * self.jitter_unit, tuple(parameter.shape))
            parameter.add_(torch.as_tensor(moves).to(parameter))
        self.project()

    def ranges(self) -> Ranges:
        """Return the parameters with their legal ranges.

        Returns
        -------
        list of (Tensor, (float, float))
        """
        return []

    def dead_share(self) -> float:
        """Return the fraction of parameters whose gradient is exactly 0 after a backward pass.

        Such a code cannot learn from this batch: all its pixels are saturated, dark or unused.

        Returns
        -------
        float
            0..1; 1 if no gradient arrived, 0 for a class without parameters.
        """
        learned = list(self.parameters())
        dead = sum(p.numel() if p.grad is None else int((p.grad == 0).sum()) for p in learned)
        return dead / sum(p.numel() for p in learned) if learned else 0.0

    def noisy(self, parameter: Tensor, generator: torch.Generator | None) -> Tensor:
        """Add noise of the standard deviation `noise` to a parameter.

        Parameters
        ----------
        parameter : Tensor
        generator : torch.Generator or None
            No noise if None.

        Returns
        -------
        Tensor
        """
        if generator is None or self.noise == 0:
            return parameter
        return parameter + self.noise * normal(parameter, generator)

    def checked(
        self, codes: Mapping[str, Ints], limits: Mapping[str, tuple[int, int]]
    ) -> list[Tensor]:
        """Check codes and return them as tensors.

        Parameters
        ----------
        codes : mapping of str to array of int64
            Values (rows, cols) by field.
        limits : mapping of str to (int, int)
            Smallest and largest value by field.

        Returns
        -------
        list of Tensor
            Float64, in the order of `limits`.

        Raises
        ------
        ValueError
            For a missing field, another shape or values outside the limits. Other fields are
            ignored.
        """
        tensors = []
        for name, (low, high) in limits.items():
            values = codes.get(name)
            if values is None:
                raise ValueError(f"the field '{name}' is missing")
            if values.shape != self.spec.tile:
                raise ValueError(
                    f"'{name}' has the shape {values.shape}, but the tile is {self.spec.tile}"
                )
            if values.min() < low or values.max() > high:
                raise ValueError(f"'{name}' has values outside {low}..{high}")
            tensors.append(torch.tensor(values.astype(np.float64)))
        return tensors

    def quad_ranks(self) -> Ints:
        """Return the rank of every pixel in the 2 x 2 pattern.

        Returns
        -------
        array of int64
            0..3, (rows, cols), longest exposure first.
        """
        rows, cols = self.spec.tile
        y, x = np.mgrid[:rows, :cols]
        return np.asarray((y % 2) * 2 + x % 2, np.int64)
