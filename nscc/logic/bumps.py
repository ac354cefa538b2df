"""Recognition of bumps (shutters that open and close once) in the level demands of one bucket."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nscc.logic.problem import GaveUp, Problem
from nscc.record import Record
from nscc.truth import rows


class Bumps(Record):
    """Bumps: shutter k is open in steps start[k] .. stop[k] - 1.

    A shutter that never opens has start[k] = stop[k] = 0. Both arrays are (shutters,) in 0 ..
    steps. Demand i belongs to step `step[i]`; consecutive demands with equal predicates belong to
    the same step."""

    start: NDArray[np.int64]
    stop: NDArray[np.int64]
    step: tuple[int, ...]
    steps: int

    def groups(self, size: int = 1) -> list[tuple[int, int]]:
        """Return (group, demand) for every group of `size` steps, with the first demand of the
        group."""
        first: dict[int, int] = {}
        for demand, step in enumerate(self.step):
            first.setdefault(step // size, demand)
        return list(first.items())

    @property
    def length(self) -> int:
        """The number of steps of the longest bump."""
        return int((self.stop - self.start).max(initial=0))

    @property
    def never(self) -> NDArray[np.bool_]:
        """Whether each shutter never opens, (shutters,)."""
        return np.asarray(self.start == self.stop)


# Limit on shutters times demands, as a matrix of bytes: 32 MB.
_MOST_CELLS = 1 << 25


def bumps_of(problem: Problem) -> Bumps:
    """Return the bumps of a problem; raise GaveUp if some shutter is not a bump."""
    if len({(d.edge, d.bucket) for d in problem.demands}) != 1:
        raise GaveUp("demands of several kinds")
    if problem.demands[0].edge != "open":
        raise GaveUp("the demands are events")
    if problem.shutters * len(problem.demands) > _MOST_CELLS:
        raise GaveUp("too many shutters and demands to look at")
    predicates: list[int] = []
    step: list[int] = []
    for demand in problem.demands:
        if not predicates or demand.predicate != predicates[-1]:
            predicates.append(demand.predicate)
        step.append(len(predicates) - 1)
    open_in_step = rows(predicates, problem.shutters)
    start = open_in_step.argmax(axis=1).astype(np.int64)
    count = open_in_step.sum(axis=1).astype(np.int64)
    stop = start + count
    # argmax of booleans is the first 1. A row is one bump if its number of 1s equals the distance
    # of its ends.
    last = open_in_step.shape[1] - open_in_step[:, ::-1].argmax(axis=1)
    if np.any((count > 0) & (last != stop)):
        raise GaveUp("some shutter opens more than once")
    start[count == 0] = 0
    stop[count == 0] = 0
    return Bumps(start, stop, tuple(step), len(predicates))


def two_ended(problem: Problem) -> Bumps:
    """Return the bumps of a problem.

    Raises GaveUp if some shutter is not a bump, or if one end of all bumps determines the other."""
    bumps = bumps_of(problem)
    start, stop = bumps.start[~bumps.never], bumps.stop[~bumps.never]
    # The end of the frame may cut bumps of one length.
    cut = stop == bumps.steps
    if any(np.all(values == values[:1]) for values in (start, stop, (stop - start)[~cut])):
        raise GaveUp("one end of each bump follows from the other")
    return bumps
