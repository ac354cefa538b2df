"""Text to tokens: every character of a text ends up in one, so that nothing stops the lexer."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache

from nscc.source import Source, Span
from nscc.syntax.tables import tables

MALFORMED = "MALFORMED"
UNCLOSED = "UNCLOSED"
STRAY = "STRAY"
_TARGET_NAME = "TARGET_NAME"

_NO_TOKEN = (
    (MALFORMED, r"[0-9]\w*(?:\.\w+)*"),
    (UNCLOSED, r'"[^\r\n]*'),
    (STRAY, r"\w+|."),
)
"""What the grammar has no word for: 12abc, quotes left open, any other character."""


@dataclass(frozen=True, slots=True)
class Tokens:
    """The tokens of a text: kind and place of each, blanks and comments left out.

    A kind is a terminal of the grammar (a word or sign stands for itself), or MALFORMED, UNCLOSED
    or STRAY, which no rule takes.
    """

    source: Source
    kinds: list[str]
    starts: list[int]
    ends: list[int]

    def text(self, index: int) -> str:
        """The text of a token."""
        return self.source.text[self.starts[index] : self.ends[index]]

    def span(self, index: int) -> Span:
        """The place of a token."""
        return Span(self.starts[index], self.ends[index])


@cache
def _patterns() -> tuple[re.Pattern[str], re.Pattern[str]]:
    """Any token, and the name of a target."""
    language = tables()
    signs = sorted((s for s in language.literals if not s.isalnum()), key=lambda s: (-len(s), s))
    kinds = dict(language.patterns)
    target_name = kinds.pop(_TARGET_NAME)
    kinds["SIGN"] = "|".join(map(re.escape, signs))
    kinds.update(_NO_TOKEN)
    anything = "|".join(f"(?P<{kind}>{pattern})" for kind, pattern in kinds.items())
    return re.compile(anything, re.DOTALL), re.compile(target_name)


def lex(source: Source) -> Tokens:
    """All tokens of a text, in order; takes any text."""
    anything, target_name = _patterns()
    literals = tables().literals
    text = source.text
    found = Tokens(source, [], [], [])
    kinds, starts, ends = found.kinds, found.starts, found.ends
    taken = 0
    for match in anything.finditer(text):
        kind = match.lastgroup
        assert kind is not None
        start, end = match.span()
        if kind == "BLANK" or start < taken:
            continue
        if kind == "SIGN":
            kind = text[start:end]
        elif kind == "NAME":
            word = text[start:end]
            if kinds and kinds[-1] == "target":
                kind = _TARGET_NAME
                whole = target_name.match(text, start)
                if whole is not None:
                    end = taken = whole.end()
                    word = whole.group()
            if word in literals:
                kind = word
        kinds.append(kind)
        starts.append(start)
        ends.append(end)
    return found
