"""Rename what a program declares."""

from __future__ import annotations

import re
from collections.abc import Set

from nscc.editing.document import Document
from nscc.editing.mentions import Mention, alike, declaration, mention_at, mentions
from nscc.program.names import LOOKS, PREDEFINED
from nscc.source import Span
from nscc.syntax.words import reserved, shown

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


class CannotRename(ValueError):
    """Raised if a name cannot be changed; the text is the reason in one sentence."""


def renamed(document: Document, offset: int, name: str) -> tuple[Span, ...]:
    """Return the places at which the name at `offset` must be replaced by `name`.

    Raises CannotRename if no declared name is at `offset`, if `name` is invalid or in use, or if an
    array in a file has the old name."""
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
    other_names = {(place.name, place.kind) for place in mentions(document)} - {
        (old.name, old.kind)
    }
    if (name, old.kind) in other_names:
        raise CannotRename(f"`{name}` has another meaning in this program")
    return tuple(place.span for place in alike(document, old))


def renameable(document: Document, offset: int) -> Mention:
    """Return the name at `offset` if it can be renamed; raise CannotRename as `renamed` does."""
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
    return {*PREDEFINED, *([LOOKS] if document.tokens.version > 1 else [])}
