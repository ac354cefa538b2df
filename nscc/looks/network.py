"""The gates of a program with senses as a network; `nscc.emit.network` describes it."""

from __future__ import annotations

from collections.abc import Iterator

import networkx as nx

from nscc.emit.network import NetworkMaker, measured
from nscc.logic.problem import Gate
from nscc.looks.passes import LookingLowered
from nscc.looks.solve import SetIn
from nscc.operations import Op, WordEffect
from nscc.words.machine import LIGHT, Comparison


class LookingNetwork(NetworkMaker):
    """Makes the network of gates of a program with senses.

    It leads from codes, states and answers to shutter changes, resets and final states.
    `resets_some` tells whether the chip can reset PIX (the photodiode) in some pixels only, so that
    a reset depends on FLAG. FLAG is the bit that lets a pixel act."""

    def __init__(self, lowered: LookingLowered) -> None:
        """Begin an empty network of a lowered program with senses; `build_network` fills it."""
        super().__init__(lowered, lowered.looking.encoding.name)
        self.solution = lowered.looking
        self.machine = lowered.program.machine
        self.buckets = [bucket.name for bucket in lowered.program.buckets]
        self.resets_some = lowered.program.target.reset_honours_flag != "no"

    def build_network(self) -> nx.DiGraph:
        """Return the network of a whole frame as a graph: code registers, gates, comparisons and
        final values.

        It may be called once, because it fills the network."""
        solution = self.solution
        self.planes(solution.planes, solution.holders)
        for i, holder in enumerate(solution.states):
            self.plane(f"s{i}", self.chip_registers[f"s{i}"], f"state {holder}", vector=0)
        for boundary, items in solution.items.items():
            comparisons = self.machine.at(boundary)
            looks = iter([comparisons[i] for i in self.machine.order(boundary)])
            for item in items:
                if isinstance(item, Gate):
                    self.gate(item, boundary)
                elif not isinstance(item, SetIn):
                    self._word(item, boundary, looks)
        # The final values: the restored code, and states that are read out or kept.
        ended = set()
        for state, names in zip(self.machine.states, self.solution.registers, strict=True):
            for bit, name in enumerate(names):
                if state.read or state.is_kept:
                    self.end(f"z_{state.name}_{bit}", name, kind="state", state=state.name, bit=bit)
                    ended.add(name)
        for i in range(len(self.solution.planes)):
            if f"p{i}" not in ended:
                self.end(f"e{i}", f"p{i}", kind="end")
        return measured(self.network)

    def _word(self, word: Op, boundary: int, looks: Iterator[Comparison]) -> None:
        """Add the node of an analog word that writes FLAG (the bit that lets a pixel act), opens or
        closes a shutter, or resets PIX (the photodiode); add none for other words.

        `looks` yields the comparisons of `boundary` in the order in which words make them."""
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
            # The word that opens a bucket's shutter reads PIX itself; one that closes it reads the
            # scratch.
            edge = "rise" if "PIX" in word.sources else "fall"
            for bucket in (registers.index(r) for r in word.destinations if r in registers):
                self.demand(edge, self.buckets[bucket], boundary)
        elif effect is WordEffect.RESET_PIX and self.resets_some:
            # It is there twice: one word is too short to reset the photodiode.
            resets = (node for _, node in self.network.nodes(data=True) if node["kind"] == "demand")
            if not any((node["edge"], node["boundary"]) == ("reset", boundary) for node in resets):
                self.demand("reset", "", boundary)
