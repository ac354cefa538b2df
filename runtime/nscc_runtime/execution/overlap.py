"""Crosstalk of Poisson counts of electrons: the part of a neighbour's counts that arrives in a
pixel's open slots.

Counts are drawn for the exposures of the neighbour itself. From these draws, slot by slot, the
charge that a pixel receives in its open slots is estimated."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Floats, Floats32, Ints32

Weights = Floats32

MOST_EXCHANGED = 0.01
"""Largest fraction of its charge that a pixel may give to each neighbour if frames are exposed by
sums, or if the block loop spreads counts of neighbours evenly over time. Variances and correlations
are then wrong by little (docs/emulator.md). With stronger crosstalk all pixels run through their
words, and their counts are drawn in all stretches that a pixel or a neighbour distinguishes."""

_MOST_PAIRS = 1 << 23
"""Largest number of pairs of lanes for which a table of all pairs is computed: a product of
matrices is some thirty times as fast as sums over single pairs."""
_CHUNK = 4096
_ALL, _FIRST, _LAST = slice(None), slice(None, -1), slice(1, None)
NEIGHBOURS = (
    ((_LAST, _ALL), (_FIRST, _ALL)),
    ((_FIRST, _ALL), (_LAST, _ALL)),
    ((_ALL, _LAST), (_ALL, _FIRST)),
    ((_ALL, _FIRST), (_ALL, _LAST)),
)
"""Index pairs for neighbours above, below, left and right: the pixels (rows, cols) that have such a
neighbour, and these neighbours."""


def weights_beside(seconds: Floats, estimated: Floats, lanes: Ints32) -> Weights:
    """Return the electrons that one Poisson count of each neighbour would add to a pixel's
    exposures if all its charge moved to the pixel.

    Parameters
    ----------
    seconds : float64, shape (N, lanes, buckets)
        Length of each slot in seconds times its weight in the exposures of a lane (the pixels of
        one distinct shutter).
    estimated : float64, shape (N, lanes, draws)
        Estimated charge in each slot, in electrons per second, if a draw of a lane counts 1. A draw
        is one Poisson count of every pixel.
    lanes : int32, shape (rows, cols)
        The lane of each pixel.

    Returns
    -------
    float32, shape (draws, 4, buckets, pixels)
        Neighbours are above, below, left and right; beyond the border weights are 0.
    """
    draws, buckets, table = estimated.shape[2], seconds.shape[2], None
    if seconds.shape[1] ** 2 <= _MOST_PAIRS:
        pairs = [
            [of_bucket @ draw for of_bucket in seconds.T] for draw in estimated.transpose(2, 0, 1)
        ]
        table = np.array(pairs, np.float32)
    all_weights = np.zeros((draws, len(NEIGHBOURS), buckets, *lanes.shape), np.float32)
    for side, (to, source) in enumerate(NEIGHBOURS):
        own, other = lanes[to].reshape(-1), lanes[source].reshape(-1)
        if table is not None:
            weights = table[:, :, own, other]
        else:
            weights = np.empty((draws, buckets, own.size), np.float32)
            for first in range(0, own.size, _CHUNK):
                chunk = slice(first, first + _CHUNK)
                weights[:, :, chunk] = np.einsum(
                    "npb,npd->dbp", seconds[:, own[chunk]], estimated[:, other[chunk]]
                )
        shape = draws, buckets, *lanes[to].shape
        all_weights[(slice(None), side, slice(None), *to)] = weights.reshape(shape)
    return all_weights.reshape(draws, len(NEIGHBOURS), buckets, lanes.size)
