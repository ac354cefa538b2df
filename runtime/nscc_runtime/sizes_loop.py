"""The loops that add up the light of a scene and compute its statistics."""

from __future__ import annotations

from typing import Annotated, NamedTuple

from nscc_runtime.loop import Floats, Floats32, Ints, Ints32, Written, compiled, loop, record


class LightMatrix(NamedTuple):
    """The frames and weights of `nscc_runtime.light.Light`, with its names."""

    frames: Annotated[Floats32, "frames pixels"]
    row_start: Annotated[Ints, "slots+1"]
    frame_index: Annotated[Ints32, "entries"]
    weight: Annotated[Floats, "entries"]


MEAN, SQUARE, EIGHTH, LARGEST, STEPS = 0, 1, 2, 3, 8
OPEN = 4
"""Index of the first of four statistics of the light while pixels are open."""
KINDS = 9
_LEAST = 1e-30
"""Smaller squares of light count as this value, because powers of smaller numbers are slow."""
BLOCK = 2048
"""Number of pixels whose sums stay in the cache for all frames."""


@record
class ArraySize:
    """The size of the array."""

    rows: int
    cols: int


@record
class Frames:
    """Sizes for `sum_light`. `count` frames of `pixels` pixels; sums are limited to `most`. `even`:
    whether all frames have the same weight."""

    count: int
    pixels: int
    even: int
    most: float


@compiled
def _gather(
    frames: Floats32, step: int, count: int, first: int, stop: int, total_32: Floats32
) -> None:
    """Set total_32[i] to the sum of pixel first + i over all frames, which are `step` apart."""
    for i in range(stop - first):
        total_32[i] = frames[first + i]
    k = 1
    while k + 2 < count:
        at = k * step + first
        for i in range(stop - first):
            total = total_32[i] + frames[at + i]
            total += frames[at + step + i]
            total_32[i] = total + frames[at + 2 * step + i]
        k += 3
    for last in range(k, count):
        at = last * step + first
        for i in range(stop - first):
            total_32[i] += frames[at + i]


@compiled
def _gather_weighted(
    frames: Floats32, step: int, weight: Floats, count: int, first: int, stop: int, out: Floats
) -> None:
    """Set out[p] to the weighted sum of pixel p over all frames, in float64."""
    for p in range(first, stop):
        out[p] = 0.0
    k = 0
    while k + 2 < count:
        at, a, b, c = k * step, weight[k], weight[k + 1], weight[k + 2]
        for p in range(first, stop):
            total = out[p] + a * float(frames[at + p])
            total += b * float(frames[at + step + p])
            out[p] = total + c * float(frames[at + 2 * step + p])
        k += 3
    for last in range(k, count):
        for p in range(first, stop):
            out[p] += weight[last] * float(frames[last * step + p])


@loop
def sum_light(
    size: Frames,
    frames: Annotated[Floats32, "count pixels"],
    weight: Annotated[Floats, "count"],
    total_32: Written[Floats32],
    out: Written[Annotated[Floats, "pixels"]],
    capped: Written[Ints],
) -> None:
    """Set out[p] to the sum over k of weight[k] * frames[k, p], at most `most`.

    The sum is in float32 if all weights are equal. `capped`: set to the number of pixels above
    `most`. `total_32`: working memory for `BLOCK` pixels."""
    capped[0] = 0
    for first in range(0, size.pixels, BLOCK):
        stop = min(first + BLOCK, size.pixels)
        if size.even:
            _gather(frames, size.pixels, size.count, first, stop, total_32)
            for p in range(first, stop):
                out[p] = float(total_32[p - first]) * weight[0]
        else:
            _gather_weighted(frames, size.pixels, weight, size.count, first, stop, out)
        capped_pixels = 0
        for p in range(first, stop):
            capped_pixels += 1 if out[p] > size.most else 0
            out[p] = size.most if out[p] > size.most else out[p]
        capped[0] += capped_pixels


@compiled
def _powers(
    total: Floats, open_fraction: Floats32, first: int, cols: int, opened: bool, column_sums: Floats
) -> None:
    """Add powers and the maximum of a row to `column_sums`: of its light, or with `opened` of its
    light while pixels are open. Each column is separate, so LLVM vectorises the loop."""
    at = OPEN * cols if opened else 0
    for col in range(cols):
        fraction = float(open_fraction[first + col]) if opened else 1.0
        light = total[first + col] * fraction
        square = light * light
        column_sums[at + MEAN * cols + col] += light
        column_sums[at + SQUARE * cols + col] += square
        fourth = square * square if square > _LEAST else _LEAST * _LEAST
        column_sums[at + EIGHTH * cols + col] += fourth * fourth
        most = column_sums[at + LARGEST * cols + col]
        column_sums[at + LARGEST * cols + col] = light if light > most else most


@compiled
def _steps(total: Floats, first: int, cols: int, last: bool, column_sums: Floats) -> None:
    """Add to `column_sums` the squared differences to the neighbours to the right and below."""
    for col in range(cols - 1):
        right = total[first + col + 1] - total[first + col]
        column_sums[STEPS * cols + col] += right * right
    for col in range(0 if last else cols):
        down = total[first + cols + col] - total[first + col]
        column_sums[STEPS * cols + col] += down * down


@loop
def sizes_of(
    pixels: ArraySize,
    total: Annotated[Floats, "rows cols"],
    open_fraction: Annotated[Floats32, "rows cols"],
    column_sums: Written[Annotated[Floats, "kinds cols"]],
) -> None:
    """Compute statistics of each column into column_sums (9, cols).

    These are the sums of `total`, of its squares and of its eighth powers, and its maximum; the
    same for `total` times `open_fraction`; and the sum of squared differences between neighbours.
    Light is at most 1e36, so powers do not overflow."""
    rows, cols = pixels.rows, pixels.cols
    for i in range(KINDS * cols):
        column_sums[i] = 0.0
    for row in range(rows):
        for opened in range(2):
            _powers(total, open_fraction, row * cols, cols, opened == 1, column_sums)
        _steps(total, row * cols, cols, row + 1 == rows, column_sums)
