"""The words and the loaded registers of a chip during a frame, executed without sensor effects.

Words take no time: all words of boundary n see PIX as it is after the slots before n. Then the
light of slot n is added to PIX of every pixel. The words of boundary N follow the last slot.

A frame starts with arbitrary values in PIX, FLAG, the analog registers and the digital registers
that are not loaded. The reset level of PIX is a nonzero constant of each pixel. These values are
determined by `device_seed`. Analog values are 1/4 to 3/4 of the pixel's light in the frame (1 to 2
without light). That is large enough to reveal a program that forgets a reset or reads an unwritten
register. It is small enough that a correct program, which subtracts the value, loses no accuracy,
for any amount of light. PIX and the reset level are positive, registers have either sign.

Not emulated, because no program of this project uses it: addresses (SELECT reads 0)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property, partial
from itertools import groupby
from math import prod
from types import MappingProxyType

import numpy as np

from nscc.arrays import Bools, Floats, Ints
from nscc.chips.target import Target
from nscc.mappings import NamedValues
from nscc.operations import Op
from nscc.record import Record
from nscc.words.container import Launch
from nscc_runtime.emulator.array_words import ArrayWords, packed, unpacked
from nscc_runtime.emulator.loops import (
    EmulatedWords,
    KeptValues,
    PixelRange,
    RegisterBits,
    expose_without_effects,
)
from nscc_runtime.light import Light
from nscc_runtime.pool import in_parts, threads_of

Bits = Bools

EMULATED_BLOCK = 8192
"""Number of pixels exposed together, a multiple of 64. Their registers stay in the cache."""


class ChipProgram(Record, eq=False):
    """A program as a chip executes it.

    `slots`: N, the number of slots. `kernels`: the words of each. `launches`: of these kernels
    (lists of words) by number, in the order of execution, at boundaries 0 to N. `planes`: digital
    registers (rows, cols) that are loaded before the frame, by name. `kept`: electrons (rows, cols)
    of analog registers that the previous frame left, by name; the others begin with arbitrary
    values."""

    target: Target
    slots: int
    kernels: Sequence[Sequence[Op]]
    launches: Sequence[Launch]
    planes: Mapping[str, Bits]
    kept: Mapping[str, Floats] = MappingProxyType({})

    @cached_property
    def _words(self) -> tuple[ArrayWords, EmulatedWords, Ints]:
        """The words as a table, as arrays for the loop, and their operands. A kernel (a list of
        words) occurs once for each value of IN with which it is launched, because each word has its
        own value. IN is the level sent to all pixels."""
        table, kernel_start, in_e = ArrayWords(self.target), [0], 0.0
        numbers: dict[tuple[int, float], int] = {}
        instants, launched = [], []
        for launch in self.launches:
            if launch.level is not None:
                in_e = launch.level * self.target.electrons_per_step
            if (launch.kernel, in_e) not in numbers:
                numbers[launch.kernel, in_e] = len(numbers)
                # No word reads its own result, so repeating a word changes nothing.
                words = groupby(self.kernels[launch.kernel])
                kernel_start.append(table.append((op, in_e) for op, _ in words))
            instants.append(launch.instant)
            launched.append(numbers[launch.kernel, in_e])
        # Boundaries 0 to N, and one entry more for the end of the last.
        launch_start = np.zeros(self.slots + 2, np.int64)
        np.cumsum(np.bincount(instants, minlength=self.slots + 1), out=launch_start[1:])
        rows, operands = table.table
        starts = np.array(kernel_start, np.int64), launch_start, np.array(launched, np.int64)
        return table, EmulatedWords(rows, *starts), operands

    def run(
        self,
        light: Light,
        analog: Sequence[str],
        digital: Sequence[str] = (),
        *,
        device_seed: int = 0,
        threads: int | None = None,
    ) -> tuple[Floats, Bits]:
        """Execute a frame, and return the contents of registers at its end.

        Parameters
        ----------
        light : Light
        analog, digital : sequence of str
            Names of the registers to return.
        device_seed : int
            Seed of the arbitrary values.
        threads : int, optional
            Results do not depend on it.

        Returns
        -------
        tuple
            Analog registers in electrons, float64 (analog, rows, cols), and digital registers, bool
            (digital, rows, cols).

        Raises
        ------
        ValueError
            If the light's matrix is inconsistent.
        """
        _check_matrix(light)
        (table, _, operands), (rows, cols) = self._words, light.shape
        pixels = prod(light.shape)
        # If pixels depend on each other, the whole array is one block, with a column of zeros at
        # the end of each row; otherwise blocks are pieces of one long row.
        if table.reaches_neighbours:
            block, length = (rows, cols), cols + 1
        else:
            rows, cols = 1, pixels
            block = 1, min(EMULATED_BLOCK, (pixels + 63) // 64 * 64)
            length = block[1]
        shape = table.shape(*block, length, len(table.analog))
        shared = self._shared(light, analog, digital, (rows, cols))

        def fill(lit: Light, first: int, begin: int, end: int) -> None:
            """Run the program on the pixels from first + `begin` up to before first + `end`, and
            write their results into the shared arrays. `lit`: the light from pixel `first` on."""
            chosen = PixelRange(
                slots=self.slots,
                pixels=pixels,
                begin=first + begin,
                end=first + end,
                block_rows=rows,
                row_words=shared["bits"].read.shape[-1],
                frames=len(light.frames),
                lit_pixels=prod(lit.shape),
                first_lit=first,
                loads=len(self.planes),
                reads=len(digital),
                registers=len(analog),
                keeps=len(self.kept),
                seed=np.uint64(device_seed & 2**64 - 1),
                pix=table.analog["PIX"],
            )
            expose_without_effects(
                shape=shape,
                chosen=chosen,
                light=lit.matrix,
                state=table.state(shape, operands),
                charge=np.empty(block[0] * block[1], np.float32),
                **shared,
            )

        # Pixels that depend on each other need the light of the whole array.
        strips = [(range(light.shape[0]), 0, light)]
        for strip, _, lit in strips if table.reaches_neighbours else light.strips():
            first, count = strip.start * light.shape[1], len(strip) * light.shape[1]
            in_parts(partial(fill, lit, first), count, threads_of(threads), block[0] * block[1])
        read = unpacked(shared["bits"].read, cols).reshape(-1, *light.shape)
        return shared["contents"].reshape(-1, *light.shape), read

    def _shared(
        self,
        light: Light,
        analog: Sequence[str],
        digital: Sequence[str],
        size: tuple[int, int],
    ) -> NamedValues:
        """Return the arguments of the loop that all parts of a frame share, by name. `contents` and
        `bits.read` get the registers `analog` and `digital` at the end of the frame. `size`: rows
        and columns of digital registers."""
        (table, words, _), pixels = self._words, prod(light.shape)
        loaded = packed(np.array([*self.planes.values()], np.bool_).reshape(-1, *size))
        return {
            "program": words,
            "bits": RegisterBits(
                loaded,
                np.array([table.digital[name] for name in self.planes], np.int64),
                np.empty((len(digital), *loaded.shape[1:]), np.uint64),
                np.array([table.digital[name] for name in digital], np.int64),
            ),
            "before": KeptValues(
                np.array([*self.kept.values()], np.float64).reshape(-1, pixels),
                np.array([table.analog[name] for name in self.kept], np.int64),
            ),
            "frame_weight": light.frame_weight,
            "contents": np.empty((len(analog), pixels)),
            "register_numbers": np.array([table.analog[name] for name in analog], np.int64),
        }


def _check_matrix(light: Light) -> None:
    """Raise ValueError if the matrix of `light` has rows out of order, or names a frame that does
    not exist."""
    starts, index = light.row_start, light.frame_index
    if starts[0] != 0 or np.any(np.diff(starts) < 0):
        raise ValueError("the rows of the light's matrix are out of order")
    if index.size and not (index.min() >= 0 and index.max() < len(light.frames)):
        raise ValueError("the light's matrix names a frame that does not exist")
