"""What must be true of a value between two passes; where it is not, the compiler is at fault.

Each check is cheap beside the pass that made its value, and shares nothing with it.
"""

from __future__ import annotations

from nscc.logic.problem import Machine
from nscc.logic.replay import fault
from nscc.lower.gates import Gated
from nscc.lower.lowered import Choice
from nscc.lower.plan import ExposurePlan, Planned
from nscc.program.program import Program
from nscc.prove.proof import Proof
from nscc.source import Source
from nscc.syntax.tree import File
from nscc.words.container import Container


class Inconsistent(Exception):
    """A pass made a value that is not what it promises: a fault of the compiler."""


def check_tree(source: Source, tree: File) -> None:
    """The statements lie in the text, one behind the other."""
    end = 0
    for statement in tree.statements:
        _require(end <= statement.span.start <= statement.span.end, "statements overlap")
        end = statement.span.end
    _require(end <= len(source.text), "a statement beyond the text")


def check_program(program: Program) -> None:
    """The decode table has one row for each code, and shutters of the frame and its buckets."""
    table = program.table
    _, buckets, slots = table.shutters.shape
    _require(len(table.codes) == len(table.shutter_of_code), "a code without a shutter")
    _require(slots == len(program.frame.slot_us), "shutters of another frame")
    _require(buckets == len(program.buckets), "shutters of other buckets")
    if program.pixel_codes is not None:
        _require(int(program.pixel_codes.max()) < len(table.codes), "a pixel without a code")


def check_plans(planned: Planned) -> None:
    """Every plan's predicates, played through the frame, are the shutters."""
    for plan in planned.plans:
        for bucket, opens in enumerate(planned.opens):
            gathered = _gathered(plan, bucket, opens[0])
            _require(gathered == list(opens), f"{plan.lowering} gathers other slots' light")


def _gathered(plan: ExposurePlan, bucket: int, first: int) -> list[int]:
    """For each slot, the shutters whose pixels keep its light; `first` are those open in slot 0."""
    at = {
        (s.boundary, s.role): plan.everywhere if s.predicate is None else s.predicate
        for s in plan.steps
        if s.bucket == bucket
    }
    slots = range(plan.slots)
    match plan.lowering:
        case "accumulate":
            return [at.get((n + 1, "open"), 0) for n in slots]
        case "latch":
            # The last copy is what stays, and holds the light of all slots before it.
            copied = 0
            kept = [copied := copied | at.get((n + 1, "open"), 0) for n in reversed(slots)]
            return kept[::-1]
        case "edges":
            # PIX starts at the reset level: pixels open from slot 0 on need no rise.
            now = first
            kept = []
            for n in slots:
                now = now & ~at.get((n, "fall"), 0) | at.get((n, "rise"), 0)
                kept.append(now)
            _require(at.get((plan.slots, "fall"), 0) == now, "a shutter is never read")
            return kept


def check_gates(gated: Gated) -> None:
    """Every solution, replayed on truth vectors, meets its demands."""
    machine = Machine.of(gated.program.target)
    for decoding in gated.tried:
        wrong = fault(decoding.problem, machine, decoding.solution)
        _require(wrong is None, f"{decoding.solution.encoding}: {wrong}")


def check_schedule(choice: Choice) -> None:
    """Every layout launches its kernels in time and names registers that the chip has."""
    for lowered in choice.tried:
        schedule, target, slots = lowered.schedule, lowered.program.target, lowered.plan.slots
        places = schedule.allocation.places
        _require(len(set(places.values())) == len(places), "two holders of one register")
        boundaries = [boundary for boundary, _ in schedule.launches]
        _require(boundaries == sorted(boundaries), "launches out of their order")
        _require(boundaries[0] == 0 and boundaries[-1] <= slots, "a launch out of time")
        used = {kernel for _, kernel in schedule.launches}
        _require(used == set(range(len(schedule.kernels))), "a kernel that is never launched")
        own = {*target.digital_registers, *target.analog_registers, "FLAG", "PIX"}
        for word in {word for kernel in schedule.kernels for word in kernel}:
            _require(own.issuperset(word.destinations), f"a word that the chip has not: {word}")


def check_words(container: Container) -> None:
    """Every shutter has an encoding, every bucket a readout, every launch a kernel."""
    shape = len(container.table.shutters), len(container.target.digital_registers)
    _require(container.encoding.shape == shape, "an encoding of other shutters")
    read = [readout.bucket for readout in container.readouts]
    _require(sorted(read) == sorted(container.buckets), "a bucket that is not read out")
    kernels = range(len(container.kernels))
    _require(all(each.kernel in kernels for each in container.launches), "a launch of no kernel")


def check_proof(proof: Proof) -> None:
    """The words do what the decode table says."""
    _require(proof.holds, f"the proof fails: {proof.failure}")


def _require(holds: bool, otherwise: str) -> None:
    if not holds:
        raise Inconsistent(otherwise)
