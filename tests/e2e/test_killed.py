"""A tradeoff and a training that are killed at any moment end in the same bytes as undisturbed."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from time import perf_counter

import pytest

pytest.importorskip("torch")

pytestmark = pytest.mark.slow

KILLS = 20
LONGEST = 1.4
"""Latest moment of a kill, in times of a run that has nothing left to compute."""
TRADEOFF = [
    "tradeoff", "sensor", "--classes", "c,d", "--slots", "4,8", "--stop-slots", "4,8",
    "--looks", "2", "--lowerings", "accumulate,edges", "--target", "small.toml",
    "--readouts", "none", "-o", "out",
]  # fmt: skip
CONFIG = """
[shutter]
class = "d"
slots = 8
tile = [2, 2]
relaxation = "tried"

[data]
protocol = "video-v1"
scenes = 4
patch = 16
val_items = 1

[train]
steps = 60
batch = 2
validate_every = 3
average = 0.9
optimizer = "muon"
workers = 1
device = "cpu"
"""


def started(folder: Path, arguments: Sequence[str]) -> subprocess.Popen[bytes]:
    """A command in a session of its own, so that its workers are killed with it."""
    return subprocess.Popen(
        [sys.executable, "-m", "nscc_cli", *arguments],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        start_new_session=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )


def finished(folder: Path, arguments: Sequence[str]) -> float:
    """Run a command to its end; return its seconds."""
    begin = perf_counter()
    process = started(folder, arguments)
    _, said = process.communicate()
    assert process.returncode == 0, said.decode()
    return perf_counter() - begin


def killed(folder: Path, arguments: Sequence[str], again: Path, longest_s: float) -> int:
    """Kill a command at random moments up to `longest_s`; how often it was not done yet. Where it
    is, its product `again` is taken away, and the next kills come earlier: the machine is faster
    than it was when `longest_s` was measured."""
    moments = random.Random(38)
    early = 0
    for _ in range(KILLS):
        process = started(folder, arguments)
        with suppress(subprocess.TimeoutExpired):
            process.communicate(timeout=moments.uniform(0.5, longest_s))
        if process.poll() is None:
            early += 1
        else:
            longest_s *= 0.8
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        again.unlink(missing_ok=True)
    return early


def test_a_tradeoff_ends_in_the_same_table(tmp_path: Path) -> None:
    from dataclasses import replace

    from nscc.chips.load import builtin_target, target_toml

    small = replace(builtin_target("scamp5"), rows=64, cols=64)
    folders = [tmp_path / name for name in ("whole", "killed")]
    for folder in folders:
        folder.mkdir()
        (folder / "small.toml").write_text(target_toml(small))
    finished(folders[0], TRADEOFF)
    (folders[0] / "out.csv").unlink()
    known_s = finished(folders[0], TRADEOFF)
    assert killed(folders[1], TRADEOFF, folders[1] / "out.csv", LONGEST * known_s) >= KILLS // 2
    finished(folders[1], TRADEOFF)
    tables = [(folder / "out.csv").read_bytes() for folder in folders]
    assert tables[0] == tables[1]
    assert tables[0].count(b"\n") > 10
    assert {path.name for path in folders[1].iterdir()} == {"small.toml", "out.csv", "out.png"}


def test_a_training_ends_in_the_same_bytes(tmp_path: Path) -> None:
    """A training is killed again and again and then finished. Its files have the bytes of one that
    was never killed."""
    (tmp_path / "c.toml").write_text(CONFIG)
    whole = ["train", "c.toml", "--out", "whole"]
    finished(tmp_path, whole)
    done_s = finished(tmp_path, whole)
    line = ["train", "c.toml", "--out", "killed"]
    assert killed(tmp_path, line, tmp_path / "killed/result.json", LONGEST * done_s) >= KILLS // 2
    finished(tmp_path, line)
    files = [
        {path.name: path.read_bytes() for path in (tmp_path / name).iterdir() if path.is_file()}
        for name in ("whole", "killed")
    ]
    assert files[0] == files[1]
    assert {"decoder.safetensors", "checkpoint.safetensors", "metrics.csv"} <= set(files[0])
