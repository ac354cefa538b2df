"""Expressions of images and planes: conversion to nodes, with names and types checked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, Literal, cast

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Fix
from nscc.program.constants import constant
from nscc.program.expressions import Meaning
from nscc.program.looking import level_e
from nscc.program.names import Declarations
from nscc.program.problems import Problems
from nscc.source import Span
from nscc.syntax import tree
from nscc.words import pictures as p

Kind = Literal["image", "plane", "bucket"]
_FUNCTIONS = ("abs", "any", "all", "agree", "max", "min")


class _Wrong(Exception):
    """Raised after an error in an expression was reported."""


class Reader:
    """A reader of expressions in the order of the text; `kinds` are the names declared so far."""

    def __init__(
        self,
        declared: Declarations,
        constants: Mapping[str, Meaning],
        target: Target,
        buckets: Sequence[str],
        kernels: Mapping[str, p.Weights],
        outside: int | None,
        problems: Problems,
    ) -> None:
        self.declared, self.constants, self.target = declared, constants, target
        self.buckets, self.kernels, self.outside = buckets, kernels, outside
        self.problems = problems
        self.kinds: dict[str, Kind] = {}
        self.failed: set[str] = set()
        self._outside_asked = False

    def declare(self, name: str, is_plane: bool, *, sound: bool) -> None:
        """Declare an image or plane for the following expressions; unless `sound`, mark it as
        invalid."""
        if not sound:
            self.failed.add(name)
        else:
            self.kinds[name] = "plane" if is_plane else "image"

    def image(self, expr: tree.Expr) -> p.Value | None:
        """Return the image of an expression; None after reporting an error."""
        try:
            return self._image(expr)
        except _Wrong:
            return None

    def condition(self, expr: tree.Expr) -> p.Condition | None:
        """Return the plane of an expression; None after reporting an error."""
        try:
            return self._condition(expr)
        except _Wrong:
            return None

    # --- images

    def _image(self, expr: tree.Expr) -> p.Value:
        match expr:
            case tree.Name():
                return self._named_image(expr)
            case tree.Unary(op="-", operand=operand):
                return _sum((Fraction(-1), self._image(operand)))
            case tree.Binary(op="+" | "-" as op, left=left, right=right):
                sign = Fraction(1 if op == "+" else -1)
                return _sum((Fraction(1), self._image(left)), (sign, self._image(right)))
            case tree.Binary(op="*" | "/", left=left, right=right):
                return self._scaled(expr, left, right)
            case tree.IfElse():
                return p.Chosen(
                    self._condition(expr.condition), self._image(expr.then),
                    self._image(expr.otherwise),
                )  # fmt: skip
            case tree.Call():
                return self._call(expr)
        raise self._report(
            "NS0531", "this is not an image", expr.span, "no image",
            ("an image combines `exposure`, buckets and images with `+`, `-`, `* integer`, "
             "`/ power of two`, kernels, `abs(..)` and `A if PLANE else B`",),
        )  # fmt: skip

    def _named_image(self, name: tree.Name) -> p.Value:
        text = name.text
        if text == "exposure":
            if len(self.buckets) == 1:
                return p.Source(self.buckets[0])
            raise self._report(
                "NS0323", "this program has several buckets", name.span, "whose exposure?",
                (f"name the bucket: `{self.buckets[0]}`",),
            )  # fmt: skip
        kind = self.kinds.get(text)
        if kind == "image":
            return p.Source(text)
        if kind == "plane":
            raise self._report(
                "NS0531", f"`{text}` is a plane, but this must be an image", name.span, "a plane",
                (f"choose between two images with it: `A if {text} else B`",),
            )  # fmt: skip
        if text in self.buckets and text not in self.kinds:
            return p.Source(text)
        raise self._unknown("an image or a bucket", name, "image")

    def _scaled(self, expr: tree.Binary, image: tree.Expr, factor: tree.Expr) -> p.Value:
        if expr.op == "*" and self._is_number(image):
            image, factor = factor, image
        if not self._is_number(factor):
            raise self._report(
                "NS0531", "an image can be multiplied or divided only by an integer", expr.span,
                "two images" if not self._is_number(image) else "divided by an image",
                ("a pixel can add, subtract and halve values, but not multiply two values",),
            )  # fmt: skip
        number = constant(factor, self.constants, self.problems, "a factor")
        if number is None:
            raise _Wrong
        if expr.op == "*":
            return _sum((Fraction(number), self._image(image)))
        if not is_power_of_two(number):
            refuse_divisor(self.problems, number, factor.span)
            raise _Wrong
        return _sum((Fraction(1, number), self._image(image)))

    def _call(self, call: tree.Call) -> p.Value:
        name, arguments = call.function.text, call.arguments
        if name in ("agree", "max", "min"):
            raise self._report(
                "NS0539", f"`{name}` of images is not supported yet", call.span, "not yet",
                ("use sums, kernels, `abs(..)` and `A if PLANE else B`",),
            )  # fmt: skip
        if name in ("any", "all"):
            raise self._report(
                "NS0531", f"`{name}(..)` is a plane, but this must be an image", call.span,
                "a plane", (f"declare `plane p = {name}(..)` and write `A if p else B`",),
            )  # fmt: skip
        if name != "abs" and name not in self.kernels:
            if name in self.declared.kernels:
                raise _Wrong
            raise self._unknown("a kernel", call.function, "kernel")
        if len(arguments) != 1:
            raise self._report(
                "NS0531", f"`{name}` takes one image", call.span, f"{len(arguments)} arguments",
                (f"write `{name}(EXPR)`",),
            )  # fmt: skip
        value = self._image(arguments[0])
        return p.Absolute(value) if name == "abs" else p.Filtered(name, value)

    # --- planes

    def _condition(self, expr: tree.Expr) -> p.Condition:
        match expr:
            case tree.Bool():
                return p.Constant(expr.value)
            case tree.Name():
                return self._named_plane(expr)
            case tree.Unary(op="not"):
                return p.Inverse(self._condition(expr.operand))
            case tree.Binary(op="and" | "or" | "xor" as op):
                first, second = self._condition(expr.left), self._condition(expr.right)
                return p.Joined(cast(Any, op), first, second)
            case tree.Compare():
                return self._compare(expr)
            case tree.Place():
                self._needs_outside(expr.span)
                x = constant(expr.right, self.constants, self.problems, "columns to the right")
                y = constant(expr.down, self.constants, self.problems, "rows down")
                if x is None or y is None:
                    raise _Wrong
                return p.At(self._named_plane(expr.base), x, y)
            case tree.Call():
                return self._any_or_all(expr)
        raise self._report(
            "NS0531", "this is not a plane", expr.span, "no condition",
            ("a plane combines comparisons such as `image > 6%` and planes with `and`, `or`, "
             "`xor`, `not`, `any(PLANE, kernel)`, `all(PLANE, kernel)` and `PLANE[dx, dy]`",),
        )  # fmt: skip

    def _named_plane(self, name: tree.Name) -> p.Condition:
        kind = self.kinds.get(name.text)
        if kind == "plane":
            return p.Bit(name.text)
        if kind == "image" or name.text in (*self.buckets, "exposure"):
            raise self._report(
                "NS0531", f"`{name.text}` is an image, but this must be a plane", name.span,
                "an image", (f"compare it with a level: `{name.text} > 6%`",),
            )  # fmt: skip
        raise self._unknown("a plane", name, "plane")

    def _any_or_all(self, call: tree.Call) -> p.Condition:
        kind = call.function.text
        if kind not in ("any", "all"):
            image = kind in self.kernels or kind in _FUNCTIONS
            if not image:
                raise self._unknown("a function of planes", call.function, "function")
            raise self._report(
                "NS0531", f"`{kind}(..)` is an image, but this must be a plane", call.span,
                "an image", (f"compare it with a level: `{kind}(..) > 6%`",),
            )  # fmt: skip
        if len(call.arguments) != 2 or not isinstance(call.arguments[1], tree.Name):
            raise self._report(
                "NS0531", f"`{kind}` takes a plane and a kernel", call.span, "these arguments",
                (f"write `{kind}(PLANE, KERNEL)`",),
            )  # fmt: skip
        kernel = call.arguments[1]
        if kernel.text not in self.kernels:
            if kernel.text in self.declared.kernels:
                raise _Wrong
            raise self._unknown("a kernel", kernel, "kernel")
        self._needs_outside(call.span)
        return p.Near(cast(Any, kind), self._condition(call.arguments[0]), kernel.text)

    def _needs_outside(self, span: Span) -> None:
        if self.outside is not None or self._outside_asked:
            return
        self._outside_asked = True
        self.problems.error(
            "NS0534", "the bits of neighbours outside the array are not defined", span,
            "reads them in pixels at the border",
            helps=("define these bits: `outside 0` or `outside 1`",),
        )  # fmt: skip

    def _compare(self, compare: tree.Compare) -> p.Condition:
        operands = (compare.first, *compare.later_operands)
        condition: p.Condition | None = None
        for op, first, second in zip(
            compare.ops, operands[:-1], compare.later_operands, strict=True
        ):
            if op in ("==", "!="):
                raise self._report(
                    "NS0533", "images can be compared only with `>` and `<`", compare.span,
                    f"this is `{op}`",
                    ("test whether the image is in a small range: "
                     "`-2% < image < 2%`",),
                    notes=("a comparator cannot test whether two charges are equal",),
                )  # fmt: skip
            comparison = self._one_comparison(op[0] == ">", first, second, compare.span)
            condition = comparison if condition is None else p.Joined("and", condition, comparison)
        assert condition is not None
        return condition

    def _one_comparison(
        self, above: bool, first: tree.Expr, second: tree.Expr, span: Span
    ) -> p.Condition:
        """Return `first > second` if `above`, else `first < second`; at least one side is
        an image."""
        levels = [self._steps(side) for side in (first, second)]
        if levels[0] is not None and levels[1] is not None:
            raise self._report(
                "NS0533", "at least one side of a comparison must be an image", span, "no image",
                ("compare an image with a level: `image > 6%`",),
            )  # fmt: skip
        if levels[0] is not None:
            return self._one_comparison(not above, second, first, span)
        value = self._image(first)
        if levels[1] is None:
            value = _sum((Fraction(1), value), (Fraction(-1), self._image(second)))
        test = p.Above(value, levels[1] or 0)
        return test if above else p.Inverse(test)

    def _steps(self, expr: tree.Expr) -> int | None:
        """Return a level in steps of IN; None for an expression that is not a level."""
        sign, inner = 1, expr
        while isinstance(inner, tree.Unary) and inner.op == "-":
            sign, inner = -sign, inner.operand
        if isinstance(inner, tree.Int):
            if inner.value == 0:
                return 0
            raise self._report(
                "NS0533", "this level has no unit", expr.span, "a number alone",
                (f"write `{inner.value}%` of a full well, `{inner.value}e` or `{inner.value}lsb`; "
                 "only `0` needs no unit",),
            )  # fmt: skip
        if not isinstance(inner, tree.Amount):
            return None
        target = self.target
        electrons = sign * level_e(float(inner.value), inner.unit, target)
        steps = round(electrons / target.electrons_per_step)
        reach = min(target.in_high, -target.in_low)
        if abs(steps) > reach or steps == 0 != electrons:
            least, most = target.electrons_per_step, reach * target.electrons_per_step
            raise self._report(
                "NS0533", f"the level {electrons:g} e is outside the range of IN", expr.span,
                "this level",
                (f"give a level from {100 * least / target.full_well_e:.3g}% to "
                 f"{100 * most / target.full_well_e:.3g}%, or scale the image",),
                notes=(f"IN has steps of {least:.4g} e, from 1 to {reach}",),
            )  # fmt: skip
        return steps

    # --- both

    def _is_number(self, expr: tree.Expr) -> bool:
        """Return whether an expression contains neither images nor levels."""
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

    def _unknown(self, category: str, name: tree.Name, kind: str) -> _Wrong:
        text = name.text
        if text in self.failed or text in self.declared.refused:
            return _Wrong()
        later = [picture for picture in self.declared.pictures if picture.name.text == text]
        if later:
            return self._report(
                "NS0531", f"`{text}` is used before its declaration", name.span, "not computed yet",
                ("images and planes are computed in the order of the program: move it up",),
            )  # fmt: skip
        if text in (*self.declared.senses, *self.declared.states):
            return self._report(
                "NS0539", f"`{text}` in images and planes is not supported yet", name.span,
                "not yet", ("use only `exposure`, buckets, images and planes",),
            )  # fmt: skip
        known = {
            "kernel": [*self.kernels, "abs"],
            "function": ["any", "all"],
            "plane": [name for name, kind in self.kinds.items() if kind == "plane"],
        }.get(kind, [*self.buckets, *(n for n, k in self.kinds.items() if k == "image")])
        self.problems.unknown(category, text, name.span, known)
        return _Wrong()

    def _report(
        self,
        code: str,
        message: str,
        span: Span,
        label: str,
        helps: tuple[str, ...],
        **details: Any,
    ) -> _Wrong:
        self.problems.error(code, message, span, label, helps=helps, **details)
        return _Wrong()


def is_power_of_two(number: int) -> bool:
    """Return whether `number` is a power of two, by which a pixel can divide."""
    return number > 0 and number & (number - 1) == 0


def refuse_divisor(problems: Problems, divisor: int, span: Span) -> None:
    """Report NS0532, with the nearest power of two and how much the result changes."""
    helps: tuple[str, ...] = ("divide by 1, 2, 4, 8, ..",)
    fixes: tuple[Fix, ...] = ()
    if divisor > 0:
        power = nearest_power(divisor)
        percent = 100 * abs(divisor / power - 1)
        change = "larger" if power < divisor else "smaller"
        text = f"with `/ {power}` values are {percent:.0f} % {change}: change the levels, too"
        helps = (text, *helps)
        fixes = (Fix(f"divide by {power}", span, str(power), sure=False),)
    problems.error(
        "NS0532", f"a pixel cannot divide by {divisor}", span, "not a power of two",
        notes=("a word can halve a value; there is no other division",),
        helps=helps, fixes=fixes,
    )  # fmt: skip


def nearest_power(number: int) -> int:
    """Return the power of two whose ratio to a number above 0 is nearest to 1."""
    low = 1 << (number.bit_length() - 1)
    return low if number / low <= 2 * low / number else 2 * low


def _sum(*terms: tuple[Fraction, p.Value]) -> p.Value:
    """Return a sum with nested sums expanded, and without terms with factor 0."""
    flat: list[tuple[Fraction, p.Value]] = []
    for factor, value in terms:
        terms_of_value = value.terms if isinstance(value, p.Sum) else ((Fraction(1), value),)
        flat += [(factor * inner, term) for inner, term in terms_of_value]
    merged: dict[p.Value, Fraction] = {}
    for factor, value in flat:
        merged[value] = merged.get(value, Fraction(0)) + factor
    nonzero = tuple((factor, value) for value, factor in merged.items() if factor)
    if len(nonzero) == 1 and nonzero[0][0] == 1:
        return nonzero[0][1]
    return p.Sum(nonzero)
