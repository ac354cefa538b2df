"""Which pixels have a slot in a group of theirs: what a simple plan makes of a clip's frames."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

_MOST_BYTES = 1 << 26


@dataclass(frozen=True, eq=False)
class Masks:
    """For each slot: `kinds` (N,), none, all or some pixels; `rows` (N,), which row of `planes`
    uint8 (rows, pixels) says which.
    """

    kinds: NDArray[np.int64]
    rows: NDArray[np.int64]
    planes: NDArray[np.uint8]

    SKIPPED: ClassVar[int] = 0
    EVEN: ClassVar[int] = 1
    MASKED: ClassVar[int] = 2
    TABLED: ClassVar[int] = 3
    """As the loop calls them; the last is by a table of lanes, without a mask."""

    @classmethod
    def of(cls, members: NDArray[np.bool_], lanes: NDArray[np.int32]) -> Masks | None:
        """Of the slots (N, lanes) that belong to a group; None where masks would take too much."""
        distinct, rows = np.unique(members, axis=0, return_inverse=True)
        if len(distinct) * len(lanes) > _MOST_BYTES:
            return None
        every, some = members.all(axis=1), members.any(axis=1)
        kinds = np.where(every, cls.EVEN, np.where(some, cls.MASKED, cls.SKIPPED))
        return cls(
            kinds.astype(np.int64),
            rows.reshape(-1).astype(np.int64),
            np.ascontiguousarray(distinct[:, lanes], np.uint8),
        )
