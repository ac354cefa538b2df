"""Simulate the words after an exposure on the whole array, with every effect.

`nscc_runtime.reference.words` simulates words that use one pixel. This module adds NEWS and DNEWS,
which access neighbours. It is not published what a bus beyond the array gives: here it gives 0."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from nscc.arrays import Array, Bools, Bytes, Floats
from nscc.operations import NEIGHBOURS, STEERING, STEPS, Op, WordEffect
from nscc.words.cost import word_us
from nscc_runtime.reference.digital import Digital
from nscc_runtime.reference.trace import RunningWord, retention_us
from nscc_runtime.reference.weights import error_sign
from nscc_runtime.reference.words import Bits, WordPixels

RANGE_BIT = 32
"""In `saturated_by`: a value left the range of registers, or an exposure was above its `assume`."""


@dataclass(eq=False, kw_only=True)
class ArrayPixels(WordPixels):
    """All pixels of an array of `shape` (rows, columns); all other arrays are (pixels,), row after
    row, by name of a register.

    `exposed`: analog registers after the exposure, in electrons. `exposed_by`: their saturation
    marks. `code`: digital registers after the exposure, bool. `cut_by`: the saturation marks of
    every analog register and of IN (the level sent to all pixels) while words run. The values of IN
    have no marks."""

    word_draws = 2  # words after an exposure
    shape: tuple[int, int]
    exposed: Mapping[str, Floats]
    exposed_by: Mapping[str, Bytes]
    code: Mapping[str, Bits]
    cut_by: dict[str, Bytes] = field(init=False)

    def __post_init__(self) -> None:
        """Set the registers as the exposure leaves them; all others, analog and digital, hold
        arbitrary values of the device seed. IN (the level sent to all pixels) is 0, and no word has
        run."""
        # Registers without an exposure have arbitrary contents: here equal in all registers.
        arbitrary = self.arbitrary(0)
        self.begin()
        # Between 0 and half of a register's range, so that it does not saturate by itself.
        left = arbitrary * (self.sensor.register_max_e / 2)
        self.register = {**dict.fromkeys(self.target.analog_registers, left), **self.exposed}
        registers = (*self.target.digital_registers, "FLAG")
        bits = {**dict.fromkeys(registers, arbitrary < 0.5), **self.code}
        self.digital = Digital(self.target, bits, retention_us(self.effects, self.sensor))
        self.number, self.after_us, self.in_e = 0, 0.0, 0.0
        pixels = len(self.places)
        self._uncut = np.zeros(pixels, np.uint8)
        cut = {name: by for name, by in self.exposed_by.items() if by.any()}
        self.cut_by = {**dict.fromkeys((*self.register, "IN"), self._uncut), **cut}

    def bit(self, name: str) -> Bits:
        """Return the bits (pixels,) of the digital register `name`. An unknown bit, or one held for
        longer than the retention time, reads False."""
        return np.asarray(self.digital.read(name) == 1)

    def run_words(self, words: Iterable[tuple[Op, int | None]]) -> None:
        """Run words on all pixels, one after the other, and update the registers and the time.

        Each pair is a word and the value of IN that the controller sends with it, in steps of the
        target (`electrons_per_step`). None leaves IN as it was."""
        for op, level in words:
            if level is not None:
                self.in_e = level * self.target.electrons_per_step
            self.after_us += word_us(op, self.target)
            word = RunningWord(self.number, self.container.slots, self.after_us, op, self.in_e)
            self.number += op.analog  # only analog words draw random numbers
            self._run(word)

    # --- words

    def _run(self, word: RunningWord) -> None:
        """Run one word on all pixels, and update their registers. Words of unknown effect change
        nothing."""
        op, digital = word.op, self.digital
        match op.operation.effect:
            case WordEffect.BUS:
                self._bus_on_array(word)
            case WordEffect.FLAG_ANALOG:
                flag = self.compared(word) > 0
                if self.target.where_obeys_flag:
                    flag &= digital.read("FLAG") == 1
                digital.write("FLAG", flag)
            case WordEffect.DIGITAL_NEIGHBOURS:
                self._neighbour_values(op)
            case WordEffect.PROPAGATION:
                names = (op.destinations[0], self.target.mask_register or "", *STEERING)
                bits, mask, *chosen = (self.bit(name).reshape(self.shape) for name in names)
                reached = propagated(bits, mask, chosen, self.target.propagation_pixels)
                digital.write(op.destinations[0], reached.reshape(-1))
            case _:
                digital.run(op)

    def total(self, word: RunningWord) -> Floats:
        """Return the sum of a word's sources in each pixel, electrons (pixels,). A neighbour's bus
        is the content of NEWS there, 0 beyond the array. PIX (the photodiode) is not read after the
        exposure."""
        total = np.zeros(len(self.places))
        for name in word.op.sources:
            if name in NEIGHBOURS:
                total += self.moved(self.register["NEWS"], *STEPS[name], beyond=0.0)
            else:
                total += word.in_e if name == "IN" else self.register[name]
        return total

    def _bus_on_array(self, word: RunningWord) -> None:
        """Run an analog word where FLAG (the bit that lets a pixel act) is 1: write -(sum of its
        sources) / divisor to each destination, as the effects of words and registers change it
        there."""
        result = self.total(word) / -word.op.operation.divisor
        cut = self._cut(word.op)
        for index, name in enumerate(word.op.destinations):
            value, register = result, "NEWS" if name in NEIGHBOURS else name
            for written in self.at("words"):
                value = written(self, value, word, index, error_sign(register, self.container))
            # Marks tell the range before the effects of registers bend the value into it.
            by = self._with_range(cut, value)
            for bends in self.at("registers"):
                value = bends(self, value)
            self._store(name, value, by)

    def _cut(self, op: Op) -> Bytes:
        """Return the bitwise OR (pixels,) of the saturation marks of a word's sources. For a source
        in a neighbour, the marks are the neighbour's; beyond the array they are 0."""
        # `_uncut` itself, not a copy, stands for "no marks": comparing objects is fast.
        marks = self._uncut
        for name in op.sources:
            by = self.cut_by["NEWS" if name in NEIGHBOURS else name]
            if by is not self._uncut:
                if name in NEIGHBOURS:
                    by = self.moved(by, *STEPS[name], beyond=np.uint8(0))
                marks = marks | by
        return marks

    def _with_range(self, cut: Bytes, value: Floats) -> Bytes:
        """Return the marks `cut` (pixels,), with RANGE_BIT set where `value` (electrons) is beyond
        the range of registers; `cut` itself if it is nowhere."""
        high, low = self.target.register_max_e, self.target.register_min_e
        if value.max() <= high and value.min() >= low:
            return cut
        over = (value > high) | (value < low)
        return cut | over.astype(np.uint8) * np.uint8(RANGE_BIT)

    def _store(self, name: str, value: Floats, by: Bytes) -> None:
        """Write `value` (electrons) and its saturation marks `by` to the register `name` where FLAG
        (the bit that lets a pixel act) is 1. If `name` is a neighbour's bus, each pixel gets value
        and marks of the pixel on the opposite side, 0 at the border, and the register is NEWS."""
        if name in NEIGHBOURS:
            right, down = STEPS[name]
            value = self.moved(value, -right, -down, beyond=0.0)
            if by is not self._uncut:
                by = self.moved(by, -right, -down, beyond=np.uint8(0))
            name = "NEWS"
        here, old = self.digital.read("FLAG") == 1, self.register[name]
        if not here.all():
            value = np.where(here, value, old)
            if by is not self._uncut or self.cut_by[name] is not self._uncut:
                by = np.where(here, by, self.cut_by[name])
        self.register[name], self.cut_by[name] = value, by

    def _neighbour_values(self, op: Op) -> None:
        """Run the DNEWS word `op`: write the OR of the bits of those neighbours that the pixel
        chooses by its steering registers, 0 if it chooses none. Outside the array all bits are 1 if
        the word is of the inverted kind, else 0."""
        source, outside, digital = op.sources[0], op.operation.inverted, self.digital
        result = np.zeros(len(self.places), np.bool_)
        bits = digital.read(source) == 1
        for name, (right, down) in STEERING.items():
            chosen = digital.read(name) == 1
            if chosen.any():
                result |= chosen & self.moved(bits, right, down, beyond=outside)
        digital.write(op.destinations[0], result)

    def moved(self, values: Array, right: int, down: int, *, beyond: Any) -> Array:
        """Return for each pixel (pixels,) the value of the pixel `right` columns and `down` rows
        away, each -1, 0 or 1. Pixels outside the array have the value `beyond`."""
        rows, cols = self.shape
        padded = np.full((rows + 2, cols + 2), beyond, values.dtype)
        padded[1:-1, 1:-1] = values.reshape(self.shape)
        return padded[1 + down : 1 + down + rows, 1 + right : 1 + right + cols].reshape(-1)


def propagated(
    bits: Bools,
    mask: Bools,
    chosen: Sequence[Bools],
    pixels: int,
) -> Bools:
    """Return the bits after one propagation, in which a 1 spreads step by step to neighbours.

    All arrays are (rows, cols). A pixel where `mask` is 1 becomes 1 if a neighbour that it chooses
    is 1. `chosen`: for each direction, in the order of `STEERING`, the pixels that choose the
    neighbour there. `pixels`: the largest number of steps. Outside the array, all bits are 0."""
    padded = np.pad(bits, 1)
    inner = padded[1:-1, 1:-1]
    rows, cols = bits.shape
    for _ in range(pixels):
        near = np.zeros_like(bits)
        for direction, (right, down) in zip(chosen, STEERING.values(), strict=True):
            near |= direction & padded[1 + down : 1 + down + rows, 1 + right : 1 + right + cols]
        near &= mask & ~inner
        if not near.any():
            break
        inner |= near
    return inner.copy()
