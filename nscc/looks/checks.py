"""Consistency checks between the passes for programs with senses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nscc.arrays import Bools
from nscc.checks import require
from nscc.logic.problem import Gate
from nscc.looks.looking_plan import LookingPlan
from nscc.looks.passes import LookingLowered
from nscc.operations import Op, WordEffect
from nscc.truth import members


def check_looking_plan(plan: LookingPlan) -> None:
    """Check that the analog plan of a program with senses opens and closes shutters exactly where
    the program's state machine does.

    Raises Inconsistent, which is a fault of nscc, if the moments are not in order, a change of
    shutters has no moment, or a moment has other changes or comparisons."""
    machine = plan.machine
    boundaries = [moment.boundary for moment in plan.moments]
    require(boundaries == sorted(set(boundaries)), "times are not in order")
    inner = machine.opens[:, :, 1:] != machine.opens[:, :, :-1]
    for stage in range(machine.stages):
        changed = np.flatnonzero(inner[machine.nodes(stage)].any(axis=(0, 1))) + 1
        begin, end = machine.starts(stage), machine.ends(stage)
        changed = changed[(begin < changed) & (changed < end)]
        require({*boundaries}.issuperset(changed.tolist()), "a change without a time")
    for moment in plan.moments:
        # The open buckets before a moment, minus `falls`, plus `rises`, are those after it.
        require(moment.comparisons == machine.at(moment.boundary), "other comparisons")
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
            require(np.array_equal(computed, expected), f"bucket {bucket} is open in other pixels")


def _lanes(vector: int, lanes: int) -> Bools:
    """Return a truth vector (an integer with one bit for each lane, the lowest for lane 0) as an
    array, bool (lanes,). A lane is a simulated pixel."""
    flags = np.zeros(lanes, np.bool_)
    flags[members(vector, lanes)] = True
    return flags


def check_looking_gates(lowerings: Sequence[LookingLowered]) -> None:
    """Check the gates of lowered programs with senses.

    Raises Inconsistent, which is a fault of nscc, if two values of a state have the same bits, a
    gate uses an unknown register, or a boundary has another number of comparisons than the program.
    """
    for lowered in lowerings:
        solution, machine = lowered.looking, lowered.program.machine
        # Values of one state must be told apart by their bits.
        for value_bits in (solution.encoding.code, *solution.encoding.states):
            distinct = {row.tobytes() for row in value_bits.bits}
            require(
                len(distinct) == len(value_bits.bits) or not value_bits.registers,
                f"{value_bits.name}: two values with the same bits",
            )
        # All registers that gates may use: planes, states, scratch registers and FLAG.
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
            require(names >= used, f"unknown registers: {sorted(used - names)}")
            # Each comparison of the program needs one word that compares, at its boundary.
            comparison_count = sum(
                isinstance(item, Op) and item.operation.effect is WordEffect.FLAG_ANALOG
                for item in items
            )
            require(
                comparison_count == len(machine.at(boundary)), "a comparison that no word makes"
            )
