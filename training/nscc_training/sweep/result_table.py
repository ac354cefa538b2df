"""The result table of a sweep: one row per point, in the order of the grid."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from nscc_training.experiments.engine import PointRow
from nscc_training.experiments.study_table import csv_of
from nscc_training.sweep.grid import Grid
from nscc_training.sweep.point import GridPoint


@dataclass(frozen=True)
class Table:
    """The results of a sweep by columns, with a row for each point.

    The columns are `part`, the keys that the grid names, the figures, `code` and `error` of points
    without figures, and `key`. A missing value is None. `inputs` and `figures` are the names of the
    columns that identify a point, and of its results."""

    columns: dict[str, list[Any]]
    inputs: tuple[str, ...]
    figures: tuple[str, ...]

    def __len__(self) -> int:
        """Return the number of rows."""
        return len(self.columns["part"])

    def rows(self) -> list[tuple[Any, ...]]:
        """Return the rows of the table, each with one value for every column."""
        return [*zip(*self.columns.values(), strict=True)]


def table_of(grid: Grid, rows: Sequence[tuple[GridPoint, PointRow]]) -> Table:
    """Return the table of a grid's points. `rows` are the points with their stored rows.

    A figure with the name of a key has `found_` in front of it."""
    figures = tuple(dict.fromkeys(name for _, row in rows for name in row.figures))
    several = len({point.grid_part for point, _ in rows}) > 1 or not grid.columns
    columns: dict[str, list[Any]] = {"part": [point.grid_part for point, _ in rows]}
    for name in grid.columns:
        columns[name] = [_input(point, name) for point, _ in rows]
    shown = {name: name if name not in columns else f"found_{name}" for name in figures}
    for name in figures:
        columns[shown[name]] = [row.figures.get(name) for _, row in rows]
    columns["code"] = [row.code or None for _, row in rows]
    columns["error"] = [row.error or None for _, row in rows]
    columns["key"] = [row.key[:12] for _, row in rows]
    inputs = ("part", *grid.columns) if several else grid.columns
    return Table(columns, inputs, tuple(shown.values()))


def _input(point: GridPoint, name: str) -> Any:
    """Return the value of the key `name` of a point as a table cell. If the point has no such key,
    return that of the first run that it names; None if there is none."""
    if name in point.values:
        return plain(point.values[name])
    return _input(point.after[0], name) if point.after else None


def plain(value: Any) -> Any:
    """Return a value of a key as a table cell: several numbers become a text such as "4 x 4"."""
    return " x ".join(map(str, value)) if isinstance(value, tuple) else value


def csv_text(table: Table) -> str:
    """Return the table as CSV: a line of column names, then one line for each point."""
    return csv_of(table.columns, ([cell(value) for value in row] for row in table.rows()))


def cell(value: Any) -> str:
    """Return a table cell as text: empty for None, yes or no for a bool, and numbers as Python
    prints them."""
    if value is None:
        return ""
    return ("no", "yes")[value] if isinstance(value, bool) else str(value)


def parquet_bytes(table: Table) -> bytes:
    """Return the table as a Parquet file. A column whose values have different types becomes
    text."""
    import pyarrow
    from pyarrow import parquet

    columns = {name: pyarrow.array(_of_one_type(values)) for name, values in table.columns.items()}
    data = io.BytesIO()
    parquet.write_table(pyarrow.table(columns), data)
    return data.getvalue()


def _of_one_type(values: Sequence[Any]) -> list[Any]:
    """Return a column whose values have one type, except None: all floats if numbers include a
    float, all text if other types differ. None stays."""
    types = {type(value) for value in values if value is not None}
    if types <= {int, float}:
        return [float(v) if v is not None and float in types else v for v in values]
    if len(types) < 2:
        return [*values]
    return [None if value is None else cell(value) for value in values]
