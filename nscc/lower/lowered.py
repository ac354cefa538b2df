"""A lowered program with its costs, the choice between several lowerings, and the conversion of one
to a container."""

from __future__ import annotations

from functools import cached_property
from itertools import zip_longest

import numpy as np

from nscc.logic.problem import Solution
from nscc.lower.decoding import Decoding
from nscc.lower.exposure_plan import ExposurePlan, Lowering, Misfit, PlanStep, Timeline
from nscc.lower.schedule import FrameSchedule, kernel_us, schedule
from nscc.program.program import Program
from nscc.record import Record
from nscc.truth import rows
from nscc.words.container import Container, Launch, Readout, StoredKernel
from nscc.words.encoding import encode

_ROUNDING = 1 + 1e-9


class Lowered(Record):
    """An exposure plan (which analog words run at which boundary), its gates and its words, with
    costs on the program's target.

    `most_words` is the user's limit on words at a boundary, None if there is no limit."""

    program: Program
    decoding: Decoding
    schedule: FrameSchedule
    time: Timeline
    most_words: int | None

    def __repr__(self) -> str:
        """Return the lowering (a way to compute the exposure) and the number of words."""
        return f"Lowered({self.plan.lowering}, {self.schedule.words_total} words a frame)"

    @property
    def plan(self) -> ExposurePlan:
        """The analog words and what FLAG (the bit that lets a pixel act) must hold for them."""
        return self.decoding.plan

    @property
    def solution(self) -> Solution:
        """The gates and the encoding."""
        return self.decoding.solution

    @cached_property
    def words_per_boundary(self) -> list[int]:
        """The number of words that run at each boundary 0..N."""
        counts = [0] * (self.plan.slots + 1)
        for boundary, kernel in self.schedule.launches:
            counts[boundary] += len(self.schedule.kernels[kernel])
        return counts

    @cached_property
    def busy_us(self) -> list[float]:
        """The time of each boundary's words in microseconds, with launches (starts of kernels),
        settling of IN and the loop, for the boundaries 0..N.

        At boundary 0 only the words after the start of the exposure count. IN is the level sent to
        all pixels."""
        each_us = [kernel_us(kernel, self.program.target) for kernel in self.schedule.kernels]
        busy = [0.0] * (self.plan.slots + 1)
        for boundary, kernel in self.schedule.launches:
            busy[boundary] += each_us[kernel]
        for boundary in self.schedule.settles():
            busy[boundary] += self.program.target.in_settle_us
        # The frame starts at boundary 0, so the loop does not wait for it.
        for boundary in {boundary for boundary, _ in self.schedule.launches} - {0}:
            busy[boundary] += self.program.target.wait_us
        busy[0] -= self.schedule.setup_us
        return busy

    @property
    def shortest_slot_us(self) -> float:
        """The shortest slot length in microseconds, for equal slots, with which all words fit. The
        words after the last slot do not count, because no slot follows."""
        return max(self.busy_us[: self.plan.slots])

    @property
    def shortest_slot_launches(self) -> int:
        """The number of kernel launches included in `shortest_slot_us`. Of several boundaries that
        take equally long, the first counts. A launch is the start of a kernel, a list of words."""
        boundary = self.busy_us.index(self.shortest_slot_us)
        # The first launch of the frame is before the start of the exposure.
        return sum(n == boundary for n, _ in self.schedule.launches[1:])

    @property
    def frame_us(self) -> float:
        """The time from the first word of boundary 0 to the last word of boundary N, in
        microseconds."""
        return self.schedule.setup_us + self.time.boundary_us[-1] + self.busy_us[-1]

    @cached_property
    def late(self) -> list[int]:
        """The numbers of the slots that are shorter than the words at their start; empty if none
        is."""
        slots = self.program.frame.slot_us
        return [n for n, slot_us in enumerate(slots) if self.busy_us[n] > slot_us * _ROUNDING]

    @cached_property
    def overfull(self) -> list[int]:
        """The boundaries with more words than the user allows; empty without a limit."""
        if self.most_words is None:
            return []
        return [n for n, words in enumerate(self.words_per_boundary) if words > self.most_words]

    @cached_property
    def overload(self) -> float:
        """The words or time of the fullest boundary relative to its limit, above 1; 0 if all are
        within limits."""
        slots = self.program.frame.slot_us
        ratios = [self.busy_us[n] / slots[n] for n in self.late]
        ratios += [self.words_per_boundary[n] / (self.most_words or 1) for n in self.overfull]
        return max(ratios, default=0.0)

    @property
    def stored_ok(self) -> bool:
        """Whether the kernels fit the store. A kernel is a list of words."""
        return self.schedule.words_stored <= self.program.target.store_words

    @property
    def retained(self) -> bool:
        """Whether digital registers keep their content from one refresh to the next. True if none
        holds a code or a state: nothing must then be kept."""
        allocation = self.schedule.allocation
        kept = allocation.code_registers or allocation.state_registers
        return self.time.refresh_at is not None or not kept

    @property
    def fits(self) -> bool:
        """Whether store, slot times, retention and the user's limit are met."""
        return self.stored_ok and self.retained and not self.late and not self.overfull

    @property
    def price(self) -> tuple[bool, float, int, int, int]:
        """Sort key among solutions of one lowering (a way to compute the exposure); the smallest is
        the best.

        Its items are: does not fit, overload, words per frame without refresh, words of the largest
        boundary, refresh words."""
        refresh = self.schedule.words_refresh
        words = self.schedule.words_total - refresh
        return not self.fits, self.overload, words, max(self.words_per_boundary), refresh

    @property
    def headroom_e(self) -> float:
        """The largest constant light, in electrons per frame of an open shutter, that saturates no
        pixel.

        It is limited by PIX between two resets and by the registers of the buckets. PIX is the
        photodiode."""
        program, plan = self.program, self.plan
        target = program.target
        slot_us = np.array(program.frame.slot_us)
        share = slot_us / slot_us.sum()
        open_share = program.table.shutters @ share
        register_share = float(open_share.max(initial=0.0))
        reads = [s.boundary for s in plan.steps if s.bucket >= 0 and _reads_pix(s)]
        if plan.lowering == "accumulate":
            read_slots = [n - 1 for n in reads]
            pix_share = float(share[read_slots].max(initial=0.0)) if read_slots else 0.0
        elif any(s.role == "rise" and not _reads_pix(s) for s in plan.steps):
            # The largest light between a rise and its fall, as a fraction of the frame's light.
            bump = np.zeros(program.table.shutters.shape[:2])
            pix_share = 0.0
            for slot, slot_share in enumerate(share):
                bump = np.where(program.table.shutters[:, :, slot], bump + slot_share, 0.0)
                pix_share = max(pix_share, float(bump.max(initial=0.0)))
        else:
            pix_share = float(share[: max(reads, default=0)].sum())
            if plan.lowering == "edges":
                # A rising edge subtracts all light before it.
                last = max((s.boundary for s in plan.steps if s.role == "rise"), default=0)
                register_share = max(register_share, float(share[:last].sum()))
        limits = [target.full_well_e / pix_share] if pix_share else []
        if register_share:
            limits.append(min(target.register_max_e, -target.register_min_e) / register_share)
        return min(limits, default=target.full_well_e)


class Choice(Record):
    """All lowerings (ways to compute the exposure) with gates, best first, and why others failed.

    `failed_generators` names the generators (methods that find gates) that raised an exception."""

    lowerings: tuple[Lowered, ...]
    misfits: dict[Lowering, Misfit]
    failed_generators: tuple[str, ...] = ()

    bits_a_frame, bits_per_us = 0, 0.0
    """What the chip receives for a frame: nothing, because the pixels decode their codes."""

    @property
    def best(self) -> Lowered:
        """The best lowering (a way to compute the exposure); the caller ensures that it exists."""
        return self.lowerings[0]

    @property
    def program(self) -> Program:
        """The program that was lowered."""
        return self.best.program

    @property
    def shortest_slot_us(self) -> float:
        """The shortest slot length with which all words of the best lowering fit. A lowering is a
        way to compute the exposure."""
        return self.best.shortest_slot_us

    @property
    def frame_us(self) -> float:
        """The time of a frame of the best lowering (a way to compute the exposure), in
        microseconds."""
        return self.best.frame_us


def lay_out(
    program: Program, decoding: Decoding, time: Timeline, most_words: int | None
) -> Lowered:
    """Lay out the words of a decoding over the frame's boundaries.

    `decoding` and `time` belong to `program`. `most_words` is the user's limit on words at a
    boundary, as in `Lowered`; nothing is raised if it, or another limit, is exceeded."""
    laid = schedule(decoding, time, program.target, program.spared_registers)
    return Lowered(program, decoding, laid, time, most_words)


def _reads_pix(step: PlanStep) -> bool:
    """Return whether some word of a step reads the photodiode."""
    return any("PIX" in word.sources for word in step.words)


def assemble(lowered: Lowered, level: int) -> Container:
    """Return the container (a compiled program) of a lowered program, with the words and the
    register contents of each shutter.

    `level` is the optimisation level, which the container's notes name. The caller ensures that the
    words fit the chip."""
    program, plan, schedule = lowered.program, lowered.plan, lowered.schedule
    target, planes = program.target, lowered.solution.planes
    shutters = len(program.table.shutters)
    encoding = np.zeros((shutters, len(target.digital_registers)), dtype=np.bool_)
    chip_registers = schedule.allocation.chip_registers
    code_columns = [
        target.digital_registers.index(chip_registers[f"p{i}"]) for i in range(len(planes))
    ]
    encoding[:, code_columns] = rows(list(planes), shutters)
    return Container(
        target=target,
        slot_us=program.frame.slot_us,
        buckets=tuple(bucket.name for bucket in program.buckets),
        table=program.table,
        kernels=tuple(
            StoredKernel(f"k{i}", tuple(encode(word) for word in kernel))
            for i, kernel in enumerate(schedule.kernels)
        ),
        launches=tuple(
            Launch(boundary, kernel, level)
            # `levels` is empty if no launch sets IN; every launch then has None.
            for (boundary, kernel), level in zip_longest(schedule.launches, schedule.levels)
        ),
        code_registers=schedule.allocation.code_registers,
        encoding=encoding,
        pixel_codes=program.pixel_codes,
        readouts=tuple(
            Readout(register, bucket.name)
            for register, bucket in zip(plan.bucket_registers, program.buckets, strict=True)
        ),
        source_lines=tuple(program.source.text.splitlines()),
        notes={
            "class": program.class_name,
            "codes": program.mode,
            "level": str(level),
            "lowering": plan.lowering,
        },
    )


# Relative tolerance for times, which are sums of decimal fractions.
