"""`nscc sweep` on real workers, and what is left of it when processes are killed.

Whoever is killed, and whenever: the table in the end is that of a serial run.
"""

from __future__ import annotations

import csv
import io
import os
import random
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Sequence
from contextlib import closing, suppress
from pathlib import Path

import pytest

pytest.importorskip("distributed")

pytestmark = pytest.mark.slow

POINTS = 36
GRID = f"""
kind = "compile"

[bumps]
rule = "code start : 0..N - 4\\nopen when start <= n < start + 4"
slots = {[*range(20, 20 + POINTS // 2)]}
codes = "open"
level = [1, 2]
target = "scamp5"

[bits]
rule = "code bits : bit[N]\\nopen when bits[n]"
slots = [14, 15]
codes = "open"
"""
ROWS = POINTS + 2


def started(folder: Path, out: str, workers: int, *more: str) -> subprocess.Popen[bytes]:
    """A sweep in a session of its own, so that all of it can be killed."""
    arguments = ["sweep", "grid.toml", "--out", out, "--workers", str(workers), *more]
    return subprocess.Popen(
        [sys.executable, "-m", "nscc_cli", *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )


def finished(folder: Path, out: str, workers: int, *more: str, status: int = 0) -> bytes:
    """The table of a sweep that nobody disturbs."""
    process = started(folder, out, workers, *more)
    _, said = process.communicate(timeout=600)
    assert process.returncode == status, said.decode()
    return (folder / out / "table.csv").read_bytes()


def workers_of(folder: Path, out: str) -> list[str]:
    """Who computed the points that are done, in their order."""
    return [worker for _, worker in rows_of(folder, out) if worker]


def keys_of(folder: Path, out: str) -> Sequence[str]:
    return [key for key, _ in rows_of(folder, out)]


def rows_of(folder: Path, out: str) -> list[tuple[str, str]]:
    """Keys and workers in the store, as another program reads them."""
    path = folder / out / "store.sqlite"
    if not path.is_file():
        return []
    with closing(sqlite3.connect(path)) as database, suppress(sqlite3.OperationalError):
        found = database.execute("SELECT name, worker FROM measurement ORDER BY rowid")
        return found.fetchall()
    return []  # its table is yet to be made


@pytest.fixture(scope="module")
def serial(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, bytes]:
    """A folder with a grid, and its table by one process."""
    folder = tmp_path_factory.mktemp("sweep")
    (folder / "grid.toml").write_text(GRID)
    table = finished(folder, "serial", 0)
    rows = list(csv.DictReader(io.StringIO(table.decode())))
    assert [row["code"] for row in rows] == [""] * POINTS + ["NS0412"] * 2
    return folder, table


def test_a_sweep_whose_worker_is_killed_gives_the_same_table(serial: tuple[Path, bytes]) -> None:
    folder, table = serial
    process = started(folder, "killed", 2)
    while len(workers_of(folder, "killed")) < 6:
        assert process.poll() is None, process.communicate()
        time.sleep(0.02)
    killed = workers_of(folder, "killed")[-1]
    os.kill(int(killed.rpartition(":")[2]), signal.SIGKILL)
    _, said = process.communicate(timeout=600)
    assert process.returncode == 0, said.decode()
    assert (folder / "killed/table.csv").read_bytes() == table
    assert len(set(workers_of(folder, "killed"))) > 2, "another one took the place of the dead"
    assert len(set(keys_of(folder, "killed"))) == ROWS == len(keys_of(folder, "killed"))


def test_a_sweep_killed_at_random_moments_resumes(serial: tuple[Path, bytes]) -> None:
    folder, table = serial
    begin = time.perf_counter()
    finished(folder, "serial", 0)  # nothing is left to compute
    longest_s = 3 * (time.perf_counter() - begin)
    moments = random.Random(7)
    done = []
    for kill in range(20):
        process = started(folder, "moments", 2 if kill % 5 == 4 else 0)
        with suppress(subprocess.TimeoutExpired):
            process.wait(moments.uniform(0.2, longest_s))
        with suppress(ProcessLookupError):  # it was done before
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        done.append(len(keys_of(folder, "moments")))
    assert done == sorted(done)
    assert any(0 < count < ROWS for count in done)
    assert finished(folder, "moments", 0) == table
    assert len(set(keys_of(folder, "moments"))) == ROWS == len(keys_of(folder, "moments"))


def test_two_parallel_sweeps_share_the_rows(serial: tuple[Path, bytes]) -> None:
    folder, table = serial
    both = [started(folder, "both", 0) for _ in range(2)]
    for process in both:
        _, said = process.communicate(timeout=600)
        assert process.returncode == 0, said.decode()
    assert (folder / "both/table.csv").read_bytes() == table
    assert len(set(keys_of(folder, "both"))) == ROWS == len(keys_of(folder, "both"))
    assert len(set(workers_of(folder, "both"))) == 2, "each of them computed some"


def test_an_interrupted_sweep_prints_no_traceback(serial: tuple[Path, bytes]) -> None:
    """A terminal interrupts all processes of a command at once."""
    folder, table = serial
    process = started(folder, "interrupted", 2)
    while len(workers_of(folder, "interrupted")) < 3:
        assert process.poll() is None, process.communicate()
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGINT)
    _, said = process.communicate(timeout=600)
    assert process.returncode == 130
    assert b"Traceback" not in said
    assert b"KeyboardInterrupt" not in said
    assert b"stored in 'interrupted/store.sqlite'; the same command continues" in said
    assert finished(folder, "interrupted", 0) == table


def test_a_sweep_on_a_dask_scheduler_gives_the_same_table(serial: tuple[Path, bytes]) -> None:
    from distributed import LocalCluster

    folder, table = serial
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        address = cluster.scheduler_address
        process = subprocess.run(
            [
                sys.executable,
                "-m",
                "nscc_cli",
                "sweep",
                "grid.toml",
                "--out",
                "own",
                "--scheduler",
                address,
            ],
            cwd=folder,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
            capture_output=True,
            text=True,
            timeout=600,
        )
    assert process.returncode == 0, process.stderr
    assert (folder / "own/table.csv").read_bytes() == table


def test_a_point_that_kills_its_workers_is_a_failed_row_of_the_table(tmp_path: Path) -> None:
    """A loss of the user's own ends the process. The points beside it are computed."""
    pytest.importorskip("torch")
    (tmp_path / "deadly.py").write_text("import os\nos._exit(9)\n")
    (tmp_path / "config.toml").write_text(
        "[shutter]\nslots = 8\ntile = [2, 2]\n[data]\npatch = 16\nscenes = 2\nval_items = 1\n"
        "[train]\nsteps = 1\nbatch = 1\nvalidate_every = 1\n"
    )
    (tmp_path / "grid.toml").write_text(
        '[run]\nkind = "train"\nconfig = "config.toml"\nloss.name = ["l1", "deadly:loss", "log"]\n'
    )
    finished(tmp_path, "out", 2, status=1)
    with open(tmp_path / "out/table.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["code"] for row in rows] == ["", "NS0833", ""]
    assert "its worker ended" in rows[1]["error"]
    assert rows[0]["psnr_db"]
    assert (tmp_path / "out/runs/run_l1/shutter.nsl").is_file()
