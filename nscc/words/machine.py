"""The finite state machine of each code of a program with senses, as arrays.

Boundaries are 0..N; boundary n is before slot n. A look is a boundary at which signals are compared
with levels. Between two looks a pixel is in a node; the answers of a look lead to a node of the
next stage. A node defines in which slots the shutter is open and PIX is reset, until the next look.
The arrays define the program: proof, emulator and host use them instead of the program's text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

import numpy as np

from nscc.arrays import Bools, Floats, Ints, Ints32
from nscc.codec import Within
from nscc.record import Record

StateValue = Annotated[int, Within(1 - (1 << 62), (1 << 62) - 1)]
Length = Annotated[int, Within(0, (1 << 31) - 1)]
"""A number of things, or the index of one."""
OneBit = Annotated[int, Within(0, 1)]

LIGHT = -1
"""The signal `light`; other signals are indices of buckets."""


class Comparison(Record):
    """A comparison at `boundary`: is the signal above `level` steps of IN (the level sent to all
    pixels)?

    `signal` is LIGHT, the charge of PIX (the photodiode) since the start of the frame or its last
    reset, or the index of a bucket, the light of its completed open slots."""

    boundary: Length
    signal: int
    level: int


class State(Record):
    """A state of the program, with values `low`..`high` and initial value `start`.

    `is_kept` states survive the frame; `read` states are read out with the frame. `boolean` means
    that it was declared as bit. `sense` marks the latest answer of a sense (1 for yes), which was
    not declared as a state but is needed later."""

    name: str
    low: StateValue
    high: StateValue
    start: StateValue
    is_kept: bool = False
    read: bool = False
    boolean: bool = False
    sense: bool = False


class StateMachine(Record, eq=False):
    """The state machines of all behaviours; codes that behave equally share a behaviour.

    Stage k begins after look k (stage 0 at boundary 0) and has the nodes first[k] .. first[k + 1] -
    1. Arrays by node are:

    * `behaviour` int32 (nodes,)
    * `values` int64 (nodes, states), the states' values
    * `opens` bool (nodes, buckets, N), False outside the node's stage
    * `resets` bool (nodes, N), whether PIX is reset at the boundary before a slot
    * `steps` int32 (nodes, outcomes), the node after the next look: bit c of an outcome is the
      answer of the look's comparison c; -1 after the last outcome and in the last stage
    * `open_us` float64 and `open_slots` int32 (nodes, buckets), the open time of a pixel that ends
      the frame in a node; -1 in earlier stages

    `comparisons` are in the order of their boundaries.

    A program of four slots, whose pixels close before slot 2 if their light is above a quarter of a
    full well, has one behaviour and three nodes: node 0 until the look, then node 1 for the pixels
    that stay open and node 2 for those that close:

        >>> import nscc
        >>> program = nscc.compile('''nsl 2
        ... frame 4 slots of 1ms
        ... sense bright when light > 25% at n in [2]
        ... state closed : 0..1 = 0
        ... next closed = 1 when bright
        ... open when closed == 0
        ... read closed''')
        >>> machine = program.container.machine
        >>> machine.opens[:, 0].astype(int).tolist()
        [[1, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 0]]
        >>> machine.behaviour.tolist(), machine.steps[0].tolist(), machine.open_slots[:, 0].tolist()
        ([0, 0, 0], [1, 2], [-1, 4, 2])
    """

    states: tuple[State, ...]
    comparisons: tuple[Comparison, ...]
    looks: tuple[int, ...]
    first: Ints32
    behaviour: Annotated[Ints32, "nodes"]
    values: Annotated[Ints, "nodes states"]
    opens: Annotated[Bools, "nodes buckets slots"]
    resets: Annotated[Bools, "nodes slots"]
    steps: Annotated[Ints32, "nodes outcomes"]
    open_slots: Annotated[Ints32, "nodes buckets"]
    open_us: Annotated[Floats, "nodes buckets"]

    @property
    def slots(self) -> int:
        """The number of slots."""
        return int(self.opens.shape[2])

    @property
    def keeps(self) -> bool:
        """Whether a frame depends on the previous one, because a state is kept."""
        return any(state.is_kept for state in self.states)

    @property
    def stages(self) -> int:
        """The number of looks (boundaries with comparisons) plus one; 0 if shutters depend on the
        code only."""
        return len(self.first) - 1

    def nodes(self, stage: int) -> slice:
        """Return the indices of a stage's nodes (states of the machine), as a slice for the first
        axis of the arrays."""
        return slice(int(self.first[stage]), int(self.first[stage + 1]))

    def at(self, boundary: int) -> tuple[Comparison, ...]:
        """Return the comparisons at a boundary; () if there are none.

        Bit c of an outcome of this look is the answer of the comparison with index c."""
        return tuple(
            comparison for comparison in self.comparisons if comparison.boundary == boundary
        )

    def order(self, boundary: int) -> list[int]:
        """Return the indices of a boundary's comparisons in the order in which words make them.

        If two signals are the same light, such as PIX (the photodiode) and a bucket that is still
        open, only this order determines which of them a word compares."""
        comparisons = self.at(boundary)
        # Buckets come before the light since the reset, LIGHT = -1.
        return sorted(range(len(comparisons)), key=lambda number: -comparisons[number].signal)

    def starts(self, stage: int) -> int:
        """Return the first boundary of a stage: the look before it, or 0 for stage 0."""
        return 0 if stage == 0 else self.looks[stage - 1]

    def ends(self, stage: int) -> int:
        """Return the boundary of the look at the end of a stage; N for the last stage."""
        return self.looks[stage] if stage < len(self.looks) else self.slots

    def start_nodes(self) -> Ints:
        """Return for each behaviour (set of codes that act alike) the node of stage 0 in which all
        states have their start values.

        The result is int64 (behaviours,), in the order of behaviours."""
        nodes = np.arange(self.first[1])
        starts = np.array([state.start for state in self.states], np.int64)
        chosen = nodes[(self.values[: self.first[1]] == starts).all(axis=1)]
        order = np.argsort(self.behaviour[chosen], kind="stable")
        return np.asarray(chosen[order], np.int64)


NO_LOOKS = StateMachine(
    states=(),
    comparisons=(),
    looks=(),
    first=np.zeros(1, np.int32),
    behaviour=np.zeros(0, np.int32),
    values=np.zeros((0, 0), np.int64),
    opens=np.zeros((0, 0, 0), np.bool_),
    resets=np.zeros((0, 0), np.bool_),
    steps=np.zeros((0, 0), np.int32),
    open_slots=np.zeros((0, 0), np.int32),
    open_us=np.zeros((0, 0), np.float64),
)
"""The machine of a program whose shutters depend on the code only: it has no nodes."""


class StatePlanes(Record, eq=False):
    """The registers that hold a state at the end of a frame.

    Row k of `bits`, bool (values, registers), is their content for `values[k]`; columns are in the
    order of `registers`."""

    registers: tuple[str, ...]
    values: tuple[int, ...]
    bits: Bools

    def read(self, planes: Mapping[str, Bools], shape: tuple[int, ...]) -> Ints:
        """Return the value of the state at every pixel, int64 of `shape`.

        `planes` are the bits of registers by name, bool of `shape`; there may be others. Pixels
        with bits that no value has get the first value."""
        pixel_values = np.full(shape, self.values[0], np.int64)
        for value, row in zip(self.values, self.bits.tolist(), strict=True):
            matches = np.ones(shape, np.bool_)
            for register, bit in zip(self.registers, row, strict=True):
                matches &= planes[register] == bit
            pixel_values[matches] = value
        return pixel_values
