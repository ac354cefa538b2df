"""Inlay hints at the ends of statements: costs, and values of `let` statements."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from nscc.editing.costs import in_short
from nscc.editing.document import Document
from nscc.program.problems import clipped
from nscc.syntax import tree


@dataclass(frozen=True, slots=True)
class Hint:
    """A text shown after the character before `offset`."""

    offset: int
    text: str


def hints(document: Document) -> Iterator[Hint]:
    """Yield the frame's cost if the program fits, and the value of every `let` that is an
    expression."""
    for statement in document.parsed[0].statements:
        match statement:
            case tree.EqualSlots() | tree.ListedSlots():
                cost = in_short(document)
                if cost is not None:
                    yield Hint(statement.span.end, cost)
            case tree.Let() if not isinstance(statement.value, tree.Int):
                meaning = document.constants.get(statement.name.text)
                if meaning is not None and meaning.kind == "constant":
                    yield Hint(statement.span.end, f"= {clipped(meaning.value)}")
