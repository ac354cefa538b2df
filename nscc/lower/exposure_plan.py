"""Exposure plans: which analog words run at which boundary, and in which pixels.

The exposure of a bucket is E = sum over n of L[n] S[n], with the light L[n] of slot n and S[n] = 1
if the shutter is open (equation 3 of the paper). The photodiode PIX can only integrate light, so
a plan computes E in one of three ways (lowerings):

* accumulate: PIX is reset in every slot, and the light of a slot is added if the shutter was open
* latch: PIX is not reset within the frame; a pixel that is open from slot 0 copies PIX when it
  closes
* edges: PIX is not reset within the frame; PIX is added when the shutter closes (falling edge) and
  subtracted when it opens (rising edge). A chip that can reset single pixels resets them instead
  when they open.

Boundaries are 0..N. Boundary n is before slot n, and slot n is read at boundary n + 1. A
predicate, a truth vector over the program's shutters, selects the pixels of each step; gates
compute the predicate later.

A plan also needs the times of the frame, because digital registers keep their content only for a
while."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import accumulate, pairwise
from typing import Literal, NamedTuple, get_args

import numpy as np

from nscc.chips.target import Target
from nscc.operations import Op, WordEffect, op
from nscc.program.limits import bits_needed
from nscc.program.program import Program
from nscc.record import Record
from nscc.truth import columns, members

# Share of the retention time that may be used: words take time, and the retention is a typical
# value.
RETENTION_SHARE = 0.9


class Timeline(Record):
    """The frame's times in microseconds.

    `boundary_us[n]` is the time of boundary n. `between_us` is the time from boundary N to the next
    frame's boundary 0 (readout). `keep_us` is the time for which registers keep their content.
    `refresh_at` are the boundaries within the frame at which registers must be refreshed; None if
    that is not enough."""

    boundary_us: tuple[float, ...]
    between_us: float
    keep_us: float
    refresh_at: tuple[int, ...] | None


def timeline(slot_us: tuple[float, ...], bucket_count: int, target: Target) -> Timeline:
    """Return when the boundaries of a frame are, how long its `bucket_count` readouts take, and
    where registers are refreshed.

    `slot_us` are the lengths of the slots in microseconds. The readouts are one after the other. If
    no refresh suffices, `refresh_at` is None and nothing is raised."""
    boundary_us = (0.0, *accumulate(slot_us))
    between_us = target.readout_us * bucket_count
    keep_us = RETENTION_SHARE * target.digital_retention_us
    refresh_at = _refresh_boundaries(boundary_us, between_us, keep_us)
    return Timeline(boundary_us, between_us, keep_us, refresh_at)


def _refresh_boundaries(
    boundary_us: tuple[float, ...], between_us: float, keep_us: float
) -> tuple[int, ...] | None:
    """Return the fewest boundaries that keep every gap, including the readout, within keep_us;
    empty if no refresh is needed.

    `boundary_us` are the times of the boundaries 0..N, from 0 on, and `between_us` is the time from
    boundary N to the next frame. None if a single slot or the readout is too long."""
    if between_us > keep_us:
        return None
    refresh_at: list[int] = []
    last_us = -between_us  # the end of the previous frame, before its readout
    for n in range(1, len(boundary_us)):
        if boundary_us[n] - last_us > keep_us:
            # A refresh at boundary n - 1 does not help if this slot alone is too long, or if there
            # was one already.
            if boundary_us[n] - boundary_us[n - 1] > keep_us or boundary_us[n - 1] <= last_us:
                return None
            refresh_at.append(n - 1)
            last_us = boundary_us[n - 1]
    return tuple(refresh_at)


def fades(written_at: Collection[int], time: Timeline) -> bool:
    """Return whether a register that is written at these boundaries of every frame exceeds the
    retention time between two writes; True if it is never written.

    `written_at` are numbers of boundaries, in any order."""
    if not written_at:
        return True
    times_us = [time.boundary_us[n] for n in sorted(written_at)]
    # From the last write of one frame, over the readout, to the first write of the next.
    to_next_frame_us = time.boundary_us[-1] - times_us[-1] + time.between_us + times_us[0]
    gaps_us = [later - earlier for earlier, later in pairwise(times_us)]
    return max([to_next_frame_us, *gaps_us]) > time.keep_us


Lowering = Literal["accumulate", "latch", "edges"]
LOWERINGS: tuple[Lowering, ...] = get_args(Lowering)
LoweringOption = Lowering | Literal["auto"]

Role = Literal["setup", "reset", "look", "open", "rise", "fall"]


class PlanStep(NamedTuple):
    """Analog words at one boundary, executed in the pixels of the truth vector `predicate`.

    A predicate (a set of shutters) of None means every pixel, independent of FLAG. `role` says what
    the words are for. `bucket` is the bucket's index, -1 for steps of the whole frame. A truth
    vector is an integer with one bit for each shutter."""

    boundary: int
    role: Role
    bucket: int
    predicate: int | None
    words: tuple[Op, ...]


class ExposurePlan(Record):
    """The analog part of a program, for one lowering (a way to compute the exposure).

    `registers` describes the content of every used analog register; `bucket_registers` are those
    that hold the exposures, in the order of the buckets. `shutters` and `slots` are numbers.
    `analog_writes` are the fewest and most analog words (`bus`) that a pixel with an opening
    shutter executes after the setup."""

    lowering: Lowering
    steps: tuple[PlanStep, ...]
    registers: dict[str, str]
    bucket_registers: tuple[str, ...]
    shutters: int
    slots: int
    analog_writes: tuple[int, int]

    @property
    def everywhere(self) -> int:
        """The truth vector (an integer with one bit for each shutter) of all shutters."""
        return (1 << self.shutters) - 1


class Misfit(Record):
    """The reason why a lowering cannot be used: an unmet condition, or too few registers.

    `resource` names the kind of registers, of which `required` are needed and `available` exist;
    None for other reasons. `searched` means that no gates were found, which proves nothing. A
    lowering is a way to compute the exposure."""

    reason: str
    resource: str | None = None
    required: int = 0
    available: int = 0
    searched: bool = False


class AnalogRegisters(NamedTuple):
    """The use of analog registers: one per bucket, in their order, one for the reset level
    (`reference`, None if it is not needed), and scratch.

    `holders` describes the content of every register in words."""

    buckets: tuple[str, ...]
    reference: str | None
    scratch: str
    holders: dict[str, str]


Opens = tuple[tuple[int, ...], ...]
"""For every bucket, the truth vector of the open shutters in each slot."""


class Planned(Record):
    """A program with its exposure plans, fewest analog writes first.

    `misfits` says why other lowerings (ways to compute the exposure) that were tried have no plan.
    A lowering that the user did not choose is in neither of the two."""

    program: Program
    time: Timeline
    opens: Opens
    plans: tuple[ExposurePlan, ...]
    misfits: dict[Lowering, Misfit]


def plan_exposures(program: Program, option: LoweringOption) -> Planned:
    """Return the exposure plans of `program` for one lowering (a way to compute the exposure), or
    with the option "auto" for all of them.

    There may be no plan; the reasons are then in `misfits`."""
    opens = levels(program)
    plans: list[ExposurePlan] = []
    misfits: dict[Lowering, Misfit] = {}
    for lowering in LOWERINGS if option == "auto" else (option,):
        plan = plan_exposure(program, lowering, opens)
        if not isinstance(plan, Misfit):
            plan = _crowded(plan, program.target) or plan
        if isinstance(plan, Misfit):
            misfits[lowering] = plan
        else:
            plans.append(plan)
    plans.sort(key=lambda plan: plan.analog_writes[1])
    return Planned(program, frame_time(program), opens, tuple(plans), misfits)


def _crowded(plan: ExposurePlan, target: Target) -> Misfit | None:
    """Return why no gates can load FLAG for some step of `plan`, or None if the count of registers
    allows gates for each step.

    FLAG is the OR of one or more registers. Those are 0 in all shutters outside of the step's
    predicate, so the remaining registers must distinguish these shutters: what FLAG held before is
    lost. FLAG is the bit that lets a pixel act. A predicate is a set of shutters."""
    loaded = [step for step in plan.steps if step.predicate]
    if not loaded:
        return None
    smallest = min(loaded, key=lambda step: (step.predicate or 0).bit_count())
    others = plan.shutters - (smallest.predicate or 0).bit_count()
    required, available = 1 + bits_needed(others), len(target.digital_registers)
    if required <= available:
        return None
    return Misfit(
        f"one register selects the shutters of boundary {smallest.boundary}, and the others must "
        f"distinguish the {others} other shutters: {required} registers with any encoding",
        "digital registers",
        required,
        available,
    )


def frame_time(program: Program) -> Timeline:
    """Return the timeline of the program's frame."""
    return timeline(program.frame.slot_us, len(program.buckets), program.target)


def levels(program: Program) -> Opens:
    """Return the open shutters of every bucket and slot, as truth vectors: item [bucket][slot]. A
    truth vector is an integer with one bit for each shutter."""
    shutters = program.table.shutters
    return tuple(tuple(columns(shutters[:, bucket, :])) for bucket in range(shutters.shape[1]))


def plan_exposure(program: Program, lowering: Lowering, opens: Opens) -> ExposurePlan | Misfit:
    """Return the exposure plan (which analog words run at which boundary) of the way `lowering` to
    compute exposures, or a Misfit. The reason of a Misfit is too few analog registers, or for
    `latch` a shutter that does not open in slot 0 and close once. `opens` is `levels(program)`."""
    free = len(program.target.analog_available)
    # `edges` can do without the reset level: shutters that open in slot 0 then subtract PIX, too.
    reference = lowering != "edges" or len(program.buckets) < free
    registers = analog_registers(program, lowering, reference=reference)
    if isinstance(registers, Misfit):
        return registers
    shutters = program.table.shutters
    if lowering == "latch" and np.any(shutters[:, :, 1:] & ~shutters[:, :, :-1]):
        return Misfit("latch requires shutters that open in slot 0 and close once")
    return _Builder(program, lowering, opens, registers).build()


def analog_registers(
    program: Program, lowering: Lowering, *, reference: bool
) -> AnalogRegisters | Misfit:
    """Return the registers of a lowering (a way to compute the exposure), with one for the reset
    level if it needs a `reference`.

    Registers are taken in the order of the target: buckets first, then the reset level. Returns a
    Misfit if the chip has too few; a lowering without a `reference` may still fit."""
    target, buckets = program.target, program.buckets
    free = target.analog_available
    required = len(buckets) + reference
    if required > len(free):
        return Misfit(
            f"{lowering} needs {required} analog registers beside {target.analog_scratch}: "
            f"{len(buckets)} buckets{' and the reset level' * reference}; there are {len(free)}",
            "analog registers",
            required,
            len(free),
        )
    pairs = zip(free[: len(buckets)], buckets, strict=True)
    holders = {register: f"exposure of {bucket.name}" for register, bucket in pairs}
    level = free[len(buckets)] if reference else None
    if level is not None:
        holders[level] = "reset level of PIX"
    holders[target.analog_scratch] = "scratch of analog words"
    return AnalogRegisters(free[: len(buckets)], level, target.analog_scratch, holders)


def _analog_writes(program: Program, steps: Sequence[PlanStep]) -> tuple[int, int]:
    """Return the fewest and the most analog words (`bus`) that a pixel executes in these steps for
    its buckets, over the shutters that ever open; (0, 0) if none opens."""
    shutters = len(program.table.shutters)
    counts = np.zeros(shutters, dtype=np.int64)
    for step in steps:
        if step.bucket >= 0:
            buses = sum(word.operation.effect is WordEffect.BUS for word in step.words)
            chosen = slice(None) if step.predicate is None else members(step.predicate, shutters)
            counts[chosen] += buses
    of_opening = counts[program.table.shutters.any(axis=(1, 2))]
    return (int(of_opening.min()), int(of_opening.max())) if of_opening.size else (0, 0)


# Twice with a pause, as the library's respix does: one word is too short to reset the photodiode.
RESET = (op("rpix"), op("rpix"), op("nop"))


class _Builder:
    """The steps of an exposure plan in execution order (`steps`), under construction; each plan
    needs a new builder. `everywhere` is the truth vector (an integer with one bit for each shutter)
    of all shutters."""

    def __init__(
        self, program: Program, lowering: Lowering, opens: Opens, analog: AnalogRegisters
    ) -> None:
        """Begin an exposure plan without steps.

        `opens` lists for each bucket and slot the shutters that are open, as a truth vector (an
        integer with one bit for each shutter). `analog` holds the exposure registers, the register
        of the reset level, the scratch register (for intermediate results), and what each register
        holds."""
        self.program = program
        self.lowering = lowering
        self.opens = opens
        self.registers, self.reference, self.scratch, self.holders = analog
        self.zero = () if self.reference is None else (self.reference,)
        self.slots = len(program.frame.slot_us)
        self.everywhere = (1 << len(program.table.shutters)) - 1
        self.steps: list[PlanStep] = []

    def build(self) -> ExposurePlan:
        """Return the exposure plan. Its steps clear the registers, reset PIX (the photodiode), then
        run the words of the lowering (a way to compute the exposure). The method adds to the steps,
        so it is called only once."""
        scratch = self.scratch
        # A bus word writes minus the sum of its sources, so one without sources writes 0.
        clear = (op("bus", (scratch,)), *(op("bus", (a,), (scratch,)) for a in self.registers))
        self.steps.append(
            PlanStep(boundary=0, role="setup", bucket=-1, predicate=None, words=clear)
        )
        sample: tuple[Op, ...] = ()
        if self.reference is not None:
            # Two inversions, so that the register holds the reset level with its own sign.
            sample = (op("bus", (scratch,), ("PIX",)), op("bus", (self.reference,), (scratch,)))
        self.steps.append(
            PlanStep(boundary=0, role="reset", bucket=-1, predicate=None, words=(*RESET, *sample))
        )
        lowerings = {"accumulate": self._accumulate, "latch": self._latch, "edges": self._edges}
        lowerings[self.lowering]()
        return ExposurePlan(
            self.lowering,
            steps=tuple(self.steps),
            registers=self.holders,
            bucket_registers=self.registers,
            shutters=len(self.program.table.shutters),
            slots=self.slots,
            analog_writes=_analog_writes(self.program, self.steps),
        )

    def _step(
        self, boundary: int, role: Role, bucket: int, predicate: int, words: tuple[Op, ...]
    ) -> None:
        """Add a step for the pixels of `predicate` unless it is empty. If it contains all shutters,
        the step is for every pixel (a predicate of None), which needs no gates. A predicate is a
        set of shutters."""
        if predicate:
            taking_part = None if predicate == self.everywhere else predicate
            self.steps.append(PlanStep(boundary, role, bucket, taking_part, words))

    def _add(self, register: str) -> tuple[Op, ...]:
        """Return words for register += PIX - reference.

        A bus word writes minus the sum of its sources: scratch = -(register + PIX), then register =
        -(scratch + reference). PIX is the photodiode."""
        first_sources, second_sources = (register, "PIX"), (self.scratch, *self.zero)
        return op("bus", (self.scratch,), first_sources), op("bus", (register,), second_sources)

    def _subtract(self, register: str) -> tuple[Op, ...]:
        """Return words for register -= PIX - reference, that is, register = -(scratch + PIX) with
        scratch = -(register + reference). PIX is the photodiode."""
        before, after = (register, *self.zero), (self.scratch, "PIX")
        return op("bus", (self.scratch,), before), op("bus", (register,), after)

    def _accumulate(self) -> None:
        """Append the steps of the lowering `accumulate`: read PIX (the photodiode) after each slot
        in pixels with an open shutter, and reset it before the next. A lowering is a way to compute
        the exposure."""
        adds = [self._add(register) for register in self.registers]
        for slot, lit in enumerate(zip(*self.opens, strict=True)):
            # The setup resets PIX for slot 0; for a slot in which no shutter is open nobody reads
            # it.
            if slot and any(lit):
                self.steps.append(
                    PlanStep(boundary=slot, role="reset", bucket=-1, predicate=None, words=RESET)
                )
            for bucket, add in enumerate(adds):
                self._step(slot + 1, "open", bucket, lit[bucket], add)

    def _latch(self) -> None:
        """Add copies of PIX (the photodiode) at boundaries where a shutter closes, in the pixels
        that were open before; a pixel that stays open copies again later, and only its last copy
        counts."""
        assert self.reference is not None
        sample = op("bus", (self.scratch,), ("PIX",))
        copies = [
            (sample, op("bus", (register,), (self.scratch, self.reference)))
            for register in self.registers
        ]
        for boundary, changes in self._changes():
            for bucket, (before, after) in enumerate(changes):
                if before != after:
                    self._step(boundary, "open", bucket, before, copies[bucket])

    def _edges(self) -> None:
        """Append the steps of the lowering `edges`: PIX (the photodiode) is added where a shutter
        closes, and subtracted, or reset, where it opens.

        Falls come before rises, because a rise may reset PIX before another bucket's fall reads it.
        A lowering is a way to compute the exposure."""
        falls = [self._add(register) for register in self.registers]
        resets = self._can_reset_at_rise()
        rises = [RESET if resets else self._subtract(register) for register in self.registers]
        # With a reference, PIX has the reset level at boundary 0, so there is nothing to subtract.
        first_rise = 0 if self.reference is None else 1
        for boundary, changes in self._changes():
            for bucket, (before, after) in enumerate(changes):
                self._step(boundary, "fall", bucket, before & ~after, falls[bucket])
            if boundary >= first_rise:
                for bucket, (before, after) in enumerate(changes):
                    self._step(boundary, "rise", bucket, after & ~before, rises[bucket])

    def _changes(self) -> Iterator[tuple[int, list[tuple[int, int]]]]:
        """Yield the boundaries where shutters change, with each bucket's open shutters before and
        after, as truth vectors (integers with one bit for each shutter).

        Before slot 0 and after the last slot all are closed. Boundaries at which no bucket changes
        are left out."""
        closed = (0,) * len(self.opens)
        states = (closed, *zip(*self.opens, strict=True), closed)
        for boundary, (before, after) in enumerate(pairwise(states)):
            if before != after:
                yield boundary, list(zip(before, after, strict=True))

    def _can_reset_at_rise(self) -> bool:
        """Return whether pixels may reset PIX (the photodiode) when a shutter opens: the target
        resets only pixels whose FLAG is 1, the reset level is stored, and in no pixel is another
        bucket open then, which would lose light. FLAG is the bit that lets a pixel act."""
        if self.program.target.reset_honours_flag != "yes" or self.reference is None:
            return False
        for boundary in range(1, self.slots):
            opening = still_open = 0  # truth vectors over all buckets
            for bucket in self.opens:
                opening |= bucket[boundary] & ~bucket[boundary - 1]
                still_open |= bucket[boundary] & bucket[boundary - 1]
            if opening & still_open:
                return False
        return True
