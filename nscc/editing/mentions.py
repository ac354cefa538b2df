"""The places of names in a text, and what they refer to, found from tokens.

No syntax tree is needed, so that incomplete statements are included."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from nscc.editing.document import Document
from nscc.source import Span

Kind = Literal["name", "bucket"]
"""Until version 3, buckets have a separate namespace; all other declarations share one
namespace."""

DECLARES = ("let", "code", "shutters", "sense", "state", "kernel", "image", "plane")
"""Keywords followed by the name that a statement declares."""


@dataclass(frozen=True, slots=True)
class Mention:
    """A name at a place; `declares` is true if the statement declares the name."""

    name: str
    span: Span
    kind: Kind
    declares: bool


def mentions(document: Document) -> list[Mention]:
    """Return all names in a text in order, except names of targets and of arrays in files."""
    tokens, kinds = document.tokens, document.tokens.kinds
    listed = []
    for index, kind in enumerate(kinds):
        before = kinds[index - 1] if index else ""
        if kind not in ("NAME", "FUNCTION") or before == "key":
            continue
        is_kept_state = before == "kept" and kinds[index - 2 : index - 1] == ["state"]
        bucket = before in ("bucket", "exposure") and tokens.version < 3
        declares = is_kept_state or before in DECLARES or before == "bucket"
        name = tokens.text(index)
        listed.append(Mention(name, tokens.span(index), "bucket" if bucket else "name", declares))
    return listed


def mention_at(document: Document, offset: int) -> Mention | None:
    """Return the name that contains `offset` or ends there, or None."""
    return next((m for m in mentions(document) if m.span.start <= offset <= m.span.end), None)


def alike(document: Document, mention: Mention) -> list[Mention]:
    """Return all mentions that refer to the same declaration as `mention`, including itself, in
    order."""
    identity = (mention.name, mention.kind)
    return [
        candidate
        for candidate in mentions(document)
        if (candidate.name, candidate.kind) == identity
    ]


def declaration(document: Document, mention: Mention) -> Mention | None:
    """Return the mention that declares the name; None for predefined and unknown names."""
    return next((candidate for candidate in alike(document, mention) if candidate.declares), None)
