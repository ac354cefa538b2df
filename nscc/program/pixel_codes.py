"""Codes from the field values of all pixels: the used codes, or codes for a compiled program."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Bools, Ints, Ints32
from nscc.diagnostics.arguments import as_array
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.diagnostics.suggest import meant
from nscc.program.arrays_file import ArraysFile
from nscc.program.field_planes import (
    Plane,
    Stored,
    first_pixel,
    pixel_text,
    planes_of,
    stored_planes,
)
from nscc.program.problems import clipped, counted
from nscc.program.program import grouped
from nscc.words.container import DecodeTable

_DENSE = 2**20
"""Largest value range that is counted in a table; wider ranges are sorted."""


def codes_in_use(planes: Sequence[Plane], shape: tuple[int, int]) -> tuple[Ints, Ints32]:
    """Return the distinct codes of the pixels, int64 (codes, fields), and each pixel's row of them,
    int32 of `shape`.

    `planes` contains one array of `shape` (rows, cols) for each field. The codes are sorted by
    field values, first field first; without fields there is one code."""
    codes = np.zeros((1, 0), dtype=np.int64)
    at_pixel = np.zeros(shape, dtype=np.int64)
    for plane in planes:
        values, of_pixel = _ranked(plane)
        # A number for each pair of the code so far and the next field's value, in their order.
        pairs, at_pixel = _ranked(at_pixel * len(values) + of_pixel)
        codes = np.column_stack((codes[pairs // len(values)], values[pairs % len(values)]))
    return codes, at_pixel.astype(np.int32)


def _ranked(plane: Plane) -> tuple[Ints, Plane]:
    """Return the distinct values of an array, int64 (values,) ascending, and the index of each
    element's value, in the array's shape. The array is not empty."""
    lowest = int(plane.min())
    span = int(plane.max()) - lowest + 1
    if span > _DENSE:
        values, ranks = np.unique(plane, return_inverse=True)
        return values, ranks.reshape(plane.shape).astype(np.int64)
    # Without sorting, a plane of 256 x 256 pixels takes a tenth of the time.
    present = np.zeros(span, dtype=bool)
    present[plane - lowest] = True
    # The rank of a value is the number of smaller values that occur.
    return np.flatnonzero(present) + lowest, (np.cumsum(present) - 1)[plane - lowest]


Ranges = Mapping[str, tuple[int, int]]
"""The smallest and the largest value of each field."""


def codes_from(
    pixels: Path | Mapping[str, Array],
    table: DecodeTable,
    rows: int,
    cols: int,
    *,
    shown: str | None = None,
    mode: str = "fixed",
    ranges: Callable[[], Ranges] = dict,
) -> Ints32:
    """Return the row of `table.codes` at each pixel, int32 (rows, cols), from a file or from arrays
    by field name.

    There is one array for each field of `table`, under the field's name: integers (rows, cols), or
    single bits (see `nscc.program.field_planes.planes_of`). Messages call the file `shown`. `mode`
    "open" means that `table` contains every legal code, "fixed" that it has only the codes in use.
    `ranges` returns the ranges of the fields. It is called only for an error.

    Raises Rejected: NS0313 and NS0314 for the file, NS0314 for missing, additional or unsuitable
    arrays, NS0311 for a value outside its field's range, NS0312 for a code that the program
    forbids, NS0319 for a code that was not compiled. Errors about pixels name the first such pixel
    and their number."""
    fields, shape, origin = grouped(table.fields), (rows, cols), "the arrays"
    stored: list[Stored] = []
    if isinstance(pixels, Path):
        file = ArraysFile(pixels, str(pixels) if shown is None else shown)
        origin = f'"{file.shown}"'
        for name, chunk_names in fields.items():
            stored += stored_planes(file, name, shape, len(chunk_names))
    # The loop only serves to take the first unknown name, if there is one.
    else:
        for name in {*pixels} - {*fields}:
            raise rejected(
                "NS0314",
                f"the program's code has no field '{clipped(name)}'",
                notes=(f"its fields: {', '.join(fields) or 'none'}",),
                helps=meant(name, fields),
            )
        for name, chunk_names in fields.items():
            if name not in pixels:
                raise rejected("NS0314", f"the array for the code field '{name}' is missing")
            stored += planes_of(
                as_array("with_pixels", f"'{name}'", pixels[name]), name, shape, len(chunk_names)
            )
    planes = [plane for plane, _ in stored]
    missing = np.zeros(shape, dtype=bool)
    for _, beyond in stored:
        missing |= beyond
    at_pixel, unknown = (
        rows_of(table.codes, planes) if planes else (missing.astype(np.int32), missing)
    )
    missing |= unknown
    if missing.any():
        # Of several faults, a value outside its range explains most, so it is reported first.
        known = ranges()
        for name, plane in zip(table.fields, planes, strict=True):
            if name in known:
                refuse_outside(origin, name, plane, known[name])
        raise _unknown(origin, table, planes, missing, mode)
    return at_pixel


def refuse_outside(origin: str, name: str, plane: Plane, values: tuple[int, int]) -> None:
    """Raise Rejected (NS0311) if a pixel's value of the field `name` is outside `values` (low,
    high).

    `plane` (rows, cols) has the values of all pixels, `high` is included, and `origin` says in
    messages where they come from."""
    low, high = values
    outside = (plane < low) | (plane > high)
    if outside.any():
        y, x = first_pixel(outside)
        count = int(outside.sum())
        raise rejected(
            "NS0311",
            f"in {origin} the {pixel_text(x, y)} has {name} = {plane[y, x]}, outside {low}..{high}",
            notes=(f"{counted(count, 'pixel is', 'pixels are')} outside the range",),
            helps=(
                f"use values from {low} to {high}, or extend the range `code {name}` in the "
                "program",
            ),
            data={"field": name, "x": x, "y": y, "pixels": count},
        )


def _unknown(
    origin: str, table: DecodeTable, planes: list[Plane], missing: Bools, mode: str
) -> Rejected:
    """Return the error for pixels whose code the program forbids (NS0312) or was not compiled for
    (NS0319).

    `missing`, bool (rows, cols), marks these pixels. `planes` has the values (rows, cols) of each
    field of the table, and `origin` says where they come from. With `mode` "open" the table has all
    legal codes, so that others are forbidden."""
    y, x = first_pixel(missing)
    count = int(missing.sum())
    code = ", ".join(f"{n} = {p[y, x]}" for n, p in zip(table.fields, planes, strict=True))
    if mode == "open":
        return rejected(
            "NS0312",
            f"in {origin} the {pixel_text(x, y)} has {code}, which the program forbids",
            notes=(f"{counted(count, 'pixel has', 'pixels have')} such codes",),
            helps=("use codes within the ranges of the fields that fulfil every `require`",),
            data={"x": x, "y": y, "pixels": count},
        )
    return rejected(
        "NS0319",
        f"the program was not compiled for a code in {origin}: {pixel_text(x, y)} has {code}",
        notes=(
            f"{counted(count, 'pixel has', 'pixels have')} such codes; the program was "
            f"compiled for {counted(len(table.codes), 'code')}",
        ),
        helps=("`--codes open` compiles the program (.nsl) for every code that it allows",),
        data={"x": x, "y": y, "pixels": count},
    )


def rows_of(codes: Ints, planes: Sequence[Ints]) -> tuple[Ints32, Bools]:
    """Return the row of `codes` that equals the values of `planes` at each place, and where there
    is none.

    `codes` (codes, fields) are sorted and distinct, at least one. `planes` contains at least one
    array for a field, all of equal shape. The results are int32 and bool of this shape; rows are
    arbitrary where there is none."""
    shape = planes[0].shape
    unknown = np.zeros(shape, dtype=bool)
    # One field after the other: `known` numbers the distinct prefixes of the codes, and `at_pixel`
    # is the prefix of each pixel's code.
    known = np.zeros(len(codes), dtype=np.int64)
    at_pixel = np.zeros(shape, dtype=np.int64)
    for column, plane in zip(codes.T, planes, strict=True):
        values, of_code = _ranked(column)
        # A value beyond the last has no index of its own; it differs from the last one.
        of_pixel = np.minimum(np.searchsorted(values, plane), len(values) - 1)
        unknown |= values[of_pixel] != plane
        beginnings, known = _ranked(known * len(values) + of_code)
        beginning = at_pixel * len(values) + of_pixel
        at_pixel = np.minimum(np.searchsorted(beginnings, beginning), len(beginnings) - 1)
        unknown |= beginnings[at_pixel] != beginning
    # The codes are sorted and distinct, so their numbers are their rows.
    return at_pixel.astype(np.int32), unknown
