"""The frame: the lengths of its slots."""

from __future__ import annotations

from fractions import Fraction

from nscc.program.expressions import Meaning
from nscc.program.problems import Problems
from nscc.program.program import SlotGrid
from nscc.source import Span
from nscc.syntax.tree import EqualSlots, ListedSlots

SHORTEST_US = Fraction(1, 10**6)
LONGEST_US = Fraction(10**12)


def make_frame(
    statement: EqualSlots | ListedSlots, slots: Meaning, problems: Problems
) -> SlotGrid | None:
    """Return the frame, or None after reporting invalid slot lengths (NS0309).

    `slots` is the meaning of N; if it failed, the result is None without a report."""
    times = (statement.length,) if isinstance(statement, EqualSlots) else statement.lengths
    invalid = [time for time in times if not SHORTEST_US <= time.us <= LONGEST_US]
    for time in invalid[:8]:
        text = "zero or negative" if time.us <= 0 else "too short" if time.us < 1 else "too long"
        notes = ("a slot must be between 1 ps and 10^6 s long",)
        problems.error("NS0309", "slot length out of range", time.span, text, notes=notes)
    if invalid or slots.kind != "constant":
        return None
    if isinstance(statement, EqualSlots):
        lengths = (float(statement.length.us),) * slots.value
        count_span = statement.count.span
    else:
        lengths = tuple(float(time.us) for time in times)
        count_span = Span(times[0].span.start, times[-1].span.end)
    return SlotGrid(lengths, len(set(lengths)) == 1, statement.span, count_span)
