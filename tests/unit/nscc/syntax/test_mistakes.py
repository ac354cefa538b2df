"""What is said of the mistakes that people make: the code, the place, and what to do."""

from __future__ import annotations

import pytest
from syntax_text import codes, read

from nscc.diagnostics.diagnostic import Diagnostic
from nscc.source import Source
from nscc.syntax.parse import MOST_ERRORS, parse


def the_error(text: str) -> Diagnostic:
    _, errors = read(text)
    assert len(errors) == 1, [e.message for e in errors]
    return errors[0]


def words_of(error: Diagnostic) -> str:
    fixes = [fix.title for fix in error.fixes]
    return "\n".join([error.message, *error.notes, *error.helps, *fixes])


MISTAKES = [
    # text after `nsl 1`, code, the marked text, words of the message, replacement or None
    ("frame 8 slots of 500 us", "NS0107", "500", "no blank", "500us"),
    ("frame 8 slots of 500", "NS0107", "500", "a time such as", None),
    ("frame 8 slots 1ms", "NS0107", "1ms", "expected `of`", None),
    ("frame 8 slot of 1ms", "NS0107", "slot", "did you mean `slots`", "slots"),
    ("frame 8.5 slots of 1ms", "NS0107", "8.5", "only times have decimals", None),
    ("frame 8 slots of 250\u00b5s", "NS0107", "250\u00b5s", "units are ns, us", "250us"),
    ("frame 8 slots of 250\u03bcs", "NS0107", "250\u03bcs", "units are ns, us", "250us"),
    ("frame 8 slots of 2.5 \u03bcs", "NS0107", "2.5", "no blank", "2.5us"),
    ("frame 8 slots of 250usec", "NS0107", "250usec", "units are ns, us", "250us"),
    ("frame 8 slots of 250 microseconds", "NS0107", "250", "no blank", "250us"),
    ("frame slots [1ms, 2MS]", "NS0107", "2MS", "units are ns, us", "2ms"),
    ("frame 8 slots of 1.5min", "NS0107", "1.5min", "only times have decimals", None),
    ("let a = N * 0.5", "NS0107", "0.5", "`N * 0.5` is written `N / 2`", None),
    ("let a = N / 0.5", "NS0107", "0.5", "`N / 0.5` is written `N * 2`", None),
    ("let a = 0.75 * N", "NS0107", "0.75", "`N * 0.75` is written `N * 3 / 4`", None),
    ("let a = (N + 1) * 2.0", "NS0107", "2.0", "`A * 2.0` is written `A * 2`", None),
    ("let a = N + 0.5", "NS0107", "0.5", "numbers are integers", None),
    ("pixels a = [[1, 2], [3, 4]]", "NS0107", "[", "`tile` before the rows", "tile "),
    ("pixels a = [1, 2]", "NS0107", "[", "rows of values are a tile", None),
    ("pixels a = tile [1, 2]", "NS0107", "1", "a single row `tile [[4, 3]]`", None),
    ("pixels a = tile [[1, 2]; [3, 4]]", "NS0108", ";", "with commas", ","),
    ("pixels a = y ? 1 : 2", "NS0108", "?", "`A if CONDITION else B`", None),
    ("pixels a = if x > 2 then 1 else 2", "NS0107", "if", "`A if CONDITION else B`", None),
    ("pixels a = (row + 1) % 2", "NS0107", "row", "`y` is a pixel's row", None),
    ("pixels a = random(1, 8)", "NS0107", "(", "random codes are data", None),
    ("pixels a = codes.npz", "NS0108", ".", 'in quotes: "codes.npz"', None),
    ('pixels a from "codes.npz"', "NS0107", "from", '`pixels from "codes.npz"`', None),
    ("target scamp5.toml", "NS0108", ".", 'in quotes: "scamp5.toml"', None),
    ("frame 8 slots of 1", "NS0107", "1", "every time has a unit", None),
    ("frame slots [1, 2] ms", "NS0107", "1", "every time has a unit", None),
    ("code a : [1, 8]", "NS0107", "[", "LO..HI", None),
    ("code a : bits[8]\nrequire true", "NS0107", "", "did you mean `bit`?", None),
    ("code a : 1-8\nrequire true", "NS0107", "", "two dots between them", None),
    ("open when a & 3", "NS0108", "&", "bit i of a field", "and"),
    ("open when (a >> n) % 2 == 1", "NS0107", ">", "the language has no `>>`", None),
    ("open when book[a][n]", "NS0107", "[", "one index is enough", None),
    ("open when n <> 4", "NS0107", ">", "it is written `!=`", "!="),
    ("open when n =< 4", "NS0107", "=", "it is written `<=`", "<="),
    ("open when n => 4", "NS0107", "=", "it is written `>=`", ">="),
    ("open when ~true", "NS0108", "~", "`not`", "not "),
    ("open when 0x1F < n", "NS0107", "0x1F", "numbers are decimal: 31", None),
    ("frame 1_000 slots of 1ms", "NS0107", "1_000", "digits in groups", None),
    ("frame 8 slots of 5msec", "NS0107", "5msec", "ns, us, ms and s", "5ms"),
    ("open when n = 3", "NS0107", "=", "equality is written `==`", "=="),
    ("open when n < 3;", "NS0108", ";", "no semicolon", ""),
    ("open when n < 3 && n > 1", "NS0108", "&&", "`and`", "and"),
    ("open when n < 3 || n > 1", "NS0108", "||", "`or`", "or"),
    ("open when !true", "NS0108", "!", "`not`", "not "),
    ("open when n \u2264 3", "NS0108", "\u2264", "`<=`", "<="),
    ("open when n < 3)", "NS0107", ")", "has no opening bracket", None),
    ("for i in 1..3", "NS0109", "for", "there are no loops", None),
    ("def f(x)", "NS0109", "def", "`let NAME = EXPR` names an expression", None),
    ("frame 8 slots of 1ms // slow", "NS0107", "/", "comments begin with `#`", None),
    ("code a : 1-16", "NS0107", "", "`1..16`", None),
    ("code a : 1\u201316", "NS0108", "\u2013", "a range has two dots", ".."),
    ("code a\uff1a 1..16", "NS0108", "\uff1a", "write `:`", ":"),
    ("open when n \u2014 1 < 3", "NS0108", "\u2014", "it is written `-`", "-"),
    ("let a = (if n < 3 then 1 else 2) + 1", "NS0107", "if", "`1 if n < 3 else 2`", None),
    ("open when n < 3 // always", "NS0107", "/", "comments begin with `#`", None),
    ("open when 1 + not true", "NS0107", "not", "put brackets around it", None),
    ("code a : 0 . 7", "NS0108", ".", "two dots", None),
    ("code a = 0..7", "NS0107", "=", "expected `:`", None),
    ("code of : 0..7", "NS0113", "of", "reserved word", None),
    ("let frame = 3", "NS0113", "frame", "reserved word", None),
    ("let open = 3", "NS0113", "open", "reserved word", None),
    ("let min = 3", "NS0113", "min", "reserved word", None),
    ("shutters tile [1]", "NS0113", "tile", "reserved word", None),
    ("bucket open open when true", "NS0113", "open", "reserved word", None),
    ("let caf\u00e9 = 3", "NS0108", "caf\u00e9", "letters a-z", None),
    ('target "chip.toml', "NS0114", '"chip.toml', "closing quotation mark is missing", None),
    ("pixels a = tile [[1 2]]", "NS0107", "2", "expected `,` or `]`", None),
    ("pixels a = tile [[1], 2]", "NS0107", "2", "expected `[`", None),
    ("shutters b [1100 0011]", "NS0107", "0011", "commas", None),
    ("pixels a = 3ms", "NS0107", "3ms", "only `frame` uses times", None),
    ("let a = 12abc", "NS0107", "12abc", "names begin with a letter", None),
    ("fram 8 slots of 1ms", "NS0109", "fram", "did you mean `frame`", "frame"),
    ("let a = 1\nhello", "NS0109", "hello", "statements begin with nsl, target", None),
    ("slots 8", "NS0109", "slots", "`frame 64 slots of 125us`", None),
    ("let a = 1\nwhen n < a", "NS0109", "when", "statements begin with nsl, target", None),
    ("let a = 1\nif n < a: 2", "NS0107", ":", "write `open when CONDITION`", None),
    ("open when n < {1, 2}", "NS0108", "{", "a list is written `[1, 2, 3]`", None),
]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "code", "marked", "words", "replacement"), MISTAKES, ids=[m[0] for m in MISTAKES]
)
def test_a_mistake_has_its_code_place_and_remedy(
    text: str, code: str, marked: str, words: str, replacement: str | None
) -> None:
    whole = f"nsl 1\n{text}\n"
    error = the_error(whole)
    assert error.code == code
    assert error.label is not None
    assert whole[error.label.span.start : error.label.span.end] == marked
    assert words in words_of(error)
    assert [fix.replacement for fix in error.fixes] == (
        [] if replacement is None else [replacement]
    )
    for fix in error.fixes:
        mended = whole[: fix.span.start] + fix.replacement + whole[fix.span.end :]
        assert codes(mended) == []


@pytest.mark.parametrize(
    "text",
    [
        "let",
        "let a",
        "let a =",
        "let a = 1 +",
        "code a : 1..",
        "code a : bit[3",
        "open when (n < 3",
        "open",
        "bucket",
        "bucket a open",
        "frame",
        "frame 8 slots of",
        "frame slots [1ms,",
        "target",
        "pixels a = tile [[1, 2],[3,4]",
        "pixels from",
        'shutters b from "x" key',
        "require",
    ],
)
def test_an_incomplete_statement_is_reported_at_its_end(text: str) -> None:
    at_the_end = the_error(f"nsl 1\n{text}")
    assert at_the_end.code == "NS0107"
    assert "the end of the file" in at_the_end.message
    before_another = the_error(f"nsl 1\n{text} # no more\nrequire true")
    assert "`require`" in before_another.message
    for error in (at_the_end, before_another):
        assert error.label is not None
        assert error.label.span.end == 6 + len(text)


def test_a_range_after_in_is_an_error_that_suggests_a_list() -> None:
    """`n in 1..3` gives NS0107, which proposes `n in [1, 2, 3]`."""
    error = the_error("nsl 2\nopen when n in 1..3\n")
    assert error.code == "NS0107"
    assert "`n in [1, 2, 3]`" in words_of(error)


def test_the_error_for_a_missing_bracket_points_at_the_open_one() -> None:
    text = "nsl 1\nopen when (n < min(2, 3)"
    (related,) = the_error(text).related
    assert related.span.start == text.index("(")


def test_all_errors_come_at_once_and_in_order() -> None:
    text = (
        "nsl 1\nfram 8 slots of 500 us\ncode a = 0..7\nlet b = 1;\n"
        "open when n <\npixles a = tile [[1 2]]\nlet c = 1\n"
    )
    file, errors = read(text)
    rows = [Source("", text).row_column(e.label.span.start)[0] for e in errors if e.label]
    assert rows == [2, 2, 3, 4, 5, 6, 6]
    assert [e.code for e in errors] == [
        "NS0109",
        "NS0107",
        "NS0107",
        "NS0108",
        "NS0107",
        "NS0109",
        "NS0107",
    ]
    assert [type(s).__name__ for s in file.statements] == ["Version", "Let", "Let"]


def test_parsing_continues_with_the_statement_that_a_misspelt_word_suggests() -> None:
    """`Frame` and `opne` are errors NS0109, and the tree still has the frame and the rule."""
    file, errors = read("nsl 1\nFrame 8 slots of 1ms\nopne when true")
    assert [e.code for e in errors] == ["NS0109", "NS0109"]
    assert [type(s).__name__ for s in file.statements] == ["Version", "EqualSlots", "Open"]


@pytest.mark.parametrize("count", [MOST_ERRORS - 1, MOST_ERRORS, MOST_ERRORS + 1, 500])
def test_errors_beyond_the_limit_are_only_counted(count: int) -> None:
    """MOST_ERRORS are shown. A last message counts the rest."""
    _, errors = read("nsl 1\n" + "let = 1\n" * count)
    assert [e.code for e in errors[:MOST_ERRORS]] == ["NS0107"] * min(count, MOST_ERRORS)
    rest = [e.message for e in errors[MOST_ERRORS:]]
    more = count - MOST_ERRORS
    if more <= 0:
        assert rest == []
    else:
        assert rest == [f"and {more} more error{'s' if more > 1 else ''} in the text"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", ["NS0104"]),
        ("# only a comment\n", ["NS0104"]),
        ("open when true", ["NS0104"]),
        ("open when true nsl 1", ["NS0104"]),
        ("nls 1\nopen when true", ["NS0104"]),
        ("nsl 1 nsl 1", ["NS0104"]),
        ("nsl 1 open when true nsl 1", ["NS0104"]),
        ("nsl 2 open when true", []),
        ("nsl 5 open when true", ["NS0106"]),
        ("nsl 02 sense b when light > 45% at n == 2 open when b", []),
        ("nsl 01 let sense = 1 open when n < sense", []),
        ("nsl 1 sense", ["NS0109"]),
        ("nsl 1 let sense = 1 code read : 0..1", []),
        ("nsl 0", ["NS0106"]),
        ("nsl", ["NS0107"]),
        ("nsl one", ["NS0107"]),
        ("# comment\n\n  nsl 1\n", []),
    ],
)
def test_invalid_version_lines_are_refused(text: str, expected: list[str]) -> None:
    assert codes(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "module counter {\n input a;\n}\n",
        "declare counter interface {\n input a[8];\n}\nmodule counter { reg r[8] = 0; }\n",
        "/* a counter */\ndeclare counter { output q; }",
        "// a counter\nmodule counter { func_in go; }",
        '#include "defs.h"\n#define WIDTH 8\nmodule counter { }',
        "struct pair { a[4]; b[4]; };",
    ],
)
def test_files_of_the_hardware_language_get_one_friendly_error(text: str) -> None:
    error = the_error(text)
    assert error.code == "NS0105"
    assert "nsl 1" in words_of(error)


def test_too_long_texts_are_refused() -> None:
    """300 000 letters, and 90 000 characters of three bytes, give NS0103."""
    _, errors = parse(Source("long.nsl", "nsl 1 #" + "x" * 300_000))
    assert [e.code for e in errors] == ["NS0103"]
    _, errors = parse(Source("long.nsl", "nsl 1 #" + "\u4e2d" * 90_000))
    assert [e.code for e in errors] == ["NS0103"]
