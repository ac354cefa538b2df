"""Images of neighbouring pixels: words beside goals, and the emulator beside SciPy.

    python tests/benchmarks/bench_neighbours.py [--words] [--speed] [--beside CHECKOUT]

Words: what `-O2` takes for kernels with public forms of words and with all forms, beside the goals
and the words of Cain (its div counted as 2), with CPU-seconds of both. Sets are several kernels of
one exposure in one program. Speed: two Sobels and a threshold on 256 x 256 pixels without effects,
beside two calls of `scipy.ndimage.correlate`, taken in turn; the goal is 2 times. Whoever exposes
more slots waits for these, too. With `--beside`, only the speed is measured, in turns with that of
another checkout.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import numpy as np
from scipy.ndimage import correlate

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "helpers"))

from beside import add_option, in_turns, show
from network_kernels import ANALOGNET2, MAX_POOLED

from nscc.chips.load import builtin_target
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

Rows = list[list[int]]


def outer(column: list[int], row: list[int]) -> Rows:
    """A separable kernel."""
    return [[a * b for b in row] for a in column]


SOBEL_X, SOBEL_Y = outer([1, 2, 1], [1, 0, -1]), outer([1, 0, -1], [1, 2, 1])
BOX_3, BOX_5 = outer([1] * 3, [1] * 3), outer([1] * 5, [1] * 5)
GAUSS_5 = [[0, 1, 2, 1, 0], [1, 4, 6, 4, 1], [2, 6, 10, 6, 2], [1, 4, 6, 4, 1], [0, 1, 2, 1, 0]]
SETS: dict[str, tuple[list[Rows], int, tuple[int, int | None], int]] = {
    "Sobel x": ([SOBEL_X], 1, (7, 7), 10),
    "Prewitt x": ([outer([1] * 3, [1, 0, -1])], 1, (7, 6), 8),
    "Laplace 4": ([[[0, -1, 0], [-1, 4, -1], [0, -1, 0]]], 1, (8, 6), 13),
    "Laplace 8": ([[[-1, -1, -1], [-1, 8, -1], [-1, -1, -1]]], 1, (12, 10), 19),
    "Gauss 3x3 / 16": ([outer([1, 2, 1], [1, 2, 1])], 16, (8, 7), 20),
    "box 3x3": ([BOX_3], 1, (8, 8), 12),
    "box 5x5": ([BOX_5], 1, (12, 12), 16),
    "box 7x7 / 64": ([outer([1] * 7, [1] * 7)], 64, (36, None), 36),
    "sharpen": ([[[0, -1, 0], [-1, 5, -1], [0, -1, 0]]], 1, (10, 10), 15),
    "Gauss 5x5 / 64": ([GAUSS_5], 64, (22, 19), 38),
    "Sobel x and y": ([SOBEL_X, SOBEL_Y], 1, (13, 13), 17),
    "box 3x3 and 5x5": ([BOX_3, BOX_5], 1, (20, 19), 26),
    "AnalogNet2 / 4": (ANALOGNET2, 4, (36, 28), 41),
    "MaxPooled / 4": (MAX_POOLED, 4, (28, 23), 31),
}
"""Kernels, their divisor, the goals with public and with all forms, and the words of Cain."""

ALL_FORMS = {"directed_sources": 4, "directed_halving": True}
"""Keys of a target that allows all forms of words with neighbours."""


def container_of(text: str, level: int = 2, **keys: Any) -> Container:
    """The proved program, on scamp5 with some keys changed."""
    target = replace(builtin_target("scamp5"), **keys)
    options = Options(level=level, target=target, cache=False)
    made = run_passes(Source("bench.nsl", text), Path(), options).container
    assert made is not None
    return made


def words_of(kernels: list[Rows], divisor: int, **keys: Any) -> int:
    """The words that compute these kernels of one exposure."""
    most = max(
        sum(abs(Fraction(weight, divisor)) for row in rows for weight in row) for rows in kernels
    )
    lines = ["nsl 3", "frame 1 slots of 1ms", "open when true"]
    lines.append(f"assume exposure <= {min(100, int(50 / most))}%")
    for number, rows in enumerate(kernels):
        lines.append(f"kernel k{number} = {rows} / {divisor}")
        lines.append(f"image i{number} = k{number}(exposure)")
    # Both signs of an image are as good: a comparison reads either.
    lines += [f"plane p{number} = i{number} > 1%" for number in range(len(kernels))]
    lines.append(f"read {', '.join(f'p{number}' for number in range(len(kernels)))}")
    pictures = container_of("\n".join(lines) + "\n", **keys).pictures
    return sum(cost.words for cost in pictures.costs if cost.name.startswith("i"))


def print_words() -> None:
    """Words beside goals."""
    print(f"{'kernels':18} {'public forms, goal':>18} {'all forms, goal':>16} Cain  CPU s")
    for name, (kernels, divisor, goals, cain) in SETS.items():
        begin = process_time()
        words = [words_of(kernels, divisor), words_of(kernels, divisor, **ALL_FORMS)]
        seconds = process_time() - begin
        cells = [f"{count:3} {goal or '-':>4}" for count, goal in zip(words, goals, strict=True)]
        print(f"{name:18} {cells[0]:>18} {cells[1]:>16} {cain:4} {seconds:6.1f}")


EDGES = """\
nsl 3
frame 1 slots of 1ms
open when true
kernel sx = [[1, 0, -1], [2, 0, -2], [1, 0, -1]] / 8
kernel sy = [[1, 2, 1], [0, 0, 0], [-1, -2, -1]] / 8
image strength = abs(sx(exposure)) + abs(sy(exposure))
plane edge = strength > 6%
read edge
"""


def milliseconds(runs: list[Callable[[], object]], rounds: int = 60) -> list[float]:
    """The best time of each, taken in turn."""
    best = [float("inf")] * len(runs)
    for _ in range(rounds):
        for number, run in enumerate(runs):
            begin = perf_counter()
            run()
            best[number] = min(best[number], 1000 * (perf_counter() - begin))
    return best


def measure() -> dict[str, float]:
    """The least milliseconds of a frame by the emulator, and of two correlations by SciPy."""
    container = container_of(EDGES)
    program = PicturedProgram(
        container, default_sensor(container.target), selected("none"), threads=1
    )
    still = np.random.default_rng(0).uniform(0, 20000, (1, 256, 256)).astype(np.float32)
    light = Light.of_clip(still)
    image = still[0].astype(np.float64)
    weights = [np.array(rows) / 8 for rows in (SOBEL_X, SOBEL_Y)]
    frame, pair = milliseconds(
        [
            lambda: list(program.film([light], 0, 0)),
            lambda: [correlate(image, kernel, mode="constant") for kernel in weights],
        ]
    )
    return {"a frame": frame, "two correlations": pair}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--words", action="store_true", help="only words")
    parser.add_argument("--speed", action="store_true", help="only times")
    add_option(parser)
    arguments = parser.parse_args()
    if arguments.worker:
        print(json.dumps(measure()))
        sys.exit()
    if not (arguments.speed or arguments.beside):
        print_words()
    if not arguments.words:
        mine, other = in_turns(str(Path(__file__).resolve()), [], arguments.beside, 3)
        show(mine, other, "ms")
        print(f"{mine['a frame'] / mine['two correlations']:.2f} times SciPy")
