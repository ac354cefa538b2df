"""Work-precision diagrams: error against time, a panel for each problem, a line for each method.

Settings of a method are marks joined in their order, each on a band from its shortest to its
longest time; a hollow one is dominated. Dashed lines in a method's colour are proved bounds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from nscc.tradeoff.points import Point, dominated
from nscc_runtime.pictures import sheet

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_EXACT = 1e-7
"""On a logarithmic axis errors below this part of the largest are at its end, pointing down."""
_COLUMNS = 2


@dataclass(frozen=True)
class Guide:
    """A line across a panel, at a time or at an error, to hold the methods against."""

    name: str
    dashes: str
    time_ms: float | None = None
    error: float | None = None


@dataclass(frozen=True)
class Panel:
    """A problem: what its error is, its points and guides."""

    title: str
    error: str
    points: Sequence[Point]
    guides: tuple[Guide, ...] = ()


@dataclass(frozen=True)
class Reading:
    """How points are read: the label of the time axis and how many of its units a millisecond has,
    the line of a point (none: it only counts for who is dominated) and the text beside it.

    `linear` is the error axis of decibels; the other one is logarithmic.
    """

    time: str
    per_ms: float = 1.0
    line: Callable[[Point], str] = attrgetter("method")
    text: Callable[[Point], str] = attrgetter("setting")
    linear: bool = False

    def lines(self, points: Sequence[Point]) -> dict[str, list[Point]]:
        """What is drawn of these points."""
        found: dict[str, list[Point]] = {}
        for point in points:
            if self.line(point) and math.isfinite(point.error):
                found.setdefault(self.line(point), []).append(point)
        return found

    def times(self, point: Point) -> list[float]:
        """Median, least and most on the time axis."""
        every = (point.time_ms, min(point.times_ms), max(point.times_ms))
        return [time_ms * self.per_ms for time_ms in every]


def precision_diagram(problems: Sequence[Panel], title: str, note: str, reading: Reading) -> Figure:
    """All panels, with one scale of time. Raises ValueError where there is nothing to draw."""
    from matplotlib.lines import Line2D

    points = [point for panel in problems for point in panel.points]
    beaten = dict(zip(map(id, points), dominated(points), strict=True))
    lines = reading.lines(points)
    if not lines:
        raise ValueError("no points to draw")
    looks = {name: sheet.series(number) for number, name in enumerate(lines)}
    guides = {guide.name: guide for panel in problems for guide in panel.guides}
    times = [time for part in lines.values() for point in part for time in reading.times(point)]
    times += [g.time_ms * reading.per_ms for p in problems for g in p.guides if g.time_ms]
    room = max(max(times) / min(times), 3.0) ** 0.06
    columns = min(_COLUMNS, len(problems))
    figure, grid = sheet.panels(len(problems), (sheet.WIDTH / max(columns, 1.4), 3.1), columns)
    labels = []
    for number, (axes, panel) in enumerate(zip(grid, problems, strict=True)):
        axes.set_xscale("log")
        axes.set_xlim(min(times) / room, max(times) * room)
        sheet.round_ticks(axes.xaxis)
        labels.append(_draw(axes, panel, looks, reading, beaten))
        axes.set_title(panel.title)
        if number % columns == 0 or panel.error != problems[number - 1].error:
            axes.set_ylabel(panel.error)
        if number + columns >= len(problems):
            axes.set_xlabel(reading.time)
    handles = [Line2D([], [], label=name, **look) for name, look in looks.items()]
    if any(point.bound for part in lines.values() for point in part):
        handles.append(Line2D([], [], label="proved bound", color=sheet.FAINT, linestyle="--"))
    handles += [Line2D([], [], label=g.name, color=sheet.INK, ls=g.dashes) for g in guides.values()]
    figure.align_ylabels(grid)
    sheet.head(figure, title, note, handles)
    for axes, texts in zip(grid, labels, strict=True):
        sheet.label_points(axes, texts)
    return figure


def _draw(
    axes: Axes, panel: Panel, looks: dict[str, dict[str, Any]], reading: Reading,
    beaten: dict[int, bool],
) -> list[tuple[float, float, str, str]]:  # fmt: skip
    """Draws lines and guides; the texts that go with points, those that nothing beats first."""
    lines = reading.lines(panel.points)
    bounds = {name: part[0].bound for name, part in lines.items() if part[0].bound}
    heights = [point.error for part in lines.values() for point in part]
    heights += [*bounds.values(), *(guide.error for guide in panel.guides if guide.error)]
    bottom = _set_errors(axes, heights or [1.0], reading.linear)
    labels = []
    for name, part in lines.items():
        colour, marker = looks[name]["color"], looks[name]["marker"]
        times = [reading.times(point) for point in part]
        errors = [max(point.error, bottom) for point in part]
        medians, least, most = zip(*times, strict=True)
        axes.plot(medians, errors, color=colour)
        axes.hlines(errors, least, most, colour, linewidth=3.2, alpha=0.25)
        for point, time, error in zip(part, medians, errors, strict=True):
            hollow = beaten[id(point)]
            axes.plot(
                time, error, marker if point.error >= bottom else "v", color=colour,
                markerfacecolor="white" if hollow else colour, clip_on=False, zorder=3,
            )  # fmt: skip
            labels.append((hollow, (time, error, reading.text(point), colour)))
        if name in bounds:
            axes.axhline(bounds[name], color=colour, linewidth=1, linestyle="--")
            left, right = axes.get_xlim()
            edge = left * (right / left) ** 0.05
            labels.append((False, (edge, bounds[name], f"{bounds[name]:g}", colour)))
    for guide in panel.guides:
        look: dict[str, Any] = {"color": sheet.INK, "lw": 1.1, "ls": guide.dashes, "zorder": 1}
        if guide.time_ms:
            axes.axvline(guide.time_ms * reading.per_ms, **look)
        elif guide.error:
            axes.axhline(guide.error, **look)
    return [label for _, label in sorted(labels, key=lambda pair: pair[0])]


def _set_errors(axes: Axes, heights: Sequence[float], linear: bool) -> float:
    """Scale, limits and ticks of the error axis; its lower end."""
    if linear:
        least, most = min(heights), max(heights)
        margin = max(0.14 * (most - least), 0.02 * abs(most), 1e-6)
        axes.set_ylim(least - margin, most + margin)
    else:
        most = max(heights) or 1.0
        least = min(height for height in (*heights, most) if height >= _EXACT * most)
        margin = max((most / least) ** 0.14, 1.15)
        axes.set_yscale("log")
        axes.set_ylim(least / margin, most * margin)
    sheet.round_ticks(axes.yaxis)
    return axes.get_ylim()[0]
