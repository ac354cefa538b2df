"""Consistency checks between two passes; a failed check is a bug of the compiler.

A check takes little time compared with the pass, and shares no code with it."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nscc.logic.problem import Gate, Machine
from nscc.logic.replay import fault
from nscc.lower.exposure_plan import ExposurePlan, Planned
from nscc.lower.gates import Gated
from nscc.lower.lowered import Choice
from nscc.operations import Op, WordEffect
from nscc.program.program import Program
from nscc.prove.proof import Proof
from nscc.source import Source
from nscc.syntax.tree import File
from nscc.truth import members
from nscc.words.container import Container

if TYPE_CHECKING:
    from nscc.looks.looking_plan import LookingPlan
    from nscc.looks.passes import LookingLowered
    from nscc.stream.passes import Sending

_ROUNDING = 1e-9
"""Relative tolerance for times, which are sums of decimal fractions."""


class Inconsistent(Exception):
    """Raised if the output of a pass violates its invariants: a bug of the compiler."""


def check_tree(source: Source, tree: File) -> None:
    """Check that statements lie inside the text and do not overlap."""
    end = 0
    for statement in tree.statements:
        _require(end <= statement.span.start <= statement.span.end, "statements overlap")
        end = statement.span.end
    _require(end <= len(source.text), "a statement beyond the text")


def check_program(program: Program) -> None:
    """Check that the decode table has a shutter for each code, with the frame's slots and
    buckets."""
    table = program.table
    _, buckets, slots = table.shutters.shape
    _require(len(table.codes) == len(table.shutter_of_code), "a code without a shutter")
    _require(slots == len(program.frame.slot_us), "shutters of another frame")
    _require(buckets == len(program.buckets), "shutters of other buckets")
    if program.pixel_codes is not None:
        _require(int(program.pixel_codes.max()) < len(table.codes), "a pixel without a code")


def check_plans(planned: Planned) -> None:
    """Check that the predicates of every plan reproduce the shutters."""
    for plan in planned.plans:
        for bucket, opens in enumerate(planned.opens):
            gathered = _gathered(plan, bucket, opens[0])
            _require(gathered == list(opens), f"{plan.lowering} collects the light of other slots")


def _gathered(plan: ExposurePlan, bucket: int, first: int) -> list[int]:
    """Return for each slot the set of shutters whose light is collected, as a truth vector.

    `first` is the set of shutters that are open in slot 0."""
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
            # The last copy remains, and holds the light of all slots before it.
            copied = 0
            kept_by = [copied := copied | at.get((n + 1, "open"), 0) for n in reversed(slots)]
            return kept_by[::-1]
        case "edges":
            # PIX starts at the reset level, so pixels open from slot 0 on need no rise.
            now = first
            kept_by = []
            for n in slots:
                now = now & ~at.get((n, "fall"), 0) | at.get((n, "rise"), 0)
                kept_by.append(now)
            _require(at.get((plan.slots, "fall"), 0) == now, "a shutter is never read")
            return kept_by


def check_gates(gated: Gated) -> None:
    """Replay every solution on truth vectors and check that it meets its demands."""
    machine = Machine.of(gated.program.target)
    for decoding in gated.decodings:
        fault_text = fault(decoding.problem, machine, decoding.solution)
        _require(fault_text is None, f"{decoding.solution.encoding}: {fault_text}")


def check_looking_plan(plan: LookingPlan) -> None:
    """Check that every change of a node's open buckets is a moment that opens or closes these
    buckets."""
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
        # The open buckets before a moment, minus `falls`, plus `rises`, are those after it.
        _require(moment.comparisons == machine.at(moment.boundary), "other comparisons")
        lanes, boundary = len(moment.before), moment.boundary
        reset = _lanes(moment.resets, lanes)
        for bucket, (falls, rises) in enumerate(zip(moment.falls, moment.rises, strict=True)):
            was = machine.opens[moment.before, bucket, boundary - 1]
            inside = boundary < machine.slots
            becomes = (
                machine.opens[moment.after, bucket, boundary] if inside else np.zeros_like(was)
            )
            computed = was & ~_lanes(falls, lanes) | _lanes(rises, lanes)
            expected = np.where(reset, False, becomes)
            _require(np.array_equal(computed, expected), f"bucket {bucket} is open in other pixels")


def _lanes(vector: int, lanes: int) -> NDArray[np.bool_]:
    flags = np.zeros(lanes, np.bool_)
    flags[members(vector, lanes)] = True
    return flags


def check_looking_gates(lowerings: Sequence[LookingLowered]) -> None:
    """Check that encodings are injective, and that every comparison is made at its boundary."""
    for lowered in lowerings:
        solution, machine = lowered.looking, lowered.program.machine
        assert solution is not None
        for value_bits in (solution.encoding.code, *solution.encoding.states):
            distinct = {row.tobytes() for row in value_bits.bits}
            _require(
                len(distinct) == len(value_bits.bits) or not value_bits.registers,
                f"{value_bits.name}: two values with the same bits",
            )
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
            comparison_count = sum(
                isinstance(item, Op) and item.operation.effect is WordEffect.FLAG_ANALOG
                for item in items
            )
            _require(
                comparison_count == len(machine.at(boundary)), "a comparison that no word makes"
            )


def check_route(sending: Sending) -> None:
    """Check that in every slot the light goes to the tap of the open bucket.

    If no bucket is open, the light must go to the drain or to a tap without a bucket."""
    route, shutters = sending.route, sending.program.table.shutters
    place = np.where(route.bits, route.ones, route.zeros)[:, None]
    collected = place == np.arange(shutters.shape[1])[:, None]
    _require(np.array_equal(collected, shutters), "light goes to the tap of another bucket")


def check_loadings(sending: Sending) -> None:
    """Check that every plane is completely loaded before it acts and before the next one loads."""
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
    """Check that kernels are launched at increasing boundaries and name registers of the chip."""
    for lowered in choice.lowerings:
        schedule, target, slots = lowered.schedule, lowered.program.target, lowered.plan.slots
        places = schedule.allocation.places
        _require(len(set(places.values())) == len(places), "two holders of one register")
        boundaries = [boundary for boundary, _ in schedule.launches]
        _require(boundaries == sorted(boundaries), "launches are not in order")
        _require(boundaries[0] == 0 and boundaries[-1] <= slots, "a launch out of time")
        used = {kernel for _, kernel in schedule.launches}
        _require(used == set(range(len(schedule.kernels))), "a kernel that is never launched")
        registers = {*target.digital_registers, *target.analog_registers, "FLAG", "PIX"}
        for word in {word for kernel in schedule.kernels for word in kernel}:
            _require(
                registers.issuperset(word.destinations),
                f"a word that the chip does not have: {word}",
            )


def check_words(container: Container) -> None:
    """Check that every shutter has an encoding, every bucket a readout and every launch a
    kernel."""
    shape = len(container.table.shutters), len(container.target.digital_registers)
    _require(container.encoding.shape == shape, "an encoding of other shutters")
    read = [readout.bucket for readout in container.readouts]
    _require(sorted(read) == sorted(container.buckets), "a bucket that is not read out")
    kernels = range(len(container.kernels))
    _require(
        all(launch.kernel in kernels for launch in container.launches),
        "a launch of an unknown kernel",
    )


def check_proof(proof: Proof) -> None:
    """Check that the proof of the words holds."""
    _require(proof.holds, f"the proof fails: {proof.failure}")


def _require(holds: bool, otherwise: str) -> None:
    if not holds:
        raise Inconsistent(otherwise)
