"""The loop that finds how large the light of a scene is, for `nscc_runtime.kept_plans`."""

from __future__ import annotations

from typing import Annotated

from nscc_runtime.loop import Floats, Floats32, Written, compiled, loop, record

MEAN, SQUARE, EIGHTH, LARGEST, STEPS = 0, 1, 2, 3, 8
OPEN = 4
"""Where the first four of the light while pixels are open begin."""
KINDS = 9
_LEAST = 1e-30
"""Squares of light that is less count as that: the powers of smaller numbers are slow."""


@record
class Pixels:
    """The array."""

    rows: int
    cols: int


@compiled
def _powers(lit: Floats, cols: int, at: int, found: Floats) -> None:
    """Add a row: each column by itself, and each kind, so that LLVM makes vectors."""
    for col in range(cols):
        found[at + MEAN * cols + col] += lit[col]
    for col in range(cols):
        found[at + SQUARE * cols + col] += lit[col] * lit[col]
    for col in range(cols):
        square = lit[col] * lit[col]
        square = square if square > _LEAST else _LEAST
        found[at + EIGHTH * cols + col] += square * square * (square * square)
    for col in range(cols):
        most = found[at + LARGEST * cols + col]
        found[at + LARGEST * cols + col] = lit[col] if lit[col] > most else most


@loop
def sizes_of(
    pixels: Pixels,
    total: Annotated[Floats, "rows cols"],
    part: Annotated[Floats32, "rows cols"],
    lit: Written[Annotated[Floats, "cols"]],
    found: Written[Annotated[Floats, "kinds cols"]],
) -> None:
    """found (9, cols) := for each column, of `total` its sum, the sums of its squares and of its
    eighth powers, and the largest; these of `total` times `part`; the sum of squares of steps
    between neighbours. Light is at most 1e36, whose powers have room. `lit` is scratch.
    """
    cols = pixels.cols
    for i in range(KINDS * cols):
        found[i] = 0.0
    for row in range(pixels.rows):
        first = row * cols
        for col in range(cols):
            lit[col] = total[first + col]
        _powers(lit, cols, 0, found)
        for col in range(cols):
            lit[col] = total[first + col] * part[first + col]
        _powers(lit, cols, OPEN * cols, found)
        for col in range(cols - 1):
            right = total[first + col + 1] - total[first + col]
            found[STEPS * cols + col] += right * right
        for col in range(cols if row + 1 < pixels.rows else 0):
            down = total[first + cols + col] - total[first + col]
            found[STEPS * cols + col] += down * down
