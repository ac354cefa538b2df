"""Execute digital words on the registers of pixels or of lanes."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Array, Indices
from nscc.chips.target import Target
from nscc.operations import Op, Phase, WordEffect

Bits = NDArray[np.int8]
"""One-bit values: 0, 1 or UNKNOWN."""
UNKNOWN = np.int8(2)


class Digital:
    """The one-bit registers of pixels while words run, including SELECT and the bus.

    `bits`: values (pixels,) by register, each 0, 1 or UNKNOWN. A register reads 0 if no word wrote
    it for more than `retention_us`, by the time `now_us`, which the caller advances. Where the mask
    register disables a write, the masked register keeps its value."""

    def __init__(self, target: Target, bits: Mapping[str, Array], retention_us: float) -> None:
        """Begin with `bits` (pixels,) by name, of all digital registers and of FLAG (the bit that
        lets a pixel act). Registers that are not written again within `retention_us` microseconds
        read 0."""
        self.bits: dict[str, Bits] = {name: plane.astype(np.int8) for name, plane in bits.items()}
        nothing = np.zeros_like(self.bits["FLAG"])
        self.bits |= {"SELECT": nothing, "bus": nothing}
        self.mask, self.masked = target.mask_register, target.masked_register
        self.written_us: dict[str, Array | float] = dict.fromkeys(self.bits, 0.0)
        self.retention_us, self.now_us = retention_us, 0.0

    @property
    def pixels(self) -> int:
        """Current number of pixels; `choose` and `merge` change it."""
        return len(self.bits["FLAG"])

    def read(self, name: str) -> Bits:
        """Return the bits (pixels,) of the register `name`: 0, 1 or UNKNOWN; 0 where they were
        written longer ago than the retention time. Callers do not change the array."""
        if self.retention_us == inf:
            return self.bits[name]
        is_retained = self.now_us - self.written_us[name] <= self.retention_us
        return np.where(is_retained, self.bits[name], np.int8(0))

    def write(self, name: str, value: Array) -> None:
        """Set a register in all pixels to `value` (pixels,), bool or 0, 1 and UNKNOWN, and note the
        time."""
        self.bits[name], self.written_us[name] = value.astype(np.int8), self.now_us

    def run(self, op: Op) -> None:
        """Execute the word `op` in all pixels. Words that are analog or compare are left to the
        caller: they change nothing here."""
        match op.operation.effect:
            case WordEffect.FLAG_ALL:
                self.write("FLAG", np.ones_like(self.bits["FLAG"]))
            case WordEffect.FLAG_DIGITAL:
                self.write("FLAG", self._or_sources(op))
            case WordEffect.DIGITAL:
                self._digital(op)

    def _digital(self, op: Op) -> None:
        """Run a digital word: put the OR of its sources on the bus, inverted if the word says so,
        and write the bus to its destinations.

        Of a pair of words, the first only reads and the second only writes."""
        row = op.operation
        if row.phase is not Phase.WRITE:
            any_source = self._or_sources(op)
            inverted = np.where(any_source == UNKNOWN, UNKNOWN, 1 - any_source)
            self.bits["bus"] = inverted if row.inverted else any_source
        if row.phase is Phase.READ:
            return
        # The mask as it was before this word guards the masked register.
        guard = None if self.mask is None else self.read(self.mask)
        for name in op.destinations:
            if name == self.masked and guard is not None:
                self._write_where(name, guard)
            else:
                self.write(name, self.bits["bus"])

    def _write_where(self, name: str, guard: Bits) -> None:
        """Write the bus to the masked register `name` where `guard` (pixels,) is 1, and keep its
        value where it is 0. Where `guard` is unknown, differing bits become unknown, and the time
        of writing is set, which is the later of the two possible ones."""
        old, new, before_us = self.read(name), self.bits["bus"], self.written_us[name]
        unsure = np.where(old == new, old, UNKNOWN)
        self.write(name, np.where(guard == 1, new, np.where(guard == 0, old, unsure)))
        if self.retention_us < inf:
            self.written_us[name] = np.where(guard == 0, before_us, self.now_us)

    def _or_sources(self, op: Op) -> Bits:
        """Return the OR of the sources of `op`: 1 if any is 1, else unknown if any is unknown, else
        0."""
        any_bit = np.zeros_like(self.bits["FLAG"])
        for name in op.sources:
            value = self.read(name)
            any_bit = np.where(
                (any_bit == 1) | (value == 1), np.int8(1), np.maximum(any_bit, value)
            )
        return any_bit

    def choose(self, pixels: Indices) -> None:
        """Replace the pixels by those with the indices `pixels` (new pixels,); an index may occur
        several times or never. Bits and times of writing follow."""
        self.bits = {name: values[pixels] for name, values in self.bits.items()}
        for name, values in self.written_us.items():
            if isinstance(values, np.ndarray):
                self.written_us[name] = values[pixels]

    def merge(self) -> Indices:
        """Merge pixels whose bits and times of writing are equal into one. Return for each old
        pixel (pixels,) the index of the new one."""
        # A time that is a single number is the same in all pixels.
        times = [
            written_us
            for written_us in self.written_us.values()
            if isinstance(written_us, np.ndarray)
        ]
        rows = np.stack([*self.bits.values(), *times])
        _, first, group = np.unique(rows, axis=1, return_index=True, return_inverse=True)
        self.choose(first)
        return np.asarray(group.reshape(-1))
