"""The digital registers of many lanes at once, with bits that may be unknown."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.operations import Effect, Op, Phase

Bits = NDArray[np.int8]
"""0, 1 or UNKNOWN."""
UNKNOWN = np.int8(2)


class Registers:
    """As pixels have them under their words; `loaded` (lanes,) by register, others are unknown.

    A register reads 0 when no word wrote it for more than `retention_us`.
    """

    def __init__(self, target: Target, loaded: Mapping[str, Bits], retention_us: float) -> None:
        names = (*target.digital_registers, "FLAG", "SELECT", "bus")
        lanes = len(next(iter(loaded.values()))) if loaded else 1
        self.place = {name: i for i, name in enumerate(names)}
        self.bits = np.full((len(names), lanes), UNKNOWN, np.int8)
        nothing = np.zeros(lanes, np.int8)
        for name, values in {"SELECT": nothing, "bus": nothing, **loaded}.items():
            self.bits[self.place[name]] = values
        self.mask, self.masked = target.mask_register, target.masked_register
        self.written_us = dict.fromkeys(names, 0.0)
        self.retention_us, self.now_us = retention_us, 0.0

    @property
    def lanes(self) -> int:
        """How many there are by now."""
        return self.bits.shape[1]

    def read(self, name: str) -> Bits:
        """A register (lanes,), 0 where it has decayed."""
        if self.now_us - self.written_us[name] > self.retention_us:
            return np.zeros(self.lanes, np.int8)
        return np.array(self.bits[self.place[name]])

    def write(self, name: str, value: Bits) -> None:
        """A register (lanes,) is set."""
        self.bits[self.place[name]] = value
        self.written_us[name] = self.now_us

    def run(self, op: Op) -> None:
        """One word that neither is analog nor compares."""
        match op.operation.effect:
            case Effect.FLAG_ALL:
                self.write("FLAG", np.ones(self.lanes, np.int8))
            case Effect.FLAG_DIGITAL:
                self.write("FLAG", self._some(op))
            case Effect.DIGITAL:
                self._digital(op)

    def _digital(self, op: Op) -> None:
        row = op.operation
        if row.phase is not Phase.WRITE:
            value = self._some(op)
            if row.inverted:
                value = np.where(value == UNKNOWN, UNKNOWN, 1 - value).astype(np.int8)
            self.bits[self.place["bus"]] = value
        if row.phase is Phase.READ:
            return
        # What guards the masked register is the mask as it was before this word.
        guard = None if self.mask is None else self.read(self.mask)
        for name in op.destinations:
            value = self.bits[self.place["bus"]].copy()
            if name == self.masked and guard is not None:
                old = self.read(name)
                unsure = np.where(old == value, old, UNKNOWN)
                value = np.where(guard == 1, value, np.where(guard == 0, old, unsure))
            self.write(name, value)

    def _some(self, op: Op) -> Bits:
        found = np.zeros(self.lanes, np.int8)
        for name in op.sources:
            value = self.read(name)
            found = np.where((found == 1) | (value == 1), 1, np.maximum(found, value))
        return found.astype(np.int8)

    def choose(self, lanes: NDArray[np.intp]) -> None:
        """Go on with these lanes."""
        self.bits = self.bits[:, lanes]

    def merge(self) -> NDArray[np.intp]:
        """Make one lane of all whose bits are the same; which one each has become."""
        self.bits, group = np.unique(self.bits, axis=1, return_inverse=True)
        return np.asarray(group.reshape(-1))
