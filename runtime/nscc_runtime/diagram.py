"""Work-precision diagrams: error against time, a panel for each problem, a line for each method.

Settings of a method are dots with the setting's mark above, joined in their order, on a band from
the shortest to the longest time; a hollow dot is dominated. A dashed line is what no setting can
get below.
"""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

INK, FAINT, GRID = "#1d2129", "#6b7280", "#e3e7ee"
COLOURS = (
    "#2563a8", "#d9722b", "#2f9268", "#8a4fb5", "#c2405a", "#8c7a2d", "#1b9bb3", "#6b4226",
    "#d15fa6", "#4a4f57",
)  # fmt: skip
_DPI = 150
_NEAR = 12.0
"""Dots of a line closer than this, in the figure's own pixels (100 an inch), share one name."""
_MOST_COLUMNS = 3
_MOST_NAMED = 3
"""Of more marks than that in one place the first and the last are named."""
_PANEL_WIDTH, _PANEL_HEIGHT = 4.0, 2.75
_LEFT, _RIGHT, _TOP, _BOTTOM = 0.75, 0.3, 1.3, 0.75
_BETWEEN, _ABOVE = 0.62, 0.62
"""Inches between the panels of a row, and between rows."""


@dataclass(frozen=True)
class Mark:
    """One setting: where it is, how far its time spreads, one or two letters to name it."""

    time_s: float
    least_s: float
    most_s: float
    error: float
    text: str
    dominated: bool


@dataclass(frozen=True)
class Line:
    """A method's marks in the order in which they are joined, and its bound, if it has one."""

    name: str
    marks: tuple[Mark, ...]
    bound: float | None = None


@dataclass(frozen=True)
class Panel:
    """A problem and the methods that were measured on it."""

    title: str
    lines: tuple[Line, ...]


@dataclass(frozen=True)
class Axis:
    """The time axis: its label, and how many of its units a second has."""

    label: str = "time, s"
    per_s: float = 1.0


SECONDS = Axis()


def diagram_png(
    panels: Sequence[Panel], title: str, subtitle: str, error_label: str, *,
    linear: bool = False, time: Axis = SECONDS,
) -> bytes:  # fmt: skip
    """A PNG of all panels: time across, `error_label` upwards, both logarithmic.

    With `linear` only time is, as decibels want it. The time axis is the same for all. The same
    panels give the same bytes, whatever the user's plotting settings. Raises ValueError where there
    is nothing to draw.
    """
    if not any(line.marks for panel in panels for line in panel.lines):
        raise ValueError("no points to draw")
    return png_of(lambda: _figure(panels, title, subtitle, error_label, linear, time))


def png_of(make: Callable[[], Figure]) -> bytes:
    """A figure as PNG: the same bytes every time, whatever the user's plotting settings."""
    import matplotlib

    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        data = io.BytesIO()
        make().savefig(data, format="png", dpi=_DPI, metadata={"Software": None})
    return data.getvalue()


def _figure(
    panels: Sequence[Panel], title: str, subtitle: str, error_label: str, linear: bool, time: Axis
) -> Figure:
    from matplotlib.figure import Figure

    columns = _columns(len(panels))
    rows = math.ceil(len(panels) / columns)
    width = _LEFT + columns * _PANEL_WIDTH + (columns - 1) * _BETWEEN + _RIGHT
    height = _TOP + rows * _PANEL_HEIGHT + (rows - 1) * _ABOVE + _BOTTOM
    figure = Figure(figsize=(width, height), facecolor="white")
    figure.text(0.25 / width, 1 - 0.42 / height, title, size=15, weight="bold", color=INK)
    figure.text(0.25 / width, 1 - 0.69 / height, subtitle, size=9.5, color=FAINT)
    names = list(dict.fromkeys(line.name for panel in panels for line in panel.lines))
    colours = {name: COLOURS[i % len(COLOURS)] for i, name in enumerate(names)}
    times = _time_range(panels)
    for number, panel in enumerate(panels):
        row, column = divmod(number, columns)
        x = _LEFT + column * (_PANEL_WIDTH + _BETWEEN)
        y = height - _TOP - row * (_PANEL_HEIGHT + _ABOVE) - _PANEL_HEIGHT
        axes = figure.add_axes(
            (x / width, y / height, _PANEL_WIDTH / width, _PANEL_HEIGHT / height)
        )
        _draw(axes, panel, colours, times, linear, time)
        if column == 0:
            axes.set_ylabel(error_label, color=INK, size=9)
        if number + columns >= len(panels):
            axes.set_xlabel(time.label, color=INK, size=9)
    return figure


def _columns(panels: int) -> int:
    """The fewest that need no more rows than _MOST_COLUMNS do: no row is left half empty."""
    rows = math.ceil(panels / _MOST_COLUMNS)
    return math.ceil(panels / rows)


def _time_range(panels: Sequence[Panel]) -> tuple[float, float]:
    marks = [mark for panel in panels for line in panel.lines for mark in line.marks]
    least_s, most_s = min(m.least_s for m in marks), max(m.most_s for m in marks)
    # To the right there has to be room for the names of the lines.
    span = max(most_s / least_s, 2.0)
    return least_s / span**0.05, most_s * span**0.32


def _draw(
    axes: Axes, panel: Panel, colours: dict[str, str], times: tuple[float, float], linear: bool,
    time: Axis,
) -> None:  # fmt: skip
    axes.set_xscale("log")
    axes.set_yscale("linear" if linear else "log")
    axes.set_xlim(*times)
    drawn = [line for line in panel.lines if line.marks]
    heights = [m.error for line in drawn for m in line.marks]
    heights += [line.bound for line in drawn if line.bound]
    least, most = min(heights, default=1.0), max(heights, default=1.0)
    if linear:
        margin = max(0.14 * (most - least), 0.02 * abs(most), 1e-6)
        axes.set_ylim(least - margin, most + margin)
    else:
        room = max((most / least) ** 0.14, 1.1)
        axes.set_ylim(least / room, most * room)
    _dress(axes, panel.title, linear, time)
    placed: list[float] = []
    # Names give way to where there is room: where errors are large, and where decibels are few.
    for line in sorted(drawn, key=lambda line: line.marks[-1].error, reverse=linear):
        _draw_line(axes, line, colours[line.name], times)
        _name(axes, line, colours[line.name], placed, downwards=linear)


def _dress(axes: Axes, title: str, linear: bool, time: Axis) -> None:
    """Frame, grid and ticks."""
    from matplotlib.ticker import (
        FixedLocator,
        FuncFormatter,
        LogLocator,
        MaxNLocator,
        NullFormatter,
        NullLocator,
    )  # fmt: skip

    axes.set_title(title, loc="left", size=10.5, weight="bold", color=INK, pad=7)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(FAINT)
    axes.grid(True, which="major", color=GRID, linewidth=0.7)
    axes.set_axisbelow(True)
    axes.tick_params(which="both", colors=FAINT, labelsize=8.5, length=3)
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value * time.per_s:g}"))
    low_s, high_s = axes.get_xlim()
    if high_s / low_s < 100:
        axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_locator(
        MaxNLocator(6) if linear else FixedLocator(round_values(*axes.get_ylim()))
    )
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _draw_line(axes: Axes, line: Line, colour: str, times: tuple[float, float]) -> None:
    from matplotlib.patheffects import withStroke

    if line.bound:
        axes.plot(times, [line.bound] * 2, color=colour, linewidth=1, dashes=(5, 3), zorder=1)
        axes.annotate(
            f"proved bound of {line.name}: {line.bound:g}", (times[0], line.bound), xytext=(5, 3),
            textcoords="offset points", size=7.5, color=colour, ha="left",
        )  # fmt: skip
    at_s, errors = [m.time_s for m in line.marks], [m.error for m in line.marks]
    axes.plot(at_s, errors, color=colour, linewidth=1.4, zorder=2)
    for mark in line.marks:
        axes.plot(
            [mark.least_s, mark.most_s], [mark.error] * 2, color=colour, linewidth=3.2,
            alpha=0.22, solid_capstyle="butt", zorder=1,
        )  # fmt: skip
        axes.plot(
            [mark.time_s], [mark.error], "o", markersize=5.5, zorder=3, markeredgecolor=colour,
            markerfacecolor="white" if mark.dominated else colour, markeredgewidth=1.2,
        )  # fmt: skip
    halo = [withStroke(linewidth=2.2, foreground="white")]
    for group in _close(axes, line.marks):
        middle_s = math.sqrt(group[0].time_s * group[-1].time_s)
        texts = [mark.text for mark in line.marks if mark in group]
        text = " ".join(texts if len(texts) <= _MOST_NAMED else [texts[0], "..", texts[-1]])
        axes.annotate(
            text, (middle_s, max(mark.error for mark in group)), xytext=(0, 5.5),
            textcoords="offset points", ha="center", size=7.5, color=colour, zorder=4,
            path_effects=halo,
        )  # fmt: skip


def _close(axes: Axes, marks: Sequence[Mark]) -> list[list[Mark]]:
    """Marks by time, those too close to each other to be named apart together."""
    groups: list[list[Mark]] = []
    for mark in sorted(marks, key=lambda m: m.time_s):
        (x, y), near = axes.transData.transform((mark.time_s, mark.error)), False
        if groups:
            last = groups[-1][-1]
            other_x, other_y = axes.transData.transform((last.time_s, last.error))
            near = x - other_x < _NEAR and abs(y - other_y) < _NEAR
        if near:
            groups[-1].append(mark)
        else:
            groups.append([mark])
    return groups


def _name(axes: Axes, line: Line, colour: str, placed: list[float], *, downwards: bool) -> None:
    """The line's name to the right of its last mark, moved away where another name is already."""
    last = line.marks[-1]
    right_s = max(m.most_s for m in line.marks if abs(_height(axes, m) - _height(axes, last)) < 4)
    share = _height(axes, last) / (_PANEL_HEIGHT * 100)
    # The number above the other line's last mark is cleared, too.
    step = 15 / (_PANEL_HEIGHT * 72)
    while any(abs(share - other) < step for other in placed):
        share += -step / 4 if downwards else step / 4
    placed.append(share)
    axes.annotate(
        line.name, (right_s, share), xycoords=axes.get_xaxis_transform(), xytext=(6, 0),
        textcoords="offset points", va="center", size=8.5, color=colour, weight="bold",
        annotation_clip=False,
    )  # fmt: skip


def _height(axes: Axes, mark: Mark) -> float:
    """How far above the bottom of the axes a mark is, in the figure's own pixels."""
    whole = _PANEL_HEIGHT * 100
    shown = axes.transData.transform((mark.time_s, mark.error))
    return float(axes.transAxes.inverted().transform(shown)[1]) * whole


def round_values(low: float, high: float) -> list[float]:
    """Three to eight round numbers from `low` to `high`, evenly spread on a logarithmic axis."""
    for steps in ((1.0,), (1.0, 3.0), (1.0, 2.0, 5.0), (1.0, 1.5, 2.0, 3.0, 5.0, 7.0)):
        found = _multiples(steps, low, high)
        if len(found) >= 3:
            return found
    unit = 10.0 ** math.floor(math.log10(high - low))
    for size in (unit, unit / 2, unit / 5, unit / 10):
        first = math.ceil(low / size - 1e-9)
        found = [size * i for i in range(first, math.floor(high / size + 1e-9) + 1)]
        if len(found) >= 3:
            break
    return found


def _multiples(steps: Sequence[float], low: float, high: float) -> list[float]:
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    values: list[Any] = [step * 10.0**decade for decade in decades for step in steps]
    return [value for value in values if low <= value <= high]
