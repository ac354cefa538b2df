"""Storage of a state machine in a container file: header, arrays and checks."""

from __future__ import annotations

import json
from base64 import b64decode, b64encode
from collections.abc import Iterator, Mapping
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.machine import LIGHT, Comparison, State, StateMachine, StatePlanes

if TYPE_CHECKING:
    from nscc.words.container import Container

_STATE = ("name", "low", "high", "start", "is_kept", "read", "boolean", "sense")
Read = tuple[StateMachine, dict[str, StatePlanes], list[int | None]]

NO_LEVEL = -(2**31)
"""The stored level of a launch that does not set IN."""
_LARGEST = 2**62
_WIDTH = 96


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


def layout_of(
    header: Mapping[str, Any], buckets: int, slots: int
) -> list[tuple[str, str, tuple[int, ...]]]:
    """Return the machine's arrays in order: name, type and shape; "?" is bit-packed."""
    nodes, states = header["first"][-1], len(header["states"])
    return [
        ("behaviour", "<i4", (nodes,)),
        ("values", "<i8", (nodes, states)),
        ("opens", "?", (nodes, buckets, slots)),
        ("resets", "?", (nodes, slots)),
        ("steps", "<i4", (nodes, header["outcomes"])),
        ("open_slots", "<i4", (nodes, buckets)),
        ("open_us", "<f8", (nodes, buckets)),
    ]


def check_header(header: Any) -> None:
    """Check the structure of a machine's header; raise ValueError if it is invalid."""
    complete = isinstance(header, dict) and header.keys() == {
        "states", "comparisons", "first", "looks", "outcomes", "planes",
    }  # fmt: skip
    if not complete or not all(isinstance(header[k], list) for k in header if k != "outcomes"):
        raise ValueError("the header's machine is malformed")
    kinds = (str, int, int, int, bool, bool, bool, bool)
    sound = all(_typed(state, kinds) for state in header["states"])
    sound &= all(_typed(entry, (int, int, int)) for entry in header["comparisons"])
    numbers = [*header["first"], *header["looks"], header["outcomes"]]
    sound &= all(_is_count(entry) for entry in numbers) and bool(header["first"])
    for plane in header["planes"]:
        sound &= _typed(plane, (str, list, list, list))
        sound &= sound and all(isinstance(r, str) for r in plane[1])
        sound &= sound and all(_is_whole(v) for v in plane[2])
        sound &= sound and all(
            isinstance(row, list)
            and len(row) == len(plane[1])
            and all(type(bit) is int and bit in (0, 1) for bit in row)
            for row in plane[3]
        )
        sound &= sound and len(plane[2]) == len(plane[3]) > 0
    if not sound:
        raise ValueError("the header's machine is malformed")


def _typed(values: Any, kinds: tuple[type, ...]) -> bool:
    return (
        isinstance(values, list)
        and len(values) == len(kinds)
        and all(
            type(v) is kind and (kind is not int or _is_whole(v))
            for v, kind in zip(values, kinds, strict=True)
        )
    )


def _is_whole(value: Any) -> bool:
    return type(value) is int and abs(value) < _LARGEST


def _is_count(value: Any) -> bool:
    return type(value) is int and 0 <= value < 2**31


def machine_from(
    header: Mapping[str, Any], arrays: Mapping[str, NDArray[Any]]
) -> tuple[StateMachine, dict[str, StatePlanes]]:
    """Return the machine and the encodings of its states, from a checked header and its arrays."""
    machine = StateMachine(
        states=tuple(State(*state) for state in header["states"]),
        comparisons=tuple(Comparison(*entry) for entry in header["comparisons"]),
        looks=tuple(header["looks"]),
        first=np.array(header["first"], np.int32),
        **{name: arrays[name] for name, _, _ in layout_of(header, 0, 0)},
    )
    planes = {
        name: StatePlanes(
            tuple(registers),
            tuple(values),
            np.array(bits, np.bool_).reshape(len(values), len(registers)),
        )
        for name, registers, values, bits in header["planes"]
    }
    return machine, planes


def to_text(container: Container) -> Iterator[str]:
    """Yield the `.machine` lines of assembly text: base64 of the header and the arrays."""
    machine = container.machine
    assert machine is not None
    header = {**header_of(machine, container.state_planes), "levels": _levels(container)}
    data = json.dumps(header, sort_keys=True, separators=(",", ":")).encode("ascii")
    buckets, slots = len(container.buckets), container.slots
    blocks = [len(data).to_bytes(4, "little"), data]
    for name, dtype, _ in layout_of(header, buckets, slots):
        array = getattr(machine, name)
        packed = np.packbits(array, axis=None, bitorder="little") if dtype == "?" else array
        blocks.append(packed.astype(packed.dtype.newbyteorder("<")).tobytes())
    text = b64encode(b"".join(blocks)).decode("ascii")
    for start in range(0, len(text), _WIDTH):
        yield text[start : start + _WIDTH]


def _levels(container: Container) -> list[int | None]:
    return [launch.level for launch in container.launches]


def from_text(text: str, buckets: int, slots: int, launches: int) -> Read | None:
    """Return machine, state encodings and levels of launches from `.machine` lines; None if
    invalid."""
    try:
        data = b64decode(text, validate=True)
        size = int.from_bytes(data[:4], "little")
        header = json.loads(data[4 : 4 + size])
        levels = header.pop("levels")
        check_header(header)
        if not isinstance(levels, list) or len(levels) != launches:
            return None
        if not all(level is None or _is_whole(level) for level in levels):
            return None
        arrays, at = {}, 4 + size
        for name, dtype, shape in layout_of(header, buckets, slots):
            items = prod(shape)
            count = (items + 7) // 8 if dtype == "?" else items * np.dtype(dtype).itemsize
            raw = np.frombuffer(data, np.uint8, count, at)
            at += count
            if dtype == "?":
                arrays[name] = np.unpackbits(raw, count=items, bitorder="little").view(np.bool_)
            else:
                arrays[name] = raw.view(dtype).astype(np.dtype(dtype).newbyteorder("="))
            arrays[name] = arrays[name].reshape(shape)
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return None
    return (*machine_from(header, arrays), levels) if at == len(data) else None


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
    yield from _step_faults(machine)
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


def _step_faults(machine: StateMachine) -> Iterator[str]:
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


def _state_faults(container: Container, machine: StateMachine) -> Iterator[str]:
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
    starts = machine.behaviour[machine.start_nodes()]
    if not np.array_equal(starts, np.arange(len(container.encoding))):
        yield "a behaviour of its machine has no start"
