"""Work-precision diagrams: error against time, one panel per problem, one line per method.

Settings of a method are marks joined in order, each on a band from its shortest to its longest
time; hollow marks are dominated. Dashed lines in a method's colour are proved bounds. Names are
beside their lines; names without room are in the legend."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import chain
from operator import attrgetter
from statistics import median
from typing import TYPE_CHECKING

from nscc.mappings import NamedValues
from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.labels import ChartLabel, place_labels
from nscc_runtime.pictures.sheet import theme

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_EXACT = 1e-7
"""On a logarithmic axis, errors below this fraction of the largest error are drawn at the end of
the axis, pointing down."""
_COLUMNS = 2
"""Number of panels side by side."""


@dataclass(frozen=True)
class Point:
    """One method at one setting, measured several times on one problem.

    Points with the same `case` and `error_unit` are comparable. A smaller `error` is better unless
    `more_is_better`, as for PSNR. `times_ms` are all measured times, one or more. `bound` is a
    lower bound for all settings of the method, None if unknown. `device` is the device of the times
    if it differs from that of most points, else ""."""

    case: str
    method: str
    setting: str
    error: float
    error_unit: str
    times_ms: tuple[float, ...]
    bound: float | None = None
    more_is_better: bool = False
    device: str = ""

    @property
    def badness(self) -> float:
        """The error, negated if a larger value is better."""
        return -self.error if self.more_is_better else self.error

    @property
    def time_ms(self) -> float:
        """The median time in milliseconds."""
        return median(self.times_ms)

    @property
    def spread_ms(self) -> float:
        """The difference between the longest and the shortest time in milliseconds."""
        return max(self.times_ms) - min(self.times_ms)


def dominated(points: Sequence[Point]) -> list[bool]:
    """Return for each of `points`, in their order, whether another point of its case and unit
    dominates it.

    A dominating point is no worse in error and time, and better in one of them. Of equal points
    none dominates the other."""
    flags = []
    for point in points:
        mine, kind = (point.badness, point.time_ms), (point.case, point.error_unit)
        rivals = ((p.badness, p.time_ms) for p in points if (p.case, p.error_unit) == kind)
        flags.append(any(e <= mine[0] and t <= mine[1] and (e, t) != mine for e, t in rivals))
    return flags


@dataclass(frozen=True)
class Guide:
    """A reference line with a pattern of dashes (a line style of matplotlib, such as "--"):
    vertical at `time_ms`, or horizontal at `error`. The other one is None."""

    name: str
    dashes: str
    time_ms: float | None = None
    error: float | None = None


@dataclass(frozen=True)
class Panel:
    """One panel of a diagram of error against time: its title, the label of its error axis
    (`error`), its points, and reference lines. Panels with the same label have one scale."""

    title: str
    error: str
    points: Sequence[Point]
    guides: tuple[Guide, ...] = ()


@dataclass(frozen=True)
class PointReading:
    """The mapping of points to a diagram.

    `time`: label of the time axis. `per_ms`: its units per millisecond. `line`: returns the name of
    a point's line ("": the point only counts for dominance). `text`: returns a point's label, ""
    for none. `linear`: whether the error axis, in decibels, is linear instead of logarithmic."""

    time: str
    per_ms: float = 1.0
    line: Callable[[Point], str] = attrgetter("method")
    text: Callable[[Point], str] = attrgetter("setting")
    linear: bool = False

    def lines(self, points: Sequence[Point]) -> dict[str, list[Point]]:
        """Return `points` by the name of the line on which they are drawn, in their order, without
        those that have no line or no finite error."""
        points_by_line: dict[str, list[Point]] = {}
        for point in points:
            if self.line(point) and math.isfinite(point.error):
                points_by_line.setdefault(self.line(point), []).append(point)
        return points_by_line

    def times(self, point: Point) -> list[float]:
        """Return median, minimum and maximum of a point's time, in units of the time axis."""
        times_ms = (point.time_ms, min(point.times_ms), max(point.times_ms))
        return [time_ms * self.per_ms for time_ms in times_ms]


def precision_diagram(
    problems: Sequence[Panel], title: str, note: str, reading: PointReading
) -> Figure:
    """Return a figure of error against time with one panel for each of `problems`, all with one
    time scale, under `title` and above `note`.

    `reading` says on which line a point lies and which times it has. Raises ValueError without
    points that can be drawn."""
    from matplotlib.lines import Line2D

    points = [point for panel in problems for point in panel.points]
    beaten = dict(zip(map(id, points), dominated(points), strict=True))
    lines = reading.lines(points)
    if not lines:
        raise ValueError("there are no points to draw: no point belongs to a line")
    looks = {name: theme().of(number) for number, name in enumerate(lines)}
    guides = {guide.name: guide for panel in problems for guide in panel.guides}
    drawn_points = [*chain.from_iterable(lines.values())]
    times = [time for point in drawn_points for time in reading.times(point)]
    times += [g.time_ms * reading.per_ms for p in problems for g in p.guides if g.time_ms]
    # A margin in proportion to the length of the logarithmic axis; at least that of a factor of 3.
    room = max(max(times) / min(times), 3.0) ** 0.06
    columns = min(_COLUMNS, len(problems))
    figure, grid = sheet.panels(len(problems), (sheet.WIDTH / max(columns, 1.4), 3.1), columns)
    labels = []
    heights: dict[str, list[float]] = {}
    for panel in problems:
        panel_heights = heights.setdefault(panel.error, [])
        for line in reading.lines(panel.points).values():
            panel_heights.extend(point.error for point in line)
            panel_heights.extend([line[0].bound] if line[0].bound else [])
        panel_heights.extend(guide.error for guide in panel.guides if guide.error)
    for number, (axes, panel) in enumerate(zip(grid, problems, strict=True)):
        _set_errors(axes, heights[panel.error] or [1.0], reading.linear)
        axes.set_xscale("log")
        axes.set_xlim(min(times) / room, max(times) * room)
        sheet.round_ticks(axes.xaxis)
        labels.append(_draw(axes, panel, looks, reading, beaten))
        axes.set_title(panel.title)
        if number % columns == 0 or panel.error != problems[number - 1].error:
            axes.set_ylabel(panel.error)
        if number + columns >= len(problems):
            axes.set_xlabel(reading.time)
    figure.align_ylabels(grid)
    sheet.lay_out(figure)
    homeless = {
        label.text
        for axes, texts in zip(grid, labels, strict=True)
        for label in place_labels(axes, texts)
        if label.name
    }
    handles = [Line2D([], [], label=n, **style) for n, style in looks.items() if n in homeless]
    if any(point.bound for point in drawn_points):
        handles.append(Line2D([], [], label="proved bound", color=theme().faint, linestyle="--"))
    handles += [
        Line2D([], [], label=g.name, color=theme().ink, ls=g.dashes) for g in guides.values()
    ]
    sheet.head(figure, title, note, handles)
    return figure


def _draw(
    axes: Axes,
    panel: Panel,
    looks: dict[str, NamedValues],
    reading: PointReading,
    beaten: dict[int, bool],
) -> list[ChartLabel]:
    """Draw the lines of `panel` with their bounds into `axes`; return the labels to place: names of
    lines, points that are not dominated, other points.

    `looks` gives each line's colour and marker by name. `beaten` says by `id` of a point whether
    another point dominates it."""
    lines = reading.lines(panel.points)
    bottom = axes.get_ylim()[0]
    names, labels = [], []
    for name, line_points in lines.items():
        colour, marker = looks[name]["color"], looks[name]["marker"]
        times = [reading.times(point) for point in line_points]
        errors = [max(point.error, bottom) for point in line_points]
        medians, least, most = zip(*times, strict=True)
        axes.plot(medians, errors, color=colour)
        axes.hlines(errors, least, most, colour, linewidth=3.2, alpha=0.25)
        for point, time, error in zip(line_points, medians, errors, strict=True):
            hollow = beaten[id(point)]
            axes.plot(
                time,
                error,
                marker if point.error >= bottom else "v",
                color=colour,
                markerfacecolor=theme().paper if hollow else colour,
                clip_on=False,
                zorder=3,
            )
            # A method with a single setting is described by its text.
            text, sought = reading.text(point), len(line_points) == 1
            labels.append((hollow, ChartLabel(text, time, error, colour, sought=sought)))
        names.append(ChartLabel(name, medians[-1], errors[-1], colour, name=True))
        bound = line_points[0].bound
        if bound:
            axes.axhline(bound, color=colour, linewidth=1, linestyle="--")
            left_time, right_time = axes.get_xlim()
            edge = left_time * (right_time / left_time) ** 0.05
            labels.append((False, ChartLabel(f"{bound:g}", edge, bound, colour)))
    for guide in panel.guides:
        line: NamedValues = {"color": theme().ink, "lw": 1.1, "ls": guide.dashes, "zorder": 1}
        if guide.time_ms:
            axes.axvline(guide.time_ms * reading.per_ms, **line)
        elif guide.error:
            axes.axhline(guide.error, **line)
    return names + [label for _, label in sorted(labels, key=lambda pair: pair[0])]


def _set_errors(axes: Axes, heights: Sequence[float], linear: bool) -> None:
    """Set the scale of the error axis, linear or logarithmic, with margins around `heights`, one or
    more errors. A logarithmic axis ends at `_EXACT` of the largest."""
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
