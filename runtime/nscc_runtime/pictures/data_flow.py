"""Draw the data flow of a program with images and planes, and its convolution kernels.

Exposures and states are at the top, read-out and reports at the bottom. An edge names the kernels
and levels that are applied. A kernel is a grid of weights."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from nscc.mappings import NamedValues
from nscc.words import pictures as p
from nscc.words.container import Container
from nscc_runtime.pictures.sheet import place, theme

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from networkx import DiGraph

_LAYER, _BOX, _WIDEST = 0.95, 0.4, 1.5
"""Inches: distance of layers, height of a box, largest width of a box."""
_CELL, _BETWEEN, _NAME = 0.19, 0.5, 0.4
"""Inches: side of a weight, gap between kernels, height of a kernel's name."""
_SWEEPS = 8
"""Number of passes that order each layer by the mean position of the neighbours."""
# The number of the colour of each kind of box.
_SERIES = {"exposure": 6, "image": 0, "plane": 2, "state": 3, "output": 4}

Node = str | tuple[str, str, int]
"""A box, or the place of an edge (source, target) in a layer between its ends."""


def flow_graph(container: Container) -> DiGraph:
    """Return the graph of exposures, states, images, planes, read-out and reports of a program.

    Nodes are named as in the program ("next NAME" for the new value of a state). They have a
    `kind`, a key of `_SERIES`, and a `text`. Edges have a `label`: the kernels and levels applied,
    a line for each use. An edge that would close a circle, to a value of the step before, is left
    out."""
    from networkx import DiGraph, has_path

    pictures, graph = container.pictures, DiGraph()
    words = {cost.name: cost.words for cost in pictures.costs}
    states = {name: f"next {name}" for name in pictures.stepping}
    for name, expression in pictures.expressions.items():
        node = states.get(name, name)
        kind = "state" if name in states else "plane" if name in pictures.planes else "image"
        graph.add_node(node, kind=kind, text=f"{kind}, {words.get(name, 0)} words")
        for source, label in _sources(container, expression):
            if source in graph and has_path(graph, node, source):
                continue  # a value of the step before
            labels = graph.edges[source, node]["label"] if graph.has_edge(source, node) else ""
            graph.add_edge(source, node, label=f"{labels}\n{label}".strip())
    outputs = [("read", "", name) for name in pictures.reads]
    for report in pictures.reports:
        most = f"at most {report.most}" if report.most else ""
        outputs.append((f"report {report.kind}", most, report.plane))
    for node, text, name in outputs:
        graph.add_node(node, kind="output", text=text)
        graph.add_edge(states.get(name, name), node, label="")
    for node, facts in graph.nodes.items():
        # Nodes that only an edge added: values that the program does not compute.
        if not facts:
            facts |= {"kind": "state" if node in states else "exposure", "text": ""}
    return graph


def _sources(container: Container, node: p.Node, label: str = "") -> Iterator[tuple[str, str]]:
    """Yield the names that the expression `node` reads, each with the kernels and levels that are
    applied to it as text, from the outermost on. `label` is this text for the expressions around
    `node`."""
    step = ""
    match node:
        case p.Source() | p.Bit():
            yield node.name, label
        case p.Filtered() | p.Agreement():
            step = node.kernel
        case p.Largest() | p.Near():
            step = f"{'max' if isinstance(node, p.Largest) else node.kind} {node.kernel}"
        case p.At() | p.Shifted():
            step = f"[{node.right}, {node.down}]"
        case p.Above():
            step = f"> {node.steps * container.target.electrons_per_step:.0f} e"
        case p.AboveParam():
            step = f"> {'-' if node.factor < 0 else ''}{node.param}"
        case p.Exceeds():
            step = f"> {float(node.level):g}"
    for operand in p.operands(node):
        yield from _sources(container, operand, ", ".join(filter(None, (step, label))))


def _layers(graph: DiGraph) -> list[list[Node]]:
    """Return the nodes by layer, from top to bottom, each below all that it reads, ordered so that
    few edges cross; outputs are in the last layer. Edges that pass through layers have points in
    them."""
    from networkx import topological_generations

    outputs = [node for node in graph if graph.nodes[node]["kind"] == "output"]
    inner = graph.subgraph(set(graph) - {*outputs})
    layers: list[list[Any]] = [*map(sorted, topological_generations(inner)), outputs]
    neighbours: dict[Node, list[Node]] = {}
    for edge in graph.edges:
        for first, second in pairwise(_chain(edge, layers)):
            neighbours.setdefault(first, []).append(second)
            neighbours.setdefault(second, []).append(first)
    # Nodes without a name are points (source, target, layer) of an edge that passes through layers.
    for node in neighbours:
        if not isinstance(node, str):
            layers[node[2]].append(node)
    for node in {*graph} - neighbours.keys():
        neighbours[node] = [node]  # a constant that nothing reads keeps its place
    for sweep in range(_SWEEPS):
        for layer in layers if sweep % 2 == 0 else reversed(layers):
            at = {node: (i + 0.5) / len(row) for row in layers for i, node in enumerate(row)}
            mean = {node: np.mean([at[other] for other in neighbours[node]]) for node in layer}
            layer.sort(key=mean.__getitem__)
    return layers


def _chain(edge: tuple[str, str], layers: list[list[Any]]) -> list[Node]:
    """Return the ends of `edge` (source, target), and between them its points (source, target,
    layer) in the `layers` that it passes, from top to bottom."""
    first, last = (next(n for n, layer in enumerate(layers) if end in layer) for end in edge)
    return [edge[0], *((*edge, number) for number in range(first + 1, last)), edge[1]]


class DataFlow:
    """A layered drawing of `flow_graph`, with the kernels below it; lengths in inches."""

    def __init__(self, container: Container, width: float) -> None:
        """Arrange the nodes in layers and the convolution kernels in rows, `width` inches wide."""
        self.graph, self.width = flow_graph(container), width
        self.layers, weights = _layers(self.graph), container.pictures.weights
        side = max((len(kernel.rows) for kernel in weights), default=0) * _CELL
        columns = int((width + _BETWEEN) // (side + _BETWEEN))
        self.kernels = [weights[k : k + columns] for k in range(0, len(weights), columns)]
        self.row_height, self.graph_height = side + _NAME, _LAYER * len(self.layers)
        self.height = self.graph_height + self.row_height * len(self.kernels)

    def draw(self, figure: Figure, top: float) -> None:
        """Draw the graph and the kernels into `figure`, from `top` inches below its upper edge."""
        axes = place(figure, 0, top, self.width, self.graph_height)
        axes.set(xlim=(0, self.width), ylim=(self.graph_height, -0.02))
        axes.axis("off")
        place_of: dict[Node, tuple[float, float]] = {
            node: ((i + 0.5) * self.width / len(layer), number * _LAYER + _BOX / 2)
            for number, layer in enumerate(self.layers)
            for i, node in enumerate(layer)
        }
        for node in self.graph:
            self._draw_edges(axes, node, place_of)
            (room,) = (self.width / len(layer) for layer in self.layers if node in layer)
            self._draw_box(axes, node, place_of[node], min(_WIDEST, room - 0.15))
        for row, kernels in enumerate(self.kernels):
            y = top + self.graph_height + row * self.row_height
            for column, kernel in enumerate(kernels):
                x = column * (self.row_height - _NAME + _BETWEEN)
                size = len(kernel.rows[0]) * _CELL, len(kernel.rows) * _CELL
                _draw_kernel(place(figure, x, y, *size), kernel)

    def _draw_edges(self, axes: Axes, node: str, at: dict[Node, tuple[float, float]]) -> None:
        """Draw the edges that end at the box of `node`, side by side in the order of where they
        begin, with their labels.

        `at` are the positions (x, y) of all nodes and points of edges, in inches."""
        edges = [
            (self.graph.edges[source, node]["label"], _chain((source, node), self.layers))
            for source in self.graph.predecessors(node)
        ]
        edges.sort(key=lambda edge: at[edge[1][-2]])
        for number, (label, chain) in enumerate(edges):
            x = at[node][0] + (number - (len(edges) - 1) / 2) * min(0.5, 1.2 / len(edges))
            y, before = at[node][1] - _BOX / 2, [at[point] for point in chain[:-1]]
            axes.plot(*zip(*before, strict=True), color=theme().bar, linewidth=1, zorder=1)
            arrow = {"arrowstyle": "-|>", "color": theme().bar, "shrinkA": 0, "shrinkB": 0}
            axes.annotate("", (x, y), before[-1], arrowprops=arrow, zorder=1)
            right, down = before[-1][0] - x, before[-1][1] - y
            # The label lies on the edge, near its end, where edges from other boxes are apart.
            share = float(np.clip(0.4 / max(abs(right), 1e-9), 0.2, 0.4))
            axes.text(
                x + share * right,
                y + share * down,
                label,
                size=6.5,
                color=theme().ink,
                ha="center",
                va="center",
                zorder=2,
                bbox={"boxstyle": "square,pad=0.1", "color": theme().paper, "linewidth": 0},
            )

    def _draw_box(self, axes: Axes, node: str, at: tuple[float, float], width: float) -> None:
        """Draw the box of a node, `width` inches wide, around the point `at` (x, y in inches), with
        its name and its text. The type is smaller where a long name would not fit."""
        from matplotlib.patches import FancyBboxPatch

        kind, text = (self.graph.nodes[node][key] for key in ("kind", "text"))
        axes.add_patch(
            FancyBboxPatch(
                (at[0] - width / 2, at[1] - _BOX / 2),
                width,
                _BOX,
                linewidth=1.2,
                zorder=3,
                boxstyle="round,pad=0,rounding_size=0.05",
                facecolor=theme().closed,
                edgecolor=theme().series[_SERIES[kind]],
            )
        )
        is_start = kind == "state" and not text
        name = "exposure" if node == "frame" else f"state {node}" if is_start else node
        # 72 points are an inch; a letter is about 0.62 of the type size wide.
        size = min(8.5, width * 72 / (0.62 * max(len(name), len(text), 8)))
        line: NamedValues = {"ha": "center", "va": "center", "zorder": 4}
        axes.text(at[0], at[1] - 0.07 * bool(text), name, size=size, weight="bold", **line)
        axes.text(at[0], at[1] + 0.08, text, size=0.8 * size, color=theme().faint, **line)


def _draw_kernel(axes: Axes, kernel: p.Weights) -> None:
    """Draw the weights of `kernel` as numbers in cells: blue if positive, red if negative. The
    title is its name, with its divisor if that is above 1."""
    # Beyond the largest weight, so that colours stay light and the numbers legible.
    limit = 1.6 * max(abs(weight) for row in kernel.rows for weight in row) or 1
    axes.imshow(kernel.rows, cmap="RdBu", vmin=-limit, vmax=limit, alpha=0.7, aspect="auto")
    axes.set_title(
        f"{kernel.name} / {kernel.divisor}" if kernel.divisor > 1 else kernel.name, size=7, pad=3
    )
    axes.axis("off")
    for (y, x), weight in np.ndenumerate(np.array(kernel.rows)):
        axes.text(x, y, f"{weight}", size=6, ha="center", va="center_baseline")
