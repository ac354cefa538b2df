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


def smeared_frames(
    sizes: Ints, fraction: Floats, frames: Frames, scale: Floats, out: Frames
) -> None:
    """out[k] := q + fraction laplacian(q), q = scale * frames[k] (rows, cols); the border reflects.

    `sizes`: first frame and last + 1, rows, cols.
    """
    rows, cols = sizes[2], sizes[3]
    c = np.float32(fraction[0])
    for k in range(sizes[0], sizes[1]):
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


SIGNATURES = {
    "weighted_sums": (
        "void(CPointer(int64), CPointer(float32), CPointer(int32), CPointer(float64), "
        "CPointer(float64))"
    ),
    "smeared_frames": (
        "void(CPointer(int64), CPointer(float64), CPointer(float32), CPointer(float64), "
        "CPointer(float32))"
    ),
}
"""The types of the loops' parameters, for numba."""
