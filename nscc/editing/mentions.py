"""The places of names in a text, what they refer to, and their renaming, found from tokens.

No syntax tree is needed, so that incomplete statements are included."""

from __future__ import annotations

import re
from collections.abc import Set
from typing import Literal

from nscc.editing.document import Document
from nscc.program.names import LOOKS, PREDEFINED
from nscc.record import Record
from nscc.source import Span
from nscc.syntax.words import reserved, shown

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


class CannotRename(ValueError):
    """Raised if a name cannot be changed; the text is the reason in one sentence."""


def renamed(document: Document, offset: int, name: str) -> tuple[Span, ...]:
    """Return the places at which the name at `offset` (characters) must be replaced by `name`.

    They are all uses and the declaration, in the order of the text. Raises CannotRename if no
    declared name is at `offset`, if `name` is invalid or in use, or if the old name is that of an
    array in a file."""
    old = renameable(document, offset)
    if not _NAME.fullmatch(name):
        raise CannotRename(
            f"{shown(name)} is not a valid name: names consist of letters, digits and "
            "underscores, and do not begin with a digit"
        )
    if name in reserved(document.tokens.version):
        raise CannotRename(f"`{name}` is a reserved word of the language")
    if old.kind == "name" and name in _predefined(document):
        raise CannotRename(f"`{name}` is predefined")
    other_names = {(mention.name, mention.kind) for mention in mentions(document)} - {
        (old.name, old.kind)
    }
    if (name, old.kind) in other_names:
        raise CannotRename(f"`{name}` has another meaning in this program: choose another name")
    return tuple(mention.span for mention in alike(document, old))


def renameable(document: Document, offset: int) -> Mention:
    """Return the declared name at `offset` (characters), if it can be renamed.

    Raises CannotRename if no declared name stands there, or if it is that of an array in a file."""
    mention = mention_at(document, offset)
    if mention is None:
        raise CannotRename("there is no name of the program at this place")
    if declaration(document, mention) is None:
        predefined = mention.name in _predefined(document)
        why = "is predefined" if predefined else "is not declared in this program"
        raise CannotRename(f"`{mention.name}` {why}")
    file = document.declared.pixels_file
    by_name = mention.name in document.declared.codes.keys() - document.declared.pixels.keys()
    if file is not None and by_name and mention.kind == "name":
        raise CannotRename(
            f"the values of `{mention.name}` come from the array of that name in "
            f'"{file.path.value}": rename the array first'
        )
    return mention


def _predefined(document: Document) -> Set[str]:
    """Return the names that the language defines, which depend on the document's version of it:
    `looks` exists from version 2 on."""
    return {*PREDEFINED, *([LOOKS] if document.tokens.version > 1 else [])}


Kind = Literal["name", "bucket"]
"""Until version 3, buckets have a separate namespace; all other declarations share one
namespace."""

DECLARES = ("let", "code", "shutters", "sense", "state", "kernel", "image", "plane")
"""Keywords followed by the name that a statement declares."""


class Mention(Record):
    """A name at the place `span`, without backquotes or blanks; `declares` is true if the statement
    declares the name."""

    name: str
    span: Span
    kind: Kind
    declares: bool


def mentions(document: Document) -> list[Mention]:
    """Return all names in a text, in order, except the names of targets and of arrays in files. A
    name is listed once for each place."""
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
    """Return the name that contains `offset` (characters) or ends there, the first in the text, or
    None."""
    return next((m for m in mentions(document) if m.span.start <= offset <= m.span.end), None)


def alike(document: Document, mention: Mention) -> list[Mention]:
    """Return all mentions of the same name, including `mention`, in the order of the text.

    The name of a bucket is a different name where buckets have a namespace of their own."""
    identity = (mention.name, mention.kind)
    return [
        candidate
        for candidate in mentions(document)
        if (candidate.name, candidate.kind) == identity
    ]


def declaration(document: Document, mention: Mention) -> Mention | None:
    """Return the mention that declares the name; None for predefined and unknown names. Of several,
    it is the first."""
    return next((candidate for candidate in alike(document, mention) if candidate.declares), None)
