"""The analog plan of a program with senses: the analog operations of each pixel at each boundary.

PIX is reset only where the program says so; `light` is the charge since then. When a shutter
closes, PIX - reset level is added to its bucket; when it opens, it is subtracted. A bucket that was
open since the frame began and is still empty gets the difference as a copy, so no word reads the
bucket.

Each moment (a boundary with operations) is described over its lanes. A lane is a node of the state
machine that a pixel can be in before the boundary, with one outcome of the boundary's comparisons.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from itertools import chain

import numpy as np

from nscc.arrays import Bools, Indices
from nscc.lower.exposure_plan import LoweringOption, Misfit, analog_registers
from nscc.operations import Op, op
from nscc.program.program import Program
from nscc.record import Record
from nscc.truth import vector
from nscc.words.machine import Comparison, StateMachine

Nodes = Indices
Bits = Bools


class Moment(Record, eq=False):
    """A boundary at which pixels compare their light, shutters open or close, or PIX (the
    photodiode) is reset.

    A lane is a node of the state machine with one outcome of the comparisons. `before` and `after`
    (lanes,) are the nodes of each lane; bit c of `outcomes` (lanes,) is its answer of comparison c.
    `falls`, `rises` and `resets` are truth vectors: integers with one bit for each lane. For each
    bucket they say where its shutter closes (`falls`) and opens (`rises`); `copies` says whether a
    closing bucket may take a copy of PIX. `resets` says where PIX is reset in between."""

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
        """The truth vector (an integer with one bit for each lane) of all lanes."""
        return (1 << len(self.before)) - 1

    def below(self, comparison: int) -> int:
        """Return the truth vector of the lanes (simulated pixels) in which a comparison finds the
        signal at most at its level.

        `comparison` is its index in `comparisons`. A truth vector is an integer with one bit for
        each simulated pixel."""
        return vector(np.flatnonzero(self.outcomes >> comparison & 1 == 0))


class LookingPlan(Record, eq=False):
    """What happens to PIX (the photodiode) and the analog registers at each boundary of a frame,
    for a program with senses.

    `moments` are the boundaries at which something happens, in order. `registers` says by register
    what it holds, and `bucket_registers` are those of the buckets, in their order. The register
    `reference` holds the reset level, or its negative if every exposure is a single copy
    (`latches`): each word adds an error, and the negative takes one word less. `scratch` is a
    register for intermediate results."""

    program: Program
    machine: StateMachine
    moments: tuple[Moment, ...]
    registers: dict[str, str]
    bucket_registers: tuple[str, ...]
    reference: str
    scratch: str

    @cached_property
    def latches(self) -> bool:
        """Whether every closing shutter copies PIX (the photodiode) into an empty bucket, and no
        shutter opens after slot 0.

        The register `reference` then holds minus the reset level."""
        falls = (
            pair
            for moment in self.moments
            for pair in zip(moment.falls, moment.copies, strict=True)
        )
        rises = chain.from_iterable(moment.rises for moment in self.moments)
        return all(copy or not fall for fall, copy in falls) and not any(rises)

    def sampled(self, *registers: str) -> Op:
        """Return the word that writes -(PIX + the sum of `registers`) to the scratch register (for
        intermediate results).

        If `reference` holds the negative reset level, that is included in the sum. PIX is the
        photodiode."""
        level = (self.reference,) if self.latches else ()
        return op("bus", (self.scratch,), (*registers, "PIX", *level))

    def register_to_scratch(self, register: str) -> Op:
        """Return the word that writes to the scratch register so that the sum of the registers
        `scratched` is minus the value of `register`. A scratch register holds an intermediate
        result."""
        level = () if self.latches else (self.reference,)
        return op("bus", (self.scratch,), (register, *level))

    @property
    def scratched(self) -> tuple[str, ...]:
        """The registers whose sum is minus the signal, after the word of `sampled` or
        `register_to_scratch`."""
        return (self.scratch,) if self.latches else (self.scratch, self.reference)


def plan_looks(
    program: Program, machine: StateMachine, lowering: LoweringOption
) -> LookingPlan | Misfit:
    """Return the analog plan of a program with senses.

    `lowering` is the way to compute the exposure: "edges", "latch", "accumulate" or "auto", which
    chooses. Return a Misfit with the reason if analog registers are missing or `lowering` cannot
    implement the program; "accumulate" never can."""
    if lowering == "accumulate":
        return Misfit(
            "accumulate resets PIX in every slot, so a program with `sense` cannot use it"
        )
    analog = analog_registers(program, "edges", reference=True)
    if isinstance(analog, Misfit):
        return analog
    assert analog.reference is not None
    moments = _moments(machine)
    # Without copies, every exposure is a sum of differences.
    if lowering == "edges":
        moments = (replace(m, copies=(False,) * len(m.copies)) for m in moments)
    plan = LookingPlan(
        program,
        machine,
        moments=tuple(moments),
        registers=analog.holders,
        bucket_registers=analog.buckets,
        reference=analog.reference,
        scratch=analog.scratch,
    )
    if lowering == "latch" and not plan.latches:
        return Misfit(
            "latch requires shutters that open in slot 0 and close once, with no `reset` before"
        )
    return plan


def _moments(machine: StateMachine) -> Iterator[Moment]:
    """Yield the moments of the frame in order: boundaries with comparisons, opening or closing
    shutters, or resets, and the end of the frame."""
    # Whether a shutter was open and PIX was not reset, from the frame's start to the stage's, on
    # every path to the node.
    always_open = np.ones((len(machine.behaviour), machine.opens.shape[1]), np.bool_)
    for stage in range(machine.stages):
        span = machine.nodes(stage)
        nodes = np.arange(span.start, span.stop)
        begin, end = machine.starts(stage), machine.ends(stage)
        # Most slots are equal to the previous one in every node.
        opens, resets = machine.opens[span], machine.resets[span]
        changes = (opens[:, :, 1:] != opens[:, :, :-1]).any(axis=(0, 1)) | resets[:, 1:].any(axis=0)
        fresh = always_open[span]
        for boundary in (*np.flatnonzero(changes[begin : end - 1]) + begin + 1, end):
            fresh = fresh & opens[:, :, begin:boundary].all(axis=2)
            fresh &= ~resets[:, begin:boundary].any(axis=1, keepdims=True)
            begin = int(boundary)
            if begin < end:
                yield _moment(
                    machine, fresh, boundary=begin, comparisons=(), before=nodes, after=nodes
                )
        if stage + 1 < machine.stages:
            comparisons = machine.at(end)
            outcomes = 1 << len(comparisons)
            before = np.repeat(nodes, outcomes)
            outcome = np.tile(np.arange(outcomes), len(nodes))
            after = machine.steps[before, outcome].astype(np.intp)
            fresh = np.repeat(fresh, outcomes, axis=0)
            np.logical_and.at(always_open, after, fresh)
            yield _moment(
                machine,
                fresh,
                boundary=end,
                comparisons=comparisons,
                before=before,
                after=after,
                outcomes=outcome,
            )
        # A look at the end of the frame leaves no slot for the last stage, and closes the shutters.
        elif machine.starts(stage) < end:
            yield _moment(machine, fresh, boundary=end, comparisons=(), before=nodes, after=nodes)


def _moment(
    machine: StateMachine,
    fresh: Bits,
    boundary: int,
    comparisons: tuple[Comparison, ...],
    before: Nodes,
    after: Nodes,
    outcomes: Nodes | None = None,
) -> Moment:
    """Return which buckets close, open or reset at a boundary, in which lanes.

    Lane k is a transition of the state machine: from node `before[k]` to node `after[k]` by the
    answers `outcomes[k]`, whose bit c is that of comparison c; None without comparisons. `fresh`,
    bool (lanes, buckets), tells where a bucket is empty and was open since PIX (the photodiode) was
    reset, so that closing it copies PIX instead of adding a difference. `comparisons` are those
    made at this boundary."""
    buckets = machine.opens.shape[1]
    was = machine.opens[before, :, boundary - 1]
    inside = boundary < machine.slots
    becomes = machine.opens[after, :, boundary] if inside else np.zeros_like(was)
    resets = machine.resets[after, boundary] if inside else np.zeros(len(after), np.bool_)
    # A reset ends the light in PIX, so an open bucket takes it before, and continues from an empty
    # PIX: nothing need be subtracted then.
    falls = was & (~becomes | resets[:, None])
    rises = becomes & ~was & ~resets[:, None]
    copies = [bool(fresh[falls[:, b], b].all()) for b in range(buckets)]
    return Moment(
        boundary,
        comparisons,
        before,
        after,
        outcomes=np.zeros(len(before), np.intp) if outcomes is None else outcomes,
        falls=tuple(vector(np.flatnonzero(falls[:, b])) for b in range(buckets)),
        copies=tuple(copies),
        resets=vector(np.flatnonzero(resets)),
        rises=tuple(vector(np.flatnonzero(rises[:, b])) for b in range(buckets)),
    )
