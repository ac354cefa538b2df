"""A short description of a compiled program: class, codes, whether it fits, costs."""

from __future__ import annotations

import numpy as np

from nscc.lower.fit import ledger
from nscc.lower.lowered import Lowered
from nscc.lower.resources import time_text
from nscc.pipeline import KINDS, Compiled
from nscc.program.problems import counted
from nscc.program.program import Program


def summary(name: str, compiled: Compiled) -> str:
    """Return the text that `nscc check` prints for the valid program file `name`: its name with the
    verdict, then a line for each row of the summary."""
    fits = compiled.container is not None
    verdict = f"fits {compiled.program.target.name}" if fits else "valid, but not known to fit"
    lines = (f"{label:<10} {value}" for label, value in summary_rows(compiled))
    return "\n  ".join([f"{name}: {verdict}", *lines])


def summary_rows(compiled: Compiled) -> list[tuple[str, str]]:
    """Return the rows (label, text) of a summary: class, codes and costs. There are no costs if it
    is unknown whether the words fit."""
    program = compiled.program
    table = program.table
    return [
        ("class", f"{program.class_name}: {program.class_reason}"),
        (
            "codes",
            f"{_codes_text(program)}, {counted(len(table.shutters), 'shutter')}, "
            f"{counted(len(program.frame.slot_us), 'slot')}",
        ),
        *KINDS.of(program).rows(compiled),
    ]


def word_rows(compiled: Compiled) -> list[tuple[str, str]]:
    """Return the rows (label, text) about a program's words; [] if it is unknown whether they
    fit."""
    program, lowered, proof = compiled.program, compiled.lowered, compiled.proof
    if lowered is None or proof is None:
        return []
    digital = ledger(lowered.schedule.allocation.holders)
    stored, executed = _words(compiled)
    return [
        ("lowering", f"{lowered.plan.lowering}; encoding: {lowered.solution.encoding}"),
        ("digital", digital or "no register needed for the exposure"),
        ("analog", ledger(lowered.plan.registers)),
        (
            "words",
            f"{stored} stored of {program.target.store_words}, {executed} a frame",
        ),
        (
            "time",
            f"shortest slot {time_text(min(program.frame.slot_us))}, longest instructions "
            f"{time_text(lowered.shortest_slot_us)}",
        ),
        (
            "proved",
            f"{counted(proof.codes, 'code')} x {counted(proof.slots, 'slot')}, "
            f"{counted(proof.frames, 'frame')}",
        ),
    ]


def _codes_text(program: Program) -> str:
    """Return how many codes are compiled, and how many others are legal or in use, where that
    differs."""
    count, legal = len(program.table.codes), program.legal_codes
    if program.mode == "fixed":
        excludes_legal_codes = legal is not None and legal > count
        return f"{count} in use" + (f" of {legal} legal" if excludes_legal_codes else "")
    used = count
    if program.pixel_codes is not None:
        used = int(np.count_nonzero(np.bincount(program.pixel_codes.ravel())))
    return f"{count} legal" + (f", {used} in use" if used < count else "")


def word_cost_text(compiled: Compiled) -> str:
    """Return two lines: words a frame and words stored, and the shortest possible slot. The program
    must have been lowered."""
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

    With a container (a compiled program), these include the words of images and planes."""
    if compiled.container is not None:
        return compiled.container.words_stored, compiled.container.words_per_frame
    assert compiled.lowered is not None
    schedule = compiled.lowered.schedule
    return schedule.words_stored, schedule.words_total


def word_frame_text(lowered: Lowered) -> str:
    """Return the cost of a frame in sentences, with the distribution of words over slots. Of
    several fullest boundaries the first is named.

    The last sentence, which begins with "The words", is completed by the caller."""
    schedule, slots = lowered.schedule, lowered.plan.slots
    most = max(lowered.words_per_boundary)
    boundary = lowered.words_per_boundary.index(most)
    place = f"before slot {boundary}" if boundary < slots else "after the last slot"
    return (
        f"{counted(schedule.words_total, 'word')} a frame, {schedule.words_stored} stored of "
        f"{lowered.program.target.store_words}: {schedule.words_total / slots:.3g} a slot, at most "
        f"{most}, {place}. The words"
    )


def word_slot_text(lowered: Lowered, slot: int) -> str:
    """Return the number of words at the start of a slot and their share of it, as the end of a
    sentence. `slot` is its number, 0..N-1."""
    words, busy_us = lowered.words_per_boundary[slot], lowered.busy_us[slot]
    if not words:
        return "costs no words."
    slot_us = lowered.program.frame.slot_us[slot]
    # The words of boundary 0 run before the exposure begins, so they may take nothing of slot 0.
    took = share_text(busy_us, slot_us) if busy_us else "no time of its light"
    return f"{counted(words, 'word')} at its start, {took}."


def share_text(us: float, slot_us: float) -> str:
    """Return a time, and how much of a slot it is in percent, such as "2.5 us or 2 % of it"."""
    return f"{time_text(us)} or {100 * us / slot_us:.2g} % of it"
