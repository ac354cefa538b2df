"""A state machine as it is stored: a record of JSON values, and arrays.

A container file has both in its header and its arrays. Assembly text has them in one block."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from nscc.arrays import Array
from nscc.codec import LATER, from_json, to_json
from nscc.record import Record
from nscc.words.container import Container, Launch
from nscc.words.machine import (
    Comparison,
    Length,
    OneBit,
    State,
    StateMachine,
    StatePlanes,
    StateValue,
)
from nscc.words.stored_arrays import StoredArray, layout_of, packed, unpacked


class StoredPlanes(Record):
    """The registers of a state, and the bits of each of its values.

    Row k of `bits` belongs to `values[k]`, and has a bit for each of `registers`."""

    state: str
    registers: tuple[str, ...]
    values: tuple[StateValue, ...]
    bits: tuple[tuple[OneBit, ...], ...]


@dataclass(frozen=True)
class StoredMachine:
    """The parts of a state machine that are not arrays, as they are written to JSON.

    `first` are the first nodes of the stages and, last, the number of nodes. `outcomes` is the
    largest number of outcomes of a look. In assembly text, `levels` are the values of IN (the level
    sent to all pixels) of all launches (starts of kernels). A kernel is a list of words."""

    states: tuple[State, ...]
    comparisons: tuple[Comparison, ...]
    first: tuple[Length, ...]
    looks: tuple[Length, ...]
    outcomes: Length
    planes: tuple[StoredPlanes, ...]
    levels: Annotated[tuple[int | None, ...] | None, LATER] = None

    def layout(self, bucket_count: int, slots: int) -> list[StoredArray]:
        """Return the names, types and shapes of the machine's arrays, in file order.

        `bucket_count` and `slots` are the program's numbers of these. Raises ValueError if there
        are no stages."""
        if not self.first:
            raise ValueError("its machine has no nodes")
        sizes = {
            "nodes": self.first[-1],
            "states": len(self.states),
            "outcomes": self.outcomes,
            "buckets": bucket_count,
            "slots": slots,
        }
        return layout_of(StateMachine, sizes)

    def machine(self, arrays: Mapping[str, Array]) -> StateMachine:
        """Return the state machine with the arrays `arrays`, which are given by name; others are
        ignored.

        Raises KeyError if one is missing."""
        # The first four fields are not arrays by node.
        by_node = (arrays[name] for name in StateMachine.field_names[4:])
        first = np.array(self.first, np.int32)
        return StateMachine(self.states, self.comparisons, self.looks, first, *by_node)

    def state_planes(self) -> dict[str, StatePlanes]:
        """Return the registers of the states, by the state's name.

        Raises ValueError unless each state has as many bits as values times registers."""
        return {
            planes.state: StatePlanes(
                planes.registers,
                planes.values,
                np.array(planes.bits, np.bool_).reshape(len(planes.values), len(planes.registers)),
            )
            for planes in self.planes
        }


def stored_machine(machine: StateMachine, planes: Mapping[str, StatePlanes]) -> StoredMachine:
    """Return the parts of a state machine that are not arrays, without levels of IN (the level sent
    to all pixels); `planes` are the registers of its states by name."""
    return StoredMachine(
        machine.states,
        machine.comparisons,
        first=tuple(machine.first.tolist()),
        looks=machine.looks,
        outcomes=machine.steps.shape[1],
        planes=tuple(
            StoredPlanes(name, row.registers, row.values, tuple(row.bits.astype(int).tolist()))
            for name, row in planes.items()
        ),
    )


def machine_data(container: Container) -> bytes:
    """Return the data of `.machine` in assembly text: the length of the record (4 bytes, little
    endian), the record as JSON, then the arrays.

    The record also has the values of IN (the level sent to all pixels) of all launches (starts of
    kernels). The container (a compiled program) must have a state machine; ValueError is raised
    otherwise. A kernel is a list of words."""
    levels = tuple(launch.level for launch in container.launches)
    record = replace(stored_machine(container.machine, container.state_planes), levels=levels)
    text = to_json(record).encode("ascii")
    layout = record.layout(len(container.buckets), container.slots)
    arrays = packed(layout, vars(container.machine))
    return b"".join([len(text).to_bytes(4, "little"), text, *arrays])


def with_machine_data(container: Container, data: bytes) -> Container:
    """Return a container (a compiled program) with the state machine and the values of IN (the
    level sent to all pixels) that `data` contain.

    Raises ValueError for damaged data, and for data that `machine_data` does not return for a
    machine of this program."""
    end = 4 + int.from_bytes(data[:4], "little")
    record = from_json(StoredMachine, data[4:end])
    arrays = unpacked(record.layout(len(container.buckets), container.slots), data, end)
    if record.levels is None or len(record.levels) != len(container.launches):
        raise ValueError("its levels of IN are not those of the launches")
    read = replace(
        container,
        launches=tuple(
            Launch(launch.instant, launch.kernel, level)
            for launch, level in zip(container.launches, record.levels, strict=True)
        ),
        machine=record.machine(arrays),
        state_planes=record.state_planes(),
    )
    if machine_data(read) != data:
        raise ValueError("its encoding differs from the one that nscc writes")
    return read
