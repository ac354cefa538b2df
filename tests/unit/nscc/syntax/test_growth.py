"""No text is worse than linear: six times the text takes the parser six times the calls.

What that comes to in seconds is in `tests/benchmarks/bench_syntax.py`.
"""

from __future__ import annotations

import sys
from typing import Any

import pytest
from syntax_text import PIECES, check, over_and_over, read, tile

_SIZE, _TIMES = 1_000, 6
_SLACK = 1.25  # rows and pieces are whole, and what is known already is not asked for again


def calls(text: str) -> int:
    """How many functions are called, those of C included, for all that is said of a text."""
    count = 0

    def see(_frame: Any, event: str, _argument: Any) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(see)
    try:
        check(text)
    finally:
        sys.setprofile(before)
    return count


@pytest.fixture(scope="module", autouse=True)
def _warm() -> None:
    """The grammar is read once, whoever is first."""
    for piece in PIECES:
        read(f"nsl 1\nlet a = {piece}")


@pytest.mark.parametrize("before", ["", "nsl 1\nlet a = "])
@pytest.mark.parametrize("piece", PIECES)
def test_calls_to_read_repeated_text_grow_linearly(piece: str, before: str) -> None:
    short, long = (calls(before + over_and_over(piece, size)) for size in (_SIZE, _TIMES * _SIZE))
    assert long <= _SLACK * _TIMES * short


@pytest.mark.parametrize("cells", ["1,", "1+x,"])
def test_calls_to_read_a_tile_grow_linearly(cells: str) -> None:
    short, long = tile(cells, 2 * _SIZE), tile(cells, 2 * _TIMES * _SIZE)
    file, errors = read(long)
    assert not errors
    assert len(file.statements) == 2
    assert calls(long) <= _SLACK * _TIMES * calls(short)


def test_quadratic_work_would_be_seen() -> None:
    """The measure is one: a second parse of every line is far above the limit."""

    def work(text: str) -> int:
        lines = text.splitlines(keepends=True)
        return sum(calls("".join(lines[:n])) for n in range(len(lines)))

    short, long = ("nsl 1\n" + "let a = 1\n" * n for n in (4, 32))
    assert work(long) > _SLACK * _TIMES * work(short)
