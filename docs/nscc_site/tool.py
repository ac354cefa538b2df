"""What `nscc` prints, for pages that show it."""

from __future__ import annotations

import io
import shlex
from contextlib import chdir, redirect_stderr, redirect_stdout
from pathlib import Path

from nscc_cli.main import main


def said(command: str, folder: Path = Path()) -> str:
    """What a command (without `nscc`) prints to standard output in `folder`.

    Raises RuntimeError with all that it said where it does not end with status 0.
    """
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err), chdir(folder):
        status = main(shlex.split(command))
    if status != 0:
        raise RuntimeError(f"nscc {command}: status {status}\n{out.getvalue()}{err.getvalue()}")
    return out.getvalue()


def block(text: str, language: str = "text") -> str:
    """A fenced block."""
    return f"````{language}\n{text.rstrip()}\n````\n"


def table(rows: list[tuple[str, ...]]) -> str:
    """A table whose first row is its head."""
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    lines.insert(1, "|---" * len(rows[0]) + "|")
    return "\n".join(lines) + "\n"


def grid(cards: list[str]) -> str:
    """Cards side by side, as many in a row as there is room for."""
    parts = (f":::{{container}} card\n{card}\n:::" for card in cards)
    return "::::{container} cards\n" + "\n".join(parts) + "\n::::\n"
