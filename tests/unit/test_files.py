"""Files are written whole or not at all, several together or none."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from nscc.diagnostics.diagnostic import Rejected
from nscc.files import refuse_same, write_together, write_whole


def test_writes_and_replaces(tmp_path: Path) -> None:
    for data in (b"one", b"", b"three"):
        write_whole(tmp_path / "file", data)
        assert (tmp_path / "file").read_bytes() == data
    assert os.listdir(tmp_path) == ["file"]


def test_what_a_killed_process_left_is_no_obstacle(tmp_path: Path) -> None:
    """In a container the next process has the same number."""
    (tmp_path / f".file.{os.getpid()}.part").write_bytes(b"half")
    write_whole(tmp_path / "file", b"whole")
    assert (tmp_path / "file").read_bytes() == b"whole"
    assert os.listdir(tmp_path) == ["file"]


def test_new_files_have_the_usual_rights(tmp_path: Path) -> None:
    write_whole(tmp_path / "product", b"")
    (tmp_path / "usual").write_bytes(b"")
    assert (tmp_path / "product").stat().st_mode == (tmp_path / "usual").stat().st_mode


def test_follows_a_link_and_leaves_a_device_alone(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "real")
    write_whole(tmp_path / "link", b"x")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_bytes() == b"x"
    write_whole(Path(os.devnull), b"x")
    assert Path(os.devnull).is_char_device()


@pytest.mark.parametrize("name", [".", "no/such", "file/under", "n" * 300])
def test_refuses_in_one_sentence_and_leaves_nothing(tmp_path: Path, name: str) -> None:
    (tmp_path / "file").write_bytes(b"old")
    with pytest.raises(Rejected) as raised:
        write_whole(tmp_path / name, b"new")
    assert raised.value.status == 2
    assert [d.code for d in raised.value.diagnostics] == ["NS0784"]
    assert os.listdir(tmp_path) == ["file"]


def test_several_files_or_none(tmp_path: Path) -> None:
    with pytest.raises(Rejected):
        write_together({tmp_path / "a": b"a", tmp_path / "no" / "b": b"b"})
    assert os.listdir(tmp_path) == []
    write_together({tmp_path / "a": b"a", tmp_path / "b": b"b"})
    assert sorted(os.listdir(tmp_path)) == ["a", "b"]


def test_two_products_in_one_file_are_refused(tmp_path: Path) -> None:
    refuse_same([tmp_path / "a", tmp_path / "b"], "-o and --png")
    with pytest.raises(Rejected) as raised:
        refuse_same([Path("a"), Path("a").absolute()], "-o and --png")
    assert [d.code for d in raised.value.diagnostics] == ["NS0745"]
