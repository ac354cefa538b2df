"""Draw a program whose pixels look: their open times against light.

Comparators are exact here and light is steady, so only the program determines the result."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from nscc.arrays import Bools, Floats, Ints
from nscc.words.container import Container
from nscc.words.machine import LIGHT, StateMachine
from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.sheet import theme
from nscc_runtime.pictures.shutter_sheet import (
    CHART_INCHES,
    bucket_handles,
    open_share,
    subtitle,
    time_axis,
    unit,
)

Nodes = Ints
"""Numbers of nodes of the state machine; a node is a behaviour with values of its states."""


@dataclass(frozen=True, eq=False)
class Courses:
    """One frame of pixels of one code in several amounts of light.

    `wells` (lights,): the light of the whole frame in full wells. `opens` bool (lights, buckets,
    N), `resets` bool (lights, N): open slots, and slots that begin with a reset. `values` int64
    (lights, states): states at the end of the frame. `flips`: (boundary, light) of comparisons
    whose answer changes between two lights."""

    wells: Floats
    opens: Bools
    resets: Bools
    values: Ints
    flips: tuple[tuple[int, float], ...]


def courses(container: Container, behaviour: int, wells: Floats, frame: int = 0) -> Courses:
    """Return what pixels do in frame number `frame`, from 0. `behaviour` is the number of the codes
    that pass the same states. `wells` (lights,) is the steady light of each pixel, in full wells
    over a frame, ascending. Kept states have the program's start values in frame 0 and continue
    from there."""
    machine = container.machine
    nodes = np.full(len(wells), machine.start_nodes()[behaviour])
    for _ in range(frame):
        nodes = _next_start(machine, _run_frame(container, machine, nodes, wells)[1])
    return _run_frame(container, machine, nodes, wells)[0]


def thresholds(container: Container) -> Floats:
    """Return for each comparison (comparisons,) the light at which what a pixel has collected
    reaches its level, in full wells over the frame, if nothing resets the pixel."""
    machine, share = container.machine, _share(container)
    level = container.target.electrons_per_step / container.target.full_well_e
    return np.array(
        [
            comparison.level * level / share[comparison.boundary]
            for comparison in machine.comparisons
        ]
    )


def _share(container: Container) -> Floats:
    """Return the fraction of the frame that has passed at each boundary (N + 1,), from 0 to 1, by
    the lengths of the slots."""
    ends = np.cumsum([0.0, *container.slot_us])
    return np.asarray(ends / ends[-1])


def _run_frame(
    container: Container, machine: StateMachine, nodes: Nodes, wells: Floats
) -> tuple[Courses, Nodes]:
    """Run one frame of pixels in steady light, and return what they did and the nodes in which they
    end (lights,).

    `nodes` (lights,) are the pixels' nodes of `machine` at the start, `wells` (lights,) their light
    in full wells over the frame, ascending."""
    share = np.diff(_share(container))
    opens = np.zeros((len(wells), *machine.opens.shape[1:]), np.bool_)
    resets = np.zeros((len(wells), machine.slots), np.bool_)
    charge, exposed = np.zeros(len(wells)), np.zeros((machine.opens.shape[1], len(wells)))
    level = container.target.electrons_per_step / container.target.full_well_e
    flips: list[tuple[int, float]] = []
    for stage in range(machine.stages):
        for slot in range(machine.starts(stage), machine.ends(stage)):
            resets[:, slot] = machine.resets[nodes, slot]
            opens[:, :, slot] = machine.opens[nodes, :, slot]
            # A photodiode is full at one full well.
            charge = np.minimum(np.where(resets[:, slot], 0.0, charge) + wells * share[slot], 1.0)
            exposed += opens[:, :, slot].T * wells * share[slot]
        if stage + 1 == machine.stages:
            break
        outcome = np.zeros(len(wells), np.int64)
        for bit, comparison in enumerate(machine.at(machine.ends(stage))):
            signal = charge
            if comparison.signal != LIGHT:
                signal = np.minimum(exposed[comparison.signal], 1.0)
            above = signal > comparison.level * level
            outcome |= above.astype(np.int64) << bit
            # The light at which the answer changes lies between two neighbouring ones: their
            # geometric mean, because lights are spaced in equal ratios.
            turned = np.flatnonzero(above[1:] != above[:-1])
            flips += [
                (comparison.boundary, float(np.sqrt(wells[k] * wells[k + 1]))) for k in turned
            ]
        nodes = machine.steps[nodes, outcome].astype(np.int64)
    return Courses(wells, opens, resets, machine.values[nodes], tuple(flips)), nodes


def _next_start(machine: StateMachine, ended: Nodes) -> Nodes:
    """Return the nodes (lights,) of `machine` in which the next frame starts after the frame
    `ended` in these. Kept states continue, others restart."""
    is_kept = np.array([state.is_kept for state in machine.states], np.bool_)
    starts = np.array([state.start for state in machine.states], np.int64)
    # The nodes of the first stage, one for each behaviour and possible values at the start.
    first = slice(0, int(machine.first[1]))
    known = np.column_stack([machine.behaviour[first], machine.values[first]])
    values = np.where(is_kept, machine.values[ended], starts)
    start_values = np.column_stack([machine.behaviour[ended], values])
    return np.asarray((start_values[:, None] == known).all(axis=2).argmax(axis=1))


if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LIGHTS = 360
"""Number of rows of a chart, one for each amount of light."""
_MOST_CODES = 3
"""Number of charts, each of one code."""
_LATER = 8
"""With kept states, this later frame is drawn beside the first."""
_ROUND = 4.0
"""The lights shown end at the outermost thresholds, divided or multiplied by this factor."""
_MOST_RANGE = 1e7
"""Largest ratio of the lights shown."""
_HEIGHT, _BETWEEN, _TIMES, _GAP, _ABOVE = 3.0, 0.95, 1.5, 0.35, 0.3
"""Inches: height of a chart, gap below, width of the open times, gap to their left, margin."""
_MOST_NAMED = 14
_MOST_FLIPS = 400
"""Largest numbers of values of states that are written, and of dots for answers that turn."""


def course_sheet(container: Container, title: str) -> Figure:
    """Return a drawing, under `title`, of the program `container`, whose pixels look: they compare
    their light with levels.

    It shows for some codes when pixels are open (across) in each light (up), with looks and
    thresholds. A second panel shows the total open time and the states that are read."""
    from matplotlib.lines import Line2D

    machine = container.machine
    shown = _shown(container)
    high = len(shown) * (_HEIGHT + _BETWEEN) - _BETWEEN
    figure = sheet.blank(CHART_INCHES, high + _ABOVE)
    for number, (chart_title, chart_courses) in enumerate(shown):
        top = _ABOVE + number * (_HEIGHT + _BETWEEN)
        wide = CHART_INCHES - _TIMES - _GAP
        chart = sheet.place(figure, 0, top, wide, _HEIGHT)
        _draw_chart(chart, container, chart_courses)
        chart.set_title(chart_title)
        beside = sheet.place(figure, wide + _GAP, top, _TIMES, _HEIGHT)
        _draw_times(beside, container, chart_courses)
    handles: list[Artist] = [
        Line2D([], [], color=theme().ink, linewidth=0.8, linestyle=":", label="a look"),
        Line2D([], [], color=theme().ink, marker=".", linestyle="", label="its answer turns"),
    ]
    if any(chart_courses.resets.any() for _, chart_courses in shown):
        handles.append(
            Line2D([], [], color=theme().series[1], marker="|", linestyle="", label="PIX is reset")
        )
    handles += bucket_handles(container)
    looks = machine.stages - 1
    look_count_text = f"{looks} look{'s' * (looks != 1)}"
    sheet.head(figure, title, subtitle(container, look_count_text), handles)
    return figure


def _shown(container: Container) -> list[tuple[str, Courses]]:
    """Return title and content of each chart of the program: of up to three codes, or of the first
    and a later frame of one code if states are kept. The lights shown go beyond the outermost
    thresholds."""
    machine, table = container.machine, container.table
    threshold_wells = thresholds(container)
    low = min(float(threshold_wells.min(initial=1.0)), 1.0) / _ROUND
    high = max(float(threshold_wells.max(initial=1.0)), 1.0) * _ROUND
    wells = np.geomspace(max(low, high / _MOST_RANGE), high, _LIGHTS)
    behaviours = int(machine.behaviour.max()) + 1
    count = min(behaviours, _MOST_CODES)
    chosen = np.unique(np.rint(np.linspace(0, behaviours - 1, count)).astype(int)).tolist()
    charts = []
    for behaviour in chosen:
        code = int(np.flatnonzero(table.shutter_of_code == behaviour)[0])
        values = zip(table.fields, table.codes[code].tolist(), strict=True)
        name = ", ".join(f"{field} = {value}" for field, value in values)
        if machine.keeps:
            frames = {0: "the first frame", _LATER: f"the same light {_LATER} frames later"}
            chosen_frames = frames if count == 1 else {0: frames[0]}
            for frame, frame_text in chosen_frames.items():
                text = ", ".join(phrase for phrase in (name, frame_text) if phrase)
                charts.append((text, courses(container, behaviour, wells, frame)))
        else:
            charts.append((name, courses(container, behaviour, wells)))
    return charts


def _draw_chart(axes: Axes, container: Container, courses: Courses) -> None:
    """Draw into `axes` when pixels are open (across) in each light (up), as `courses` says. The
    colour stands for the total open time, or for the bucket if there are several. Dots mark the
    lights at which the answer of a look changes; short strokes are resets after slot 0."""
    from matplotlib import colormaps
    from matplotlib.colors import to_rgb

    machine = container.machine
    lights, lanes = courses.opens.shape[:2]
    edges, columns = time_axis(axes, container)
    if lanes == 1:
        rank = np.unique(courses.opens[:, 0] @ np.diff(edges), return_inverse=True)[1]
        most = int(rank.max())
        shade = 0.08 + 0.82 * rank / most if most else np.full(lights, 0.35)
        colours = colormaps[sheet.SCALE](shade)[:, None, :3]
    else:
        colours = np.array([[to_rgb(theme().of(lane)["color"]) for lane in range(lanes)]] * lights)
    image = np.empty((lights, len(columns) - 1, 3))
    for row in range(lights):
        share = np.array([open_share(courses.opens[row, b], edges, columns) for b in range(lanes)])
        total = share.sum(axis=0)
        mixed = (share.T @ colours[row]) / np.maximum(total, 1.0)[:, None]
        image[row] = np.outer(1 - np.minimum(total, 1.0), to_rgb(theme().closed)) + mixed
    axes.set_yscale("log")
    inner = np.sqrt(courses.wells[1:] * courses.wells[:-1])
    # The outermost rows extend as far beyond their light as within, in equal ratios.
    first, last = courses.wells[0] ** 2 / inner[0], courses.wells[-1] ** 2 / inner[-1]
    row_edges = np.concatenate(([first], inner, [last]))
    axes.pcolormesh(columns, row_edges, image.clip(0, 1), edgecolors="none")
    axes.set_ylim(courses.wells[0], courses.wells[-1])
    for boundary in machine.looks:
        axes.axvline(edges[boundary], color=theme().ink, linewidth=0.6, linestyle=":", alpha=0.5)
    every = max(1, -(-len(courses.flips) // _MOST_FLIPS))
    flips = np.array(courses.flips[::every], np.float64).reshape(-1, 2)
    axes.plot(edges[flips[:, 0].astype(int)], flips[:, 1], ".", color=theme().ink, clip_on=False)
    # A reset before slot 0 is not drawn: it begins the frame.
    light, slot = np.nonzero(courses.resets[:, 1:])
    axes.plot(edges[slot + 1], courses.wells[light], "|", color=theme().series[1], markersize=2)
    axes.set_ylabel("light of the frame, full wells")
    sheet.round_ticks(axes.yaxis)


def _draw_times(axes: Axes, container: Container, courses: Courses) -> None:
    """Draw into `axes` the total open time in `courses` against light for each bucket, and beside
    it the values of the states that are read, where they hold for enough lights to write them."""
    machine = container.machine
    slot_us = np.array(container.slot_us)
    scale, name = unit(float(slot_us.sum()))
    for bucket in range(courses.opens.shape[1]):
        times = courses.opens[:, bucket] @ slot_us * scale
        style = theme().of(bucket) if courses.opens.shape[1] > 1 else {"color": theme().ink}
        axes.step(times, courses.wells, where="mid", color=style["color"], linewidth=1.2)
    axes.set_xlim(0, float(slot_us.sum()) * scale * 1.05)
    axes.set_yscale("log")
    axes.set_ylim(courses.wells[0], courses.wells[-1])
    axes.set_xlabel(f"open, {name}")
    for axis in (axes.xaxis, axes.yaxis):
        sheet.round_ticks(axis)
    axes.tick_params(axis="y", labelleft=False, length=0)
    # States are named beside the lights where they keep one combination of values for long
    # enough.
    read = [k for k, state in enumerate(machine.states) if state.read]
    if not read:
        return
    values = courses.values[:, read]
    begins = [0, *(np.flatnonzero((values[1:] != values[:-1]).any(axis=1)) + 1).tolist()]
    ends = [*begins[1:], len(values)]
    tall = [(b, e) for b, e in zip(begins, ends, strict=True) if e - b >= _LIGHTS // 30]
    for begin, end in tall if len(tall) <= _MOST_NAMED else tall[:: -(-len(tall) // _MOST_NAMED)]:
        text = ", ".join(map(str, values[begin].tolist()))
        middle = float(np.sqrt(courses.wells[begin] * courses.wells[end - 1]))
        axes.text(1.06, middle, text, transform=axes.get_yaxis_transform(), va="center")
    names = ", ".join(machine.states[k].name for k in read)
    axes.set_title(names, loc="right")
