"""The gates of a frame as a network of values.

Each value that is written to a register is a node (static single assignment), and each edge leads
from a value to a reader. The network is executable: it contains the bits of every plane and the
function of every gate.

The graph's attributes are `encoding`, `lowering`, `shutters`, `slots`, `depth` (gates on the
longest path) and `registers` (see `registers_needed`). Its nodes are in execution order and have a
`kind`:

* plane: the initial content of a register: `register`, `name` in the listing of the gates, `holder`
  in words, `bits` as a hexadecimal number, bit i for shutter i of the decode table
* gate: `function` WHERE or OR, NOR, MOV (OR of one), NOT, SET (1), CLR (0) of its predecessors; the
  `register` that it writes (FLAG for WHERE), the value's `name`, `words`, `boundary`, and the
  `kernel` that contains it. A masked gate also has `operands`, the nodes that its function reads,
  separated by spaces, and the nodes `mask` and `before`: where `mask` is 0, its value is `before`
* demand: a required value of FLAG: `edge` "open", "rise", "fall" or "reset", `bucket` ("" if PIX is
  reset), `boundary`
* end: the required final content of a plane: `register`, `boundary`

In a program with senses, planes include the registers of its states: cleared by the frame's first
words or kept from the previous frame. Bits are for the behaviours of its machine. There are two
more kinds:

* look: an answer in FLAG, which comes from no gate: `function` where, `signal` "light" or a bucket,
  `steps` of IN, `boundary`, `kernel`. It is 1 if the signal is at most the level
* state: the final bit of a state: `state`, `bit`, `register`, `boundary`"""

from __future__ import annotations

import io
import json
from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import chain

import networkx as nx

from nscc.logic.problem import MASK, Gate, Segment
from nscc.lower.lowered import Lowered
from nscc.lower.schedule import words
from nscc.operations import Op


def network_of(lowered: Lowered) -> nx.DiGraph:
    """Return the gates of a program as a network (see the module); its shutters must depend on the
    code only, so that pixels do not look at their light."""
    solution = lowered.solution
    maker = NetworkMaker(lowered, solution.encoding)
    maker.planes(solution.planes, solution.holders)

    def add(segments: Iterable[Segment], boundary: int) -> None:
        """Add the gates of segments, which run at a boundary, to the network."""
        for gate in chain.from_iterable(segments):
            maker.gate(gate, boundary)

    add(solution.opening, 0)
    steps = [step for step in lowered.plan.steps if step.predicate is not None]
    for step, answer in zip(steps, solution.answers, strict=True):
        add(answer, step.boundary)
        maker.demand(step.role, lowered.program.buckets[step.bucket].name, step.boundary)
    add(solution.closing, lowered.plan.slots)
    for i in range(len(solution.planes)):
        maker.end(f"e{i}", f"p{i}", kind="end")
    return measured(maker.network)


class NetworkMaker:
    """A network of gates under construction.

    `network` has the nodes so far, and `holds` the node of the current value of each virtual
    register and of FLAG. Gates must be added in execution order, after the planes. FLAG is the bit
    that lets a pixel act."""

    def __init__(self, lowered: Lowered, encoding: str) -> None:
        """Begin with an empty network; its graph attributes name encoding, lowering (way to compute
        the exposure) and size."""
        plan = lowered.plan
        self.lowered = lowered
        self.chip_registers = lowered.schedule.allocation.chip_registers
        self.kernels = KernelFinder(lowered)
        self.network = nx.DiGraph(
            encoding=encoding, lowering=plan.lowering, shutters=plan.shutters, slots=plan.slots
        )
        self.holds: dict[str, str] = {}
        self._counts = Counter[str]()

    def planes(self, vectors: Iterable[int], holders: Iterable[str]) -> None:
        """Add the nodes p0, p1, .. of the code registers' initial values.

        `vectors` are their bits for all shutters, bit k for shutter k, and `holders` say in words
        what they hold; both are in the order of the planes."""
        for i, (vector, holder) in enumerate(zip(vectors, holders, strict=True)):
            self.plane(f"p{i}", self.chip_registers[f"p{i}"], holder, vector)

    def plane(self, name: str, register: str, holder: str, vector: int) -> None:
        """Add the node of a register's initial value.

        `name` is the register's virtual name, which becomes that of the node, `register` the chip's
        register, and `holder` says what it holds. Bit k of `vector` belongs to shutter k."""
        self.network.add_node(
            name, kind="plane", register=register, name=name, holder=holder, bits=f"{vector:#x}"
        )
        self.holds[name] = name

    def gate(self, gate: Gate, boundary: int) -> None:
        """Add the node of a gate that runs at a boundary, with edges from the values that it reads;
        all of them must have been written.

        The gate's register then holds its result. Raises ValueError if the boundary does not run
        the gate's words."""
        written = words((gate,), self.lowered.schedule.allocation)
        node = self.value("gate", gate.name, gate.destination, written, boundary)
        for source in gate.reads:
            self.network.add_edge(self.holds[source], node)
        if gate.masked:
            operands = " ".join(self.holds[source] for source in gate.sources)
            mask, before = self.holds[MASK], self.holds[gate.destination]
            self.network.add_node(node, operands=operands, mask=mask, before=before)
        self.holds[gate.destination] = node

    def value(
        self,
        kind: str,
        function: str,
        name: str,
        written: Sequence[Op],
        boundary: int,
        **look: str | int,
    ) -> str:
        """Add the node of a value that the words `written` store in the register `name` at a
        boundary.

        `kind` is "gate" or "look", `function` the attribute of that name, `name` a virtual register
        or FLAG (the bit that lets a pixel act). `look` has further attributes of the answer of a
        comparison; a gate has the number of its words instead. Return the node's name. Raises
        ValueError if the boundary does not run the words."""
        node = self._named(kind[0])
        self.network.add_node(
            node,
            kind=kind,
            function=function,
            name=name,
            register=self.chip_registers.get(name, name),
            **look or {"words": len(written)},
            boundary=boundary,
            kernel=self.kernels.kernel_of(tuple(written), boundary),
        )
        return node

    def demand(self, edge: str, bucket: str, boundary: int) -> None:
        """Add the node of a demand: what the value of FLAG (the bit that lets a pixel act) is
        needed for at a boundary. FLAG must have been written.

        `edge` is "open", "rise", "fall" or "reset", and `bucket` is the bucket's name, "" for a
        reset. A demand is a set of shutters that FLAG must select at a boundary."""
        node = self._named("d")
        self.network.add_node(node, kind="demand", edge=edge, bucket=bucket, boundary=boundary)
        self.network.add_edge(self.holds["FLAG"], node)

    def end(self, node: str, name: str, **attributes: str | int) -> None:
        """Add the node `node` of a register's required final value, with further attributes, of
        which `kind` must be one; `name` is the virtual register."""
        register, slots = self.chip_registers[name], self.lowered.plan.slots
        self.network.add_node(node, **attributes, register=register, boundary=slots)
        self.network.add_edge(self.holds[name], node)

    def _named(self, letter: str) -> str:
        """Return a new name of a node: the letter and the number of earlier nodes of this letter,
        such as g0, g1, .."""
        self._counts[letter] += 1
        return f"{letter}{self._counts[letter] - 1}"


def measured(network: nx.DiGraph) -> nx.DiGraph:
    """Return a complete network after setting its attributes `depth` and `registers`.

    They are the most gates in a row, and the number of registers that the gates need."""
    network.graph |= {"depth": depth(network), "registers": registers_needed(network)}
    return network


class KernelFinder:
    """Finds the kernel (list of words) that contains each gate's words, gate after gate in
    execution order."""

    def __init__(self, lowered: Lowered) -> None:
        """List the words that run at each boundary, with their kernels (lists of words).

        Kernels that only write registers again (refresh) are left out, because they have no gates.
        """
        schedule = lowered.schedule
        refreshes = set(lowered.time.refresh_at or ())
        self._run: dict[int, list[tuple[Op, int]]] = {}
        for boundary, number in schedule.launches:
            kernel = schedule.kernels[number]
            # A refresh is the first kernel of its boundary.
            if boundary in refreshes and boundary not in self._run:
                self._run[boundary] = []
                if any(word.operation.name.startswith("REFRESH") for word in kernel):
                    continue  # not gates: registers written back to themselves
            self._run.setdefault(boundary, []).extend((word, number) for word in kernel)
        self._next = dict.fromkeys(self._run, 0)

    def kernel_of(self, gate: tuple[Op, ...], boundary: int) -> int:
        """Return the number of the kernel (list of words) that contains the boundary's next gate,
        which is given by its words.

        Must be called in the order of gates. Raises ValueError if the boundary does not run these
        words."""
        run, position = self._run[boundary], self._next[boundary]
        while tuple(word for word, _ in run[position : position + len(gate)]) != gate:
            if position >= len(run):
                raise ValueError(f"boundary {boundary} does not launch its gates")
            position += 1
        self._next[boundary] = position + len(gate)
        return run[position][1]


def depth(network: nx.DiGraph) -> int:
    """Return the number of gates on the longest path of a network."""
    gates = [node for node, kind in network.nodes(data="kind") if kind == "gate"]
    return len(nx.dag_longest_path(network.subgraph(gates)))


def registers_needed(network: nx.DiGraph) -> int:
    """Return the fewest registers, including FLAG (the bit that lets a pixel act), that can hold
    all values in this order of gates.

    That is the largest number of values that are alive at the same time. Planes are alive before
    the first gate. A gate may overwrite a register that it reads for the last time. A value that
    nothing reads needs a register only while it is written. An empty network needs none."""
    last = {value: reader for reader in network for value in network.predecessors(reader)}
    alive: set[str] = set()
    most = 0
    for node, kind in network.nodes(data="kind"):
        alive -= {value for value in network.predecessors(node) if last[value] == node}
        if kind in ("plane", "gate", "look"):
            most = max(most, len(alive) + 1)
            if node in last:
                alive.add(node)
    return most


def graphml_bytes(network: nx.DiGraph) -> bytes:
    """Return the network as GraphML, the bytes of a file."""
    out = io.BytesIO()
    # Named explicitly: `write_graphml` selects another writer if lxml is installed.
    nx.write_graphml_xml(network, out)
    return out.getvalue() + b"\n"


_SHAPES = {
    "plane": "box",
    "gate": "ellipse",
    "look": "diamond",
    "demand": "invhouse",
    "end": "box",
    "state": "box",
}


def dot_text(network: nx.DiGraph) -> str:
    """Return the network as Graphviz DOT, drawn from left to right: a shape for each kind of node,
    with two lines of text."""
    lines = ["digraph gates {", "  rankdir=LR;", "  node [fontname=monospace];"]
    lines.append(f"  label={_quoted([network.graph['encoding']])};")
    for node, attributes in network.nodes(data=True):
        shape = _SHAPES[attributes["kind"]]
        lines.append(f"  {node} [shape={shape}, label={_quoted(_label(attributes))}];")
    lines += (f"  {value} -> {reader};" for value, reader in network.edges)
    return "\n".join([*lines, "}"]) + "\n"


def _label(node: dict[str, str | int]) -> list[str]:
    """Return one or two lines of text that describe a node: what it is, and its register and
    boundary. `node` has the node's attributes, as listed in the module."""
    match node["kind"]:
        case "plane":
            return [f"{node['name']} in {node['register']}", str(node["holder"])]
        case "gate":
            name = f"{node['function']} {node['name']}"
            return [name, f"{node['register']}, boundary {node['boundary']}"]
        case "look":
            comparison_text = f"{node['signal']} at most {node['steps']} steps"
            return [comparison_text, f"FLAG, boundary {node['boundary']}"]
        case "demand":
            return [f"{node['edge']} of {node['bucket'] or 'PIX'}", f"boundary {node['boundary']}"]
        case "state":
            return [f"{node['state']}, bit {node['bit']}", str(node["register"])]
        case _:
            return [f"{node['register']} as it was"]


def _quoted(lines: Iterable[str]) -> str:
    """Return a DOT string of these lines; JSON escapes the same characters."""
    return '"' + "\\n".join(json.dumps(line, ensure_ascii=False)[1:-1] for line in lines) + '"'
