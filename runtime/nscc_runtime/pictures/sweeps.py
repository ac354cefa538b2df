"""Pictures of sweeps: figures against an axis, a line for each value of others.

Panels that show the same have the same scales: numbers, which are logarithmic where they span a
decade, or names side by side.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.labels import ChartLabel, place_labels
from nscc_runtime.pictures.look import look

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_COLUMNS = 2
_HEIGHT = 2.9
_DECADE = 10.0
_MARGIN = 0.06
"""Of an axis beyond its outermost points."""
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


@dataclass(frozen=True)
class _Scale:
    """How an axis is laid out: `names` side by side, or numbers between limits."""

    low: float
    high: float
    logarithmic: bool = False
    names: tuple[str, ...] = ()

    @classmethod
    def of(cls, values: Sequence[Place]) -> _Scale:
        """The scale that all of these values are on."""
        numbers = [value for value in values if not isinstance(value, str)]
        if len(numbers) < len(values):
            names = tuple(dict.fromkeys(map(str, values)))
            return cls(-0.3, len(names) - 0.7, names=names)
        low, high = min(numbers), max(numbers)
        if low > 0 and high >= _DECADE * low:
            room = (high / low) ** _MARGIN
            return cls(low / room, high * room, logarithmic=True)
        room = _MARGIN * ((high - low) or abs(high) or 1.0)
        return cls(low - room, high + room)

    def at(self, value: Place) -> float:
        """Where a value is."""
        return float(self.names.index(str(value)) if self.names else value)

    def lay(self, axes: Axes, axis_name: str) -> None:
        """Gives one of a panel's axes, "x" or "y", this scale."""
        if self.logarithmic:
            axes.set(**{f"{axis_name}scale": "log"})
        axes.set(**{f"{axis_name}lim": (self.low, self.high)})
        axis = axes.xaxis if axis_name == "x" else axes.yaxis
        if self.names:
            axis.set_ticks(range(len(self.names)), self.names)
        else:
            sheet.round_ticks(axis)


def sweep_diagram(panels: Sequence[Lines], title: str, note: str) -> Figure:
    """All panels, lines of one name in one colour. Raises ValueError where there is nothing to
    draw."""
    from matplotlib.lines import Line2D

    filled_panels = [panel for panel in panels if any(panel.lines.values())]
    if not filled_panels:
        raise ValueError("no points to draw")
    names = list(dict.fromkeys(name for panel in filled_panels for name in panel.lines))
    scales = _scales(filled_panels)
    columns = min(_COLUMNS, len(filled_panels))
    figure, grid = sheet.panels(
        len(filled_panels), (sheet.WIDTH / max(columns, 1.4), _HEIGHT), columns
    )
    labels = [
        _draw(axes, panel, names, scales) for axes, panel in zip(grid, filled_panels, strict=True)
    ]
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


def _scales(panels: Sequence[Lines]) -> dict[tuple[str, str], _Scale]:
    """The scales by ("x" or "y", what is drawn along it)."""
    values: dict[tuple[str, str], list[Place]] = {}
    for panel in panels:
        for points in panel.lines.values():
            for across, upwards in points:
                values.setdefault(("x", panel.across), []).append(across)
                values.setdefault(("y", panel.upwards), []).append(upwards)
    return {key: _Scale.of(axis_values) for key, axis_values in values.items()}


def _draw(
    axes: Axes, panel: Lines, names: Sequence[str], scales: Mapping[tuple[str, str], _Scale]
) -> list[ChartLabel]:
    """Draws a panel's lines; their names, for their ends."""
    across, upwards = scales["x", panel.across], scales["y", panel.upwards]
    axes.set_title(panel.title)
    axes.set_xlabel(panel.across)
    axes.set_ylabel(panel.upwards)
    labels = []
    for name, points in panel.lines.items():
        places = [(across.at(x), upwards.at(y)) for x, y in points]
        chosen = look().of(names.index(name))
        axes.plot([x for x, _ in places], [y for _, y in places], clip_on=False, **chosen)
        if places and name:
            labels.append(ChartLabel(name, places[::-1], chosen["color"], name=True))
    across.lay(axes, "x")
    upwards.lay(axes, "y")
    return labels
