"""The value of every field at every pixel: expressions over the array, tiles, files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, assert_never

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Label, Rejected
from nscc.diagnostics.rejection import rejected
from nscc.program.arithmetic import Value, array
from nscc.program.arrays_file import ArraysFile
from nscc.program.constants import constant
from nscc.program.evaluate import evaluate, fault_at
from nscc.program.expressions import LIMIT, Checked, Meaning, check
from nscc.program.limits import MOST_FIELDS, WORK_LIMIT, work
from nscc.program.names import Declarations
from nscc.program.problems import Problems, clipped, counted
from nscc.program.program import Field
from nscc.program.scopes import constants_scope, pixels_scope
from nscc.program.wide import PART_BITS, parts_of, parts_of_bits
from nscc.source import Span
from nscc.syntax.tree import Expr, Int, PixelsExpr, PixelsFromFile, PixelsTile

Plane = NDArray[np.int64]
"""The values of one field: int64 (rows, cols)."""


def make_planes(
    declared: Declarations,
    fields: Mapping[str, Field | None],
    constants: Mapping[str, Meaning],
    target: Target | None,
    base: Path,
    problems: Problems,
) -> dict[str, Plane]:
    """The plane of every field; fields with errors, here or before, are left out.

    Without any `pixels` statement, or without a target, there are none. Reports fields not given
    (NS0210), values outside their range (NS0311), faults of expressions, tiles that are no
    rectangle (NS0316), files (NS0313, NS0314, NS0315). A bit field that no number holds has a plane
    for each of its parts.
    """
    return _Maker(declared, fields, constants, target, base, problems).run()


@dataclass(eq=False, repr=False)
class _Maker:
    """What planes are made from."""

    declared: Declarations
    fields: Mapping[str, Field | None]
    constants: Mapping[str, Meaning]
    target: Target | None
    base: Path
    problems: Problems

    def __post_init__(self) -> None:
        self.scope = pixels_scope(self.declared, self.constants)
        self.tile_scope = constants_scope(self.declared, self.constants)

    def run(self) -> dict[str, Plane]:
        planes: dict[str, Plane] = {}
        if len(self.fields) > MOST_FIELDS:
            return planes
        for name, statement in self.declared.pixels.items():
            if name not in self.fields:
                self._no_field(statement)
            if isinstance(statement, PixelsExpr):
                plane = self._expression(statement)
            else:
                plane = self._tile(statement)
            field = self.fields.get(name)
            if plane is not None and field is not None:
                self._keep(planes, field, plane, statement)
        missing = [name for name in self.fields if name not in self.declared.pixels]
        if self.declared.pixels_file is not None:
            self._file(planes, missing)
        elif self.declared.pixels and missing:
            self._not_given(missing)
        return planes

    def _no_field(self, statement: PixelsExpr | PixelsTile) -> None:
        name = statement.field.text
        if name in self.declared.refused:
            return
        what = dict(self.declared.declared()).get(name)
        if what is None:
            self.problems.unknown("a field", name, statement.field.span, list(self.fields))
        else:
            message = f"`{name}` is {what}, not a field: `pixels` needs a field"
            helps = (f"declare it with `code {name} : LO..HI`",)
            self.problems.error("NS0209", message, statement.field.span, what, helps=helps)

    def _not_given(self, missing: list[str]) -> None:
        shown = ", ".join(f"`{name}`" for name in missing)
        first = self.declared.codes[missing[0]]
        given = next(iter(self.declared.pixels.values()))
        self.problems.error(
            "NS0210",
            f"the pixel values of {shown} are missing, but other fields have values",
            first.name.span,
            "has no `pixels` statement",
            related=(Label(given.field.span, "given here"),),
            helps=(
                f"add `pixels {missing[0]} = ...`",
                "a program without any `pixels` statement is also valid",
            ),
        )

    def _expression(self, statement: PixelsExpr) -> Plane | None:
        value = statement.value
        checked = check(value, "integer", self.scope, self.problems, "a pixel's value")
        if checked is None or self.target is None:
            return None
        rows, cols = self.target.rows, self.target.cols
        cost = work(checked, {"y": (0, rows), "x": (1, cols)})
        if cost > WORK_LIMIT:
            takes = f"this expression needs {cost} operations for the array of {rows} x {cols}"
            helps = ('store the data in a file: `pixels from "codes.npz"`',)
            message = f"{takes}; the limit is {WORK_LIMIT}"
            self.problems.error("NS0450", message, value.span, helps=helps)
            return None
        bindings = {
            "y": array(np.arange(rows, dtype=np.int64).reshape(rows, 1)),
            "x": array(np.arange(cols, dtype=np.int64).reshape(1, cols)),
        }
        found = evaluate(checked, bindings, {})
        if found.faults is not None:
            self._fault(checked, bindings, found, (rows, cols))
            return None
        return np.broadcast_to(np.asarray(found.data, dtype=np.int64), (rows, cols))

    def _fault(
        self, checked: Checked, bindings: dict[str, Value], found: Value, shape: tuple[int, int]
    ) -> None:
        places = np.ones(shape, dtype=bool)
        if isinstance(found.faults, np.ndarray):
            places = np.broadcast_to(found.faults, shape)
        y, x = first_place(places)
        fault = fault_at(checked, bindings, {}, shape, (y, x))
        count = int(places.sum())
        notes = (f"at {pixel_text(x, y)}, and at {counted(count, 'pixel')} in all",)
        self.problems.error(*fault, notes=notes, data={"x": x, "y": y, "pixels": count})

    def _tile(self, statement: PixelsTile) -> Plane | None:
        lines = statement.rows
        widths = {len(row.values) for row in lines}
        if len(widths) != 1 or 0 in widths:
            odd = next((row for row in lines if len(row.values) != len(lines[0].values)), None)
            place, text = statement.span, "an empty tile"
            if odd:
                have = counted(len(odd.values), "value")
                place, text = odd.span, f"{have}, the first row has {len(lines[0].values)}"
            message = (
                "all rows of a tile must have the same number of values, and at least one value"
            )
            self.problems.error("NS0316", message, place, text)
            return None
        values = [[self._tile_value(expr) for expr in row.values] for row in lines]
        if self.target is None or any(None in line for line in values):
            return None
        tile = np.array(values, dtype=np.int64)
        height, width = tile.shape
        rows, cols = self.target.rows, self.target.cols
        if height > rows or width > cols:
            self.problems.warning(
                "NS0357",
                f"this tile of {height} x {width} values is larger than the array of "
                f"{self.target.name}, {rows} x {cols}",
                statement.field.span,
                "the values beyond the array are not used",
            )
        y, x = np.arange(rows) % height, np.arange(cols) % width
        return np.asarray(tile[y[:, None], x[None, :]], dtype=np.int64)

    def _tile_value(self, expr: Expr) -> int | None:
        if isinstance(expr, Int) and expr.value < 2**31:
            return expr.value
        return constant(expr, self.tile_scope, self.problems, "a value of a tile")

    def _file(self, planes: dict[str, Plane], missing: list[str]) -> None:
        statement = self.declared.pixels_file
        assert statement is not None
        if not missing:
            message = f'"{clipped(statement.path.value)}" is not used'
            why = (
                "every field has its own `pixels` statement"
                if self.fields
                else "the program has no fields"
            )
            self.problems.warning("NS0356", message, statement.span, why)
            return
        try:
            file = ArraysFile(self.base / statement.path.value, statement.path.value)
            if statement.sha256 is not None:
                file.require_sha256(statement.sha256.value)
        except Rejected as wrong:
            self.problems.adopt(wrong, statement.path.span)
            return
        for name in missing:
            field = self.fields[name]
            if field is None or self.target is None:
                continue
            shape = self.target.rows, self.target.cols
            names = [part.name for part in parts_of(field)]
            try:
                found = stored_planes(file, name, shape, len(names), field.bits)
            except Rejected as wrong:
                self.problems.adopt(wrong, statement.path.span)
                continue
            (plane, beyond), *more = found
            # Only bits that the file gives one by one reach into the other parts.
            if any(part.any() for part, _ in more):
                planes.update(zip(names, (each for each, _ in found), strict=True))
            else:
                self._keep(planes, field, plane, statement, beyond)

    def _keep(
        self,
        planes: dict[str, Plane],
        field: Field,
        plane: Plane,
        statement: PixelsExpr | PixelsTile | PixelsFromFile,
        beyond: NDArray[np.bool_] | None = None,
    ) -> None:
        """Adds a plane whose values are in range; `beyond` are places that int64 cannot hold."""
        outside = (plane < field.low) | (plane > min(field.high, LIMIT))
        if beyond is not None:
            outside |= beyond
        if not outside.any():
            first, *others = (part.name for part in parts_of(field))
            planes[first] = plane
            planes.update((name, np.zeros_like(plane)) for name in others)
            return
        y, x = first_place(outside)
        count = int(outside.sum())
        value = "a number beyond 2^63" if beyond is not None and beyond[y, x] else plane[y, x]
        self.problems.error(
            "NS0311",
            f"the {pixel_text(x, y)} has {field.name} = {value}, outside {_range(field)}",
            _value_span(statement, x, y),
            f"{counted(count, 'pixel is', 'pixels are')} outside the range",
            related=(Label(field.span, f"`{field.name}` is {_range(field)}"),),
            helps=_as_bits(field, self.target),
            data={"field": field.name, "x": x, "y": y, "pixels": count},
        )


def _range(field: Field) -> str:
    """The values of a field; a number has at most 62 bits."""
    return f"{field.low}..{min(field.high, LIMIT)}"


def _as_bits(field: Field, target: Target | None) -> tuple[str, ...]:
    """How to give the pixels of a bit field that no number holds."""
    if field.high <= LIMIT or target is None:
        return ()
    shape = f"({target.rows}, {target.cols}, {field.bits})"
    return (f"give its bits in a file: an array {field.name} of 0 and 1 {shape}, bit 0 first",)


def _value_span(statement: PixelsExpr | PixelsTile | PixelsFromFile, x: int, y: int) -> Span:
    """Where the value of pixel (x, y) comes from."""
    match statement:
        case PixelsExpr():
            return statement.value.span
        case PixelsTile():
            row = statement.rows[y % len(statement.rows)].values
            return row[x % len(row)].span
        case PixelsFromFile():
            return statement.path.span
    assert_never(statement)


Stored = tuple[Plane, NDArray[np.bool_]]
"""A plane, and where what was given is beyond int64."""


def stored_planes(
    file: ArraysFile, name: str, shape: tuple[int, int], parts: int = 1, bits: int | None = None
) -> list[Stored]:
    """The planes of the field `name` in a file, as `planes_of` makes them; NS0313, NS0314."""
    most = shape[0] * shape[1] * (bits or parts * PART_BITS)
    stored = file.integers(name, most=max(most, 2**20), bools=True)
    return planes_of(stored, name, shape, parts, bits, f' of "{file.shown}"')


def planes_of(
    stored: NDArray[Any],
    name: str,
    shape: tuple[int, int],
    parts: int,
    bits: int | None = None,
    where: str = "",
) -> list[Stored]:
    """The planes of a field that is kept as so many parts, of the array that gives it.

    It holds integers (rows, cols), or the single bits (rows, cols, K) of a bit field, bit 0 first:
    as many as the field has where `bits` says, else as many as its parts can hold. NS0314 for
    anything else.
    """
    if stored.ndim == 3 and (parts > 1 or bits is not None):
        return [(plane, np.zeros(shape, np.bool_)) for plane in
                parts_of_bits(_single_bits(stored, name, shape, parts, bits, where))]  # fmt: skip
    if stored.dtype.kind not in "iu" or stored.shape != shape:
        found = f"the array `{clipped(name)}`{where} is {stored.shape} of {stored.dtype}"
        message = f"{found}, but must contain integers {shape}: [row, column]"
        helps = (f"the array of pixels is {shape[0]} rows x {shape[1]} columns",)
        raise rejected("NS0314", message, helps=helps)
    plane = as_plane(stored)
    nothing = np.zeros(shape, np.int64), np.zeros(shape, np.bool_)
    return [plane, *[nothing] * (parts - 1)]


def _single_bits(
    stored: NDArray[Any], name: str, shape: tuple[int, int], parts: int, bits: int | None,
    where: str,
) -> NDArray[Any]:  # fmt: skip
    count = stored.shape[2]
    least = bits or (parts - 1) * PART_BITS + 1
    most = bits or parts * PART_BITS
    if stored.shape[:2] != shape or not least <= count <= most:
        wanted = f"({shape[0]}, {shape[1]}, {bits if bits else f'{least} to {most}'})"
        message = (
            f"the array `{clipped(name)}`{where} has shape {stored.shape}, but bits need {wanted}"
        )
        helps = ("the last axis is the bit, bit 0 first",)
        raise rejected("NS0314", message, helps=helps)
    if not np.isin(stored, (0, 1)).all():
        message = f"the array `{clipped(name)}`{where} has values other than 0 and 1"
        raise rejected(
            "NS0314", message, helps=("with three axes, an array must contain single bits",)
        )
    return stored


def as_plane(stored: NDArray[Any]) -> tuple[Plane, NDArray[np.bool_]]:
    """Integers as int64, and where they are beyond it."""
    beyond = np.zeros(stored.shape, dtype=bool)
    if stored.dtype.kind == "u" and stored.dtype.itemsize == 8:
        beyond = np.asarray(stored > np.uint64(2**63 - 1), dtype=bool)
    with np.errstate(all="ignore"):
        return stored.astype(np.int64), beyond


def first_place(places: NDArray[np.bool_]) -> tuple[int, int]:
    """(y, x) of the first place, row by row."""
    y, x = np.unravel_index(int(places.argmax()), places.shape)
    return int(y), int(x)


def pixel_text(x: int, y: int) -> str:
    """A pixel's place for messages, in both ways of naming it."""
    return f"pixel at x = {x}, y = {y} (row {y}, column {x})"
