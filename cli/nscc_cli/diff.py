"""`nscc diff`: what changed between two containers."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.words.diff import differences
from nscc.words.file import read_container
from nscc_cli.support import CommonCommand


@click.command(name="diff", cls=CommonCommand)
@click.argument("first", metavar="A.icw")
@click.argument("second", metavar="B.icw")
def command(first: str, second: str) -> None:
    """Say what differs between A.icw and B.icw: words, kernels, schedule, codes, costs."""
    lines = differences(read_container(Path(first)), read_container(Path(second)))
    click.echo("\n".join(lines) if lines else "identical")
