"""Comparisons of images with levels, of counts with integers, and of two images."""

from __future__ import annotations

from abc import ABC, abstractmethod
from fractions import Fraction
from typing import Any

from nscc.program.constants import constant
from nscc.program.expressions import names_in
from nscc.program.host_values import HostValues, signed_level
from nscc.source import Span
from nscc.syntax import tree
from nscc.words import pictures as p
from nscc.words.counts import CountRange, counts_of
from nscc.words.picture_launches import HostParam

# The comparison with exchanged sides: `a > b` is `b < a`.
_MIRRORED = {">": "<", "<": ">", ">=": "<=", "<=": ">="}


class WrongPicture(Exception):
    """Raised for an invalid expression after reporting its error; whoever catches it reports
    nothing."""


class PictureComparer(ABC):
    """Converts comparisons of images to expressions of `nscc.words.pictures`, and reports invalid
    ones.

    `counts` has the ranges of values of the images of integers ("counts") that are declared so far.
    """

    def __init__(self, host: HostValues, kernels: dict[str, p.Weights]) -> None:
        """Prepare to check comparisons in the file of `host`, which knows the parameters that the
        host sets.

        `kernels` are the valid convolution kernels by name."""
        self.host, self.kernels = host, kernels
        self.declared, self.constants, self.target = host.declared, host.constants, host.target
        self.problems = host.problems
        self.counts: dict[str, CountRange] = {}

    @abstractmethod
    def _image(self, expr: tree.Expr) -> p.Value:
        """Return an expression that must be an image; raise WrongPicture after reporting an
        error."""

    @abstractmethod
    def _require_alike(self, first: p.Value, second: p.Value, span: Span) -> None:
        """Report if one image is a count and the other is in electrons, and raise WrongPicture."""

    def _not(self, condition: p.Condition) -> p.Condition:
        """Return the negation of a condition, a plane; from version 4 on in the form that needs the
        fewest words."""
        # Words of older programs stay as they are.
        if self.declared.version > 3:
            match condition:
                case p.Above(value=value, steps=steps):
                    # Not above may be taken as below: no comparator can tell equal charges.
                    return p.Above(picture_sum((Fraction(-1), value)), -steps)
                case p.AboveParam(value=value, param=param, factor=factor):
                    return p.AboveParam(picture_sum((Fraction(-1), value)), param, -factor)
            return p.inverse_of(condition)
        return p.Inverse(condition)

    def _both(self, first: p.Condition, second: p.Condition) -> p.Condition:
        """Return the condition that holds where both `first` and `second` hold. From version 4 on
        it has the form that needs the fewest words."""
        if self.declared.version > 3:
            # NOR is one word, and the negations often need none.
            return p.Neither(self._not(first), self._not(second))
        return p.Joined("and", first, second)

    def _compare(self, compare: tree.Compare) -> p.Condition:
        """Return the condition, a plane, of a chain of comparisons such as `a < image < b`.

        Raises WrongPicture after reporting an error, such as NS0533 for == and !=."""
        operands = (compare.first, *compare.later_operands)
        condition: p.Condition | None = None
        for op, first, second in zip(
            compare.ops, operands[:-1], compare.later_operands, strict=True
        ):
            if op in ("==", "!="):
                for name in names_in(compare):
                    if name.text in ("x", "y") and self.declared.version > 3:
                        self._image(name)  # raises WrongPicture with a help about positions
                raise self._report(
                    "NS0533",
                    "images are compared by `>`, `<`, `>=` and `<=`",
                    compare.span,
                    "tests whether they are equal",
                    (
                        "compare with both sides of a small range: `-2% < image < 2%`, "
                        "`3 <= count <= 3`",
                    ),
                    notes=("no comparator can tell whether two charges are equal",),
                )
            comparison = self._one_comparison(op, first, second, compare.span)
            condition = comparison if condition is None else self._both(condition, comparison)
        assert condition is not None
        return condition

    def _one_comparison(
        self, op: str, first: tree.Expr, second: tree.Expr, span: Span
    ) -> p.Condition:
        """Return the condition of one comparison: of an image with a level, or of two images.

        `op` is >, <, >= or <=. Two images are compared by the sign of their difference. Raises
        WrongPicture after reporting an error, such as NS0533 for two levels."""
        if self._is_level(first):
            if not self._is_level(second):
                return self._one_comparison(_MIRRORED[op], second, first, span)
            raise self._report(
                "NS0533",
                "a comparison has an image on at least one side",
                span,
                "two levels",
                ("compare an image with a level: `image > 6%`",),
            )
        value, level = self._image(first), second
        if not self._is_level(second):
            other, level = self._image(second), tree.Int(second.span, 0)
            self._require_alike(value, other, span)
            value = picture_sum((Fraction(1), value), (Fraction(-1), other))
        counts = counts_of(value, self.counts, self.kernels)
        if counts is not None:
            return self._count_comparison(value, counts, op, level)
        test = self._above(value, level)
        # `>=` counts as `>`, and `<=` as `<`: no comparator can tell equal charges.
        return test if op[0] == ">" else self._not(test)

    def _above(self, value: p.Value, level: tree.Expr) -> p.Condition:
        """Return the condition that the image `value` is above a level with a unit, 0, or a
        parameter that the host sets.

        Raises WrongPicture after reporting NS0533 for an invalid level, such as a parameter that is
        an integer."""
        param = self.host.level_param(level)
        if param is None:
            return self._above_steps(value, self._steps(level), level.span)
        sign, parameter = param
        self._require_level(parameter, level.span)
        return p.AboveParam(value, parameter.name, sign)

    def _above_steps(self, value: p.Value, steps: int, span: Span) -> p.Condition:
        """Return the condition that an image is above `steps` of IN (the value that all pixels
        receive).

        If the image is a sum that contains levels, they are moved to the other side where IN can
        represent the result. Raises WrongPicture after reporting (NS0533, at `span`) a sum of
        levels only."""
        terms = value.terms if isinstance(value, p.Sum) else ((Fraction(1), value),)
        levels = {term.param: factor for factor, term in terms if isinstance(term, p.Uniform)}
        if not levels:
            return p.Above(value, steps)
        other = [(factor, term) for factor, term in terms if not isinstance(term, p.Uniform)]
        if not other:
            raise self._report(
                "NS0533",
                "a comparison has an image on at least one side",
                span,
                "only levels",
                ("compare an image with a level: `image > 6%`",),
            )
        # The level without a parameter has the name "".
        constant_steps = steps - levels.pop("", Fraction(0))
        whole = constant_steps.denominator == 1 and abs(constant_steps) <= self.host.most_steps
        if not levels and whole:
            return p.Above(picture_sum(*other), int(constant_steps))
        # A parameter alone, times 1 or -1, is a level that the host sets: an `AboveParam`.
        if not constant_steps:
            for param, factor in levels.items():
                if abs(factor) == 1:
                    without = [term for term in terms if term[1] != p.Uniform(param)]
                    return p.AboveParam(picture_sum(*without), param, -int(factor))
        return p.Above(value, steps)

    def _require_level(self, param: HostParam, span: Span) -> None:
        """Raise WrongPicture after reporting (NS0533) a parameter that is an integer, where a level
        with a unit is needed."""
        if param.kind == "integer":
            raise self._report(
                "NS0533",
                f"`{param.name}` is an integer, but a level has a unit",
                span,
                "without a unit",
                (f"declare levels: `param {param.name} : 1% .. 20% = 4%`",),
            )

    def _is_level(self, expr: tree.Expr) -> bool:
        """Return whether a side of a comparison is a level: an amount with a unit, a parameter or a
        number."""
        inner = signed_level(expr)[1]
        is_param = isinstance(inner, tree.Name) and inner.text in self.declared.params
        return is_param or isinstance(inner, tree.Amount) or self._is_number(expr)

    def _count_comparison(
        self, value: p.Value, counts: CountRange, op: str, level: tree.Expr
    ) -> p.Condition:
        """Return the comparison of `value`, a count, with the integer `level`, as one with a level
        between two possible counts.

        `counts` is the range of the count, and `op` is >, <, >= or <=. Raises WrongPicture after
        reporting NS0533 if the answer would be the same in every pixel, or if the level has a unit.
        """
        if not self._is_number(level):
            raise self._report(
                "NS0533",
                "a level of counts is an integer",
                level.span,
                "with a unit",
                ("write a number without a unit: `count > 3`",),
            )
        number = constant(level, self.constants, self.problems, "a level")
        if number is None:
            raise WrongPicture
        # `count >= 3` is true above a level below 3; `count < 3` is its negation.
        split = counts.half_way(Fraction(number), or_equal=op in (">=", "<"))
        if split is None:
            raise self._report(
                "NS0533",
                f"these counts lie from {counts.low} to {counts.high}: this comparison "
                "has the same answer in every pixel",
                level.span,
                "beyond all counts",
                (f"compare with a number from {counts.low} to {counts.high}",),
            )
        test = p.Exceeds(value, split)
        return test if op[0] == ">" else p.Inverse(test)

    def _steps(self, expr: tree.Expr) -> int:
        """Return the level `expr`, with its sign, in whole steps of IN (the level sent to all
        pixels); a plain 0 needs no unit.

        Raises WrongPicture after reporting NS0533 for a level without a unit, or one that IN cannot
        represent."""
        sign, inner = signed_level(expr)
        if not isinstance(inner, tree.Amount):
            number = constant(expr, self.constants, self.problems, "a level")
            if number == 0:
                return 0
            raise (
                WrongPicture
                if number is None
                else self._report(
                    "NS0533",
                    "a level has a unit",
                    expr.span,
                    "without a unit",
                    (
                        f"write `{number}%` of a full well, `{number}e` or `{number}lsb`; "
                        "only `0` needs none",
                    ),
                )
            )
        target = self.target
        electrons = sign * target.level_e(float(inner.value), inner.unit)
        steps = round(electrons / target.electrons_per_step)
        reach = min(target.in_high, -target.in_low)
        # A small level must not become 0, which would be another comparison.
        if abs(steps) > reach or steps == 0 != electrons:
            least, most = target.electrons_per_step, reach * target.electrons_per_step
            raise self._report(
                "NS0533",
                f"IN cannot be {electrons:g} e",
                expr.span,
                "this level",
                (
                    f"give a level from {100 * least / target.full_well_e:.3g}% to "
                    f"{100 * most / target.full_well_e:.3g}%, or scale the image",
                ),
                notes=(f"IN has steps of {least:.4g} e, up to {reach} of them",),
            )
        return steps

    def _is_number(self, expr: tree.Expr) -> bool:
        """Return whether an expression contains only integers and names of constants (`let`, N,
        rows, cols), joined by operators. Their values are not checked."""
        match expr:
            case tree.Int():
                return True
            case tree.Name():
                return expr.text in self.declared.lets or expr.text in ("N", "rows", "cols")
            case tree.Unary(op="-"):
                return self._is_number(expr.operand)
            case tree.Binary():
                return self._is_number(expr.left) and self._is_number(expr.right)
        return False

    def _report(
        self,
        code: str,
        message: str,
        span: Span,
        label: str,
        helps: tuple[str, ...],
        **details: Any,
    ) -> WrongPicture:
        """Report an error, and return the exception that ends the expression, for the caller to
        raise. `details` are further fields of `Diagnostic`."""
        self.problems.error(code, message, span, label, helps=helps, **details)
        return WrongPicture()


def picture_sum(*terms: tuple[Fraction, p.Value]) -> p.Value:
    """Return the sum of factors times images, without nested sums, equal terms or zero terms.

    There is at least one term. A single term with the factor 1 is returned as it is. If all terms
    cancel, one stays, times 0: it tells whether the sum is a count."""
    flat: list[tuple[Fraction, p.Value]] = []
    for factor, value in terms:
        terms_of_value = value.terms if isinstance(value, p.Sum) else ((Fraction(1), value),)
        flat += [(factor * inner, term) for inner, term in terms_of_value]
    merged: dict[p.Value, Fraction] = {}
    for factor, value in flat:
        merged[value] = merged.get(value, Fraction(0)) + factor
    nonzero = tuple((factor, value) for value, factor in merged.items() if factor)
    nonzero = nonzero or tuple((Fraction(0), value) for value in merged)[:1]
    if len(nonzero) == 1 and nonzero[0][0] == 1:
        return nonzero[0][1]
    return p.Sum(nonzero)
