"""Diagrams of sweeps: quantities against a setting, one line for each value of other settings.

Panels of equal quantities have equal scales: numbers, logarithmic if they span a decade, or names
side by side."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import TYPE_CHECKING

from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.labels import ChartLabel, place_labels
from nscc_runtime.pictures.sheet import theme

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_COLUMNS = 2
"""Number of panels side by side."""
_HEIGHT = 2.9
"""Height of a panel in inches."""
_DECADE = 10.0
"""Ratio of numbers from which on their axis is logarithmic."""
_MARGIN = 0.06
"""Margin of an axis beyond its outermost points, relative to its length."""
_MOST_NAMED = 6
"""Largest number of lines with names beside them; more lines have a legend."""

Place = float | str
"""The position of a point on an axis: a number, or one of several names."""


@dataclass(frozen=True)
class Lines:
    """A panel: its axis labels (`across`, `upwards`), and by the name of each line its points
    (across, upwards). A line named "" has no label."""

    title: str
    across: str
    upwards: str
    lines: Mapping[str, Sequence[tuple[Place, float]]]


@dataclass(frozen=True)
class _Scale:
    """The scale of an axis: `names` side by side if given, else numbers from `low` to `high`."""

    low: float
    high: float
    logarithmic: bool = False
    names: tuple[str, ...] = ()

    @classmethod
    def of(cls, values: Sequence[Place]) -> _Scale:
        """Return the scale that shows all of `values`, one or more: names if any of them is a text,
        else linear, or logarithmic if they are positive and span a decade or more."""
        numbers = [value for value in values if not isinstance(value, str)]
        if len(numbers) < len(values):
            names = tuple(dict.fromkeys(map(str, values)))
            # Names lie at 0, 1, ..: the axis extends 0.3 beyond the outermost ones.
            return cls(-0.3, len(names) - 0.7, names=names)
        low, high = min(numbers), max(numbers)
        if low > 0 and high >= _DECADE * low:
            room = (high / low) ** _MARGIN
            return cls(low / room, high * room, logarithmic=True)
        room = _MARGIN * ((high - low) or abs(high) or 1.0)
        return cls(low - room, high + room)

    def at(self, value: Place) -> float:
        """Return where `value` is on the axis: a number as it is, a name by its place among the
        names."""
        return float(self.names.index(str(value)) if self.names else value)

    def lay(self, axes: Axes, axis_name: str) -> None:
        """Apply the scale, with its limits and ticks, to the axis `axis_name` ("x" or "y") of a
        panel."""
        if self.logarithmic:
            axes.set(**{f"{axis_name}scale": "log"})
        axes.set(**{f"{axis_name}lim": (self.low, self.high)})
        axis = axes.xaxis if axis_name == "x" else axes.yaxis
        if self.names:
            axis.set_ticks(range(len(self.names)), self.names)
        else:
            sheet.round_ticks(axis)


def sweep_diagram(panels: Sequence[Lines], title: str, note: str) -> Figure:
    """Return a figure of all `panels` that have points, with one colour per name of lines, under
    `title` and above `note`. Panels with the same axis label have the same scale. Raises ValueError
    without points."""
    from matplotlib.lines import Line2D

    filled_panels = [panel for panel in panels if any(panel.lines.values())]
    if not filled_panels:
        raise ValueError("there are no points to draw: every panel is empty")
    names = list(dict.fromkeys(name for panel in filled_panels for name in panel.lines))
    # Axes with the same label share a scale, so that panels can be compared.
    values: dict[tuple[str, str], list[Place]] = {}
    for panel in filled_panels:
        for across, upwards in chain.from_iterable(panel.lines.values()):
            values.setdefault(("x", panel.across), []).append(across)
            values.setdefault(("y", panel.upwards), []).append(upwards)
    scales = {key: _Scale.of(axis_values) for key, axis_values in values.items()}
    columns = min(_COLUMNS, len(filled_panels))
    figure, grid = sheet.panels(
        len(filled_panels), (sheet.WIDTH / max(columns, 1.4), _HEIGHT), columns
    )
    labels = [
        _draw(axes, panel, names, scales) for axes, panel in zip(grid, filled_panels, strict=True)
    ]
    figure.align_ylabels(grid)
    sheet.lay_out(figure)
    # Names without room beside their line move to the legend.
    homeless = {*names} - {""}
    if len(names) <= _MOST_NAMED:
        homeless = {
            label.text
            for axes, texts in zip(grid, labels, strict=True)
            for label in place_labels(axes, texts)
        }
    handles = [
        Line2D([], [], label=name, **theme().of(number))
        for number, name in enumerate(names)
        if name in homeless
    ]
    sheet.head(figure, title, note, handles)
    return figure


def _draw(
    axes: Axes, panel: Lines, names: Sequence[str], scales: Mapping[tuple[str, str], _Scale]
) -> list[ChartLabel]:
    """Draw the lines of `panel` into `axes`; return labels with the lines' names at their ends.

    `names` fixes the colour of each line by its place. `scales` has the scale of each quantity, by
    ("x" or "y", axis label)."""
    across, upwards = scales["x", panel.across], scales["y", panel.upwards]
    axes.set_title(panel.title)
    axes.set_xlabel(panel.across)
    axes.set_ylabel(panel.upwards)
    labels = []
    for name, points in panel.lines.items():
        positions = [(across.at(x), upwards.at(y)) for x, y in points]
        chosen = theme().of(names.index(name))
        axes.plot([x for x, _ in positions], [y for _, y in positions], clip_on=False, **chosen)
        if positions and name:
            labels.append(ChartLabel(name, *positions[-1], chosen["color"], name=True))
    across.lay(axes, "x")
    upwards.lay(axes, "y")
    return labels
