"""Decision diagrams: numbers and bits that depend on the answers of comparisons.

A diagram is the index of a node. A leaf is an exact fraction; bits are 0 and 1. An inner node
branches on one answer. Variables have a fixed order, and equal diagrams share one node: two values
are equal for all answers if and only if their indices are equal."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

Number = Fraction
_LEAF = -1
MOST_NODES = 2_000_000
"""Most nodes of all diagrams of a program; beyond this number the proof is given up."""


class TooLarge(Exception):
    """Raised if the diagrams of a program need more than MOST_NODES nodes; `name` is the image,
    plane or state that was replayed last."""

    name = ""


class Diagrams:
    """All diagrams of one proof; `zero` and `one` are leaves."""

    def __init__(self) -> None:
        self._nodes: list[tuple[int, int, int]] = []
        self._values: dict[int, Fraction] = {}
        self._number: dict[object, int] = {}
        self._known: dict[tuple[str, int, int], int] = {}
        self._multiples: dict[tuple[int, int], dict[int, int]] = {}
        self._inverses: dict[int, int] = {}
        self._support: dict[int, frozenset[int]] = {}
        self._order: list[tuple[int, int, int]] = []
        self.zero, self.one = self.leaf(Fraction(0)), self.leaf(Fraction(1))

    def leaf(self, value: Fraction) -> int:
        """Return the diagram of a constant number."""
        key = value.as_integer_ratio()  # hashing a Fraction is slow
        number = self._number.get(key)
        if number is None:
            number = self._add(key, (_LEAF, 0, 0))
            self._values[number] = value
        return number

    def new_variable(self, at: tuple[int, int]) -> int:
        """Return a bit for a new answer, asked at the place `at` (column, row) of the array.

        Answers of nearby places are close in the order of variables, so that planes computed from
        neighbours' bits have small diagrams."""
        x, y = at
        self._order.append((y, x, len(self._order)))
        return self._node(len(self._order) - 1, self.zero, self.one)

    def value(self, node: int) -> Fraction | None:
        """Return the number of a leaf; None for a node that depends on answers."""
        return self._values.get(node)

    def first_value(self, node: int) -> Fraction:
        """Return a nonzero number among a diagram's leaves, the same for equal diagrams; 0 for the
        zero diagram."""
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
        """Return the variables that a diagram depends on."""
        variables = self._support.get(node)
        if variables is None:
            variable, low, high = self._nodes[node]
            variables = frozenset()
            if variable != _LEAF:
                variables = self.support(low) | self.support(high) | {variable}
            self._support[node] = variables
        return variables

    def add(self, a: int, b: int) -> int:
        """Return the sum of two numbers."""
        if a == self.zero:
            return b
        if b == self.zero:
            return a
        return self._apply("+", min(a, b), max(a, b), lambda x, y: x + y)

    def times(self, a: int, b: int) -> int:
        """Return the product of two numbers; for bits this is `and`."""
        if self.zero in (a, b):
            return self.zero
        if a == self.one:
            return b
        if b == self.one:
            return a
        return self._apply("*", min(a, b), max(a, b), lambda x, y: x * y)

    def either(self, a: int, b: int) -> int:
        """Return `or` of two bits."""
        return self.inverse(self.times(self.inverse(a), self.inverse(b)))

    def differs(self, a: int, b: int) -> int:
        """Return `xor` of two bits."""
        return self._apply("^", min(a, b), max(a, b), lambda x, y: Fraction(x != y))

    def inverse(self, bit: int) -> int:
        """Return `not` of a bit."""
        inverse = self._inverses.get(bit)
        if inverse is None:
            inverse = self._inverses[bit] = self.add(self.one, self.scaled(Fraction(-1), bit))
        return inverse

    def scaled(self, factor: Fraction, node: int) -> int:
        """Return a number times a fraction."""
        known = self.multiples(factor)
        product = known.get(node)
        if product is None:
            product = known[node] = self.times(self.leaf(factor), node)
        return product

    def multiples(self, factor: Fraction) -> dict[int, int]:
        """Return the products with a fraction computed so far, by node."""
        return self._multiples.setdefault(factor.as_integer_ratio(), {})

    def chosen(self, bit: int, then: int, otherwise: int) -> int:
        """Return `then` where the bit is 1 and `otherwise` where it is 0."""
        return self.add(self.times(bit, then), self.times(self.inverse(bit), otherwise))

    def _apply(
        self, name: str, a: int, b: int, op: Callable[[Fraction, Fraction], Fraction]
    ) -> int:
        key = (name, a, b)
        result = self._known.get(key)
        if result is None:
            (va, la, ha), (vb, lb, hb) = self._nodes[a], self._nodes[b]
            if va == vb == _LEAF:
                result = self.leaf(op(self._values[a], self._values[b]))
            else:
                tested = (v for v in (va, vb) if v != _LEAF)
                top = min(tested, key=self._order.__getitem__)
                lows = la if va == top else a, lb if vb == top else b
                highs = ha if va == top else a, hb if vb == top else b
                low = self._apply(name, *lows, op)
                result = self._node(top, low, self._apply(name, *highs, op))
            self._known[key] = result
        return result

    def _node(self, variable: int, low: int, high: int) -> int:
        if low == high:
            return low
        key = (variable, low, high)
        number = self._number.get(key)
        return self._add(key, key) if number is None else number

    def _add(self, key: object, node: tuple[int, int, int]) -> int:
        if len(self._nodes) >= MOST_NODES:
            raise TooLarge
        self._nodes.append(node)
        self._number[key] = len(self._nodes) - 1
        return len(self._nodes) - 1
