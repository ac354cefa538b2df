"""The loop that finds how large the light of a scene is, for `nscc_runtime.kept_plans`."""

from __future__ import annotations

from typing import Annotated

from nscc_runtime.loop import Floats, Floats32, Written, loop, record

MEAN, SQUARE, EIGHTH, LARGEST = range(4)
_LEAST = 1e-9
"""Of the square of the largest: smaller numbers, whose powers are slow, count as that."""


@record
class Pixels:
    """The array."""

    rows: int
    cols: int


@loop
def sizes_of(
    pixels: Pixels,
    total: Annotated[Floats, "rows cols"],
    part: Annotated[Floats32, "rows cols"],
    found: Written[Floats],
) -> None:
    """found (9,) := of `total` mean, mean square, mean eighth power and the largest; the sum of
    squares of steps between neighbours; the first four of `total` times `part`.

    Powers are of parts of the largest, whose sizes count; of no light all are 0.
    """
    cols, count = pixels.cols, pixels.rows * pixels.cols
    for kind in range(2):
        at, largest = 5 * kind, 0.0
        for p in range(count):
            size = abs(total[p] * (part[p] if kind else 1.0))
            largest = size if size > largest or size != size else largest
        for power in range(4):
            found[at + power] = 0.0
        found[at + LARGEST] = largest
        if largest <= 0.0:
            continue
        for p in range(count):
            size = abs(total[p] * (part[p] if kind else 1.0)) / largest
            square = max(size * size, _LEAST)
            fourth = square * square
            found[at + MEAN] += size
            found[at + SQUARE] += square
            found[at + EIGHTH] += fourth * fourth
        for power in range(3):
            found[at + power] /= count
    found[4] = 0.0
    if found[LARGEST] > 0.0:
        scale = 1.0 / found[LARGEST]
        for row in range(pixels.rows):
            for col in range(cols):
                p = row * cols + col
                down = (total[p + cols] - total[p]) * scale if row + 1 < pixels.rows else 0.0
                right = (total[p + 1] - total[p]) * scale if col + 1 < cols else 0.0
                found[4] += down * down + right * right
