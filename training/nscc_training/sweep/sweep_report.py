"""The results of a sweep: a table (CSV, Parquet), a diagram, and a self-contained HTML page."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

from nscc import html
from nscc.diagnostics.diagnostic import rejected
from nscc.diagnostics.suggest import meant
from nscc.mappings import NamedValues
from nscc.program.problems import counted
from nscc_runtime.pictures.sweeps import Lines, sweep_diagram
from nscc_training.experiments.engine import PointRow
from nscc_training.experiments.study_table import csv_of
from nscc_training.sweep.grid import Grid
from nscc_training.sweep.kinds import KINDS
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


_MOST_ROWS = 2000
"""Most rows on the HTML page; the CSV table contains all rows."""
_MOST_PANELS, _MOST_LINES = 12, 7
"""Most panels of a diagram, and most lines of a panel unless the grid names the lines."""
_MOST_LETTERS = 60
"""Most letters of a cell."""
_WIDTH = 900
"""Width of the diagram in pixels."""


def report_html(grid: Grid, table: Table, diagram: bytes | None) -> str:
    """Return the report as an HTML page: the diagram (PNG, or None), points without figures, all
    points (the first `_MOST_ROWS`), and the grid's text. It names no other files."""
    shown = [name for name in ("part", *grid.columns) if name in table.inputs or len(table) == 1]
    shown += [name for name in table.figures if any(v is not None for v in table.columns[name])]
    rows = [*zip(*(table.columns[name] for name in shown), strict=True)][:_MOST_ROWS]
    blocks = [
        html.Html() if diagram is None else html.picture(diagram, "", _WIDTH),
        _misfits(grid, table),
        html.table(([_short(v) for v in row] for row in rows), shown),
        html.folded("the grid", html.plain(grid.text)),
    ]
    count = counted(len(table), "point")
    if len(table) > _MOST_ROWS:
        count += f", {_MOST_ROWS} of them below, all in the table"
    body = html.card(grid.name, count, *blocks)
    style = "body{font-family:sans-serif;margin:2em}img{image-rendering:auto!important}"
    return (
        f"<!doctype html>\n<html lang='en'><head><meta charset='utf-8'><title>"
        f"{html.text(grid.name)}</title><style>{style}</style></head><body>{body}</body></html>\n"
    )


def diagram_of(grid: Grid, table: Table) -> bytes | None:
    """Return the PNG of the diagram that the grid describes, or with defaults where it does not.
    Return None if there is nothing to draw.

    Raises Rejected (NS0832) if the grid names a column that the table lacks."""
    from nscc_runtime.pictures.sheet import png_of

    if not table.figures:
        return None
    plot = grid.plot
    plot_axes = [("x", plot.x), *(("line", name) for name in plot.line), ("panel", plot.panel)]
    for key, name in (*plot_axes, *(("y", name) for name in plot.y)):
        if name and name not in table.columns:
            raise rejected(
                "NS0832",
                f"plot.{key} is '{name[:60]}', but the table has no such column",
                notes=(f"it has {', '.join(table.columns)}",),
                helps=meant(name, table.columns, "name one of them"),
            )
    used_names = {name for _, name in plot_axes}
    free = [
        n for n in ("part", *grid.axes) if len(set(table.columns[n])) > 1 and n not in used_names
    ]
    x = plot.x or _take(free, lambda name: _numbers(table.columns[name])) or _take(free)
    # Results of several seeds are averaged, not drawn as lines.
    lines = [name for name in free if not name.endswith("seed")]
    panel = plot.panel
    if not panel and len({*zip(*(table.columns[n] for n in lines), strict=True)}) > _MOST_LINES:
        # The first axis becomes panels, because one panel would have too many lines.
        panel = lines.pop(0)
    lines = [*plot.line] or lines
    panels = [
        Lines(
            "" if value is None else f"{panel} {_short(value)}",
            x,
            figure,
            _lines(table, x, figure, lines, {panel: value} if panel else {}),
        )
        for figure in plot.y or _drawn(grid, table)
        for value in (dict.fromkeys(table.columns[panel]) if panel else (None,))
        if x
    ]
    panels = [panel_lines for panel_lines in panels if panel_lines.lines][:_MOST_PANELS]
    if not panels:
        return None
    averaged_names = [name for name in free if name not in (*lines, panel)]
    note = (
        f"means over {', '.join(averaged_names)}"
        if averaged_names and x not in table.figures
        else ""
    )
    return png_of(sweep_diagram, panels, grid.name.replace("_", " "), note)


def _drawn(grid: Grid, table: Table) -> list[str]:
    """Return the figures that are drawn by default: one for each kind of point in the grid."""
    kinds = [KINDS[name] for name in dict.fromkeys(point.kind for point in grid.points)]
    known = ([name for name in kind.drawn if name in table.figures] for kind in kinds)
    return list(dict.fromkeys(names[0] for names in known if names))


def _lines(
    table: Table, x: str, figure: str, lines: Sequence[str], chosen: NamedValues
) -> dict[str, list[tuple[Any, float]]]:
    """Return the points (x, y) of a panel's lines by the name of the line.

    `x` and `figure` are the columns of both axes. `lines` are columns that tell lines apart, and
    `chosen` are values of columns that rows must have. If x is a key, equal x have the mean of y,
    and points are sorted if all x are numbers; if it is a figure, points stay as in the table. Rows
    without x or a finite y are left out."""
    columns = table.columns
    points_by_line: dict[str, list[tuple[Any, float]]] = {}
    for index in range(len(table)):
        across, up = columns[x][index], columns[figure][index]
        matches = all(columns[name][index] == value for name, value in chosen.items())
        if matches and across is not None and _number(up):
            name = ", ".join(_short(columns[line][index]) for line in lines)
            points_by_line.setdefault(name, []).append((across, up))
    if x in table.figures:
        return points_by_line
    return {name: _means(points, _numbers(columns[x])) for name, points in points_by_line.items()}


def _means(points: Sequence[tuple[Any, float]], ordered: bool) -> list[tuple[Any, float]]:
    """Return one point (x, y) for each x, with the mean of its y. They are sorted by x if
    `ordered`, else in the order of the first points."""
    places: dict[Any, list[float]] = {}
    for across, up in points:
        places.setdefault(across, []).append(up)
    means = [(across, sum(ups) / len(ups)) for across, ups in places.items()]
    return sorted(means) if ordered else means


def _misfits(grid: Grid, table: Table) -> html.Html:
    """Return a table of the points that have a message instead of figures, grouped by code and
    reason; empty if all have figures. Points and rows are in the same order."""
    together: dict[tuple[str, str], list[str]] = {}
    columns = table.columns
    for point, code, error in zip(grid.points, columns["code"], columns["error"], strict=True):
        if code:
            together.setdefault((code, error), []).append(point.name)
    if not together:
        return html.Html()
    rows = [(code, error, ", ".join(names)) for (code, error), names in together.items()]
    count = sum(map(len, together.values()))
    heading = html.text(f"{count} without figures")
    return html.Html(heading + html.table(rows, ("code", "why", "points")))


def _take(names: list[str], fits: Any = lambda _name: True) -> str:
    """Remove the first of `names` for which `fits` is true from the list, and return it; "" if
    there is none."""
    first_fit = next((name for name in names if fits(name)), "")
    if first_fit:
        names.remove(first_fit)
    return first_fit


def _number(value: Any) -> bool:
    """Return whether a value is a finite number; a bool is none."""
    number = isinstance(value, int | float) and not isinstance(value, bool)
    return number and isfinite(value)


def _numbers(values: Sequence[Any]) -> bool:
    """Return whether all values are finite numbers or missing."""
    return all(value is None or _number(value) for value in values)


def _short(value: Any) -> str:
    """Return a cell as short text: floats with six digits, and long texts cut to
    `_MOST_LETTERS`."""
    if isinstance(value, float):
        return f"{value:.6g}"
    text = " ".join(cell(value).split())
    return text if len(text) <= _MOST_LETTERS else f"{text[: _MOST_LETTERS - 2]} .."
