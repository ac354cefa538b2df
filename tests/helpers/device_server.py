"""`nscc device serve` as a process, and small programs for it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from checkout import ROOT

from nscc.chips.load import builtin_target, target_toml

SIZE = 16
PROGRAM = """nsl 1
target "chip.toml"
frame 8 slots of 1ms
code stop : 1..8
open when n < stop
pixels stop = 1 + (x + 3 * y) % 8
"""
LIMIT_S = 100


def environment() -> dict[str, str]:
    """That of a process that runs this checkout."""
    folders = [ROOT, ROOT / "cli", ROOT / "runtime", ROOT / "training"]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, folders))}


def write_files(folder: Path) -> None:
    """A small chip and a program for it."""
    from dataclasses import replace

    small = replace(builtin_target("scamp5"), rows=SIZE, cols=SIZE)
    (folder / "chip.toml").write_text(target_toml(small))
    (folder / "small.nsl").write_text(PROGRAM)


def start(arguments: list[str], folder: Path) -> subprocess.Popen[str]:
    """`nscc ARGUMENTS` as a process."""
    return subprocess.Popen(
        [sys.executable, "-m", "nscc_cli", *arguments],
        cwd=folder,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


class Serving:
    """A running stand-in and the port that it printed."""

    def __init__(self, process: subprocess.Popen[str], port: str) -> None:
        self.process, self.port = process, port

    def stop(self) -> str:
        """End it as Ctrl-C does; what it said on standard error."""
        self.process.send_signal(signal.SIGINT)
        _, said = self.process.communicate(timeout=LIMIT_S)
        return said


@contextmanager
def serving(
    folder: Path, *more: str, scene: str = "builtin:hdr", line: list[str] | None = None
) -> Iterator[Serving]:
    """A stand-in for the small chip; or any, with the whole command as `line`."""
    arguments = ["device", "serve", "--target", "chip.toml", "--scene", scene, *more]
    process = start(line or arguments, folder)
    try:
        assert process.stdout is not None
        port = process.stdout.readline().strip()
        if not port:
            raise AssertionError(process.communicate(timeout=LIMIT_S)[1])
        yield Serving(process, port)
    finally:
        process.kill()
        process.communicate()
