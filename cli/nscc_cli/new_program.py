"""Options of commands that write a program and the arrays that it reads."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.files import refuse_same
from nscc_cli.options import OUT

NEW_PROGRAM = click.option(
    "-o", "out", required=True, metavar="P.nsl", type=OUT, help="The program."
)


def beside_program(out: Path, arrays: str) -> Path:
    """Return the path STEM.ARRAYS.npz beside a program, whose name must end in .nsl."""
    if out.suffix.lower() != ".nsl":
        raise click.BadParameter(f"'{out}' does not end in .nsl", param_hint="-o")
    path = out.with_suffix(f".{arrays}.npz")
    refuse_same([out, path], f"-o and its {arrays}")
    return path
