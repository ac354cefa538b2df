"""The loop that says how much a pixel has of light and of its differences between neighbours."""

from __future__ import annotations

from typing import Annotated

from nscc_runtime.loop import Floats, Written, inlined, loop, record


@record
class Array:
    """The array that is looked at."""

    rows: int
    cols: int


@inlined
def _scored(
    light: Floats, p: int, up: int, down: int, left: int, right: int, score: Floats
) -> None:  # fmt: skip
    """Pixel p; where it has no neighbour, the place is its own."""
    here = light[p]
    found = here + abs(here - light[up]) + abs(here - light[down])
    score[p] = found + abs(here - light[left]) + abs(here - light[right])


@loop
def scores(
    array: Array,
    light: Annotated[Floats, "rows cols"],
    score: Written[Annotated[Floats, "rows cols"]],
) -> None:
    """score := the light of each pixel and how much that of its neighbours is more or less."""
    rows, cols = array.rows, array.cols
    for row in range(rows):
        first, last = row * cols, (row + 1) * cols - 1
        up, down = -cols if row > 0 else 0, cols if row + 1 < rows else 0
        for p in range(first + 1, last):
            _scored(light, p, p + up, p + down, p - 1, p + 1, score)
        for p in (first, last):
            left, right = 1 if p > first else 0, 1 if p < last else 0
            _scored(light, p, p + up, p + down, p - left, p + right, score)
