"""The open time of every pixel, determined by its code and the states that are read out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from nscc.arrays import Floats
from nscc.program.machine import MOST_HISTORIES
from nscc.program.table import TooMuch
from nscc.record import Record
from nscc.words.machine import StateMachine

Times = tuple[tuple[int, float], ...]
"""For each bucket the number of open slots, and their total length in microseconds."""


class Untold(Record):
    """Why a readout does not tell how long each pixel was open.

    `bucket` is the index of the first bucket whose open time differs between pixels with the same
    code and readout. `states` are the fewest states that would determine it if they were read, too;
    () if no states would."""

    bucket: int
    states: tuple[str, ...]


def with_open_times(
    machine: StateMachine, slot_us: Sequence[float]
) -> tuple[StateMachine, Untold | None]:
    """Return the machine with the open time of every pixel at the end of the frame, and None.

    `slot_us` are the lengths of all slots in microseconds. `open_us` and `open_slots` get the time
    for the nodes of the last stage. If code and readout do not determine it, return the machine
    unchanged and an Untold. Raises TooMuch for too many different times."""
    times = _times(machine, np.array(slot_us, np.float64))
    # The nodes of the last stage: a slice, as the range of their numbers.
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


def _times(machine: StateMachine, slot_us: Floats) -> dict[int, set[Times]]:
    """Return the possible open times of every node at the end of its stage, by the node's number.
    Raises TooMuch beyond `MOST_HISTORIES` times of one node.

    A node is a state of the machine between two looks. Each time is (slots, microseconds) for all
    buckets."""
    buckets = machine.opens.shape[1]
    closed_so_far: Times = ((0, 0.0),) * buckets
    # The nodes of the first stage. Nodes are in the order of stages, so each comes before its next.
    times: dict[int, set[Times]] = {node: {closed_so_far} for node in range(int(machine.first[1]))}
    slots = machine.opens.sum(axis=2).tolist()
    us = (machine.opens @ slot_us).tolist()
    for node in range(len(machine.behaviour)):
        # Rounded because sums of decimal fractions depend on the order; slot lengths are multiples
        # of 1 ps.
        times[node] = {
            tuple(
                (n + slots[node][b], round(t + us[node][b], 6)) for b, (n, t) in enumerate(before)
            )
            for before in times[node]
        }
        for following in {step for step in machine.steps[node].tolist() if step >= 0}:
            times.setdefault(following, set()).update(times[node])
            if len(times[following]) > MOST_HISTORIES:
                count = len(times[following])
                message = f"a pixel can be open for {count} or more different times"
                raise TooMuch(message, count, MOST_HISTORIES)
    return times


def _differing(
    machine: StateMachine, last: range, times: dict[int, set[Times]], read: Sequence[int]
) -> int | None:
    """Return the first bucket whose open time the code and the states `read` do not determine, or
    None.

    `last` are the nodes (states of the machine) at the end of a frame and `times` their possible
    open times; `read` are indices of `machine.states`."""
    by_readout: dict[tuple[int, ...], set[Times]] = {}
    for node in last:
        values = machine.values[node, list(read)].tolist()
        key = (int(machine.behaviour[node]), *values)
        by_readout.setdefault(key, set()).update(times[node])
    differing = [
        bucket
        for readout_times in by_readout.values()
        if len(readout_times) > 1
        for bucket, of_bucket in enumerate(zip(*readout_times, strict=True))
        if len(set(of_bucket)) > 1
    ]
    return min(differing, default=None)


def _missing(
    machine: StateMachine, last: range, times: dict[int, set[Times]], read: Sequence[int]
) -> tuple[str, ...]:
    """Return the fewest states whose readout, added to `read`, would determine all open times.

    Sets of up to three states are tried, then all states; () if even these do not suffice. `read`
    are indices of states. `last` are the nodes at the end of the frame, and `times` their possible
    open times. Of sets of equal size, the first in the order of states is returned."""
    unread = [k for k, state in enumerate(machine.states) if not (state.read or state.sense)]
    # Larger sets would be too many to try, except the one of all states.
    choices = [added for count in (1, 2, 3) for added in combinations(unread, count)]
    for added in [*choices, tuple(unread)]:
        if _differing(machine, last, times, [*read, *added]) is None:
            return tuple(machine.states[k].name for k in added)
    return ()
