"""Every error has its code, its place and its words; nothing is reported twice."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import pytest
from program_oracle import program_of

import nscc.diagnostics
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.diagnostics.message import MOST_ERRORS
from nscc.program.analyse import analyse
from nscc.program.problems import Problems
from nscc.source import Source, Span
from nscc.syntax import tree as t

FRAME = "nsl 1 frame 8 slots of 1ms "
STOP = FRAME + "code stop : 0..8 "


def errors(text: str, **more: object) -> list[Diagnostic]:
    with pytest.raises(Rejected) as caught:
        program_of(text, **more)
    assert caught.value.status == 1
    return [d for d in caught.value.diagnostics if d.severity == "error"]


def placed(diagnostic: Diagnostic) -> str:
    assert diagnostic.source is not None
    assert diagnostic.label is not None
    return diagnostic.source.text[diagnostic.label.span.start : diagnostic.label.span.end]


ONE_ERROR = [
    ("nsl 1 frame 4 slots of 1ms", "NS0204", "nsl 1"),
    ("nsl 1 open when true", "NS0204", "nsl 1"),
    (FRAME + "frame 9 slots of 1ms open when n < N", "NS0205", "frame 9 slots of 1ms"),
    (FRAME + "open when true open when false", "NS0205", "open when false"),
    (FRAME + "target scamp5 target scamp7 open when true", "NS0205", "target scamp7"),
    (FRAME + "bucket a open when true open when true", "NS0206", "open when true"),
    (FRAME + "bucket a open when true bucket a open when n < 2", "NS0201", "a"),
    (FRAME + "let a = 1 code a : 0..3 open when n < a pixels a = 9", "NS0201", "a"),
    (FRAME + "code x : 0..3 open when n < 2 pixels x = 9", "NS0202", "x"),
    (FRAME + "let a = b + 1 let b = a let c = b open when n < c", "NS0203", "a"),
    (FRAME + "let a = a open when n < 3", "NS0203", "a"),
    ("nsl 1 let a = N frame a slots of 1ms code s : 0..a open when n < s", "NS0203", "a"),
    (STOP + "open when n < y", "NS0208", "y"),
    (STOP + "require n < stop open when n < stop", "NS0208", "n"),
    (STOP + "open when n < stop pixels stop = n", "NS0208", "n"),
    (STOP + "code a : 0..3 open when n < stop + a pixels stop = a pixels a = 3", "NS0208", "a"),
    (FRAME + "let a = n open when n < a", "NS0208", "n"),
    (STOP + "open when stop[n]", "NS0209", "stop"),
    (STOP + "code id : row of stop open when n < id", "NS0209", "stop"),
    (FRAME + "shutters b [11110000] code id : row of b open when b", "NS0209", "b"),
    (STOP + "let a = 3 open when n < stop + a pixels a = 3 pixels stop = 2", "NS0209", "a"),
    (STOP + "code a : 0..1 open when a < n < stop pixels stop = 3", "NS0210", "a"),
    (STOP + "open when n < stop pixels stop = 3 pixels stop = 4", "NS0211", "stop"),
    (STOP + "open when n < stpo or stpo == 3", "NS0214", "stpo"),
    (STOP + "code id : row of book open when n < id", "NS0214", "book"),
    (STOP + "open when n < stop pixels stop = 3 pixels pots = 3", "NS0214", "pots"),
    (STOP + "open when stop", "NS0301", "stop"),
    (STOP + "open when stop and true", "NS0301", "stop"),
    (STOP + "open when not stop", "NS0301", "stop"),
    (STOP + "open when -(n < stop) < 3", "NS0301", "n < stop"),
    (STOP + "open when n + true < stop", "NS0301", "true"),
    (STOP + "open when (n < stop) < 3", "NS0301", "n < stop"),
    (STOP + "open when n < min(stop, n < 2)", "NS0301", "n < 2"),
    (STOP + "open when (stop if n else 3) < 2", "NS0301", "n"),
    (STOP + "open when n < stop if true else 3", "NS0301", "n < stop if true else 3"),
    (STOP + "open when (n < stop) == 1", "NS0301", None),
    (STOP + "require stop open when n < stop", "NS0301", "stop"),
    (STOP + "open when n < stop pixels stop = x < 3", "NS0301", "x < 3"),
    (FRAME + "let a = true open when n < a", "NS0301", "true"),
    (FRAME + "code bits : bit[8] open when bits[n < 3]", "NS0301", "n < 3"),
    (STOP + "open when n / stop > 3", "NS0302", "stop"),
    (STOP + "open when n < stop pixels stop = 8 % x", "NS0302", "x"),
    (FRAME + "let a = 1 / 0 let b = a open when n < b", "NS0302", "0"),
    (FRAME + "code bits : bit[7] open when bits[n]", "NS0303", "n"),
    (FRAME + "shutters b [11110000] code id : row of b open when b[id - 1]", "NS0303", "id - 1"),
    (STOP + "open when 1 << 62 - n > stop", "NS0304", "62 - n"),
    (STOP + "open when 1 << n - 1 > stop", "NS0304", "n - 1"),
    (STOP + "let a = (1 << 61) - 1 + (1 << 61) open when n - 1 < a + n", "NS0305", "a + n"),
    (STOP + "open when 1000000000000 * n < 5000000 * stop * 1000000000000", "NS0305", None),
    (FRAME + f"let a = {2**62 - 1} open when a + n > 3", "NS0305", "a + n"),
    (FRAME + "let a = 3 << 61 open when n < a", "NS0305", "3 << 61"),
    (FRAME + "code a : 3..1 open when n < a pixels a = 2", "NS0306", "3..1"),
    (FRAME + "code a : bit[0] open when a[n]", "NS0307", "0"),
    (FRAME + "code a : bit[65537] open when a[n]", "NS0307", "65537"),
    ("nsl 1 frame 0 slots of 1ms code s : 0..N open when n < s", "NS0308", "0"),
    ("nsl 1 frame 65537 slots of 1ms open when n < N", "NS0308", "65537"),
    ("nsl 1 frame 2 - 9 slots of 1ms open when n < N", "NS0308", "2 - 9"),
    ("nsl 1 frame 9 slots of 0.00000001ns open when n < N", "NS0309", "0.00000001ns"),
    ("nsl 1 frame slots [1ms, 9999999s] open when n < N", "NS0309", "9999999s"),
    (FRAME + "shutters b [1111000] code id : row of b open when b[id]", "NS0310", "1111000"),
    (STOP + "open when n < stop pixels stop = x % 10", "NS0311", "x % 10"),
    (STOP + "open when n < stop pixels stop = tile [[1, 2], [3, 9]]", "NS0311", "9"),
    (STOP + "require stop != 2 open when n < stop pixels stop = x % 3", "NS0312", None),
    (FRAME + 'shutters b from "no.npz" code id : row of b open when b[id]', "NS0313", '"no.npz"'),
    (STOP + 'open when n < stop pixels from "no.npz"', "NS0313", '"no.npz"'),
    (STOP + "open when n < stop pixels stop = tile [[1, 2], [3]]", "NS0316", "[3]"),
    (STOP + "require stop > 8 open when n < stop", "NS0317", "stop > 8"),
    ("nsl 1 target scamp6 frame 8 slots of 1ms open when n < rows", "NS0230", "scamp6"),
]


@pytest.mark.parametrize(("text", "code", "place"), ONE_ERROR)
def test_one_mistake_is_one_error_at_its_place(text: str, code: str, place: str | None) -> None:
    """Each text of `ONE_ERROR` has one error with the code beside it, at the text beside it."""
    (found,) = errors(text)
    assert found.code == code
    if place is not None:
        assert placed(found) == place


def test_all_errors_come_at_once_by_place() -> None:
    """Six mistakes give six errors in the order of their places."""
    found = errors(
        "nsl 1 let a = b frame 8 slots of 1ms code c : 5..3 code d : bit[0] "
        "require d open when n < zz pixels c = 4 pixels d = true"
    )
    codes = ["NS0214", "NS0306", "NS0307", "NS0301", "NS0214", "NS0301"]
    assert [d.code for d in found] == codes
    starts = [d.label.span.start for d in found if d.label is not None]
    assert starts == sorted(starts)


def test_an_unknown_name_gets_the_closest_known_one() -> None:
    """`stpo` gets a help and a fix with `stop`."""
    (found,) = errors(STOP + "open when n < stpo")
    assert found.helps == ("did you mean `stop`?",)
    assert found.fixes[0].replacement == "stop"


def test_the_first_pixel_and_the_count_are_named() -> None:
    """`x + y` leaves the range first at x = 9. The data counts all 65 491 pixels outside."""
    (found,) = errors(STOP + "open when n < stop pixels stop = x + y")
    assert "x = 9, y = 0 (row 0, column 9)" in found.message
    # x + y is at most 8 in 1 + 2 + .. + 9 = 45 pixels.
    assert found.data == {"field": "stop", "x": 9, "y": 0, "pixels": 65536 - 45}


def test_a_fault_names_code_and_slot() -> None:
    (found,) = errors(FRAME + "code a : 1..3 open when 4 / (n - 2 * a) > 0")
    assert found.notes == ("first for a = 1, in slot 2; 3 times in all",)


def test_several_rules_are_judged_separately() -> None:
    """Each of two buckets that divide by n = 0 has its own NS0302."""
    found = errors(FRAME + "bucket a open when 1 / n > 0 bucket b open when 1 % n > 0")
    assert [d.code for d in found] == ["NS0302", "NS0302"]


@pytest.mark.parametrize(
    "rule",
    [
        "stop != 0 and n / stop > 1",
        "stop == 0 or n / stop > 1",
        "0 < stop < n / stop",
        "(n / stop if stop > 0 else n) > 1",
        "false and 1 / 0 == n or n < stop",
        "(1 / 0 if N < 3 else stop) > n",
    ],
)
def test_parts_that_are_not_reached_have_no_faults(rule: str) -> None:
    """As in Python, what `and`, `or`, chained comparisons and `if` leave out is not computed: a
    division by 0 there is no error."""
    assert program_of(STOP + "open when " + rule).table.codes.shape == (9, 1)


@pytest.mark.parametrize(
    "rule",
    ["n / stop > 1 and stop != 0", "true xor n / stop > 1", "min(n / stop, 3) > 1"],
)
def test_parts_that_are_reached_have_their_faults_reported(rule: str) -> None:
    """A division by stop = 0 is NS0302 if it comes before its guard, or where all parts are
    computed."""
    (found,) = errors(STOP + "open when " + rule)
    assert found.code == "NS0302"


def test_faults_of_unused_codes_do_not_matter_with_fixed_codes() -> None:
    """Stop 0 divides by 0, but no pixel has it: that is an error only for open codes."""
    text = STOP + "open when n / stop > 1 pixels stop = 1 + x % 8"
    assert len(program_of(text, codes="fixed").table.codes) == 8
    assert [d.code for d in errors(text, codes="open")] == ["NS0302"]


@pytest.mark.parametrize(
    ("text", "codes", "required"),
    [
        ("frame 4096 slots of 1us code a : bit[20] open when n < a", "open", 2**32),
        ("frame 64 slots of 1us code a : bit[30] require a > 3 open when n < a", "open", 2**30),
        ("frame 2 slots of 1us code a : bit[62] open when n < a pixels a = x", "open", 2**63),
        (
            "frame 65536 slots of 1us code a : 0..65535 open when n < a pixels a = x + 256 * y",
            "fixed",
            2**32,
        ),
    ],
)
def test_programs_beyond_the_proof_are_refused_with_the_numbers(
    text: str, codes: str, required: int
) -> None:
    (found,) = errors("nsl 1 " + text, codes=codes)
    assert found.code == "NS0450"
    assert found.data["required"] == required
    assert str(required) in found.message
    assert str(found.data["available"]) in found.message
    assert found.helps


@pytest.mark.parametrize("more", [0, 1, 300])
def test_many_errors_are_counted_and_warnings_all_shown(more: int) -> None:
    lets = " ".join(f"let spare{k} = missing{k}" for k in range(MOST_ERRORS + more))
    twice = "let a = 1 " + " ".join("let a = 1" for _ in range(MOST_ERRORS + more))
    for text in (FRAME + lets + " open when n < 2", FRAME + twice + " open when n < 2"):
        found = errors(text)
        assert len(found) == MOST_ERRORS + (more > 0)
        places = [d.label.span.start for d in found if d.label is not None]
        assert places == sorted(places)
        assert [str(more) in d.message for d in found if d.code == "NS0190"] == [True] * (more > 0)
    problems = Problems(Source("test.nsl", "text"))
    for _ in range(2 * MOST_ERRORS + more):
        problems.error("NS0214", "unknown", Span(0, 1))
        problems.warning("NS0352", "not read", Span(0, 1))
    severities = [d.severity for d in problems.sorted()]
    assert severities.count(Severity.WARNING) == 2 * MOST_ERRORS + more
    assert severities.count(Severity.ERROR) == MOST_ERRORS + 1


LOOKING = "nsl 2 frame 8 slots of 1ms "
LOOK = "sense b when light > 40% at n in [1, 2, 4] "
MANY_SENSES = " ".join(f"sense b{k} when light > {k + 5}% at n == 4" for k in range(40))
LENGTHS = ", ".join(f"{2**k}ms" for k in range(18))


@pytest.mark.parametrize(
    ("text", "place", "helps"),
    [
        (LOOKING + MANY_SENSES + " open when n < 4", "b0", ["use fewer senses at one boundary"]),
        (
            # A state that reaches few of its values is not what there is too much of.
            LOOKING + MANY_SENSES + " state a : 0..10000000000 = 0 next a = looks open when a < 1",
            "b0",
            ["use fewer senses at one boundary", "reduce the ranges of the states"],
        ),
        (
            LOOKING + LOOK + "state a : bit = false state c : 0..99999999 = 0 kept open when a",
            "c",
            ["reduce the ranges of the states", "use fewer looks: there are 3"],
        ),
        (
            LOOKING + "code level : 20..200 sense b when light > level at n == 2 open when b",
            "b",
            [
                "use fewer values of `level`",
                "add the pixel values",
                "reduce the ranges of the fields",
            ],
        ),
        (
            f"nsl 2 frame slots [{LENGTHS}] sense b when light > 40% at n > 0 open when b",
            "n > 0",
            ["use fewer looks"],
        ),
    ],
)
def test_the_part_of_a_looking_program_that_is_too_large_is_named(
    text: str, place: str, helps: list[str]
) -> None:
    (found,) = errors(text)
    assert (found.code, placed(found)) == ("NS0450", place)
    assert len(found.helps) == len(helps)
    for given, wanted in zip(found.helps, helps, strict=True):
        assert given.startswith(wanted)


def test_too_many_operations_are_refused() -> None:
    """3000 comparisons for 1000 slots and 60 000 codes give NS0450."""
    rules = [f"n == {k} * stop" for k in range(3000)]
    while len(rules) > 1:
        rules = [f"({' or '.join(rules[k : k + 2])})" for k in range(0, len(rules), 2)]
    text = f"nsl 1 frame 1000 slots of 1us code stop : 1..60000 open when {rules[0]}"
    (found,) = errors(text)
    assert found.code == "NS0450"
    assert "operations" in found.message


def test_too_many_fields_are_refused() -> None:
    fields = " ".join(f"code f{k} : 0..255 pixels f{k} = x" for k in range(65))
    (found,) = errors(FRAME + fields + " open when n < f3")
    assert found.code == "NS0450"


def test_thousands_of_lets_compile() -> None:
    lets = " ".join(f"let a{k} = a{k + 1} + 1" for k in range(3000))
    program = program_of(f"nsl 1 frame 8 slots of 1ms {lets} let a3000 = 5 open when n < a0")
    assert program.table.shutters.all()


def test_deep_trees_are_no_problem() -> None:
    span = Span(0, 1)
    deep: t.Expr = t.Int(span, 1)
    for _ in range(20000):
        deep = t.Binary(span, "+", deep, t.Int(span, 1))
    rule = t.Compare(span, deep, ("==",), (t.Int(span, 20001),))
    frame = t.EqualSlots(span, t.Int(span, 4), t.Time(span, Fraction(1)))
    tree = t.File(span, (frame, t.Open(span, rule)))
    assert analyse(Source("deep", "?"), tree, base=Path()).table.shutters.all()


PAGES = sorted(Path(nscc.diagnostics.__path__[0]).glob("pages/NS0[23]*.md"))
PAGES += sorted(Path(nscc.diagnostics.__path__[0]).glob("pages/NS0450*.md"))


@pytest.mark.parametrize(
    "page", [p for p in PAGES if not "NS0230" <= p.name[:6] <= "NS0249"], ids=lambda p: p.name[:6]
)
def test_each_message_page_has_a_failing_and_a_valid_program(page: Path) -> None:
    blocks = re.findall(r"```nsl\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    if not blocks:
        return
    bad, good = blocks
    try:
        found = program_of(bad).messages
    except Rejected as rejected:
        found = rejected.diagnostics
    assert page.name[:6] in {d.code for d in found}
    assert page.name[:6] not in {d.code for d in program_of(good).messages}
