"""Decision diagrams: numbers and bits that depend on the answers of comparisons; and values of
pixels as exact linear forms in the exposures, on a small array of pixels.

A diagram is the index of a node. A leaf is an exact fraction; bits are 0 and 1. An inner node
branches on one answer. Variables have a fixed order, and equal diagrams share one node: two values
are equal for all answers if and only if their indices are equal.

A form maps unknowns to factors, which may depend on answers of comparisons (`Diagrams`). Unknowns
are the exposures of pixels, steps of IN, light outside the array, and the content of registers that
were never written. A step of IN that is added only where a bit is 1 is a separate unknown for each
bit: a count of many bits is then a linear form, without a large diagram. An answer is the sign of a
form: forms that differ by a factor have the same answer."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Set
from dataclasses import dataclass, field
from fractions import Fraction
from operator import add, mul

Number = Fraction
_LEAF = -1
_OF_LEAVES: dict[str, Callable[[Fraction, Fraction], Fraction]] = {"+": add, "*": mul}
MOST_NODES = 2_000_000
"""Most nodes of all diagrams of a program; beyond this number the proof is given up."""


class TooLarge(Exception):
    """Raised if the diagrams of a program need more than MOST_NODES nodes; `name` is the image,
    plane or state that was replayed last."""

    name = ""


class AlwaysEqual(Exception):
    """Raised if an image, plane or state compares two values that are equal in every pixel; the
    argument is its name."""


class Diagrams:
    """The decision diagrams of one proof: numbers and bits that depend on the answers of
    comparisons.

    A diagram is the index of a node; equal diagrams have the same index. `zero` and `one` are the
    diagrams of these constants."""

    def __init__(self) -> None:
        """Begin with the leaves 0 and 1, which are the nodes of a decision diagram 0 and 1."""
        self._nodes: list[tuple[int, int, int]] = []
        self._values: dict[int, Fraction] = {}
        self._number: dict[object, int] = {}
        self._known: dict[tuple[str, int, int], int] = {}
        self._multiples: dict[tuple[int, int], dict[int, int]] = {}
        self._support: dict[int, frozenset[int]] = {}
        self._order: list[tuple[int, int, int]] = []
        # `_apply` relies on zero and one being the nodes 0 and 1.
        self.zero, self.one = self.leaf(Fraction(0)), self.leaf(Fraction(1))

    def leaf(self, value: Fraction) -> int:
        """Return the diagram of the constant `value`; equal numbers give the same diagram. Raises
        TooLarge if it would be a node too many, as all methods that make nodes do."""
        key = value.as_integer_ratio()  # hashing a Fraction is slow
        number = self._number.get(key)
        if number is None:
            number = self._add(key, (_LEAF, 0, 0))
            self._values[number] = value
        return number

    def new_variable(self, at: tuple[int, int]) -> int:
        """Return the diagram of a new answer, a bit that is unknown; `at` (column, row) is the
        pixel that asks.

        Answers of nearby pixels are close in the order of variables (by row, column, then age), so
        that planes computed from neighbours' bits have small diagrams."""
        x, y = at
        self._order.append((y, x, len(self._order)))
        return self._node(len(self._order) - 1, self.zero, self.one)

    def value(self, node: int) -> Fraction | None:
        """Return the number of a constant diagram; None for one that depends on answers."""
        return self._values.get(node)

    def first_value(self, node: int) -> Fraction:
        """Return the first number other than 0 among a diagram's leaves, those where answers are 0
        first; 0 for the zero diagram.

        Equal diagrams give the same number, which `Forms.positive` uses to scale forms."""
        stack = [node]
        visited = set()
        while stack:
            node = stack.pop()
            if node in visited:
                continue
            visited.add(node)
            variable, low, high = self._nodes[node]
            if variable != _LEAF:
                stack += (high, low)
            elif self._values[node]:
                return self._values[node]
        return Fraction(0)

    def support(self, node: int) -> frozenset[int]:
        """Return the numbers of the variables (answers of comparisons) on which a diagram depends;
        empty for a constant."""
        variables = self._support.get(node)
        if variables is None:
            variable, low, high = self._nodes[node]
            variables = frozenset()
            if variable != _LEAF:
                variables = self.support(low) | self.support(high) | {variable}
            self._support[node] = variables
        return variables

    def add(self, a: int, b: int) -> int:
        """Return the diagram of the sum of two numbers, given as diagrams."""
        return self._apply("+", a, b)

    def times(self, a: int, b: int) -> int:
        """Return the diagram of the product of two numbers, given as diagrams; for bits this is
        `and`."""
        return self._apply("*", a, b)

    def either(self, a: int, b: int) -> int:
        """Return the diagram of `or` of two bits, given as diagrams."""
        return self._apply("|", a, b)

    def differs(self, a: int, b: int) -> int:
        """Return the diagram of `xor` of two bits, given as diagrams."""
        return self._apply("^", a, b)

    def inverse(self, bit: int) -> int:
        """Return the diagram of `not` of a bit, given as a diagram."""
        return self._apply("^", bit, self.one)

    def scaled(self, factor: Fraction, node: int) -> int:
        """Return the diagram of `factor` times the number whose diagram is `node`."""
        known = self.multiples(factor)
        product = known.get(node)
        if product is None:
            product = known[node] = self.times(self.leaf(factor), node)
        return product

    def multiples(self, factor: Fraction) -> dict[int, int]:
        """Return the known products with the fraction `factor`, by node: the key is the diagram of
        a number, the value that of its product. Callers may add to the mapping, which is kept."""
        return self._multiples.setdefault(factor.as_integer_ratio(), {})

    def chosen(self, bit: int, then: int, otherwise: int) -> int:
        """Return the diagram of the number `then` where the bit is 1 and of `otherwise` where it is
        0; all three are diagrams."""
        return self.add(self.times(bit, then), self.times(self.inverse(bit), otherwise))

    def _apply(self, name: str, a: int, b: int) -> int:
        """Return the diagram of a + b, a * b, a | b or a ^ b; `name` is the operator. Results are
        cached.

        Both diagrams are followed from the top; at each node, the variable that is first in the
        order is decided. `a` and `b` may be exchanged, because all four operations are commutative.
        """
        if a > b:
            a, b = b, a
        if a == self.zero:
            return self.zero if name == "*" else b
        if a == self.one and name in "*|":
            return b if name == "*" else a
        if a == b and name in "|^":
            return a if name == "|" else self.zero
        key = (name, a, b)
        result = self._known.get(key)
        if result is None:
            (va, la, ha), (vb, lb, hb) = self._nodes[a], self._nodes[b]
            if va == vb == _LEAF:
                result = self.leaf(_OF_LEAVES[name](self._values[a], self._values[b]))
            else:
                order = self._order
                a_first = vb == _LEAF or (va != _LEAF and order[va] <= order[vb])
                top = va if a_first else vb
                low = self._apply(name, la if va == top else a, lb if vb == top else b)
                high = self._apply(name, ha if va == top else a, hb if vb == top else b)
                result = self._node(top, low, high)
            self._known[key] = result
        return result

    def _node(self, variable: int, low: int, high: int) -> int:
        """Return the node of a decision diagram that branches to `low` where the variable number
        `variable` is 0 and to `high` where it is 1.

        Equal branches need no node, and an existing node with the same branches is used again.
        Raises TooLarge beyond `MOST_NODES`."""
        if low == high:
            return low
        key = (variable, low, high)
        number = self._number.get(key)
        return self._add(key, key) if number is None else number

    def _add(self, key: object, node: tuple[int, int, int]) -> int:
        """Append a node (variable, low, high) of a decision diagram, which can be found by `key`,
        and return its number. The caller ensures that the key is new.

        Raises TooLarge if there are `MOST_NODES` nodes already."""
        if len(self._nodes) >= MOST_NODES:
            raise TooLarge
        self._nodes.append(node)
        self._number[key] = len(self._nodes) - 1
        return len(self._nodes) - 1


Unknown = tuple[str, int, int]
"""A bucket and its pixel, or another kind of unknown with numbers that distinguish it."""
Form = Mapping[Unknown, int]
"""The diagram of each unknown's factor; factors that are 0 are left out."""

IN: Unknown = ("IN", 0, 0)


def in_at(param: str) -> Unknown:
    """Return the unknown that stands for IN (the level sent to all pixels) at the level of the
    parameter `param`."""
    return (f"IN at {param}", 0, 0)


COUNTED = "IN where"
"""Kind of unknowns for a step of IN where a bit is 1, else 0; the bit is their first number."""
BEYOND = "beyond the array"
"""Kind of unknowns for light or a bus outside the array."""


@dataclass
class Forms:
    """The values of pixels in one proof, on an array of `rows` x `cols` pixels.

    A form is an exact weighted sum of unknowns, such as exposures: {unknown: diagram of its
    factor}. The empty form is 0. A pixel is (x, y): column and row."""

    rows: int
    cols: int
    diagrams: Diagrams = field(default_factory=Diagrams)
    _answers: dict[tuple[tuple[Unknown, int], ...], int] = field(default_factory=dict)
    _beyond: set[int] = field(default_factory=set)
    _fresh: int = 0
    _kept: dict[tuple[str, int, int], int] = field(default_factory=dict)
    _propagated: dict[tuple[int, int, tuple[int, int]], int] = field(default_factory=dict)

    def pixels(self) -> list[tuple[int, int]]:
        """Return the positions (x, y) of all pixels, row by row."""
        return [(x, y) for y in range(self.rows) for x in range(self.cols)]

    def inside(self, x: int, y: int) -> bool:
        """Return whether a pixel is in the array."""
        return 0 <= x < self.cols and 0 <= y < self.rows

    def exposure(self, bucket: str, x: int, y: int) -> Form:
        """Return the exposure of a bucket at a pixel as a weighted sum: one unknown with the factor
        1."""
        return {(bucket, x, y): self.diagrams.one}

    def beyond(self) -> Form:
        """Return a new unknown for a value outside the array, different from all others."""
        self._fresh += 1
        return {(BEYOND, self._fresh, 0): self.diagrams.one}

    def kept_bit(self, state: str, at: tuple[int, int]) -> int:
        """Return the bit of a state at the pixel `at` (x, y) before the frame.

        It is an unknown: a variable that is the same at every call."""
        key = (state, *at)
        if key not in self._kept:
            self._kept[key] = self.diagrams.new_variable(at)
        return self._kept[key]

    def propagated(self, bit: int, mask: int, at: tuple[int, int]) -> int:
        """Return the bit at the pixel `at` (x, y) after a propagation of `bit` under `mask`,
        diagrams of that pixel, as an unknown.

        The same bits and masks in all pixels give the same result. As the proof compares all
        pixels, a bit and a mask that are equal in one pixel may share the unknown there."""
        key = (bit, mask, at)
        if key not in self._propagated:
            answer = self._propagated[key] = self.diagrams.new_variable(at)
            if self.depends_beyond(bit) or self.depends_beyond(mask):
                self._beyond |= self.diagrams.support(answer)
        return self._propagated[key]

    def counted(self, bit: int, steps: Fraction) -> Form:
        """Return the form (weighted sum) of a value that is `steps` of IN where `bit` is 1, else 0.

        `bit` is a decision diagram (`Diagrams`). IN is the value that all pixels receive. A step of
        IN times the bit is an unknown of the form. A bit and its inverse share this unknown. The
        form is empty for the constant 0."""
        diagrams = self.diagrams
        if bit == diagrams.zero:
            return {}
        if bit == diagrams.one:
            return {IN: diagrams.leaf(steps)}
        inverse = diagrams.inverse(bit)
        if inverse < bit:
            # A bit is 1 minus its inverse, so of the two only the lower node becomes an unknown.
            return {IN: diagrams.leaf(steps), (COUNTED, inverse, 0): diagrams.leaf(-steps)}
        return {(COUNTED, bit, 0): diagrams.leaf(steps)}

    def sum(self, *terms: tuple[Fraction, Form]) -> Form:
        """Return the sum of `terms`, each a (factor, form), as a form; unknowns whose factors
        cancel are left out. The forms do not change; without terms the sum is empty, which is 0."""
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
        """Return the form `then` where the bit, given as a diagram, is 1 and `otherwise` where it
        is 0.

        If they differ by a number of steps of IN (the level sent to all pixels), the result
        contains one unknown for the bit (`counted`). Otherwise the factors of all unknowns branch
        on the bit."""
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
        """Return the number of steps of IN (the level sent to all pixels) in `first` minus that in
        `second`; None if they differ in anything else, or in a number of steps that depends on
        answers."""
        if {**first, IN: 0} != {**second, IN: 0}:
            return None
        zero = self.diagrams.zero
        steps = [self.diagrams.value(form.get(IN, zero)) for form in (first, second)]
        return None if steps[0] is None or steps[1] is None else steps[0] - steps[1]

    def positive(self, form: Form, at: tuple[int, int]) -> int:
        """Return the bit that tells whether a weighted sum of the pixel `at` (x, y) is above 0.

        Sums that differ by a positive factor give the same bit, and by a negative factor its
        inverse: comparators do not detect equal charges. The sign of 0 is unknown. Only a constant
        number of steps of IN (the level sent to all pixels) is decided here; other bits are new
        variables."""
        diagrams = self.diagrams
        unknowns = sorted(form)
        if unknowns == [IN] and (steps := diagrams.value(form[IN])) is not None:
            return diagrams.one if steps > 0 else diagrams.zero
        first = diagrams.first_value(form[unknowns[0]]) if form else Fraction(1)
        # Divided by it, forms that differ by a factor are equal.
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
        """Return whether a form, or a bit (an int), depends on light outside the array, directly or
        through a comparison."""
        if not isinstance(value, int) and any(kind == BEYOND for kind, *_ in value):
            return True
        return bool(self._beyond) and self._depends_on(value, self._beyond)

    def compares_equal(self, value: Form | int) -> bool:
        """Return whether a form, or a bit (an int), depends on the sign of 0: on comparing equal
        values, which no real comparator decides."""
        sign_of_0 = self._answers.get(())
        return sign_of_0 is not None and self._depends_on(value, self.diagrams.support(sign_of_0))

    def _depends_on(self, value: Form | int, variables: Set[int]) -> bool:
        """Return whether a form, or a bit (an int), depends on one of these variables, given by
        number. The bits that a form counts as unknowns are looked into."""
        bits = [value] if isinstance(value, int) else list(value.values())
        if not isinstance(value, int):
            bits += [bit for kind, bit, _ in value if kind == COUNTED]
        return any(self.diagrams.support(bit) & variables for bit in bits)
