"""Values of pixels as exact linear forms in the exposures, on a small array of pixels.

A form maps unknowns to factors, which may depend on answers of comparisons (`Diagrams`). Unknowns
are the exposures of pixels, steps of IN, light outside the array, and the content of registers that
were never written. An answer is the sign of a form: forms that differ by a factor have the same
answer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from nscc.prove.diagrams import Diagrams

Unknown = tuple[str, int, int]
"""A bucket and its pixel, or another kind of unknown with numbers that distinguish it."""
Form = Mapping[Unknown, int]
"""The diagram of each unknown's factor; factors that are 0 are left out."""

IN: Unknown = ("IN", 0, 0)
BEYOND = "beyond the array"
"""The kind of unknowns for light or a bus outside the array."""


@dataclass
class Forms:
    """The forms of one proof, on an array of `rows` x `cols` pixels."""

    rows: int
    cols: int
    diagrams: Diagrams = field(default_factory=Diagrams)
    _answers: dict[tuple[tuple[Unknown, int], ...], int] = field(default_factory=dict)
    _beyond: set[int] = field(default_factory=set)
    _fresh: int = 0

    def places(self) -> list[tuple[int, int]]:
        """Return all pixels (x, y), row by row."""
        return [(x, y) for y in range(self.rows) for x in range(self.cols)]

    def inside(self, x: int, y: int) -> bool:
        """Return whether a place is on the array."""
        return 0 <= x < self.cols and 0 <= y < self.rows

    def exposure(self, bucket: str, x: int, y: int) -> Form:
        """Return the form of a pixel's exposure."""
        return {(bucket, x, y): self.diagrams.one}

    def beyond(self) -> Form:
        """Return a new unknown value outside the array."""
        self._fresh += 1
        return {(BEYOND, self._fresh, 0): self.diagrams.one}

    def sum(self, *terms: tuple[Fraction, Form]) -> Form:
        """Return the sum of factors times forms."""
        diagrams = self.diagrams
        total: dict[Unknown, int] = {}
        for factor, form in terms:
            for unknown, number in form.items():
                scaled = number if factor == 1 else diagrams.scaled(factor, number)
                total[unknown] = diagrams.add(total.get(unknown, diagrams.zero), scaled)
        return {unknown: number for unknown, number in total.items() if number != diagrams.zero}

    def chosen(self, bit: int, then: Form, otherwise: Form) -> Form:
        """Return `then` where the bit is 1 and `otherwise` where it is 0."""
        diagrams = self.diagrams
        if bit == diagrams.one:
            return then
        if bit == diagrams.zero or then == otherwise:
            return otherwise
        zero = diagrams.zero
        numbers = {
            unknown: diagrams.chosen(bit, then.get(unknown, zero), otherwise.get(unknown, zero))
            for unknown in then.keys() | otherwise.keys()
        }
        return {unknown: number for unknown, number in numbers.items() if number != zero}

    def positive(self, form: Form, at: tuple[int, int]) -> int:
        """Return the bit that tells whether a form of the pixel `at` is above 0.

        Either a form or its negative counts as positive, because comparators do not detect equal
        charges."""
        diagrams = self.diagrams
        unknowns = sorted(form)
        if all(unknown == IN for unknown in unknowns):
            steps = diagrams.value(form[IN]) if form else Fraction(0)
            if steps is not None:
                return diagrams.one if steps > 0 else diagrams.zero
        first = diagrams.first_value(form[unknowns[0]])
        scale = 1 / first
        key = tuple((u, diagrams.scaled(scale, form[u])) for u in unknowns)
        answer = self._answers.get(key)
        if answer is None:
            answer = diagrams.new_variable(at)
            self._answers[key] = answer
            if self.depends_beyond(form):
                self._beyond |= diagrams.support(answer)
        return answer if first > 0 else diagrams.inverse(answer)

    def unknown_bit(self, at: tuple[int, int]) -> int:
        """Return a bit of a pixel that was never written."""
        return self.diagrams.new_variable(at)

    def depends_beyond(self, value: Form | int) -> bool:
        """Return whether a form, or a bit, depends on light outside the array."""
        if isinstance(value, int):
            return bool(self._beyond and self.diagrams.support(value) & self._beyond)
        return any(
            unknown[0] == BEYOND or self.depends_beyond(number) for unknown, number in value.items()
        )
