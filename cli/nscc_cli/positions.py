"""Places of a text as the Language Server Protocol counts them: lines from 0, and columns in units
of UTF-16, of which characters beyond U+FFFF have two."""

from __future__ import annotations

import re
from bisect import bisect_right

from lsprotocol import types

from nscc.source import Span

_LINE_END = re.compile(r"\r\n|\r|\n")


class Positions:
    """The lines of one text."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._starts = [0, *(line_end.end() for line_end in _LINE_END.finditer(text))]

    def of(self, offset: int) -> types.Position:
        """The position of a character offset; beyond the text's end, that of its end."""
        offset = min(offset, len(self.text))
        line = bisect_right(self._starts, offset) - 1
        return types.Position(line, _units(self.text[self._starts[line] : offset]))

    def range(self, span: Span) -> types.Range:
        """The range of a span."""
        return types.Range(self.of(span.start), self.of(span.end))

    def offset(self, position: types.Position) -> int:
        """The character offset of a position; of one beyond a line or the text, the end of it."""
        if position.line >= len(self._starts):
            return len(self.text)
        begin = self._starts[position.line]
        last = position.line + 1 == len(self._starts)
        end = len(self.text) if last else self._starts[position.line + 1]
        line = self.text[begin:end].rstrip("\r\n")
        units = 0
        for index, character in enumerate(line):
            if units >= position.character:
                return begin + index
            units += _units(character)
        return begin + len(line)

    def span(self, lsp_range: types.Range) -> Span:
        """The span of a range."""
        return Span(self.offset(lsp_range.start), self.offset(lsp_range.end))


def _units(text: str) -> int:
    return len(text) + sum(character > "\uffff" for character in text)
