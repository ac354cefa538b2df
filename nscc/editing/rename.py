"""Another name for what a program declares."""

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
    """Says in a sentence why a name stays what it is."""


def renamed(document: Document, offset: int, name: str) -> tuple[Span, ...]:
    """The places that have to become `name`, so that the program means the same.

    Raises CannotRename where no name that the text declares stands at `offset`, where `name` is
    none or means something else already, and where a file knows the field by its old name.
    """
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
    others = {(each.name, each.kind) for each in mentions(document)} - {(old.name, old.kind)}
    if (name, old.kind) in others:
        raise CannotRename(f"`{name}` has another meaning in this program")
    return tuple(each.span for each in alike(document, old))


def renameable(document: Document, offset: int) -> Mention:
    """The name at `offset`, if it may have another one. Raises CannotRename as `renamed` does."""
    found = mention_at(document, offset)
    if found is None:
        raise CannotRename("there is no name of the program at this place")
    if declaration(document, found) is None:
        predefined = found.name in _predefined(document)
        why = "is predefined" if predefined else "is not declared in this program"
        raise CannotRename(f"`{found.name}` {why}")
    file = document.declared.pixels_file
    by_name = found.name in document.declared.codes.keys() - document.declared.pixels.keys()
    if file is not None and by_name and found.kind == "name":
        raise CannotRename(
            f"the values of `{found.name}` come from the array of that name in "
            f'"{file.path.value}": rename the array first'
        )
    return found


def _predefined(document: Document) -> Set[str]:
    return {*PREDEFINED, *([LOOKS] if document.tokens.version > 1 else [])}
