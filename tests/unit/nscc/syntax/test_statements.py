"""Every form of a statement, and what of the text each node stands for."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import pytest
from checkout import ROOT
from syntax_text import bare, codes, nodes, read, statement

from nscc.syntax import tree as t
from nscc.syntax.words import FORMS, statement_words

FORMS_READ: dict[str, tuple[Any, ...]] = {
    "target scamp5": ("TargetByName", ("Name", "scamp5")),
    "target scamp5-algorithm1": ("TargetByName", ("Name", "scamp5-algorithm1")),
    "target open-code-2": ("TargetByName", ("Name", "open-code-2")),
    'target "my chips/a.toml"': ("TargetFromFile", ("Text", "my chips/a.toml")),
    "frame 256 slots of 125us": ("EqualSlots", ("Int", 256), ("Time", Fraction(125))),
    "frame N slots of 1.6ms": ("EqualSlots", ("Name", "N"), ("Time", Fraction(1600))),
    "frame 2 slots of 250ns": ("EqualSlots", ("Int", 2), ("Time", Fraction(1, 4))),
    "frame slots [1s, 0.5us,]": (
        "ListedSlots", (("Time", Fraction(10**6)), ("Time", Fraction(1, 2))),
    ),
    "let a = -1": ("Let", ("Name", "a"), ("Unary", "-", ("Int", 1))),
    "code stop : 1..256": ("CodeRange", ("Name", "stop"), ("Int", 1), ("Int", 256)),
    "code stop:-k..2*k": (
        "CodeRange", ("Name", "stop"), ("Unary", "-", ("Name", "k")),
        ("Binary", "*", ("Int", 2), ("Name", "k")),
    ),
    "code b : bit[13]": ("CodeBits", ("Name", "b"), ("Int", 13)),
    "code id : row of book": ("CodeRow", ("Name", "id"), ("Name", "book")),
    "require true": ("Require", ("Bool", True)),
    "shutters book [1111_0000, 0101, 1]": (
        "BookInline", ("Name", "book"),
        (("BookRow", "11110000"), ("BookRow", "0101"), ("BookRow", "1")),
    ),
    'shutters b from "b.npz"': ("BookFromFile", ("Name", "b"), ("Text", "b.npz"), None, None),
    'shutters b from "b.npz" key k sha256 "0f"': (
        "BookFromFile", ("Name", "b"), ("Text", "b.npz"), ("Name", "k"), ("Text", "0f"),
    ),
    'shutters b from "b.npz" sha256 "0f"': (
        "BookFromFile", ("Name", "b"), ("Text", "b.npz"), None, ("Text", "0f"),
    ),
    "open when false": ("Open", ("Bool", False)),
    "bucket early open when n": ("Bucket", ("Name", "early"), ("Name", "n")),
    "pixels a = x": ("PixelsExpr", ("Name", "a"), ("Name", "x")),
    "pixels a = tile [[1, 2,], [x],]": (
        "PixelsTile", ("Name", "a"),
        (("TileRow", (("Int", 1), ("Int", 2))), ("TileRow", (("Name", "x"),))),
    ),
    'pixels from "c.npz"': ("PixelsFromFile", ("Text", "c.npz"), None),
    'pixels from "c.npz" sha256 "0f"': ("PixelsFromFile", ("Text", "c.npz"), ("Text", "0f")),
}  # fmt: skip


@pytest.mark.parametrize("text", FORMS_READ)
def test_a_statement_spans_its_text(text: str) -> None:
    """Each form gives its recorded tree and begins and ends where its text does."""
    node = statement(text)
    assert bare(node) == FORMS_READ[text]
    assert (node.span.start, node.span.end) == (6, 6 + len(text))


def test_every_statement_has_forms_to_show() -> None:
    """`FORMS` has an entry for each statement word of version 4, in its order."""
    assert list(FORMS) == list(statement_words(4))
    assert all(form.split()[0] == word for word, forms in FORMS.items() for form in forms)


def test_places_are_those_of_the_text() -> None:
    text = 'nsl 1\nframe 8 slots of 1ms\nopen when min(n, 2) < b[n + 1] # end\npixels from "a"'
    file, errors = read(text)
    assert not errors
    found = {text[node.span.start : node.span.end] for node in nodes(file)}
    assert found == {
        text,
        "nsl 1",
        "1",
        "frame 8 slots of 1ms",
        "8",
        "1ms",
        "open when min(n, 2) < b[n + 1]",
        "min(n, 2) < b[n + 1]",
        "min(n, 2)",
        "min",
        "n",
        "2",
        "b[n + 1]",
        "b",
        "n + 1",
        'pixels from "a"',
        '"a"',
    }


def test_newlines_blanks_and_comments_mean_nothing() -> None:
    """Line ends, tabs, comments and form feeds in place of blanks give the same tree."""
    text = "nsl 1 frame 8 slots of 1ms bucket a open when n < 3 open when true"
    plain, _ = read(text)
    for blank in ("\n", "\r\n", "\t", ' # nsl 2 "\n', "\f"):
        other, errors = read(text.replace(" ", blank) + blank)
        assert not errors
        assert bare(other) == bare(plain)
    kinds = [type(s) for s in plain.statements]
    assert kinds == [t.Version, t.EqualSlots, t.Bucket, t.Open]


def test_signs_need_no_blanks() -> None:
    """`a:0..7` and `1<<2<-3` are read as with blanks."""
    dense, errors = read("nsl 1 code a:0..7 let b=1<<2<-3 open when n<=a require not(a==7)")
    assert not errors
    spaced, _ = read(
        "nsl 1 code a : 0 .. 7 let b = 1 << 2 < - 3 open when n <= a require not ( a == 7 )"
    )
    assert bare(dense) == bare(spaced)


@pytest.mark.parametrize("name", ["_", "Frame", "nsl1", "minute", "max_", "openwhen", "ms", "us"])
def test_words_that_only_look_reserved_are_names(name: str) -> None:
    """`_`, `Frame`, `openwhen` and even the units `ms` and `us` can be names."""
    assert statement(f"let {name} = {name} + 1").name.text == name


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (f"let a = {2**62 - 1}", None),
        (f"let a = {2**62}", "NS0111"),
        ("let a = " + "0" * 50 + "1", None),
        ("let a = " + "9" * 10_000, "NS0111"),
        ("frame 8 slots of 0us", "NS0112"),
        ("frame 8 slots of 0.000ms", "NS0112"),
        ("frame 8 slots of " + "9" * 10_000 + "us", "NS0111"),
        ("frame 8 slots of 0." + "0" * 10_000 + "1us", "NS0111"),
    ],
)
def test_numbers_beyond_the_limit_are_refused(text: str, code: str | None) -> None:
    assert codes(f"nsl 1\n{text}") == ([] if code is None else [code])


@pytest.mark.parametrize(
    "deep",
    [
        "(" * 5000 + "1" + ")" * 5000,
        "1" + " + 1" * 5000,
        "- " * 5000 + "1",
        "not " * 5000 + "true",
        "1 if true else " * 5000 + "1",
        "b[" * 5000 + "1" + "]" * 5000,
        "max(1, " * 5000 + "1" + ")" * 5000,
    ],
)
def test_nesting_has_a_limit_and_no_recursion(deep: str) -> None:
    assert codes(f"nsl 1 let a = {deep} let b = 1") == ["NS0110"]


@pytest.mark.parametrize(
    "broad", ["0 < " * 5000 + "n", "max(" + "1, " * 5000 + "1)", "1" + " * 2" * 90]
)
def test_long_expressions_without_nesting_are_accepted(broad: str) -> None:
    """5000 comparisons or arguments in a row, and 90 factors, have no error."""
    assert codes(f"nsl 1 require {broad}") == []


def test_programs_on_syntax_pages_give_their_messages() -> None:
    pages = ROOT / "nscc" / "diagnostics" / "pages"
    checked = 0
    for page in sorted(pages.glob("NS01*.md")):
        sections = re.split(r"^## ", page.read_text(encoding="utf-8"), flags=re.MULTILINE)
        for section in sections:
            for program in re.findall(r"```nsl\n(.*?)```", section, flags=re.DOTALL):
                expected = [page.name[:6]] if section.startswith("Bad") else []
                assert codes(program) == expected, page.name
                checked += 1
    # So that the patterns still find the programs of the pages.
    assert checked >= 14


def test_the_tree_is_a_frozen_value() -> None:
    """Equal texts give equal nodes with equal hashes. A node's fields cannot be set, and none may
    be missing."""
    one, other = statement("let a = 1"), statement("let a = 1")
    assert one == other
    assert hash(one) == hash(other)
    assert one != statement("let a = 2")
    with pytest.raises(AttributeError):
        one.name = other.name
    with pytest.raises(TypeError):
        t.Int(one.span)  # type: ignore[call-arg]
