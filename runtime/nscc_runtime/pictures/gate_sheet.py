"""Draw a program's gates: registers as horizontal lines (staves), time from left to right, row by
row.

A value is a bar on its register's line, from its write to its last read. A gate is a box on the
line that it writes, with a dot on every line that it reads; a comparison of light is drawn in the
same way. A triangle below the line of FLAG marks a value that the program needs in FLAG."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING

from nscc_runtime.pictures.sheet import blank, head, place, theme

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from networkx import DiGraph

_COLUMNS = 23
"""Number of gates and demands (values needed in FLAG) per row."""
_MOST = 16 * _COLUMNS
"""Largest number of gates and demands that are drawn, in complete boundaries from the first on."""
_LEAST = 14
"""Smallest number of columns of a picture, with room for the heading."""
_COLUMN, _STAVE = 0.32, 0.21
"""Width of a column and height of a register's line, in inches."""
_ABOVE, _BELOW = 0.42, 0.42
_HOLDER = 40
"""Largest number of letters for the content of a register."""
_WRITING = ("gate", "look")
_SERIES = {"NOR": 0, "NOT": 0, "OR": 1, "MOV": 1, "WHERE": 2, "where": 3}
"""Index of the series colour for each kind of gate."""


@dataclass(frozen=True)
class _Score:
    """The layout of gates.

    `column`: the column of every drawn gate and demand (a value needed in FLAG), by node, _COLUMNS
    of them per row of the picture. `row`: the line of every register, by name, FLAG last. `until`:
    the last column in which each value is read, by node; -1 if it is never read. FLAG is the bit
    that lets a pixel act."""

    network: DiGraph
    column: dict[str, int]
    row: dict[str, int]
    until: dict[str, int]


def gate_sheet(network: DiGraph, title: str) -> Figure:
    """Return a drawing of `network`, a network of gates of `nscc.emit.network`, under `title`. Only
    the beginning of a large one is drawn, which the note says."""
    score = _score(network)
    used = 1 + max(score.column.values(), default=-1)
    lines, columns = -(-used // _COLUMNS), max(_LEAST, min(used, _COLUMNS))
    tall = len(score.row) * _STAVE
    figure = blank(columns * _COLUMN, max(1, lines) * (_ABOVE + tall + _BELOW))
    for line in range(lines):
        top = line * (_ABOVE + tall + _BELOW) + _ABOVE
        axes = place(figure, 0, top, columns * _COLUMN, tall)
        axes.set(xlim=(0, columns), ylim=(len(score.row) - 0.5, -0.5))
        axes.axis("off")
        _draw_line(axes, score, line * _COLUMNS)
    head(figure, title, _note(network, score))
    return figure


def _score(network: DiGraph) -> _Score:
    """Return the column of each gate of `network` and the line of each register.

    The gates of a boundary begin a new row of the picture if they would be divided otherwise and
    fit into one. Only complete boundaries within the first `_MOST` columns are drawn, but always
    the first boundary, cut off there."""
    nodes = network.nodes
    events = [node for node in nodes if nodes[node]["kind"] in (*_WRITING, "demand")]
    column: dict[str, int] = {}
    position = 0
    for _, group in groupby(events, key=lambda node: nodes[node]["boundary"]):
        boundary_nodes = list(group)
        free_columns = -position % _COLUMNS
        if free_columns < len(boundary_nodes) <= _COLUMNS:
            position += free_columns  # a boundary that would be split starts a line
        if column and position + len(boundary_nodes) > _MOST:
            break
        column |= {node: position + i for i, node in enumerate(boundary_nodes[:_MOST])}
        position += len(boundary_nodes)
    values = [
        node
        for node in nodes
        if nodes[node]["kind"] == "plane" or (nodes[node]["kind"] in _WRITING and node in column)
    ]
    names = {nodes[node]["register"] for node in values}
    order = sorted(names, key=lambda name: (name == "FLAG", len(name), name))
    # Values that are read later than the picture shows are drawn up to its edge.
    until = {
        node: max((column.get(r, position) for r in network.successors(node)), default=-1)
        for node in values
    }
    return _Score(network, column, {name: i for i, name in enumerate(order)}, until)


def _note(network: DiGraph, score: _Score) -> str:
    """Return the text below the title: encoding, number and depth of the gates of `network`, and
    what `score`, its layout, leaves out of the picture."""
    nodes, facts = network.nodes, network.graph
    gates = [node for node in nodes if nodes[node]["kind"] == "gate"]
    drawn = sum(node in score.column for node in gates)
    if not gates:
        return f"{facts['encoding']}: there are no gates"
    text = (
        f"{facts['encoding']}; {len(gates)} gates, at most {facts['depth']} one after the other; "
    )
    text += f"{facts['registers']} registers can hold all values"
    if drawn < len(gates):
        last = max(nodes[node]["boundary"] for node in score.column)
        text += f"; here the first {drawn}, up to boundary {last} (--emit graphml has all)"
    return text


def _draw_line(axes: Axes, score: _Score, first: int) -> None:
    """Draw one row of the picture into `axes`: the registers' lines, values and gates of the
    `_COLUMNS` columns of `score` from `first` on. Coordinates are columns to the right and lines
    downwards."""
    nodes = score.network.nodes
    shown = {n: at - first for n, at in score.column.items() if first <= at < first + _COLUMNS}
    end = first + max(shown.values()) + 1
    _draw_bands(axes, score, shown)
    rows = list(score.row.values())
    axes.hlines(rows, 0, end - first, color=theme().grid, linewidth=0.7, zorder=1)
    for register, row in score.row.items():
        axes.text(-0.25, row, register, size=7, color=theme().ink, ha="right", va="center")
    bars = []
    for node, until in score.until.items():
        row = score.row[nodes[node]["register"]]
        if nodes[node]["kind"] == "plane":
            holder = nodes[node]["holder"]
            if len(holder) > _HOLDER:  # names of contents differ at the end
                holder = "…" + holder[1 - _HOLDER :]
            axes.text(-1.6, row, holder, size=6.5, color=theme().faint, ha="right", va="center")
        bar_left, bar_right = max(score.column.get(node, -1) + 0.5, first), min(until + 0.5, end)
        if bar_left < bar_right:
            bars.append((row, bar_left - first, bar_right - first))
    axes.hlines(*zip(*bars, strict=True), color=theme().bar, linewidth=4, zorder=2)
    _draw_gates(axes, score, shown)
    _draw_demands(axes, score, shown)


def _draw_bands(axes: Axes, score: _Score, shown: dict[str, int]) -> None:
    """Draw into `axes` a band for each boundary of the nodes `shown` (gates and demands of this
    row, with their columns in it), alternately shaded, with the numbers of boundaries and kernels.
    `score` is the layout."""
    nodes, top, bottom = score.network.nodes, -0.5, len(score.row) - 0.5
    boundaries = list(dict.fromkeys(nodes[node]["boundary"] for node in score.column))
    for boundary, group in groupby(shown, key=lambda node: nodes[node]["boundary"]):
        inside = list(group)
        band_left = shown[inside[0]]
        # Counted over all rows, so that the shades of a picture alternate.
        if boundaries.index(boundary) % 2 == 0:
            axes.axvspan(band_left, band_left + len(inside), color=theme().closed, zorder=0)
        axes.text(
            band_left + 0.1, top - 0.75, f"{boundary}", size=7, color=theme().ink, va="bottom"
        )
        edge = [band_left, band_left], [top - 1.2, bottom]
        axes.plot(*edge, color=theme().grid, linewidth=0.7, clip_on=False)
    kernel = None
    for node, column in shown.items():
        if nodes[node].get("kernel", kernel) != kernel:
            kernel = nodes[node]["kernel"]
            axes.text(
                column + 0.1, top - 0.1, f"k{kernel}", size=6.5, color=theme().faint, va="bottom"
            )


def _draw_gates(axes: Axes, score: _Score, shown: dict[str, int]) -> None:
    """Draw the gates among the nodes `shown`, given with their columns, into `axes`: a box on the
    line that each writes, and a dot on each line that it reads, joined by a vertical line. `score`
    is the layout."""
    nodes = score.network.nodes
    for node, column in shown.items():
        if nodes[node]["kind"] not in _WRITING:
            continue
        x = column + 0.5
        row = score.row[nodes[node]["register"]]
        read = [score.row[nodes[value]["register"]] for value in score.network.predecessors(node)]
        kind = _SERIES.get(nodes[node]["function"])
        colour = theme().faint if kind is None else theme().series[kind]
        # The box covers the dot on the written stave.
        axes.plot(
            [x] * (1 + len(read)),
            sorted([row, *read]),
            color=colour,
            linewidth=1,
            zorder=3,
            marker="o",
            markersize=3,
        )
        axes.text(
            x,
            row,
            nodes[node]["function"],
            size=5.6,
            color=theme().on(colour),
            ha="center",
            va="center",
            zorder=5,
            bbox={"boxstyle": "round,pad=0.25", "color": colour, "linewidth": 0},
        )


def _draw_demands(axes: Axes, score: _Score, shown: dict[str, int]) -> None:
    """Draw an arrow on the FLAG line into `axes` for each demand among the nodes `shown`, given
    with their columns: FLAG then decides which pixels add or reset. `score` is the layout. FLAG is
    the bit that lets a pixel act."""
    nodes, row = score.network.nodes, len(score.row) - 1
    for node, column in shown.items():
        if nodes[node]["kind"] != "demand":
            continue
        x = column + 0.5
        axes.plot(
            [x, x],
            [row, row + 0.85],
            color=theme().ink,
            linewidth=0.8,
            zorder=3,
            clip_on=False,
            marker="v",
            markersize=4,
            markevery=[1],
        )
        axes.text(
            x, row + 1.2, nodes[node]["edge"], size=6.5, color=theme().ink, ha="center", va="top"
        )
