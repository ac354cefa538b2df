"""Containers with a checksum that is right and strings that are not: every command that reads one
says what is wrong, or does its work."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from nscc_command import invoke

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.file import from_bytes, to_bytes

PROGRAM = """nsl 1
frame 4 slots of 1ms
code stop : 1..4
open when n < stop
pixels stop = tile [[4, 3], [2, 1]]
"""
ODD = st.one_of(
    st.text(st.characters(), max_size=4),  # with halves of characters, which st.text() leaves out
    st.sampled_from(["\ud800", "\x1b[2J", "\0", "\n", "\u2028", "", "x" * 300, "../x", "é"]),
)
COMMANDS = (
    ["diff", "a.icw", "b.icw"],
    ["diff", "b.icw", "a.icw"],
    ["disasm", "b.icw"],
    ["prove", "b.icw"],
    ["shutters", "b.icw", "-o", "s.npz"],
    ["run", "b.icw", "--scene", "builtin:dark", "-o", "f.npz"],
)


@cache
def good() -> tuple[bytes, dict[str, Any], bytes]:
    """A small container: what stands before its header, the header, what stands after it."""
    target = replace(builtin_target("scamp5"), rows=4, cols=6, name="small")
    container = run_passes(Source("p.nsl", PROGRAM), Path(), Options(target=target)).container
    assert container is not None
    data = to_bytes(container)
    end = 24 + int.from_bytes(data[12:16], "little")
    return data[:24], json.loads(data[24:end]), data[end:-32]


def signed(header: dict[str, Any]) -> bytes:
    """The container with another header, its lengths and its checksum made to fit."""
    before, _, after = good()
    text = json.dumps(header, sort_keys=True, separators=(",", ":")).encode("ascii")
    length = len(before) + len(text) + len(after) + 32
    body = before[:12] + len(text).to_bytes(4, "little") + length.to_bytes(8, "little")
    body += text + after
    return body + sha256(body).digest()


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The paths of all strings in a JSON value, keys of tables (as the last part None) included."""
    if isinstance(value, str):
        yield path
    elif isinstance(value, dict):
        for key, each in value.items():
            yield (*path, key, None)
            yield from places(each, (*path, key))
    elif isinstance(value, list):
        for number, each in enumerate(value):
            yield from places(each, (*path, number))


def changed(path: tuple[Any, ...], text: str) -> dict[str, Any]:
    header: dict[str, Any] = json.loads(json.dumps(good()[1]))
    place: Any = header
    key = path[-2] if path[-1] is None else path[-1]
    for part in path[: -2 if path[-1] is None else -1]:
        place = place[part]
    if path[-1] is None:
        place[text] = place.pop(key)
    else:
        place[key] = text
    return header


def test_a_container_with_a_valid_digest_is_read() -> None:
    assert from_bytes(signed(good()[1]), "x.icw").slots == 4


@settings(max_examples=60)
@given(number=st.integers(0, 10**6), text=ODD)
@example(number=10**6 - 1, text="\ud800")
def test_any_string_in_a_container_is_read_or_refused(
    number: int, text: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    every = list(places(good()[1]))
    judge(changed(every[number % len(every)], text), tmp_path_factory)


@pytest.mark.parametrize("name", ["source_lines", "notes"])
@pytest.mark.parametrize("text", ["\ud800", "\udfff x", "\x1b]0;title\x07", "\0"])
def test_free_text_of_containers_is_shown_by_diff_and_disasm(
    name: str, text: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """Names and notes that the compiler does not read are shown by `diff` and `disasm`."""
    value: Any = ["nsl 1", text] if name == "source_lines" else {"class": text, text: "b"}
    judge({**good()[1], name: value}, tmp_path_factory)


@pytest.mark.parametrize("name", ["source_lines", "notes"])
def test_containers_with_a_lone_surrogate_in_a_string_are_refused(name: str) -> None:
    """Files and terminals accept no lone surrogate, so commands could not print the string."""
    value: Any = ["nsl 1", "\ud800"] if name == "source_lines" else {"class": "\ud800"}
    with pytest.raises(Rejected, match=r"NS0707.*surrogate"):
        from_bytes(signed({**good()[1], name: value}), "x.icw")


def judge(header: dict[str, Any], factory: pytest.TempPathFactory) -> None:
    """All commands pass or refuse, say one thing, and print nothing that a terminal acts on."""
    folder = factory.mktemp("signed")
    (folder / "a.icw").write_bytes(signed(good()[1]))
    (folder / "b.icw").write_bytes(signed(header))
    for arguments in COMMANDS:
        found = invoke(arguments, folder)
        assert found.status in (0, 1, 2), found.err
        assert not [c for c in found.out + found.err if c != "\n" and not c.isprintable()]
        if found.status:
            assert found.codes
            assert not (folder / arguments[-1]).exists() or arguments[-1] in ("a.icw", "b.icw")
