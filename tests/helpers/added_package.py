"""A distribution from outside, as small as it can be: one module and its entry points."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from textwrap import dedent


def add_package(folder: Path, source: str, group: str, name: str, value: str) -> None:
    """Lays the distribution `mine` into `folder`: module `mine.py` holds `source`, and its entry
    point `name` of `group` is `mine:value`.
    """
    (folder / "mine.py").write_text(dedent(source))
    about = folder / "mine-1.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: mine\nVersion: 1\n")
    (about / "entry_points.txt").write_text(f"[{group}]\n{name} = mine:{value}\n")


def nscc_with(folder: Path, *arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Runs `nscc ARGUMENTS` in `folder`, with what lies there installed; text in and out."""
    return subprocess.run(
        [sys.executable, "-m", "nscc_cli", *map(str, arguments)],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(folder), *sys.path])},
        capture_output=True,
        text=True,
        timeout=300,
    )
