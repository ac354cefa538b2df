"""The page of results: each claim with its picture; the numbers are those of the stored tables."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from nscc_runtime.pictures.sheet import THEMES, blank, head, png_of, theme, themed
from result_pages import EVALUATIONS, Page

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_TEMPLATE = Path(__file__).with_name("results.template")
"""The page, with the placeholders of `docs/result_pages.py`. In a block `chart NAME: UNIT`, each
line is a label and a result; * marks those that the claim is about."""
_CHART = re.compile(r"^```chart (\w+): (.*?)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_ROW, _WIDTH, _AXIS = 0.34, 6.4, 0.4
"""The height of a row of a chart, the width of its panel, and the room for the axis, in inches."""


class _Row(NamedTuple):
    """A row of a chart: a mean and its interval."""

    label: str
    is_own: bool
    mean: float
    low: float
    high: float


def results_pages() -> dict[str, str | bytes]:
    """Return the page of results and its charts, light and dark, by path in `docs/generated`."""
    files: dict[str, str | bytes] = {}
    text = Page(EVALUATIONS).filled(_TEMPLATE.read_text(encoding="utf-8"))
    for name, unit, lines in _CHART.findall(text):
        rows = [_row(line) for line in lines.splitlines()]
        for theme_name, colours in THEMES.items():
            with themed(colours):
                picture = png_of(_chart, unit, rows)
            files[f"pictures/result_{name}_{theme_name}.png"] = picture
    page = _CHART.sub(r"![\2](pictures/result_\1_light.png)", text)
    return files | {"results.md": page}


def _row(line: str) -> _Row:
    """Return the row of a line `LABEL | MEAN (LOW to HIGH)`; without an interval, its ends are the
    mean. Raises ValueError for a result that is not stored."""
    label, _, result = line.partition(" | ")
    numbers = [float(number) for number in re.findall(r"[-+]?\d+\.\d+", result)]
    if len(numbers) not in (1, 3):
        raise ValueError(f"a result of the page is missing: {line}")
    mean, *ends = numbers
    return _Row(label.removeprefix("* "), label.startswith("* "), mean, *(ends or (mean, mean)))


def _chart(unit: str, rows: Sequence[_Row]) -> Figure:
    """Draw a line for each result, with a line at 0 between gains and losses."""
    height = _ROW * len(rows) + _AXIS
    figure, colours = blank(_WIDTH, height), theme()
    axes = figure.add_axes((0, _AXIS / height, 1, 1 - _AXIS / height))
    for place, row in enumerate(rows):
        colour = colours.series[0] if row.is_own else colours.faint
        axes.plot((row.low, row.high), (place, place), color=colour, lw=2, solid_capstyle="round")
        axes.plot(row.mean, place, "o", color=colour, ms=8)
        above = {"xytext": (0, 7), "textcoords": "offset points", "ha": "center", "size": 9}
        axes.annotate(f"{row.mean:.2f}", (row.mean, place), **above)
    if min(row.low for row in rows) < 0 < max(row.high for row in rows):
        axes.axvline(0, color=colours.ink, lw=1)
    axes.set_yticks(range(len(rows)), [row.label for row in rows])
    axes.set(ylim=(len(rows) - 0.4, -0.8), xlabel=unit)
    axes.grid(axis="x", color=colours.grid)
    head(figure, "", "")
    return figure
