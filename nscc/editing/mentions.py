"""Where names stand in a text and what they name. Told from the tokens, so that a statement that is
not finished hides no name."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from nscc.editing.document import Document
from nscc.source import Span

Kind = Literal["name", "bucket"]
"""Until version 3 buckets have names of their own; all else that a program declares shares one set
of names."""

DECLARES = ("let", "code", "shutters", "sense", "state", "kernel", "image", "plane")
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
    found = []
    for index, kind in enumerate(kinds):
        before = kinds[index - 1] if index else ""
        if kind not in ("NAME", "FUNCTION") or before == "key":
            continue
        kept = before == "kept" and kinds[index - 2 : index - 1] == ["state"]
        bucket = before in ("bucket", "exposure") and tokens.version < 3
        declares = kept or before in DECLARES or before == "bucket"
        name = tokens.text(index)
        found.append(Mention(name, tokens.span(index), "bucket" if bucket else "name", declares))
    return found


def mention_at(document: Document, offset: int) -> Mention | None:
    """The name that holds a character or ends before it."""
    return next((m for m in mentions(document) if m.span.start <= offset <= m.span.end), None)


def alike(document: Document, mention: Mention) -> list[Mention]:
    """All mentions of what one names, itself among them, in the text's order."""
    wanted = (mention.name, mention.kind)
    return [each for each in mentions(document) if (each.name, each.kind) == wanted]


def declaration(document: Document, mention: Mention) -> Mention | None:
    """The first mention that gives the name its meaning; None for predefined and unknown ones."""
    return next((each for each in alike(document, mention) if each.declares), None)
