"""The reference for the words after an exposure: words of the whole array, with every effect.

`nscc_runtime.reference.words` simulates words that use one pixel. This module adds NEWS and DNEWS,
which access neighbours. It is not published what a bus beyond the array gives: here it gives 0."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from nscc.arrays import Array, Bytes, Floats
from nscc.operations import NEIGHBOURS, STEERING, STEPS, Op, WordEffect
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
        super().__post_init__()
        self.register.update(self.exposed)
        registers = (*self.target.digital_registers, "FLAG")
        bits = {**dict.fromkeys(registers, self.arbitrary(0) < 0.5), **self.code}
        self.digital = Digital(self.target, bits, retention_us(self.effects, self.sensor))
        self.number, self.in_e = 0, 0.0
        uncut = np.zeros(len(self.places), np.uint8)
        self.cut_by = {**dict.fromkeys((*self.register, "IN"), uncut), **self.exposed_by}

    def bit(self, name: str) -> Bits:
        """Return the bits (pixels,) of the digital register `name`. An unknown bit, or one held for
        longer than the retention time, reads False."""
        return np.asarray(self.digital.read(name) == 1)

    def run_words(self, words: Iterable[tuple[Op, int | None]]) -> None:
        """Run words on all pixels, one after the other, and update the registers.

        Each pair is a word and the value of IN that the controller sends with it, in steps of the
        target (`electrons_per_step`). None leaves IN as it was."""
        for op, level in words:
            if level is not None:
                self.in_e = level * self.target.electrons_per_step
            # PIX is not read after the exposure, so the time does not matter.
            self.run_word(RunningWord(self.number, self.container.slots, 0.0, op, self.in_e))
            self.number += op.analog  # only analog words draw random numbers

    def run_word(self, word: RunningWord) -> None:
        """Run one word on all pixels, and update their registers. Words of unknown effect change
        nothing."""
        op, target = word.op, self.target
        match op.operation.effect:
            case WordEffect.DIGITAL_NEIGHBOURS:
                bits = self._or_of_chosen(self.bit(op.sources[0]), op.operation.inverted)
                self.digital.write(op.destinations[0], bits)
            case WordEffect.PROPAGATION:
                bits, mask = self.bit(op.destinations[0]), self.bit(target.mask_register or "")
                for _ in range(target.propagation_pixels):
                    reached = self._or_of_chosen(bits, False) & mask & ~bits
                    if not reached.any():
                        break
                    bits = bits | reached
                self.digital.write(op.destinations[0], bits)
            case _:
                super().run_word(word)

    def total(self, word: RunningWord) -> Floats:
        """Return the sum of a word's sources in each pixel, electrons (pixels,). PIX (the
        photodiode) is not read after the exposure."""
        total = np.zeros(len(self.places))
        for name in word.op.sources:
            total += word.in_e if name == "IN" else self._read(self.register, name)
        return total

    def _read(self, contents: Mapping[str, Array], name: str) -> Array:
        """Return what a word reads (pixels,) of `contents`, which has an array for each register. A
        neighbour's bus is the content of NEWS there, 0 beyond the array."""
        if name not in NEIGHBOURS:
            return contents[name]
        return self.moved(contents["NEWS"], *STEPS[name], beyond=0)

    def bus(self, word: RunningWord, acting: Bits) -> None:
        """Run an analog word: write -(sum of its sources) / divisor to each destination, as the
        effects of words and registers change it, in the pixels of the mask `acting`. The marks are
        those of all sources.

        If a destination is a neighbour's bus, each pixel gets value and marks of the pixel on the
        opposite side, 0 at the border, in NEWS."""
        result = self.total(word) / -word.op.operation.divisor
        cut = np.zeros(len(self.places), np.uint8)
        for name in word.op.sources:
            cut |= self._read(self.cut_by, name)
        for index, name in enumerate(word.op.destinations):
            value, register = result, "NEWS" if name in NEIGHBOURS else name
            for written in self.at("words"):
                value = written(self, value, word, index, error_sign(register, self.container))
            # Marks tell the range before the effects of registers bend the value into it.
            over = (value > self.target.register_max_e) | (value < self.target.register_min_e)
            by = cut | over * np.uint8(RANGE_BIT)
            for bends in self.at("registers"):
                value = bends(self, value)
            if name in NEIGHBOURS:
                right, down = STEPS[name]
                value, by = (self.moved(x, -right, -down, beyond=0) for x in (value, by))
            self.register[register] = np.where(acting, value, self.register[register])
            self.cut_by[register] = np.where(acting, by, self.cut_by[register])

    def _or_of_chosen(self, bits: Bits, outside: bool) -> Bits:
        """Return the OR (pixels,) of the `bits` (pixels,) of those neighbours that each pixel
        chooses by its steering registers, 0 if it chooses none. `outside`: the bits outside the
        array."""
        near = np.zeros(len(self.places), np.bool_)
        for name, (right, down) in STEERING.items():
            near |= self.bit(name) & self.moved(bits, right, down, beyond=outside)
        return near

    def moved(self, values: Array, right: int, down: int, *, beyond: Any) -> Array:
        """Return for each pixel (pixels,) the value of the pixel `right` columns and `down` rows
        away, each -1, 0 or 1. Pixels outside the array have the value `beyond`."""
        rows, cols = self.shape
        padded = np.full((rows + 2, cols + 2), beyond, values.dtype)
        padded[1:-1, 1:-1] = values.reshape(self.shape)
        return padded[1 + down : 1 + down + rows, 1 + right : 1 + right + cols].reshape(-1)
