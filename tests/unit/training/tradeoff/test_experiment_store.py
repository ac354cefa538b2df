"""Measurements in an experiment store: whole or not there, of one experiment, by many processes."""

from __future__ import annotations

import errno
import json
import math
import os
import signal
import sqlite3
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import Mock

import pytest
from nscc_command import invoke

from nscc.diagnostics.diagnostic import Rejected
from nscc.experiment_store import ExperimentStore
from nscc.source import Source
from nscc_training.command_settings import SynthesisStudySettings
from nscc_training.experiments.engine import Done, PointRow, results, rows_in
from nscc_training.experiments.study import measure
from nscc_training.tradeoff.synthesis import StudiedProgram, synthesis_study

TEXT = "nsl 1 frame 8 slots of 1ms code stop : 0..7 open when n < stop "


@dataclass(frozen=True)
class Item:
    """A task whose figures are those of `run`."""

    key: str
    run: Callable[[], dict[str, Any]]
    label: str = ""


def once(store: ExperimentStore, key: str, run: Callable[[], dict[str, Any]]) -> dict[str, Any]:
    """The figures of one task."""

    def execute(tasks: Iterable[Item]) -> Iterator[Done]:
        return (Done(task, PointRow(task.key, task.run())) for task in tasks)

    for _ in results(store, [Item(key, run)], execute):
        pass
    return rows_in(store)[key].figures


def values(file: Path, of: str = "digest") -> dict[str, object]:
    with ExperimentStore(file, of) as store:
        return store.values()


def test_a_measurement_is_on_the_disk_when_it_is_measured(tmp_path: Path) -> None:
    file = tmp_path / "x.sqlite"
    figures = {"ms": [1.5, 2], "inf": math.inf, "text": "a"}
    with ExperimentStore(file, "digest") as store:
        assert once(store, "a", lambda: figures) == figures
        with sqlite3.connect(file) as other:
            [(of, name, value)] = other.execute("SELECT experiment, name, value FROM measurement")
            assert (of, name) == ("digest", "a")
            assert json.loads(value)["figures"] == {**figures, "inf": "inf"}
        other.close()
        assert once(store, "a", lambda: pytest.fail("it is known")) == figures
    with ExperimentStore(file, "digest") as store:
        assert once(store, "a", lambda: pytest.fail("it is known")) == figures
        store.remove()
    assert not any(tmp_path.iterdir())


def test_measurements_of_another_experiment_do_not_count(tmp_path: Path) -> None:
    """The same key in another experiment is measured again, and both values are kept in the one
    file."""
    file = tmp_path / "rows"
    for number, of in enumerate(("one", "other")):
        with ExperimentStore(file, of) as store:
            assert once(store, "a", lambda number=number: {"n": number}) == {"n": number}
    assert len(values(file, "one")) == len(values(file, "other")) == 1


def test_without_a_file_everything_is_measured() -> None:
    """Two stores without a file each measure the same key for themselves."""
    found = [once(ExperimentStore(), "a", lambda n=n: {"n": n}) for n in (1, 2)]
    assert found == [{"n": 1}, {"n": 2}]


@pytest.mark.parametrize("bad", [float("nan"), float("inf"), None])
def test_measurements_that_are_not_finite_numbers_are_not_stored(
    tmp_path: Path, bad: object
) -> None:
    """NaN, infinity and None raise a ValueError, and the file stays without rows."""
    with ExperimentStore(tmp_path / "s", "e") as store, pytest.raises(ValueError):  # noqa: PT011
        store.keep("a", bad)
    assert values(tmp_path / "s", "e") == {}


def test_files_that_are_not_stores_are_refused(tmp_path: Path) -> None:
    """A text, a database of another program and a path below a file give NS0834."""
    (tmp_path / "s").write_text("a text of more than a hundred bytes, " * 5)
    with pytest.raises(Rejected) as caught:
        ExperimentStore(tmp_path / "s")
    assert caught.value.diagnostics[0].code == "NS0834"
    with sqlite3.connect(tmp_path / "other") as other:
        other.execute("CREATE TABLE measurement (a)")
    with ExperimentStore(tmp_path / "other") as store, pytest.raises(Rejected, match="NS0834"):
        store.get("a")
    with pytest.raises(Rejected, match="choose a folder that you may write to"):
        ExperimentStore(tmp_path / "s" / "rows")


def test_a_store_that_another_process_holds_is_waited_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("nscc.experiment_store._PATIENCE_S", 0.05)
    reports: list[str] = []
    with ExperimentStore(tmp_path / "s", "e", reports.append) as store:
        store.keep("a", 1)
        other = sqlite3.connect(tmp_path / "s", isolation_level=None, check_same_thread=False)
        other.execute("BEGIN IMMEDIATE")
        end = threading.Timer(0.5, other.execute, ["COMMIT"])
        end.start()
        store.keep("b", 2)
        end.join()
        assert store.values() == {"a": 1, "b": 2}
        assert len(reports) == 1
        assert "waiting for another process" in reports[0]
        monkeypatch.setattr("nscc.experiment_store._BUSY_S", 0.1)
        other.execute("BEGIN IMMEDIATE")
        with pytest.raises(Rejected, match="end the other process") as caught:
            store.keep("c", 3)
        other.close()
    assert (caught.value.diagnostics[0].code, caught.value.status) == ("NS0784", 2)


@pytest.mark.parametrize("full", [sqlite3.SQLITE_FULL, sqlite3.SQLITE_IOERR, errno.ENOSPC])
def test_a_full_disk_and_a_missing_permission_have_different_errors(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, full: int
) -> None:
    """SQLite calls some writes to a full disk I/O errors."""
    error: Exception = OSError(full, "No space left on device")
    if full != errno.ENOSPC:
        error = sqlite3.OperationalError("database or disk is full")
        error.sqlite_errorcode = full  # type: ignore[attr-defined]
    free = SimpleNamespace(free=0)
    monkeypatch.setattr("nscc.experiment_store.disk_usage", lambda _folder: free)
    monkeypatch.setattr(sqlite3, "connect", Mock(side_effect=error))
    with pytest.raises(Rejected, match="free some space on this disk"):
        ExperimentStore(tmp_path / "s")
    free.free = 1 << 30
    if full == sqlite3.SQLITE_IOERR:
        with pytest.raises(Rejected, match="choose a folder"):
            ExperimentStore(tmp_path / "s")


WRITER = """
import sys, time
from dataclasses import dataclass
from pathlib import Path
from nscc.experiment_store import ExperimentStore
from nscc_training.experiments.study import Done, PointRow, results

@dataclass(frozen=True)
class Item:
    key: str
    label: str = ""

def execute(tasks):
    for task in tasks:
        with open(sys.argv[3], "a") as log:
            log.write(f"{task.key}\\n")
        time.sleep(0.002)
        yield Done(task, PointRow(task.key, {"number": int(task.key), "text": "x" * 3000}))

with ExperimentStore(Path(sys.argv[1]), "e") as store:
    for _ in results(store, [Item(str(number)) for number in range(int(sys.argv[2]))], execute):
        pass
"""


def writer(folder: Path, count: int) -> subprocess.Popen[bytes]:
    arguments = [sys.executable, "-c", WRITER, str(folder / "s"), str(count), str(folder / "log")]
    path = os.pathsep.join(sys.path)
    return subprocess.Popen(arguments, env={**os.environ, "PYTHONPATH": path})


def logged(folder: Path) -> int:
    """How many measurements have begun."""
    log = folder / "log"
    return log.read_bytes().count(b"\n") if log.exists() else 0


def test_two_processes_share_a_store_and_nothing_is_lost(tmp_path: Path) -> None:
    """Every measurement is made once, and both processes know all of them."""
    writers = [writer(tmp_path, 150) for _ in range(2)]
    assert [process.wait(timeout=120) for process in writers] == [0, 0]
    known = values(tmp_path / "s", "e")
    row = {"code": "", "error": ""}
    assert known == {
        str(n): {"figures": {"number": n, "text": "x" * 3000}, **row} for n in range(150)
    }
    made = (tmp_path / "log").read_text().split()
    assert sorted(map(int, made)) == list(range(150))


def test_measurements_killed_at_any_moment_are_complete(tmp_path: Path) -> None:
    before = 0
    for kill in range(20):
        process = writer(tmp_path, 400)
        begin = logged(tmp_path)
        # The second measurement begins when the first is kept.
        while process.poll() is None and logged(tmp_path) < begin + 2:
            time.sleep(0.001)
        time.sleep(0.0017 * kill)
        process.send_signal(signal.SIGKILL)
        process.wait()
        known = values(tmp_path / "s", "e")
        assert [each["figures"]["number"] for each in known.values()] == list(range(len(known)))  # type: ignore[index]
        assert len(known) >= before
        before = len(known)
    # Each of the 20 processes kept one measurement or more.
    assert before >= 20


def test_an_interrupted_measurement_resumes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = StudiedProgram("p", Source("p.nsl", TEXT), Path(), "open")
    compiled = []
    real = StudiedProgram.compiled
    monkeypatch.setattr(
        StudiedProgram, "compiled", lambda *way: (compiled.append(way), real(*way))[1]
    )

    study = synthesis_study([program], SynthesisStudySettings((0,), ("latch", "edges")))

    def until(items, _label, _total):
        for number, item in enumerate(items):
            yield item
            if number == 2:
                raise KeyboardInterrupt

    told = r"stored in '.*rows'; the same command continues"
    with (
        pytest.raises(KeyboardInterrupt, match=told),
        ExperimentStore(tmp_path / "rows", "x") as rows,
    ):
        measure(study, rows, until)
    before = [value["figures"]["ms"] for value in values(tmp_path / "rows", "x").values()]  # type: ignore[index]
    assert len(before) == 3
    compiled.clear()
    with ExperimentStore(tmp_path / "rows", "x") as rows:
        found = measure(study, rows)
    # Each way is compiled untimed, timed twice the first time, for it is short, then once.
    assert len(compiled) == 3 + 1 + 3
    latch, edges = found.points
    assert [latch.times_ms[0], edges.times_ms[0], latch.times_ms[1]] == before


def test_without_a_measurement_an_interrupt_says_nothing(tmp_path: Path) -> None:
    """Nothing was kept, so the interrupt passes on without a note."""
    for nothing in (ExperimentStore(), ExperimentStore(tmp_path / "none", "x")):
        with pytest.raises(KeyboardInterrupt) as found, nothing:
            raise KeyboardInterrupt
        assert found.value.args == ()


def test_a_command_leaves_its_products_and_no_store(tmp_path: Path) -> None:
    """Beside the program the folder has only the table and the picture that were asked for."""
    (tmp_path / "p.nsl").write_text(TEXT)
    command = ["tradeoff", "synthesis", "p.nsl", "--levels", "0", "--repeats", "1", "-o", "out"]
    done = invoke(command, tmp_path)
    assert (done.status, done.err) == (0, "wrote out.csv, out.png\n")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.csv", "out.png", "p.nsl"]
