"""The passes of programs that look, as `nscc.pipeline` lists them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from nscc.diagnostics.diagnostic import Diagnostic
from nscc.logic.problem import GaveUp
from nscc.looks.encode import Encoding, encodings
from nscc.looks.layout import lay_out_looks
from nscc.looks.plan import LookingPlan, plan_looks
from nscc.looks.solve import LookingSolution, solve
from nscc.lower import fit
from nscc.lower.assemble import assemble
from nscc.lower.lowered import Lowered
from nscc.lower.plan import LoweringOption, Misfit, frame_time
from nscc.program.program import Program
from nscc.words.container import Container
from nscc.words.machine import StatePlanes

ENCODINGS = {0: (1, 32), 1: (4, 32), 2: (128, 128), 3: (1024, 1024)}
"""So many encodings are tried at each level, and so many until one fits."""


@dataclass(frozen=True)
class LookingLowered(Lowered):
    """A lowering whose container carries a machine."""

    looking: LookingSolution | None = None


def plan_of(
    program: Program, lowering: LoweringOption
) -> tuple[LookingPlan | Misfit, Sequence[Diagnostic]]:
    """The plan, or NS0413 or NS0414."""
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
    """Lowerings with several encodings, the best first, or NS0502."""
    program = plan.program
    registers = len(program.target.digital_registers)
    time = frame_time(program)
    found: list[LookingLowered] = []
    reasons: dict[str, None] = {}
    enough, most = ENCODINGS[level]
    for tried, encoding in enumerate(encodings(plan.machine, registers)):
        if tried >= (enough if any(each.fits for each in found) else most):
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
            found.append(_with(lowered, solution))
    found.sort(key=lambda each: (each.price, len(each.schedule.allocation.places)))
    if not found:
        return [], [fit.looking_fault(program, list(reasons)[:4], level=level)]
    return found, []


def _with(lowered: Lowered, solution: LookingSolution) -> LookingLowered:
    return LookingLowered(
        lowered.program, lowered.decoding, lowered.schedule, lowered.time, lowered.most_words,
        solution,
    )  # fmt: skip


def container_of(lowered: Lowered, level: int) -> Container:
    """The container, with its machine and how registers hold its states."""
    assert isinstance(lowered, LookingLowered)
    assert lowered.looking is not None
    machine = lowered.program.machine
    assert machine is not None
    return replace(
        assemble(lowered, level),
        machine=machine,
        state_planes=_state_planes(lowered, lowered.looking.encoding),
    )


def _state_planes(lowered: LookingLowered, encoding: Encoding) -> dict[str, StatePlanes]:
    machine, places = lowered.program.machine, lowered.schedule.allocation.places
    assert machine is not None
    assert lowered.looking is not None
    found = {}
    held = zip(machine.states, encoding.states, lowered.looking.registers, strict=True)
    for state, how, names in held:
        if state.read or state.kept:
            registers = tuple(places[name] for name in names)
            found[state.name] = StatePlanes(registers, how.values, how.bits)
    return found
