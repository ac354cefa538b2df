"""The loops that add up light, each frame weighted by the pixel's lane, and smear it.

`nscc_runtime.planner.sums` has checked what they are given.
"""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc_runtime.loop import Floats, Floats32, Ints32, Written, loop, record

BLOCK = 512
"""Pixels whose sums stay in the cache while the frames go by."""


@record
class SumSizes:
    """How much there is of everything; `begin` and `end` say which pixels are to be done."""

    pixels: int
    begin: int
    end: int
    count: int
    lane_count: int
    sums: int


@loop
def weighted_sums(
    sizes: SumSizes,
    frames: Annotated[Floats32, "count pixels"],
    lanes: Annotated[Ints32, "pixels"],
    table: Annotated[Floats, "sums count lane_count"],
    out: Written[Annotated[Floats, "sums pixels"]],
) -> None:
    """out[j, p] := the sum over k of table[j, k, lanes[p]] * frames[k, p].

    Products and sums in float64, frame after frame.
    """
    pixels, end, count, lane_count = sizes.pixels, sizes.end, sizes.count, sizes.lane_count
    sums = sizes.sums
    for first in range(sizes.begin, end, BLOCK):
        stop = min(first + BLOCK, end)
        for j in range(sums):
            for p in range(first, stop):
                out[j * pixels + p] = 0.0
        for k in range(count):
            for j in range(sums):
                row = (j * count + k) * lane_count
                for p in range(first, stop):
                    out[j * pixels + p] += table[row + lanes[p]] * frames[k * pixels + p]


@record
class SmearSizes:
    """The size of a frame; `begin` and `end` say which frames are to be done."""

    begin: int
    end: int
    rows: int
    cols: int
    fraction: float


@loop
def smeared_frames(
    sizes: SmearSizes, frames: Annotated[Floats32, "frames rows cols"],
    scale: Annotated[Floats, "rows cols"], out: Written[Annotated[Floats32, "frames rows cols"]],
) -> None:  # fmt: skip
    """out[k] := q + fraction laplacian(q), q = scale * frames[k]; the border reflects."""
    rows, cols = sizes.rows, sizes.cols
    c = np.float32(sizes.fraction)
    for k in range(sizes.begin, sizes.end):
        at = k * rows * cols
        for row in range(rows):
            here = row * cols
            up = here - cols if row > 0 else here
            down = here + cols if row + 1 < rows else here
            for col in range(cols):
                left = col - 1 if col > 0 else col
                right = col + 1 if col + 1 < cols else col
                own = np.float32(scale[here + col]) * frames[at + here + col]
                four = (
                    np.float32(scale[up + col]) * frames[at + up + col]
                    + np.float32(scale[down + col]) * frames[at + down + col]
                    + np.float32(scale[here + left]) * frames[at + here + left]
                    + np.float32(scale[here + right]) * frames[at + here + right]
                )
                out[at + here + col] = own + c * (four - np.float32(4.0) * own)
