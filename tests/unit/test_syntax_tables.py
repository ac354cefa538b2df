"""The parser's tables say what the grammar says."""

from __future__ import annotations

from pathlib import Path

import pytest
from lark import Lark
from lark.exceptions import UnexpectedInput
from syntax_text import codes

from nscc.syntax.generate import grammar_path, tables_text
from nscc.syntax.tables import tables

GRAMMAR = grammar_path().read_text(encoding="utf-8")


def test_the_tables_are_in_step_with_the_grammar(root: Path) -> None:
    written = (root / "nscc" / "syntax" / "tables.json").read_text(encoding="utf-8")
    assert tables_text(GRAMMAR) == written, "run `python -m nscc.syntax.generate`"


def test_the_tables_are_loaded_once() -> None:
    assert tables() is tables()


@pytest.fixture(scope="module")
def lark() -> Lark:
    return Lark(GRAMMAR, parser="lalr", start="statement")


@pytest.mark.parametrize(
    "text",
    [
        "frame 8 slots of 1ms", "frame 8 slots 1ms", "frame slots [1ms,]", "frame slots []",
        "code a : 0..7", "code a : 0..", "code a : bit[3]", "code a : bit 3", "code a : row of b",
        "let a = not 1 < 2", "let a = 1 < not 2", "let a = - - 1", "let a = 1 - - 1", "let a = 1 +",
        "require a[1][2]", "require (1)[2]", "require min()", "require min(1,)", "require a(1)",
        "require a if b", "require a if b else c if d else e", "open when", "open true",
        "bucket a open when n", "bucket open when n", "shutters a [1, 1_0]", "shutters a [1_0 1]",
        'shutters a from "b" key k', 'shutters a from "b" sha256 "c" key k', 'pixels from "b"',
        "pixels a = tile [[1], [2]]", "pixels a = tile []", "pixels a = tile [1]",
    ],
)  # fmt: skip
def test_what_lark_takes_is_what_is_taken(text: str, lark: Lark) -> None:
    try:
        lark.parse(text)
        taken = True
    except UnexpectedInput:
        taken = False
    assert (codes(f"nsl 1 {text}") == []) is taken
