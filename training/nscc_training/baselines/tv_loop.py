"""Total variation denoising of clips, in one thread, by a compiled loop."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc.arrays import Array, Floats32
from nscc_runtime.loop import Written, inlined, loop, record

_ONE = np.float32(1.0)


@inlined
def _primal_row(
    cols: int,
    at: int,
    above: int,
    before: int,
    time: np.float32,
    image: Floats32,
    later: Floats32,
    down: Floats32,
    right: Floats32,
    out: Floats32,
) -> None:
    """Compute out = image + div(field) in one row, of `cols` pixels, that begins at index `at`; all
    arrays are flat.

    `right`, `down` and `later` are the field: one component for each direction of a difference.
    `time` is the weight of differences between frames. The pixel above is `above` elements back,
    that in the previous frame `before` elements. If such a neighbour is missing, the element there
    is in the last row or frame, where its component of the field is 0."""
    for k in range(at + 1, at + cols):
        out[k] = (
            image[k]
            - right[k]
            + right[k - 1]
            - down[k]
            + down[k - above]
            + time * (later[k - before] - later[k])
        )
    first = image[at] - right[at] - down[at] - time * later[at]
    out[at] = first + down[at - above] + time * later[at - before]


@inlined
def _dual_row(
    cols: int,
    at: int,
    below: int,
    after: int,
    step: np.float32,
    pull: np.float32,
    time: np.float32,
    out: Floats32,
    later: Floats32,
    down: Floats32,
    right: Floats32,
) -> None:
    """Take a descent step of the field (`right`, `down`, `later`) in one row, projected back into
    the ball of radius `weight`.

    The row begins at index `at`. The pixel below is `below` elements ahead, that in the next frame
    `after` elements. If the neighbour is missing, the distance is 0, so that the difference is 0
    and its component of the field stays 0. `pull` is `step` / `weight`, and `time` is the weight of
    differences between frames."""
    end = at + cols - 1
    last_down, last_later = out[end + below] - out[end], time * (out[end + after] - out[end])
    for k in range(at, end):
        r, d, t = out[k + 1] - out[k], out[k + below] - out[k], time * (out[k + after] - out[k])
        scale = _ONE / (_ONE + pull * np.sqrt(r * r + d * d + t * t))
        right[k] = (right[k] - step * r) * scale
        down[k] = (down[k] - step * d) * scale
        later[k] = (later[k] - step * t) * scale
    scale = _ONE / (_ONE + pull * np.sqrt(last_down * last_down + last_later * last_later))
    down[end] = (down[end] - step * last_down) * scale
    later[end] = (later[end] - step * last_later) * scale


@record
class Volume:
    """Size of a batch of `clips`, each of `frames` frames of `rows` x `cols` pixels, and how they
    are denoised: number of `iterations`, `weight` of total variation (above 0), and `time`, the
    weight of differences in time relative to those in space."""

    clips: int
    frames: int
    rows: int
    cols: int
    iterations: int
    weight: float
    time: float


_Clip = Annotated[Floats32, "clips frames rows cols"]


@inlined
def _denoise_clip(
    volume: Volume,
    clip: int,
    image: Floats32,
    later: Floats32,
    down: Floats32,
    right: Floats32,
    out: Floats32,
) -> None:
    """Denoise clip number `clip` of `image` by dual projections (Chambolle 2004), and write the
    result into `out`.

    `later`, `down` and `right` are the dual field in time and space; it is updated in place. Arrays
    are flat and hold the frames of a clip one after the other."""
    frames, rows, cols, iterations = volume.frames, volume.rows, volume.cols, volume.iterations
    plane = rows * cols
    begin = clip * frames * plane
    time, weight = np.float32(volume.time), np.float32(volume.weight)
    # 1 / (2 dimensions) is where the projection is known to converge.
    step = _ONE / (np.float32(4.0) + np.float32(2.0) * time * time)
    pull = step / weight
    for turn in range(iterations + 1):
        for frame in range(frames + 1):
            # The field of a frame changes after both of its neighbours in time are computed.
            at = begin + frame * plane
            if frame < frames:
                before = plane if frame > 0 else plane - frames * plane
                for row in range(rows):
                    above = cols if row > 0 else cols - plane
                    _primal_row(
                        cols, at + row * cols, above, before, time, image, later, down, right, out
                    )
            if frame > 0 and turn < iterations:
                after = plane if frame < frames else 0
                for row in range(rows):
                    below = cols if row < rows - 1 else 0
                    _dual_row(
                        cols,
                        at - plane + row * cols,
                        below,
                        after,
                        step,
                        pull,
                        time,
                        out,
                        later,
                        down,
                        right,
                    )


@loop
def denoise(
    volume: Volume,
    image: _Clip,
    later: Written[_Clip],
    down: Written[_Clip],
    right: Written[_Clip],
    out: Written[_Clip],
) -> None:
    """Denoise each clip of `image` by Chambolle's projection (2004): minimise |out - image|^2 / 2 +
    weight TV(out).

    `out` receives the result. `later`, `down` and `right` are the dual field, updated in place: 0
    at the start, and always 0 where a neighbour is missing."""
    for clip in range(volume.clips):
        _denoise_clip(volume, clip, image, later, down, right, out)


Clip = Floats32


def tv_denoise(clip: Clip, weight: float, iterations: int, time: float = 1.0) -> Clip:
    """Denoise a clip (T, rows, cols) by `iterations` of Chambolle's method for total variation, and
    return float32.

    A larger `weight` smooths more. `time` weights differences between frames relative to those
    between pixels; 0 denoises every frame alone. The dual field starts at 0. Raises ValueError for
    an array that is not a clip and for a weight of 0 or less."""
    if clip.ndim != 3 or 0 in clip.shape:
        raise ValueError(f"a clip has the shape (T, rows, cols), at least 1 each, not {clip.shape}")
    if not weight > 0 or iterations < 0 or not time >= 0:
        raise ValueError(f"weight {weight}, {iterations} iterations, time {time}")
    return np.asarray(tv_denoised_arrays(clip[None], weight, iterations, time)[0])


def tv_denoised_arrays(clips: Array, weight: float, iterations: int, time: float) -> Clip:
    """Return clips (batch, T, rows, cols), float32, each denoised by itself as `tv_denoise` does.
    The arguments, among them `weight` above 0, are not checked."""
    image = np.ascontiguousarray(clips, np.float32)
    field = np.zeros((3, *image.shape), np.float32)
    out = np.empty_like(image)
    batch, frames, rows, cols = image.shape
    volume = Volume(
        clips=batch,
        frames=frames,
        rows=rows,
        cols=cols,
        iterations=iterations,
        weight=weight,
        time=time,
    )
    denoise(volume=volume, image=image, later=field[0], down=field[1], right=field[2], out=out)
    return out
