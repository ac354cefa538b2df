"""A running `nscc play`, for tests of the server and of its page."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def play_session(folder: Path, program: str) -> Iterator[str]:
    """Serve the page for `program`, saved as `folder`/mine.nsl, and yield the page's address."""
    (folder / "mine.nsl").write_text(program)
    command = [sys.executable, "-m", "nscc_cli", "play", "mine.nsl", "--no-browser"]
    with subprocess.Popen(
        command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as server:
        assert server.stdout is not None
        yield server.stdout.readline().strip()
        server.terminate()
