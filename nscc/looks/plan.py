"""What must happen at each boundary of a program that looks, pixel by pixel, before any gate.

PIX is never reset but where the program says so: `light` is the charge since then. A shutter that
closes adds PIX - reset level to its bucket, one that opens subtracts it; a bucket that has been
open since the frame began and is still empty takes the difference as a copy, which needs no word
to read the bucket.

What a boundary asks is said over its lanes. A lane is a node that a pixel can be in before the
boundary, with one outcome of the boundary's comparisons.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from nscc.lower.plan import Misfit, analog_registers
from nscc.operations import Op, op
from nscc.program.program import Program
from nscc.truth import vector
from nscc.words.machine import Comparison, Machine

Nodes = NDArray[np.intp]
Bits = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Moment:
    """One boundary at which something happens.

    `before` and `after` (lanes,) are the nodes of each lane, `outcomes` (lanes,) what it found.
    The rest are truth vectors over the lanes: by bucket, whose shutter closes (`falls`; `copies`:
    the bucket may take a copy) and opens (`rises`), and whose PIX is reset in between.
    """

    boundary: int
    comparisons: tuple[Comparison, ...]
    before: Nodes
    after: Nodes
    outcomes: Nodes
    falls: tuple[int, ...]
    copies: tuple[bool, ...]
    resets: int
    rises: tuple[int, ...]

    @property
    def everything(self) -> int:
        """The truth vector of all lanes."""
        return (1 << len(self.before)) - 1

    def below(self, comparison: int) -> int:
        """The lanes whose signal is not above the level of a comparison."""
        return vector(np.flatnonzero(self.outcomes >> comparison & 1 == 0))


@dataclass(frozen=True, eq=False)
class LookingPlan:
    """The moments of a frame in their order, and who holds which analog register.

    `reference` holds the reset level, or its negative where every exposure is one copy: each word
    has an error of its own, and the negative takes one word less.
    """

    program: Program
    machine: Machine
    moments: tuple[Moment, ...]
    registers: dict[str, str]
    bucket_registers: tuple[str, ...]
    reference: str
    scratch: str

    @cached_property
    def latches(self) -> bool:
        """Whether every shutter that closes copies, and none opens after the frame has begun."""
        falls = (
            each
            for moment in self.moments
            for each in zip(moment.falls, moment.copies, strict=True)
        )
        rises = chain.from_iterable(moment.rises for moment in self.moments)
        return all(copy or not fall for fall, copy in falls) and not any(rises)

    def sampled(self, *held: str) -> Op:
        """Brings -(what is held + PIX) into scratch; the reset level is taken off as well if its
        negative is at hand."""
        level = (self.reference,) if self.latches else ()
        return op("bus", (self.scratch,), (*held, "PIX", *level))

    def kept(self, register: str) -> Op:
        """Brings -what is held into scratch, as `sampled` does of a PIX without light."""
        level = () if self.latches else (self.reference,)
        return op("bus", (self.scratch,), (register, *level))

    @property
    def scratched(self) -> tuple[str, ...]:
        """What adds up to -signal once either has run."""
        return (self.scratch,) if self.latches else (self.scratch, self.reference)


def plan_looks(program: Program, machine: Machine) -> LookingPlan | Misfit:
    """The plan of a program, or the analog registers that it lacks."""
    analog = analog_registers(program, "edges", reference=True)
    if isinstance(analog, Misfit):
        return analog
    assert analog.reference is not None
    return LookingPlan(
        program, machine, tuple(_moments(machine)), analog.holders, analog.buckets,
        analog.reference, analog.scratch,
    )  # fmt: skip


def _moments(machine: Machine) -> Iterator[Moment]:
    """Every boundary at which pixels compare, open, close or are reset."""
    fresh = _fresh(machine)
    for stage in range(machine.stages):
        span = machine.nodes(stage)
        nodes = np.arange(span.start, span.stop)
        begin, end = machine.starts(stage), machine.ends(stage)
        # Most slots are like the one before them in every node.
        opens, resets = machine.opens[span], machine.resets[span]
        changes = (opens[:, :, 1:] != opens[:, :, :-1]).any(axis=(0, 1)) | resets[:, 1:].any(axis=0)
        for boundary in (np.flatnonzero(changes) + 1).tolist():
            if begin < boundary < end:
                yield _moment(machine, fresh, boundary, (), nodes, nodes)
        if stage + 1 < machine.stages:
            asked = machine.at(end)
            outcomes = 1 << len(asked)
            before = np.repeat(nodes, outcomes)
            outcome = np.tile(np.arange(outcomes), len(nodes))
            after = machine.steps[before, outcome].astype(np.intp)
            yield _moment(machine, fresh, end, asked, before, after, outcome)
        elif begin < end:
            yield _moment(machine, fresh, end, (), nodes, nodes)


def _moment(
    machine: Machine,
    fresh: Bits,
    boundary: int,
    comparisons: tuple[Comparison, ...],
    before: Nodes,
    after: Nodes,
    outcomes: Nodes | None = None,
) -> Moment:
    buckets = machine.opens.shape[1]
    was = machine.opens[before, :, boundary - 1]
    inside = boundary < machine.slots
    becomes = machine.opens[after, :, boundary] if inside else np.zeros_like(was)
    resets = machine.resets[after, boundary] if inside else np.zeros(len(after), np.bool_)
    falls = was & (~becomes | resets[:, None])
    rises = becomes & ~was & ~resets[:, None]
    copies = [bool(fresh[before[falls[:, b]], b].all()) for b in range(buckets)]
    return Moment(
        boundary,
        comparisons,
        before,
        after,
        np.zeros(len(before), np.intp) if outcomes is None else outcomes,
        tuple(vector(np.flatnonzero(falls[:, b])) for b in range(buckets)),
        tuple(copies),
        vector(np.flatnonzero(resets)),
        tuple(vector(np.flatnonzero(rises[:, b])) for b in range(buckets)),
    )


def _fresh(machine: Machine) -> Bits:
    """By node and bucket: whether a shutter that is open at the end of the node's stage has been
    open ever since the frame began, without a reset, however the pixel came there."""
    nodes, buckets = len(machine.behaviour), machine.opens.shape[1]
    fresh = np.zeros((nodes, buckets), np.bool_)
    fresh[: machine.first[1]] = True
    reached = np.zeros(nodes, np.bool_)
    for stage in range(machine.stages):
        span, slots = machine.nodes(stage), slice(machine.starts(stage), machine.ends(stage))
        whole = machine.opens[span][:, :, slots].all(axis=2)
        reset = np.asarray(machine.resets[span, slots].any(axis=1))
        fresh[span] &= whole & ~reset[:, None]
        for node in range(span.start, span.stop):
            for step in {step for step in machine.steps[node].tolist() if step >= 0}:
                fresh[step] = fresh[node] & (fresh[step] | ~reached[step])
                reached[step] = True
    return fresh
