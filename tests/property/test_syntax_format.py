"""Formatting changes no meaning, loses no comment, and changes nothing the second time."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from syntax_text import PROGRAMS, bare, read, statement_text

from nscc.source import Source
from nscc.syntax import tree as t
from nscc.syntax.format import format_source
from nscc.syntax.lexer import lex

GAPS = st.sampled_from([" ", " ", " ", "\n", "\r\n", "\n\n\n", "\t", " #{}\n", "\n  # {} \n\n"])


@given(PROGRAMS, st.data())
def test_trees_and_comments_survive(program: list[t.Statement], data: st.DataObject) -> None:
    written = "\n".join(["nsl 1", *map(statement_text, program)])
    tokens = lex(Source("test.nsl", written))
    text, comments = "", []
    for k in range(len(tokens.kinds)):
        gap = data.draw(GAPS)
        if "{" in gap:
            comments.append(f"comment {k}")
            gap = gap.format(comments[-1])
        text += gap + tokens.text(k)
    found = format_source(Source("test.nsl", text))
    file, errors = read(found)
    assert not errors
    assert bare(file.statements[1:]) == bare(tuple(program))
    kept = [line.rpartition("#")[2].strip() for line in found.split("\n") if "comment " in line]
    assert kept == comments
    assert format_source(Source("test.nsl", found)) == found
    assert found.endswith("\n")
    assert "\n\n\n" not in found
    assert all(line == line.rstrip() for line in found.split("\n"))
