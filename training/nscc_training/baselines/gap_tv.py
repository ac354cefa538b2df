"""GAP-TV: clips from coded frames by total variation, for arrays of numpy and of torch."""

from __future__ import annotations

import numpy as np

from nscc_training.baselines.tv_loop import tv_denoised_arrays
from nscc_training.measured import Array, Measured, namespace

START = 20
"""Iterations of GAP-TV at the start of decoders."""
WEIGHT, INNER, TIME = 0.1, 5, 0.3
"""The weight of total variation, iterations of the denoiser, and the weight of differences between
frames relative to those between pixels, because objects move."""
_FAR = 1.0
"""Standard deviation of the clip's error that GAP-TV assumes, so large that frames are fitted
exactly."""


def gap_tv_of(
    measured: Measured[Array],
    iterations: int = START,
    *,
    weight: float = WEIGHT,
    start: Array | None = None,
) -> tuple[Array, Array]:
    """Reconstruct clips by accelerated generalised alternating projection with total variation (X.
    Yuan, ICIP 2016).

    Without noise it minimises TV(x) = sum of sqrt(right^2 + down^2 + (TIME later)^2), the
    differences of x between neighbouring pixels and frames, over all clips x with A x = y: the
    frames `measured.of(x)` are those that were measured. Each of the `iterations` is

        target <- target + (y - A x)
        x <- x + A^T (A A^T)^-1 (target - A x), with the same A x
        x <- argmin over z of |z - x|^2 / 2 + weight TV(z), by `INNER` steps of Chambolle's method

    Noise is added to A A^T, and its part of a difference is left out of `target`. Returns the clips
    (batch, N, rows, cols), and `target` (shape of y): y plus all differences that remained after
    earlier steps, with which `gap_step` continues.

    The default start is a static clip, with each pixel's light spread over the frame. From a dark
    start, slots that no pixel recorded would stay about a fifth too dark (64 slots)."""
    library, target = namespace(measured.value), measured.value
    sigma: Array = library.full_like(measured.value[:, 0, 0, 0], _FAR)
    # The first clip must have no other name, or its memory stays in use.
    clip: Array = (
        library.stack([measured.mean()] * measured.mask.shape[2], 1) if start is None else start
    )
    for _ in range(iterations):
        clip, target = gap_step(measured, clip, target, sigma)
        clip = _denoised(clip, weight)
    return clip, target


def gap_step(
    measured: Measured[Array], clip: Array, target: Array, sigma: Array
) -> tuple[Array, Array]:
    """Return the clip (batch, N, rows, cols) after one step towards the frames of `measured`, and
    the updated `target`: the frames plus what earlier steps have not explained.

    `target` has the shape of the frames; the first step receives the frames themselves. `sigma`
    (batch,) is the standard deviation of the clip's error: the smaller it is, the less is
    corrected."""
    predicted = measured.of(clip)
    target = target + measured.missing(predicted, measured.value) * measured.trust(sigma)
    corrected: Array = measured.correction(measured.missing(predicted, target), sigma)
    corrected += clip
    return corrected, target


def _denoised(clip: Array, weight: float) -> Array:
    """Denoise a clip (batch, T, rows, cols) by `INNER` iterations of total variation of this
    `weight`, in which differences in time count `TIME`. Works on arrays of numpy and of torch."""
    if isinstance(clip, np.ndarray):
        return tv_denoised_arrays(clip, weight, INNER, TIME)
    from nscc_training.baselines.tensor_tv import tv_denoised

    denoised: Array = tv_denoised(clip, weight, INNER, TIME).to(clip)
    return denoised
