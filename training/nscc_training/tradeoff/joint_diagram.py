"""The picture of the joint tradeoff: error against time, a front for each stage."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from nscc.tradeoff.points import Point, dominated
from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.labels import Label, place_labels
from nscc_runtime.pictures.look import look

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from nscc_training.tradeoff.joint import Joint

_WIDTH, _HEIGHT = 8.4, 5.2
_EXACT = 1e-4
"""Errors below this part of the target are at the lower edge, pointing down."""
_MARKERS = "osD^P"
"""Of the stages: a mark that points down is an error of nothing."""
_ROOM = 0.05
"""Of an axis beyond its outermost points."""


def joint_diagram(joint: Joint, repeats: int, device: str) -> Figure:
    """Every point of every stage on one axis of error and one of time. ValueError for none."""
    from matplotlib.lines import Line2D
    from matplotlib.ticker import EngFormatter

    if not joint.points:
        raise ValueError("no points to draw")
    figure, [axes] = sheet.panels(1, (_WIDTH, _HEIGHT), 1)
    bottom = _set_limits(axes, joint)
    beaten = dict(zip(map(id, joint.points), dominated(joint.points), strict=True))
    labels: list[Label] = []
    keys: dict[int, Line2D] = {}
    for number, each in enumerate(joint.advice):
        points = [point for point in joint.points if point.case == each.stage]
        if not points:
            continue
        style = {**look().of(number), "marker": _MARKERS[number]}
        front = sorted((p for p in points if not beaten[id(p)]), key=lambda p: p.time_ms)
        places = [_place(point, bottom) for point in front]
        axes.plot(*zip(*places, strict=True), color=style["color"], zorder=2)
        for point in points:
            _mark(axes, point, bottom, style, hollow=beaten[id(point)])
        name = Label(each.stage, places[::-1], style["color"], name=True)
        labels.append(name)
        keys[id(name)] = Line2D([], [], label=each.stage, **style)
        if each.point is not None:
            place = _place(each.point, bottom)
            axes.plot(*place, "o", markersize=12, fillstyle="none", color=look().ink, clip_on=False)
            text = ", ".join(filter(None, (each.point.method, each.point.setting)))
            label = Label(text, [place], style["color"], sought=True)
            labels.append(label)
            keys[id(label)] = Line2D([], [], label=f"{each.stage}: {text}", ls="", **style)
    guides: list[tuple[float, Literal["--", ":"], str]] = [
        (joint.target_percent, "--", f"target, {joint.target}"),
        (joint.shot_percent, ":", "the light's own noise"),
    ]
    for error, dashes, _ in guides:
        axes.axhline(error, color=look().ink, linewidth=1.1, linestyle=dashes, zorder=1)
    axes.xaxis.set_major_formatter(EngFormatter(unit="s"))
    axes.set(xlabel="time", ylabel="RMS error, % of the mean signal")
    sheet.lay_out(figure)
    # What is advised has room before all else, and what finds none stands in the legend.
    homeless = place_labels(axes, sorted(labels, key=lambda label: not label.sought))
    times = "one run" if repeats == 1 else f"medians of {repeats} runs"
    handles = [
        Line2D([], [], color=look().ink, linestyle=dashes, label=name) for _, dashes, name in guides
    ]
    handles.append(Line2D([], [], color=look().ink, linestyle="", marker="o", markersize=10,
                          fillstyle="none", label="advised"))  # fmt: skip
    handles += [keys[id(label)] for label in homeless]
    sheet.head(
        figure, f"{joint.program} on {Path(joint.scene).name}: what each stage's time buys",
        "compile, lowering, slots: the chip's frame against the light that fell; effects: against "
        "the reference; decoder: against the scene's light (hollow: dominated within its stage; "
        f"pointing down: no error); {times} on {device}", handles,
    )  # fmt: skip
    return figure


def _set_limits(axes: Axes, joint: Joint) -> float:
    """Logarithmic axes that hold all points, target and noise; the lower end of errors."""
    times = [time / 1e3 for point in joint.points for time in point.times_ms]
    floor = _EXACT * joint.target_percent
    errors = [p.error for p in joint.points if floor <= p.error < float("inf")]
    errors += [joint.target_percent, joint.shot_percent]
    axes.set(xscale="log", yscale="log")
    for which, values in (("x", times), ("y", errors)):
        low, high = min(values), max(values)
        room = max((high / low) ** _ROOM, 1.25)
        axes.set(**{f"{which}lim": (low / room, high * room)})
    sheet.round_ticks(axes.yaxis)
    return axes.get_ylim()[0]


def _place(point: Point, bottom: float) -> tuple[float, float]:
    return point.time_ms / 1e3, max(point.error, bottom)


def _mark(axes: Axes, point: Point, bottom: float, style: dict[str, Any], *, hollow: bool) -> None:
    time, error = _place(point, bottom)
    colour = style["color"]
    least, most = (edge(point.times_ms) / 1e3 for edge in (min, max))
    axes.hlines(error, least, most, colour, linewidth=3.2, alpha=0.25)
    axes.plot(
        time, error, style["marker"] if point.error >= bottom else "v", color=colour,
        markerfacecolor=look().paper if hollow else colour, clip_on=False, zorder=3,
    )  # fmt: skip
