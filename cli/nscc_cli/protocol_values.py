"""Conversion of `nscc.editing` results into values of the Language Server Protocol."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable
from pathlib import Path

from lsprotocol import types
from pygls import uris

from nscc.diagnostics.diagnostic import Diagnostic, Severity
from nscc.diagnostics.reports import full_text
from nscc.editing.complete import Text
from nscc.source import Source, Span

_LINE_END = re.compile(r"\r\n|\r|\n")


class Positions:
    """Converts between character offsets in `text`, and positions of the protocol: line and column,
    counted from 0, in 16-bit units."""

    def __init__(self, text: str) -> None:
        """Find where the lines of the text begin."""
        self.text = text
        self._starts = [0, *(line_end.end() for line_end in _LINE_END.finditer(text))]

    def of(self, offset: int) -> types.Position:
        """Return the position of a character offset; an offset beyond the text gives its end."""
        offset = min(offset, len(self.text))
        line = bisect_right(self._starts, offset) - 1
        return types.Position(line, _units(self.text[self._starts[line] : offset]))

    def range(self, span: Span) -> types.Range:
        """Return the protocol's range (two positions) of a span (two offsets)."""
        return types.Range(self.of(span.start), self.of(span.end))

    def offset(self, position: types.Position) -> int:
        """Return the character offset, from 0, of a position of the protocol (line and column). A
        position beyond its line or the text gives the end of the line or the text."""
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
        """Return the span of a range of the protocol."""
        return Span(self.offset(lsp_range.start), self.offset(lsp_range.end))


def _units(text: str) -> int:
    """Return the length of a text in 16-bit units, which the protocol counts."""
    return len(text) + sum(character > "\uffff" for character in text)


_SEVERITIES = {
    Severity.ERROR: types.DiagnosticSeverity.Error,
    Severity.WARNING: types.DiagnosticSeverity.Warning,
    Severity.NOTE: types.DiagnosticSeverity.Information,
}
"""The protocol's severity of each severity of a message."""
OFFERED = {
    "word": types.CompletionItemKind.Keyword,
    "name": types.CompletionItemKind.Variable,
    "target": types.CompletionItemKind.Module,
    "file": types.CompletionItemKind.File,
    "digest": types.CompletionItemKind.Constant,
}
"""The protocol's kind of a completion, by our kind."""
DECLARED = {
    "frame": types.SymbolKind.Event,
    "let": types.SymbolKind.Constant,
    "code": types.SymbolKind.Field,
    "shutters": types.SymbolKind.Array,
    "open": types.SymbolKind.Function,
    "bucket": types.SymbolKind.Function,
    "sense": types.SymbolKind.Boolean,
    "state": types.SymbolKind.Variable,
}
"""The symbol kind of each statement, by its first word."""


def diagnostic(message: Diagnostic, document: Text, uri: str) -> types.Diagnostic:
    """Convert a message about the text `document`, whose address is `uri`.

    A message without a place in this text goes to its first line; a place in another file becomes
    related information."""
    source, label = message.source, message.label
    in_document = source is not None and source.name == document.name
    place = types.Range(types.Position(0, 0), types.Position(0, 0))
    related: list[types.DiagnosticRelatedInformation] = []
    if source is not None:
        positions = Positions(source.text)
        label_uri = uri if in_document else _uri(source, document)
        if label is not None and in_document:
            place = positions.range(label.span)
        elsewhere = [label] if label is not None and not in_document else []
        related = [
            types.DiagnosticRelatedInformation(
                types.Location(label_uri, positions.range(related_label.span)),
                related_label.text or message.message,
            )
            for related_label in (*elsewhere, *message.related)
        ]
    return types.Diagnostic(
        place,
        full_text(message),
        severity=_SEVERITIES[message.severity],
        code=message.code,
        source="nscc",
        related_information=related or None,
    )


def _uri(source: Source, document: Text) -> str:
    """Return the URI of the file of `source`, whose name is relative to the folder of
    `document`."""
    path = Path(document.folder / source.name)
    return uris.from_fs_path(path.absolute().as_posix()) or path.as_posix()


def edits(
    uri: str, changes: Iterable[tuple[Span, str]], positions: Positions
) -> types.WorkspaceEdit:
    """Convert `changes`, pairs of a span and its new text, into an edit of the document `uri`. The
    spans must not overlap; `positions` are those of the document's text."""
    text_edits = [types.TextEdit(positions.range(span), text) for span, text in changes]
    return types.WorkspaceEdit({uri: text_edits})
