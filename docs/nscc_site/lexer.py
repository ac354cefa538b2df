"""The colours of shutter programs."""

from __future__ import annotations

import re
from pathlib import Path

from pygments.lexer import RegexLexer, words
from pygments.token import (
    Comment,
    Keyword,
    Name,
    Number,
    Operator,
    Punctuation,
    String,
    Text,
    Whitespace,
)

_GRAMMAR = Path(__file__).resolve().parents[2] / "grammars" / "nsl.lark"
_WORDS = tuple(dict.fromkeys(re.findall(r'"([a-z]+)"', _GRAMMAR.read_text())))


class NslLexer(RegexLexer):
    """The words of the grammar, names, numbers with their units of time, texts and remarks."""

    name = "nsl"
    aliases = ("nsl",)
    tokens = {  # noqa: RUF012 - as pygments asks for it
        "root": [
            (r"#.*?$", Comment.Single),
            (r'"[^"\n]*"', String),
            (words(_WORDS, prefix=r"\b", suffix=r"\b"), Keyword),
            (r"\d+(\.\d+)?(ns|us|ms|s)\b", Number),
            (r"0[xb][\da-fA-F_]+|\d[\d_]*", Number),
            (r"[A-Za-z_]\w*", Name),
            (r"\.\.|[<>=!]=|<<|>>|[-+*/%<>=:]", Operator),
            (r"[\[\](),]", Punctuation),
            (r"\s+", Whitespace),
            (r".", Text),  # what is no program, to show what is said of it
        ]
    }
