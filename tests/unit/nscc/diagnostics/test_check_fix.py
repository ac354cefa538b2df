"""`nscc check --fix`: what has one sure remedy is mended, the rest stays its author's."""

from __future__ import annotations

from pathlib import Path

import pytest

from nscc.diagnostics.diagnostic import Diagnostic, Fix
from nscc.diagnostics.message import with_safe_fixes
from nscc.source import Source, Span
from nscc_cli.main import main

BAD = "frame 8 slots of 1 msec\ncode a : 0..3;\nrequire a = 2\nopen when n =< a\npixels a = [[2]]\n"
GOOD = (
    "nsl 1\nframe 8 slots of 1ms\ncode a : 0..3\nrequire a == 2\nopen when n <= a\n"
    "pixels a = tile [[2]]\n"
)


def with_fixes(source: Source, *fixes: Fix) -> Diagnostic:
    return Diagnostic("NS0107", "wrong", source=source, fixes=fixes)


def test_check_fix_applies_all_safe_fixes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The first call writes the mended text. The second finds nothing to mend and leaves the
    file."""
    path = tmp_path / "a.nsl"
    path.write_text(BAD)
    assert main(["check", "--fix", str(path)]) == 0
    assert path.read_text() == GOOD
    assert "fixed" in capsys.readouterr().err
    assert main(["check", "--fix", str(path)]) == 0
    assert "fixed" not in capsys.readouterr().err
    assert path.read_text() == GOOD


def test_names_are_not_guessed_at(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A misspelt name is proposed, but not written: it might be another one."""
    text = "nsl 1\nframe 8 slots of 1ms\ncode stop : 1..8\nopen when n < stopp\n"
    path = tmp_path / "a.nsl"
    path.write_text(text)
    assert main(["check", "--fix", str(path)]) == 1
    assert path.read_text() == text
    assert "did you mean `stop`" in capsys.readouterr().err


def test_without_the_option_nothing_is_written(tmp_path: Path) -> None:
    """`nscc check` alone ends with status 1 and leaves the faulty file as it is."""
    path = tmp_path / "a.nsl"
    path.write_text(BAD)
    assert main(["check", str(path)]) == 1
    assert path.read_text() == BAD


def test_of_fixes_that_overlap_one_is_taken() -> None:
    """Of two overlapping fixes the shorter, and one apart, are applied. One that is unsure or for
    another text is not."""
    source = Source("a.nsl", "abcdef")
    one, other = Fix("", Span(1, 4), "X"), Fix("", Span(2, 3), "Y")
    apart, unsure = Fix("", Span(4, 6), "Z"), Fix("", Span(0, 1), "?", sure=False)
    found, count = with_safe_fixes(
        source, [with_fixes(source, fix) for fix in (one, other, apart, unsure)]
    )
    assert (found.text, count) == ("abYdZ", 2)
    elsewhere = Source("b.nsl", "other text")
    assert with_safe_fixes(source, [with_fixes(elsewhere, one)]) == (source, 0)


def test_equal_insertions_at_one_place_are_applied_once() -> None:
    source = Source("a.nsl", "ab")
    fix = Fix("", Span(1, 1), "-")
    assert with_safe_fixes(source, [with_fixes(source, fix)] * 2)[0].text == "a-b"
