"""Expressions of images and planes: from the tree to nodes, every name and type checked."""

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
from nscc.words.counts import Counts, counts_of

Kind = Literal["image", "plane", "bucket"]
_FUNCTIONS = ("abs", "agree", "max", "min")
_MIRRORED = {">": "<", "<": ">", ">=": "<=", "<=": ">="}


class _Wrong(Exception):
    """An expression has an error, which is reported."""


class Reader:
    """Reads the expressions of a text in its order; `kinds` are the images and planes so far,
    `counts` those images that are counts. States are planes."""

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
        self.counts: dict[str, Counts] = {}
        if declared.keeps_planes:
            self.kinds.update(dict.fromkeys(declared.states, "plane"))
        self.failed: set[str] = set()
        self._outside_asked = False

    def declare(self, name: str, node: p.Node | None) -> None:
        """A picture is known from here on; None where it has an error."""
        if node is None:
            self.failed.add(name)
        elif isinstance(node, p.Condition):
            self.kinds[name] = "plane"
        else:
            self.kinds[name] = "image"
            if (counts := self._counts(node)) is not None:
                self.counts[name] = counts

    def image(self, expr: tree.Expr) -> p.Value | None:
        """The image that an expression is; None after reporting why it is none."""
        try:
            return self._image(expr)
        except _Wrong:
            return None

    def condition(self, expr: tree.Expr) -> p.Condition | None:
        """The plane that an expression is; None after reporting why it is none."""
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
                first, second = self._image(left), self._image(right)
                self._require_alike(first, second, expr.span)
                return _sum((Fraction(1), first), (sign, second))
            case tree.Binary(op="*" | "/", left=left, right=right):
                return self._scaled(expr, left, right)
            case tree.IfElse():
                condition = self._condition(expr.condition)
                first, second = self._image(expr.then), self._image(expr.otherwise)
                self._require_alike(first, second, expr.span)
                return p.Chosen(condition, first, second)
            case tree.Call():
                return self._call(expr)
        raise self._report(
            "NS0531", "this is not an image", expr.span, "no image",
            ("an image is made of `exposure`, buckets and images by `+`, `-`, `* integer`, "
             "`/ power of two`, kernels, `abs(..)`, `max(EXPR, kernel)`, `agree(PLANE, kernel)` "
             "and `A if PLANE else B`",),
        )  # fmt: skip

    def _counts(self, value: p.Value) -> Counts | None:
        """The values of a count; None for electrons."""
        return counts_of(value, self.counts, self.kernels)

    def _require_alike(self, first: p.Value, second: p.Value, span: Span) -> None:
        if (self._counts(first) is None) != (self._counts(second) is None):
            raise self._report(
                "NS0531", "counts and electrons do not mix", span,
                "one of the two is a count, made by `agree`",
                ("compare each of them, and join the planes: `a > 6% and c > 3`",),
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
                "NS0531", f"`{text}` is a plane, and an image belongs here", name.span, "a plane",
                (f"choose by it: `A if {text} else B`",),
            )  # fmt: skip
        if text in self.buckets and text not in self.kinds:
            return p.Source(text)
        raise self._unknown("an image or a bucket", name, "image")

    def _scaled(self, expr: tree.Binary, image: tree.Expr, factor: tree.Expr) -> p.Value:
        if expr.op == "*" and self._is_number(image):
            image, factor = factor, image
        if not self._is_number(factor):
            raise self._report(
                "NS0531", "images are multiplied and divided by integers only", expr.span,
                "two images" if not self._is_number(image) else "divided by an image",
                ("a pixel adds, subtracts and halves; it has no product of two values",),
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
        if name in ("agree", "max"):
            kernel = self._kernel_of(call, "EXPR" if name == "max" else "PLANE")
            if name == "max":
                return p.Largest(self._image(arguments[0]), kernel)
            self._needs_outside(call.span)
            return p.Agreement(self._condition(arguments[0]), kernel)
        if name == "min":
            raise self._report(
                "NS0531", "there is no `min` of images", call.span, "not a function of images",
                ("write `-max(-EXPR, kernel)`",),
            )  # fmt: skip
        if name in ("any", "all"):
            raise self._report(
                "NS0531", f"`{name}` makes a plane, and an image belongs here", call.span,
                "a plane", (f"declare it: `plane p = {name}(..)`, then choose: `A if p else B`",),
            )  # fmt: skip
        if name != "abs" and name not in self.kernels:
            if name in self.declared.kernels:
                raise _Wrong
            raise self._unknown("a kernel", call.function, "kernel")
        if len(arguments) != 1:
            raise self._report(
                "NS0531", f"`{name}` takes one image", call.span, f"{len(arguments)} are given",
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
            ("a plane is made of comparisons such as `image > 6%`, planes, `and`, `or`, `xor`, "
             "`not`, `any(PLANE, kernel)`, `all(PLANE, kernel)` and `PLANE[dx, dy]`",),
        )  # fmt: skip

    def _named_plane(self, name: tree.Name) -> p.Condition:
        kind = self.kinds.get(name.text)
        if kind == "plane":
            return p.Bit(name.text)
        if kind == "image" or name.text in (*self.buckets, "exposure"):
            raise self._report(
                "NS0531", f"`{name.text}` is an image, and a plane belongs here", name.span,
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
                "NS0531", f"`{kind}(..)` is an image, and a plane belongs here", call.span,
                "an image", (f"compare it with a level: `{kind}(..) > 6%`",),
            )  # fmt: skip
        kernel = self._kernel_of(call, "PLANE")
        self._needs_outside(call.span)
        return p.Near(cast(Any, kind), self._condition(call.arguments[0]), kernel)

    def _kernel_of(self, call: tree.Call, first: str) -> str:
        """The kernel that is the second argument of a call."""
        name, arguments = call.function.text, call.arguments
        if len(arguments) != 2 or not isinstance(arguments[1], tree.Name):
            what = "a plane" if first == "PLANE" else "an image"
            raise self._report(
                "NS0531", f"`{name}` takes {what} and a kernel", call.span, "these arguments",
                (f"write `{name}({first}, KERNEL)`",),
            )  # fmt: skip
        kernel = arguments[1]
        if kernel.text not in self.kernels:
            if kernel.text in self.declared.kernels:
                raise _Wrong
            raise self._unknown("a kernel", kernel, "kernel")
        return kernel.text

    def _needs_outside(self, span: Span) -> None:
        if self.outside is not None or self._outside_asked:
            return
        self._outside_asked = True
        self.problems.error(
            "NS0534", "bits of neighbours are read, and those beyond the array have no value", span,
            "at the border this reads beyond the array",
            helps=("say what they are: `outside 0`, or `outside 1`",),
        )  # fmt: skip

    def _compare(self, compare: tree.Compare) -> p.Condition:
        operands = (compare.first, *compare.later_operands)
        condition: p.Condition | None = None
        for op, first, second in zip(
            compare.ops, operands[:-1], compare.later_operands, strict=True
        ):
            if op in ("==", "!="):
                raise self._report(
                    "NS0533", "charges are compared by `>` and `<`", compare.span,
                    f"this is `{op}`",
                    ("a pixel compares with both sides of a small range: "
                     "`-2% < image < 2%`",),
                    notes=("no comparator can tell whether two charges are equal",),
                )  # fmt: skip
            comparison = self._one_comparison(op, first, second, compare.span)
            condition = comparison if condition is None else p.Joined("and", condition, comparison)
        assert condition is not None
        return condition

    def _one_comparison(
        self, op: str, first: tree.Expr, second: tree.Expr, span: Span
    ) -> p.Condition:
        """A comparison of an image with a level or with another image."""
        if self._is_level(first):
            if not self._is_level(second):
                return self._one_comparison(_MIRRORED[op], second, first, span)
            raise self._report(
                "NS0533", "a comparison has an image on at least one side", span, "two levels",
                ("compare an image with a level: `image > 6%`",),
            )  # fmt: skip
        value, level = self._image(first), second
        if not self._is_level(second):
            other, level = self._image(second), tree.Int(second.span, 0)
            self._require_alike(value, other, span)
            value = _sum((Fraction(1), value), (Fraction(-1), other))
        counts = self._counts(value)
        if counts is not None:
            return self._count_comparison(value, counts, op, level)
        test = p.Above(value, self._steps(level))
        return test if op[0] == ">" else p.Inverse(test)

    def _is_level(self, expr: tree.Expr) -> bool:
        """Whether one side of a comparison is a level: with a unit, or a number."""
        while isinstance(expr, tree.Unary) and expr.op == "-":
            expr = expr.operand
        return isinstance(expr, tree.Amount) or self._is_number(expr)

    def _count_comparison(
        self, value: p.Value, counts: Counts, op: str, level: tree.Expr
    ) -> p.Condition:
        """A comparison of counts, half-way between two that are attainable."""
        if not self._is_number(level):
            raise self._report(
                "NS0533", "a level of counts is an integer", level.span, "with a unit",
                ("write a number without a unit: `count > 3`",),
            )  # fmt: skip
        number = constant(level, self.constants, self.problems, "a level")
        if number is None:
            raise _Wrong
        split = counts.half_way(Fraction(number), or_equal=op in (">=", "<"))
        if split is None:
            raise self._report(
                "NS0533", f"these counts lie from {counts.low} to {counts.high}: this comparison "
                "has the same answer in every pixel", level.span, "beyond all counts",
                (f"compare with a number from {counts.low} to {counts.high}",),
            )  # fmt: skip
        test = p.Exceeds(value, split)
        return test if op[0] == ">" else p.Inverse(test)

    def _steps(self, expr: tree.Expr) -> int:
        """A level in steps of IN."""
        sign, inner = 1, expr
        while isinstance(inner, tree.Unary) and inner.op == "-":
            sign, inner = -sign, inner.operand
        if not isinstance(inner, tree.Amount):
            number = constant(expr, self.constants, self.problems, "a level")
            if number == 0:
                return 0
            raise _Wrong if number is None else self._report(
                "NS0533", "a level has a unit", expr.span, "without a unit",
                (f"write `{number}%` of a full well, `{number}e` or `{number}lsb`; "
                 "only `0` needs none",),
            )  # fmt: skip
        target = self.target
        electrons = sign * level_e(float(inner.value), inner.unit, target)
        steps = round(electrons / target.electrons_per_step)
        reach = min(target.in_high, -target.in_low)
        if abs(steps) > reach or steps == 0 != electrons:
            least, most = target.electrons_per_step, reach * target.electrons_per_step
            raise self._report(
                "NS0533", f"IN cannot be {electrons:g} e", expr.span, "this level",
                (f"give a level from {100 * least / target.full_well_e:.3g}% to "
                 f"{100 * most / target.full_well_e:.3g}%, or scale the image",),
                notes=(f"IN has steps of {least:.4g} e, up to {reach} of them",),
            )  # fmt: skip
        return steps

    # --- both

    def _is_number(self, expr: tree.Expr) -> bool:
        """Whether an expression has neither images nor levels in it."""
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
                "NS0531", f"`{text}` is declared further down", name.span, "not computed yet",
                ("images and planes are computed in the order of the text: move it up",),
            )  # fmt: skip
        if text in (*self.declared.senses, *self.declared.states):
            return self._report(
                "NS0539", f"`{text}` in images and planes is not supported yet", name.span,
                "not yet", ("use exposures, images, planes, and states that step on them",),
            )  # fmt: skip
        known = {
            "kernel": [*self.kernels, *_FUNCTIONS[:3]],
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
    """Return whether a pixel can divide by `number`."""
    return number > 0 and number & (number - 1) == 0


def refuse_divisor(problems: Problems, divisor: int, span: Span) -> None:
    """Report NS0532, with the nearest power of two and what dividing by it changes."""
    helps: tuple[str, ...] = ("divide by 1, 2, 4, 8, ..",)
    fixes: tuple[Fix, ...] = ()
    if divisor > 0:
        power = nearest_power(divisor)
        percent = 100 * abs(divisor / power - 1)
        change = "larger" if power < divisor else "smaller"
        text = f"`/ {power}` makes everything {percent:.0f} % {change}; choose levels to match"
        helps = (text, *helps)
        fixes = (Fix(f"divide by {power}", span, str(power), sure=False),)
    problems.error(
        "NS0532", f"a pixel cannot divide by {divisor}", span, "no power of two",
        notes=("one word halves a value; there is no other division",),
        helps=helps, fixes=fixes,
    )  # fmt: skip


def nearest_power(number: int) -> int:
    """The power of two whose ratio to a number above 0 is nearest to 1."""
    low = 1 << (number.bit_length() - 1)
    return low if number / low <= 2 * low / number else 2 * low


def _sum(*terms: tuple[Fraction, p.Value]) -> p.Value:
    """A sum without sums in it, and without terms that add nothing."""
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
