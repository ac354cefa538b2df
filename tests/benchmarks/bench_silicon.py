"""Frames of the emulator beside public frames of a SCAMP-5, by the same estimators.

    python tests/benchmarks/bench_silicon.py [--frames 90] [--chip SUMS.npz] [--sensor K=V ..]

The words are those of the chip's firmware: for each of 25 taps `add` or `sub` of a register, where
bits agree with the kernel's sign; 64 pixels of transport for one half; one `add`; copies; readout.
The emulator runs them with every effect. Bits are drawn at random. silicon_chip.json holds what
these estimators give for sums over half of the chip's frames; `--chip` takes other sums.
docs/silicon.md says what the comparison means.
"""

from __future__ import annotations

import argparse
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
from silicon_estimators import (
    ORDER,
    SIDE,
    SIGNS_H,
    SIGNS_X,
    figures,
    square_sums,
    zero_figures,
)

CHIP = Path(__file__).with_name("silicon_chip.json")
STEPS, WRONG, ZERO = 12, 0.11, 129.7
"""Steps of IN in the added register, the part of the bits of x that are wrong, and the code of 0.

The first two are not published. They are fitted to the last tap, the clipped codes and the mean of
the square, and describe the experiment, not the sensor."""
EDGE = 4
REST = 60, 252
"""Rows and columns around the square whose kernels are complete, and of the region at zero."""


def tap_masks(bits: np.ndarray, tap: int) -> np.ndarray:
    """Return the pixels whose bit of tap number `tap` agrees with the sign of their kernel."""
    (row,), (col,) = np.nonzero(tap == ORDER)
    moved = np.roll(bits, (2 - row, 2 - col), (0, 1))
    middle = EDGE + SIDE
    signs = np.where(np.arange(bits.shape[1]) < middle, SIGNS_X[row, col], SIGNS_H[row, col])
    return moved * signs > 0


class Chip:
    """The emulator's scamp5 with the words of the experiment."""

    def __init__(self, changes: dict[str, float]) -> None:
        import nscc
        from nscc.chips.load import builtin_target
        from nscc_runtime.effects import selected
        from nscc_runtime.neighbours.pictured_program import image_sensor
        from nscc_runtime.sensor import default_sensor

        self.container = nscc.compile("nsl 1\nframe 1 slots of 1ms\nopen when n < 1\n").container
        target = builtin_target("scamp5")
        self.target = replace(target, readout="full")
        sensor = default_sensor(target).changed(**changes)
        self.sensor = image_sensor(sensor, target).changed(adc_offset_lsb=ZERO)
        self.effects = selected("all")

    def pixels(self, shape: tuple[int, int], frame: int):
        """Return pixels whose registers hold 0."""
        from nscc_runtime.reference.array_pixels import ArrayPixels

        zero = np.zeros(shape[0] * shape[1])
        return ArrayPixels(
            sensor=self.sensor,
            seed=1,
            device_seed=1,
            frame=frame,
            places=np.arange(zero.size),
            container=self.container,
            effects=self.effects,
            code={},
            shape=shape,
            exposed={},
            exposed_by={},
        )

    def codes(self, pixels, shape: tuple[int, int], frame: int) -> np.ndarray:
        """Return the codes of register F."""
        from nscc_runtime.exposed_frame import Exposure
        from nscc_runtime.frame_file import converted

        values = pixels.register["F"].reshape(1, *shape)
        exposure = Exposure(values, np.ones(values.shape, np.bool_))
        frame_of = converted(exposure, self.target, self.sensor, self.effects, (1, 1), frame)
        return frame_of.frame[0].astype(np.float64)


def words(text: str, level: int | None = None):
    """Return words, written as `F=NEWS,C` and `all`, with their steps of IN."""
    from nscc.operations import op

    for word in text.split():
        name, equals, sources = word.partition("=")
        operands = [*filter(None, sources.split(","))]
        yield (op("bus", [name], operands) if equals else op(name)), level


def square_of(chip: Chip, bits: np.ndarray, frame: int) -> np.ndarray:
    """Return the codes of the square of one frame; `bits` (rows, cols): x, then h to its right."""
    pixels = chip.pixels(bits.shape, frame)
    pixels.run_words(words("all NEWS=IN C=NEWS", 0))
    pixels.run_words(words("NEWS=IN F=NEWS", STEPS))
    for tap in range(ORDER.size):
        agrees = tap_masks(bits, tap).reshape(-1)
        pixels.digital.write("FLAG", agrees)
        pixels.run_words(words("NEWS=C,F C=NEWS"))
        pixels.digital.write("FLAG", ~agrees)
        pixels.run_words(words("NEWS=C C=NEWS,F"))
    pixels.run_words(words("all NEWS=C F=NEWS NEWS=F C=NEWS " + "XE=F F=NEWS " * SIDE))
    pixels.run_words(words("NEWS=F,C E=NEWS NEWS=E F=NEWS"))
    rows = slice(EDGE, EDGE + SIDE)
    return chip.codes(pixels, bits.shape, frame)[rows, EDGE + SIDE : EDGE + 2 * SIDE]


def zero_of(chip: Chip, frame: int) -> np.ndarray:
    """Return the codes of a register that two words loaded with 0."""
    pixels = chip.pixels(REST, frame)
    pixels.run_words(words("all NEWS=IN F=NEWS", 0))
    return chip.codes(pixels, REST, frame)


def emulated(frames: int, changes: dict[str, float]) -> dict[str, tuple[float, float]]:
    """Return the figures of the emulator."""
    chip, numbers = Chip(changes), np.random.default_rng(1)
    squares, bits_of_x = [], []
    for frame in range(frames):
        shape = SIDE + 2 * EDGE, 2 * (SIDE + EDGE)
        bits = numbers.choice([-1.0, 1.0], shape)
        bits_of_x.append(bits[EDGE:-EDGE, EDGE : EDGE + SIDE].copy())
        wrong = numbers.random(shape) < WRONG
        wrong[:, EDGE + SIDE :] = False
        squares.append(square_of(chip, np.where(wrong, -bits, bits), frame))
    zeros = np.array([zero_of(chip, frame) for frame in range(frames)])
    return figures(square_sums(np.array(squares), np.array(bits_of_x)) | zero_figures(zeros))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--frames", type=int, default=90)
    parser.add_argument("--chip", type=Path, help="sums of a chip's frames, as .npz")
    parser.add_argument("--sensor", nargs="*", default=[], metavar="NAME=VALUE")
    options = parser.parse_args()
    chip = json.loads(CHIP.read_text())
    if options.chip:
        chip = figures(dict(np.load(options.chip)))
    changes = {name: float(value) for name, value in (c.split("=") for c in options.sensor)}
    nscc_figures = emulated(options.frames, changes)
    line = "{:34} {:>18} {:>18}"
    print(line.format("figure", "chip", "nscc"))
    for name, values in chip.items():
        cells = (
            f"{value:.4g}" + (f" +- {error:.2g}" if error else "")
            for value, error in (values, nscc_figures[name])
        )
        print(line.format(name, *cells))


if __name__ == "__main__":
    main()
