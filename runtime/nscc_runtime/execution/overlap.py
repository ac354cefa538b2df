"""Crosstalk of counts: the part of a neighbour's counts that arrives in a pixel's open slots.

A neighbour's charge is drawn for the neighbour's own exposures. What another pixel collects of it
in its own open slots is estimated from these draws, slot by slot."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.float64]
Weights = NDArray[np.float32]

_MOST_PAIRS = 1 << 23
"""Largest number of pairs of lanes for which a table of all pairs is computed: a product of
matrices is some thirty times as fast as sums over single pairs."""
_CHUNK = 4096
_ALL, _FIRST, _LAST = slice(None), slice(None, -1), slice(1, None)
NEIGHBOURS = (
    ((_LAST, _ALL), (_FIRST, _ALL)), ((_FIRST, _ALL), (_LAST, _ALL)),
    ((_ALL, _LAST), (_ALL, _FIRST)), ((_ALL, _FIRST), (_ALL, _LAST)),
)  # fmt: skip
"""Index pairs for neighbours above, below, left and right: the pixels (rows, cols) that have such a
neighbour, and these neighbours."""


@dataclass(frozen=True, eq=False)
class Overlap:
    """The weights of the draws of one pixel in the exposures of another.

    Attributes
    ----------
    seconds : float64, shape (N, lanes, buckets)
        Length of each slot times its weight in the exposures of a lane.
    estimated : float64, shape (N, lanes, draws)
        Charge per second in each slot, for one count of a draw of a lane.
    """

    seconds: Values
    estimated: Values

    def between(
        self, pixel_lanes: NDArray[np.int32], neighbour_lanes: NDArray[np.int32]
    ) -> Weights:
        """Return weights (draws, buckets, pairs) of neighbours' counts, for pairs of lanes."""
        if self._table is not None:
            return self._table[:, :, pixel_lanes, neighbour_lanes]
        draws, buckets = self.estimated.shape[2], self.seconds.shape[2]
        weights = np.empty((draws, buckets, pixel_lanes.size), np.float32)
        for first in range(0, pixel_lanes.size, _CHUNK):
            chunk = slice(first, first + _CHUNK)
            weights[:, :, chunk] = np.einsum(
                "npb,npd->dbp",
                self.seconds[:, pixel_lanes[chunk]],
                self.estimated[:, neighbour_lanes[chunk]],
            )
        return weights

    @cached_property
    def _table(self) -> Weights | None:
        """Weights (draws, buckets, lanes, lanes) of all pairs of lanes; None if too many pairs."""
        if self.seconds.shape[1] ** 2 > _MOST_PAIRS:
            return None
        seconds, estimated = self.seconds.T, self.estimated.transpose(2, 0, 1)
        pairs = [[of_bucket @ draw for of_bucket in seconds] for draw in estimated]
        return np.array(pairs, np.float32)


def weights_beside(overlap: Overlap, lanes: NDArray[np.int32]) -> Weights:
    """Return the weights (draws, 4, buckets, pixels) of neighbours' counts in a pixel's exposures.

    `lanes` (rows, cols): the lane of each pixel. Neighbours are above, below, left and right;
    beyond the border weights are 0."""
    draws, buckets = overlap.estimated.shape[2], overlap.seconds.shape[2]
    all_weights = np.zeros((draws, len(NEIGHBOURS), buckets, *lanes.shape), np.float32)
    for side, (to, source) in enumerate(NEIGHBOURS):
        weights = overlap.between(lanes[to].reshape(-1), lanes[source].reshape(-1))
        all_weights[(slice(None), side, slice(None), *to)] = weights.reshape(
            draws, buckets, *lanes[to].shape
        )
    return all_weights.reshape(draws, len(NEIGHBOURS), buckets, lanes.size)
