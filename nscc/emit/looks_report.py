"""The comparisons and states of a program with senses, for summaries and reports."""

from __future__ import annotations

from typing import Any

from nscc.chips.target import Target
from nscc.words.machine import LIGHT, StateMachine

_MOST_SHOWN = 12


def looks_lines(machine: StateMachine, buckets: tuple[str, ...], target: Target) -> list[str]:
    """Return the comparisons, one line for each signal and level, and the states."""
    at: dict[tuple[int, int], list[int]] = {}
    for comparison in machine.comparisons:
        at.setdefault((comparison.signal, comparison.level), []).append(comparison.boundary)
    lines = []
    for (signal, level), boundaries in at.items():
        electrons = level * target.electrons_per_step
        signal_text = "light" if signal == LIGHT else f"exposure of {buckets[signal]}"
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


def looks_report(machine: StateMachine, target: Target) -> dict[str, Any]:
    """Return the comparisons and states as JSON values, for `--emit report`."""
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
                "name": state.name, "low": state.low, "high": state.high, "start": state.start,
                "kept": state.is_kept, "read": state.read,
            }
            for state in machine.states
        ],
        "nodes": len(machine.behaviour),
    }  # fmt: skip
