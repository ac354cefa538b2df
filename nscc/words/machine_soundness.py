"""Consistency checks of a container's state machine."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from nscc.words.container import Container
from nscc.words.machine import LIGHT, StateMachine
from nscc.words.stored_arrays import array_faults


def faults(container: Container) -> Iterator[str]:
    """Yield the errors of a container's state machine, each as the end of a sentence about the
    container (a compiled program); nothing if it is sound.

    A program without senses must not set IN (the level sent to all pixels). If stages or arrays
    have wrong sizes, nothing else is checked."""
    machine = container.machine
    if not machine.stages:
        if any(launch.level is not None for launch in container.launches):
            yield "a launch sets IN, but no comparison uses it"
        return
    target, nodes = container.target, int(machine.first[-1])
    buckets, slots = len(container.buckets), container.slots
    rising = bool((np.diff(machine.first) > 0).all()) and machine.first[0] == 0
    # There is one look between two stages, and `first` also has the number of nodes.
    if not rising or len(machine.looks) != len(machine.first) - 2:
        yield "the stages of its machine are out of order"
        return
    if list(machine.looks) != sorted({*machine.looks}) or not all(
        1 <= n <= slots for n in machine.looks
    ):
        yield "the looks of its machine are out of order"
    sizes = {
        "nodes": nodes,
        "states": len(machine.states),
        "buckets": buckets,
        "slots": slots,
        "outcomes": machine.steps.shape[-1],
    }
    if wrong := list(array_faults(machine, sizes)):
        yield f"its machine's {wrong[0]}"
        return
    # Sums of lengths may be rounded up.
    shortest_us, frame_us = min(container.slot_us), sum(container.slot_us) * (1 + 1e-9)
    # An open time is -1 (not known), 0, or a sum of slots.
    is_sum = (machine.open_us >= shortest_us) & (machine.open_us <= frame_us)
    if not (is_sum | np.isin(machine.open_us, (-1.0, 0.0))).all():
        yield "the open times of its machine are invalid"
    for stage in range(machine.stages):
        span = machine.nodes(stage)
        steps = machine.steps[span]
        if stage == machine.stages - 1:
            if (steps != -1).any():
                yield "a node of the last stage of its machine has a successor"
            continue
        outcomes = 1 << len(machine.at(machine.looks[stage]))
        after = machine.nodes(stage + 1)
        inside = steps[:, :outcomes]
        if outcomes > steps.shape[1] or (steps[:, outcomes:] != -1).any():
            yield "its machine has other outcomes than comparisons"
        elif ((inside < after.start) | (inside >= after.stop)).any():
            yield "a node of its machine leads out of the next stage"
        elif (machine.behaviour[inside] != machine.behaviour[span][:, None]).any():
            yield "a node of its machine leads to another behaviour"
    for comparison in machine.comparisons:
        if comparison.boundary not in machine.looks:
            yield f"a comparison at boundary {comparison.boundary}, which is not a look"
        if not (LIGHT <= comparison.signal < buckets):
            yield f"a comparison of signal {comparison.signal}"
        if not target.in_low <= comparison.level <= target.in_high:
            yield f"a comparison with {comparison.level} steps of IN"
    behaviours = len(container.encoding)
    if {*machine.behaviour.tolist()} != {*range(behaviours)}:
        yield "its machine has other behaviours than its encoding"
    yield from _state_faults(container, machine)
    for launch in container.launches:
        if launch.level is not None and not target.in_low <= launch.level <= target.in_high:
            yield f"a launch sets IN to {launch.level} steps"


def _state_faults(container: Container, machine: StateMachine) -> Iterator[str]:
    """Yield the errors of the states of `machine`: their names, ranges, and the registers of the
    container (a compiled program) that hold their bits.

    Each is the end of a sentence about the container."""
    names = [state.name for state in machine.states]
    if len({*names}) != len(names):
        yield "two states of its machine have one name"
    for k, state in enumerate(machine.states):
        values = machine.values[:, k]
        if not state.low <= state.start <= state.high or (
            values.size and not (state.low <= values.min() and values.max() <= state.high)
        ):
            yield f"the state {state.name[:40]!a} leaves its range"
        planes = container.state_planes.get(state.name)
        if (state.read or state.is_kept) != (planes is not None):
            yield f"the state {state.name[:40]!a} has planes, or lacks them"
        elif planes is not None and not {*values.tolist()} <= {*planes.values}:
            yield f"the planes of {state.name[:40]!a} have no bits for some of its values"
        elif planes and state.is_kept and not {*planes.registers} <= {*container.code_registers}:
            yield f"the planes of {state.name[:40]!a} are kept and not loaded"
    registers = container.target.digital_registers
    for name, planes in container.state_planes.items():
        if len({*planes.values}) < len(planes.values):
            yield f"the planes of {name[:40]!a} have two rows of bits for one value"
        if name not in names or not {*planes.registers} <= {*registers}:
            yield f"the planes of {name[:40]!a} belong to no state"
    # Code k of the encoding belongs to behaviour k, so each behaviour needs exactly one start.
    starts = machine.behaviour[machine.start_nodes()]
    if not np.array_equal(starts, np.arange(len(container.encoding))):
        yield "a behaviour of its machine has no start"
