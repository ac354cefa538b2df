"""Lark reads the language from its grammar; what it makes of it is kept, and never trusted."""

from __future__ import annotations

import pickle
from collections.abc import Iterator
from pathlib import Path

import lark
import pytest
from lark.exceptions import UnexpectedInput
from syntax_text import codes

from nscc.cache.store import Store
from nscc.syntax import words as grammar


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Where tables are kept, empty; parsers made here are forgotten afterwards."""
    monkeypatch.setenv("NSCC_CACHE_DIR", str(tmp_path))
    grammar.parser.cache_clear()
    yield tmp_path / "grammar"
    grammar.parser.cache_clear()


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The grammars that lark is given from now on."""
    given: list[str] = []

    class Counted(lark.Lark):
        def __init__(self, text: str, **options: object) -> None:
            given.append(text)
            super().__init__(text, **options)

    monkeypatch.setattr(lark, "Lark", Counted)
    return given


def another_process() -> lark.Lark:
    grammar.parser.cache_clear()
    return grammar.parser()


def takes(parser: lark.Lark, text: str) -> bool:
    try:
        parser.parse(text, start=grammar.START)
    except UnexpectedInput:
        return False
    return True


def replace_tables(folder: Path, tables: bytes) -> None:
    (entry,) = folder.iterdir()
    Store(folder).write(entry.name, tables)


def test_tables_are_made_once_and_kept(folder: Path, made: list[str]) -> None:
    """A second process reads the one stored file and makes no tables. Both parsers accept and
    refuse alike."""
    first = grammar.parser()
    assert grammar.parser() is first
    second = another_process()
    assert made == [grammar.grammar_path().read_text(encoding="utf-8")]
    assert len(list(folder.iterdir())) == 1
    for parser in (first, second):
        assert takes(parser, "frame 8 slots of 1ms")
        assert not takes(parser, "frame 8 slots 1ms")


def test_another_grammar_has_other_tables(
    folder: Path, made: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A changed grammar file makes tables of its own, and its parser takes the changed text."""
    grammar.parser()
    text = grammar.grammar_path().read_text(encoding="utf-8")
    changed = tmp_path / "changed.lark"
    changed.write_text(text.replace('"slots" "of" time', '"slots" time'), encoding="utf-8")
    monkeypatch.setattr(grammar, "grammar_path", lambda: changed)
    assert takes(another_process(), "frame 8 slots 1ms")
    assert len(made) == 2


def test_another_version_of_lark_makes_the_tables_again(
    folder: Path, made: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Tables stored by one version of lark are not read by another."""
    grammar.parser()
    monkeypatch.setattr(lark, "__version__", "99.0")
    another_process()
    assert len(made) == 2


@pytest.mark.parametrize("value", [None, {}, {"data": {}, "memo": {1: 2}}, [1], "text"])
def test_invalid_stored_tables_are_made_again(folder: Path, made: list[str], value: object) -> None:
    """A stored file that holds no tables is replaced once, and the next process reads it."""
    grammar.parser()
    replace_tables(folder, pickle.dumps(value))
    assert takes(another_process(), "open when true")
    another_process()
    assert len(made) == 2


def test_kept_tables_run_no_code(folder: Path, made: list[str], tmp_path: Path) -> None:
    """A pickle that would make a file when it is loaded makes none: the tables are made again."""

    class Evil:
        def __reduce__(self) -> tuple[object, ...]:
            return Path.touch, (tmp_path / "touched",)

    grammar.parser()
    replace_tables(folder, pickle.dumps(Evil()))
    another_process()
    assert len(made) == 2
    assert not (tmp_path / "touched").exists()


@pytest.mark.parametrize("switched_off", [True, False])
def test_parsing_works_without_stored_tables(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, switched_off: bool
) -> None:
    """With the cache off, and with a file in place of its folder, texts are parsed."""
    if switched_off:
        monkeypatch.setenv("NSCC_CACHE", "off")
    else:
        folder.write_text("a file where the folder should be")
    assert takes(grammar.parser(), "open when true")
    assert not folder.is_dir()


@pytest.mark.parametrize("text", ["", "12abc", '"', "é", "\0", "\ud800", "1.2.3", "target -"])
def test_the_lexer_takes_any_text(text: str) -> None:
    """Any text comes out of the lexer whole, but for blanks."""
    state = grammar.parser().parse_interactive(text, start=grammar.START)
    assert "".join(state.lexer_thread.lex(None)) == text.replace(" ", "")


@pytest.mark.parametrize(
    "text",
    [
        "frame 8 slots of 1ms",
        "frame 8 slots 1ms",
        "frame slots [1ms,]",
        "frame slots []",
        "code a : 0..7",
        "code a : 0..",
        "code a : bit[3]",
        "code a : bit 3",
        "code a : row of b",
        "let a = not 1 < 2",
        "let a = 1 < not 2",
        "let a = - - 1",
        "let a = 1 - - 1",
        "let a = 1 +",
        "require a[1][2]",
        "require (1)[2]",
        "require min()",
        "require min(1,)",
        "require a(1)",
        "require a if b",
        "require a if b else c if d else e",
        "open when",
        "open true",
        "bucket a open when n",
        "bucket open when n",
        "shutters a [1, 1_0]",
        "shutters a [1_0 1]",
        'shutters a from "b" key k',
        'shutters a from "b" sha256 "c" key k',
        'pixels from "b"',
        "pixels a = tile [[1], [2]]",
        "pixels a = tile []",
        "pixels a = tile [1]",
    ],
)
def test_the_parser_accepts_what_the_lark_grammar_accepts(text: str) -> None:
    assert (codes(f"nsl 1 {text}") == []) is takes(grammar.parser(), text)
