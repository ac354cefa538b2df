"""What a program declares, statement by statement."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from nscc.editing.document import Document
from nscc.source import Span
from nscc.syntax import tree


@dataclass(frozen=True, slots=True)
class Entry:
    """A statement: its name, how it is written in short, what it is, and its place.

    `kind` is the word that begins it; `at` is the place of the name.
    """

    name: str
    detail: str
    kind: str
    span: Span
    at: Span


def outline(document: Document) -> list[Entry]:
    """Those statements that have a name, the frame and the rule, in the order written."""
    return list(_entries(document))


def _entries(document: Document) -> Iterator[Entry]:
    text = document.text
    for statement in document.parsed[0].statements:
        span = statement.span
        word = text[span.start : span.end].split(None, 1)[0]
        written = " ".join(text[span.start : span.end].split())
        match statement:
            case tree.EqualSlots() | tree.ListedSlots() | tree.Open():
                at = Span(span.start, span.start + len(word))
                yield Entry(word, _after(written, word), word, span, at)
            case (
                tree.Let() | tree.CodeRange() | tree.CodeBits() | tree.CodeRow()
                | tree.BookInline() | tree.BookFromFile() | tree.Bucket() | tree.Sense()
                | tree.StateRange() | tree.StateBit()
            ):  # fmt: skip
                name = statement.name
                yield Entry(name.text, _after(written, name.text), word, span, name.span)


_LONGEST = 60


def _after(written: str, name: str) -> str:
    """What a statement says behind its name, cut short."""
    rest = written.partition(name)[2].strip(" :=")
    return rest if len(rest) <= _LONGEST else rest[: _LONGEST - 3] + "..."
