"""Video snapshot compressive imaging without learning: T frames from one coded exposure. `mask` is
(T, rows, cols), `measurement` (rows, cols) = sum over T of mask * clip, and the result a clip (T,
rows, cols), on 0..1 in the unit of the measurement."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Floats, Floats32
from nscc_training.baselines.dictionary import dictionary_clip, made_dictionary
from nscc_training.baselines.gap_tv import INNER, TIME, WEIGHT, gap_tv_of
from nscc_training.baselines.merge_loop import tent_sums
from nscc_training.baselines.tv_loop import Clip, tv_denoise
from nscc_training.measured import Measured

ITERATIONS = 40
_RIDGE = 0.01
"""Weight of the constraint that both solutions of ADMM agree."""


def gap_tv(
    measurement: Floats32,
    mask: Clip,
    iterations: int = ITERATIONS,
    weight: float = WEIGHT,
) -> Clip:
    """Reconstruct the clip (T, rows, cols) of a `measurement` (rows, cols) through `mask` (T, rows,
    cols) by `iterations` of GAP-TV, without noise. It starts from the measurement divided among the
    open frames.

    `weight` is that of total variation."""
    measured = Measured.exact(measurement[None], mask[None])
    start = adjoint(measurement, mask)[None]
    clips, _ = gap_tv_of(measured, iterations, weight=weight, start=start)
    return np.asarray(clips[0])


def admm_tv(
    measurement: Floats32,
    mask: Clip,
    iterations: int = ITERATIONS,
    weight: float = WEIGHT,
) -> Clip:
    """Reconstruct a clip x by the alternating direction method of multipliers (ADMM): minimise
    |measurement - sum over T of mask x|^2 / 2 + `_RIDGE` weight TV(x).

    TV is the total variation of `gap_tv_of`. Each of the `iterations` solves for the data term and
    then for TV. `dual` sums the differences of both solutions, which brings them together."""
    energy = _energy(mask) + np.float32(_RIDGE)
    clip = mask * (measurement / energy)
    dual = np.zeros_like(clip)
    for _ in range(iterations):
        split = clip + dual
        captured = np.einsum("trc,trc->rc", mask, split)
        split += mask * ((measurement - captured) / energy)
        clip = tv_denoise(split - dual, weight, INNER, TIME)
        dual -= split - clip
    return clip


def from_dictionary(measurement: Floats32, mask: Clip) -> Clip:
    """Reconstruct a clip by sparse coding (`nscc_training.baselines.dictionary`). The first call
    for a number of frames learns a dictionary."""
    return dictionary_clip(measurement, mask, made_dictionary(len(mask)))


def adjoint(measurement: Floats32, mask: Clip) -> Clip:
    """Return the measurement shared among the frames in which a pixel was open: S^T E, divided by
    the sum of squares of its mask. Decoders start from it."""
    return np.asarray(mask * (measurement / _energy(mask)), np.float32)


def bilinear(clip: Clip, mask: Clip) -> Clip:
    """Interpolate the pixels of each frame of `clip` that its mask opens, with tent weights whose
    reach doubles until they find data. A frame that no pixel sees is 0.

    This is a reference method: it uses the ground truth `clip` instead of the measurement."""
    pairs = zip(clip, mask, strict=True)
    return np.stack([_inpainted(frame * open_mask, open_mask) for frame, open_mask in pairs])


_STEP = 4


def thin_out(clip: Clip) -> Clip:
    """Keep every fourth pixel in x and y of all frames of `clip`, and interpolate the others
    linearly.

    This is a reference method: it uses the ground truth `clip` instead of the measurement."""
    rows, cols = clip.shape[1:]
    down, right = _between(rows, _STEP), _between(cols, _STEP)
    return np.asarray(down @ clip[:, ::_STEP, ::_STEP] @ right.T, np.float32)


def _energy(mask: Clip) -> Floats32:
    """Return the sum over the frames of the squared `mask` (T, rows, cols), as (rows, cols). It is
    1 where a pixel never opens, so that one can divide by it."""
    energy = np.einsum("trc,trc->rc", mask, mask)
    return np.asarray(np.where(energy > 0, energy, 1), np.float32)


def _inpainted(values: Floats32, sample_mask: Floats32) -> Floats32:
    """Return a picture (rows, cols) whose missing pixels are means of the known ones around them.

    `values` are light times `sample_mask`, which is the weight of each pixel and 0 where the pixel
    is missing. The neighbourhood doubles until every pixel has a known one; without any, the
    picture is 0."""
    picture = np.zeros_like(values)
    missing = np.ones(values.shape, bool)
    reach = 2
    while missing.any():
        weight = tent_sums(sample_mask.astype(np.float64), reach)
        sums = tent_sums(values.astype(np.float64), reach)
        fillable = missing & (weight > 0)
        picture[fillable] = (sums[fillable] / weight[fillable]).astype(np.float32)
        missing &= ~fillable
        if reach > 2 * max(values.shape):
            break
        reach *= 2
    keep = sample_mask > 0
    picture[keep] = values[keep] / sample_mask[keep]
    return picture


def _between(length: int, step: int) -> Floats:
    """Return the matrix (length, samples) that interpolates linearly between samples at every
    `step`-th of `length` places. After the last sample its value is repeated."""
    at = np.arange(0, length, step)
    return np.stack([np.interp(np.arange(length), at, unit) for unit in np.eye(len(at))], 1)
