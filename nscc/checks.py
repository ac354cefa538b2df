"""Consistency checks between two passes; a failed check is a bug of the compiler.

A check takes little time compared with the pass, and shares no code with it."""

from __future__ import annotations

from nscc.logic.problem import Machine
from nscc.logic.replay import fault
from nscc.lower.exposure_plan import ExposurePlan, Planned
from nscc.lower.gates import Gated
from nscc.lower.lowered import Choice
from nscc.program.program import Program
from nscc.prove.proof import Proof
from nscc.source import Source
from nscc.syntax.tree import File
from nscc.words.container import Container
from nscc.words.soundness import faults


class Inconsistent(Exception):
    """Raised if the output of a pass violates its invariants: a bug of the compiler."""


def check_tree(source: Source, tree: File) -> None:
    """Check that all statements of `tree` lie inside the text `source`, in order and without
    overlap; raise Inconsistent if not."""
    end = 0
    for statement in tree.statements:
        require(end <= statement.span.start <= statement.span.end, "statements overlap")
        end = statement.span.end
    require(end <= len(source.text), "a statement beyond the text")


def check_program(program: Program) -> None:
    """Check the decode table and the pixel codes of a program; raise Inconsistent if they are
    wrong.

    The table must have a shutter for each code, with the frame's slots and buckets, and every pixel
    a code of the table."""
    table = program.table
    _, buckets, slots = table.shutters.shape
    require(len(table.codes) == len(table.shutter_of_code), "a code without a shutter")
    require(slots == len(program.frame.slot_us), "shutters of another frame")
    require(buckets == len(program.buckets), "shutters of other buckets")
    if program.pixel_codes is not None:
        require(int(program.pixel_codes.max()) < len(table.codes), "a pixel without a code")


def check_plans(planned: Planned) -> None:
    """Check that each exposure plan of `planned` collects in every bucket the light of exactly the
    open slots. Raise Inconsistent if a plan collects the light of other slots. An exposure plan
    says which analog words run at which boundary."""
    for plan in planned.plans:
        for bucket, opens in enumerate(planned.opens):
            gathered = _gathered(plan, bucket, opens[0])
            require(gathered == list(opens), f"{plan.lowering} collects the light of other slots")


def _gathered(plan: ExposurePlan, bucket: int, first: int) -> list[int]:
    """Return for each slot the shutters whose light the exposure plan `plan` collects in bucket
    number `bucket`. A set of shutters is a truth vector: an integer with one bit for each shutter.

    `first` are the shutters that are open in slot 0, also as a truth vector. Raises Inconsistent if
    the light of a shutter is never read."""
    shutters_at = {
        (s.boundary, s.role): plan.everywhere if s.predicate is None else s.predicate
        for s in plan.steps
        if s.bucket == bucket
    }
    slots = range(plan.slots)
    match plan.lowering:
        case "accumulate":
            return [shutters_at.get((n + 1, "open"), 0) for n in slots]
        case "latch":
            # The last copy remains, and holds the light of all slots before it.
            # Backwards in time: `copied` are the shutters with a copy after slot n.
            copied = 0
            from_the_end = [
                copied := copied | shutters_at.get((n + 1, "open"), 0) for n in reversed(slots)
            ]
            return from_the_end[::-1]
        case "edges":
            # PIX starts at the reset level, so pixels open from slot 0 on need no rise.
            is_open = first
            collected = []
            for n in slots:
                is_open = is_open & ~shutters_at.get((n, "fall"), 0) | shutters_at.get(
                    (n, "rise"), 0
                )
                collected.append(is_open)
            # A shutter that is open in the last slot closes at the end of the frame.
            require(shutters_at.get((plan.slots, "fall"), 0) == is_open, "a shutter is never read")
            return collected


def check_gates(gated: Gated) -> None:
    """Check every solution of `gated` by replaying its gates on truth vectors (integers with one
    bit for each shutter); raise Inconsistent if it fails its demands."""
    machine = Machine.of(gated.program.target)
    for decoding in gated.decodings:
        fault_text = fault(decoding.problem, machine, decoding.solution)
        require(fault_text is None, f"{decoding.solution.encoding}: {fault_text}")


def check_schedule(choice: Choice) -> None:
    """Check the kernels (lists of words) of all lowerings (ways to compute the exposure) of
    `choice`, and when they start; raise Inconsistent if they are wrong.

    Kernels must start in the order of boundaries, each at least once, and name only registers of
    the chip."""
    for lowered in choice.lowerings:
        schedule, target, slots = lowered.schedule, lowered.program.target, lowered.plan.slots
        chip_registers = schedule.allocation.chip_registers
        require(
            len(set(chip_registers.values())) == len(chip_registers), "two holders of one register"
        )
        boundaries = [boundary for boundary, _ in schedule.launches]
        require(boundaries == sorted(boundaries), "launches are not in order")
        require(boundaries[0] == 0 and boundaries[-1] <= slots, "a launch out of time")
        used = {kernel for _, kernel in schedule.launches}
        require(used == set(range(len(schedule.kernels))), "a kernel that is never launched")
        registers = {*target.digital_registers, *target.analog_registers, "FLAG", "PIX"}
        for word in {word for kernel in schedule.kernels for word in kernel}:
            require(
                registers.issuperset(word.destinations),
                f"a word that the chip does not have: {word}",
            )


def check_words(container: Container) -> None:
    """Check that a container is consistent: every index, shape and name in it; raise Inconsistent
    if not."""
    for text in faults(container):
        require(False, text)


def check_proof(proof: Proof) -> None:
    """Raise Inconsistent if the proof of the words has failed."""
    require(proof.holds, f"the proof fails: {proof.failure}")


def require(holds: bool, otherwise: str) -> None:
    """Raise Inconsistent with the text `otherwise` unless a condition holds."""
    if not holds:
        raise Inconsistent(otherwise)
