"""Run the words of images and planes on the whole array without effects, in one compiled loop."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.operations import Op
from nscc_runtime.emulator.array_loop import run_array_words
from nscc_runtime.emulator.array_words import ArrayWords, packed, unpacked
from nscc_runtime.neighbours.pixels import RANGE_BIT


@dataclass(frozen=True, eq=False)
class ArrayContents:
    """The contents of registers after the words, by name.

    `register`: analog registers (rows, cols) in electrons. `cut_by`: their saturation marks.
    `planes`: digital registers (rows, plane words)."""

    register: Mapping[str, NDArray[np.float64]]
    cut_by: Mapping[str, NDArray[np.uint8]]
    planes: Mapping[str, NDArray[np.uint64]]

    def bit(self, name: str) -> NDArray[np.bool_]:
        """Return a digital register (rows, cols)."""
        return unpacked(self.planes[name], next(iter(self.register.values())).shape[1])

    def hold(self, seconds: float) -> None:
        """Do nothing: registers without effects do not decay."""


class PictureWords:
    """Words in their order, each with its steps of IN or None, prepared for arrays of a target."""

    def __init__(self, target: Target, words: Iterable[tuple[Op, int | None]]) -> None:
        self._target, self._table = target, ArrayWords(target)
        in_e, words_with_in = 0.0, list[tuple[Op, float]]()
        for op, level in words:
            in_e = in_e if level is None else level * target.electrons_per_step
            words_with_in.append((op, in_e))
        self._table.append(words_with_in)
        self._words, self._operands = self._table.table

    def run(
        self,
        shape: tuple[int, int],
        exposed: Mapping[str, NDArray[np.float64]],
        exposed_by: Mapping[str, NDArray[np.uint8]],
        code: Mapping[str, NDArray[np.bool_]],
    ) -> ArrayContents:
        """Return the contents of registers after the words.

        Before the words, registers hold `exposed` (electrons) with the marks `exposed_by`, and the
        bits of `code`, all (pixels,). All other registers hold 0."""
        (rows, cols), table, names = shape, self._table, self._target.analog_registers
        length, last = cols + 1, len(names) * (rows + 1)
        array = table.shape(rows, cols, length, len(names), RANGE_BIT)
        # Groups of 64 pixels may extend beyond the last row.
        values = np.zeros((last + 5) * length + 64)
        marks = np.zeros(values.shape, np.uint8)
        planes = np.zeros((len(table.digital), rows, array.plane_words), np.uint64)
        register, cut_by = (
            dict(zip(names, inner.reshape(-1, rows + 1, length)[:, :-1, :cols], strict=True))
            for inner in (values[length:][: last * length], marks[length:][: last * length])
        )
        for name, exposure in exposed.items():
            register[name][:] = exposure.reshape(shape)
            cut_by[name][:] = exposed_by[name].reshape(shape)
        for name, plane in code.items():
            planes[table.digital[name]] = packed(plane.reshape(shape))
        run_array_words(
            shape=array, words=self._words, operands=self._operands, values=values, marks=marks,
            planes=planes, marked=np.array([any(by.any() for by in exposed_by.values())], np.int64),
        )  # fmt: skip
        return ArrayContents(register, cut_by, dict(zip(table.digital, planes, strict=True)))
