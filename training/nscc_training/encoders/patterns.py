"""Class e (free bits) and the codebook: learned shapes, and a choice of shape per pixel."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional

from nscc.arrays import Bools, Ints
from nscc_training.code_choices import bits_of, opened_by_bits
from nscc_training.encoders.base import (
    Codes,
    CodeTrial,
    Encoder,
    Over,
    Ranges,
    ShutterSpec,
    decided,
)
from nscc_training.gradients import replaced, signed

MOST_BITS = 62
"""Most slots of class e, whose code is one int64; longer bit fields need several numbers."""
_LEAST_TRIED = 0.25
"""Minimum standard deviation of trials; with less, undecided digits never change."""


class _Digits(Encoder):
    """Encoders whose codes consist of binary digits: 1 if the parameter (a logit) is above 0.
    Parameters lie in -1..1."""

    jitter_unit = 0.1
    """A fifth of the distance to the other digit: a start keeps its digits."""
    reach = 1
    """With N digits tried per pixel, a larger radius only adds the effects of other trials (no
    benefit was measured for clips of 16 slots)."""

    def digits(self, logits: Tensor, generator: torch.Generator | None, soft: bool) -> Tensor:
        """Return the digit 0 or 1 of every logit, in its shape; if `soft`, a sigmoid of the width
        `temperature`.

        A generator adds noise of the standard deviation `noise`; None adds none. Gradients pass in
        both cases."""
        noisy = self.noisy(logits, generator)
        return torch.sigmoid(noisy / self.temperature) if soft else signed(noisy)

    def trial_spread(self, logits: Tensor) -> Tensor:
        """Return the standard deviation of trials around logits, of the same shape: the noise of
        training, at least `_LEAST_TRIED`."""
        return torch.full_like(logits, max(self.noise, _LEAST_TRIED))

    def set_digits(self, logits: Tensor, digits: Bools) -> None:
        """Set logits in place to 0.5 for a true digit, and to -0.5 for a false one: half of their
        range."""
        with torch.no_grad():
            logits.copy_(torch.where(torch.as_tensor(digits), 0.5, -0.5))


class Bits(_Digits):
    """Class e: N independent bits for every pixel of the tile, 1 for an open slot. Each has a
    learned score, whose sign is the bit."""

    def __init__(self, spec: ShutterSpec, relaxation: str = "straight-through") -> None:
        """Begin with all slots of all pixels open (a logit of 0.5). Raise ValueError for more than
        `MOST_BITS` slots."""
        super().__init__(spec, relaxation)
        if spec.slots > MOST_BITS:
            raise ValueError(
                f"class e has at most {MOST_BITS} slots, the bits of one number, not {spec.slots}; "
                "a codebook has shutters of any length"
            )
        self.logits = nn.Parameter(torch.full((spec.slots, *spec.tile), 0.5))

    def shutters(self, generator: torch.Generator | None, soft: bool) -> Tensor:
        """Return the shutters (N, rows, cols) of the present logits: exactly 0 and 1, or if `soft`,
        sigmoids of the width `temperature`. A generator adds noise to the logits; None adds none.
        """
        return self.digits(self.logits, generator, soft)

    def trial(self, over: Over, generator: torch.Generator) -> CodeTrial:
        """Return shutters for two versions of the bits, decided by the same random numbers, added
        and subtracted.

        `over` repeats the logits over the pixels of a patch, each of which is decided on its own.
        The numbers are drawn from `generator`."""
        fields = over(self.logits)
        with torch.no_grad():
            spread = self.trial_spread(fields)
            first, second, moved = decided(fields, spread, generator, self.tried_share)
        sides = (first.float(), second.float())
        return CodeTrial(fields, moved, spread, sides)

    def ranges(self) -> Ranges:
        """Return the logits with the range that training keeps them in."""
        return [(self.logits, (-1.0, 1.0))]

    def codes(self) -> Codes:
        """Return the open slots of each pixel as one integer, int64 (rows, cols): bit n is slot n.
        Raise ValueError if a parameter is not finite."""
        self.check_finite()
        return {"bits": bits_of((self.logits.detach() > 0).cpu().numpy())}

    def load_codes(self, codes: Mapping[str, Ints]) -> None:
        """Set the bits of each pixel from one integer of `bits` (rows, cols), bit n for slot n.
        Raise ValueError if `bits` is missing, of another shape or out of range."""
        self.checked(codes, {"bits": (0, (1 << self.spec.slots) - 1)})
        self.set_digits(self.logits, opened_by_bits(codes["bits"], self.spec.slots))

    def start_random(self, generator: np.random.Generator) -> None:
        """Draw every bit."""
        self.set_digits(self.logits, generator.random(self.logits.shape) < 0.5)

    def start_uniform(self) -> None:
        """Open all slots of all pixels."""
        self.set_digits(self.logits, np.array(True))

    def start_quad(self) -> None:
        """Open each of the pixels of a 2 x 2 square in another quarter of the frame."""
        self.set_digits(self.logits, quarters(self.spec.slots)[:, self.quad_ranks()])


class Codebook(_Digits):
    """A codebook: K shutters of N bits, called shapes, and a choice of shape for every pixel of the
    tile.

    The choice is the largest of K scores of the pixel. With as many shapes as pixels, the codebook
    is as free as class e, with any N."""

    def __init__(self, spec: ShutterSpec, relaxation: str = "straight-through") -> None:
        """Begin with open shutters in all rows, and use the rows in turn. Raise ValueError if
        `spec` has no number of rows."""
        super().__init__(spec, relaxation)
        if spec.rows is None or spec.rows < 1:
            raise ValueError(f"a codebook of {spec.rows} rows")
        self.rows = spec.rows
        self.shapes = nn.Parameter(torch.full((spec.rows, spec.slots), 0.5))
        self.choice = nn.Parameter(torch.zeros((*spec.tile, spec.rows)))
        self.choose(self.spread())

    def shutters(self, generator: torch.Generator | None, soft: bool) -> Tensor:
        """Return the shutters (N, rows, cols) of the shapes that the pixels choose.

        If `soft`, they are means of shapes weighted by the scores, and values between 0 and 1.
        Otherwise they are exactly 0 and 1. A generator adds noise to the digits; None adds none."""
        digits = self.digits(self.shapes, generator, soft)
        return torch.einsum("rck,kn->nrc", self.chosen(generator, soft), digits)

    def chosen(self, generator: torch.Generator | None, soft: bool) -> Tensor:
        """Return the weights (rows, cols, K) of the shapes at each pixel: one-hot, or if `soft`,
        the softmax of the scores.

        With the relaxation `gumbel` and a generator, soft weights are a random choice: the softmax
        of scores with Gumbel noise. None draws nothing. One-hot weights pass the gradient of the
        softmax."""
        scores: Tensor = self.choice
        if soft and self.relaxation == "gumbel" and generator is not None:
            drawn = torch.empty(scores.shape, device=generator.device)
            # The negative logarithm of an exponential number is a Gumbel number.
            scores = scores - torch.log(drawn.exponential_(generator=generator)).to(scores)
        likely = functional.softmax(scores / self.temperature, dim=-1)
        if soft:
            return likely
        hard = functional.one_hot(self.choice.argmax(dim=-1), self.rows).to(likely.dtype)
        return replaced(likely, hard)

    def trial(self, over: Over, generator: torch.Generator) -> CodeTrial:
        """Return shutters for two versions of the codes: pixels decide anew about each digit of
        their shape, and between it and a random other shape.

        `over` repeats the scores over the pixels of a patch, each of which decides on its own. The
        last of the fields is the difference of the scores of both shapes, so that its gradient
        decides between them."""
        scores = over(self.choice.movedim(-1, 0))
        with torch.no_grad():
            current = scores.argmax(dim=0, keepdim=True)
            steps = torch.randint(
                1, max(2, self.rows), current.shape, generator=generator, device=generator.device
            )
            alternative = (current + steps.to(current.device)) % self.rows
        fields = torch.cat(
            [
                self.shown(self.shapes, current),
                scores.gather(0, current) - scores.gather(0, alternative),
            ]
        )
        with torch.no_grad():
            spread = self.trial_spread(fields)
            # two scores differ by the noise of both
            spread[-1] *= math.sqrt(2)
            *sides, moved = decided(fields, spread, generator, self.tried_share)
            alternative_digits = self.shown(self.shapes, alternative) > 0
            first, second = (
                torch.where(side[-1:], side[:-1], alternative_digits).float() for side in sides
            )
        return CodeTrial(fields, moved, spread, (first, second))

    def shown(self, shapes: Tensor, choice: Tensor) -> Tensor:
        """Return the shutters (N, rows, cols): for each pixel the row of `shapes` (K, N) that
        `choice` (1, rows, cols) names. The gradient of `shapes` passes."""
        # as a product, whose gradient is added up in the same order every time
        weights = functional.one_hot(choice[0], self.rows).to(shapes.dtype)
        return torch.einsum("rck,kn->nrc", weights, shapes)

    def ranges(self) -> Ranges:
        """Return the shapes with the range that training keeps them in. The scores of choices have
        no limits."""
        return [(self.shapes, (-1.0, 1.0))]

    def unused_share(self) -> float:
        """Return the fraction of shapes, 0 to below 1, that no pixel chooses."""
        return 1 - len(torch.unique(self.choice.argmax(dim=-1))) / self.rows

    def codes(self) -> Codes:
        """Return the row of each pixel, `id`, int64 (rows, cols), and the digits 0 and 1 of the
        rows, `book`, int64 (K, N). Raise ValueError if a parameter is not finite."""
        self.check_finite()
        codes = {"id": self.choice.argmax(dim=-1), "book": self.shapes > 0}
        return {name: values.to("cpu", torch.int64).numpy() for name, values in codes.items()}

    def load_codes(self, codes: Mapping[str, Ints]) -> None:
        """Set the row of each pixel from `id` (rows, cols), and the digits of the shapes if `book`
        (K, N) is given.

        Without a book, the shapes stay. Raise ValueError for rows or digits that do not exist, and
        other shapes of arrays."""
        self.checked(codes, {"id": (0, self.rows - 1)})
        book = codes.get("book")
        if book is not None:
            if book.shape != (self.rows, self.spec.slots) or not np.isin(book, (0, 1)).all():
                raise ValueError(
                    f"'book' must be an array {(self.rows, self.spec.slots)} of 0 and 1"
                )
            self.set_digits(self.shapes, book == 1)
        self.choose(codes["id"])

    def start_random(self, generator: np.random.Generator) -> None:
        """Draw all digits of all shapes, and use the shapes in turn."""
        self.set_digits(self.shapes, generator.random(self.shapes.shape) < 0.5)
        self.choose(self.spread())

    def start_uniform(self) -> None:
        """Begin with all slots open in every row of the codebook. The pixels choose the rows in
        turn."""
        self.set_digits(self.shapes, np.array(True))
        self.choose(self.spread())

    def start_quad(self) -> None:
        """Begin with shutters that are open in one quarter of the frame each, repeated over the
        rows of the codebook. The pixels of each 2 x 2 square choose the four quarters."""
        self.set_digits(self.shapes, quarters(self.spec.slots)[:, np.arange(self.rows) % 4].T)
        rank = self.quad_ranks()
        # Each square takes the next group of four rows; an incomplete last group is replaced by the
        # first.
        again = self.spread() // 4 * 4 + rank
        self.choose(np.where(again < self.rows, again, rank % self.rows))

    def spread(self) -> Ints:
        """Return a shape index for each pixel, int64 (rows, cols), using all shapes in turn, row by
        row."""
        return np.arange(self.spec.places, dtype=np.int64).reshape(self.spec.tile) % self.rows

    def choose(self, rows: Ints) -> None:
        """Set the scores so that each pixel chooses the shape whose index is in `rows` (rows,
        cols), by a margin of 1 that training can overcome."""
        with torch.no_grad():
            chosen = functional.one_hot(torch.as_tensor(rows), self.rows)
            self.choice.copy_(chosen.to(self.choice.dtype))


def quarters(slots: int) -> Bools:
    """Return four shutters (slots, 4), each open in one quarter of the frame in turn, and for at
    least one slot; in frames of fewer than four slots some are equal."""
    n = np.arange(slots)[:, None]
    first = np.minimum(np.arange(4) * slots // 4, slots - 1)
    last = np.maximum((np.arange(4) + 1) * slots // 4, first + 1)
    return np.asarray((first <= n) & (n < last), np.bool_)
