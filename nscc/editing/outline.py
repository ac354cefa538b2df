"""The outline of a program: its declarations."""

from __future__ import annotations

from dataclasses import dataclass

from nscc.editing.document import Document
from nscc.source import Span
from nscc.syntax import tree

_KINDS = {
    tree.EqualSlots: "frame",
    tree.ListedSlots: "frame",
    tree.Let: "let",
    tree.CodeRange: "code",
    tree.CodeBits: "code",
    tree.CodeRow: "code",
    tree.BookInline: "shutters",
    tree.BookFromFile: "shutters",
    tree.Open: "open",
    tree.Bucket: "bucket",
    tree.Sense: "sense",
    tree.StateRange: "state",
    tree.StateBit: "state",
}
"""The statements in the outline, with the keyword of each."""

_LONGEST = 60


@dataclass(frozen=True, slots=True)
class OutlineEntry:
    """A statement in the outline.

    `kind` is its first word, which is also its `name` if it declares no name. `detail` is a short
    form of the rest of the statement. `at` is the place of the name."""

    name: str
    detail: str
    kind: str
    span: Span
    at: Span


def outline(document: Document) -> list[OutlineEntry]:
    """Return the named statements, the frame and the rule, in the order of the text."""
    entries = []
    for statement in document.parsed[0].statements:
        kind = _KINDS.get(type(statement))
        if kind is None:
            continue
        span, name = statement.span, getattr(statement, "name", None)
        first = document.text[span.start : span.end].split(None, 1)[0]
        at = Span(span.start, span.start + len(first)) if name is None else name.span
        detail = " ".join(document.text[at.end : span.end].split()).lstrip(" :=")
        if len(detail) > _LONGEST:
            detail = detail[: _LONGEST - 3] + "..."
        entries.append(OutlineEntry(kind if name is None else name.text, detail, kind, span, at))
    return entries
