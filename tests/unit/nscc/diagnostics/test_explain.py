"""`nscc explain`, and the names that messages suggest."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from nscc_command import invoke

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.explain import index, page
from nscc.diagnostics.render import PAGES, names
from nscc.diagnostics.suggest import closest


@pytest.mark.parametrize(
    "asked",
    [
        "NS0107",
        "ns0107",
        " NS0107 ",
        "syntax",
        "SYNTAX",
        "107",
        "0107",
        "NS107",
        "error[NS0107]",
        "error[NS0107]: in this `frame` statement: expected `slots`",
    ],
)
def test_a_page_is_found_by_code_and_by_name(asked: str) -> None:
    assert page(asked) == (PAGES / "NS0107-syntax.md").read_text(encoding="utf-8")


def test_the_index_names_every_code_once() -> None:
    """Each line of the index begins with a code and its name, in the order of the pages."""
    assert [line.split()[:2] for line in index().splitlines()] == [*map(list, names().items())]


@pytest.mark.parametrize(("asked", "meant"), [("NS0197", "NS0107"), ("sytax", "syntax")])
def test_a_misspelt_code_is_guessed(asked: str, meant: str) -> None:
    """NS0197 proposes NS0107, and `sytax` proposes `syntax`; both are NS0790 with status 2."""
    with pytest.raises(Rejected) as caught:
        page(asked)
    (error,) = caught.value.diagnostics
    assert (error.code, caught.value.status) == ("NS0790", 2)
    assert meant in error.helps[0]


@pytest.mark.parametrize("asked", ["", "x" * 10_000, "../../etc/passwd", "NS9999", "\x1b[2J", "\0"])
def test_explain_refuses_an_unknown_code_with_one_error(asked: str, tmp_path: Path) -> None:
    """An empty, endless or unknown code, a path and control characters give NS0790. The message
    holds no control characters."""
    found = invoke(["explain", asked], tmp_path)
    assert (found.status, found.codes, found.out) == (2, ["NS0790"], "")
    assert all(line.isprintable() for line in found.err.splitlines())


def test_the_command_prints_pages_and_index(tmp_path: Path) -> None:
    """With a code the command prints its page, without one the index."""
    assert invoke(["explain", "NS0107"], tmp_path).out == page("NS0107")
    assert invoke(["explain"], tmp_path).out == index()


def test_explaining_needs_no_arrays() -> None:
    from subprocess import run

    code = "import sys, nscc_cli.guide as e; e.page('NS0107'); print('numpy' in sys.modules)"
    assert run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "False\n"


@pytest.mark.parametrize(
    ("name", "candidates", "meant"),
    [
        ("stpo", ["stop", "start"], "stop"),
        ("Stop", ["start", "stop"], "stop"),
        ("fram", ["let", "frame"], "frame"),
        ("zebra", ["stop", "start"], None),
        ("stop", [], None),
        ("b" * 10_000, ["b" * 10_000 + "c"], None),
        ("ab", ["ac", "aa"], "aa"),
        ("len", ["N", "n"], None),
        ("N", ["n"], "n"),
    ],
)
def test_the_closest_name_is_suggested(name: str, candidates: list[str], meant: str | None) -> None:
    assert closest(name, candidates) == meant
    assert closest(name, reversed(candidates)) == meant
