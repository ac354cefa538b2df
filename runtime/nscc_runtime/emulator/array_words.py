"""Translate words into tables for the compiled loop `nscc_runtime.emulator.array_loop`.

`nscc.operations` defines the words; this file only lists their operands."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools, Ints
from nscc.chips.target import Target
from nscc.operations import NEIGHBOURS, STEERING, STEPS, Op, Phase, WordEffect
from nscc_runtime.emulator import array_loop as loop

_KINDS = {
    WordEffect.RESET_PIX: loop.BUS,
    WordEffect.BUS: loop.BUS,
    WordEffect.FLAG_ANALOG: loop.COMPARE,
    WordEffect.FLAG_ALL: loop.BITS,
    WordEffect.FLAG_DIGITAL: loop.BITS,
    WordEffect.DIGITAL: loop.BITS,
    WordEffect.DIGITAL_NEIGHBOURS: loop.NEIGHBOURS,
    WordEffect.PROPAGATION: loop.PROPAGATION,
}
_FLAGS = (WordEffect.FLAG_ALL, WordEffect.FLAG_DIGITAL, WordEffect.FLAG_ANALOG)
Operand = tuple[int, int, int]


class ArrayWords:
    """Words of a target as the loop reads them.

    `analog`, `digital`: the numbers of registers by name. The last two analog registers are PIX
    (the photodiode) and minus its reset level. SELECT contains zeros, because no address matches.
    `reaches_neighbours`: whether any word reads or writes a register of another pixel."""

    def __init__(self, target: Target) -> None:
        """Number the registers of `target`, and begin with an empty table of words. The order of
        numbers is part of the interface: PIX (the photodiode) and its level come last of the analog
        registers, FLAG, SELECT and the bus last of the digital ones. FLAG is the bit that lets a
        pixel act."""
        self.target = target
        analog = (*target.analog_registers, "PIX", "level")
        self.analog = {name: number for number, name in enumerate(analog)}
        digital = (*target.digital_registers, "FLAG", "SELECT", "bus")
        self.digital = {name: number for number, name in enumerate(digital)}
        self._rows: list[tuple[float, ...]] = []
        self._operands: list[Operand] = []
        self._known: dict[Op, tuple[int, ...]] = {}
        self.reaches_neighbours = False
        self._analog_words = 0

    def append(self, words: Iterable[tuple[Op, float]]) -> int:
        """Append words, each with the value of IN (the level sent to all pixels) in electrons, in
        the order of execution; words without effect are left out. Return the number of all words so
        far. The words of one call are run together: only among these a word may run some rows
        behind another."""
        lag, vertical = 0, False
        for op, in_e in words:
            number, self._analog_words = self._analog_words, self._analog_words + op.analog
            if op.operation.effect is WordEffect.NONE:
                continue
            if op not in self._known:
                self._known[op] = self._translated(op)
            *columns, reaches = self._known[op]
            before, vertical = vertical, bool(reaches)
            # A word reads and writes at most one row beside its own.
            lag += 2 * (before or vertical)
            sources_e = in_e if "IN" in op.sources else 0.0
            self._rows.append((*columns, lag, sources_e, len(op.sources) > 1, number))
        return len(self._rows)

    @property
    def table(self) -> tuple[NDArray[np.void], Ints]:
        """All words and their operands, as arrays for the loop."""
        words = np.array(self._rows, np.dtype(loop.ArrayWord))
        return words, np.array(self._operands, np.int64).reshape(-1)

    def shape(
        self, rows: int, cols: int, length: int, registers: int, range_bit: int = 0
    ) -> loop.ArrayShape:
        """Return the shape of an array with values of the first `registers` analog registers.

        `length`: numbers in a row of values, more than `cols` if words reach neighbours.
        `range_bit`: saturation mark of values beyond the range, 0 to record none."""
        target, last = self.target, registers * (rows + 1)
        guarded = None not in (target.mask_register, target.masked_register)
        return loop.ArrayShape(
            rows=rows,
            cols=cols,
            length=length,
            plane_words=-(-cols // 64),
            count=len(self._rows),
            total=(last + 1) * length,
            part=(last + 3) * length,
            normals=(last + 5) * length,
            flag=self.digital["FLAG"],
            bus=self.digital["bus"],
            zero=self.digital["SELECT"],
            mask=self.digital[target.mask_register or ""] if guarded else -1,
            masked=self.digital[target.masked_register or ""] if guarded else -1,
            obeys_flag=int(target.where_obeys_flag),
            lowest=target.register_min_e,
            highest=target.register_max_e,
            range_bit=range_bit,
        )

    def state(self, shape: loop.ArrayShape, operands: Ints) -> loop.ArrayState:
        """Return registers of an array of `shape` that hold 0, without saturation marks, and the
        words' `operands`. Words have no errors."""
        # Groups of 64 pixels may extend beyond the last row of zeros.
        values = np.zeros(shape.normals + 2 * shape.length + 64)
        return loop.ArrayState(
            operands=operands,
            errors=np.zeros(1, np.dtype(loop.ArrayErrors)),
            values=values,
            marks=np.zeros(len(values) if shape.range_bit else 0, np.uint8),
            planes=np.zeros(len(self.digital) * shape.rows * shape.plane_words, np.uint64),
            marked=np.zeros(1, np.int64),
        )

    def _translated(self, op: Op) -> tuple[int, ...]:
        """Append the operands of the word `op`, and return the fields of its `ArrayWord` from
        `kind` to `everywhere`, then whether it reads or writes another row."""
        row, effect = op.operation, op.operation.effect
        sources, destinations = self._of_effect(op)
        first = 3 * len(self._operands)
        self._operands += [*sources, *destinations]
        self.reaches_neighbours |= any(
            right or down for _, right, down in (*sources, *destinations)
        )
        # "unknown" is taken as "yes": the chip that resets less.
        resets = effect is WordEffect.RESET_PIX
        return (
            _KINDS[effect],
            first,
            len(sources),
            len(destinations),
            self.target.propagation_pixels if effect is WordEffect.PROPAGATION else row.divisor,
            effect is WordEffect.FLAG_ALL or (row.inverted and row.phase is not Phase.WRITE),
            resets and self.target.reset_honours_flag == "no",
            any(down for *_, down in (*sources, *destinations)),
        )

    def _of_effect(self, op: Op) -> tuple[list[Operand], list[Operand]]:
        """Return the sources and the destinations of the word `op` in the order in which the loop
        expects them for its kind. Each is the number of a register and the step to the pixel:
        columns to the right, rows down."""
        effect, phase = op.operation.effect, op.operation.phase
        if effect is WordEffect.RESET_PIX:
            return [(self.analog["level"], 0, 0)], [(self.analog["PIX"], 0, 0)]
        if effect in (WordEffect.BUS, WordEffect.FLAG_ANALOG):
            read = [self._analog(name) for name in op.sources if name != "IN"]
            return read, [self._analog(name) for name in op.destinations]
        if effect is WordEffect.PROPAGATION:
            steering = [(self.digital[name], *step) for name, step in STEERING.items()]
            named = self._digital(("bus", op.destinations[0]))
            return [*named, *steering], self._digital((self.target.mask_register or "",))
        if effect is WordEffect.DIGITAL_NEIGHBOURS:
            named = self._digital((op.destinations[0], op.sources[0]))
            return [*named, *((self.digital[name], *step) for name, step in STEERING.items())], []
        sources = ("bus",) if phase is Phase.WRITE else op.sources
        destinations = ("bus",) if phase is Phase.READ else op.destinations
        if effect in _FLAGS:
            destinations = ("FLAG",)
        masked = self.target.masked_register
        return self._digital(sources), self._digital(
            sorted(destinations, key=lambda name: name != masked)
        )

    def _analog(self, name: str) -> Operand:
        """Return the number of the analog register `name` and the step to the pixel whose register
        it is: columns to the right, rows down. The bus of a neighbour is that pixel's NEWS; all
        others are of the pixel itself."""
        if name in NEIGHBOURS:
            return (self.analog["NEWS"], *STEPS[name])
        return self.analog[name], 0, 0

    def _digital(self, names: Iterable[str]) -> list[Operand]:
        """Return operands for the digital registers `names` of the pixel itself, in this order."""
        return [(self.digital[name], 0, 0) for name in names]


def packed(planes: Bools) -> NDArray[np.uint64]:
    """Return planes (.., cols) as 64-bit words (.., ceil(cols / 64)): pixel x is bit x % 64 of word
    x // 64. Bits beyond the last pixel are 0."""
    octets = np.packbits(planes, axis=-1, bitorder="little")
    words = np.zeros((*planes.shape[:-1], -(-planes.shape[-1] // 64) * 8), np.uint8)
    words[..., : octets.shape[-1]] = octets
    return words.view("<u8").astype(np.uint64)


def unpacked(words: NDArray[np.uint64], cols: int) -> Bools:
    """Return the planes (.., cols) that `packed` has turned into `words` (.., ceil(cols / 64))."""
    octets = words.astype("<u8").view(np.uint8)
    return np.unpackbits(octets, axis=-1, count=cols, bitorder="little").view(np.bool_)
