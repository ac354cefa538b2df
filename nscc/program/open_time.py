"""How long every pixel was open, as the readout tells it: from its code and the states read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from nscc.program.machine import MOST_HISTORIES
from nscc.program.table import TooMuch
from nscc.words.machine import Machine

Times = tuple[tuple[int, float], ...]
"""By bucket: open slots, and the microseconds that they last."""


@dataclass(frozen=True)
class Untold:
    """A readout that does not tell how long pixels were open.

    `bucket` is the first whose time differs between pixels of one code and readout. `states` are
    the fewest to `read` beside those that are, that would tell it: () if no state does.
    """

    bucket: int
    states: tuple[str, ...]


def with_open_times(machine: Machine, slot_us: Sequence[float]) -> tuple[Machine, Untold | None]:
    """The machine with `open_us` and `open_slots`; or what the readout does not tell.

    Raises TooMuch where there are too many different times to count.
    """
    times = _times(machine, np.array(slot_us, np.float64))
    last = range(*machine.nodes(machine.stages - 1).indices(len(machine.behaviour)))
    read = [k for k, state in enumerate(machine.states) if state.read]
    bucket = _differing(machine, last, times, read)
    if bucket is not None:
        return machine, Untold(bucket, _missing(machine, last, times, read))
    open_slots, open_us = machine.open_slots.copy(), machine.open_us.copy()
    for node in last:
        for bucket, (slots, us) in enumerate(next(iter(times[node]))):
            open_slots[node, bucket], open_us[node, bucket] = slots, us
    return replace(machine, open_slots=open_slots, open_us=open_us), None


def _times(machine: Machine, slot_us: NDArray[np.float64]) -> dict[int, set[Times]]:
    """By node the times that a pixel can have been open when its stage ends."""
    buckets = machine.opens.shape[1]
    none: Times = ((0, 0.0),) * buckets
    found: dict[int, set[Times]] = {node: {none} for node in range(int(machine.first[1]))}
    slots = machine.opens.sum(axis=2).tolist()
    us = (machine.opens @ slot_us).tolist()
    for node in range(len(machine.behaviour)):
        # Sums of decimal fractions in another order: the picosecond is beyond a slot's own figures.
        found[node] = {
            tuple(
                (n + slots[node][b], round(t + us[node][b], 6)) for b, (n, t) in enumerate(before)
            )
            for before in found[node]
        }
        for following in {step for step in machine.steps[node].tolist() if step >= 0}:
            found.setdefault(following, set()).update(found[node])
            if len(found[following]) > MOST_HISTORIES:
                count = len(found[following])
                message = f"a pixel can be open for {count} or more different times"
                raise TooMuch(message, count, MOST_HISTORIES)
    return found


def _differing(
    machine: Machine, last: range, times: dict[int, set[Times]], read: Sequence[int]
) -> int | None:
    """The first bucket whose time code and these states do not tell; None if they tell all."""
    by_readout: dict[tuple[int, ...], set[Times]] = {}
    for node in last:
        values = machine.values[node, list(read)].tolist()
        key = (int(machine.behaviour[node]), *values)
        by_readout.setdefault(key, set()).update(times[node])
    differing = [
        bucket
        for each in by_readout.values()
        if len(each) > 1
        for bucket, of_bucket in enumerate(zip(*each, strict=True))
        if len(set(of_bucket)) > 1
    ]
    return min(differing, default=None)


def _missing(
    machine: Machine, last: range, times: dict[int, set[Times]], read: Sequence[int]
) -> tuple[str, ...]:
    others = [k for k, state in enumerate(machine.states) if not (state.read or state.sense)]
    for more in _choices(others):
        if _differing(machine, last, times, [*read, *more]) is None:
            return tuple(machine.states[k].name for k in more)
    return ()


def _choices(states: Sequence[int]) -> Iterator[tuple[int, ...]]:
    for count in range(1, min(len(states), 3) + 1):
        yield from combinations(states, count)
    if len(states) > 3:
        yield tuple(states)
