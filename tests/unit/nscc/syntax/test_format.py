"""Formatting: cases as files, what is said on the command line, what is left alone."""

from __future__ import annotations

import io
from pathlib import Path

import pytest
from checkout import ROOT

from nscc.diagnostics.diagnostic import Rejected
from nscc.source import Source
from nscc.syntax.format import WIDTH, format_source
from nscc_cli.main import main

CASES = sorted((ROOT / "tests/cases/fmt").glob("*.nsl"))
UGLY = "nsl 1 frame 8 slots of 1ms\n\n\nopen when n<3#why\n"
NICE = "nsl 1\nframe 8 slots of 1ms\n\nopen when n < 3                     #why\n"


def formatted(text: str) -> str:
    """The text in the one style."""
    return format_source(Source("test.nsl", text))


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_formatting_a_case_gives_the_recorded_text(path: Path) -> None:
    """The formatted text is the recorded one. Formatted again it stays, and no line exceeds
    WIDTH."""
    expected = path.with_suffix(".expected").read_text(encoding="utf-8")
    assert formatted(path.read_text(encoding="utf-8")) == expected
    assert formatted(expected) == expected
    assert max(map(len, expected.splitlines())) <= WIDTH


@pytest.mark.parametrize("path", sorted((ROOT / "examples").glob("*.nsl")), ids=lambda p: p.stem)
def test_the_examples_are_in_the_style(path: Path) -> None:
    """`nscc fmt` changes nothing in an example."""
    text = path.read_text(encoding="utf-8")
    assert formatted(text) == text


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("nsl 1\r\nframe 8 slots of 1ms\r\n", "nsl 1\nframe 8 slots of 1ms\n"),
        ("\n\n# a\n\n\n# b\nnsl 1", "# a\n\n# b\nnsl 1\n"),
        ("nsl 1\nlet a = - ( - 2 )-- 1", "nsl 1\nlet a = -(-2) - -1\n"),
        ("nsl 1\ncode a:bit [4]\nopen when a [n]", "nsl 1\ncode a : bit[4]\nopen when a[n]\n"),
        ("nsl 1\nlet a = min ( 1 ,2 , )", "nsl 1\nlet a = min(1, 2)\n"),
        ('nsl 1 pixels from "a # b" # c', 'nsl 1\npixels from "a # b"                 # c\n'),
        ("nsl 1\n# a\n  # b\n\n\n\n", "nsl 1\n# a\n# b\n"),
    ],
)
def test_formatting_places_blanks_and_breaks(text: str, expected: str) -> None:
    assert formatted(text) == expected


def test_a_program_with_an_error_is_refused() -> None:
    with pytest.raises(Rejected, match="NS0107"):
        formatted("nsl 1\nframe 8")


def test_a_file_is_written_in_place_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "a.nsl"
    path.write_text(UGLY)
    assert main(["fmt", "--check", str(path)]) == 1
    assert path.read_text() == UGLY
    assert "would change" in capsys.readouterr().err
    assert main(["fmt", "--diff", str(path)]) == 0
    assert path.read_text() == UGLY
    assert "+open when n < 3" in capsys.readouterr().out
    assert main(["fmt", str(path)]) == 0
    assert path.read_text() == NICE
    capsys.readouterr()
    assert main(["fmt", str(path)]) == 0
    assert main(["fmt", "--check", "--diff", str(path)]) == 0
    assert capsys.readouterr() == ("", "")


def test_a_bad_file_is_left_alone_and_the_others_are_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The status is 1, the bad file has its old text and the good one is formatted."""
    good, bad = tmp_path / "good.nsl", tmp_path / "bad.nsl"
    good.write_text(UGLY)
    bad.write_text("nsl 1\nopen wen n < 3\n")
    assert main(["fmt", str(bad), str(good)]) == 1
    assert good.read_text() == NICE
    assert bad.read_text() == "nsl 1\nopen wen n < 3\n"
    assert "did you mean `when`" in capsys.readouterr().err


def test_fmt_reads_standard_input_and_prints_the_result(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """With `-` as its name, the text from stdin is printed in its style."""
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(UGLY.encode())))
    assert main(["fmt", "-"]) == 0
    assert capsys.readouterr().out == NICE
