"""Crosstalk of counts: the fraction of a neighbour's count that arrives in a pixel's open slots.

A neighbour's charge is counted for the neighbour's own groups of slots. The fraction of a group's
count in the open slots of another pixel is approximated by the fraction of the group's time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.float64]
Weights = NDArray[np.float32]

_MOST_PAIRS = 1 << 20
"""Largest number of pairs of lanes for which a table of all pairs is computed."""
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
    """The weight of the counts of one group of slots in the exposures of other pixels.

    Attributes
    ----------
    seconds : float64, shape (N, lanes, buckets)
        Length of each slot times its weight.
    inverse_seconds : float64, shape (N, lanes)
        1 / (total seconds of the group's slots) in these slots; 0 elsewhere.
    """

    seconds: Values
    inverse_seconds: Values

    def between(
        self, pixel_lanes: NDArray[np.int32], neighbour_lanes: NDArray[np.int32]
    ) -> Weights:
        """Return weights (buckets, pairs) of neighbours' counts in pixels, for pairs of lanes."""
        if self._table is not None:
            return self._table[:, pixel_lanes, neighbour_lanes]
        weights = np.empty((self.seconds.shape[2], pixel_lanes.size), np.float32)
        for first in range(0, pixel_lanes.size, _CHUNK):
            chunk = slice(first, first + _CHUNK)
            weights[:, chunk] = np.einsum(
                "npb,np->bp",
                self.seconds[:, pixel_lanes[chunk]],
                self.inverse_seconds[:, neighbour_lanes[chunk]],
            )
        return weights

    @cached_property
    def _table(self) -> Weights | None:
        """Weights (buckets, lanes, lanes) of all pairs of lanes; None if too many pairs."""
        _, lanes, buckets = self.seconds.shape
        if lanes**2 > _MOST_PAIRS:
            return None
        by_bucket = (
            self.seconds[:, :, bucket].T @ self.inverse_seconds for bucket in range(buckets)
        )
        return np.stack([*by_bucket]).astype(np.float32)


def weights_beside(overlaps: Sequence[Overlap], buckets: int, lanes: NDArray[np.int32]) -> Weights:
    """Return the weights (groups, 4, buckets, pixels) of neighbours' counts in a pixel's exposures.

    `lanes` (rows, cols): the lane of each pixel. Neighbours are above, below, left and right;
    beyond the border weights are 0."""
    all_weights = np.zeros((len(overlaps), len(NEIGHBOURS), buckets, *lanes.shape), np.float32)
    for number, overlap in enumerate(overlaps):
        for side, (to, source) in enumerate(NEIGHBOURS):
            weights = overlap.between(lanes[to].reshape(-1), lanes[source].reshape(-1))
            all_weights[(number, side, slice(None), *to)] = weights.reshape(
                buckets, *lanes[to].shape
            )
    return all_weights.reshape(*all_weights.shape[:3], lanes.size)
