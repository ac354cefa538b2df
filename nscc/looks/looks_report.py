"""Descriptions of programs with senses: plan, gates, report and summary."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.emit.listing import segment_lines
from nscc.looks.looking_plan import LookingPlan
from nscc.looks.passes import LookingLowered
from nscc.mappings import JsonObject
from nscc.program.program import Program
from nscc.words.machine import LIGHT

_MOST_SHOWN = 12
"""Most boundaries listed for a level."""


def moments_text(plan: LookingPlan) -> str:
    """Return the analog registers and, for each boundary, its comparisons and numbers of changes,
    as lines of text.

    The changes are shutters that close ("fall") or open ("rise") and resets ("reset"), counted over
    the lanes: pairs of a node of the state machine and an outcome. A lane is a simulated pixel."""
    lines = [f"{register:<5} {holder}" for register, holder in plan.registers.items()]
    for moment in plan.moments:
        changes = [("fall", v) for v in moment.falls] + [("reset", moment.resets)]
        changes += [("rise", v) for v in moment.rises]
        texts = [f"where above {comparison.level} steps" for comparison in moment.comparisons]
        texts += [f"{kind} in {v.bit_count()} of {len(moment.before)}" for kind, v in changes if v]
        lines.append(f"boundary {moment.boundary:>4} {'; '.join(texts)}")
    return "\n".join(lines) + "\n"


def looking_gates_text(lowered: LookingLowered) -> str:
    """Return the gates and words of every boundary as lines of text, after the encoding and the
    chip's register of each virtual register."""
    solution, chip_registers = lowered.looking, lowered.schedule.allocation.chip_registers
    lines = [f"encoding: {solution.encoding.name}"]
    lines += [
        f"  p{i} in {chip_registers[f'p{i}']}: {text}" for i, text in enumerate(solution.holders)
    ]
    lines += [f"  {v} in {r}: scratch or state" for v, r in chip_registers.items() if v[0] in "ts"]
    for boundary, items in solution.items.items():
        segment_lines(lines, f"boundary {boundary}", (items,))
    return "\n".join(lines) + "\n"


def all_gates_text(layouts: Sequence[LookingLowered]) -> str:
    """Return the gates and words of all lowerings (ways to compute the exposure) of a program, one
    after the other."""
    return "".join(map(looking_gates_text, layouts))


def looks_report(program: Program) -> JsonObject:
    """Return the comparisons and states of a program as JSON values, for `--emit report`.

    Keys are `boundaries` (those with comparisons), `comparisons`, `states`, and `nodes`, the number
    of nodes of the state machine. The signal of a comparison is "light" or the index of a bucket.
    """
    machine, target = program.machine, program.target
    return {
        "boundaries": list(machine.looks),
        "comparisons": [
            {
                "boundary": comparison.boundary,
                "signal": "light" if comparison.signal == LIGHT else comparison.signal,
                "steps": comparison.level,
                "level_e": comparison.level * target.electrons_per_step,
            }
            for comparison in machine.comparisons
        ],
        "states": [
            {
                "name": state.name,
                "low": state.low,
                "high": state.high,
                "start": state.start,
                "kept": state.is_kept,
                "read": state.read,
            }
            for state in machine.states
        ],
        "nodes": len(machine.behaviour),
    }


def looks_lines(program: Program) -> list[str]:
    """Return the lines of a summary about looks: one for each signal and level with its boundaries,
    then one with the states, if there are any.

    A line lists at most `_MOST_SHOWN` boundaries, and says how many more there are."""
    machine, target = program.machine, program.target
    boundaries_of: dict[tuple[int, int], list[int]] = {}
    for comparison in machine.comparisons:
        boundaries_of.setdefault((comparison.signal, comparison.level), []).append(
            comparison.boundary
        )
    lines = []
    for (signal, level), boundaries in boundaries_of.items():
        electrons = level * target.electrons_per_step
        signal_text = "light" if signal == LIGHT else f"exposure of {program.buckets[signal].name}"
        shown = ", ".join(map(str, boundaries[:_MOST_SHOWN]))
        more_text = f" and {len(boundaries) - _MOST_SHOWN} more" * (len(boundaries) > _MOST_SHOWN)
        lines.append(
            f"{signal_text} above {electrons:.6g} e ({level} steps of IN, "
            f"{100 * electrons / target.full_well_e:.4g} %) at {shown}{more_text}"
        )
    states = [
        f"{state.name} {state.low}..{state.high}{', kept' * state.is_kept}{', read' * state.read}"
        for state in machine.states
    ]
    return [*lines, *([f"states: {'; '.join(states)}"] if states else [])]
