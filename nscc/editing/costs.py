"""Costs of a frame and its slots in words, and inlay hints.

The functions on costs return None if the text has errors or only a longer search can determine the
costs."""

from __future__ import annotations

from collections.abc import Iterator

from nscc.editing.document import Document
from nscc.lower.lowered import Lowered
from nscc.lower.resources import time_text
from nscc.pipeline import Compiled
from nscc.program.problems import clipped, counted
from nscc.record import Record
from nscc.syntax import tree


class Hint(Record):
    """A text shown after the character before `offset`."""

    offset: int
    text: str


def hints(document: Document) -> Iterator[Hint]:
    """Yield the frame's cost if the program fits, and the value of every `let` that is an
    expression."""
    for statement in document.parsed[0].statements:
        match statement:
            case tree.EqualSlots() | tree.ListedSlots():
                compiled = document.checked.compiled
                shortest_us = _shortest_slot_us(compiled)
                if compiled is not None and shortest_us is not None:
                    lowered = compiled.lowered
                    cost = (
                        counted(len(compiled.program.frame.slot_us), "plane")
                        if lowered is None
                        else counted(lowered.schedule.words_total, "word")
                    )
                    text = f"{cost} a frame, shortest slot {time_text(shortest_us)}"
                    yield Hint(statement.span.end, text)
            case tree.Let() if not isinstance(statement.value, tree.Int):
                meaning = document.constants.get(statement.name.text)
                if meaning is not None and meaning.kind == "constant":
                    yield Hint(statement.span.end, f"= {clipped(meaning.value)}")


def frame_cost(document: Document) -> str | None:
    """Return the cost of a frame in sentences, with the distribution of words over slots."""
    compiled = document.checked.compiled
    shortest_us = _shortest_slot_us(compiled)
    if compiled is None or shortest_us is None:
        return None
    least = f"slots of {time_text(shortest_us)} and longer possible."
    if compiled.lowered is not None:
        return f"{_words_of_frame(compiled.lowered)} The words leave {least}"
    target = compiled.program.target
    planes = counted(len(compiled.program.frame.slot_us), "plane")
    return f"{planes} of {target.rows} x {target.cols} bits a frame. Loading them leaves {least}"


def slot_cost(document: Document, slot: int) -> str | None:
    """Return a sentence about the words that run before a slot, and their share of the slot."""
    compiled = document.checked.compiled
    if compiled is None or _shortest_slot_us(compiled) is None:
        return None
    lowered, slot_us = compiled.lowered, compiled.program.frame.slot_us[slot]
    head = f"Slot {slot}, {time_text(slot_us)}"
    if lowered is None:
        load_us = compiled.program.target.plane_load_us
        return f"{head}: one bit plane, loaded in {_share(load_us, slot_us)}."
    words, busy_us = lowered.words_per_boundary[slot], lowered.busy_us[slot]
    if not words:
        return f"{head}: costs no words."
    took = _share(busy_us, slot_us) if busy_us else "no time of its light"
    return f"{head}: {counted(words, 'word')} at its start, {took}."


def _shortest_slot_us(compiled: Compiled | None) -> float | None:
    result = None if compiled is None else compiled.lowered or compiled.sending
    return None if result is None else result.shortest_slot_us


def _share(us: float, slot_us: float) -> str:
    return f"{time_text(us)} or {100 * us / slot_us:.2g} % of it"


def _words_of_frame(lowered: Lowered) -> str:
    schedule, slots = lowered.schedule, lowered.plan.slots
    most = max(lowered.words_per_boundary)
    boundary = lowered.words_per_boundary.index(most)
    place = f"before slot {boundary}" if boundary < slots else "after the last slot"
    return (
        f"{counted(schedule.words_total, 'word')} a frame, {schedule.words_stored} stored of "
        f"{lowered.program.target.store_words}: {schedule.words_total / slots:.3g} a slot, at most "
        f"{most}, {place}."
    )
