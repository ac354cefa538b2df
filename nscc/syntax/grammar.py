"""Lark's parser of the language, made from the grammar.

Making it takes longer than all the rest of `nscc check`. So the tables that lark makes are kept in
the user's cache, under the digest of all that decides them; where nothing can be kept there, they
are made every time.
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
"""The terminal that lark sees after the last token of a statement."""

_OPTIONS = {
    "parser": "lalr",
    "lexer": "basic",
    "start": [START, "unread"],
    "keep_all_tokens": True,  # the place of a node is that of its tokens
    "maybe_placeholders": False,
}


class _PlainValues(pickle.Unpickler):
    """Reads numbers, texts and collections only: a file in the cache must not run code."""

    def find_class(self, module: str, name: str) -> Any:
        if (module, name) == ("lark.lexer", "Token"):  # a text; lark 1.2 writes some
            return lark.Token
        raise pickle.UnpicklingError(f"{module}.{name} is not a plain value")


def grammar_path() -> Path:
    """The grammar: beside this module in an installed package, in grammars/ in a checkout."""
    installed = Path(__file__).with_name("nsl.lark")
    if installed.exists():
        return installed
    return Path(__file__).resolve().parents[2] / "grammars" / "nsl.lark"


@cache
def parser() -> lark.Lark:
    """The parser of one statement; its lexer takes any text."""
    grammar = grammar_path().read_text(encoding="utf-8")
    folder = cache_folder()
    if folder is None:
        return lark.Lark(grammar, **_OPTIONS)
    store = Store(folder / "grammar")
    decides = (grammar, _OPTIONS, lark.__version__, sys.version_info[:3])
    key = sha256(repr(decides).encode()).hexdigest()
    kept = store.read(key)
    if kept is not None:
        try:
            return lark.Lark.load(_PlainValues(BytesIO(kept)).load())
        except Exception:  # whatever lark says to values that are not its tables
            pass
    made = lark.Lark(grammar, **_OPTIONS)
    tables = BytesIO()
    made.save(tables)
    store.write(key, tables.getvalue())
    return made


@cache
def spellings() -> dict[str, str]:
    """The words and signs that stand for themselves, by the names of their terminals."""
    return {t.name: t.pattern.value for t in parser().terminals if t.pattern.type == "str"}
