"""Where names stand in a text and what they name. Told from the tokens, so that a statement that is
not finished hides no name."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from nscc.editing.document import Document
from nscc.source import Span

Kind = Literal["name", "bucket"]
"""Buckets have names of their own; all else that a program declares shares one set of names."""

DECLARES = ("let", "code", "shutters", "sense", "state")
"""After these words a statement's own name comes, which expressions may read."""


@dataclass(frozen=True, slots=True)
class Mention:
    """A name at a place; `declares` where the statement is the one that gives it its meaning."""

    name: str
    span: Span
    kind: Kind
    declares: bool


def mentions(document: Document) -> list[Mention]:
    """All names of a text in its order, but for those of targets and of arrays in files."""
    tokens, kinds = document.tokens, document.tokens.kinds
    listed = []
    for index, kind in enumerate(kinds):
        before = kinds[index - 1] if index else ""
        if kind != "NAME" or before == "key":
            continue
        is_kept_state = before == "kept" and kinds[index - 2 : index - 1] == ["state"]
        bucket = before in ("bucket", "exposure")
        declares = is_kept_state or before in DECLARES or before == "bucket"
        name = tokens.text(index)
        listed.append(Mention(name, tokens.span(index), "bucket" if bucket else "name", declares))
    return listed


def mention_at(document: Document, offset: int) -> Mention | None:
    """The name that holds a character or ends before it."""
    return next((m for m in mentions(document) if m.span.start <= offset <= m.span.end), None)


def alike(document: Document, mention: Mention) -> list[Mention]:
    """All mentions of what one names, itself among them, in the text's order."""
    identity = (mention.name, mention.kind)
    return [
        candidate
        for candidate in mentions(document)
        if (candidate.name, candidate.kind) == identity
    ]


def declaration(document: Document, mention: Mention) -> Mention | None:
    """The first mention that gives the name its meaning; None for predefined and unknown ones."""
    return next((candidate for candidate in alike(document, mention) if candidate.declares), None)
