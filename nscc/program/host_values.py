"""Checked statements of version 4 for values that the host sets: parameters and input planes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from nscc.chips.target import Target
from nscc.program.constants import constant
from nscc.program.expressions import Meaning, in_evaluation_order, names_in
from nscc.program.field_planes import PlaneMaker
from nscc.program.names import Declarations
from nscc.program.problems import Problems
from nscc.syntax import tree
from nscc.truth import packed_bits
from nscc.words.picture_launches import HostParam, Times
from nscc.words.pictures import InputPlane

_OF_A_PLACE = frozenset({"x", "y"})


def signed_level(expr: tree.Expr) -> tuple[int, tree.Expr]:
    """Return the sign (1 or -1) before a level, and the expression without its minus signs. Two
    minus signs cancel."""
    sign = 1
    while isinstance(expr, tree.Unary) and expr.op == "-":
        sign, expr = -sign, expr.operand
    return sign, expr


class HostValues:
    """The values that the host sets: parameters and input planes of a file.

    `params` has the parameters by name. `inputs` has the input planes by name, and also the
    conditions over x and y inside other expressions, whose name is their text."""

    def __init__(
        self,
        declared: Declarations,
        constants: Mapping[str, Meaning],
        target: Target,
        planes: PlaneMaker,
        problems: Problems,
    ) -> None:
        """Check the declared parameters and input planes, and report errors (NS0545).

        `constants` has the meanings of N, rows, cols and `let` names. `planes` computes the initial
        bits of input planes, which are 0 without a `pixels` statement."""
        self.declared, self.constants, self.target = declared, constants, target
        self.planes, self.problems = planes, problems
        self.params: dict[str, HostParam] = {}
        self.inputs: dict[str, InputPlane] = {}
        for name, statement in declared.params.items():
            self.params[name] = self._param(name, statement)
        for name in declared.inputs:
            start = declared.input_starts.get(name)
            bits = None
            if isinstance(start, tree.PixelsExpr):
                bits = planes.bits(start.value)
            elif start is not None:
                problems.error(
                    "NS0545",
                    f"the start of `{name}` is not a condition",
                    start.span,
                    "a tile",
                    helps=(f"write `pixels {name} = CONDITION` over x and y",),
                )
            self.inputs[name] = InputPlane(
                name, 0 if bits is None else packed_bits(bits), is_open=True
            )

    def _param(self, name: str, statement: tree.Param) -> HostParam:
        """Return the checked parameter `name`; after reporting an error (NS0545), one that is 0.

        `name` is the name that `statement` declares. Range and start must all be levels or all
        integers, and IN (the level sent to all pixels) must reach all levels."""
        parts = (statement.low, statement.high, statement.start)
        are_levels = [isinstance(signed_level(part)[1], tree.Amount) for part in parts]
        # After an error, the parameter still serves, so that its uses give no further errors.
        kind: Literal["level", "integer"] = "level" if any(are_levels) else "integer"
        failed = HostParam(name, kind, 0, 0, 0)
        text = ""  # what is wrong, for the message
        if len({*are_levels}) > 1:
            text = "its range and its start have different units"
        numbers = [self._steps(part) if any(are_levels) else self._integer(part) for part in parts]
        if not text and None in numbers:
            return failed
        if not text:
            # None of the numbers is None here; `or 0` only tells the type checker so.
            low, high, start = (number or 0 for number in numbers)
            if not low <= start <= high:
                ends = (self.problems.source.text[e.span.start : e.span.end] for e in parts)
                text = "its start {2} is outside {0} .. {1}".format(*ends)
            if not text and kind == "level" and max(-low, high) > self.most_steps:
                least_e = self.target.electrons_per_step
                text = f"IN has steps of {least_e:.4g} e, up to {self.most_steps} of them"
            if not text:
                return HostParam(name, kind, low, high, start)
        self.problems.error(
            "NS0545",
            f"`{name}` is not a valid parameter: {text}",
            statement.span,
            "this range",
            helps=(
                "write all levels, `param t : 1% .. 20% = 4%`, or all integers, "
                "`param steps : 0 .. 64 = 8`",
            ),
        )
        return failed

    @property
    def most_steps(self) -> int:
        """The most steps of IN (the level sent to all pixels) that are possible as positive and as
        negative values, because levels may be added or subtracted."""
        return min(self.target.in_high, -self.target.in_low)

    def _integer(self, expr: tree.Expr) -> int | None:
        """Return the value of a constant integer expression; None after reporting an error."""
        return constant(expr, self.constants, self.problems, "the range of a parameter")

    def _steps(self, expr: tree.Expr) -> int | None:
        """Return a level in steps of IN (the level sent to all pixels), rounded, or the value of
        `expr` itself if it is an integer without a unit; None after reporting an error."""
        sign, level = signed_level(expr)
        if not isinstance(level, tree.Amount):
            return self._integer(expr)
        electrons = sign * self.target.level_e(float(level.value), level.unit)
        return round(electrons / self.target.electrons_per_step)

    def level_param(self, expr: tree.Expr) -> tuple[int, HostParam] | None:
        """Return the sign (1 or -1) and the parameter of a level such as `-t`; None for other
        expressions, and for a parameter with an error."""
        sign, level = signed_level(expr)
        param = self.params.get(level.text) if isinstance(level, tree.Name) else None
        return None if param is None else (sign, param)

    def number(self, expr: tree.Expr, role: str) -> Times | None:
        """Return the value of `expr`: a constant, or an integer parameter plus or minus a constant;
        None after reporting an error.

        `role` names the expression in messages. The result's `offset` may be negative; its `most`
        is the largest number that the parameter's range allows, at least 0."""
        params_read = [name for name in names_in(expr) if name.text in self.declared.params]
        if not params_read:
            value = constant(expr, self.constants, self.problems, role)
            return None if value is None else Times(value, max(0, value))
        name = params_read[0].text
        param = self.params[name]
        # The expression is sign * parameter + offset; both are found by taking it apart.
        sign, offset = 1, 0
        inner: tree.Expr = expr
        is_alone = len(params_read) == 1
        if is_alone and isinstance(inner, tree.Binary) and inner.op in ("+", "-"):
            param_first = any(name_read.text == name for name_read in names_in(inner.left))
            constant_side = inner.right if param_first else inner.left
            value = constant(constant_side, self.constants, self.problems, role)
            if value is None:
                return None
            offset = -value if param_first and inner.op == "-" else value
            sign = 1 if param_first or inner.op == "+" else -1  # of the parameter
            inner = inner.left if param_first else inner.right
        inner_sign, inner = signed_level(inner)
        sign *= inner_sign
        if not isinstance(inner, tree.Name) or param.kind == "level":
            what = "a level" if param.kind == "level" else "not only a sum"
            self.problems.error(
                "NS0545",
                f"{role} must be one integer parameter plus or minus an integer",
                expr.span,
                what,
                helps=("declare `param steps : 0 .. 64 = 8`, and write `steps` or `steps + 1`",),
            )
            return None
        most = offset + max(sign * param.low, sign * param.high)
        return Times(offset, max(0, most), param=name, factor=sign)

    def is_of_places(self, expr: tree.Expr) -> bool:
        """Return whether a condition depends on x and y, and on nothing else but constants."""
        known = {*_OF_A_PLACE, "rows", "cols", "N", "min", "max", *self.declared.lets}
        names = {name.text for name in names_in(expr)}
        if not names & _OF_A_PLACE or names - known:
            return False
        kinds = (tree.Place, tree.Amount)
        return not any(isinstance(node, kinds) for node in in_evaluation_order(expr))

    def plane_of_places(self, expr: tree.Expr, text: str) -> InputPlane | None:
        """Return the input plane of a condition over x and y; None for any other condition.

        `text` is its source text, which becomes the plane's name. The plane is added to `inputs`,
        once for each text. If the condition has an error, it is reported, and the plane's bits are
        0."""
        if not self.is_of_places(expr):
            return None
        name = " ".join(text.split())
        if name not in self.inputs:
            bits = self.planes.bits(expr)
            self.inputs[name] = InputPlane(
                name, 0 if bits is None else packed_bits(bits), is_open=False
            )
        return self.inputs[name]
