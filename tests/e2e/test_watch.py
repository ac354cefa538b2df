"""`nscc check --watch`: a process that looks again when files change."""

from __future__ import annotations

import os
import queue
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import Thread

import numpy as np
import pytest

from nscc.compiler import files_of
from nscc_cli.main import main

GOOD = 'nsl 1\nframe 8 slots of 1ms\ncode c : 0..1\nopen when n < c\npixels from "codes.npz"\n'
WAIT_S = 60
Lines = queue.Queue[str]


@contextmanager
def watching(
    *arguments: str, folder: Path
) -> Iterator[tuple[queue.Queue[str], subprocess.Popen[str]]]:
    """A watching process; its lines, as they come."""
    process = subprocess.Popen(
        [sys.executable, "-u", "-m", "nscc_cli", "check", "--watch", *arguments],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    lines: Lines = queue.Queue()
    assert process.stdout is not None
    out = process.stdout
    reader = Thread(target=lambda: [lines.put(line.rstrip("\n")) for line in out], daemon=True)
    reader.start()
    try:
        yield lines, process
    finally:
        process.kill()
        process.wait()
        reader.join()
        out.close()


def until(lines: Lines, *pieces: str) -> list[str]:
    """The lines up to one that holds all these pieces of text."""
    found: list[str] = []
    while not found or not all(piece in found[-1] for piece in pieces):
        found.append(lines.get(timeout=WAIT_S))
    return found


def test_check_with_watch_checks_changed_and_new_files_again(tmp_path: Path) -> None:
    program, codes = tmp_path / "a.nsl", tmp_path / "deep" / "codes.npz"
    codes.parent.mkdir()
    program.write_text(GOOD.replace("codes.npz", "deep/codes.npz"))
    with watching("a.nsl", folder=tmp_path) as (lines, process):
        assert "NS0313" in "".join(until(lines, "watching a.nsl"))
        np.savez(codes, c=np.ones((256, 256), np.uint8))
        assert "deep/codes.npz changed" in until(lines, "changed")[-1]
        assert "a.nsl: fits scamp5" in until(lines, "Ctrl-C ends it")[0]
        program.write_text("nsl 1\nframe 8 slots of 1ms\nopen wehn true\n")
        # Beside a file that was seen half written, and so changes once more.
        until(lines, "a.nsl", "changed")
        assert "NS0107" in "".join(until(lines, "Ctrl-C ends it"))
        (tmp_path / "new.nsl").write_text("nsl 1\nframe 8 slots of 1ms\nopen when true\n")
        (tmp_path / "new.nsl").replace(program)  # as editors do
        until(lines, "a.nsl changed")
        assert "a.nsl: fits scamp5" in until(lines, "Ctrl-C ends it")[0]
        process.send_signal(signal.SIGINT)
        assert process.wait(WAIT_S) == 0


def test_all_files_that_a_program_names_are_watched(tmp_path: Path) -> None:
    program = tmp_path / "a.nsl"
    assert files_of(program) == {program}
    program.write_text(
        'nsl 1\ntarget "own.toml"\nshutters b from "../b.npz" key k\nfram\n' + GOOD[6:]
    )
    named = ("own.toml", "../b.npz", "codes.npz")
    assert files_of(program) == {program, *(tmp_path / name for name in named)}
    program.write_text('nsl 3\nframe 4 slots of 1ms\nkernel k from "k.npz"\nopen when true\n')
    assert files_of(program) == {program, tmp_path / "k.npz"}


def test_watch_refuses_the_sarif_format(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "--watch", "--message-format", "sarif", "a.nsl"]) == 2
    assert "--watch runs forever" in capsys.readouterr().err
