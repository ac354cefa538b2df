"""The keywords of the language, and names for the parts of statements in messages."""

from __future__ import annotations

from collections.abc import Set

from nscc.syntax.grammar import END, spellings

STATEMENT_WORDS = (
    "nsl", "target", "frame", "let", "code", "require", "shutters", "open", "bucket", "pixels",
)  # fmt: skip

LOOKING_WORDS = ("sense", "state", "next", "reset", "read")
"""Keywords added in version 2, for pixels that look at their light."""

PICTURE_WORDS = ("kernel", "image", "plane", "outside", "report", "assume")
"""Keywords added in version 3, for pixels that see their neighbours."""

_ADDED = {2: frozenset({*LOOKING_WORDS, "kept", "at", "in", "light", "exposure"}),
          3: frozenset(PICTURE_WORDS)}  # fmt: skip
"""The keywords that each version adds; in files of earlier versions they are names."""


def names_in(version: int) -> frozenset[str]:
    """Return the keywords of later versions, which are names in a file of this version."""
    return frozenset().union(*(words for added, words in _ADDED.items() if added > version))


def statement_words(version: int) -> tuple[str, ...]:
    """Return the keywords that begin statements in a version of the language."""
    words: tuple[str, ...] = STATEMENT_WORDS
    words += LOOKING_WORDS if version > 1 else ()
    return words + (PICTURE_WORDS if version > 2 else ())


def reserved(version: int) -> frozenset[str]:
    """Return the keywords and signs of a version, which cannot be names."""
    return frozenset(spellings().values()) - names_in(version)


FORMS = {
    "nsl": ("nsl 1", "nsl 2", "nsl 3"),
    "target": ("target NAME", 'target "FILE.toml"'),
    "frame": ("frame N slots of TIME", "frame slots [TIME, TIME, ...]"),
    "let": ("let NAME = EXPR",),
    "code": ("code NAME : LO..HI", "code NAME : bit[K]", "code NAME : row of BOOK"),
    "require": ("require EXPR",),
    "shutters": (
        "shutters BOOK [ 1100, 0011, ... ]",
        'shutters BOOK from "book.npz" [key NAME] [sha256 "..."]',
    ),
    "open": ("open when EXPR",),
    "bucket": ("bucket NAME open when EXPR",),
    "pixels": (
        "pixels FIELD = EXPR",
        "pixels FIELD = tile [[..], ..]",
        'pixels from "codes.npz" [sha256 "..."]',
    ),
    "sense": (
        "sense NAME when light > LEVEL at WHEN",
        "sense NAME when exposure BUCKET > LEVEL at WHEN",
    ),
    "state": ("state NAME : LO..HI = START [kept]", "state NAME : bit = START [kept]"),
    "next": ("next NAME = EXPR [when CONDITION]",),
    "reset": ("reset when EXPR",),
    "read": ("read NAME, ...",),
    "kernel": (
        "kernel NAME = [[1, 2, 1], [2, 4, 2], [1, 2, 1]] / 16",
        'kernel NAME from "file.npz" [key NAME] [sha256 "..."]',
    ),
    "image": ("image NAME = EXPR",),
    "plane": ("plane NAME = CONDITION",),
    "outside": ("outside 0", "outside 1"),
    "report": ("report any PLANE", "report events PLANE at most K", "report box PLANE"),
    "assume": ("assume exposure <= LEVEL", "assume exposure BUCKET <= LEVEL"),
}
"""The forms of each statement."""

_OPERATORS = {"or", "xor", "and", "in", "COMPARISON", "<<", "+", "-", "*", "/", "%", "if", "PLACE"}
_OPERANDS = {
    "INTEGER", "NAME", "(", "-", "not", "true", "false", "min", "max", "FUNCTION", "AMOUNT"
}  # fmt: skip
_PIECES = {
    "NAME": "a name",
    "TARGET_NAME": "a target's name",
    "INTEGER": "a number",
    "GROUPED": "a row of digits such as 1111_0000",
    "TIME": "a time such as 125us",
    "TEXT": 'a path in quotes, "like this"',
    "LEVEL": "a level such as 45%, 12000e or 90lsb",
    "AMOUNT": "a level such as 45%, 12000e or 90lsb",
    "COMPARISON": "a comparison",
}


def expected_words(terminals: Set[str]) -> str:
    """Return what could come next, in plain words: "`slots`", "a number or a name".

    Operators are left out if something else can come next; a comma is left out if a list may end.
    """
    remaining = set(terminals)
    choices: list[str] = []
    if {"INTEGER", "NAME", "-"} <= remaining:
        choices.append("a number, a name or another expression")
        remaining -= _OPERANDS
    if {"*", "COMPARISON"} <= remaining:
        remaining -= {*_OPERATORS, "["}
        if remaining == {END}:
            choices.append("an operator")
    if "GROUPED" in remaining:
        remaining.discard("INTEGER")
    over = END in remaining
    remaining.discard(END)
    choices += [_PIECES.get(kind, f"`{kind}`") for kind in sorted(remaining)]
    if over:
        choices.append("the next statement")
    return ", ".join(choices[:-1]) + " or " + choices[-1] if len(choices) > 1 else choices[0]


def shown(text: str) -> str:
    """Return a piece of the user's text in quotes, shortened, without unprintable characters."""
    cut = text if len(text) <= 40 else text[:37] + "..."
    return "`" + "".join(ch if ch.isprintable() else "?" for ch in cut) + "`"
