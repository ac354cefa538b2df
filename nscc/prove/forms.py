"""Values of pixels as exact linear forms in the exposures, on a small array of pixels.

A form maps unknowns to factors, which may depend on answers of comparisons (`Diagrams`). Unknowns
are the exposures of pixels, steps of IN, light outside the array, and the content of registers that
were never written. A step of IN that is added only where a bit is 1 is a separate unknown for each
bit: a count of many bits is then a linear form, without a large diagram. An answer is the sign of a
form: forms that differ by a factor have the same answer."""

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
COUNTED = "IN where"
"""Kind of unknowns for a step of IN where a bit is 1, else 0; the bit is their first number."""
BEYOND = "beyond the array"
"""Kind of unknowns for light or a bus outside the array."""


@dataclass
class Forms:
    """The forms of one proof, on an array of `rows` x `cols` pixels."""

    rows: int
    cols: int
    diagrams: Diagrams = field(default_factory=Diagrams)
    _answers: dict[tuple[tuple[Unknown, int], ...], int] = field(default_factory=dict)
    _beyond: set[int] = field(default_factory=set)
    _fresh: int = 0
    _kept: dict[tuple[str, int, int], int] = field(default_factory=dict)

    def places(self) -> list[tuple[int, int]]:
        """Return all pixels (x, y), row by row."""
        return [(x, y) for y in range(self.rows) for x in range(self.cols)]

    def inside(self, x: int, y: int) -> bool:
        return 0 <= x < self.cols and 0 <= y < self.rows

    def exposure(self, bucket: str, x: int, y: int) -> Form:
        return {(bucket, x, y): self.diagrams.one}

    def beyond(self) -> Form:
        """Return a new unknown value outside the array."""
        self._fresh += 1
        return {(BEYOND, self._fresh, 0): self.diagrams.one}

    def kept_bit(self, state: str, at: tuple[int, int]) -> int:
        """Return the unknown bit of a state at the start of the frame."""
        key = (state, *at)
        if key not in self._kept:
            self._kept[key] = self.diagrams.new_variable(at)
        return self._kept[key]

    def counted(self, bit: int, steps: Fraction) -> Form:
        """Return `steps` of IN where a bit is 1, else 0. A bit and its inverse share an unknown."""
        diagrams = self.diagrams
        if bit == diagrams.zero:
            return {}
        if bit == diagrams.one:
            return {IN: diagrams.leaf(steps)}
        inverse = diagrams.inverse(bit)
        if inverse < bit:
            return {IN: diagrams.leaf(steps), (COUNTED, inverse, 0): diagrams.leaf(-steps)}
        return {(COUNTED, bit, 0): diagrams.leaf(steps)}

    def sum(self, *terms: tuple[Fraction, Form]) -> Form:
        """Return the sum of factors times forms."""
        diagrams, zero = self.diagrams, self.diagrams.zero
        total: dict[Unknown, int] = {}
        for factor, form in terms:
            known = diagrams.multiples(factor)
            for unknown, number in form.items():
                scaled = known.get(number)
                if scaled is None:
                    scaled = diagrams.scaled(factor, number)
                before = total.get(unknown, zero)
                total[unknown] = scaled if before == zero else diagrams.add(before, scaled)
        return {unknown: number for unknown, number in total.items() if number != zero}

    def chosen(self, bit: int, then: Form, otherwise: Form) -> Form:
        """Return `then` where the bit is 1 and `otherwise` where it is 0."""
        diagrams = self.diagrams
        if bit == diagrams.one:
            return then
        if bit == diagrams.zero or then == otherwise:
            return otherwise
        steps = self._steps_between(then, otherwise)
        if steps is not None:
            unit_factor = Fraction(1)
            return self.sum((unit_factor, otherwise), (unit_factor, self.counted(bit, steps)))
        zero = diagrams.zero
        numbers = {
            unknown: diagrams.chosen(bit, then.get(unknown, zero), otherwise.get(unknown, zero))
            for unknown in then.keys() | otherwise.keys()
        }
        return {unknown: number for unknown, number in numbers.items() if number != zero}

    def _steps_between(self, first: Form, second: Form) -> Fraction | None:
        """Return the difference in steps of IN; None if the forms differ in other unknowns."""
        if {**first, IN: 0} != {**second, IN: 0}:
            return None
        zero = self.diagrams.zero
        steps = [self.diagrams.value(form.get(IN, zero)) for form in (first, second)]
        return None if steps[0] is None or steps[1] is None else steps[0] - steps[1]

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

    def depends_beyond(self, value: Form | int) -> bool:
        """Return whether a form, or a bit, depends on light outside the array."""
        if isinstance(value, int):
            return bool(self._beyond and self.diagrams.support(value) & self._beyond)
        return any(
            unknown[0] == BEYOND
            or self.depends_beyond(number)
            or (unknown[0] == COUNTED and self.depends_beyond(unknown[1]))
            for unknown, number in value.items()
        )
