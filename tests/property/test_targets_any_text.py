"""Whatever a target file holds, it is a sound target or explained."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st

from nscc.chips.load import (
    builtin_target,
    parse_target,
    target_dict,
    target_from_dict,
    target_toml,
)
from nscc.chips.target import SCHEMA
from nscc.diagnostics.diagnostic import Rejected

WHOLE = target_toml(builtin_target("scamp5"))
PIECES = st.sampled_from(
    ['"', "[", "]", "=", "\n", ".", "{", "}", "nan", "-1", "1e999", "true", "'", "#", "[[", "é"]
)
SCALARS = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=5), st.binary(max_size=2)
)
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3), st.dictionaries(st.text(max_size=3), inner, max_size=3)
    ),
    max_leaves=6,
)


@settings(max_examples=200, deadline=None)
@given(st.data())
def test_a_spoilt_file_is_read_or_explained(data: st.DataObject) -> None:
    text = WHOLE
    for _ in range(data.draw(st.integers(1, 4))):
        at, cut = data.draw(st.integers(0, len(text))), data.draw(st.integers(0, 30))
        text = text[:at] + data.draw(PIECES) + text[at + cut :]
    try:
        target = parse_target(text.encode(), "x.toml")
    except Rejected:
        return
    assert parse_target(target_toml(target).encode(), "y.toml") == target


@settings(max_examples=100, deadline=None)
@given(st.binary(max_size=60))
def test_random_bytes_are_explained(data: bytes) -> None:
    try:
        parse_target(data, "x.toml")
    except Rejected:
        return
    raise AssertionError("random bytes are no target")


@settings(max_examples=300, deadline=None)
@given(
    st.sampled_from(
        [
            (s, k)
            for s, v in target_dict(builtin_target("scamp5")).items()
            if isinstance(v, dict)
            for k in v
        ]
    ),
    VALUES,
)
def test_any_value_of_any_key_is_taken_or_explained(place: tuple[str, str], value: object) -> None:
    values = target_dict(builtin_target("scamp5"))
    values[place[0]][place[1]] = value
    _, problems = SCHEMA.read(values, complete=True)
    try:
        assert target_dict(target_from_dict(values)) == values
    except ValueError as error:
        told = [str(error), *(problem.message for problem in problems)]
        assert all(message.isprintable() and len(message) < 400 for message in told)
    else:
        assert not problems


@settings(max_examples=60, deadline=None)
@given(
    st.integers(1, 8192),
    st.floats(1e-9, 1e5),
    st.one_of(st.none(), st.integers(2, 1000)),
    st.text(st.characters(categories=["L", "N", "P", "S"]), max_size=40),
)
def test_any_sound_target_reads_back(
    rows: int, word_us: float, limit: int | None, description: str
) -> None:
    """A target with any rows, word time, limit and description is equal after it was written as
    TOML and read."""
    target = replace(
        builtin_target("scamp7"),
        rows=rows,
        analog_word_us=word_us,
        where_sources=limit,
        description=description,
    )
    assert parse_target(target_toml(target).encode(), "x.toml") == target
