"""Text positions of the Language Server Protocol: lines from 0, columns in UTF-16 code units.

A character beyond U+FFFF counts as two code units."""

from __future__ import annotations

import re
from bisect import bisect_right

from lsprotocol import types

from nscc.source import Span

_LINE_END = re.compile(r"\r\n|\r|\n")


class Positions:
    """A converter between character offsets and protocol positions of one text."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._starts = [0, *(line_end.end() for line_end in _LINE_END.finditer(text))]

    def of(self, offset: int) -> types.Position:
        """Return the position of a character offset; an offset beyond the text gives its end."""
        offset = min(offset, len(self.text))
        line = bisect_right(self._starts, offset) - 1
        return types.Position(line, _units(self.text[self._starts[line] : offset]))

    def range(self, span: Span) -> types.Range:
        return types.Range(self.of(span.start), self.of(span.end))

    def offset(self, position: types.Position) -> int:
        """Return the character offset of a position, at most the end of its line or text."""
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
        return Span(self.offset(lsp_range.start), self.offset(lsp_range.end))


def _units(text: str) -> int:
    return len(text) + sum(character > "\uffff" for character in text)
