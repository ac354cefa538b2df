"""The parser of the language, made by lark from the grammar.

Constructing it takes longer than the rest of `nscc check`, so lark's tables are kept in the user's
cache, under the digest of everything that they depend on.
"""

from __future__ import annotations

import pickle
import sys
from functools import cache
from hashlib import sha256
from io import BytesIO
from pathlib import Path
from typing import Any

import lark

from nscc.cache.store import Store, cache_folder

START = "statement"
END = "$END"
"""Lark's terminal for the end of a statement."""

_OPTIONS = {
    "parser": "lalr",
    "lexer": "basic",
    "start": [START, "unread"],
    "keep_all_tokens": True,  # the place of a node is that of its tokens
    "maybe_placeholders": False,
}


class _PlainValues(pickle.Unpickler):
    """Unpickles numbers, texts and collections only, since files in the cache must not run code."""

    def find_class(self, module: str, name: str) -> Any:
        if (module, name) == ("lark.lexer", "Token"):  # a text; lark 1.2 writes some
            return lark.Token
        raise pickle.UnpicklingError(f"{module}.{name} is not a plain value")


def grammar_path() -> Path:
    """The grammar file: beside this module if installed, in grammars/ in a checkout."""
    installed = Path(__file__).with_name("nsl.lark")
    if installed.exists():
        return installed
    return Path(__file__).resolve().parents[2] / "grammars" / "nsl.lark"


@cache
def parser() -> lark.Lark:
    """The parser of one statement; its lexer accepts any text."""
    grammar = grammar_path().read_text(encoding="utf-8")
    folder = cache_folder()
    if folder is None:
        return lark.Lark(grammar, **_OPTIONS)
    store = Store(folder / "grammar")
    decides = (grammar, _OPTIONS, lark.__version__, sys.version_info[:3])
    key = sha256(repr(decides).encode()).hexdigest()
    cached_tables = store.read(key)
    if cached_tables is not None:
        try:
            return lark.Lark.load(_PlainValues(BytesIO(cached_tables)).load())
        except Exception:  # lark may raise anything for data that is not its tables
            pass
    new_parser = lark.Lark(grammar, **_OPTIONS)
    tables = BytesIO()
    new_parser.save(tables)
    store.write(key, tables.getvalue())
    return new_parser


@cache
def spellings() -> dict[str, str]:
    """Keywords and signs by terminal name."""
    return {t.name: t.pattern.value for t in parser().terminals if t.pattern.type == "str"}
