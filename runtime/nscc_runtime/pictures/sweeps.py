"""Pictures of sweeps: a figure against an axis, a line for each value of another one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.labels import Label, place_labels
from nscc_runtime.pictures.look import look

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_COLUMNS = 2
_LOGARITHMIC = 10.0
"""Values above 0 that span such a factor have a logarithmic axis."""
_MOST_NAMED = 6
"""Lines that may have their names beside them; of more a legend tells them apart."""

Place = float | str
"""Where a point is across: a number, or one of several names."""


@dataclass(frozen=True)
class Lines:
    """A panel: what is drawn across and upwards, and the points (across, upwards) of each line."""

    title: str
    across: str
    upwards: str
    lines: Mapping[str, Sequence[tuple[Place, float]]]


def sweep_diagram(panels: Sequence[Lines], title: str, note: str) -> Figure:
    """All panels, lines of one name in one colour. Raises ValueError where there is nothing to
    draw."""
    from matplotlib.lines import Line2D

    if not any(points for panel in panels for points in panel.lines.values()):
        raise ValueError("no points to draw")
    names = list(dict.fromkeys(name for panel in panels for name in panel.lines))
    columns = min(_COLUMNS, len(panels))
    figure, grid = sheet.panels(len(panels), (sheet.WIDTH / max(columns, 1.4), 2.9), columns)
    labels = [_draw(axes, panel, names) for axes, panel in zip(grid, panels, strict=True)]
    figure.align_ylabels(grid)
    sheet.lay_out(figure)
    homeless = {*names} - {""}
    if len(names) <= _MOST_NAMED:
        homeless = {
            label.text
            for axes, texts in zip(grid, labels, strict=True)
            for label in place_labels(axes, texts)
        }
    handles = [
        Line2D([], [], label=name, **look().of(number))
        for number, name in enumerate(names)
        if name in homeless
    ]
    sheet.head(figure, title, note, handles)
    return figure


def _draw(axes: Axes, panel: Lines, names: Sequence[str]) -> list[Label]:
    """Draws a panel's lines; their names, for their ends."""
    across = [x for points in panel.lines.values() for x, _ in points]
    upwards = [y for points in panel.lines.values() for _, y in points]
    axes.set_title(panel.title)
    axes.set_xlabel(panel.across)
    axes.set_ylabel(panel.upwards)
    numbers = [x for x in across if not isinstance(x, str)]
    categories = [] if len(numbers) == len(across) else list(dict.fromkeys(map(str, across)))
    if not categories and _wide(numbers):
        axes.set_xscale("log")
    if _wide(upwards):
        axes.set_yscale("log")
    labels = []
    for name, points in panel.lines.items():
        places = [
            (float(categories.index(str(x)) if categories else x), float(y)) for x, y in points
        ]
        chosen = look().of(names.index(name))
        axes.plot([x for x, _ in places], [y for _, y in places], **chosen)
        if places and name:
            labels.append(Label(name, places[::-1], chosen["color"], name=True))
    if categories:
        axes.set_xticks(range(len(categories)), categories)
        axes.set_xlim(-0.3, len(categories) - 0.7)
    elif numbers:
        sheet.round_ticks(axes.xaxis)
    if upwards:
        sheet.round_ticks(axes.yaxis)
    return labels


def _wide(values: Sequence[float]) -> bool:
    return bool(values) and min(values) > 0 and max(values) >= _LOGARITHMIC * min(values)
