"""Programs beside what `nscc check` says of them: tests/cases/pass and tests/cases/fail.

`pytest tests/e2e/test_cases.py --update-cases` rewrites the texts; read the difference.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from checkout import ROOT
from nscc_command import Outcome, invoke

CASES = ROOT / "tests/cases"
PASS, FAIL = (sorted((CASES / kind).glob("*.nsl")) for kind in ("pass", "fail"))


def named(paths: list[Path]) -> list[object]:
    """The cases as parameters, under the names of their files."""
    return [pytest.param(path, id=path.stem) for path in paths]


@pytest.mark.parametrize("path", named(PASS))
def test_programs_that_pass_print_the_recorded_text(path: Path, update_cases: bool) -> None:
    """Each case of the folder `pass` ends with status 0 and without an error line. Its output is
    the recorded text."""
    found = said_as_expected(path, update_cases)
    assert found.status == 0
    assert not [line for line in found.err.splitlines() if line.startswith("error")]


@pytest.mark.parametrize("path", named(FAIL))
def test_programs_that_fail_print_the_recorded_messages(path: Path, update_cases: bool) -> None:
    """Each case of the folder `fail` ends with status 1 or 2. It prints the recorded messages on
    stderr and nothing on stdout."""
    found = said_as_expected(path, update_cases)
    assert found.status in (1, 2)
    assert found.out == ""


def test_every_text_belongs_to_a_program() -> None:
    texts = {path.with_suffix("") for path in CASES.glob("*/*.txt")}
    assert texts == {path.with_suffix("") for path in PASS + FAIL}


def test_some_case_shows_each_family_of_messages() -> None:
    """The recorded texts hold an error of NS01, NS02, NS03, NS04 and NS06 and a note of NS05."""
    text = "".join(path.with_suffix(".txt").read_text() for path in PASS + FAIL)
    for family in ("NS01", "NS02", "NS03", "NS04", "NS06"):
        assert f"error[{family}" in text, family
    assert "note[NS05" in text, "what only a search can tell is a note of check, an error of build"


def said_as_expected(path: Path, update: bool) -> Outcome:
    """What `nscc check` says of a case, after comparing it with the text beside it."""
    found = invoke(["check", path.name], path.parent)
    said = found.err + found.out
    beside = path.with_suffix(".txt")
    if update:
        beside.write_text(said)
    assert beside.exists(), f"{path.name} has no text beside it: run with --update-cases"
    assert said == beside.read_text(), f"{path.name}: run with --update-cases if this is meant"
    return found
