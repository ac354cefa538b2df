"""Expressions of images and planes: conversion to nodes, with names and types checked."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, cast

from nscc.diagnostics.diagnostic import Fix
from nscc.program.constants import constant
from nscc.program.host_values import HostValues
from nscc.program.picture_comparisons import WrongPicture, picture_sum
from nscc.program.problems import Problems
from nscc.program.range_states import RangeReader
from nscc.source import Span
from nscc.syntax import tree
from nscc.words import pictures as p
from nscc.words.counts import counts_of

_FUNCTIONS = ("abs", "agree", "max", "min")


class Reader(RangeReader):
    """Converts expressions of images and planes to those of `nscc.words.pictures`, in the order of
    the text.

    `kinds` says of each name declared so far whether it is an image or a plane."""

    def __init__(
        self,
        host: HostValues,
        kernels: dict[str, p.Weights],
        buckets: Sequence[str],
        outside: int | None,
    ) -> None:
        """Begin with the kept states, kept images and input planes of the file of `host` as known
        names.

        `buckets` are the names of buckets, and `kernels` the convolution kernels. `outside` is the
        bit of planes beyond the array, None if the program does not say."""
        super().__init__(host, kernels)
        self.buckets, self.outside = buckets, outside
        declared = self.declared
        if declared.keeps_planes:
            states = declared.states.items()
            bits = [name for name, state in states if isinstance(state, tree.StateBit)]
            self.kinds.update(dict.fromkeys(bits, "plane"))
            self.kinds.update(dict.fromkeys(declared.kept_images, "image"))
        self.kinds.update(dict.fromkeys(declared.inputs, "plane"))
        self._outside_asked = False

    def declare(self, name: str, node: p.Node | None) -> None:
        """Make the image or plane `name`, of which `node` is the expression, known to the following
        expressions.

        With `node` None its expression is invalid, and later uses of the name report nothing."""
        if node is None:
            self.failed.add(name)
        elif isinstance(node, p.Condition):
            self.kinds[name] = "plane"
        else:
            self.kinds[name] = "image"
            counts = counts_of(node, self.counts, self.kernels)
            if counts is not None:
                self.counts[name] = counts

    def image(self, expr: tree.Expr) -> p.Value | None:
        """Return the image of the expression `expr`; None after reporting an error."""
        try:
            return self._image(expr)
        except WrongPicture:
            return None

    def condition(self, expr: tree.Expr) -> p.Condition | None:
        """Return the plane of the expression `expr`; None after reporting an error."""
        try:
            return self._condition(expr)
        except WrongPicture:
            return None

    # --- images

    def _image(self, expr: tree.Expr) -> p.Value:
        """Return an expression that must be an image, as a node of `nscc.words.pictures`.

        Raises WrongPicture after reporting an error, for example for a plane or an unknown name."""
        match expr:
            case tree.Name():
                text = expr.text
                if text == "exposure":
                    if len(self.buckets) == 1:
                        return p.Source(self.buckets[0])
                    raise self._report(
                        "NS0323",
                        "this program has several buckets",
                        expr.span,
                        "whose exposure?",
                        (f"name the bucket: `{self.buckets[0]}`",),
                    )
                kind = self.kinds.get(text)
                if kind == "image":
                    return p.Source(text)
                if kind == "plane":
                    raise self._report(
                        "NS0531",
                        f"`{text}` is a plane, but this must be an image",
                        expr.span,
                        "a plane",
                        (f"choose between two images with it: `A if {text} else B`",),
                    )
                if text in self.buckets and text not in self.kinds:
                    return p.Source(text)
                level = self.host.level_param(expr)
                if level is not None:
                    self._require_level(level[1], expr.span)
                    return p.Uniform(text)
                raise self._unknown("an image or a bucket", expr, "image")
            case tree.Unary(op="-", operand=operand):
                return picture_sum((Fraction(-1), self._image(operand)))
            case tree.Binary(op="+" | "-" as op, left=left, right=right):
                sign = Fraction(1 if op == "+" else -1)
                first, second = self._image(left), self._image(right)
                self._require_alike(first, second, expr.span)
                return picture_sum((Fraction(1), first), (sign, second))
            case tree.Binary(op="*" | "/", left=left, right=right):
                return self._scaled(expr, left, right)
            case tree.IfElse():
                condition = self._condition(expr.condition)
                first, second = self._image(expr.then), self._image(expr.otherwise)
                self._require_alike(first, second, expr.span)
                return self._chosen(condition, first, second)
            case tree.Call():
                return self._call(expr)
            case tree.Amount() | tree.Int() if self.declared.version > 3:
                return picture_sum((Fraction(self._steps(expr)), p.Uniform()))
            case tree.Place() if self.declared.version > 3:
                return cast(p.Value, self._shifted(expr, self._image(expr.base)))
        raise self._report(
            "NS0531",
            "this is not an image",
            expr.span,
            "no image",
            (
                "an image combines `exposure`, buckets and images with `+`, `-`, `* integer`, "
                "`/ power of two`, kernels, `abs(..)`, `max(EXPR, kernel)`, `agree(PLANE, kernel)` "
                "and `A if PLANE else B`",
            ),
        )

    def _chosen(self, condition: p.Condition, then: p.Value, otherwise: p.Value) -> p.Value:
        """Return `then` where the condition holds, else `otherwise`.

        From version 4 on, `a if a > b else b` becomes the larger of two images, which needs fewer
        words."""
        match condition:
            case p.Above(value=value, steps=0) if self.declared.version > 3:
                negative = picture_sum((Fraction(-1), then), (Fraction(1), otherwise))
                # Is the compared value then - otherwise (larger) or otherwise - then (smaller)?
                # Then this difference cancels.
                for sign, combine in ((1, p.Larger), (-1, _smaller)):
                    zero = picture_sum((Fraction(sign), value), (Fraction(1), negative))
                    if isinstance(zero, p.Sum) and not any(factor for factor, _ in zero.terms):
                        return combine(then, otherwise)
        return p.Chosen(condition, then, otherwise)

    def _require_alike(self, first: p.Value, second: p.Value, span: Span) -> None:
        """Report (NS0531) if one of the images `first` and `second` is a count and the other in
        electrons, and raise WrongPicture."""
        counts = [counts_of(value, self.counts, self.kernels) for value in (first, second)]
        if counts.count(None) == 1:
            raise self._report(
                "NS0531",
                "counts and electrons do not mix",
                span,
                "one of the two is a count, made by `agree`",
                ("compare each of them, and join the planes: `a > 6% and c > 3`",),
            )

    def _scaled(self, expr: tree.Binary, image: tree.Expr, factor: tree.Expr) -> p.Value:
        """Return the image of `expr`, which is `image * factor` or `image / factor`. The factor is
        an integer, the divisor a power of two; in a product, either side may be the image.

        Raises WrongPicture after reporting an error: other factors, or two images."""
        if expr.op == "*" and self._is_number(image):
            image, factor = factor, image
        if isinstance(factor, tree.Name) and factor.text in self.declared.params:
            raise self._unknown("an integer", factor, "image")
        if not self._is_number(factor):
            both = [self._image(side) for side in (image, factor) if not self._is_number(side)]
            raise self._report(
                "NS0531",
                "an image can be multiplied or divided only by an integer",
                expr.span,
                "two images" if len(both) > 1 else "divided by an image",
                ("a pixel can add, subtract and halve values, but not multiply two values",),
            )
        number = constant(factor, self.constants, self.problems, "a factor")
        if number is None:
            raise WrongPicture
        if expr.op == "*":
            return picture_sum((Fraction(number), self._image(image)))
        if not is_power_of_two(number):
            refuse_divisor(self.problems, number, factor.span)
            raise WrongPicture
        return picture_sum((Fraction(1, number), self._image(image)))

    def _is_kernel(self, expr: tree.Expr) -> bool:
        """Return whether an expression is the name of a convolution kernel."""
        return isinstance(expr, tree.Name) and expr.text in self.declared.kernels

    def _call(self, call: tree.Call) -> p.Value:
        """Return the image of a function call: a convolution kernel, `abs`, `max`, `min` or
        `agree`.

        Raises WrongPicture after reporting an error, for example for a function of planes or a
        wrong number of arguments."""
        name, arguments = call.function.text, call.arguments
        # `exposure` stands for the only bucket; with several buckets it would be ambiguous.
        is_pair = len(arguments) == 2 and not self._is_kernel(arguments[1])
        if name in ("min", "max") and is_pair and self.declared.version > 3:
            first, second = map(self._image, arguments)
            self._require_alike(first, second, call.span)
            if first == second:
                return first
            return p.Larger(first, second) if name == "max" else _smaller(first, second)
        if name in ("agree", "max"):
            kernel = self._kernel_of(call, "EXPR" if name == "max" else "PLANE")
            if name == "max":
                return p.Largest(self._image(arguments[0]), kernel)
            self._needs_outside(call.span)
            return p.Agreement(self._condition(arguments[0]), kernel)
        if name == "min":
            raise self._report(
                "NS0531",
                "there is no such `min` of images",
                call.span,
                "not a function of images",
                ("write `-max(-EXPR, kernel)`", "from `nsl 4` on, `min(A, B)` has two images"),
            )
        if name in ("any", "all"):
            raise self._report(
                "NS0531",
                f"`{name}(..)` is a plane, but this must be an image",
                call.span,
                "a plane",
                (f"declare `plane p = {name}(..)` and write `A if p else B`",),
            )
        if name != "abs" and name not in self.kernels:
            if name in self.declared.kernels:  # its error is reported at its declaration
                raise WrongPicture
            raise self._unknown("a kernel", call.function, "kernel")
        if len(arguments) != 1:
            raise self._report(
                "NS0531",
                f"`{name}` takes one image",
                call.span,
                f"{len(arguments)} arguments",
                (f"write `{name}(EXPR)`",),
            )
        value = self._image(arguments[0])
        return p.Absolute(value) if name == "abs" else p.Filtered(name, value)

    # --- planes

    def _condition(self, expr: tree.Expr) -> p.Condition:
        """Return an expression that must be a plane, as a node of `nscc.words.pictures`.

        In version 4, conditions on x and y alone become input planes. Raises WrongPicture after
        reporting an error, for example for an image."""
        # A condition on the pixel's own row and column is a plane that the host loads.
        if self.declared.version > 3:
            text = self.problems.source.text[expr.span.start : expr.span.end]
            plane = self.host.plane_of_places(expr, text)
            if plane is not None:
                return p.Bit(plane.name)
        match expr:
            case tree.IfElse() if self.declared.version > 3:
                parts = (expr.condition, expr.then, expr.otherwise)
                return p.ChosenPlane(*map(self._condition, parts))
            case tree.Bool():
                return p.Constant(expr.value)
            case tree.Name():
                return self._named_plane(expr)
            case tree.Unary(op="not"):
                return self._not(self._condition(expr.operand))
            case tree.Binary(op="and" | "or" | "xor" as op):
                inner = expr.left
                # Conditions over x and y that follow each other are one plane.
                if (
                    self.declared.version > 3
                    and isinstance(inner, tree.Binary)
                    and inner.op == op
                    and all(map(self.host.is_of_places, (inner.right, expr.right)))
                ):
                    span = Span(inner.right.span.start, expr.span.end)
                    places = tree.Binary(span, op, inner.right, expr.right)
                    return self._condition(tree.Binary(expr.span, op, inner.left, places))
                first, second = self._condition(inner), self._condition(expr.right)
                if op == "and":
                    return self._both(first, second)
                return self._joined(op, first, second)
            case tree.Compare() if self.reads_range(expr):
                conditions = self.conditions(expr)
                if not conditions:
                    raise WrongPicture
                return conditions[0]
            case tree.Compare():
                return self._compare(expr)
            case tree.Place():
                self._needs_outside(expr.span)
                if self.declared.version > 3:
                    return cast(p.Condition, self._shifted(expr, self._named_plane(expr.base)))
                x = constant(expr.right, self.constants, self.problems, "columns to the right")
                y = constant(expr.down, self.constants, self.problems, "rows down")
                if x is None or y is None:
                    raise WrongPicture
                return p.At(self._named_plane(expr.base), x, y)
            case tree.Call():
                kind = expr.function.text
                if kind == "flood" and self.declared.version > 3:
                    return self._flood(expr)
                if kind not in ("any", "all"):
                    image = kind in self.kernels or kind in _FUNCTIONS
                    if not image:
                        raise self._unknown("a function of planes", expr.function, "function")
                    raise self._report(
                        "NS0531",
                        f"`{kind}(..)` is an image, but this must be a plane",
                        expr.span,
                        "an image",
                        (f"compare it with a level: `{kind}(..) > 6%`",),
                    )
                kernel = self._kernel_of(expr, "PLANE")
                self._needs_outside(expr.span)
                return p.Near(cast(Any, kind), self._condition(expr.arguments[0]), kernel)
        raise self._report(
            "NS0531",
            "this is not a plane",
            expr.span,
            "no condition",
            (
                "a plane combines comparisons such as `image > 6%` and planes with `and`, `or`, "
                "`xor`, `not`, `any(PLANE, kernel)`, `all(PLANE, kernel)` and `PLANE[dx, dy]`",
            ),
        )

    def _joined(self, op: str, first: p.Condition, second: p.Condition) -> p.Condition:
        """Return `or` or `xor` of two planes. From version 4 on, a shift of both becomes one of the
        result, if that has the bit `outside` beyond the array, too."""
        is_kept = self.declared.version > 3 and (op == "or" or not self.outside)
        match first, second:
            case p.At(right=x, down=y), p.At(right=x_too, down=y_too) if is_kept:
                if (x, y) == (x_too, y_too):
                    joined = self._joined(op, first.condition, second.condition)
                    return p.At(joined, x, y)
        return p.Joined(cast(Any, op), first, second)

    def _named_plane(self, name: tree.Name) -> p.Condition:
        """Return the node that reads the plane `name`.

        Raises WrongPicture after reporting a name that is not a plane, or whose declaration failed.
        """
        kind = self.kinds.get(name.text)
        if kind == "plane":
            return p.Bit(name.text)
        if kind == "image" or name.text in (*self.buckets, "exposure"):
            raise self._report(
                "NS0531",
                f"`{name.text}` is an image, but this must be a plane",
                name.span,
                "an image",
                (f"compare it with a level: `{name.text} > 6%`",),
            )
        raise self._unknown("a plane", name, "plane")

    def _kernel_of(self, call: tree.Call, first: str) -> str:
        """Return the name of the convolution kernel that is the second argument of a call such as
        `any(PLANE, k)`.

        `first` is the form of the first argument for messages: "PLANE" or "EXPR". Raises
        WrongPicture after reporting another number of arguments (NS0531) or an unknown kernel
        (NS0214)."""
        name, arguments = call.function.text, call.arguments
        if len(arguments) != 2 or not isinstance(arguments[1], tree.Name):
            what = "a plane" if first == "PLANE" else "an image"
            raise self._report(
                "NS0531",
                f"`{name}` takes {what} and a kernel",
                call.span,
                "these arguments",
                (f"write `{name}({first}, KERNEL)`",),
            )
        kernel = arguments[1]
        if kernel.text not in self.kernels:
            if kernel.text in self.declared.kernels:  # its error is reported at its declaration
                raise WrongPicture
            raise self._unknown("a kernel", kernel, "kernel")
        return kernel.text

    def _needs_outside(self, span: Span) -> None:
        """Report that bits beyond the array are read but not defined (NS0534), once for each
        program."""
        if self.outside is not None or self._outside_asked:
            return
        self._outside_asked = True
        self.problems.error(
            "NS0534",
            "the bits of neighbours outside the array are not defined",
            span,
            "reads them in pixels at the border",
            helps=("define these bits: `outside 0` or `outside 1`",),
        )

    # --- both

    def _unknown(self, category: str, name: tree.Name, kind: str) -> WrongPicture:
        """Report a name that cannot be used here, and return the exception for the caller to raise.

        `category` is what was expected, as text for the message; `kind` ("image", "plane",
        "kernel", "function") chooses which names are suggested. Names whose declaration failed are
        not reported again; the exception is returned all the same."""
        text = name.text
        if text in ("x", "y") and self.declared.version > 3:
            return self._report(
                "NS0531",
                f"`{text}` is compared only with constants",
                name.span,
                "a position",
                (
                    "a plane of x and y is known before the exposure: for one that the host sets, "
                    "declare `input plane NAME`",
                ),
            )
        if text in self.failed or text in self.declared.refused:
            return WrongPicture()
        if text in self.declared.params:
            return self._report(
                "NS0531",
                f"the parameter `{text}` cannot be used here",
                name.span,
                f"{category} is required here",
                (
                    "a parameter is a level that images add or compare, a number of steps of "
                    "`repeat`, or an offset `IMAGE[dx, dy]`",
                ),
            )
        later = [picture for picture in self.declared.pictures if picture.name.text == text]
        if later:
            return self._report(
                "NS0531",
                f"`{text}` is used before its declaration",
                name.span,
                "not computed yet",
                ("images and planes are computed in the order of the program: move it up",),
            )
        if text in self.ranges:
            return self._report(
                "NS0531",
                f"`{text}` is a number of each pixel, but {category} is required here",
                name.span,
                "a state with a range",
                (f"compare it in a plane: `{text} > {self.ranges[text].low}`",),
            )
        known = {
            "kernel": [*self.kernels, *_FUNCTIONS[:3]],
            "function": ["any", "all"],
            "plane": [name for name, kind in self.kinds.items() if kind == "plane"],
        }.get(kind, ["exposure", *(n for n, k in self.kinds.items() if k == "image")])
        # With several buckets, their names take the place of `exposure`.
        if kind == "image" and len(self.buckets) > 1:
            known[:1] = self.buckets
        self.problems.unknown(category, text, name.span, known)
        return WrongPicture()


def _smaller(first: p.Value, second: p.Value) -> p.Value:
    """Return the smaller of two images: the larger of their negatives, inverted.
    `nscc.words.pictures` has only the larger."""
    negatives = (picture_sum((Fraction(-1), value)) for value in (first, second))
    return picture_sum((Fraction(-1), p.Larger(*negatives)))


def is_power_of_two(number: int) -> bool:
    """Return whether `number` is 1, 2, 4, ..: a pixel can divide only by these. 0 and negative
    numbers are not."""
    return number > 0 and number & (number - 1) == 0


def refuse_divisor(problems: Problems, divisor: int, span: Span) -> None:
    """Report a divisor that is not a power of two (NS0532).

    For a positive divisor, the help is the power of two that changes the values least, and by how
    much."""
    helps: tuple[str, ...] = ("divide by 1, 2, 4, 8, ..",)
    fixes: tuple[Fix, ...] = ()
    if divisor > 0:
        below = 1 << (divisor.bit_length() - 1)  # the next power of two; 2 * below is the one above
        # The closer one as a ratio.
        power = below if divisor / below <= 2 * below / divisor else 2 * below
        percent = 100 * abs(divisor / power - 1)
        change = "larger" if power < divisor else "smaller"
        text = f"with `/ {power}` values are {percent:.0f} % {change}: change the levels, too"
        helps = (text, *helps)
        fixes = (Fix(f"divide by {power}", span, str(power), sure=False),)
    problems.error(
        "NS0532",
        f"a pixel cannot divide by {divisor}",
        span,
        "not a power of two",
        notes=("a word can halve a value; there is no other division",),
        helps=helps,
        fixes=fixes,
    )
