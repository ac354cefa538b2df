"""The network of gates as it is written: what a reader of the file alone can compute from it."""

from __future__ import annotations

import io
import re
from pathlib import Path

import networkx as nx
import numpy as np
import pytest
from looks_oracle import Interpreter
from nscc_command import invoke

from nscc.compiler import compile_source
from nscc.emit.network import dot_text, graphml_bytes, network_of
from nscc.emit.report import report
from nscc.looks.passes import container_of
from nscc.pipeline import KINDS, Options
from nscc.source import Source

BOOK = [f"{37 * k * k % 1023:010b}" for k in range(1, 25)]
TEXTS = {
    "a": "frame 4 slots of 1ms\nopen when true",
    "b": "frame 40 slots of 1ms\ncode stop : 1..40\nopen when n < stop",
    "b_many": "frame 300 slots of 100us\ncode stop : 1..300\nopen when n < stop",
    "c": "frame 33 slots of 1ms\ncode s : 0..25\nopen when s <= n < s + 8",
    "d": "frame 12 slots of 1ms\ncode a : 0..11\ncode b : 1..12\nrequire a < b\n"
    "open when a <= n < b",
    "d_masked": "frame 20 slots of 1ms\ncode a : 0..19\ncode b : 1..20\nrequire a < b\n"
    "open when a <= n < b",
    "buckets": "frame 21 slots of 1ms\ncode split : 1..20\n"
    "bucket early open when n < split\nbucket late open when n >= split",
    "book": f"frame 10 slots of 1ms\nshutters book [{', '.join(BOOK)}]\n"
    "code id : row of book\nopen when book[id]",
    "composed": "frame 24 slots of 1ms\ncode stop : 1..24\ncode k : 0..3\n"
    "open when n < stop xor n % 4 == k",
    "long": "frame 12 slots of 0.5s\ncode stop : 1..12\nopen when n < stop",
}
CASES = [(name, lowering, 1) for name in TEXTS for lowering in ("accumulate", "edges")]
CASES += [("d", "accumulate", 2), ("c", "accumulate", 2)]


def built(text, **options):
    source = Source("test.nsl", f"nsl 1\n{text}\n")
    return compile_source(source, Path(), Options(codes="open", cache=False, **options))


def values_of(network, shutters):
    """What every node is for each shutter, as sets of shutters: nothing but the file is used."""
    everything, values = set(range(shutters)), {}
    for node in nx.topological_sort(network):
        facts = network.nodes[node]
        named = facts["operands"].split() if "mask" in facts else network.predecessors(node)
        sources = [values[value] for value in named]
        if facts["kind"] == "plane":
            values[node] = {i for i in everything if int(facts["bits"], 16) >> i & 1}
            continue
        some = set().union(*sources)
        match facts.get("function"):
            case "NOR" | "NOT" | "SET":
                values[node] = everything - some
            case "OR" | "MOV" | "WHERE" | "CLR" | None:
                values[node] = some
                assert facts["kind"] == "gate" or len(sources) == 1
        if "mask" in facts:
            mask, before = values[facts["mask"]], values[facts["before"]]
            values[node] = values[node] & mask | before - mask
    return values


def expected(program, lowering):
    """(bucket, edge, boundary) -> shutters, for all that differ between shutters."""
    table, found = program.table.shutters, {}
    count, _, slots = table.shape

    def add(bucket, edge, boundary, wanted):
        if 0 < wanted.sum() < count:
            name = program.buckets[bucket].name
            found[name, edge, boundary] = set(wanted.nonzero()[0].tolist())

    for bucket in range(table.shape[1]):
        level = table[:, bucket]
        for n in range(1, slots + 1):
            if lowering == "accumulate":
                add(bucket, "open", n, level[:, n - 1])
                continue
            after = level[:, n] if n < slots else level[:, 0] & False
            add(bucket, "fall", n, level[:, n - 1] & ~after)
            add(bucket, "rise", n, after & ~level[:, n - 1])
    return found


@pytest.mark.parametrize(("name", "lowering", "level"), CASES)
def test_the_file_alone_computes_the_shutters(name, lowering, level):
    compiled = built(TEXTS[name], lowering=lowering, level=level)
    lowered = compiled.lowered
    network = nx.read_graphml(io.BytesIO(graphml_bytes(network_of(lowered))))
    values = values_of(network, network.graph["shutters"])
    asked = {}
    for node, facts in network.nodes(data=True):
        if facts["kind"] == "demand":
            asked[facts["bucket"], facts["edge"], facts["boundary"]] = values[node]
        elif facts["kind"] == "end":
            (plane,) = [
                p
                for p, f in network.nodes(data=True)
                if f["kind"] == "plane" and f["register"] == facts["register"]
            ]
            assert values[node] == values[plane]
    assert asked == expected(compiled.program, lowering)
    gates = [facts for _, facts in network.nodes(data=True) if facts["kind"] == "gate"]
    logic = report(compiled.layout, compiled.proof)["logic"]
    assert sum(facts["words"] for facts in gates) == logic["words"]
    for facts in gates:
        assert (facts["boundary"], facts["kernel"]) in lowered.schedule.launches
    registers = len(lowered.schedule.allocation.holders)
    assert network.graph["registers"] <= registers + 1  # FLAG


LOOKING = {
    "float": "frame 8 slots of 1ms\nsense b when light > 45% at n in [1, 2, 4]\n"
    "state s : 0..3 = 0\nnext s = looks when b and s == 0\nopen when s == 0\nread s",
    "kept": "frame 4 slots of 1ms\nsense f when exposure > 80% at n == N\n"
    "sense d when exposure < 30% at n == N\nstate stop : 0..3 = 2 kept\nstate was : 0..3 = 2\n"
    "next stop = max(stop - 1, 0) if f else min(stop + 1, 3) if d else stop\nnext was = stop\n"
    "open when n <= stop\nread was, stop",
    "reset": 'target "scamp5-algorithm1"\nframe 6 slots of 1ms\n'
    "sense full when light > 70% at n >= 1\nstate count : 0..5 = 0\n"
    "next count = min(count + 1, 5) when full\nreset when full\nopen when true\nread count",
}


@pytest.mark.parametrize("name", list(LOOKING))
def test_the_network_file_computes_the_answers_of_pixels_that_look(name):
    """Lanes are pixels with answers of their own, drawn; a direct interpreter of the text says what
    each of them does."""
    text = f"nsl 2\n{LOOKING[name]}\n"
    source = Source("test.nsl", text)
    lowered = compile_source(source, Path(), Options(codes="open", cache=False)).lowered
    made = KINDS.of(lowered.program).network(lowered)
    network = nx.read_graphml(io.BytesIO(graphml_bytes(made)))
    lanes, nodes = range(40), network.nodes
    draw = np.random.default_rng(3)
    signal = {
        (facts["boundary"], facts["signal"]): draw.random(len(lanes)) * 30_000
        for _, facts in nodes(data=True)
        if facts["kind"] == "look"
    }
    values = {}
    for node in nx.topological_sort(network):
        facts = nodes[node]
        some = set().union(*(values[source] for source in network.predecessors(node)))
        if facts["kind"] == "look":
            level = facts["steps"] * 30_000 / 127
            found = signal[facts["boundary"], facts["signal"]]
            some = {lane for lane in lanes if found[lane] <= level}
        elif facts["kind"] == "plane":
            some = set(lanes) if int(facts["bits"], 16) & 1 else set()
        elif facts.get("function") in ("NOR", "NOT", "SET"):
            some = set(lanes) - some
        values[node] = some
    interpreter = Interpreter(text)
    for lane in lanes:
        pixel = interpreter.run(
            {},
            [0.0] * interpreter.slots,
            answer=lambda _sense, n, _light, level: bool(
                next(v for (at, _), v in signal.items() if at == n)[lane] > level  # noqa: B023
            ),
        )
        [opens] = pixel.opens
        edges = {
            (facts["edge"], facts["boundary"])
            for node, facts in nodes(data=True)
            if facts["kind"] == "demand" and lane in values[node]
        }
        resets = {n for edge, n in edges if edge == "reset"}
        becomes = [*opens[1:], False]
        assert {n for edge, n in edges if edge == "fall"} == {
            n + 1 for n, now in enumerate(opens) if now and (not becomes[n] or n + 1 in resets)
        }
        assert {n for edge, n in edges if edge == "rise"} == {
            n + 1 for n, now in enumerate(opens) if becomes[n] and not now and n + 1 not in resets
        }
        for state, planes in lowered_planes(lowered).items():
            bits = [lane in values[f"z_{state}_{bit}"] for bit in range(planes.bits.shape[1])]
            [row] = np.flatnonzero((planes.bits == bits).all(axis=1))
            assert planes.values[row] == pixel.states[state]


def lowered_planes(lowered):
    """How registers hold the states that are read or kept."""
    return container_of(lowered, 1).state_planes


def test_depth_and_registers_equal_those_computed_by_hand():
    """Two stops: planes p0, p1 and a WHERE for each; both planes live on, and FLAG."""
    network = network_of(
        built("frame 3 slots of 1ms\ncode s : 1..3\nopen when n < s", lowering="latch").lowered
    )
    assert (network.graph["depth"], network.graph["registers"]) == (1, 3)


def test_dot_has_every_node_and_edge():
    """The nodes and edges of the text are those of the network of gates, in the same order."""
    network = network_of(built(TEXTS["d"], level=1).lowered)
    text = dot_text(network)
    assert set(re.findall(r"^  (\w+) \[shape", text, re.M)) == set(network)
    assert re.findall(r"^  (\w+) -> (\w+);$", text, re.M) == list(network.edges)
    assert text.startswith("digraph gates {\n")
    assert text.endswith("}\n")


@pytest.mark.parametrize("name", ["a", "b_many"])
def test_view_draws_gates(name, tmp_path):
    """`nscc view --gates` writes a PNG file for a small and a large network."""
    (tmp_path / "p.nsl").write_text(f"nsl 1\n{TEXTS[name]}\n")
    arguments = ["view", "p.nsl", "--gates", "-O1", "--codes", "open", "-o", "p.png"]
    outcome = invoke(arguments, tmp_path)
    assert outcome.status == 0, outcome.err
    assert (tmp_path / "p.png").read_bytes().startswith(b"\x89PNG")


def test_a_compiled_program_has_no_gates(tmp_path):
    """A container holds words and no gates: `nscc view --gates` gives NS0743 and writes no file."""
    (tmp_path / "p.nsl").write_text(f"nsl 1\n{TEXTS['b']}\n")
    assert invoke(["build", "p.nsl", "-O1"], tmp_path).status == 0
    outcome = invoke(["view", "p.icw", "--gates", "-o", "p.png"], tmp_path)
    assert (outcome.status, outcome.codes) == (2, ["NS0743"])
    assert not (tmp_path / "p.png").exists()
