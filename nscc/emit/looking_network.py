"""The network of gates of a program whose pixels look at the light.

As `nscc.emit.network`, which says what its nodes are: from code, states and answers to what opens,
closes and resets, and to the states as the frame leaves them.
"""

from __future__ import annotations

from collections.abc import Iterator

import networkx as nx

from nscc.emit.network import NetworkMaker, gate_network, measured
from nscc.logic.problem import Gate
from nscc.looks.passes import LookingLowered
from nscc.looks.solve import LookingSolution, SetIn
from nscc.lower.lowered import Lowered
from nscc.operations import Effect, Op
from nscc.words.machine import LIGHT, Comparison, Machine


def network_of(lowered: Lowered) -> nx.DiGraph:
    """The network of any program's gates; see `nscc.emit.network` for nodes and attributes."""
    if isinstance(lowered, LookingLowered) and lowered.looking is not None:
        return _Maker(lowered, lowered.looking).made()
    return gate_network(lowered)


class _Maker(NetworkMaker):
    def __init__(self, lowered: LookingLowered, solution: LookingSolution) -> None:
        super().__init__(lowered, solution.encoding.name)
        self.solution = solution
        self.machine = _machine(lowered)
        self.buckets = [bucket.name for bucket in lowered.program.buckets]
        self.resets_some = lowered.program.target.reset_honours_flag != "no"

    def made(self) -> nx.DiGraph:
        solution = self.solution
        self.planes(solution.planes, solution.holders)
        for i, holder in enumerate(solution.states):
            self.plane(f"s{i}", self.places[f"s{i}"], f"state {holder}", 0)
        for boundary, items in solution.items.items():
            looks = iter(_in_order(self.machine.at(boundary)))
            for item in items:
                if isinstance(item, Gate):
                    self.gate(item, boundary)
                elif not isinstance(item, SetIn):
                    self._word(item, boundary, looks)
        self._ends()
        return measured(self.network)

    def _word(self, word: Op, boundary: int, looks: Iterator[Comparison]) -> None:
        """An analog word: it may write FLAG, or ask for it."""
        effect = word.operation.effect
        if effect is Effect.FLAG_ALL:
            self.holds["FLAG"] = self.value("gate", "SET", "FLAG", (word,), boundary)
        elif effect is Effect.FLAG_ANALOG:
            asked = next(looks)
            signal = "light" if asked.signal == LIGHT else self.buckets[asked.signal]
            self.holds["FLAG"] = self.value(
                "look", "where", "FLAG", (word,), boundary, signal=signal, steps=asked.level
            )
        elif effect is Effect.BUS:
            registers = self.lowered.plan.bucket_registers
            edge = "rise" if "PIX" in word.sources else "fall"
            for bucket in (registers.index(r) for r in word.destinations if r in registers):
                self.demand(edge, self.buckets[bucket], boundary)
        elif effect is Effect.RESET_PIX and self.resets_some:
            # It stands twice: one word is too short to empty the well.
            resets = (each for _, each in self.network.nodes(data=True) if each["kind"] == "demand")
            if not any((each["edge"], each["boundary"]) == ("reset", boundary) for each in resets):
                self.demand("reset", "", boundary)

    def _ends(self) -> None:
        """The code as it was, and the states that are read or kept."""
        told = set()
        for state, names in zip(self.machine.states, self.solution.registers, strict=True):
            for bit, name in enumerate(names):
                if state.read or state.kept:
                    self.end(f"z_{state.name}_{bit}", name, kind="state", state=state.name, bit=bit)
                    told.add(name)
        for i in range(len(self.solution.planes)):
            if f"p{i}" not in told:
                self.end(f"e{i}", f"p{i}", kind="end")


def _machine(lowered: LookingLowered) -> Machine:
    machine = lowered.program.machine
    assert machine is not None
    return machine


def _in_order(comparisons: tuple[Comparison, ...]) -> list[Comparison]:
    """The comparisons of a boundary as `nscc.looks.solve` makes them: those of one signal together,
    light last."""
    return sorted(comparisons, key=lambda each: -each.signal)
