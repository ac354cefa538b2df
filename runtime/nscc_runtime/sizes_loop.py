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
ROWS = 4
"""Number of rows that are added in one pass."""
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
def _powers(lit: Floats, cols: int, at: int, column_sums: Floats) -> None:
    """Add sums of powers and the maximum of `ROWS` rows to `column_sums`. Each column is separate,
    so LLVM vectorises the loop."""
    b, c, d = cols, 2 * cols, 3 * cols
    for col in range(cols):
        light_a, light_b, light_c, light_d = lit[col], lit[b + col], lit[c + col], lit[d + col]
        column_sums[at + MEAN * cols + col] += (light_a + light_b) + (light_c + light_d)
        first = light_a if light_a > light_b else light_b
        last = light_c if light_c > light_d else light_d
        most, last = column_sums[at + LARGEST * cols + col], first if first > last else last
        column_sums[at + LARGEST * cols + col] = last if last > most else most
        light_a = light_a * light_a
        light_b = light_b * light_b
        light_c = light_c * light_c
        light_d = light_d * light_d
        column_sums[at + SQUARE * cols + col] += (light_a + light_b) + (light_c + light_d)
        light_a = light_a if light_a > _LEAST else _LEAST
        light_b = light_b if light_b > _LEAST else _LEAST
        light_c = light_c if light_c > _LEAST else _LEAST
        light_d = light_d if light_d > _LEAST else _LEAST
        light_a = light_a * light_a
        light_b = light_b * light_b
        light_c = light_c * light_c
        light_d = light_d * light_d
        column_sums[at + EIGHTH * cols + col] += (light_a * light_a + light_b * light_b) + (
            light_c * light_c + light_d * light_d
        )


@compiled
def _steps(total: Floats, first: int, cols: int, last: bool, column_sums: Floats) -> None:
    """Add to `column_sums` the squared differences to the neighbours to the right and below."""
    if last:
        for col in range(cols - 1):
            right = total[first + col + 1] - total[first + col]
            column_sums[STEPS * cols + col] += right * right
        return
    for col in range(cols - 1):
        right = total[first + col + 1] - total[first + col]
        down = total[first + cols + col] - total[first + col]
        column_sums[STEPS * cols + col] += right * right + down * down
    down = total[first + 2 * cols - 1] - total[first + cols - 1]
    column_sums[STEPS * cols + cols - 1] += down * down


@loop
def sizes_of(
    pixels: ArraySize,
    total: Annotated[Floats, "rows cols"],
    open_fraction: Annotated[Floats32, "rows cols"],
    lit: Written[Floats],
    column_sums: Written[Annotated[Floats, "kinds cols"]],
) -> None:
    """Compute statistics of each column into column_sums (9, cols).

    These are the sums of `total`, of its squares and of its eighth powers, and its maximum; the
    same for `total` times `open_fraction`; and the sum of squared differences between neighbours.
    Light is at most 1e36, so powers do not overflow. `lit`: working memory for `ROWS` rows."""
    rows, cols = pixels.rows, pixels.cols
    for i in range(KINDS * cols):
        column_sums[i] = 0.0
    for row in range(0, rows, ROWS):
        first, count = row * cols, min(ROWS, rows - row) * cols
        for opened in range(2):
            for i in range(count, ROWS * cols):
                lit[i] = 0.0
            if opened:
                for i in range(count):
                    lit[i] = total[first + i] * open_fraction[first + i]
            else:
                for i in range(count):
                    lit[i] = total[first + i]
            _powers(lit, cols, OPEN * cols if opened else 0, column_sums)
        for step_row in range(row, min(row + ROWS, rows)):
            _steps(total, step_row * cols, cols, step_row + 1 == rows, column_sums)
