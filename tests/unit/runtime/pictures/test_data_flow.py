"""The drawing of a program with images and planes: its graph, its layers, and its kernels."""

from __future__ import annotations

from pathlib import Path

import pytest
from drawn_figures import compare_figure

from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.pictures.data_flow import DataFlow, flow_graph
from nscc_runtime.pictures.sheet import png_of, style
from nscc_runtime.pictures.shutter_sheet import CHART_INCHES, shutter_sheet

TEXT = """
nsl 3
frame 8 slots of 500us
outside 0
bucket early open when n < 4
bucket late open when n >= 4
kernel blur = [[1, 2, 1], [2, 4, 2], [1, 2, 1]] / 16
kernel line = [[1, 1, 1]]
state h : bit = 0 kept
image change = blur(late - early)
plane moved = change > 4%
plane sure = moved[1, 0] and all(moved, line) and h
next h = any(moved, line)
read change, late, h
report events sure at most 9
"""


@pytest.fixture(scope="module")
def container() -> Container:
    made = run_passes(Source("p.nsl", TEXT), Path(), Options(level=0, cache=False)).container
    assert made is not None
    return made


def test_the_graph_has_every_use_of_a_value(container: Container) -> None:
    graph = flow_graph(container)
    step_e = container.target.electrons_per_step
    edges = {(a, b): facts["label"] for a, b, facts in graph.edges(data=True)}
    assert edges == {
        ("late", "change"): "blur",
        ("early", "change"): "blur",
        ("change", "moved"): f"> {round(0.04 * 30000 / step_e) * step_e:.0f} e",
        ("moved", "sure"): "[1, 0]\nall line",
        ("h", "sure"): "",
        ("moved", "next h"): "any line",
        ("change", "read"): "",
        ("late", "read"): "",
        ("next h", "read"): "",
        ("sure", "report events"): "",
    }
    kinds = {node: facts["kind"] for node, facts in graph.nodes.items()}
    assert (kinds["late"], kinds["h"], kinds["next h"]) == ("exposure", "state", "state")
    assert graph.nodes["report events"]["text"] == "at most 9"


def test_edges_go_down_and_their_places_between_are_kept_free(container: Container) -> None:
    flow = DataFlow(container, CHART_INCHES)
    layer_of = {node: number for number, layer in enumerate(flow.layers) for node in layer}
    assert all(layer_of[source] < layer_of[target] for source, target in flow.graph.edges)
    long = {(a, b) for a, b in flow.graph.edges if layer_of[b] - layer_of[a] > 1}
    assert ("late", "read") in long
    assert {node[:2] for node in layer_of if not isinstance(node, str)} == long
    assert [[kernel.name for kernel in row] for row in flow.kernels] == [["blur", "line"]]


@pytest.mark.parametrize(
    "unused", ["plane t = true", "plane t = true plane u = not t", "image z = exposure - exposure"]
)
def test_constants_that_nothing_reads_are_drawn(unused: str) -> None:
    text = f"nsl 3 frame 4 slots of 1ms open when true {unused} image y = -exposure read y"
    made = run_passes(Source("p.nsl", text), Path(), Options(level=0, cache=False)).container
    assert made is not None
    flow = DataFlow(made, CHART_INCHES)
    assert {name for layer in flow.layers for name in layer} >= {unused.split()[1], "y", "read"}
    assert png_of(shutter_sheet, made, "p.nsl").startswith(b"\x89PNG")


def test_a_program_is_drawn_the_same_each_time(container: Container) -> None:
    drawn = png_of(shutter_sheet, container, "p.nsl")
    assert drawn == png_of(shutter_sheet, container, "p.nsl")
    # An empty picture is smaller.
    assert len(drawn) > 20_000


def test_the_drawing_is_what_was_recorded(container: Container, update_cases: bool) -> None:
    with style():
        figure = shutter_sheet(container, "p.nsl")
        figure.draw_without_rendering()
    compare_figure(figure, "data flow", update_cases)
