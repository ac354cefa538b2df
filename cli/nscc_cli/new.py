"""`nscc new`: a commented program to begin with."""

from __future__ import annotations

from pathlib import Path

import click

from nscc_cli.options import OUT
from nscc_cli.support import CommonCommand, done


@click.command("new", cls=CommonCommand)
@click.argument("name", type=OUT, metavar="NAME")
def command(name: Path) -> None:
    """Write NAME.nsl: a program with a remark on every statement, which checks and runs."""
    from nscc.examples import START
    from nscc.files import write_new

    if name.name in ("", "..", ".nsl"):
        raise click.BadParameter(f"'{name}' names no file", param_hint="NAME")
    path = name if name.suffix == ".nsl" else name.with_name(name.name + ".nsl")
    write_new({path: START.encode()})
    done(f"wrote {path.as_posix()}: `nscc check {path.as_posix()}` says what it is")
