"""Whatever the text, the parser answers: a tree or errors with places in it, in its order."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from syntax_text import PROGRAMS, RESERVED, nodes, read, statement_text

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.render import render
from nscc.syntax.parse import MOST_ERRORS, parse, read_source

SOUP = st.lists(
    st.sampled_from(
        [
            *sorted(RESERVED),
            "n",
            "x",
            "fram",
            "1",
            "07",
            "1_0",
            "1.6ms",
            "5us",
            "500",
            "us",
            "1.5",
            "..",
            ".",
            ":",
            "=",
            "==",
            "<=",
            "<",
            "<<",
            "+",
            "-",
            "*",
            "/",
            "%",
            "(",
            ")",
            "[",
            "]",
            ",",
            ";",
            '"a.npz"',
            '"',
            "#",
            "\n",
            "\t",
            "&&",
            "!",
            "\u00e9",
            "\u2264",
            "9" * 25,
        ]
    ),
    max_size=40,
)
_RAW = st.text(st.characters(codec="utf-8"), max_size=200)


def check(text: str) -> None:
    file, errors = read(text)
    assert len(errors) <= MOST_ERRORS + 1
    places = [d.label.span for d in errors if d.label is not None]
    assert places == sorted(places, key=lambda span: span.start)
    for node in nodes(file):
        assert 0 <= node.span.start <= node.span.end <= len(text)
    for error in errors:
        labels = [*([error.label] if error.label else []), *error.related]
        for span in (*(label.span for label in labels), *(fix.span for fix in error.fixes)):
            assert 0 <= span.start <= span.end <= len(text)
        assert "\n" not in error.message
    for line in render(errors, "json").splitlines():
        assert json.loads(line)["severity"] == "error"
    for line in render(errors, "human").splitlines():
        assert line.isprintable(), line


@given(_RAW)
@example("")
@example("\ufeffnsl 1")
@example("nsl 1 \u2028 open when true")
@example('nsl 1 target "')
@example("nsl 1 pixels a = tile [[")
@example("nsl 1 pixels a = tile [[1,],[2]")
def test_any_text_is_parsed_or_refused(text: str) -> None:
    check(text)


@given(SOUP, st.sampled_from([" ", "", "\n"]))
def test_any_sequence_of_words_is_parsed_or_refused(words: list[str], blank: str) -> None:
    check(blank.join(words))
    check("nsl 1\n" + blank.join(words))


@given(PROGRAMS, st.data())
def test_a_right_program_with_one_change_never_crashes_the_parser(
    program: list[object], data: st.DataObject
) -> None:
    text = "\n".join(["nsl 1", *map(statement_text, program)])
    start = data.draw(st.integers(0, len(text)))
    end = data.draw(st.integers(start, min(len(text), start + 6)))
    put = data.draw(
        st.sampled_from(["", " ", ",", ")", "]", "(", "let", "=", '"', "1", "if", "\0"])
    )
    check(text[:start] + put + text[end:])


@given(PROGRAMS, st.data())
def test_an_error_hides_no_other_statement(program: list[object], data: st.DataObject) -> None:
    texts = list(map(statement_text, program))
    wrong = data.draw(st.integers(0, len(texts)))
    broken = data.draw(
        st.sampled_from(["let = 1", "code c : 0..", "open when (n", "frame 8 slots"])
    )
    file, errors = read("\n".join(["nsl 1", *texts[:wrong], broken, *texts[wrong:]]))
    assert len(errors) == 1
    assert len(file.statements) == 1 + len(texts)


@given(data=st.binary(max_size=300))
@example(data=b"\xff\xfe")
@example(data=b"nsl 1\0")
def test_any_bytes_are_read_or_refused(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "any.nsl"
    path.write_bytes(data)
    try:
        data.decode("utf-8")
        is_text = b"\0" not in data
    except UnicodeDecodeError:
        is_text = False
    if is_text:
        parse(read_source(path))
    else:
        with pytest.raises(Rejected, match="NS0102"):
            read_source(path)


def test_applied_fixes_leave_a_valid_program() -> None:
    """`500 us` and `n = 3` each have one fix. With both applied the text has no error."""
    text = "nsl 1\nframe 8 slots of 500 us\nopen when n = 3 and true"
    _, errors = read(text)
    for error in sorted(errors, key=lambda d: -d.fixes[0].span.start):
        (fix,) = error.fixes
        text = text[: fix.span.start] + fix.replacement + text[fix.span.end :]
    assert read(text)[1] == ()


@pytest.mark.parametrize("word", sorted(RESERVED))
def test_no_reserved_word_is_a_name(word: str) -> None:
    assert read(f"nsl 1\nlet {word} = 1")[1]
