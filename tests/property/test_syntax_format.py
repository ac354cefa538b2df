"""Formatting changes no meaning, loses no comment, and changes nothing the second time."""

from __future__ import annotations

from itertools import pairwise
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from syntax_text import LOOKING_PROGRAMS, PROGRAMS, bare, read, statement_text

from nscc.source import Source
from nscc.syntax import tree as t
from nscc.syntax.format import format_source
from nscc.syntax.lexer import lex

GAPS = (
    " ",
    " ",
    " ",
    "\n",
    "\r\n",
    "\n\n\n",
    "\t",
    "\f",
    " #{}\n",
    "\n  #{} \t\n\n",
    "#{}\r\n",
)
REMARKS = (" remark", "", "#", ' "', " nsl 2", " ä💡", "\t[ 1,", " open when x #")
PROGRAMS_BY_VERSION = st.one_of(
    st.tuples(st.just(1), PROGRAMS), st.tuples(st.just(2), LOOKING_PROGRAMS)
)


def remark(choose: Random, remarks: list[str]) -> str:
    """What may stand between two tokens; a comment among it is numbered and kept in `remarks`."""
    gap = choose.choice(GAPS)
    if "{" not in gap:
        return gap
    remarks.append(f"#{choose.choice(REMARKS)} {len(remarks)}")
    return gap.format(remarks[-1][1:])


def survives(version: int, program: list[t.Statement], seed: int) -> None:
    """The program, written with anything between its tokens, means the same when formatted."""
    written = "\n".join([f"nsl {version}", *map(statement_text, program)])
    tokens = lex(Source("test.nsl", written))
    choose, remarks = Random(seed), list[str]()
    text = "".join(
        remark(choose, remarks) + tokens.text(k) for k in range(len(tokens.kinds))
    ) + remark(choose, remarks)
    found = format_source(Source("test.nsl", text))
    file, errors = read(found)
    assert not errors
    assert bare(file.statements[1:]) == bare(tuple(program))
    # A number ends each remark, and no line end is in one: they are found again as they stand.
    for earlier, later in pairwise(remarks):
        assert found.index(earlier) < found.index(later)
    assert all(f"{each}\n" in found for each in remarks)
    assert format_source(Source("test.nsl", found)) == found
    assert found.endswith("\n")
    assert "\n\n\n" not in found
    assert all(line == line.rstrip() for line in found.split("\n"))


@given(PROGRAMS_BY_VERSION, st.integers(0, 2**32))
def test_trees_and_comments_survive(program: tuple[int, list[t.Statement]], seed: int) -> None:
    survives(*program, seed)


@pytest.mark.slow
@settings(max_examples=10_000, suppress_health_check=list(HealthCheck), deadline=None)
@given(PROGRAMS_BY_VERSION, st.integers(0, 2**32))
def test_ten_thousand_programs_survive_formatting(
    program: tuple[int, list[t.Statement]], seed: int
) -> None:
    survives(*program, seed)
