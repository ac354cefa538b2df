"""Builds `tables.py`, the parser's serialised tables, from the grammar.

    python -m nscc.syntax.generate

Building the tables from the grammar takes longer than all of `nscc check` may; a test keeps the
file in step with the grammar.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from pprint import pformat

STARTS = ("statement", "misplaced")


def grammar_path() -> Path:
    """The grammar: beside this module in an installed package, in grammars/ in a checkout."""
    here = Path(__file__).resolve().parent
    installed = here / "nsl.lark"
    return installed if installed.exists() else here.parents[1] / "grammars" / "nsl.lark"


def tables_text(grammar: str) -> str:
    """The text of tables.py for a grammar."""
    from lark import Lark
    from lark.grammar import Rule
    from lark.lexer import TerminalDef

    parser = Lark(grammar, parser="lalr", lexer="basic", start=list(STARTS))
    data, memo = parser.memo_serialize([TerminalDef, Rule])
    digest = hashlib.sha256(grammar.encode()).hexdigest()
    body = pformat(data, width=100, compact=True, sort_dicts=True)
    rest = pformat(memo, width=100, compact=True, sort_dicts=True)
    return (
        '"""Tables of the parser, made by nscc.syntax.generate from grammars/nsl.lark."""\n\n'
        "from typing import Any\n\n"
        f'GRAMMAR_SHA256 = "{digest}"\n\nDATA: dict[str, Any] = {body}\n\n'
        f"MEMO: dict[int, Any] = {rest}\n"
    )


if __name__ == "__main__":
    text = tables_text(grammar_path().read_text(encoding="utf-8"))
    (Path(__file__).parent / "tables.py").write_text(text, encoding="utf-8")
