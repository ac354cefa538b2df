"""The value of every field at every pixel, from expressions, tiles or files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import assert_never

import numpy as np

from nscc.arrays import Array, Bools, Ints
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Label, Rejected, rejected
from nscc.program.arrays_file import ArraysFile
from nscc.program.constants import constant, constants_scope, pixels_scope
from nscc.program.evaluate import Value, values_of
from nscc.program.expressions import LIMIT, Meaning, Type, check
from nscc.program.limits import MOST_FIELDS, WORK_LIMIT, work
from nscc.program.names import Declarations
from nscc.program.problems import Problems, clipped, counted
from nscc.program.program import CHUNK_BITS, Field, chunks_of, chunks_of_bits
from nscc.source import Span
from nscc.syntax.tree import Expr, Int, PixelsExpr, PixelsFromFile, PixelsTile

Plane = Ints
"""The values of one field at all pixels: int64 (rows, cols)."""


@dataclass(eq=False, repr=False)
class PlaneMaker:
    """Computes the values of all fields at all pixels (their planes), or reports why that is
    impossible.

    `fields` has the fields by name, None for those with errors. `constants` has the meanings of N,
    rows, cols and `let` names. `base` is the folder of the files that the program names. `target`
    is None if it could not be loaded."""

    declared: Declarations
    fields: Mapping[str, Field | None]
    constants: Mapping[str, Meaning]
    target: Target | None
    base: Path
    problems: Problems

    def make(self) -> dict[str, Plane]:
        """Return the plane of every field by name: its values at all pixels, int64 (rows, cols).

        Fields with errors are left out. The result is empty without `pixels` statements or without
        a target, and beyond `MOST_FIELDS` fields, which `gather` reports. Reports fields without
        pixels (NS0210), values outside their range (NS0311), faults of expressions, tiles that are
        not rectangular (NS0316) and errors of files (NS0313, NS0314, NS0315). A long bit field has
        a plane for each of its chunks."""
        planes: dict[str, Plane] = {}
        if len(self.fields) > MOST_FIELDS:
            return planes
        for name, statement in self.declared.pixels.items():
            if name not in self.fields:
                helps = (f"declare it with `code {name} : LO..HI`",)
                self.declared.report_other(
                    statement.field,
                    "a field",
                    ": `pixels` needs a field",
                    self.fields,
                    helps,
                    self.problems,
                )
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
            shown = ", ".join(f"`{name}`" for name in missing)
            first = self.declared.codes[missing[0]]
            given_statement = next(iter(self.declared.pixels.values()))
            self.problems.error(
                "NS0210",
                f"the pixel values of {shown} are missing, but other fields have values",
                first.name.span,
                "has no `pixels` statement",
                related=(Label(given_statement.field.span, "given here"),),
                helps=(
                    f"add `pixels {missing[0]} = ...`",
                    "a program without any `pixels` statement is also valid",
                ),
            )
        return planes

    def bits(self, condition: Expr) -> Bools | None:
        """Return a condition over x (column) and y (row) at every pixel, bool (rows, cols). Return
        None after reporting an error, or without a target."""
        return self._values(condition, "boolean", "a plane of x and y")

    def _expression(self, statement: PixelsExpr) -> Plane | None:
        """Return the values of an integer expression at all pixels, int64 (rows, cols); None after
        an error."""
        return self._values(statement.value, "integer", "a pixel's value")

    def _values(self, value: Expr, kind: Type, role: str) -> Array | None:
        """Return the value of an expression over x and y in every pixel, shape (rows, cols).

        `kind` is its type and `role` its name in messages. Return None without a target, or after
        reporting an error: a wrong type, a pixel without a value, or more than `WORK_LIMIT`
        operations."""
        scope = pixels_scope(self.declared, self.constants)
        checked = check(value, kind, scope, self.problems, role)
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
            "y": Value(np.arange(rows, dtype=np.int64).reshape(rows, 1)),
            "x": Value(np.arange(cols, dtype=np.int64).reshape(1, cols)),
        }
        values, gap = values_of(checked, bindings, books={}, shape=(rows, cols))
        if gap is not None:
            y, x = gap.first_index
            notes = (f"at {pixel_text(x, y)}, and at {counted(gap.number, 'pixel')} in all",)
            data = {"x": x, "y": y, "pixels": gap.number}
            gap.fault.report(self.problems, notes=notes, data=data)
            return None
        return values

    def _tile(self, statement: PixelsTile) -> Plane | None:
        """Return the values of a tile repeated over the array from its top left corner, int64
        (rows, cols).

        The top left corner is row 0, column 0. Return None without a target, or after reporting an
        error, such as rows of different lengths (NS0316). A tile larger than the array causes a
        warning (NS0357); its further values are not used."""
        lines = statement.rows
        widths = {len(row.values) for row in lines}
        if len(widths) != 1 or 0 in widths:
            odd = next((row for row in lines if len(row.values) != len(lines[0].values)), None)
            span, text = statement.span, "an empty tile"
            if odd:
                have = counted(len(odd.values), "value")
                span, text = odd.span, f"{have}, the first row has {len(lines[0].values)}"
            message = (
                "all rows of a tile must have the same number of values, and at least one value"
            )
            self.problems.error("NS0316", message, span, text)
            return None
        scope = constants_scope(self.declared, self.constants)
        values = [
            [
                # Large tiles are common; a plain number needs no scope, and a small one no check.
                expr.value
                if isinstance(expr, Int) and expr.value < 2**31
                else constant(expr, scope, self.problems, "a value of a tile")
                for expr in row.values
            ]
            for row in lines
        ]
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
        tile_row, tile_col = np.arange(rows) % height, np.arange(cols) % width
        return np.asarray(tile[tile_row[:, None], tile_col[None, :]], dtype=np.int64)

    def _file(self, planes: dict[str, Plane], missing: list[str]) -> None:
        """Read the values of the `missing` fields from the program's file, and add them to
        `planes`.

        A field whose array has an error is left out. Errors are reported at the statement. A file
        that no field needs causes a warning (NS0356) and is not read."""
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
            names = [chunk.name for chunk in chunks_of(field)]
            try:
                stored = stored_planes(file, name, shape, len(names), field.bits)
            except Rejected as wrong:
                self.problems.adopt(wrong, statement.path.span)
                continue
            (plane, beyond), *higher_chunks = stored
            # Only single bits from a file can set the other chunks.
            if any(chunk.any() for chunk, _ in higher_chunks):
                planes.update(zip(names, (chunk_plane for chunk_plane, _ in stored), strict=True))
            else:
                self._keep(planes, field, plane, statement, beyond)

    def _keep(
        self,
        planes: dict[str, Plane],
        field: Field,
        plane: Plane,
        statement: PixelsExpr | PixelsTile | PixelsFromFile,
        beyond: Bools | None = None,
    ) -> None:
        """Add the plane of a field to `planes` if all its values are in range; else report NS0311.

        Chunks of a long bit field above the first become 0. `statement` gave the values, for the
        place of the error. `beyond` marks pixels whose values do not fit int64; None if all do."""
        outside = (plane < field.low) | (plane > min(field.high, LIMIT))
        if beyond is not None:
            outside |= beyond
        if not outside.any():
            first, *higher_names = (chunk.name for chunk in chunks_of(field))
            planes[first] = plane
            # The value is in the lowest chunk; the higher chunks of a wide field are 0.
            planes.update((name, np.zeros_like(plane)) for name in higher_names)
            return
        y, x = first_pixel(outside)
        count = int(outside.sum())
        value = "a number beyond 2^63" if beyond is not None and beyond[y, x] else plane[y, x]
        range_text = f"{field.low}..{min(field.high, LIMIT)}"
        helps: tuple[str, ...] = ()
        if field.high > LIMIT:
            shape = f"({', '.join(map(str, plane.shape))}, {field.bits})"
            bits_text = f"an array {field.name} of 0 and 1 {shape}, bit 0 first"
            helps = (f"give its bits in a file: {bits_text}",)
        self.problems.error(
            "NS0311",
            f"the {pixel_text(x, y)} has {field.name} = {value}, outside {range_text}",
            _value_span(statement, x, y),
            f"{counted(count, 'pixel is', 'pixels are')} outside the range",
            related=(Label(field.span, f"`{field.name}` is {range_text}"),),
            helps=helps,
            data={"field": field.name, "x": x, "y": y, "pixels": count},
        )


def _value_span(statement: PixelsExpr | PixelsTile | PixelsFromFile, x: int, y: int) -> Span:
    """Return the place of the text that gives the pixel in column `x`, row `y` its value: an
    expression, a value of a tile, or a file."""
    match statement:
        case PixelsExpr():
            return statement.value.span
        case PixelsTile():
            row = statement.rows[y % len(statement.rows)].values
            return row[x % len(row)].span
        case PixelsFromFile():
            return statement.path.span
    assert_never(statement)


Stored = tuple[Plane, Bools]
"""The values of a field, and where the given values do not fit int64."""


def stored_planes(
    file: ArraysFile,
    name: str,
    shape: tuple[int, int],
    chunk_count: int = 1,
    bits: int | None = None,
) -> list[Stored]:
    """Return the planes of the field `name` from the array of that name in a file, one for each of
    its chunks (see `planes_of`).

    `shape` is (rows, cols) of the pixel array. The array contains integers of this shape, or single
    bits (rows, cols, K). `bits` is the number of bits of the field; None allows every number that
    takes `chunk_count` chunks. Raises Rejected (NS0313, NS0314) for a damaged file or an unsuitable
    array."""
    most = shape[0] * shape[1] * (bits or chunk_count * CHUNK_BITS)
    # A small array that has too many values is read all the same, for an error that names its
    # shape.
    stored = file.integers(name, most=max(most, 2**20), bools=True)
    return planes_of(stored, name, shape, chunk_count, bits, origin=f' of "{file.shown}"')


def planes_of(
    stored: Array,
    name: str,
    shape: tuple[int, int],
    chunk_count: int,
    bits: int | None = None,
    origin: str = "",
) -> list[Stored]:
    """Return the planes of a field from the array `stored` that defines it, one for each chunk.

    The array contains integers (rows, cols), or single bits (rows, cols, K) of a bit field, bit 0
    first. `shape` is (rows, cols). A field has `chunk_count` chunks, and `bits` bits or, if None,
    as many as the chunks hold. `name` is the field and `origin` the file in messages. Each plane is
    returned with marks, bool (rows, cols), of the values that int64 cannot hold. Integers set only
    the first chunk, and the others become 0. Raises Rejected (NS0314) for other arrays."""
    # Only bit fields have single bits: (rows, cols, bits).
    if stored.ndim == 3 and (chunk_count > 1 or bits is not None):
        chunks = chunks_of_bits(_single_bits(stored, name, shape, chunk_count, bits, origin))
        return [(plane, np.zeros(shape, np.bool_)) for plane in chunks]
    if stored.dtype.kind not in "iu" or stored.shape != shape:
        array_text = f"the array `{clipped(name)}`{origin} is {stored.shape} of {stored.dtype}"
        message = f"{array_text}, but must contain integers {shape}: [row, column]"
        helps = (f"the array of pixels is {shape[0]} rows x {shape[1]} columns",)
        raise rejected("NS0314", message, helps=helps)
    plane = as_plane(stored)
    nothing = np.zeros(shape, np.int64), np.zeros(shape, np.bool_)
    return [plane, *[nothing] * (chunk_count - 1)]


def _single_bits(
    stored: Array,
    name: str,
    shape: tuple[int, int],
    chunk_count: int,
    bits: int | None,
    origin: str,
) -> Array:
    """Return `stored`, an array of single bits (rows, cols, bits), after checking it.

    Raises Rejected (NS0314) if its shape does not fit the pixel array and the field, or if values
    other than 0 and 1 occur. The field has `chunk_count` chunks, and `bits` bits, or any number
    that takes these chunks if None. `name` is the field and `origin` the file in messages."""
    count = stored.shape[2]
    # Without `bits`, every number of bits that takes this many chunks is allowed.
    least = bits or (chunk_count - 1) * CHUNK_BITS + 1
    most = bits or chunk_count * CHUNK_BITS
    if stored.shape[:2] != shape or not least <= count <= most:
        shape_text = f"({shape[0]}, {shape[1]}, {bits if bits else f'{least} to {most}'})"
        message = (
            f"the array `{clipped(name)}`{origin} has shape {stored.shape}, but bits need "
            f"{shape_text}"
        )
        helps = ("the last axis is the bit, bit 0 first",)
        raise rejected("NS0314", message, helps=helps)
    if not np.isin(stored, (0, 1)).all():
        message = f"the array `{clipped(name)}`{origin} has values other than 0 and 1"
        raise rejected(
            "NS0314", message, helps=("with three axes, an array must contain single bits",)
        )
    return stored


def as_plane(stored: Array) -> tuple[Plane, Bools]:
    """Return `stored`, integers of any dtype, as int64, and a bool array of the same shape that
    marks those that int64 cannot hold; these are arbitrary."""
    beyond = np.zeros(stored.shape, dtype=bool)
    # Only 64-bit unsigned integers exceed int64.
    if stored.dtype.kind == "u" and stored.dtype.itemsize == 8:
        beyond = np.asarray(stored > np.uint64(2**63 - 1), dtype=bool)
    with np.errstate(all="ignore"):
        return stored.astype(np.int64), beyond


def first_pixel(marked: Bools) -> tuple[int, int]:
    """Return (y, x), row and column, of the first true element of an array (rows, cols), row by
    row. At least one element must be true."""
    y, x = np.unravel_index(int(marked.argmax()), marked.shape)
    return int(y), int(x)


def pixel_text(x: int, y: int) -> str:
    """Return the name of a pixel in messages, both as x, y and as row, column."""
    return f"pixel at x = {x}, y = {y} (row {y}, column {x})"
