"""Files are written whole or not at all, several together or none."""

from __future__ import annotations

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from itertools import count
from pathlib import Path
from threading import Barrier
from typing import BinaryIO

import numpy as np
import pytest
from nscc_command import RunNscc

from nscc import files
from nscc.diagnostics.diagnostic import Rejected
from nscc.files import inputs_kept, reads, refuse_same, write_together, write_whole


def test_a_file_is_written_and_replaced(tmp_path: Path) -> None:
    """Three writes leave one file with the last bytes, and an empty write leaves it empty."""
    for data in (b"one", b"", b"three"):
        write_whole(tmp_path / "file", data)
        assert (tmp_path / "file").read_bytes() == data
    assert os.listdir(tmp_path) == ["file"]


def test_files_are_written_in_spite_of_partial_files_of_a_killed_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In a container the next process has the same process number and also counts its writes from
    0, so both choose the same temporary name."""
    half: list[str] = []

    def killed(file: BinaryIO) -> None:
        half.extend(os.listdir(tmp_path))
        file.write(b"half")

    monkeypatch.setattr(files, "_writes", count())
    write_whole(tmp_path / "file", killed)
    (tmp_path / half[0]).write_bytes(b"half")
    (tmp_path / "file").unlink()
    monkeypatch.setattr(files, "_writes", count())
    write_whole(tmp_path / "file", b"whole")
    assert (tmp_path / "file").read_bytes() == b"whole"
    assert os.listdir(tmp_path) == ["file"]


def test_products_with_the_longest_names_keep_their_own_bytes(tmp_path: Path) -> None:
    """All but the last characters of their names are the same."""
    products = {tmp_path / f"{'n' * 251}.{kind}": kind.encode() for kind in ("icw", "asm", "cpp")}
    write_together(products)
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == products


def test_commands_write_products_under_the_longest_names(tmp_path: Path, run_nscc: RunNscc) -> None:
    """A name of 255 characters, the most that a file system allows, has no room for a longer
    temporary name. Both products are written."""
    (tmp_path / "a.nsl").write_text("nsl 1\nframe 4 slots of 1ms\nopen when n < 2\n")
    stem = "n" * 251
    assert run_nscc(["build", "a.nsl", "-o", f"{stem}.icw", "--emit", "asm"], tmp_path).status == 0
    assert (tmp_path / f"{stem}.icw").read_bytes().startswith(b"\x89ICW")
    assert b".kernel" in (tmp_path / f"{stem}.asm").read_bytes()


def test_threads_save_one_path_at_the_same_time(tmp_path: Path) -> None:
    path = tmp_path / "file"
    contents = [bytes([number]) * 100_000 for number in range(4)]
    together = Barrier(4)

    def save(data: bytes) -> None:
        for _ in range(30):
            together.wait()
            write_whole(path, data)

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(save, contents))
    assert path.read_bytes() in contents
    assert os.listdir(tmp_path) == ["file"]


def test_new_files_have_the_usual_rights(tmp_path: Path) -> None:
    write_whole(tmp_path / "product", b"")
    (tmp_path / "usual").write_bytes(b"")
    assert (tmp_path / "product").stat().st_mode == (tmp_path / "usual").stat().st_mode


@pytest.mark.parametrize("mode", [0o600, 0o755, 0o666, 0o444])
def test_a_file_that_is_replaced_keeps_its_rights(tmp_path: Path, mode: int) -> None:
    """Written through a link, the file keeps its mode, also one that forbids writing."""
    (tmp_path / "real").write_bytes(b"old")
    (tmp_path / "real").chmod(mode)
    (tmp_path / "link").symlink_to(tmp_path / "real")
    write_whole(tmp_path / "link", b"new")
    assert (tmp_path / "real").read_bytes() == b"new"
    assert (tmp_path / "real").stat().st_mode & 0o777 == mode


def test_private_files_stay_private_while_they_are_written(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"old")
    path.chmod(0o600)

    def look(file: BinaryIO) -> None:
        # No rights of group and others.
        assert os.fstat(file.fileno()).st_mode & 0o077 == 0
        file.write(b"new")

    write_whole(path, look)
    assert path.read_bytes() == b"new"


def test_mending_a_program_keeps_its_rights(tmp_path: Path, run_nscc: RunNscc) -> None:
    """`nscc fmt` and `nscc check --fix` change the text and keep mode 600."""
    path = tmp_path / "a.nsl"
    for text, line in (
        ("nsl 1\nframe 4 slots of 1ms\nopen   when n < 2\n", ["fmt", "a.nsl"]),
        ("frame 4 slots of 1ms\nopen when n < 2\n", ["check", "--fix", "a.nsl"]),
    ):
        path.write_text(text)
        path.chmod(0o600)
        assert run_nscc(line, tmp_path).status == 0
        assert path.read_text() != text
        assert path.stat().st_mode & 0o777 == 0o600


def test_follows_a_link_and_leaves_a_device_alone(tmp_path: Path) -> None:
    """A link stays a link and its target is written. The null device stays a device."""
    (tmp_path / "link").symlink_to(tmp_path / "real")
    write_whole(tmp_path / "link", b"x")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_bytes() == b"x"
    write_whole(Path(os.devnull), b"x")
    assert Path(os.devnull).is_char_device()


@pytest.mark.parametrize("name", [".", "file/under", "n" * 300])
def test_write_whole_refuses_bad_paths_and_writes_nothing(tmp_path: Path, name: str) -> None:
    """A folder, a path below a file and a name that is too long give NS0784."""
    (tmp_path / "file").write_bytes(b"old")
    with pytest.raises(Rejected) as raised:
        write_whole(tmp_path / name, b"new")
    assert raised.value.status == 2
    assert [d.code for d in raised.value.diagnostics] == ["NS0784"]
    assert os.listdir(tmp_path) == ["file"]


def test_all_files_or_none_are_written(tmp_path: Path) -> None:
    """The second of two files cannot be written, so the first is not there either. If both can,
    both are."""
    (tmp_path / "file").write_bytes(b"old")
    with pytest.raises(Rejected):
        write_together({tmp_path / "a": b"a", tmp_path / "file" / "b": b"b"})
    assert os.listdir(tmp_path) == ["file"]
    write_together({tmp_path / "a": b"a", tmp_path / "b": b"b"})
    assert sorted(os.listdir(tmp_path)) == ["a", "b", "file"]


def test_two_products_in_one_file_are_refused(tmp_path: Path) -> None:
    """`a` and its absolute path are one file: NS0745. Two names are accepted."""
    refuse_same([tmp_path / "a", tmp_path / "b"], "-o and --png")
    with pytest.raises(Rejected) as raised:
        refuse_same([Path("a"), Path("a").absolute()], "-o and --png")
    assert [d.code for d in raised.value.diagnostics] == ["NS0745"]


def test_an_input_is_never_overwritten_by_any_name(tmp_path: Path) -> None:
    source, link = tmp_path / "a.nsl", tmp_path / "b.nsl"
    source.write_bytes(b"text")
    link.hardlink_to(source)
    with inputs_kept():
        reads(source, tmp_path / "file does not exist", tmp_path)
        for product in (source, link, tmp_path / "." / "a.nsl"):
            with pytest.raises(Rejected) as raised:
                write_together({tmp_path / "other": b"x", product: b"words"})
            assert [d.code for d in raised.value.diagnostics] == ["NS0785"]
        assert source.read_bytes() == b"text"
        assert not (tmp_path / "other").exists()
        write_whole(source, b"text")
    write_whole(source, b"words")
    assert source.read_bytes() == b"words"


def test_commands_refuse_to_overwrite_their_inputs(tmp_path: Path, run_nscc: RunNscc) -> None:
    """Files that the inputs name are protected, too."""
    np.savez(tmp_path / "codes.npz", stop=np.ones((256, 256), np.int64))
    (tmp_path / "a.nsl").write_text(
        "nsl 1\nframe 4 slots of 1ms\ncode stop : 1..4\nopen when n < stop\n"
        'pixels from "codes.npz"\n'
    )
    assert run_nscc(["build", "a.nsl"], tmp_path).status == 0
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    for line in (
        "build a.nsl -o a.nsl",
        "build a.nsl -o codes.npz",
        "shutters a.nsl -o codes.npz",
        "disasm a.icw -o a.icw",
        "run a.nsl --scene builtin:dark -o codes.npz",
        "run a.nsl --scene builtin:dark -o new.npz --timings a.nsl",
    ):
        assert "NS0785" in run_nscc(line.split(), tmp_path).err, line
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before


@pytest.mark.parametrize("name", ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"])
def test_open_pipes_and_files_are_appended_to(tmp_path: Path, name: str) -> None:
    """A pipe has no path to put a temporary file beside; a file of the shell's is not replaced."""
    code = "from pathlib import Path; from nscc.files import write_whole; "
    code += f"write_whole(Path({name!r}), b'words')"
    command = [sys.executable, "-c", code]
    assert subprocess.run(command, capture_output=True, check=True).stdout == b"words"
    with open(tmp_path / "file", "ab") as file:
        file.write(b"some ")
        file.flush()
        subprocess.run(command, stdout=file, check=True)
    assert (tmp_path / "file").read_bytes() == b"some words"
