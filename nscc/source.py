"""Source texts, and places in them."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from functools import cached_property

from nscc.record import Record


@dataclass(frozen=True, slots=True)
class Span:
    """A half-open range of character offsets in one source text: from `start`, counted from 0, to
    `end`, which is not included."""

    start: int
    end: int

    def to(self, last: Span) -> Span:
        """Return the range from the start of this one to the end of `last`, or its own end if that
        is later."""
        return Span(self.start, max(self.end, last.end))


class Source(Record):
    """A text, and its name in messages: the path as the user wrote it, or a name such as
    `<text>`."""

    name: str
    text: str

    @cached_property
    def _line_starts(self) -> list[int]:
        """Where each line begins."""
        starts = [0]
        starts.extend(i + 1 for i, ch in enumerate(self.text) if ch == "\n")
        return starts

    def row_column(self, offset: int) -> tuple[int, int]:
        """Return the row and the column of a character offset, both counted from 1. Only LF ends a
        line; an offset beyond the text is in its last row."""
        row = bisect_right(self._line_starts, offset)
        return row, offset - self._line_starts[row - 1] + 1

    def line(self, row: int) -> str:
        """Return the text of row `row` (from 1), without its line break (LF, or CR and LF). The row
        must exist."""
        start = self._line_starts[row - 1]
        end = self._line_starts[row] - 1 if row < len(self._line_starts) else len(self.text)
        return self.text[start:end].rstrip("\r")
