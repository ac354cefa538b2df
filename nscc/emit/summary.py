"""A short description of a compiled program: class, codes, whether it fits, costs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from nscc.lower.fit import ledger
from nscc.lower.resources import time_text
from nscc.program.problems import counted

_MOST_SHOWN = 12

if TYPE_CHECKING:
    from nscc.chips.target import Target
    from nscc.pipeline import Compiled
    from nscc.program.program import Program
    from nscc.words.machine import StateMachine


def summary(name: str, compiled: Compiled) -> str:
    """Return the text that `nscc check` prints for a valid program."""
    fits = compiled.container is not None
    verdict = (
        f"fits {compiled.program.target.name}" if fits else "passes, unless its words do not fit"
    )
    lines = (f"{label:<10} {value}" for label, value in summary_rows(compiled))
    return "\n  ".join([f"{name}: {verdict}", *lines])


def summary_rows(compiled: Compiled) -> list[tuple[str, str]]:
    """Return the summary as rows (label, text)."""
    program, lowered, proof = compiled.program, compiled.lowered, compiled.proof
    table = program.table
    rows = [
        ("class", f"{program.class_name}: {program.class_reason}"),
        (
            "codes",
            f"{_codes_text(program)}, {counted(len(table.shutters), 'shutter')}, "
            f"{counted(len(program.frame.slot_us), 'slot')}",
        ),
    ]
    if program.machine.stages:
        names = tuple(bucket.name for bucket in program.buckets)
        looks = _looks_lines(program.machine, names, program.target)
        rows += [("looks" * (not k), text) for k, text in enumerate(looks)]
    if compiled.sending is not None and proof is not None:
        from nscc.emit.sending_report import stream_rows

        return [*rows, *stream_rows(compiled.sending, proof)]
    if lowered is None or proof is None:
        return rows
    schedule = lowered.schedule
    digital = ledger(schedule.allocation.holders)
    shortest = min(program.frame.slot_us)
    stored, executed = _words(compiled)
    if compiled.container is not None and compiled.container.pictures.outputs:
        from nscc.emit.picture_report import picture_rows

        rows += picture_rows(compiled.container.pictures, program.target)
    return [
        *rows,
        ("lowering", f"{lowered.plan.lowering}; encoding: {lowered.solution.encoding}"),
        ("digital", digital or "no register needed"),
        ("analog", ledger(lowered.plan.registers)),
        (
            "words",
            f"{stored} stored of {program.target.store_words}, {executed} a frame",
        ),
        (
            "time",
            f"shortest slot {time_text(shortest)}, longest instructions "
            f"{time_text(lowered.shortest_slot_us)}",
        ),
        (
            "proved",
            f"{counted(proof.codes, 'code')} x {counted(proof.slots, 'slot')}, "
            f"{counted(proof.frames, 'frame')}"
            + f", {counted(proof.transitions, 'answer')}"
            * (program.machine.stages > 0),
        ),
    ]


def _looks_lines(machine: StateMachine, buckets: tuple[str, ...], target: Target) -> list[str]:
    """Return the comparisons, one line for each signal and level, and the states."""
    from nscc.words.machine import LIGHT

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


def _codes_text(program: Program) -> str:
    """Return how many codes are compiled, and how many others are legal or in use."""
    count, legal = len(program.table.codes), program.legal_codes
    if program.mode == "fixed":
        excludes_legal_codes = legal is not None and legal > count
        return f"{count} in use" + (f" of {legal} legal" if excludes_legal_codes else "")
    used = count
    if program.pixel_codes is not None:
        used = int(np.count_nonzero(np.bincount(program.pixel_codes.ravel())))
    return f"{count} legal" + (f", {used} in use" if used < count else "")


def cost_text(compiled: Compiled) -> str:
    """Return the cost of words, or of bit planes, in two lines."""
    if compiled.sending is not None:
        from nscc.emit.sending_report import rate_text

        sending = compiled.sending
        return (
            f"  planes {len(sending.loadings)} a frame, {sending.bits_a_frame} bits, "
            f"{rate_text(sending.bits_per_us)} while one loads\n"
            f"  time   shortest legal slot {time_text(sending.shortest_slot_us)}"
        )
    lowered = compiled.lowered
    assert lowered is not None
    target, (stored, executed) = lowered.program.target, _words(compiled)
    launches = lowered.shortest_slot_launches
    launched = counted(launches, "kernel launch", "kernel launches")
    return (
        f"  words  {executed} a frame, at most {max(lowered.words_per_boundary)} in a slot, "
        f"{stored} stored of {target.store_words}\n"
        f"  time   shortest legal slot {time_text(lowered.shortest_slot_us)}, "
        f"with {launched} of {time_text(target.launch_us)}"
    )


def _words(compiled: Compiled) -> tuple[int, int]:
    """Return how many words a chip stores, and how many it executes in a frame.

    Only a container has the words of images and planes."""
    if compiled.container is not None:
        return compiled.container.words_stored, compiled.container.words_per_frame
    assert compiled.lowered is not None
    schedule = compiled.lowered.schedule
    return schedule.words_stored, schedule.words_total
