"""What must be true of a value between two passes; where it is not, the compiler is at fault.

Each check is cheap beside the pass that made its value, and shares nothing with it.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nscc.logic.problem import Gate, Machine
from nscc.logic.replay import fault
from nscc.lower.gates import Gated
from nscc.lower.lowered import Choice
from nscc.lower.plan import ExposurePlan, Planned
from nscc.operations import Effect, Op
from nscc.program.program import Program
from nscc.prove.proof import Proof
from nscc.source import Source
from nscc.syntax.tree import File
from nscc.truth import members
from nscc.words.container import Container

if TYPE_CHECKING:
    from nscc.looks.passes import LookingLowered
    from nscc.looks.plan import LookingPlan, Moment
    from nscc.stream.sending import Sending
    from nscc.words.machine import Machine as StateMachine

_ROUNDING = 1e-9
"""Part of a time by which sums of decimal fractions may differ."""


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
            _require(gathered == list(opens), f"{plan.lowering} collects the light of other slots")


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


def check_looking_plan(plan: LookingPlan) -> None:
    """Every change of a node's open buckets is a moment that closes and opens these buckets."""
    machine = plan.machine
    boundaries = [moment.boundary for moment in plan.moments]
    _require(boundaries == sorted(set(boundaries)), "times are not in order")
    inner = machine.opens[:, :, 1:] != machine.opens[:, :, :-1]
    for stage in range(machine.stages):
        changed = np.flatnonzero(inner[machine.nodes(stage)].any(axis=(0, 1))) + 1
        begin, end = machine.starts(stage), machine.ends(stage)
        changed = changed[(begin < changed) & (changed < end)]
        _require({*boundaries}.issuperset(changed.tolist()), "a change without a time")
    for moment in plan.moments:
        _check_moment(moment, machine)


def _check_moment(moment: Moment, machine: StateMachine) -> None:
    """Buckets that were open, less those that close and with those that open, are open then."""
    _require(moment.comparisons == machine.at(moment.boundary), "other comparisons")
    lanes, boundary = len(moment.before), moment.boundary
    reset = _lanes(moment.resets, lanes)
    for bucket, (falls, rises) in enumerate(zip(moment.falls, moment.rises, strict=True)):
        was = machine.opens[moment.before, bucket, boundary - 1]
        inside = boundary < machine.slots
        becomes = machine.opens[moment.after, bucket, boundary] if inside else np.zeros_like(was)
        found = was & ~_lanes(falls, lanes) | _lanes(rises, lanes)
        wanted = np.where(reset, False, becomes)
        _require(np.array_equal(found, wanted), f"bucket {bucket} is open in other pixels")


def _lanes(vector: int, lanes: int) -> NDArray[np.bool_]:
    found = np.zeros(lanes, np.bool_)
    found[members(vector, lanes)] = True
    return found


def check_looking_gates(tried: Sequence[LookingLowered]) -> None:
    """Codes and states can be told apart, and each comparison is made at its moment."""
    for lowered in tried:
        solution, machine = lowered.looking, lowered.program.machine
        assert solution is not None
        assert machine is not None
        for held in (solution.encoding.code, *solution.encoding.states):
            rows = np.unique(held.bits, axis=0) if held.registers else held.bits
            _require(len(rows) == len(held.bits), f"{held.name}: two values with the same bits")
        names = {
            *(f"p{i}" for i in range(len(solution.planes))),
            *solution.states,
            *(f"s{i}" for i in range(len(solution.states))),
            *(f"t{i}" for i in range(solution.scratch)),
            "FLAG",
        }
        for boundary, items in solution.items.items():
            gates = [item for item in items if isinstance(item, Gate)]
            used = {name for gate in gates for name in (gate.destination, *gate.sources)}
            _require(names >= used, f"unknown registers: {sorted(used - names)}")
            made = sum(
                isinstance(item, Op) and item.operation.effect is Effect.FLAG_ANALOG
                for item in items
            )
            _require(made == len(machine.at(boundary)), "a comparison that no word makes")


def check_route(sending: Sending) -> None:
    """The light of every slot goes to the tap of the bucket that is open, or to no bucket's."""
    route, shutters = sending.route, sending.program.table.shutters
    place = np.where(route.bits, route.ones, route.zeros)[:, None]
    taken = place == np.arange(shutters.shape[1])[:, None]
    _require(np.array_equal(taken, shutters), "light goes to the tap of another bucket")


def check_loadings(sending: Sending) -> None:
    """Every plane is loaded, as long as its rows take, before it acts and before the next one."""
    load_us, begin_us = sending.program.target.plane_load_us, 0.0
    ended_us = -inf
    for slot_us, loading in zip(sending.program.frame.slot_us, sending.loadings, strict=True):
        slack = _ROUNDING * max(1.0, begin_us + slot_us)
        _require(loading.load_us >= ended_us - slack, "two planes are loaded at once")
        ended_us = loading.load_us + load_us
        _require(ended_us <= loading.acts_us + slack, "a plane acts before it is loaded")
        _require(begin_us <= loading.acts_us + slack, "a plane acts in an earlier slot")
        begin_us += slot_us
        _require(loading.acts_us < begin_us, "a plane acts after its slot")


def check_schedule(choice: Choice) -> None:
    """Every layout launches its kernels in time and names registers that the chip has."""
    for lowered in choice.tried:
        schedule, target, slots = lowered.schedule, lowered.program.target, lowered.plan.slots
        places = schedule.allocation.places
        _require(len(set(places.values())) == len(places), "two holders of one register")
        boundaries = [boundary for boundary, _ in schedule.launches]
        _require(boundaries == sorted(boundaries), "launches are not in order")
        _require(boundaries[0] == 0 and boundaries[-1] <= slots, "a launch out of time")
        used = {kernel for _, kernel in schedule.launches}
        _require(used == set(range(len(schedule.kernels))), "a kernel that is never launched")
        own = {*target.digital_registers, *target.analog_registers, "FLAG", "PIX"}
        for word in {word for kernel in schedule.kernels for word in kernel}:
            _require(
                own.issuperset(word.destinations), f"a word that the chip does not have: {word}"
            )


def check_words(container: Container) -> None:
    """Every shutter has an encoding, every bucket a readout, every launch a kernel."""
    shape = len(container.table.shutters), len(container.target.digital_registers)
    _require(container.encoding.shape == shape, "an encoding of other shutters")
    read = [readout.bucket for readout in container.readouts]
    _require(sorted(read) == sorted(container.buckets), "a bucket that is not read out")
    kernels = range(len(container.kernels))
    _require(
        all(each.kernel in kernels for each in container.launches), "a launch of an unknown kernel"
    )


def check_proof(proof: Proof) -> None:
    """The words do what the decode table says."""
    _require(proof.holds, f"the proof fails: {proof.failure}")


def _require(holds: bool, otherwise: str) -> None:
    if not holds:
        raise Inconsistent(otherwise)
