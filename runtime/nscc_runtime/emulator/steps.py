"""Translate words into the emulator's steps: every kernel is decoded once, into rows of integers.

A word is one to a few steps, each of which writes one place: a plane (a one-bit register of all
pixels) or a row (an analog register of all pixels). A word's sources are read before any
destination is written, so a word with several destinations uses the bus plane or the sum row.
`nscc.operations` defines the words; this file only chooses the steps that
`nscc_runtime.emulator.loops` executes."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Op, Phase, WordEffect
from nscc.words.legality import decoded

if TYPE_CHECKING:
    from nscc.chips.target import Target
    from nscc.words.container import Container


class Step(IntEnum):
    """The operation of a step, which is its first column. The second column is the written place
    `out`; the members describe the other columns in order."""

    COMBINE = 0
    """(first, count, inverted): plane := OR of the planes operands[first : first + count]."""
    STORE = 1
    """(plane, mask): plane := the other plane, where the mask plane is 1."""
    BUS2 = 2
    """(a, b): row := -(a + b) where FLAG = 1."""
    DIVIDE = 3
    """(a, divisor): row := a / divisor where FLAG = 1."""
    COPY = 4
    """(a): row := a in every pixel."""
    COMPARE = 5
    """(first, count): FLAG := the sum of the rows operands[first : first + count] > 0."""
    COMPARE_MASKED = 6
    """(first, count): like COMPARE, but FLAG stays 0 where it was 0."""
    BUS = 7
    """(first, count): row := -(sum of the rows operands[first : first + count]) where FLAG = 1."""


COLUMNS = 5


@dataclass(frozen=True)
class Layout:
    """The numbers of planes and rows, by name.

    Planes: the target's digital registers, then FLAG, the bus of half-word pairs, and a plane of
    zeros (SELECT: no address ever matches). Rows: the analog registers, then PIX, the reset level,
    the sum of a word with several destinations, a row of zeros (IN: the global DAC is at 0), and
    the light that is being added to PIX."""

    planes: dict[str, int]
    rows: dict[str, int]

    @classmethod
    def of(cls, target: Target) -> Layout:
        planes = (*target.digital_registers, "FLAG", "bus", "SELECT")
        rows = (*target.analog_registers, "PIX", "reset", "sum", "IN", "light")
        return cls(
            {name: i for i, name in enumerate(planes)}, {name: i for i, name in enumerate(rows)}
        )


@dataclass(frozen=True, eq=False)
class Steps:
    """A container's kernels and schedule for the compiled loops.

    `steps` int64 (steps, COLUMNS): kernel k is steps[kernel_start[k] : kernel_start[k + 1]].
    Boundary n launches launch_kernel[launch_start[n] : launch_start[n + 1]], in that order.
    `used_rows`: 1 for each row that words use, else 0."""

    steps: NDArray[np.int64]
    operands: NDArray[np.int64]
    kernel_start: NDArray[np.int64]
    launch_start: NDArray[np.int64]
    launch_kernel: NDArray[np.int64]
    used_rows: NDArray[np.int64]


def steps_of(container: Container, layout: Layout) -> Steps:
    """Decode every kernel and sort the launches by boundary. Raises Rejected like
    `nscc.words.legality.decoded`. The schedule must be sound (`nscc.words.soundness`)."""
    translator = _Translator(container.target, layout)
    rows: list[tuple[int, ...]] = []
    kernel_start = [0]
    used = {"PIX", "reset", *(readout.register for readout in container.readouts)}
    for kernel in decoded(container):
        used |= {name for op in kernel for name in (*op.sources, *op.destinations)}
        first = len(rows)
        for op in kernel:
            for step in translator.steps(op):
                # No step reads its own result, so repeating a step changes nothing.
                if len(rows) == first or rows[-1] != step:
                    rows.append(step)
        kernel_start.append(len(rows))
    instants = np.array([launch.instant for launch in container.launches], np.int64)
    kernels = np.array([launch.kernel for launch in container.launches], np.int64)
    boundaries = container.slots + 1
    launch_start = np.zeros(boundaries + 1, np.int64)
    np.cumsum(np.bincount(instants, minlength=boundaries), out=launch_start[1:])
    return Steps(
        steps=np.array(rows, np.int64).reshape(len(rows), COLUMNS),
        operands=np.array(translator.operands, np.int64),
        kernel_start=np.array(kernel_start, np.int64),
        launch_start=launch_start,
        launch_kernel=kernels[np.argsort(instants, kind="stable")],
        used_rows=np.array([name in used for name in layout.rows], np.int64),
    )


class _Translator:
    """Translates operations into steps, each distinct operation once, and collects operands."""

    def __init__(self, target: Target, layout: Layout) -> None:
        self.target = target
        self.layout = layout
        self.operands: list[int] = []
        self.known: dict[Op, tuple[tuple[int, ...], ...]] = {}

    def steps(self, op: Op) -> tuple[tuple[int, ...], ...]:
        """Return the steps of one word, padded to COLUMNS."""
        known_steps = self.known.get(op)
        if known_steps is None:
            translated = (tuple(int(value) for value in step) for step in self._translate(op))
            known_steps = tuple(step + (0,) * (COLUMNS - len(step)) for step in translated)
            self.known[op] = known_steps
        return known_steps

    def _translate(self, op: Op) -> list[tuple[int, ...]]:
        planes, rows = self.layout.planes, self.layout.rows
        match op.operation.effect:
            case WordEffect.NONE:
                return []
            case WordEffect.DIGITAL_NEIGHBOURS:
                raise AssertionError(f"`{op}` has no place in an exposure")
            case WordEffect.RESET_PIX:
                # "unknown" is taken as "yes": the chip that resets less.
                if self.target.reset_honours_flag == "no":
                    return [(Step.COPY, rows["PIX"], rows["reset"])]
                return [(Step.DIVIDE, rows["PIX"], rows["reset"], 1)]
            case WordEffect.BUS:
                return self._bus(op)
            case WordEffect.FLAG_ALL:
                return [self._combine("FLAG", (), inverted=True)]
            case WordEffect.FLAG_ANALOG:
                masked = self.target.where_obeys_flag
                compare = Step.COMPARE_MASKED if masked else Step.COMPARE
                return [(compare, planes["FLAG"], *self._listed(op.sources, rows))]
            case WordEffect.FLAG_DIGITAL:
                return self._digital(op, ("FLAG",))
            case WordEffect.DIGITAL:
                return self._digital(op, op.destinations)

    def _listed(self, sources: tuple[str, ...], places: dict[str, int]) -> tuple[int, int]:
        """Append the places of sources to the operands. Return their first index and number."""
        first = len(self.operands)
        self.operands.extend(places[name] for name in sources)
        return first, len(sources)

    def _bus(self, op: Op) -> list[tuple[int, ...]]:
        rows = self.layout.rows
        divisor = op.operation.divisor
        direct = divisor == 1 and len(op.destinations) == 1
        out = rows[op.destinations[0] if direct else "sum"]
        two, count = [rows[name] for name in (*op.sources, "IN", "IN")[:2]], len(op.sources)
        steps: list[tuple[int, ...]] = [
            (Step.BUS2, out, *two)
            if count <= 2
            else (Step.BUS, out, *self._listed(op.sources, rows))
        ]
        if not direct:
            steps += [(Step.DIVIDE, rows[d], rows["sum"], divisor) for d in op.destinations]
        return steps

    def _digital(self, op: Op, destinations: tuple[str, ...]) -> list[tuple[int, ...]]:
        row = op.operation
        masked, mask = self.target.masked_register, self.target.mask_register
        plain = len(destinations) == 1 and destinations[0] != masked
        if plain and row.phase is Phase.WHOLE and destinations[0] not in op.sources:
            return [self._combine(destinations[0], op.sources, inverted=row.inverted)]
        steps = []
        if row.phase is not Phase.WRITE:
            steps.append(self._combine("bus", op.sources, inverted=row.inverted))
        if row.phase is not Phase.READ:
            planes = self.layout.planes
            # The masked register first, because it uses the mask from before this word.
            for name in sorted(destinations, key=lambda name: name != masked):
                if name == masked and mask is not None:
                    steps.append((Step.STORE, planes[name], planes["bus"], planes[mask]))
                else:
                    steps.append(self._combine(name, ("bus",), inverted=False))
        return steps

    def _combine(
        self, destination: str, sources: tuple[str, ...], *, inverted: bool
    ) -> tuple[int, ...]:
        planes = self.layout.planes
        return (Step.COMBINE, planes[destination], *self._listed(sources, planes), inverted)
