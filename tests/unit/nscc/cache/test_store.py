"""The folder of kept results: whole or not at all, bounded, and silent about a bad disk."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from nscc.cache.folder import cache_folder, refusal
from nscc.cache.store import Store

KEYS = [f"{i:064x}" for i in range(100)]


@pytest.mark.parametrize(
    ("environment", "folder"),
    [
        ({"HOME": "/h"}, "/h/.cache/nscc"),
        ({"HOME": "/h", "XDG_CACHE_HOME": "/x"}, "/x/nscc"),
        ({"HOME": "/h", "XDG_CACHE_HOME": "x"}, "/h/.cache/nscc"),
        ({"HOME": "/h", "XDG_CACHE_HOME": "/x", "NSCC_CACHE_DIR": "/n"}, "/n"),
        ({"HOME": "/h", "NSCC_CACHE_DIR": "/n", "NSCC_CACHE": "off"}, None),
        ({"HOME": "/h", "NSCC_CACHE": "OFF"}, None),
        ({"HOME": "/h", "NSCC_CACHE": "on"}, "/h/.cache/nscc"),
        ({"HOME": ""}, None),
        ({"HOME": "~"}, None),
        ({"NSCC_CACHE_DIR": "here"}, None),
    ],
)
def test_environment_variables_choose_the_cache_folder(
    tmp_path: Path, environment: dict[str, str], folder: str | None
) -> None:
    below = {n: f"{tmp_path}{v}" if v.startswith("/") else v for n, v in environment.items()}
    assert cache_folder(below) == (None if folder is None else Path(f"{tmp_path}{folder}"))


def test_without_a_home_there_is_no_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    """A user without an entry: Python leaves `~` as it is."""
    monkeypatch.setattr(os.path, "expanduser", lambda path: path)
    assert cache_folder({}) is None


def test_a_cache_folder_that_others_can_write_is_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    own = {"NSCC_CACHE_DIR": str(tmp_path / "c")}
    (tmp_path / "c").mkdir(mode=0o700)
    assert cache_folder(own) == tmp_path / "c"
    for mode in (0o770, 0o702):
        (tmp_path / "c").chmod(mode)
        assert cache_folder(own) is None
    (tmp_path / "c").chmod(0o700)
    (tmp_path / "file").touch()
    assert cache_folder({"NSCC_CACHE_DIR": str(tmp_path / "file" / "c")}) is None
    monkeypatch.setattr(os, "geteuid", lambda: 12345)
    assert cache_folder(own) is None
    assert cache_folder({"NSCC_CACHE_DIR": str(tmp_path / "new")}) is None
    assert "belongs to another user, so nscc runs without a cache" in refusal()
    # In a folder where nobody can replace what belongs to another user, a new one is safe.
    (tmp_path / "shared").mkdir()
    (tmp_path / "shared").chmod(0o1777)
    shared = {"NSCC_CACHE_DIR": str(tmp_path / "shared" / "c")}
    assert cache_folder(shared) == tmp_path / "shared" / "c"


def test_cache_entries_that_others_can_write_are_not_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file of mode 622, or of another user, is not read. Of mode 600 it is."""
    store = Store(tmp_path)
    store.write(KEYS[0], b"data")
    (tmp_path / KEYS[0]).chmod(0o622)
    assert store.read(KEYS[0]) is None
    (tmp_path / KEYS[0]).chmod(0o600)
    assert store.read(KEYS[0]) == b"data"
    monkeypatch.setattr(os, "geteuid", lambda: 12345)
    assert store.read(KEYS[0]) is None


def test_entries_are_read_as_written(tmp_path: Path) -> None:
    store = Store(tmp_path / "not" / "there")
    assert store.read(KEYS[0]) is None
    assert (store.entries(), store.bytes_used()) == (0, 0)
    for data in (b"", b"one\n\0two", b"x" * 100_000):
        store.write(KEYS[0], data)
        assert store.read(KEYS[0]) == data
    assert store.read(KEYS[1]) is None
    assert store.entries() == 1
    assert store.bytes_used() >= 100_000
    assert [path.name for path in store.folder.iterdir()] == [KEYS[0]]
    # Nobody but the owner may read or write it.
    assert store.folder.stat().st_mode & 0o077 == 0


def test_a_damaged_entry_is_ignored_and_written_again(tmp_path: Path) -> None:
    store = Store(tmp_path)
    store.write(KEYS[0], b"the very data")
    whole = (tmp_path / KEYS[0]).read_bytes()
    for place in range(len(whole)):
        for damaged in (whole[:place], whole[:place] + b"\xfe" + whole[place + 1 :]):
            (tmp_path / KEYS[0]).write_bytes(damaged)
            assert store.read(KEYS[0]) is None
    (tmp_path / KEYS[1]).write_bytes(whole)
    assert store.read(KEYS[1]) is None, "an entry under another's name"
    store.write(KEYS[0], b"the very data")
    assert store.read(KEYS[0]) == b"the very data"


def test_entries_that_are_not_files_are_ignored(tmp_path: Path) -> None:
    store = Store(tmp_path)
    (tmp_path / KEYS[0]).mkdir()
    os.mkfifo(tmp_path / KEYS[1])
    (tmp_path / KEYS[2]).symlink_to("/dev/zero")
    (tmp_path / KEYS[3]).symlink_to(KEYS[3])
    for key in KEYS[:4]:
        assert store.read(key) is None
        store.write(key, b"data")
    assert store.read(KEYS[0]) is None
    assert [store.read(key) for key in KEYS[1:4]] == [b"data"] * 3
    assert not list(tmp_path.glob(".*.part"))


def test_a_full_cache_drops_the_least_recently_used_entries(tmp_path: Path) -> None:
    store = Store(tmp_path, most_bytes=20_000)
    for age, key in enumerate(KEYS[:10]):
        store.write(key, b"x" * 1500)
        os.utime(tmp_path / key, (1000 + age, 1000 + age))
    (tmp_path / "notes.txt").write_text("x" * 50_000)
    assert store.read(KEYS[0]) is not None  # now it is the youngest
    for key in KEYS[10:20]:
        store.write(key, b"x" * 1500)
    # The twenty entries of 1500 bytes do not all fit: the oldest are gone.
    assert store.bytes_used() <= 20_000
    assert store.read(KEYS[0]) is not None
    assert store.read(KEYS[1]) is None
    assert store.read(KEYS[19]) is not None
    assert (tmp_path / "notes.txt").exists()


def test_results_that_are_too_large_are_not_stored(tmp_path: Path) -> None:
    """A store of 1000 bytes does not keep a result of 1000, and does not delete a small one for
    it."""
    store = Store(tmp_path, most_bytes=1000)
    store.write(KEYS[0], b"small")
    store.write(KEYS[1], b"x" * 1000)
    assert store.read(KEYS[1]) is None
    assert store.read(KEYS[0]) == b"small"


def test_files_of_dead_processes_are_removed(tmp_path: Path) -> None:
    """The next write removes a half-written file of 1970. One that is young may still be written
    and stays."""
    old, young = (tmp_path / f".{key}.7.part" for key in KEYS[:2])
    for path in (old, young):
        path.write_bytes(b"half")
    os.utime(old, (1000, 1000))
    Store(tmp_path).write(KEYS[3], b"data")
    assert not old.exists()
    assert young.exists()


@pytest.mark.parametrize("place", ["/proc/nscc", "/dev/null/nscc"])
def test_a_folder_that_cannot_be_written_stores_nothing(place: str) -> None:
    """Writing raises nothing, reading gives None and the store has no entries."""
    store = Store(Path(place))
    store.write(KEYS[0], b"data")
    assert store.read(KEYS[0]) is None
    assert store.entries() == 0
    # Below a device file there can never be a folder.
    if place.startswith("/dev"):
        assert cache_folder({"NSCC_CACHE_DIR": place}) is None


def test_a_full_disk_leaves_no_partial_cache_entry(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Renaming fails with `No space left`. The write raises nothing and removes its own file."""

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.replace", full)
    Store(tmp_path).write(KEYS[0], b"data")
    assert list(tmp_path.iterdir()) == []


WRITER = """
import sys
from pathlib import Path
from nscc.cache.store import Store
store = Store(Path(sys.argv[1]), most_bytes=30_000)
for turn in range(150):
    for i in range(8):
        key = f"{i:064x}"
        found = store.read(key)
        assert found in (None, bytes([i]) * 5000), "torn"
        store.write(key, bytes([i]) * 5000)
"""


def test_processes_do_not_disturb_each_other(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-c", WRITER, str(tmp_path)]
    running = [
        subprocess.Popen(command, env=environment, stderr=subprocess.PIPE, text=True)
        for _ in range(3)
    ]
    for process in running:
        _, said = process.communicate(timeout=100)
        assert process.returncode == 0, said
    assert not list(tmp_path.glob(".*.part"))
    # Each of the three may have written an entry (5000 bytes and its head) beyond the limit.
    assert Store(tmp_path).bytes_used() <= 30_000 + 3 * 5200
