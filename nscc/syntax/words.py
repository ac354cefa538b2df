"""The reserved words, and how messages speak of the pieces of a statement."""

from __future__ import annotations

STATEMENT_WORDS = (
    "nsl", "target", "frame", "let", "code", "require", "shutters", "open", "bucket", "pixels",
)  # fmt: skip

OTHER_WORDS = (
    "slots", "of", "when", "tile", "from", "bit", "row", "key", "sha256",
    "if", "else", "and", "or", "xor", "not", "true", "false", "min", "max",
)  # fmt: skip

FORMS = {
    "nsl": ("nsl 1",),
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
}
"""How each statement is written."""

OPERATORS = {"OR", "XOR", "AND", "COMPARE", "SHIFT", "PLUS", "MINUS", "STAR", "SLASH", "PERCENT"}
OPERAND_STARTS = {"INT", "NAME", "TRUE", "FALSE", "FUNCTION", "LPAR", "NOT", "MINUS"}

_PIECES = {
    "NAME": "a name",
    "INT": "a number",
    "GROUPED": "digits",
    "TIME": "a time such as 125us",
    "STRING": 'a path in quotes, "like this"',
    "BEGIN": "`[`",
    "END": "`]`",
    "CLOSE": "`)`",
    "LPAR": "`(`",
    "COMMA": "`,`",
    "COLON": "`:`",
    "EQUAL": "`=`",
    "__ANON_0": "`..`",
    "$END": "the end of the statement",
}


def expected_words(terminals: set[str]) -> str:
    """A set of the parser's terminals in plain words: "a name, a number or `[`"."""
    rest = set(terminals)
    parts: list[str] = []
    if {"INT", "NAME", "MINUS"} <= rest:
        parts.append("an expression")
        rest -= OPERAND_STARTS
    if len(rest & OPERATORS) > 2:
        parts.append("an operator")
        rest -= OPERATORS
        rest.discard("IF")
    parts += [_PIECES.get(name, f"`{name.lower()}`") for name in sorted(rest)]
    if len(parts) < 2:
        return "".join(parts) or "nothing more"
    return ", ".join(parts[:-1]) + " or " + parts[-1]
