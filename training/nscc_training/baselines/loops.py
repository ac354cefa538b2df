"""The loop that `nscc_training.baselines.compiled` makes machine code of. It imports numba.

It takes bare pointers, allocates nothing and raises nothing; `nscc_training.baselines.tv` has
checked what it is given. Volumes are (frames, rows, cols), flat.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, cast

import numba
import numpy as np
from numpy.typing import NDArray

_F = TypeVar("_F", bound=Callable[..., object])

# Pointers; typed as arrays, which is how they are used.
Floats = NDArray[np.float32]
Ints = NDArray[np.int64]

_ONE = np.float32(1.0)
_ZERO = np.float32(0.0)


def _inlined(function: _F) -> _F:
    return cast(_F, numba.njit(inline="always", error_model="numpy")(function))


@_inlined
def _primal_row(
    cols: int, at: int, plane: int, links: int, time: np.float32,
    image: Floats, later: Floats, down: Floats, right: Floats, out: Floats,
) -> None:  # fmt: skip
    """out = image + div(field) in the row that begins at `at`.

    `links` says which neighbours there are: 1 above, 2 in the frame before.
    """
    if links == 3:
        for k in range(at + 1, at + cols):
            out[k] = (
                image[k] - right[k] + right[k - 1] - down[k] + down[k - cols]
                + time * (later[k - plane] - later[k])
            )  # fmt: skip
    elif links == 2:
        for k in range(at + 1, at + cols):
            out[k] = (
                image[k] - right[k] + right[k - 1] - down[k] + time * (later[k - plane] - later[k])
            )
    elif links == 1:
        for k in range(at + 1, at + cols):
            out[k] = image[k] - right[k] + right[k - 1] - down[k] + down[k - cols] - time * later[k]
    else:
        for k in range(at + 1, at + cols):
            out[k] = image[k] - right[k] + right[k - 1] - down[k] - time * later[k]
    first = image[at] - right[at] - down[at] - time * later[at]
    if links & 1:
        first += down[at - cols]
    if links & 2:
        first += time * later[at - plane]
    out[at] = first


@_inlined
def _dual_row(
    cols: int, at: int, plane: int, links: int, step: np.float32, pull: np.float32,
    time: np.float32, out: Floats, later: Floats, down: Floats, right: Floats,
) -> None:  # fmt: skip
    """A descent step of the field in one row, back into the ball of radius `weight`.

    `links` says which neighbours there are: 1 below, 2 in the frame after. Without one, that part
    of the field stays 0.
    """
    end = at + cols - 1
    last_down, last_later = _ZERO, _ZERO
    if links & 1:
        last_down = out[end + cols] - out[end]
    if links & 2:
        last_later = time * (out[end + plane] - out[end])
    if links == 3:
        for k in range(at, end):
            r, d, t = out[k + 1] - out[k], out[k + cols] - out[k], time * (out[k + plane] - out[k])
            scale = _ONE / (_ONE + pull * np.sqrt(r * r + d * d + t * t))
            right[k] = (right[k] - step * r) * scale
            down[k] = (down[k] - step * d) * scale
            later[k] = (later[k] - step * t) * scale
    elif links == 2:
        for k in range(at, end):
            r, t = out[k + 1] - out[k], time * (out[k + plane] - out[k])
            scale = _ONE / (_ONE + pull * np.sqrt(r * r + t * t))
            right[k] = (right[k] - step * r) * scale
            later[k] = (later[k] - step * t) * scale
    elif links == 1:
        for k in range(at, end):
            r, d = out[k + 1] - out[k], out[k + cols] - out[k]
            scale = _ONE / (_ONE + pull * np.sqrt(r * r + d * d))
            right[k] = (right[k] - step * r) * scale
            down[k] = (down[k] - step * d) * scale
    else:
        for k in range(at, end):
            r = out[k + 1] - out[k]
            right[k] = (right[k] - step * r) / (_ONE + pull * abs(r))
    scale = _ONE / (_ONE + pull * np.sqrt(last_down * last_down + last_later * last_later))
    if links & 1:
        down[end] = (down[end] - step * last_down) * scale
    if links & 2:
        later[end] = (later[end] - step * last_later) * scale


def denoise(
    sizes: Ints, weights: Floats, image: Floats, later: Floats, down: Floats, right: Floats,
    out: Floats,
) -> None:  # fmt: skip
    """Chambolle's projection (2004) of a volume: least |out - image|^2 / 2 + weight TV(out).

    `sizes` = frames, rows, cols, iterations; `weights` = weight, weight of differences in time
    relative to those in space. `later`, `down` and `right` are the dual field, from where it is to
    where it has come, 0 where a neighbour is missing.
    """
    frames, rows, cols, iterations = sizes[0], sizes[1], sizes[2], sizes[3]
    plane = rows * cols
    time = weights[1]
    # 1 / (2 dimensions) is where the projection is known to converge.
    step = _ONE / (np.float32(4.0) + np.float32(2.0) * time * time)
    pull = step / weights[0]
    for turn in range(iterations + 1):
        for frame in range(frames):
            before = 2 if frame > 0 else 0
            for row in range(rows):
                links = before + (1 if row > 0 else 0)
                at = frame * plane + row * cols
                _primal_row(cols, at, plane, links, time, image, later, down, right, out)
            if frame > 0 and turn < iterations:
                for row in range(rows):
                    links = 2 + (1 if row < rows - 1 else 0)
                    at = (frame - 1) * plane + row * cols
                    _dual_row(cols, at, plane, links, step, pull, time, out, later, down, right)
        if turn < iterations:
            for row in range(rows):
                links = 1 if row < rows - 1 else 0
                at = (frames - 1) * plane + row * cols
                _dual_row(cols, at, plane, links, step, pull, time, out, later, down, right)


_INTS, _FLOATS = "CPointer(int64)", "CPointer(float32)"

SIGNATURE = f"void({_INTS}, {', '.join([_FLOATS] * 6)})"
"""The types of its parameters, for numba."""
