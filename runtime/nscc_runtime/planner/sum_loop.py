"""The loops that add up light, each frame weighted by the pixel's lane, and smear it.

`nscc_runtime.planner.sums` has checked what they are given.
"""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc_runtime.loop import (
    Bytes,
    Floats,
    Floats32,
    Ints32,
    Written,
    compiled,
    inlined,
    loop,
    record,
)

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
class SceneSizes:
    """The size of the frames, of which the rows from `begin` to `end` - 1 are to be done.

    Sums from number `smeared` on are of light that neighbours have exchanged `fraction` of.
    """

    begin: int
    end: int
    rows: int
    cols: int
    count: int
    lane_count: int
    sums: int
    smeared: int
    fraction: float


@inlined
def _moved(
    frames: Floats32, scale: Floats, frame: int, p: int, up: int, down: int, left: int, right: int,
    c: np.float32,
) -> np.float32:  # fmt: skip
    """The light of pixel p of a frame once its neighbours, so many places away, have exchanged."""
    own = np.float32(scale[p]) * frames[frame + p]
    four = (
        np.float32(scale[p + up]) * frames[frame + p + up]
        + np.float32(scale[p + down]) * frames[frame + p + down]
        + np.float32(scale[p + left]) * frames[frame + p + left]
        + np.float32(scale[p + right]) * frames[frame + p + right]
    )
    found: np.float32 = own + c * (four - np.float32(4.0) * own)
    return found


@compiled
def _smear(
    sizes: SceneSizes, frames: Floats32, scale: Floats, frame: int, first: int, stop: int,
    lit: Floats32,
) -> None:  # fmt: skip
    """lit[i] := q + fraction laplacian(q) at pixel first + i, q = scale * frame; the border
    reflects. The pixels are of one row.
    """
    cols, c = sizes.cols, np.float32(sizes.fraction)
    row = first // cols
    up = -cols if row > 0 else 0
    down = cols if row + 1 < sizes.rows else 0
    # Those inside have all neighbours: no branch, so LLVM makes vectors.
    for p in range(first + 1, stop - 1):
        lit[p - first] = _moved(frames, scale, frame, p, up, down, -1, 1, c)
    left, right = -1 if first % cols else 0, 1 if first + 1 < (row + 1) * cols else 0
    lit[0] = _moved(frames, scale, frame, first, up, down, left, right, c)
    left, right = -1 if (stop - 1) % cols else 0, 1 if stop % cols else 0
    lit[stop - 1 - first] = _moved(frames, scale, frame, stop - 1, up, down, left, right, c)


@loop
def scene_sums(
    sizes: SceneSizes,
    frames: Annotated[Floats32, "count rows cols"],
    scale: Annotated[Floats, "rows cols"],
    lanes: Annotated[Ints32, "rows cols"],
    table: Annotated[Floats, "sums count lane_count"],
    even: Annotated[Bytes, "sums count"],
    lit: Written[Floats32],
    out: Written[Annotated[Floats, "sums rows cols"]],
) -> None:
    """out[j, p] := the sum over k of table[j, k, lanes[p]] * scale[p] * frames[k, p].

    The frames pass once, for all sums. Products and sums in float64, frame after frame; smeared
    light in float32. `even`: whether the table has the same for all lanes. `lit`: scratch for
    `BLOCK` pixels.
    """
    cols, count, lane_count = sizes.cols, sizes.count, sizes.lane_count
    pixels = sizes.rows * cols
    for row in range(sizes.begin, sizes.end):
        for first in range(row * cols, (row + 1) * cols, BLOCK):
            stop = min(first + BLOCK, (row + 1) * cols)
            for j in range(sizes.sums):
                for p in range(first, stop):
                    out[j * pixels + p] = 0.0
            for k in range(count):
                if sizes.smeared < sizes.sums:
                    _smear(sizes, frames, scale, k * pixels, first, stop, lit)
                for j in range(sizes.sums):
                    at, frame, to = (j * count + k) * lane_count, k * pixels, j * pixels
                    weight = table[at]
                    if even[j * count + k] and weight == 0.0:
                        continue
                    if even[j * count + k] and j >= sizes.smeared:
                        for p in range(first, stop):
                            out[to + p] += weight * lit[p - first]
                    elif even[j * count + k]:
                        for p in range(first, stop):
                            out[to + p] += weight * frames[frame + p]
                    elif j >= sizes.smeared:
                        for p in range(first, stop):
                            out[to + p] += table[at + lanes[p]] * lit[p - first]
                    else:
                        for p in range(first, stop):
                            out[to + p] += table[at + lanes[p]] * frames[frame + p]
            for j in range(sizes.smeared):
                for p in range(first, stop):
                    out[j * pixels + p] *= scale[p]
