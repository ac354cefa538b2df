"""The loop that adds up light, each frame weighted by the pixel's lane.

It takes bare pointers, allocates nothing and raises nothing; `nscc_runtime.plan.sums` has checked
what it is given. Importing this module imports numba.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# Pointers; typed as arrays, which is how they are used.
Ints = NDArray[np.int64]
Ints32 = NDArray[np.int32]
Floats = NDArray[np.float64]
Frames = NDArray[np.float32]

_BLOCK = 512
"""Pixels whose sums stay in the cache while the frames go by."""


def weighted_sums(sizes: Ints, frames: Frames, lanes: Ints32, table: Floats, out: Floats) -> None:
    """out[j, p] := the sum over k of table[j, k, lanes[p]] * frames[k, p].

    `sizes`: pixels in all, the first and the last + 1 of those to do, frames, lanes, sums. Products
    and sums in float64, frame after frame.
    """
    pixels, begin, end, count, lane_count, sums = (
        sizes[0], sizes[1], sizes[2], sizes[3], sizes[4], sizes[5],
    )  # fmt: skip
    for first in range(begin, end, _BLOCK):
        stop = min(first + _BLOCK, end)
        for j in range(sums):
            for p in range(first, stop):
                out[j * pixels + p] = 0.0
        for k in range(count):
            for j in range(sums):
                row = (j * count + k) * lane_count
                for p in range(first, stop):
                    out[j * pixels + p] += table[row + lanes[p]] * frames[k * pixels + p]


SIGNATURE = (
    "void(CPointer(int64), CPointer(float32), CPointer(int32), CPointer(float64), "
    "CPointer(float64))"
)
"""The types of `weighted_sums`'s parameters, for numba."""
