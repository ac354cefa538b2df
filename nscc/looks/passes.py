"""Compiler passes for programs with senses; `nscc.pipeline` lists all passes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nscc.diagnostics.diagnostic import Diagnostic
from nscc.logic.problem import GaveUp
from nscc.looks.encode import encodings
from nscc.looks.looking_plan import LookingPlan, plan_looks
from nscc.looks.solve import solve
from nscc.looks.word_layout import LookingLowered, lay_out_looks
from nscc.lower import fit
from nscc.lower.exposure_plan import LoweringOption, Misfit, frame_time
from nscc.lower.lowered import Lowered, assemble
from nscc.program.program import Program
from nscc.words.container import Container
from nscc.words.machine import StatePlanes

ENCODINGS = {0: (1, 32), 1: (4, 32), 2: (128, 128), 3: (1024, 1024)}
"""For each level the number of encodings to try, and the largest number until one fits."""


def plan_of(
    program: Program, lowering: LoweringOption
) -> tuple[LookingPlan | Misfit, Sequence[Diagnostic]]:
    """Return the plan and no errors, or a Misfit and the error NS0413 or NS0414."""
    assert program.machine is not None
    plan = plan_looks(program, program.machine)
    if isinstance(plan, Misfit):
        return plan, [fit.plan_fault(program, {"edges": plan})]
    if lowering == "accumulate":
        reason = Misfit(
            "accumulate resets PIX in every slot, but `light` needs its charge since the last reset"
        )
        return reason, [fit.plan_fault(program, {lowering: reason})]
    return plan, []


def lowered_of(
    plan: LookingPlan, level: int, most_words: int | None
) -> tuple[list[LookingLowered], Sequence[Diagnostic]]:
    """Return lowerings with several encodings, best first, and errors (NS0502 if none was
    found)."""
    program = plan.program
    registers = len(program.target.digital_registers)
    time = frame_time(program)
    lowerings: list[LookingLowered] = []
    reasons: dict[str, None] = {}
    enough, most = ENCODINGS[level]
    for count, encoding in enumerate(encodings(plan.machine, registers)):
        if count >= (enough if any(candidate.fits for candidate in lowerings) else most):
            break
        try:
            solution = solve(plan, encoding, program.target)
        except GaveUp as given_up:
            reasons[f"{encoding.name}: {given_up}"] = None
            continue
        lowered = lay_out_looks(plan, solution, time, most_words)
        if lowered is None:
            reasons[f"{encoding.name}: the mask would lose what its register holds"] = None
        else:
            lowerings.append(lowered)
    lowerings.sort(
        key=lambda candidate: (candidate.price, len(candidate.schedule.allocation.places))
    )
    if not lowerings:
        return [], [fit.looking_fault(program, list(reasons)[:4], level=level)]
    return lowerings, []


def container_of(lowered: Lowered, level: int) -> Container:
    """Return the container, with its state machine and the encodings of states."""
    assert isinstance(lowered, LookingLowered)
    assert lowered.looking is not None
    looking, machine = lowered.looking, lowered.program.machine
    places = lowered.schedule.allocation.places
    assert machine is not None
    planes = {}
    encoded_states = zip(machine.states, looking.encoding.states, looking.registers, strict=True)
    for state, how, names in encoded_states:
        if state.read or state.is_kept:
            registers = tuple(places[name] for name in names)
            planes[state.name] = StatePlanes(registers, how.values, how.bits)
    return replace(assemble(lowered, level), machine=machine, state_planes=planes)
