"""What a frame and its slots cost in words, in words."""

from __future__ import annotations

from nscc.editing.document import Document
from nscc.lower.lowered import Lowered
from nscc.lower.resources import time_text
from nscc.program.problems import counted


def lowered_of(document: Document) -> Lowered | None:
    """The words of a text that fits; None for others."""
    compiled = document.checked.compiled
    return None if compiled is None else compiled.lowered


def in_short(lowered: Lowered) -> str:
    """Words a frame and the shortest slot, for the end of a line."""
    return (
        f"{counted(lowered.schedule.words_total, 'word')} a frame, "
        f"shortest slot {time_text(lowered.shortest_slot_us)}"
    )


def frame_cost(lowered: Lowered) -> str:
    """The same with how words are shared out between slots."""
    schedule, target = lowered.schedule, lowered.program.target
    at_boundary = lowered.words_per_boundary
    most = max(at_boundary)
    slots = lowered.plan.slots
    return (
        f"{counted(schedule.words_total, 'word')} a frame, {schedule.words_stored} stored of "
        f"{target.store_words}: {schedule.words_total / slots:.3g} a slot, at most {most}, "
        f"{_before(at_boundary.index(most), slots)}. The words leave slots of "
        f"{time_text(lowered.shortest_slot_us)} and longer possible."
    )


def slot_cost(lowered: Lowered, slot: int) -> str:
    """What runs before a slot's light, and how much of the slot it takes."""
    words, busy_us = lowered.words_per_boundary[slot], lowered.busy_us[slot]
    slot_us = lowered.program.frame.slot_us[slot]
    if not words:
        return f"Slot {slot}, {time_text(slot_us)}: costs no words."
    took = (
        f"{time_text(busy_us)} or {100 * busy_us / slot_us:.2g} % of it" if busy_us else "no time"
    )
    return f"Slot {slot}, {time_text(slot_us)}: {counted(words, 'word')} at its start, {took}."


def _before(boundary: int, slots: int) -> str:
    return f"before slot {boundary}" if boundary < slots else "after the last slot"
