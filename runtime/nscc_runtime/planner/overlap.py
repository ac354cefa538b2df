"""Crosstalk of counts: how much of a neighbour's counted charge falls on a pixel's open slots.

A neighbour's charge is counted for its own groups of slots. What of a group's count lies in the
slots that another pixel has open is taken as that part of the group's time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.float64]
Weights = NDArray[np.float32]

_MOST_PAIRS = 1 << 20
"""Pairs of lanes up to which a table of all pairs is made; else each pixel's pair is computed."""
_CHUNK = 4096
_ALL, _FIRST, _LAST = slice(None), slice(None, -1), slice(1, None)
_NEIGHBOURS = (
    ((_LAST, _ALL), (_FIRST, _ALL)), ((_FIRST, _ALL), (_LAST, _ALL)),
    ((_ALL, _LAST), (_ALL, _FIRST)), ((_ALL, _FIRST), (_ALL, _LAST)),
)  # fmt: skip
"""Above, below, left and right: the pixels (rows, cols) that have such a neighbour, and those."""


@dataclass(frozen=True, eq=False)
class Overlap:
    """Weights of the deviations of groups' counts in the exposures: of a pixel's `own` (groups,
    buckets, pixels), and of those of its `neighbours` (groups, 4, buckets, pixels) above, below,
    left and right.
    """

    own: Weights
    neighbours: Weights

    @classmethod
    def of(
        cls,
        lanes: NDArray[np.int32],
        slot_s: Values,
        weights: Values,
        groups: Sequence[tuple[Values, Values]],
    ) -> Overlap:
        """For the weights (N, lanes, buckets) of slots that are `slot_s` (N,) long.

        `lanes` (rows, cols); `groups`: where each group has slots (N, lanes), 1 or 0, and its mean
        weight (lanes, buckets).
        """
        seconds = weights * slot_s[:, None, None]
        shape = len(groups), weights.shape[2], lanes.size
        own = np.empty(shape, np.float32)
        neighbours = np.empty((shape[0], len(_NEIGHBOURS), *shape[1:]), np.float32)
        for group, (members, means) in enumerate(groups):
            time = slot_s @ members
            parts = np.divide(members, time, out=np.zeros_like(members), where=time > 0)
            own[group] = means.T[:, lanes.reshape(-1)]
            for each, (to, source) in enumerate(_NEIGHBOURS):
                found = _pairs(seconds, parts, lanes, to, source)
                neighbours[group, each] = found.reshape(shape[1:])
        return cls(own, neighbours)


def _pairs(
    weights: Values,
    parts: Values,
    lanes: NDArray[np.int32],
    to: tuple[slice, slice],
    source: tuple[slice, slice],
) -> Weights:
    """The weight (buckets, rows, cols) of the neighbours `source` of `to`; 0 where there is none.

    `weights` (N, lanes, buckets) times the slots' seconds, `parts` (N, lanes).
    """
    buckets = weights.shape[2]
    found = np.zeros((buckets, *lanes.shape), np.float32)
    mine, other = lanes[to].reshape(-1), lanes[source].reshape(-1)
    values = np.empty((buckets, mine.size), np.float32)
    if weights.shape[1] ** 2 <= _MOST_PAIRS:
        for bucket in range(buckets):
            values[bucket] = (weights[:, :, bucket].T @ parts)[mine, other]
    else:
        for first in range(0, mine.size, _CHUNK):
            part = slice(first, first + _CHUNK)
            values[:, part] = np.einsum("npb,np->bp", weights[:, mine[part]], parts[:, other[part]])
    found[(..., *to)] = values.reshape(buckets, *lanes[to].shape)
    return found
