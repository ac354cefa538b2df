"""Diagrams of a planner's promise: tolerance asked against error measured, and what each effect of
a scene does to the exposure, simulated or left out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from nscc_runtime.diagram import COLOURS, FAINT, GRID, INK, png_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_KEPT, _DROPPED, _BROKEN = "#2563a8", "#d9722b", "#c2405a"
_BAR = 0.235
"""Inches from bar to bar."""
_MOST_COLUMNS = 3
_MARKERS = "osD^vP"


@dataclass(frozen=True)
class Promise:
    """One plan of a scene: electrons asked, predicted and measured."""

    scene: str
    asked_e: float
    predicted_e: float
    measured_e: float


@dataclass(frozen=True)
class Bar:
    """An effect of a budget: RMS electrons (None where it has no place before the ADC), and the
    milliseconds that leaving it out saves, by a model."""

    name: str
    choice: Literal["kept", "dropped", "absent"]
    rms_e: float | None
    cost_ms: float


@dataclass(frozen=True)
class Budget:
    """A scene's plan, effect by effect."""

    scene: str
    tolerance_e: float
    predicted_e: float
    bars: tuple[Bar, ...]


def calibration_png(promises: Sequence[Promise], slack: float) -> bytes:
    """Asked against measured as PNG, with y = x and y = `slack` x. ValueError for no promises."""
    if not promises:
        raise ValueError("no promises to draw")
    return png_of(lambda: _calibration(promises, slack))


def budget_png(budgets: Sequence[Budget]) -> bytes:
    """A panel of bars for each scene as PNG. ValueError for no budgets."""
    if not budgets:
        raise ValueError("no budgets to draw")
    return png_of(lambda: _budgets(budgets))


def _calibration(promises: Sequence[Promise], slack: float) -> Figure:
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

    figure = Figure(figsize=(6.6, 6.2), facecolor="white")
    _head(figure, "What was asked, what came of it", "RMS electrons before the ADC, worst bucket")
    axes = figure.add_axes((0.115, 0.1, 0.85, 0.745))
    axes.set_xscale("log")
    axes.set_yscale("log")
    asked = [each.asked_e for each in promises]
    least, most = min(asked) / 1.5, max(asked) * 1.5
    found = [e for each in promises for e in (each.predicted_e, each.measured_e)]
    low = min([e for e in found if e > least / 30] + [least]) / 1.5
    high = max([most * slack, *(e * 1.2 for e in found if e < math.inf)])
    axes.set_xlim(least, most)
    axes.set_ylim(low, high)
    _grid(axes, both=True)
    line = [least, most]
    above = [slack * x for x in line]
    axes.fill_between(line, above, [high] * 2, color=_BROKEN, alpha=0.06, linewidth=0)
    axes.plot(line, line, color=INK, linewidth=1.2)
    axes.plot(line, above, color=_BROKEN, linewidth=1.2, dashes=(5, 3))
    names = list(dict.fromkeys(each.scene for each in promises))
    for i, name in enumerate(names):
        colour, marker = COLOURS[i % len(COLOURS)], _MARKERS[i % len(_MARKERS)]
        # Scenes side by side, so that none hides another.
        shift = 1.0 + 0.05 * (i - (len(names) - 1) / 2)
        for each in (p for p in promises if p.scene == name):
            x = each.asked_e * shift
            measured, predicted = (max(e, low) for e in (each.measured_e, each.predicted_e))
            axes.plot([x, x], [predicted, measured], color=colour, linewidth=1, alpha=0.6)
            axes.plot(
                x, predicted, marker, markersize=9, markerfacecolor="none", markeredgecolor=colour,
                markeredgewidth=1, clip_on=False,
            )  # fmt: skip
            axes.plot(x, measured, marker, markersize=4.5, color=colour, clip_on=False)
            if each.measured_e < low:
                axes.annotate(
                    f"{each.measured_e:.1g}", (x, low), xytext=(0, 9), ha="center", size=7.5,
                    textcoords="offset points", color=colour,
                )  # fmt: skip
    axes.set_xlabel("tolerance asked, e", color=INK, size=9)
    axes.set_ylabel("error, e", color=INK, size=9)

    def dot(size: float, fill: str, label: str) -> Line2D:
        return Line2D(
            [], [], color=FAINT, linestyle="", marker="o", markersize=size, markerfacecolor=fill,
            label=label,
        )  # fmt: skip

    promise = f"y = {slack:g} x: the promise"
    entries = [
        Line2D([], [], color=INK, linewidth=1.2, label="y = x"),
        Line2D([], [], color=_BROKEN, linewidth=1.2, dashes=(5, 3), label=promise),
        dot(4.5, FAINT, "measured"),
        dot(9, "none", "predicted"),
    ]
    entries += [
        Line2D(
            [], [], color=COLOURS[i % len(COLOURS)], linestyle="", markersize=5,
            marker=_MARKERS[i % len(_MARKERS)], label=name,
        )
        for i, name in enumerate(names)
    ]  # fmt: skip
    axes.legend(handles=entries, loc="upper left", frameon=False, fontsize=8.5, labelcolor=INK)
    return figure


def _budgets(budgets: Sequence[Budget]) -> Figure:
    from matplotlib.figure import Figure

    rows = math.ceil(len(budgets) / _MOST_COLUMNS)
    columns = math.ceil(len(budgets) / rows)
    most = max(len(budget.bars) for budget in budgets)
    left, right, top, bottom, between, above, panel = 0.95, 0.75, 1.3, 0.95, 1.75, 0.95, 2.75
    tall = most * _BAR
    width = left + columns * panel + (columns - 1) * between + right
    width = max(width, 8.2)
    height = top + rows * tall + (rows - 1) * above + bottom
    figure = Figure(figsize=(width, height), facecolor="white")
    _head(
        figure,
        "Error budgets: what each effect does, and what is left out",
        "RMS electrons of each effect; at the right, ms a frame that leaving it out saves (model)",
    )
    panel = (width - left - right - (columns - 1) * between) / columns
    values = [b.rms_e for budget in budgets for b in budget.bars if b.rms_e]
    values += [budget.tolerance_e for budget in budgets]
    span = (max(min(values), max(values) * 1e-6) / 2, max(values) * 2)
    for number, budget in enumerate(budgets):
        row, column = divmod(number, columns)
        x = left + column * (panel + between)
        y = height - top - row * (tall + above) - tall
        axes = figure.add_axes((x / width, y / height, panel / width, tall / height))
        _bars(axes, budget, span)
    _budget_legend(figure, (width, height))
    return figure


def _bars(axes: Axes, budget: Budget, span: tuple[float, float]) -> None:
    axes.set_xscale("log")
    axes.set_xlim(*span)
    count = len(budget.bars)
    axes.set_ylim(count - 0.4, -0.6)
    _grid(axes, both=False)
    for i, bar in enumerate(budget.bars):
        drawn = bar.rms_e is not None and bar.rms_e > span[0] and bar.choice != "absent"
        if drawn and bar.rms_e is not None:
            kept = bar.choice == "kept"
            axes.barh(
                i, bar.rms_e - span[0], left=span[0], height=0.62, linewidth=1.1,
                facecolor=_KEPT if kept else "white", edgecolor=_KEPT if kept else _DROPPED,
            )  # fmt: skip
        elif bar.choice == "absent":
            axes.text(
                span[0] * (span[1] / span[0]) ** 0.015, i, "absent", size=7.5, color=FAINT,
                va="center", style="italic",
            )  # fmt: skip
        if bar.choice != "absent":
            axes.annotate(
                f"{bar.cost_ms:.2g} ms" if bar.cost_ms else "free", (1.0, i),
                xycoords=("axes fraction", "data"), xytext=(5, 0), textcoords="offset points",
                size=8, color=_KEPT if bar.choice == "kept" else _DROPPED, va="center",
            )  # fmt: skip
    axes.axvline(budget.tolerance_e, color=INK, linewidth=1.2)
    axes.axvline(budget.predicted_e, color=_DROPPED, linewidth=1.2, dashes=(4, 2))
    axes.set_yticks(range(count), [bar.name for bar in budget.bars])
    for label, bar in zip(axes.get_yticklabels(), budget.bars, strict=True):
        label.set_color(FAINT if bar.choice == "absent" else INK)
    axes.tick_params(axis="y", length=0)
    axes.set_title(budget.scene, loc="left", size=10.5, weight="bold", color=INK, pad=20)
    axes.annotate(
        f"{budget.tolerance_e:g} e asked, {budget.predicted_e:.3g} e predicted", (0, 1),
        xycoords="axes fraction", xytext=(0, 7), textcoords="offset points", size=8.5, color=FAINT,
    )  # fmt: skip
    axes.set_xlabel("RMS, e", color=INK, size=9)


def _budget_legend(figure: Figure, size: tuple[float, float]) -> None:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    entries = [
        Patch(facecolor=_KEPT, edgecolor=_KEPT, label="simulated"),
        Patch(facecolor="white", edgecolor=_DROPPED, label="left out"),
        Line2D([], [], color=INK, linewidth=1.2, label="tolerance asked"),
        Line2D([], [], color=_DROPPED, linewidth=1.2, dashes=(4, 2), label="predicted error"),
    ]
    figure.legend(
        handles=entries, loc="lower left", bbox_to_anchor=(0.2 / size[0], 0.12 / size[1]),
        ncols=len(entries), frameon=False, fontsize=8.5, labelcolor=INK,
    )  # fmt: skip


def _head(figure: Figure, title: str, subtitle: str) -> None:
    width, height = figure.get_size_inches()
    figure.text(0.25 / width, 1 - 0.42 / height, title, size=15, weight="bold", color=INK)
    figure.text(0.25 / width, 1 - 0.69 / height, subtitle, size=9.5, color=FAINT)


def _grid(axes: Axes, both: bool) -> None:
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(FAINT)
    axes.grid(True, axis="both" if both else "x", which="major", color=GRID, linewidth=0.7)
    axes.set_axisbelow(True)
    axes.tick_params(which="both", colors=FAINT, labelsize=8.5, length=3)
    for axis in (axes.xaxis, axes.yaxis) if both else (axes.xaxis,):
        low, high = axis.get_view_interval()
        subs = (1.0,) if high / low > 5000 else (1.0, 2.0, 5.0)
        axis.set_major_locator(LogLocator(subs=subs, numticks=12))
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
