"""Storage of a state machine in a container file: header, arrays and checks."""

from __future__ import annotations

import json
from base64 import b64decode
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.assembly_text import base64_lines
from nscc.words.machine import LIGHT, Comparison, State, StateMachine, StatePlanes
from nscc.words.stored_arrays import StoredArray, packed, unpacked

if TYPE_CHECKING:
    from nscc.words.container import Container

_STATE = ("name", "low", "high", "start", "is_kept", "read", "boolean", "sense")
Read = tuple[StateMachine, dict[str, StatePlanes], list[int | None]]

NO_LEVEL = -(2**31)
"""The stored level of a launch that does not set IN."""
_LARGEST = 2**62


def header_of(machine: StateMachine, planes: Mapping[str, StatePlanes]) -> dict[str, Any]:
    """Return the JSON header of a machine."""
    return {
        "states": [[getattr(state, name) for name in _STATE] for state in machine.states],
        "comparisons": [[c.boundary, c.signal, c.level] for c in machine.comparisons],
        "first": machine.first.tolist(),
        "looks": list(machine.looks),
        "outcomes": machine.steps.shape[1],
        "planes": [
            [
                name,
                list(state_planes.registers),
                list(state_planes.values),
                state_planes.bits.astype(int).tolist(),
            ]
            for name, state_planes in planes.items()
        ],
    }


def layout_of(header: Mapping[str, Any], buckets: int, slots: int) -> list[StoredArray]:
    """Return the names, types and shapes of the machine's arrays, in file order."""
    nodes, states = header["first"][-1], len(header["states"])
    return [
        StoredArray("behaviour", "<i4", (nodes,)),
        StoredArray("values", "<i8", (nodes, states)),
        StoredArray("opens", "?", (nodes, buckets, slots)),
        StoredArray("resets", "?", (nodes, slots)),
        StoredArray("steps", "<i4", (nodes, header["outcomes"])),
        StoredArray("open_slots", "<i4", (nodes, buckets)),
        StoredArray("open_us", "<f8", (nodes, buckets)),
    ]


def machine_from(
    header: Mapping[str, Any], arrays: Mapping[str, NDArray[Any]]
) -> tuple[StateMachine, dict[str, StatePlanes]]:
    """Return the machine and the encodings of its states, from a header and its arrays.

    Raises an exception if a value does not have the type that `header_of` writes."""
    machine = StateMachine(
        states=tuple(
            State(
                str(name),
                *np.array(numbers, np.int64).tolist(),
                *map(bool, (is_kept, read, boolean, sense)),
            )
            for name, *numbers, is_kept, read, boolean, sense in header["states"]
        ),
        comparisons=tuple(Comparison(*map(int, entry)) for entry in header["comparisons"]),
        looks=tuple(map(int, header["looks"])),
        first=np.array(header["first"], np.int32),
        **{name: arrays[name] for name, _, _ in layout_of(header, 0, 0)},
    )
    planes = {
        str(name): StatePlanes(
            tuple(map(str, registers)),
            tuple(np.array(values, np.int64).tolist()),
            np.array(bits, np.bool_).reshape(len(values), len(registers)),
        )
        for name, registers, values, bits in header["planes"]
    }
    return machine, planes


def to_text(container: Container) -> list[str]:
    """Return the `.machine` lines of assembly text: base64 of the header and the arrays."""
    machine = container.machine
    assert machine is not None
    header = header_of(machine, container.state_planes)
    header["levels"] = [launch.level for launch in container.launches]
    data = json.dumps(header, sort_keys=True, separators=(",", ":")).encode("ascii")
    layout = layout_of(header, len(container.buckets), container.slots)
    blocks = [len(data).to_bytes(4, "little"), data, *packed(layout, vars(machine))]
    return base64_lines(b"".join(blocks))


def from_text(text: str, buckets: int, slots: int, launches: int) -> Read | None:
    """Return machine, state encodings and levels of launches from `.machine` lines; None if
    invalid."""
    try:
        data = b64decode(text, validate=True)
        size = int.from_bytes(data[:4], "little")
        header = json.loads(data[4 : 4 + size])
        arrays = unpacked(layout_of(header, buckets, slots), data, 4 + size)
        machine, planes = machine_from(header, arrays)
        levels = [None if level is None else int(level) for level in header["levels"]]
    except (ValueError, ArithmeticError, AttributeError, LookupError, RecursionError, TypeError):
        return None
    sound = header == {**header_of(machine, planes), "levels": levels} and len(levels) == launches
    return (machine, planes, levels) if sound else None


def faults(container: Container) -> Iterator[str]:
    """Yield the errors of a container's machine, each as part of a sentence."""
    machine = container.machine
    if machine is None:
        if any(launch.level is not None for launch in container.launches):
            yield "a launch sets IN, but no comparison uses it"
        return
    target, nodes = container.target, int(machine.first[-1])
    buckets, slots = len(container.buckets), container.slots
    rising = bool((np.diff(machine.first) > 0).all()) and machine.first[0] == 0
    if not rising or len(machine.looks) != len(machine.first) - 2:
        yield "the stages of its machine are out of order"
        return
    if list(machine.looks) != sorted({*machine.looks}) or not all(
        1 <= n <= slots for n in machine.looks
    ):
        yield "the looks of its machine are out of order"
    for name, dtype, shape in layout_of(
        {"first": [nodes], "states": machine.states, "outcomes": machine.steps.shape[-1]},
        buckets, slots,
    ):  # fmt: skip
        array = getattr(machine, name)
        if array.shape != shape or array.dtype != np.dtype(dtype):
            yield f"its machine has {name} of {array.dtype} {array.shape}"
            return
    shortest_us, frame_us = min(container.slot_us), sum(container.slot_us) * (1 + 1e-9)
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
    if not np.array_equal(np.unique(machine.behaviour), np.arange(behaviours)):
        yield "its machine has other behaviours than its encoding"
    yield from _state_faults(container, machine)
    for launch in container.launches:
        if launch.level is not None and not target.in_low <= launch.level <= target.in_high:
            yield f"a launch sets IN to {launch.level} steps"


def _state_faults(container: Container, machine: StateMachine) -> Iterator[str]:
    names = [state.name for state in machine.states]
    if len({*names}) != len(names):
        yield "two states of its machine have one name"
    for k, state in enumerate(machine.states):
        values = machine.values[:, k]
        if not -_LARGEST < state.low <= state.start <= state.high < _LARGEST or (
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
        if max(map(abs, planes.values), default=0) >= _LARGEST:
            yield f"the planes of {name[:40]!a} have values beyond 62 bits"
        if len({*planes.values}) < len(planes.values):
            yield f"the planes of {name[:40]!a} have two rows of bits for one value"
        if name not in names or not {*planes.registers} <= {*registers}:
            yield f"the planes of {name[:40]!a} belong to no state"
    starts = machine.behaviour[machine.start_nodes()]
    if not np.array_equal(starts, np.arange(len(container.encoding))):
        yield "a behaviour of its machine has no start"
