"""Messages as people, editors and programs get them."""

from __future__ import annotations

import json
import re
import unicodedata

import pytest

from nscc.diagnostics.diagnostic import Diagnostic, Fix, Label, Severity
from nscc.diagnostics.render import names, render
from nscc.source import Source, Span

TEXT = "nsl 1\ntarget scamp5\nframe 16 slots of 1ms\ncode bits : bit[16]\n"


def place(text: str, piece: str, words: str = "") -> Label:
    start = text.index(piece)
    return Label(Span(start, start + len(piece)), words)


def about(text: str, piece: str) -> str:
    """The human form of an error about a piece of a text."""
    return render(
        [Diagnostic("NS0107", "wrong", source=Source("a.nsl", text), label=place(text, piece))],
        "human",
    )


def test_an_error_is_rendered_with_its_lines_and_labels() -> None:
    error = Diagnostic(
        "NS0107",
        "the codes need 16 bits a pixel, the chip has 13",
        source=Source("burst.nsl", TEXT),
        label=place(TEXT, "bit[16]", "16 slots, each free"),
        related=(place(TEXT, "scamp5", "13 registers"),),
        notes=("certain",),
        helps=("use fewer",),
        fixes=(Fix("write 13", place(TEXT, "16]").span, "13]"),),
    )
    assert (
        render([error], "human")
        == """\
error[NS0107]: the codes need 16 bits a pixel, the chip has 13
  --> burst.nsl:4:13
   |
 4 | code bits : bit[16]
   |             ^^^^^^^ 16 slots, each free
 2 | target scamp5
   |        ------ 13 registers
   |
   = certain
help: use fewer
help: write 13
"""
    )
    assert render([error], "short") == (
        "burst.nsl:4:13: error[NS0107]: the codes need 16 bits a pixel, the chip has 13\n"
    )


def test_a_line_with_two_labels_is_shown_once() -> None:
    error = Diagnostic(
        "NS0107",
        "wrong",
        source=Source("a.nsl", TEXT),
        label=place(TEXT, "bit[16]"),
        related=(place(TEXT, "bits", "here"),),
    )
    lines = render([error], "human").splitlines()
    assert lines[3:] == [
        " 4 | code bits : bit[16]",
        "   |             ^^^^^^^",
        "   |      ---- here",
    ]


@pytest.mark.parametrize(
    "before", ["\t", "\t\t x ", "\u4f60\u597d ", "e\u0301 ", "\x1b[2J", "\u202e", "\x07"]
)
def test_marks_are_below_the_marked_text_at_any_character_width(before: str) -> None:
    """After tabs, wide, combining and control characters the marks stand at the width of the text
    before them."""
    line, marks = about(f"{before}WRONG and more", "WRONG").splitlines()[3:5]
    width = sum(
        0 if unicodedata.combining(ch) else 2 if unicodedata.east_asian_width(ch) in "WF" else 1
        for ch in line[: line.index("WRONG")]
    )
    assert marks.index("^^^^^") == width
    assert line.isprintable()


@pytest.mark.parametrize("left", [0, 10, 99, 5_000])
@pytest.mark.parametrize("right", [0, 10, 5_000])
def test_long_lines_are_cut_around_the_place(left: int, right: int) -> None:
    """With up to 5000 characters on each side, the shown line stays below 120 and the five marks
    are below the word."""
    line, marks = about("x" * left + "WRONG" + "y" * right, "WRONG").splitlines()[3:5]
    assert line[marks.index("^") :].startswith("WRONG")
    assert marks.count("^") == 5
    assert len(line) < 120


def test_places_at_the_end_and_over_lines_get_a_mark() -> None:
    source = Source("a.nsl", "let a =\nlet b\n")
    for span in (Span(7, 7), Span(14, 14), Span(4, 12)):
        text = render([Diagnostic("NS0107", "wrong", source=source, label=Label(span))], "human")
        assert "^" in text


def test_coloured_messages_equal_plain_ones_without_escapes() -> None:
    error = Diagnostic(
        "NS0107",
        "wrong",
        Severity.WARNING,
        source=Source("a.nsl", TEXT),
        label=place(TEXT, "frame"),
        notes=("a note",),
        helps=("a help",),
    )
    plain, painted = render([error], "human"), render([error], "human", True)
    assert "\x1b" not in plain
    assert re.sub(r"\x1b\[[0-9;]*m", "", painted) == plain


def test_control_characters_of_the_users_text_are_escaped() -> None:
    error = Diagnostic(
        "NS0107",
        "a\nb\x1b[2J",
        source=Source("x\x1b\n.nsl", "\x1b"),
        label=Label(Span(0, 1), "\x07"),
        notes=("\x1b[2J",),
        helps=("\x9b",),
    )
    for form in ("human", "short"):
        assert all(line.isprintable() for line in render([error], form).splitlines())


def test_json_has_the_promised_keys() -> None:
    error = Diagnostic(
        "NS0107",
        "wrong",
        source=Source("a.nsl", TEXT),
        label=place(TEXT, "bit[16]"),
        fixes=(Fix("write 13", place(TEXT, "16]").span, "13]"),),
        data={"required": 16},
    )
    bare = Diagnostic("NS0101", "cannot read", Severity.NOTE)
    first, second = map(json.loads, render([error, bare], "json").splitlines())
    assert (
        set(first)
        == set(second)
        == {
            "code",
            "name",
            "severity",
            "message",
            "filename",
            "location",
            "end_location",
            "data",
            "fixes",
            "rendered",
        }
    )
    assert first["name"] == names()["NS0107"]
    assert first["location"] == {"row": 4, "column": 13}
    assert first["end_location"] == {"row": 4, "column": 20}
    assert first["data"] == {"required": 16}
    assert first["fixes"][0]["replacement"] == "13]"
    assert first["rendered"] == render([error], "human")
    assert second["severity"] == "note"
    assert second["filename"] is second["location"] is second["end_location"] is None


def test_no_diagnostics_render_as_empty_text() -> None:
    assert [render([], form) for form in ("human", "short", "json")] == ["", "", ""]
