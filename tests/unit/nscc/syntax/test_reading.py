"""A program's file as text: what is taken, and what is refused before a word of it is read."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.render import render
from nscc.diagnostics.reports import workflow_commands
from nscc.syntax.parse import MOST_BYTES, parse, read_source


def refusal(path: Path) -> tuple[str, int]:
    with pytest.raises(Rejected) as caught:
        read_source(path)
    (diagnostic,) = caught.value.diagnostics
    return diagnostic.code, caught.value.status


def test_source_text_keeps_its_line_ends_and_characters(tmp_path: Path) -> None:
    """CR LF, umlauts and Chinese characters are in the text as in the file."""
    path = tmp_path / "a.nsl"
    path.write_bytes("nsl 1\r\n# \u00fc \u4e2d\n".encode())
    source = read_source(path)
    assert source.text == "nsl 1\r\n# \u00fc \u4e2d\n"
    assert source.name == path.as_posix()


def test_a_byte_order_mark_is_left_out_of_the_text(tmp_path: Path) -> None:
    path = tmp_path / "a.nsl"
    path.write_bytes(b"\xef\xbb\xbfnsl 1")
    assert read_source(path).text == "nsl 1"


@pytest.mark.parametrize("data", [b"nsl 1\xff", "nsl 1".encode("utf-16"), b"nsl 1\0", bytes(9)])
def test_files_that_are_not_utf_8_are_refused(tmp_path: Path, data: bytes) -> None:
    """A byte 255, UTF-16 and zero bytes give NS0102."""
    path = tmp_path / "a.nsl"
    path.write_bytes(data)
    assert refusal(path) == ("NS0102", 1)


def test_files_above_the_limit_of_bytes_are_refused(tmp_path: Path) -> None:
    """A file of MOST_BYTES is read. One byte more, and ten times as many bytes, give NS0103."""
    path = tmp_path / "a.nsl"
    path.write_bytes(b"nsl 1\n" + b"#" * (MOST_BYTES - 6))
    assert parse(read_source(path))[1] == ()
    path.write_bytes(b"nsl 1\n" + b"#" * (MOST_BYTES - 5))
    assert refusal(path) == ("NS0103", 1)
    path.write_bytes(b"\xff" * (10 * MOST_BYTES))
    assert refusal(path) == ("NS0103", 1)


def test_unreadable_paths_are_refused(tmp_path: Path) -> None:
    """A missing file, a folder, a zero in the name, a long name and a circle of links give
    NS0101."""
    assert refusal(tmp_path / "missing.nsl") == ("NS0101", 2)
    assert refusal(tmp_path) == ("NS0101", 2)
    assert refusal(tmp_path / "a\0b.nsl") == ("NS0101", 2)
    # Longer than file systems allow.
    assert refusal(tmp_path / ("a" * 5000)) == ("NS0101", 2)
    loop = tmp_path / "loop.nsl"
    loop.symlink_to(loop)
    assert refusal(loop) == ("NS0101", 2)


@pytest.mark.parametrize("data", [b"nsl 1\xff", b"#" * (MOST_BYTES + 1)])
def test_messages_about_unreadable_text_name_the_file(tmp_path: Path, data: bytes) -> None:
    """The JSON, annotation and short forms each name the file, although there is no place in it."""
    path = tmp_path / "a.nsl"
    path.write_bytes(data)
    with pytest.raises(Rejected) as caught:
        read_source(path)
    found = caught.value.diagnostics
    assert json.loads(render(found, "json"))["filename"] == path.as_posix()
    assert f"file={path.as_posix()}" in workflow_commands(found)
    assert render(found, "short").startswith(f"{path.as_posix()}: error")


@pytest.mark.parametrize("size", [100, MOST_BYTES + 1])
@pytest.mark.parametrize(("name", "words"), [("p.icw", "compiled already"), ("p.hdr", "--scene")])
def test_files_of_other_kinds_are_told_apart(
    name: str, words: str, size: int, tmp_path: Path
) -> None:
    """A container is said to be compiled already and a picture to belong to `--scene`, at any
    size."""
    (tmp_path / name).write_bytes(b"\0" * size)
    with pytest.raises(Rejected) as caught:
        read_source(tmp_path / name)
    (found,) = caught.value.diagnostics
    assert found.code == "NS0102"
    assert words in found.helps[0]
