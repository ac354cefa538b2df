"""What pixels that look at the light do: a finite machine for each code, as plain tables.

Boundaries run over 0..N; boundary n comes before slot n's light. A look is a boundary at which
signals are compared with levels. Between two looks a pixel is in a node; the outcomes of a look's
comparisons lead it to a node of the next stage. A node says in which slots the shutter is open and
the photodiode is reset, until the next look. The tables are the program's meaning: proof, emulator
and host read them and never the program's text.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.int64]

LIGHT = -1
"""The signal `light`, where a bucket's number stands for its exposure."""


@dataclass(frozen=True, slots=True)
class Comparison:
    """At `boundary`, is `signal` above `level` steps of IN?

    `signal` is LIGHT, what PIX has gathered since the frame's start or its last reset, or the
    number of a bucket: the light of its completed open slots.
    """

    boundary: int
    signal: int
    level: int


@dataclass(frozen=True, slots=True)
class State:
    """A state of the program: its values are `low`..`high`, and START is `start`.

    `is_kept`: it survives the frame. `read`: it is read out with the frame. `boolean`: declared as
    bit.
    `sense`: not declared, but the latest answer of a sense that outlasts its look.
    """

    name: str
    low: int
    high: int
    start: int
    is_kept: bool = False
    read: bool = False
    boolean: bool = False
    sense: bool = False


@dataclass(frozen=True, eq=False)
class Machine:
    """The machines of all behaviours; a behaviour is what one or more codes do.

    Stage k begins after look k (stage 0 at boundary 0) and has the nodes
    first[k] .. first[k + 1] - 1. By node: `behaviour` int32 (nodes,); `values` int64 (nodes,
    states), the states' values; `opens` bool (nodes, buckets, N) and `resets` bool (nodes, N),
    whether PIX is reset at the boundary before a slot, both False outside the node's stage;
    `steps` int32 (nodes, outcomes), the node that the next look leads to: bit c of an outcome is
    the answer of the look's comparison number c, and -1 stands behind its last outcome and in the
    last stage. `comparisons` stand in the order of their boundaries. `open_us` float64 (nodes,
    buckets) and `open_slots` int32 (nodes, buckets): how long a pixel that ends the frame in a node
    was open; -1 in earlier stages.
    """

    states: tuple[State, ...]
    comparisons: tuple[Comparison, ...]
    looks: tuple[int, ...]
    first: NDArray[np.int32]
    behaviour: NDArray[np.int32]
    values: NDArray[np.int64]
    opens: NDArray[np.bool_]
    resets: NDArray[np.bool_]
    steps: NDArray[np.int32]
    open_slots: NDArray[np.int32]
    open_us: NDArray[np.float64]

    @property
    def slots(self) -> int:
        """The slots of a frame."""
        return int(self.opens.shape[2])

    @property
    def keeps(self) -> bool:
        """Whether a frame hangs on the one before it."""
        return any(state.is_kept for state in self.states)

    @property
    def stages(self) -> int:
        """One more than there are looks."""
        return len(self.first) - 1

    def nodes(self, stage: int) -> slice:
        """The nodes of a stage."""
        return slice(int(self.first[stage]), int(self.first[stage + 1]))

    def at(self, boundary: int) -> tuple[Comparison, ...]:
        """The comparisons of a boundary."""
        return tuple(
            comparison for comparison in self.comparisons if comparison.boundary == boundary
        )

    def order(self, boundary: int) -> list[int]:
        """The numbers of a boundary's comparisons in the order in which words make them. Where two
        signals are the same light, as PIX and a bucket that is not closed yet, it alone tells
        which of them a word compares."""
        comparisons = self.at(boundary)
        return sorted(range(len(comparisons)), key=lambda number: -comparisons[number].signal)

    def starts(self, stage: int) -> int:
        """The boundary at which a stage begins."""
        return 0 if stage == 0 else self.looks[stage - 1]

    def ends(self, stage: int) -> int:
        """The boundary of the look that ends a stage; N for the last one."""
        return self.looks[stage] if stage < len(self.looks) else self.slots

    def start_nodes(self) -> NDArray[np.int64]:
        """For each behaviour the node with the START of every state (behaviours,)."""
        nodes = np.arange(self.first[1])
        starts = np.array([state.start for state in self.states], np.int64)
        chosen = nodes[(self.values[: self.first[1]] == starts).all(axis=1)]
        order = np.argsort(self.behaviour[chosen], kind="stable")
        return np.asarray(chosen[order], np.int64)


@dataclass(frozen=True, eq=False)
class StatePlanes:
    """How `registers` hold a state: `bits` bool (values, registers) of each of the `values` that
    it can have."""

    registers: tuple[str, ...]
    values: tuple[int, ...]
    bits: NDArray[np.bool_]

    def read(self, planes: Mapping[str, NDArray[np.bool_]], shape: tuple[int, ...]) -> Values:
        """The value at every pixel of `shape`; where the bits are those of none, the first one."""
        pixel_values = np.full(shape, self.values[0], np.int64)
        for value, row in zip(self.values, self.bits.tolist(), strict=True):
            matches = np.ones(shape, np.bool_)
            for register, bit in zip(self.registers, row, strict=True):
                matches &= planes[register] == bit
            pixel_values[matches] = value
        return pixel_values
