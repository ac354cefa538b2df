"""Bumps of any length, stored as a group and an offset for each end.

Time is divided into groups. A shutter is active in the groups that it touches; it is closed in its
first group before the offset of its start, and in its last group from the offset of its stop on.
The active groups are stored.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nscc.logic.bumps import Bumps, bumps_of
from nscc.logic.digits import Planes
from nscc.logic.problem import Machine, Problem, Solution
from nscc.logic.script_walk import Script, walk
from nscc.truth import columns


def stored_spans(problem: Problem, machine: Machine, steps: int) -> Iterator[Solution]:
    """A plane for each group: whether the shutter is active in it. The first groups may be one slot
    longer."""
    bumps = bumps_of(problem)
    for groups in range(min(machine.registers - 1, bumps.steps), 2, -1):
        # One plane a group, and two thermometers of size - 1 planes.
        size = -(-bumps.steps // groups)
        if size < 2 or groups + 2 * (size - 1) > machine.registers - 1:
            continue
        longer = bumps.steps - groups * (size - 1)
        first, start = _split(bumps.start, size, longer)
        last, stop = _split(np.maximum(bumps.stop - 1, 0), size, longer)
        active = [(first <= k) & (k <= last) & ~bumps.never for k in range(groups)]
        active_planes = columns(np.stack(active, axis=1))
        planes = [(plane, f"active in group {k}") for k, plane in enumerate(active_planes)]
        planes += _offsets(bumps, start, stop, size)
        name = f"active groups of {size} and fewer, offsets of both ends"
        yield from walk(problem, machine, Script(name, planes), steps)


def _split(
    step: NDArray[np.int64], size: int, longer: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Group and place in it; the first `longer` groups have `size` steps, the others one less."""
    border = size * longer
    late = step >= border
    beyond = np.maximum(step - border, 0)
    less = max(1, size - 1)
    return (
        np.where(late, longer + beyond // less, step // size),
        np.where(late, beyond % less, step % size),
    )


def _offsets(bumps: Bumps, start: NDArray[np.int64], last: NDArray[np.int64], size: int) -> Planes:
    """Thermometers of both ends' offsets, in the polarity that a NOR reads."""
    places = np.arange(size - 1)
    starts = columns(np.where(bumps.never, 0, start)[:, None] <= places)
    lasts = columns(np.where(bumps.never, size - 1, last)[:, None] > places)
    planes = [(p, f"start's place in its group <= {m}") for m, p in enumerate(starts)]
    return planes + [(p, f"last slot's place in its group > {m}") for m, p in enumerate(lasts)]
