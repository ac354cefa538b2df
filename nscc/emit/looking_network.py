"""The network of gates of a program whose pixels look at the light.

As `nscc.emit.network`, which says what its nodes are: from code, states and answers to what opens,
closes and resets, and to the states as the frame leaves them.
"""

from __future__ import annotations

from collections.abc import Iterator

import networkx as nx

from nscc.emit.network import KernelFinder, add_reads, gate_network, measured
from nscc.logic.problem import Gate
from nscc.looks.passes import LookingLowered
from nscc.looks.solve import LookingSolution, SetIn
from nscc.lower.allocate import words
from nscc.lower.lowered import Lowered
from nscc.operations import Effect, Op
from nscc.words.machine import LIGHT, Comparison, Machine


def network_of(lowered: Lowered) -> nx.DiGraph:
    """The network of any program's gates; see `nscc.emit.network` for nodes and attributes."""
    if isinstance(lowered, LookingLowered) and lowered.looking is not None:
        return _Maker(lowered, lowered.looking).made()
    return gate_network(lowered)


class _Maker:
    def __init__(self, lowered: LookingLowered, solution: LookingSolution) -> None:
        self.lowered, self.solution = lowered, solution
        self.machine = _machine(lowered)
        self.buckets = [bucket.name for bucket in lowered.program.buckets]
        self.allocation = lowered.schedule.allocation
        self.kernels = KernelFinder(lowered)
        self.resets_some = lowered.program.target.reset_honours_flag != "no"
        self.network = nx.DiGraph(
            encoding=solution.encoding.name, lowering=lowered.plan.lowering,
            shutters=lowered.plan.shutters, slots=lowered.plan.slots,
        )  # fmt: skip
        self.holds: dict[str, str] = {}
        self.counts = dict.fromkeys(("g", "l", "d"), 0)

    def made(self) -> nx.DiGraph:
        solution = self.solution
        for i, (vector, holder) in enumerate(zip(solution.planes, solution.holders, strict=True)):
            self._plane(f"p{i}", holder, vector)
        for i, holder in enumerate(solution.states):
            self._plane(f"s{i}", f"state {holder}", 0)
        for boundary, items in solution.items.items():
            looks = iter(_in_order(self.machine.at(boundary)))
            for item in items:
                if isinstance(item, Gate):
                    self._gate(item, boundary)
                elif not isinstance(item, SetIn):
                    self._word(item, boundary, looks)
        self._ends()
        return measured(self.network)

    def _named(self, letter: str) -> str:
        self.counts[letter] += 1
        return f"{letter}{self.counts[letter] - 1}"

    def _plane(self, name: str, holder: str, vector: int) -> None:
        register = self.allocation.places[name]
        self.network.add_node(
            name, kind="plane", register=register, name=name, holder=holder, bits=f"{vector:#x}"
        )
        self.holds[name] = name

    def _gate(self, gate: Gate, boundary: int) -> None:
        written = words((gate,), self.allocation)
        node = self._named("g")
        self.network.add_node(
            node, kind="gate", function=gate.name, name=gate.destination,
            register=self.allocation.places.get(gate.destination, gate.destination),
            words=len(written), boundary=boundary,
            kernel=self.kernels.kernel_of(written, boundary),
        )  # fmt: skip
        add_reads(self.network, node, gate, self.holds)
        self.holds[gate.destination] = node

    def _word(self, word: Op, boundary: int, looks: Iterator[Comparison]) -> None:
        """An analog word: it may write FLAG, or ask for it."""
        effect = word.operation.effect
        if effect is Effect.FLAG_ALL:
            self._gate_of_word(word, boundary)
        elif effect is Effect.FLAG_ANALOG:
            self._look(word, boundary, next(looks))
        elif effect is Effect.BUS:
            registers = self.lowered.plan.bucket_registers
            for bucket in (registers.index(r) for r in word.destinations if r in registers):
                self._demand("rise" if "PIX" in word.sources else "fall", bucket, boundary)
        elif effect is Effect.RESET_PIX and self.resets_some:
            # It stands twice: one word is too short to empty the well.
            resets = (each for _, each in self.network.nodes(data=True) if each["kind"] == "demand")
            if not any((each["edge"], each["boundary"]) == ("reset", boundary) for each in resets):
                self._demand("reset", None, boundary)

    def _gate_of_word(self, word: Op, boundary: int) -> None:
        node = self._named("g")
        self.network.add_node(
            node, kind="gate", function="SET", name="FLAG", register="FLAG", words=1,
            boundary=boundary, kernel=self.kernels.kernel_of((word,), boundary),
        )  # fmt: skip
        self.holds["FLAG"] = node

    def _look(self, word: Op, boundary: int, asked: Comparison) -> None:
        node = self._named("l")
        self.network.add_node(
            node, kind="look", function="where", name="FLAG", register="FLAG",
            signal="light" if asked.signal == LIGHT else self.buckets[asked.signal],
            steps=asked.level, boundary=boundary,
            kernel=self.kernels.kernel_of((word,), boundary),
        )  # fmt: skip
        self.holds["FLAG"] = node

    def _demand(self, edge: str, bucket: int | None, boundary: int) -> None:
        node = self._named("d")
        name = "" if bucket is None else self.buckets[bucket]
        self.network.add_node(node, kind="demand", edge=edge, bucket=name, boundary=boundary)
        self.network.add_edge(self.holds["FLAG"], node)

    def _ends(self) -> None:
        """The code as it was, and the states that are read or kept."""
        slots, told = self.lowered.plan.slots, set()
        states = zip(self.machine.states, self.solution.registers, strict=True)
        for state, names in states:
            for bit, name in enumerate(names):
                if state.read or state.kept:
                    node, register = f"z_{state.name}_{bit}", self.allocation.places[name]
                    self.network.add_node(
                        node, kind="state", state=state.name, bit=bit, register=register,
                        boundary=slots,
                    )  # fmt: skip
                    self.network.add_edge(self.holds[name], node)
                    told.add(name)
        for i in range(len(self.solution.planes)):
            if f"p{i}" not in told:
                register = self.allocation.places[f"p{i}"]
                self.network.add_node(f"e{i}", kind="end", register=register, boundary=slots)
                self.network.add_edge(self.holds[f"p{i}"], f"e{i}")


def _machine(lowered: LookingLowered) -> Machine:
    machine = lowered.program.machine
    assert machine is not None
    return machine


def _in_order(comparisons: tuple[Comparison, ...]) -> list[Comparison]:
    """The comparisons of a boundary as `nscc.looks.solve` makes them: those of one signal together,
    light last."""
    return sorted(comparisons, key=lambda each: -each.signal)
