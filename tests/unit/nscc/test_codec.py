"""Records go through JSON values and back; errors name the field, the value and what is allowed."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Annotated, Any, Literal

import pytest

from nscc.codec import (
    HEX,
    LATER,
    InvalidRecord,
    KeyName,
    Within,
    from_json,
    from_plain,
    to_json,
    to_plain,
)
from nscc.record import Record


class Leaf(Record):
    name: str


class Scaled(Record):
    factor: Fraction
    node: Tree


class Several(Record):
    nodes: tuple[Tree, ...]


Tree = Leaf | Scaled | Several


class Stop(Record):
    boundary: Annotated[int, Within(0, 100)]
    bucket: str
    level: int | None = None


@dataclass(frozen=True)
class Whole:
    stops: Annotated[tuple[Stop, ...], Within(1, 3)]
    tree: Annotated[Tree, KeyName("expression")]
    gains: Mapping[str, float]
    order: Literal["first", "last"]
    pair: tuple[int, bool]
    large: Annotated[int, HEX] = 0
    anything: object = None
    note: Annotated[str, LATER] = ""


WHOLE = Whole(
    (Stop(3, "a"), Stop(5, "b", -2)),
    Several((Leaf("a"), Scaled(Fraction(1, 3), Leaf("b")))),
    {"a": 1.5},
    "last",
    (1, True),
    1 << 99_999,
    {"x": [None]},
)
PLAIN = {
    "stops": [[3, "a", None], [5, "b", -2]],
    "expression": ["Several", ["Leaf", "a"], ["Scaled", 1, 3, ["Leaf", "b"]]],
    "gains": {"a": 1.5},
    "order": "last",
    "pair": [1, True],
    "large": f"{1 << 99_999:x}",
    "anything": {"x": [None]},
}


def test_records_survive_json() -> None:
    """A record becomes plain values and JSON with a schema, and comes back equal. A note is written
    only if there is one."""
    assert to_plain(WHOLE) == PLAIN
    assert from_plain(Whole, PLAIN) == WHOLE
    noted = replace(WHOLE, note="n")
    assert to_plain(noted) == {**PLAIN, "note": "n"}
    text = to_json(noted, "nscc-test-1")
    assert json.loads(text) == {**PLAIN, "note": "n", "schema": "nscc-test-1"}
    assert from_json(Whole, text, "nscc-test-1") == noted
    assert to_json(from_json(Whole, text, "nscc-test-1"), "nscc-test-1") == text


def changed(*path: Any, value: Any) -> Any:
    """The plain values with another value at a place."""
    values = json.loads(json.dumps(PLAIN))
    place = values
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = value
    return values


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ([], "it is a list, not an object"),
        ({**PLAIN, "more": 1}, "`more` is unknown"),
        ({"stops": [[1, "a", 2]]}, "`expression` is missing"),
        (changed("stops", value=[]), "`stops` has a length of 0, but 1 to 3 is allowed"),
        (changed("stops", 1, value=[1, "a"]), "`stops[1]` has 2 items, not 3"),
        (changed("stops", 1, 0, value=101), "`stops[1].boundary` is 101, but 0 to 100 is allowed"),
        (changed("stops", 1, 0, value=True), "`stops[1].boundary` is True, not an integer"),
        (changed("stops", 0, 0, value=10**5000), "is a number of more than 64 bits, not"),
        (changed("stops", 0, 1, value=7), "`stops[0].bucket` is 7, not a text"),
        (changed("stops", 0, 2, value="x"), "`stops[0].level` is 'x', not an integer of 64 bits"),
        (changed("gains", "a", value=float("inf")), "`gains.a` is inf, not a finite number"),
        (changed("gains", "a", value=10**400), "a number of more than 64 bits, not a finite"),
        (changed("order", value="middle"), "`order` is 'middle', not 'first' or 'last'"),
        (changed("pair", 0, value=1.0), "`pair[0]` is 1.0, not an integer"),
        (changed("pair", 1, value=1), "`pair[1]` is 1, not true or false"),
        (changed("large", value="xyz"), "`large` is 'xyz', not a number in hexadecimal"),
        (changed("large", value="\n" * 99), "`large` is '\\n\\n"),
        (changed("expression", value=[]), "`expression` begins with None, not with the name"),
        (changed("expression", 0, value="x"), "`expression` begins with 'x', not with"),
        (changed("expression", 0, value=[]), "`expression` begins with a list, not with"),
        (changed("expression", 2, 2, value=0), "`expression[1].factor` is not a fraction"),
        (changed("expression", 2, 3, value=4), "`expression[1].node` is 4, not a list"),
    ],
)
def test_errors_name_the_field(values: Any, text: str) -> None:
    with pytest.raises(InvalidRecord) as raised:
        from_plain(Whole, values)
    message = str(raised.value)
    assert text in message
    assert len(message) < 200
    assert message.isprintable()


@pytest.mark.parametrize(
    ("record", "text"),
    [
        (replace(WHOLE, stops=()), "`stops` has a length of 0, but 1 to 3 is allowed"),
        (
            replace(WHOLE, stops=(Stop(-1, "a"),)),
            "`stops[0].boundary` is -1, but 0 to 100 is allowed",
        ),
        (replace(WHOLE, stops=(Leaf("a"),)), "`stops[0]` is a Leaf, not a Stop"),
        (replace(WHOLE, tree=Stop(1, "a")), "`expression` is an unknown value, not one of Leaf"),
        (replace(WHOLE, gains={"a": float("nan")}), "`gains.a` is nan, not a finite number"),
    ],
)
def test_writing_refuses_records_that_reading_would_refuse(record: Whole, text: str) -> None:
    with pytest.raises(InvalidRecord) as raised:
        to_plain(record)
    assert text in str(raised.value)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("{", "it is not JSON"),
        ("[" * 100_000, "it is nested too deeply"),
        ('{"a": ' + "9" * 5000 + "}", "it is not JSON"),
        (b"\xff\xfe\xff", "it is not JSON"),
        ("[]", "`schema` is None, not 'nscc-test-1'"),
        ('{"schema": "nscc-test-2"}', "`schema` is 'nscc-test-2', not 'nscc-test-1'"),
    ],
)
def test_texts_of_other_formats_are_refused(text: str | bytes, reason: str) -> None:
    with pytest.raises(InvalidRecord) as raised:
        from_json(Whole, text, "nscc-test-1")
    assert reason in str(raised.value)


def test_trees_that_are_too_deep_are_refused() -> None:
    """A tree of 2000 levels is refused. One of 200, as deep as an expression may be, comes back
    equal."""
    plain: Any = ["Leaf", "a"]
    for _ in range(2000):
        plain = ["Several", plain]
    with pytest.raises(InvalidRecord, match="it is nested too deeply"):
        from_plain(Tree, plain)
    plain = ["Leaf", "a"]
    for _ in range(200):  # as deep as an expression of a program may be
        plain = ["Scaled", 1, 2, plain]
    assert to_plain(from_plain(Tree, plain), Tree) == plain
