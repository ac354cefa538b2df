"""Compiler passes for programs with senses, and the layout of their words: registers, kernels, and
launches with their values of IN. `nscc.pipeline` lists all passes.

IN is set between kernels, so a boundary with comparisons at several levels has several kernels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain

import numpy as np

from nscc.chips.target import Target
from nscc.logic.problem import Gate, GaveUp, Problem, Segment, Solution
from nscc.looks.encode import encodings
from nscc.looks.looking_plan import LookingPlan, Moment, plan_looks
from nscc.looks.solve import LookingSolution, SetIn, Solver
from nscc.lower import fit
from nscc.lower.decoding import Decoding
from nscc.lower.exposure_plan import (
    RESET,
    ExposurePlan,
    Misfit,
    PlanStep,
    Timeline,
    frame_time,
)
from nscc.lower.lowered import Lowered, assemble
from nscc.lower.schedule import (
    Allocation,
    FrameSchedule,
    allocate,
    kernel_us,
    refresh_words,
    refreshed_registers,
    words,
)
from nscc.operations import Op, op
from nscc.pipeline import Found, Job
from nscc.program.program import Program
from nscc.words.container import Container
from nscc.words.machine import StatePlanes

Words = tuple[Op, ...]
_MOST_CLEARED = 4
"""Most registers in one CLR of the public library."""


class LookingLowered(Lowered):
    """The words of a program with senses; `looking` has them on virtual registers."""

    looking: LookingSolution


def lay_out_looks(
    plan: LookingPlan, solution: LookingSolution, time: Timeline, most_words: int | None
) -> LookingLowered | None:
    """Assign the virtual registers of a solution to the chip's, and the words to kernels and
    launches.

    `time` are the lengths of slots with the boundaries at which registers are refreshed.
    `most_words` is the largest number of words at a boundary, None for no limit; whether it is kept
    is checked later. Return None if the content of the mask's register would be lost."""
    target = plan.program.target
    answers = tuple(
        (tuple(item for item in items if isinstance(item, Gate)),)
        for items in solution.items.values()
    )
    general = Solution(
        encoding=solution.encoding.name,
        planes=solution.planes,
        holders=solution.holders,
        states=len(solution.states),
        scratch=solution.scratch,
        opening=(),
        answers=answers,
        closing=(),
    )
    allocation = allocate(general, target)
    if _mask_is_lost(solution, allocation):
        return None
    named = dict(zip((f"s{i}" for i in range(general.states)), solution.states, strict=True))
    by_place = {
        allocation.chip_registers[name]: f"state {state_name}" for name, state_name in named.items()
    }
    allocation = replace(allocation, holders={**allocation.holders, **by_place})
    schedule = _schedule(plan, solution, allocation, time, target, apart=False)
    if schedule.words_stored > target.store_words:
        schedule = _schedule(plan, solution, allocation, time, target, apart=True)
    # No demand depends on codes alone.
    problem = Problem(
        demands=(), shutters=len(plan.program.table.shutters), opens=(), flag_lasts=False, values={}
    )
    decoding = Decoding(_exposure_plan(plan), problem, actions=(), solution=general)
    return LookingLowered(plan.program, decoding, schedule, time, most_words, looking=solution)


def _mask_is_lost(solution: LookingSolution, allocation: Allocation) -> bool:
    """Return whether a write to the masked register destroys a value that is read later; False if
    one of both registers is unused.

    `allocation` says which value is in which register of the chip. The chip changes the masked
    register only in pixels whose mask register is 1. So the words first set the mask to 1, which
    overwrites what it holds."""
    held_by = {register: name for name, register in allocation.chip_registers.items()}
    mask, masked = held_by.get(allocation.mask or ""), held_by.get(allocation.masked or "")
    if mask is None or masked is None:
        return False
    for items in solution.items.values():
        mask_overwritten = False
        for gate in (item for item in items if isinstance(item, Gate)):
            mask_overwritten |= gate.destination == masked
            # Codes and states must last beyond the boundary; scratch ("t..") is lost only if read.
            if mask_overwritten and (mask in gate.sources or not mask.startswith("t")):
                return True
            if gate.destination == mask:
                mask_overwritten = False
    return False


def _schedule(
    plan: LookingPlan,
    solution: LookingSolution,
    allocation: Allocation,
    time: Timeline,
    target: Target,
    *,
    apart: bool,
) -> FrameSchedule:
    """Return the kernels (lists of words) of the frame, and at which boundaries they start.

    `time` says at which boundaries registers are refreshed. With `apart`, the gates after a
    boundary's last analog word are a separate kernel, because the words before them often repeat at
    other boundaries; that stores fewer words but needs more launches."""
    slots = plan.machine.slots
    boundaries: list[list[tuple[int | None, Words]]] = [[] for _ in range(slots + 1)]
    states = tuple(allocation.chip_registers[f"s{i}"] for i in range(len(solution.states)))
    cleared = (states[i : i + _MOST_CLEARED] for i in range(0, len(states), _MOST_CLEARED))
    setup = (op("all"), *_setup(plan), *(op("CLR", group) for group in cleared))
    boundaries[0].append((None, setup))
    # The light of slot 0 begins after the last word of the reset.
    last_reset = max(i for i, word in enumerate(setup) if word == RESET[0])
    for boundary, items in solution.items.items():
        boundaries[boundary] += _kernels(items, allocation, apart=apart)
    refreshed = refreshed_registers(
        [[words_ for _, words_ in boundary_kernels] for boundary_kernels in boundaries],
        allocation,
        time,
    )
    for n in time.refresh_at or ():
        to_refresh = (*refreshed, *states)
        # Boundary 0 needs no refresh: codes are refreshed at the frame's end, and states set here.
        if to_refresh and n:
            boundaries[n].insert(0, (None, refresh_words(to_refresh, allocation)))
    if refreshed:
        boundaries[slots].append((None, refresh_words(refreshed, allocation)))
    numbers: dict[Words, int] = {}
    launches: list[tuple[int, int]] = []
    levels: list[int | None] = []
    for n, kernels in enumerate(boundaries):
        for level, kernel in kernels:
            launches.append((n, numbers.setdefault(kernel, len(numbers))))
            levels.append(level)
    setup_us = kernel_us(setup[: last_reset + 1], target)
    return FrameSchedule(
        allocation,
        kernels=tuple(numbers),
        launches=tuple(launches),
        setup_us=setup_us,
        refreshed=refreshed,
        levels=tuple(levels),
    )


def _setup(plan: LookingPlan) -> Words:
    """Return the words at the start of a frame: they clear the buckets, reset PIX (the photodiode)
    and store its reset level."""
    scratch = plan.scratch
    # A bus word writes minus the sum of its sources, so one without sources writes 0.
    clear = (op("bus", (a,), (scratch,)) for a in plan.bucket_registers)
    # The reset level, inverted twice. A plan that only copies PIX stores minus the reset level.
    level: Words = (op("bus", (scratch,), ("PIX",)), op("bus", (plan.reference,), (scratch,)))
    if plan.latches:
        level = (op("bus", (plan.reference,), ("PIX",)),)
    return op("bus", (scratch,)), *clear, *RESET, *level


def _kernels(
    items: Sequence[Gate | Op | SetIn], allocation: Allocation, *, apart: bool
) -> list[tuple[int | None, Words]]:
    """Return the kernels (lists of words) of a boundary: pairs (value of IN that is set before,
    words).

    The value of IN (the level sent to all pixels) is None if no item sets it. `items` are the
    boundary's gates, words and values of IN, in order. With `apart`, the gates after the last
    analog word are a kernel of their own."""
    last = max((i for i, item in enumerate(items) if isinstance(item, Op)), default=-1)
    # The gates after the last analog word become kernels of their own.
    if apart and 0 <= last < len(items) - 1:
        head, tail = items[: last + 1], items[last + 1 :]
        return [
            kernel for half in (head, tail) for kernel in _kernels(half, allocation, apart=False)
        ]
    kernels: list[tuple[int | None, Words]] = []
    level: int | None = None
    run: list[Op] = []
    gates: list[Gate] = []

    def settle() -> None:
        """Append the words of the gates collected so far to the kernel (list of words), and forget
        the gates."""
        run.extend(words(Segment(gates) if gates else (), allocation))
        gates.clear()

    for item in items:
        if isinstance(item, Gate):
            gates.append(item)
            continue
        settle()
        if isinstance(item, Op):
            run.append(item)
        elif level is None:
            level = item.level
        # A new value of IN ends the kernel, because IN is set only when a kernel starts.
        elif level != item.level:
            kernels.append((level, tuple(run)))
            run, level = [], item.level
    settle()
    kernels.append((level, tuple(run)))
    return kernels


def _exposure_plan(plan: LookingPlan) -> ExposurePlan:
    """Return the analog words of the analog plan `plan` as an exposure plan, for reports. Reports
    use the exposure plans of programs without senses.

    Its steps are the words at the start of the frame, then those of each moment."""
    steps = [PlanStep(boundary=0, role="setup", bucket=-1, predicate=None, words=_setup(plan))]
    steps += chain.from_iterable(_steps(plan, moment) for moment in plan.moments)
    return ExposurePlan(
        lowering="latch" if plan.latches else "edges",
        steps=tuple(steps),
        registers=plan.registers,
        bucket_registers=plan.bucket_registers,
        shutters=len(plan.program.table.shutters),
        slots=plan.machine.slots,
        analog_writes=_analog_writes(plan),
    )


def _steps(plan: LookingPlan, moment: Moment) -> list[PlanStep]:
    """Return the analog steps of a moment (a boundary with operations) of the analog plan, for
    reports. The steps are comparisons, then for each bucket its closing and opening, then a reset.

    A step has the words that it would need alone; the program may share words between steps."""
    steps: list[PlanStep] = []
    sample = plan.sampled()
    # The word tests whether the sum of its sources, the negative signal and IN, is above 0.
    compare = op("where", (), (*plan.scratched, "IN"))
    for comparison in moment.comparisons:
        steps.append(
            PlanStep(
                boundary=moment.boundary,
                role="look",
                bucket=max(comparison.signal, 0),
                predicate=None,
                words=(sample, compare),
            )
        )
    for bucket, (fall, rise) in enumerate(zip(moment.falls, moment.rises, strict=True)):
        register = plan.bucket_registers[bucket]
        add = sample, op("bus", (register,), plan.scratched)
        if fall:
            steps.append(PlanStep(moment.boundary, "fall", bucket, fall, add))
        if rise:
            steps.append(PlanStep(moment.boundary, "rise", bucket, rise, add))
    if moment.resets:
        steps.append(
            PlanStep(
                boundary=moment.boundary,
                role="reset",
                bucket=-1,
                predicate=moment.resets,
                words=RESET,
            )
        )
    return steps


def _analog_writes(plan: LookingPlan) -> tuple[int, int]:
    """Return the fewest and the most analog words that write a register, over all paths of pixels
    through the state machine.

    The words that set up a frame do not count."""
    machine = plan.machine
    # By node of the state machine; paths begin at the nodes of stage 0.
    least = np.full(len(machine.behaviour), np.iinfo(np.int64).max)
    most = np.zeros(len(machine.behaviour), np.int64)
    least[: machine.first[1]] = 0
    for moment in plan.moments:
        # One word samples each signal; its comparisons write FLAG only.
        signals = {comparison.signal for comparison in moment.comparisons}
        words_ = np.full(len(moment.before), len(signals), np.int64)
        for v in (*moment.falls, *moment.rises):
            # Two words for each bucket that closes or opens: through scratch, and to its register.
            words_ += 2 * np.array([v >> lane & 1 for lane in range(len(words_))], np.int64)
        fewest, largest = least[moment.before] + words_, most[moment.before] + words_
        if (moment.after != moment.before).any():  # several paths may lead to one node
            np.minimum.at(least, moment.after, fewest)
            np.maximum.at(most, moment.after, largest)
        else:
            least[moment.after], most[moment.after] = fewest, largest
    last = machine.nodes(machine.stages - 1)
    return int(least[last].min()), int(most[last].max())


ENCODINGS = {0: (1, 32), 1: (4, 32), 2: (128, 128), 3: (1024, 1024)}
"""For each level of `-O`: the number of encodings to try, and the number if none of these fits."""


def plan_of(program: Program, job: Job) -> tuple[LookingPlan | Misfit, Found]:
    """Return the analog plan of a program with senses, and no errors.

    If there is none, return the reason (Misfit) and the error NS0413 or NS0414. `job` has the
    lowering (a way to compute the exposure) that the user chose."""
    lowering = job.options.lowering
    plan = plan_looks(program, program.machine, lowering)
    if isinstance(plan, Misfit):
        name = "edges" if lowering == "auto" else lowering
        return plan, [fit.plan_fault(program, {name: plan}, lowering)]
    return plan, []


def lowered_of(plan: LookingPlan, job: Job) -> tuple[list[LookingLowered], Found]:
    """Return the words of the analog plan of a program with senses for several encodings, best
    first, and no errors.

    If no encoding works, return [] and the error NS0502, with the first reasons and the last. `job`
    has the level of `-O`, which limits the number of encodings, and the limit of words at a
    boundary."""
    program = plan.program
    registers = len(program.target.digital_registers)
    time = frame_time(program)
    lowerings: list[LookingLowered] = []
    reasons: dict[str, None] = {}
    level, most_words = job.options.level, job.options.max_words_per_slot
    enough, most = ENCODINGS[level]
    for count, encoding in enumerate(encodings(plan.machine, registers)):
        if count >= (enough if any(candidate.fits for candidate in lowerings) else most):
            break
        try:
            solution = Solver(plan, encoding, program.target).solve()
        except GaveUp as given_up:
            reasons[f"{encoding.name}: {given_up}"] = None
            continue
        lowered = lay_out_looks(plan, solution, time, most_words)
        if lowered is None:
            reasons[f"{encoding.name}: the mask would lose what its register holds"] = None
        else:
            lowerings.append(lowered)
    lowerings.sort(
        key=lambda candidate: (candidate.price, len(candidate.schedule.allocation.chip_registers))
    )
    if not lowerings:
        # Four reasons suffice: further encodings fail for similar ones. The last may fit best.
        shown = [*list(reasons)[:3], *list(reasons)[3:][-1:]]
        return [], [fit.looking_fault(program, shown, level=level)]
    return lowerings, []


def container_of(lowered: Lowered, level: int) -> Container:
    """Return the container (a compiled program) of a lowered program with senses; `level` is that
    of `-O`.

    It has the state machine and the registers of each state that is read or kept."""
    assert isinstance(lowered, LookingLowered)
    looking, machine = lowered.looking, lowered.program.machine
    chip_registers = lowered.schedule.allocation.chip_registers
    planes = {}
    encoded_states = zip(machine.states, looking.encoding.states, looking.registers, strict=True)
    for state, how, names in encoded_states:
        if state.read or state.is_kept:
            registers = tuple(chip_registers[name] for name in names)
            planes[state.name] = StatePlanes(registers, how.values, how.bits)
    return replace(assemble(lowered, level), machine=machine, state_planes=planes)
