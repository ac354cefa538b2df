"""States with a range of values beside images and planes, whose bits are kept planes."""

from __future__ import annotations

from math import prod
from typing import Any

import numpy as np

from nscc.arrays import Bools
from nscc.logic.cubes import Budget, cover
from nscc.program.evaluate import Value, outside_range, values_of
from nscc.program.expressions import FAILED, VARIABLE, Meaning, check, names_in
from nscc.program.host_values import HostValues
from nscc.program.picture_loops import LoopReader
from nscc.syntax import tree
from nscc.truth import packed_bits
from nscc.words.pictures import Bit, Condition, Constant, Joined, RangeState, Weights

_MOST_CASES = 1 << 14
"""Most combinations of values of states and of bits of planes in one expression."""
_STEPS = 10**7
"""Most steps of the searches for the conditions of one expression."""
_OF_PLACES = "compare the position in a plane of its own: `plane p = x > 3`"
_IN_A_PLANE = "compare the image in a plane of its own: `plane p = IMAGE > 6%`"


class RangeReader(LoopReader):
    """Converts expressions over states with a range of values to conditions over their bits.

    `ranges` are these states by name."""

    def __init__(self, host: HostValues, kernels: dict[str, Weights]) -> None:
        """Begin without states; `host` knows the parameters that the host sets, and `kernels` are
        the valid convolution kernels by name."""
        super().__init__(host, kernels)
        self.ranges: dict[str, RangeState] = {}

    def reads_range(self, expr: tree.Expr) -> bool:
        """Return whether an expression reads a state with a range."""
        return any(name.text in self.ranges for name in names_in(expr))

    def conditions(self, expr: tree.Expr, state: RangeState | None = None) -> list[Condition]:
        """Return the conditions of the bits of `state` if `expr` is its value, or the condition
        that `expr` is without a state; [] after reporting an error.

        `expr` reads names of states and planes. It is computed for all of their values."""
        of_places = dict.fromkeys(("x", "y", "rows", "cols"), Meaning("misplaced", note=_OF_PLACES))
        scope = {**self.constants, **of_places, **dict.fromkeys(self.failed, FAILED)}
        for name, kind in {"exposure": "image", **self.kinds}.items():
            is_image = Meaning("misplaced", note=_IN_A_PLANE)
            scope[name] = Meaning("variable", type="boolean") if kind == "plane" else is_image
        scope |= dict.fromkeys(self.ranges, VARIABLE)
        expected: Any = "integer" if state else "boolean"
        checked = check(expr, expected, scope, self.problems, "this expression of states")
        if checked is None:
            return []
        names = sorted(checked.variables)
        sources = [self.ranges.get(name) or RangeState(name, 0, 1) for name in names]
        shape = tuple(len(source.values) for source in sources)
        if prod(shape) > _MOST_CASES:
            text = f"{prod(shape)} combinations of values, of at most {_MOST_CASES}"
            helps = ("declare planes for its parts: `plane p = s > 2 and q`",)
            self.problems.error("NS0450", "too many cases", expr.span, text, helps=helps)
            return []
        axes = np.ix_(*(source.values for source in sources))
        bindings = {
            name: Value(axis if name in self.ranges else axis != 0)
            for name, axis in zip(names, axes, strict=True)
        }
        values, gap = values_of(checked, bindings, {}, shape)
        if gap is not None:
            gap.fault.report(self.problems)
            return []
        planes: dict[str, int] = {}
        for source, axis in zip(sources, axes, strict=True):
            bits = source.bits if source.name in self.ranges else [source.name]
            for k, bit in enumerate(bits):
                planes[bit] = packed_bits(np.broadcast_to((axis - source.low) >> k & 1, shape) != 0)
        if state is None:
            return [self._condition_of(values, planes)]
        beyond = values[(values < state.low) | (values > state.high)]
        if beyond.size:
            help_text = f"keep it in its range: `min({state.name} + 1, {state.high})`"
            outside_range(state.name, state.values, beyond[0], expr.span, help_text).report(
                self.problems
            )
            return []
        offsets = values - state.low
        return [self._condition_of(offsets >> k & 1 != 0, planes) for k in range(len(state.bits))]

    def _condition_of(self, values: Bools, planes: dict[str, int]) -> Condition:
        """Return a condition with these values, as an OR of few ANDs or its inverse.

        `planes` has the values of planes by name, as truth vectors (see `packed_bits`)."""
        everything, ones = (1 << values.size) - 1, packed_bits(values)
        names, vectors, budget = [*planes], [*planes.values()], Budget(_STEPS)
        covers = [cover(bits, vectors, everything, budget) for bits in (ones, everything & ~ones)]
        cubes = min(covers, key=lambda cubes: sum(map(len, cubes)))
        condition: Condition = Constant(bit=False)
        for number, cube in enumerate(cubes):
            term: Condition = Constant(bit=True)
            for n, (plane, one) in enumerate(cube):
                literal = Bit(names[plane]) if one else self._not(Bit(names[plane]))
                term = self._both(term, literal) if n else literal
            condition = Joined("or", condition, term) if number else term
        return condition if cubes is covers[0] else self._not(condition)
