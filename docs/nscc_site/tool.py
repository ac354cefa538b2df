"""Run `nscc` and format its output for pages."""

from __future__ import annotations

import io
import shlex
from contextlib import chdir, redirect_stderr, redirect_stdout
from pathlib import Path

from nscc_cli.main import main


def run_nscc(command: str, folder: Path = Path()) -> tuple[str, str]:
    """Run a command (without `nscc`) in `folder`; return its standard output and its messages.

    Raises RuntimeError with the whole output if the exit status is not 0.
    """
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err), chdir(folder):
        status = main(shlex.split(command))
    if status != 0:
        raise RuntimeError(f"nscc {command}: status {status}\n{out.getvalue()}{err.getvalue()}")
    return out.getvalue(), err.getvalue()


def said(command: str, folder: Path = Path()) -> str:
    """Run a command as `run_nscc` does, and return its standard output."""
    return run_nscc(command, folder)[0]


def block(text: str, language: str = "text") -> str:
    """Return a fenced block."""
    return f"````{language}\n{text.rstrip()}\n````\n"


def table(rows: list[tuple[str, ...]]) -> str:
    """Return a Markdown table; the first row is the header."""
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    lines.insert(1, "|---" * len(rows[0]) + "|")
    return "\n".join(lines) + "\n"


def grid(cards: list[str]) -> str:
    """Return cards that are shown side by side."""
    parts = (f":::{{container}} card\n{card}\n:::" for card in cards)
    return "::::{container} cards\n" + "\n".join(parts) + "\n::::\n"
