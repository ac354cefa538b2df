"""The emulator's work-precision diagram: a column for each scene, error in electrons above, in LSB
below, against the time of a frame."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from nscc_runtime.diagram import COLOURS, FAINT, GRID, INK, Mark, png_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_WIDTH, _HEIGHT = 3.9, 2.7
_LEFT, _RIGHT, _TOP, _BOTTOM = 0.85, 0.3, 1.6, 0.65
_BETWEEN, _ABOVE, _APART = 0.55, 0.3, 0.95
_MOST_COLUMNS = 4
_FLOOR_COLOUR, _REFERENCE_COLOUR = "#6b7280", "#1d2129"
_LINE = 11.0
"""Marks less far apart in height, in the figure's own pixels (100 an inch), share one name."""
_EXACT = 1e-6
"""Errors below this part of the resolution are drawn at the bottom edge, pointing down."""
_WIDE = 12.5
"""Inches that the legend needs in one line."""


@dataclass(frozen=True)
class Curve:
    """A method's marks in order. A `faint` curve has the colour of the one before it."""

    name: str
    marks: tuple[Mark, ...]
    faint: bool = False


@dataclass(frozen=True)
class Cell:
    """One scene in one unit: curves, the reference's own time, and what cannot be passed.

    `resolution`: the error that two runs of the reference differ by. `floor_s`: the time that
    reading the scene takes.
    """

    curves: tuple[Curve, ...]
    reference: Mark
    resolution: float
    floor_s: float


@dataclass(frozen=True)
class Column:
    """A scene: a cell for each unit."""

    title: str
    cells: tuple[Cell, ...]


def precision_png(columns: Sequence[Column], units: Sequence[str], subtitle: str) -> bytes:
    """The diagram as PNG; `units` label the rows. Raises ValueError where there is no scene."""
    if not columns:
        raise ValueError("no scene to draw")
    return png_of(lambda: _figure(columns, units, subtitle))


def _figure(columns: Sequence[Column], units: Sequence[str], subtitle: str) -> Figure:
    from matplotlib.figure import Figure

    blocks, down = math.ceil(len(columns) / _MOST_COLUMNS), len(units)
    across = math.ceil(len(columns) / blocks)
    tall = down * _HEIGHT + (down - 1) * _ABOVE
    width = max(_LEFT + across * _WIDTH + (across - 1) * _BETWEEN + _RIGHT, 9.4)
    height = _TOP + blocks * tall + (blocks - 1) * _APART + _BOTTOM
    figure = Figure(figsize=(width, height), facecolor="white")
    title = "What the emulator's time buys"
    figure.text(0.25 / width, 1 - 0.42 / height, title, size=15, weight="bold", color=INK)
    figure.text(0.25 / width, 1 - 0.69 / height, subtitle, size=9.5, color=FAINT)
    colours = _colours(columns)
    times = _times(columns)
    panel = (width - _LEFT - _RIGHT - (across - 1) * _BETWEEN) / across
    for number, column in enumerate(columns):
        block, i = divmod(number, across)
        for j, cell in enumerate(column.cells):
            x = _LEFT + i * (panel + _BETWEEN)
            y = height - _TOP - block * (tall + _APART) - j * (_HEIGHT + _ABOVE) - _HEIGHT
            axes = figure.add_axes((x / width, y / height, panel / width, _HEIGHT / height))
            _draw(axes, cell, colours, times)
            if j == 0:
                axes.set_title(column.title, loc="left", size=10.5, weight="bold", color=INK, pad=7)
            if i == 0:
                axes.set_ylabel(units[j], color=INK, size=9)
                axes.yaxis.set_label_coords(-0.6 / panel, 0.5)
            if j == down - 1:
                axes.set_xlabel("time of one frame, ms", color=INK, size=9)
            else:
                axes.tick_params(labelbottom=False)
    _legend(figure, columns, colours, (width, height))
    return figure


def _curves(columns: Sequence[Column]) -> Iterator[Curve]:
    for column in columns:
        for cell in column.cells:
            yield from cell.curves


def _colours(columns: Sequence[Column]) -> dict[str, str]:
    found: dict[str, str] = {}
    colour = COLOURS[0]
    for curve in _curves(columns):
        if curve.name not in found:
            if not curve.faint:
                strong = set(found.values())
                colour = next((c for c in COLOURS if c not in strong), COLOURS[-1])
            found[curve.name] = colour
    return found


def _times(columns: Sequence[Column]) -> tuple[float, float]:
    cells = [cell for column in columns for cell in column.cells]
    marks = [m for cell in cells for curve in cell.curves for m in (*curve.marks, cell.reference)]
    least = min([m.least_s for m in marks] + [cell.floor_s for cell in cells])
    most = max(m.most_s for m in marks)
    room = max(most / least, 10.0) ** 0.05
    return least / room * 1e3, most * room * 1e3


def _draw(axes: Axes, cell: Cell, colours: dict[str, str], times: tuple[float, float]) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(*times)
    errors = [m.error for curve in cell.curves for m in curve.marks]
    errors = [e for e in (*errors, cell.resolution) if 0 < e < math.inf] or [1.0]
    least = min(e for e in errors if e >= _EXACT * min(cell.resolution or math.inf, max(errors)))
    most = max(errors)
    room = max((most / least) ** 0.12, 1.3)
    bottom, top = least / room, most * room
    axes.set_ylim(bottom, top)
    _dress(axes)
    axes.axvline(cell.floor_s * 1e3, color=_FLOOR_COLOUR, linewidth=1.2, dashes=(1.2, 1.6))
    if cell.resolution > 0:
        axes.axhline(cell.resolution, color=_FLOOR_COLOUR, linewidth=1.1, dashes=(5, 3))
    axes.axvspan(
        cell.reference.least_s * 1e3, cell.reference.most_s * 1e3, color=_REFERENCE_COLOUR,
        alpha=0.08, linewidth=0,
    )  # fmt: skip
    axes.axvline(cell.reference.time_s * 1e3, color=_REFERENCE_COLOUR, linewidth=1.4)
    for curve in cell.curves:
        _draw_curve(axes, curve, colours[curve.name], bottom)


def _draw_curve(axes: Axes, curve: Curve, colour: str, bottom: float) -> None:
    marks = [mark for mark in curve.marks if mark.error < math.inf]
    drawn = [max(mark.error, bottom) for mark in marks]
    strength = 0.4 if curve.faint else 1.0
    axes.plot(
        [m.time_s * 1e3 for m in marks], drawn, color=colour, linewidth=1.4, alpha=strength,
        zorder=2, solid_joinstyle="round",
    )  # fmt: skip
    for mark, error in zip(marks, drawn, strict=True):
        if not curve.faint:
            axes.plot(
                [mark.least_s * 1e3, mark.most_s * 1e3], [error] * 2, color=colour, linewidth=3.2,
                alpha=0.2, solid_capstyle="butt", zorder=1,
            )  # fmt: skip
        hollow = mark.dominated or curve.faint
        axes.plot(
            [mark.time_s * 1e3], [error], "o" if mark.error > bottom else "v",
            markersize=3.6 if curve.faint else 5.8, alpha=strength, zorder=3, clip_on=False,
            markeredgecolor=colour, markerfacecolor="white" if hollow else colour,
            markeredgewidth=1.2,
        )  # fmt: skip
    if not curve.faint:
        _name_marks(axes, [(m, e) for m, e in zip(marks, drawn, strict=True) if m.text], colour)


def _name_marks(axes: Axes, marks: Sequence[tuple[Mark, float]], colour: str) -> None:
    """Each mark's text to its left; marks as high as each other are named together."""
    from matplotlib.patheffects import withStroke

    groups: list[list[tuple[Mark, float]]] = []
    for mark, error in sorted(marks, key=lambda pair: pair[1]):
        height = axes.transData.transform((1.0, error))[1]
        if groups and height - axes.transData.transform((1.0, groups[-1][-1][1]))[1] < _LINE:
            groups[-1].append((mark, error))
        else:
            groups.append([(mark, error)])
    for group in groups:
        at_s = min(mark.least_s for mark, _ in group)
        text = " ".join(mark.text for mark, _ in marks if any(mark is m for m, _ in group))
        axes.annotate(
            text, (at_s * 1e3, max(error for _, error in group)), xytext=(-6, 0),
            textcoords="offset points", ha="right", va="center", size=7.5, color=colour, zorder=4,
            path_effects=[withStroke(linewidth=2.2, foreground="white")],
        )  # fmt: skip


def _dress(axes: Axes) -> None:
    """Frame, grid and ticks: powers of ten."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter, NullLocator

    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(FAINT)
    axes.grid(True, which="major", color=GRID, linewidth=0.7)
    axes.set_axisbelow(True)
    axes.tick_params(which="both", colors=FAINT, labelsize=8.5, length=3)
    for axis in (axes.xaxis, axes.yaxis):
        low, high = axis.get_view_interval()
        subs = (1.0,) if high / low > 50 else (1.0, 3.0)
        axis.set_major_locator(LogLocator(subs=subs, numticks=12))
        axis.set_minor_locator(NullLocator())
        axis.set_minor_formatter(NullFormatter())
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def _legend(
    figure: Figure, columns: Sequence[Column], colours: dict[str, str], size: tuple[float, float]
) -> None:
    from matplotlib.lines import Line2D

    faint = {curve.name for curve in _curves(columns) if curve.faint}
    entries = [
        Line2D(
            [], [], color=colour, linewidth=1.4, marker="o", markersize=5,
            alpha=0.4 if name in faint else 1.0,
            markerfacecolor="white" if name in faint else colour, label=name,
        )
        for name, colour in colours.items()
    ]  # fmt: skip
    entries += [
        Line2D([], [], color=_REFERENCE_COLOUR, linewidth=1.4, label="reference (no error)"),
        Line2D(
            [], [], color=_FLOOR_COLOUR, linewidth=1.1, dashes=(5, 3),
            label="two references, other draws",
        ),
        Line2D(
            [], [], color=_FLOOR_COLOUR, linewidth=1.2, dashes=(1.2, 1.6), label="reading the scene"
        ),
    ]  # fmt: skip
    legend = figure.legend(
        handles=entries, loc="upper left", bbox_to_anchor=(0.2 / size[0], 1 - 0.78 / size[1]),
        ncols=len(entries) if size[0] > _WIDE else 4, frameon=False, fontsize=8.5,
        handlelength=2.2, columnspacing=1.6, borderpad=0, handletextpad=0.6,
    )  # fmt: skip
    for text in legend.get_texts():
        text.set_color(INK)
