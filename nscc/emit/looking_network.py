"""The gate network of programs with senses; `nscc.emit.network` describes nodes and attributes.

The network leads from codes, states and answers to shutter changes, resets and final states."""

from __future__ import annotations

from collections.abc import Iterator

import networkx as nx

from nscc.emit.network import NetworkMaker, gate_network, measured
from nscc.logic.problem import Gate
from nscc.looks.passes import LookingLowered
from nscc.looks.solve import LookingSolution, SetIn
from nscc.lower.lowered import Lowered
from nscc.operations import Op, WordEffect
from nscc.words.machine import LIGHT, Comparison, StateMachine


def network_of(lowered: Lowered) -> nx.DiGraph:
    """Return the gate network of any program; see `nscc.emit.network` for nodes and attributes."""
    if isinstance(lowered, LookingLowered) and lowered.looking is not None:
        return _Maker(lowered, lowered.looking).build_network()
    return gate_network(lowered)


class _Maker(NetworkMaker):
    def __init__(self, lowered: LookingLowered, solution: LookingSolution) -> None:
        super().__init__(lowered, solution.encoding.name)
        self.solution = solution
        self.machine = _machine(lowered)
        self.buckets = [bucket.name for bucket in lowered.program.buckets]
        self.resets_some = lowered.program.target.reset_honours_flag != "no"

    def build_network(self) -> nx.DiGraph:
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
        """Add an analog word that writes FLAG or depends on FLAG."""
        effect = word.operation.effect
        if effect is WordEffect.FLAG_ALL:
            self.holds["FLAG"] = self.value("gate", "SET", "FLAG", (word,), boundary)
        elif effect is WordEffect.FLAG_ANALOG:
            comparison = next(looks)
            signal = "light" if comparison.signal == LIGHT else self.buckets[comparison.signal]
            self.holds["FLAG"] = self.value(
                "look", "where", "FLAG", (word,), boundary, signal=signal, steps=comparison.level
            )
        elif effect is WordEffect.BUS:
            registers = self.lowered.plan.bucket_registers
            edge = "rise" if "PIX" in word.sources else "fall"
            for bucket in (registers.index(r) for r in word.destinations if r in registers):
                self.demand(edge, self.buckets[bucket], boundary)
        elif effect is WordEffect.RESET_PIX and self.resets_some:
            # It is there twice: one word is too short to reset the photodiode.
            resets = (node for _, node in self.network.nodes(data=True) if node["kind"] == "demand")
            if not any((node["edge"], node["boundary"]) == ("reset", boundary) for node in resets):
                self.demand("reset", "", boundary)

    def _ends(self) -> None:
        """Add the final values: the restored code, and states that are read out or kept."""
        ended = set()
        for state, names in zip(self.machine.states, self.solution.registers, strict=True):
            for bit, name in enumerate(names):
                if state.read or state.is_kept:
                    self.end(f"z_{state.name}_{bit}", name, kind="state", state=state.name, bit=bit)
                    ended.add(name)
        for i in range(len(self.solution.planes)):
            if f"p{i}" not in ended:
                self.end(f"e{i}", f"p{i}", kind="end")


def _machine(lowered: LookingLowered) -> StateMachine:
    machine = lowered.program.machine
    assert machine is not None
    return machine


def _in_order(comparisons: tuple[Comparison, ...]) -> list[Comparison]:
    """Return the comparisons of a boundary in the order of `nscc.looks.solve`: by signal, light
    last."""
    return sorted(comparisons, key=lambda comparison: -comparison.signal)
