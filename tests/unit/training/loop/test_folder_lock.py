"""One process at a time trains into a folder; the lock ends with the process and leaves no file."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from nscc_command import RunNscc

from nscc.diagnostics.diagnostic import Rejected
from nscc_training.loop.state import locked_folder

HOLD = """
import sys, time
from pathlib import Path
from nscc_training.loop.state import locked_folder
with locked_folder(Path("run")):
    print("held", flush=True)
    time.sleep(600)
"""
CONFIG = """[shutter]
slots = 8
tile = [2, 2]
[data]
patch = 16
scenes = 2
val_items = 1
[train]
steps = 1
batch = 1
validate_every = 1
"""


def test_another_process_keeps_a_run_out(tmp_path: Path, run_nscc: RunNscc) -> None:
    (tmp_path / "c.toml").write_text(CONFIG)
    with subprocess.Popen(
        [sys.executable, "-c", HOLD],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"held\n"
        outcome = run_nscc(["train", "c.toml", "--out", "run"], tmp_path)
        assert outcome.status == 2
        assert outcome.codes == ["NS0848"]
        assert list((tmp_path / "run").iterdir()) == []
        holder.send_signal(signal.SIGKILL)
    assert run_nscc(["train", "c.toml", "--out", "run"], tmp_path).status == 0
    assert (tmp_path / "run/result.json").is_file()


def test_a_run_that_does_not_begin_leaves_no_folder(tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError), locked_folder(tmp_path / "new"):
        raise ZeroDivisionError
    assert not (tmp_path / "new").exists()
    (tmp_path / "old").mkdir()
    with pytest.raises(ZeroDivisionError), locked_folder(tmp_path / "old"):
        raise ZeroDivisionError
    assert (tmp_path / "old").exists()
    with (
        locked_folder(tmp_path / "old"),
        pytest.raises(Rejected, match="NS0848"),
        locked_folder(tmp_path / "old"),
    ):
        pass
    with locked_folder(tmp_path / "old"):
        pass
