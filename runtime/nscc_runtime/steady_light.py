"""The behaviour of pixels in steady light in a frame of a program that looks, by amount of light.

Comparators are exact here and light does not change, so only the program determines the result."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc.words.machine import LIGHT, StateMachine

Values = NDArray[np.float64]
Nodes = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Courses:
    """One frame for several amounts of light.

    `wells` (lights,): the light of the whole frame in full wells. `opens` bool (lights, buckets,
    N), `resets` bool (lights, N): open slots, and slots that begin with a reset. `values` int64
    (lights, states): states at the end of the frame. `flips`: (boundary, light) of comparisons
    whose answer changes between two lights."""

    wells: Values
    opens: NDArray[np.bool_]
    resets: NDArray[np.bool_]
    values: NDArray[np.int64]
    flips: tuple[tuple[int, float], ...]


def courses(container: Container, behaviour: int, wells: Values, frame: int = 0) -> Courses:
    """Return the courses of a behaviour in frame number `frame`. Kept states have the program's
    start values in frame 0 and continue from there."""
    machine = container.machine
    assert machine is not None
    nodes = np.full(len(wells), machine.start_nodes()[behaviour])
    for _ in range(frame):
        nodes = _next_start(machine, _run_frame(container, machine, nodes, wells)[1])
    return _run_frame(container, machine, nodes, wells)[0]


def thresholds(container: Container) -> Values:
    """Return the lights (comparisons,) at which the light collected by a pixel reaches a level of a
    look, in full wells over the frame, if nothing resets the pixel."""
    machine, share = container.machine, _share(container)
    assert machine is not None
    level = container.target.electrons_per_step / container.target.full_well_e
    return np.array(
        [
            comparison.level * level / share[comparison.boundary]
            for comparison in machine.comparisons
        ]
    )


def _share(container: Container) -> Values:
    """Return the fraction of the frame that has passed at each boundary (N + 1,)."""
    ends = np.cumsum([0.0, *container.slot_us])
    return np.asarray(ends / ends[-1])


def _run_frame(
    container: Container, machine: StateMachine, nodes: Nodes, wells: Values
) -> tuple[Courses, Nodes]:
    """Return a frame that starts in these nodes, and the nodes in which it ends."""
    share, all_pixels = np.diff(_share(container)), np.arange(len(wells))
    opens = np.zeros((len(wells), *machine.opens.shape[1:]), np.bool_)
    resets = np.zeros((len(wells), machine.slots), np.bool_)
    charge, exposed = np.zeros(len(wells)), np.zeros((machine.opens.shape[1], len(wells)))
    level = container.target.electrons_per_step / container.target.full_well_e
    flips: list[tuple[int, float]] = []
    for stage in range(machine.stages):
        for slot in range(machine.starts(stage), machine.ends(stage)):
            resets[:, slot] = machine.resets[nodes, slot]
            opens[:, :, slot] = machine.opens[nodes, :, slot]
            charge = np.minimum(np.where(resets[:, slot], 0.0, charge) + wells * share[slot], 1.0)
            exposed += opens[:, :, slot].T * wells * share[slot]
        if stage + 1 == machine.stages:
            break
        outcome = np.zeros(len(wells), np.int64)
        for bit, comparison in enumerate(machine.at(machine.ends(stage))):
            signal = (
                charge
                if comparison.signal == LIGHT
                else np.minimum(exposed[comparison.signal], 1.0)
            )
            above = signal > comparison.level * level
            outcome |= above.astype(np.int64) << bit
            turned = np.flatnonzero(above[1:] != above[:-1])
            flips += [
                (comparison.boundary, float(np.sqrt(wells[k] * wells[k + 1]))) for k in turned
            ]
        nodes = machine.steps[nodes, outcome].astype(np.int64)
    return Courses(wells, opens, resets, machine.values[nodes[all_pixels]], tuple(flips)), nodes


def _next_start(machine: StateMachine, ended: Nodes) -> Nodes:
    """Return the nodes in which the next frame starts: kept states continue, others restart."""
    is_kept = np.array([state.is_kept for state in machine.states], np.bool_)
    starts = np.array([state.start for state in machine.states], np.int64)
    first = slice(0, int(machine.first[1]))
    known = np.column_stack([machine.behaviour[first], machine.values[first]])
    start_values = np.where(is_kept, machine.values[ended], starts)
    start_values = np.column_stack([machine.behaviour[ended], start_values])
    place = {tuple(row): number for number, row in enumerate(known.tolist())}
    return np.array([place[tuple(row)] for row in start_values.tolist()], np.int64)
