"""Repeated images and planes, shifts of any distance, and floods of version 4."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import replace
from typing import Any, Literal, cast

from nscc.operations import STEERING
from nscc.program.constants import constant
from nscc.program.host_values import HostValues
from nscc.program.picture_comparisons import PictureComparer, WrongPicture
from nscc.source import Span
from nscc.syntax import tree
from nscc.words import pictures as p
from nscc.words.picture_launches import Times

Kind = Literal["image", "plane", "bucket"]
MOST_STEPS = 1 << 16
_FAR = 8
"""A plane that is shifted further is shifted in a loop; an image, beyond half of that."""


class LoopReader(PictureComparer):
    """Converts what takes several steps - `repeat`, far shifts, floods - to repeated images and
    planes.

    `kinds` has the kinds of the names declared so far; a state is a plane. `failed` are names whose
    expressions are invalid. `items` are the images and planes so far, with those that far shifts
    and floods add. `floods` are the reports of whether floods were complete. `now` is the name that
    is being declared."""

    outside: int | None

    def __init__(self, host: HostValues, kernels: dict[str, p.Weights]) -> None:
        """Begin without images and planes; `host` knows the parameters that the host sets, and
        `kernels` are the valid convolution kernels by name."""
        super().__init__(host, kernels)
        self.kinds: dict[str, Kind] = {}
        self.failed: set[str] = set()
        self.items: list[p.Picture] = []
        self.floods: list[p.PlaneReport] = []
        self.now = ""
        self._in_step = False

    @abstractmethod
    def declare(self, name: str, node: p.Node | None) -> None:
        """Make an image or plane known to the following expressions; None if its expression is
        invalid."""

    @abstractmethod
    def image(self, expr: tree.Expr) -> p.Value | None:
        """Return the image of an expression; None after reporting an error."""

    @abstractmethod
    def condition(self, expr: tree.Expr) -> p.Condition | None:
        """Return the plane of an expression; None after reporting an error."""

    @abstractmethod
    def _condition(self, expr: tree.Expr) -> p.Condition: ...

    @abstractmethod
    def _kernel_of(self, call: tree.Call, first: str) -> str: ...

    @abstractmethod
    def _needs_outside(self, span: Span) -> None: ...

    def declare_places(self, name: str, condition: tree.Expr) -> bool:
        """Declare the plane `name` if its `condition` depends on x and y only; it becomes an input
        plane. Return whether it is one.

        Return False, and declare nothing, for any other condition and before version 4."""
        if self.declared.version < 4:
            return False
        plane = self.host.plane_of_places(condition, name)
        if plane is not None:
            self.kinds[name] = "plane"
        return plane is not None

    def repeat(self, statement: tree.Repeat, name: str) -> None:
        """Declare all names of a `repeat` statement when its first name is reached; do nothing for
        later names.

        Their initial values, their steps and the number of steps are checked, and errors reported.
        A name with an error counts as failed, so that its uses report nothing."""
        names = [item.name.text for item in statement.items]
        if name != names[0]:
            return
        times = self.host.number(statement.count, "the number of steps")
        is_negative = times is not None and times.param == "" and times.offset < 0
        if times is not None and (is_negative or times.most > MOST_STEPS):
            self.problems.error(
                "NS0531",
                # `most` of a negative number is 0.
                f"a number of steps cannot be {times.most or times.offset}",
                statement.count.span,
                "negative" if is_negative else "too large",
                helps=(f"repeat 0 to {MOST_STEPS} times",),
            )
            times = None
        starts = [self._node(item.kind, item.start) for item in statement.items]
        # Steps read all names of the statement, so the names are declared before any step is read.
        for item, start in zip(statement.items, starts, strict=True):
            self.declare(item.name.text, start)
            if item.name.text in self.counts:
                self._report(
                    "NS0539",
                    "counts cannot be repeated yet",
                    item.start.span,
                    "a count",
                    ("compare the count, and repeat the plane",),
                )
        self._in_step = True
        steps = [self._node(item.kind, item.step) for item in statement.items]
        self._in_step = False
        for item, start, step in zip(statement.items, starts, steps, strict=True):
            if times is None or start is None or step is None:
                # One invalid name makes the statement invalid; its names are not reported again.
                self.kinds.pop(item.name.text, None)
                self.failed.add(item.name.text)
                continue
            make: Any = p.RepeatedImage if item.kind == "image" else p.RepeatedPlane
            self.items.append(p.Picture(item.name.text, make(start, step, times, names[0])))

    def _node(self, kind: str, expr: tree.Expr) -> p.Node | None:
        """Return an expression as an image or a plane, as `kind` says; None after reporting an
        error."""
        return self.image(expr) if kind == "image" else self.condition(expr)

    def _shifted(self, expr: tree.Place, base: p.Node) -> p.Node:
        """Return `base`, an image or plane, shifted by the offset `[dx, dy]` of `expr`: columns to
        the right, rows down; far shifts become loops.

        Raises WrongPicture after reporting NS0541 for a shift beyond the array, NS0539 for a
        parameter inside `repeat`, or an invalid offset."""
        for size, axis, what in (
            (self.target.cols, expr.right, "columns to the right"),
            (self.target.rows, expr.down, "rows down"),
        ):
            distance = self.host.number(axis, what)
            if distance is None:
                raise WrongPicture
            if distance.param and self._in_step:
                raise self._report(
                    "NS0539",
                    "a shift by a parameter is not supported inside `repeat` yet",
                    axis.span,
                    "set by the host",
                    ("shift by a constant, or shift before the `repeat`",),
                )
            name = f"{self._text_of(expr)} {what}"
            base = self._along(base, distance, (1, 0) if axis is expr.right else (0, 1), name)
            # `most` of a constant is 0 to the left or up; there the offset is negative.
            far = max(abs(distance.offset), distance.most) if not distance.param else distance.most
            if far >= size:
                raise self._report(
                    "NS0541",
                    f"`{expr.base.text}` is shifted by {far}, but the array of "
                    f"{self.target.name} has {size} {what.split()[0]}",
                    axis.span,
                    "too far",
                    (f"shift by at most {size - 1}",),
                )
        return base

    def _along(self, base: p.Node, distance: Times, step: tuple[int, int], name: str) -> p.Node:
        """Return `base`, an image or plane, shifted along one axis by `distance`: a constant, or a
        parameter of the host plus a constant.

        `step` is the axis: (1, 0) for columns to the right, (0, 1) for rows down. `name` names the
        loop that a far or variable shift needs."""
        if distance.param:
            # A parameter may be negative: one loop for each direction, of which one has no steps.
            for sign in (1, -1):
                part = Times(
                    sign * distance.offset,
                    most=0,  # set below, from the range of the parameter
                    param=distance.param,
                    factor=sign * distance.factor,
                )
                param = self.host.params[distance.param]
                part = replace(
                    part, most=max(part.at({param.name: end}) for end in (param.low, param.high))
                )
                if part.most:
                    base = self._loop(
                        name=f"{name} {sign:+}",
                        base=base,
                        start=base,
                        times=part,
                        step=step,
                        pixels=sign,
                    )
            return base
        sign, pixels = (1 if distance.offset > 0 else -1), abs(distance.offset)
        # The longest shift without a loop.
        direct = _FAR if isinstance(base, p.Condition) else _FAR // 2
        if pixels > direct and not self._in_step:
            # Each step moves 2 pixels. The start already does, and an odd pixel is left for the
            # end.
            start = _one_shift(base, step, 2 * sign)
            times = Times(pixels // 2 - 1, pixels // 2 - 1)
            base, pixels = self._loop(name, base, start, times, step, pixels=2 * sign), pixels % 2
        shifted: p.Node = _one_shift(base, step, pixels * sign)
        return shifted

    def _loop(
        self,
        name: str,
        base: p.Node,
        start: p.Node,
        times: Times,
        step: tuple[int, int],
        pixels: int,
    ) -> p.Node:
        """Declare the loop of a far shift under `name`, unless it exists, and return its result.

        Each of the `times` steps shifts by `pixels` along `step`, beginning with `start`. `base`
        tells whether it is an image or a plane. A step is (1, 0) to the right or (0, 1) down; a
        negative `pixels` reverses it. It must not be called for a step of `repeat`."""
        own: Any = p.Bit(name) if isinstance(base, p.Condition) else p.Source(name)
        make: Any = p.RepeatedPlane if isinstance(base, p.Condition) else p.RepeatedImage
        if all(item.name != name for item in self.items):
            moved = _one_shift(own, step, pixels)
            self.items.append(p.Picture(name, make(start, moved, times, name)))
        return cast(p.Node, own)

    def _text_of(self, node: tree.Node) -> str:
        """Return the source text of a node in one line, with single blanks."""
        return " ".join(self.problems.source.text[node.span.start : node.span.end].split())

    def _flood(self, call: tree.Call) -> p.Condition:
        """Return the plane of those parts of a mask that are connected with a seed: `flood(SEED,
        MASK, KERNEL)`.

        SEED and MASK are planes. Without `at most K` there are rows + columns steps. Also declare a
        plane that tells whether it still grows after the last step, which is reported. Raises
        WrongPicture after reporting wrong arguments (NS0531) or a second flood (NS0539)."""
        name = self.now
        if len(call.arguments) != 3 or not isinstance(call.arguments[2], tree.Name):
            raise self._report(
                "NS0531",
                "`flood` takes a seed, a mask and a kernel",
                call.span,
                "these arguments",
                ("write `flood(SEED, MASK, KERNEL)`, or `flood(SEED, MASK, KERNEL, at most 100)`",),
            )
        if self._in_step or any(report.plane == name + p.GROWS for report in self.floods):
            raise self._report(
                "NS0539",
                "a plane has one flood, which is not inside `repeat`",
                call.span,
                "not supported yet",
                ("declare a plane for each flood",),
            )
        kernel = self._kernel_of(replace(call, arguments=call.arguments[1:]), "PLANE")
        self._needs_outside(call.span)
        seed, mask = self._condition(call.arguments[0]), self._condition(call.arguments[1])
        steps: int | None = self.target.rows + self.target.cols
        if call.most is not None:
            steps = constant(call.most, self.constants, self.problems, "the number of steps")
        if steps is None or steps < 1 or not self.kernels[kernel].taps.keys() - {(0, 0)}:
            raise self._report(
                "NS0531",
                "a flood has at least one step, and a kernel with neighbours",
                call.span,
                "no step to a neighbour",
                ("use a kernel such as the cross of neighbours",),
            )
        around = self._around(kernel)
        area, flooded = p.Bit(f"{name} bounds"), p.Bit(f"{name} flooded")
        near = p.Near("any", flooded, around)
        times, grows = Times(steps, steps), f"{name}{p.GROWS}"
        # `area` is 1 outside of mask and seed. A step adds neighbours, except there.
        is_inside = self._is_within(seed, mask)
        step: p.Condition = p.Neither(p.Neither(flooded, near), area)
        pixels = self.target.propagation_pixels
        is_cross = self.kernels[around].taps.keys() == {*STEERING.values()}
        # The chip's own propagation reaches the four neighbours and nothing beyond the array, many
        # pixels a word.
        if pixels and is_cross and self.outside == 0:
            step = p.Propagated(flooded, p.Inverse(area), pixels)
            times = Times(-(-steps // pixels), -(-steps // pixels))  # rounded up
        self.items += [
            p.Picture(area.name, p.inverse_of(mask) if is_inside else p.Neither(mask, seed)),
            p.Picture(flooded.name, p.RepeatedPlane(seed, step, times, flooded.name)),
            p.Picture(grows, p.Neither(p.Inverse(near), p.Joined("or", area, flooded))),
        ]
        self.floods.append(p.PlaneReport("flood", grows))
        return flooded

    def _is_within(self, part: p.Condition, whole: p.Condition) -> bool:
        """Return whether the text of a condition says that it is 1 only where `whole` is 1."""
        if part == whole:
            return True
        if isinstance(part, p.Neither):
            operands = map(p.inverse_of, (part.first, part.second))
            return any(self._is_within(operand, whole) for operand in operands)
        named = next((item.node for item in self.items if p.Bit(item.name) == part), part)
        is_named = named != part and isinstance(named, p.Condition)
        return is_named and self._is_within(cast(p.Condition, named), whole)

    def _around(self, kernel: str) -> str:
        """Return the name of a convolution kernel that equals `kernel`, but has at its centre the
        weight that needs fewer words: 1 if it then has the places of a rectangle, 0 otherwise.

        If the centre has another weight, that is a new kernel, which is declared here. A flood does
        not depend on the centre, because the flooded pixels stay flooded."""
        weights, name = self.kernels[kernel], f"{kernel} around"
        places = {(0, 0), *weights.taps}
        sides = [len({*along}) for along in zip(*places, strict=True)]
        fills = min(sides) > 1 and len(places) == sides[0] * sides[1]
        if ((0, 0) in weights.taps) == fills:
            return kernel
        rows = [list(row) for row in weights.rows]
        rows[len(rows) // 2][len(rows[0]) // 2] = int(fills)
        self.kernels[name] = p.Weights(name, tuple(map(tuple, rows)), weights.divisor)
        return name


def _one_shift(base: p.Node, step: tuple[int, int], pixels: int) -> Any:
    """Return `base`, an image or plane, shifted by `pixels` times `step` (columns, rows); itself
    for 0 pixels. A negative number shifts in the other direction."""
    if not pixels:
        return base
    make: Any = p.At if isinstance(base, p.Condition) else p.Shifted
    return make(base, step[0] * pixels, step[1] * pixels)
