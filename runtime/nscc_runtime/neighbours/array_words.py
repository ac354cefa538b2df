"""Convert the words of images and planes to tables for the compiled loop."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.operations import NEIGHBOURS, STEERING, STEPS, Op, Phase, WordEffect
from nscc.words.live import live_registers
from nscc_runtime.neighbours import array_loop as loop
from nscc_runtime.neighbours.pixels import RANGE_BIT

_KINDS = {
    WordEffect.BUS: loop.BUS,
    WordEffect.FLAG_ANALOG: loop.COMPARE,
    WordEffect.FLAG_ALL: loop.BITS,
    WordEffect.FLAG_DIGITAL: loop.BITS,
    WordEffect.DIGITAL: loop.BITS,
    WordEffect.DIGITAL_NEIGHBOURS: loop.NEIGHBOURS,
}
_FLAGS = (WordEffect.FLAG_ALL, WordEffect.FLAG_DIGITAL, WordEffect.FLAG_ANALOG)
Operand = tuple[int, int, int]


@dataclass(frozen=True, eq=False)
class ArrayContents:
    """The contents of registers after the words, by name; all arrays are (pixels,).

    `register`: analog registers in electrons. `cut_by`: their saturation marks. `bits`: digital
    registers."""

    register: Mapping[str, NDArray[np.float64]]
    cut_by: Mapping[str, NDArray[np.uint8]]
    bits: Mapping[str, NDArray[np.uint8]]

    def bit(self, name: str) -> NDArray[np.bool_]:
        return np.asarray(self.bits[name] == 1)

    def hold(self, seconds: float) -> None:
        """Do nothing: registers without effects do not decay."""


class ArrayWords:
    """Words in their order, each with its steps of IN, prepared for arrays of a target."""

    def __init__(self, target: Target, words: Iterable[tuple[Op, int | None]]) -> None:
        self.target = target
        self.analog = {name: n for n, name in enumerate(target.analog_registers)}
        names = (*target.digital_registers, "FLAG", "SELECT", "bus")
        self.digital = {name: n for n, name in enumerate(names)}
        words = tuple(words)
        self._live = live_registers((op for op, _ in words), target)[0]
        rows, operands = [], list[Operand]()
        in_e, lag, everywhere, vertical = 0.0, 0, False, False
        for op, level in words:
            in_e = in_e if level is None else level * target.electrons_per_step
            effect, phase = op.operation.effect, op.operation.phase
            if effect not in _KINDS:
                continue
            sources, destinations = self._operands(op)
            before, vertical = vertical, any(down for *_, down in (*sources, *destinations))
            # A word reads and writes at most one row beside its own.
            lag += 2 * (before or vertical)
            inverted = op.operation.inverted and phase is not Phase.WRITE
            rows.append((
                _KINDS[effect], 3 * len(operands), len(sources), len(destinations),
                op.operation.divisor, inverted or effect is WordEffect.FLAG_ALL, lag, everywhere,
                in_e,
            ))  # fmt: skip
            operands += [*sources, *destinations]
            if effect in _FLAGS:
                everywhere = effect is WordEffect.FLAG_ALL
        self._rows = np.array(rows, np.dtype(loop.ArrayWord))
        self._operands_table = np.array(operands, np.int64).reshape(-1)

    def _operands(self, op: Op) -> tuple[list[Operand], list[Operand]]:
        """Return the sources and the destinations of a word."""
        effect, phase = op.operation.effect, op.operation.phase
        if effect in (WordEffect.BUS, WordEffect.FLAG_ANALOG):
            return list(map(self._analog, op.sources)), list(map(self._analog, op.destinations))
        if effect is WordEffect.DIGITAL_NEIGHBOURS:
            named = (op.destinations[0], op.sources[0])
            steering = [(self.digital[name], *step) for name, step in STEERING.items()]
            return [*((self.digital[name], 0, 0) for name in named), *steering], []
        sources = ("bus",) if phase is Phase.WRITE else op.sources
        destinations = ("bus",) if phase is Phase.READ else op.destinations
        if effect in _FLAGS:
            destinations = ("FLAG",)
        masked = self.target.masked_register
        ordered = sorted(destinations, key=lambda name: name != masked)
        return [(self.digital[name], 0, 0) for name in sources], [
            (self.digital[name], 0, 0) for name in ordered
        ]

    def _analog(self, name: str) -> Operand:
        if name in NEIGHBOURS:
            return (self.analog["NEWS"], *STEPS[name])
        return (loop.LEVEL if name == "IN" else self.analog[name]), 0, 0

    def run(
        self,
        shape: tuple[int, int],
        exposed: Mapping[str, NDArray[np.float64]],
        exposed_by: Mapping[str, NDArray[np.uint8]],
        code: Mapping[str, NDArray[np.bool_]],
    ) -> ArrayContents:
        """Return the contents of registers after the words.

        Before the words, registers hold `exposed` (electrons) with the marks `exposed_by`, and the
        bits of `code`. All other registers hold 0, and have no marks."""
        target, pixels = self.target, shape[0] * shape[1]
        allocate = np.empty if self._live <= {*exposed, *code, "IN"} else np.zeros
        size = len(self.analog) * pixels
        zeros = shape[1] + 1
        values, marks = allocate(size + zeros), np.zeros(size + zeros, np.uint8)
        values[size:] = 0.0
        bits = allocate(len(self.digital) * pixels, np.uint8)
        register = dict(zip(self.analog, values[:size].reshape(-1, pixels), strict=True))
        cut_by = dict(zip(self.analog, marks[:size].reshape(-1, pixels), strict=True))
        bit = dict(zip(self.digital, bits.reshape(-1, pixels), strict=True))
        for name, exposure in exposed.items():
            register[name][:] = exposure
        for name, by in exposed_by.items():
            cut_by[name][:] = by
        for name, plane in code.items():
            bit[name][:] = plane
        guarded = None not in (target.mask_register, target.masked_register)
        loop.run_array_words(
            shape=loop.ArrayShape(
                words=len(self._rows), registers=len(self.analog), rows=shape[0], cols=shape[1],
                flag=self.digital["FLAG"],
                mask=self.digital[target.mask_register or ""] if guarded else -1,
                masked=self.digital[target.masked_register or ""] if guarded else -1,
                obeys_flag=int(target.where_obeys_flag), lowest=target.register_min_e,
                highest=target.register_max_e, range_bit=RANGE_BIT,
            ),
            words=self._rows, operands=self._operands_table, values=values, marks=marks, bits=bits,
            total=np.empty(shape[1]), mark=np.empty(shape[1], np.uint8),
            marked=np.array([bool(exposed_by)], np.int64),
        )  # fmt: skip
        return ArrayContents(register, cut_by, bit)
