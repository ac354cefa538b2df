"""The loop that adds up the light of a scene."""

from __future__ import annotations

from typing import Annotated, NamedTuple

from nscc_runtime.loop import Floats, Floats32, Ints, Ints32, Written, compiled, loop, record


class LightMatrix(NamedTuple):
    """The frames and weights of `nscc_runtime.light.Light`, with its names."""

    frames: Annotated[Floats32, "frames chip_pixels"]
    row_start: Annotated[Ints, "slots+1"]
    frame_index: Annotated[Ints32, "entries"]
    weight: Annotated[Floats, "entries"]


BLOCK = 2048
"""Number of pixels whose sums stay in the cache for all frames."""


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
