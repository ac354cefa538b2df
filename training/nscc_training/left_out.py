"""Choice between reconstructions of a clip by pixels that are left out of them.

A method is better if it predicts better what those pixels measured. The choice is made on the
middle of the frame, and needs no ground truth."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from nscc.arrays import Array, Floats, Floats32
from nscc_training.baselines.gap_tv import gap_tv_of
from nscc_training.measured import Measured

Clips = Floats32
Decoder = Callable[[Measured[Array]], Clips]
"""A function of a measurement whose white is 1, for its clip (1, N, rows, cols)."""

_WEIGHTS = (0.05, 0.1, 0.2, 0.5, 1.0)
"""Weights of total variation to choose from: noise and motion decide which is best."""
_SIDE = 128
"""Rows and columns of the middle of the frame, where methods are compared."""
_BLOCK = 4
"""One pixel of each square of this side is left out."""


def with_weight(weight: float, iterations: int) -> Decoder:
    """Return the decoder that applies `iterations` of GAP-TV with this `weight` of total
    variation."""
    return lambda measured: np.asarray(gap_tv_of(measured, iterations, weight=weight)[0])


def best_weight(measured: Measured[Array], iterations: int) -> tuple[float, Floats]:
    """Return the weight of total variation, one of `_WEIGHTS`, with which GAP-TV predicts left-out
    pixels best (least mean square error; of equal ones the smallest weight), and the errors
    (values,) of its predictions, in units of white.

    `measured` must be divided by white. Each prediction runs `iterations` iterations."""
    errors = [prediction_errors(measured, with_weight(w, iterations)) for w in _WEIGHTS]
    best = int(np.argmin([(gaps**2).mean() for gaps in errors]))
    return _WEIGHTS[best], errors[best]


def prediction_errors(measured: Measured[Array], decoder: Decoder) -> Floats:
    """Return what a decoder's prediction lacks of each value that is left out.

    Parameters
    ----------
    measured : Measured
        A measurement whose white is 1.
    decoder : callable
        It gets the measurement with the masks and values of some pixels set to 0.

    Returns
    -------
    ndarray of float64, shape (values,)
        In units of white, one for each bucket of each pixel that is left out, for every decoder the
        same pixels, from the middle of the frame. A frame without such pixels gives one 0. The
        noise of the value is part of it.
    """
    sides = measured.value.shape[-2:]
    firsts = (max(0, (side - _SIDE) // 2) for side in sides)
    part = measured.crop(*(slice(first, first + _SIDE) for first in firsts))
    rows, cols = part.value.shape[-2:]
    generator = np.random.default_rng(0)
    # One random pixel of each block of `_BLOCK` x `_BLOCK` pixels is left out.
    chosen = generator.integers(_BLOCK, size=(2, -(-rows // _BLOCK), -(-cols // _BLOCK)))
    left_out = np.indices(chosen.shape[1:]) * _BLOCK + chosen
    down, across = left_out[:, (left_out[0] < rows) & (left_out[1] < cols)]
    kept = np.ones((rows, cols), np.float32)
    kept[down, across] = 0
    without = Measured(part.value * kept, part.mask * kept, part.variance, part.saturated)
    gap = part.missing(part.of(decoder(without)), part.value)[..., down, across]
    # Tiny frames may have no pixel to leave out.
    return gap.astype(np.float64).ravel() if gap.size else np.zeros(1)
