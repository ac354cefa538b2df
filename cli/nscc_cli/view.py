"""`nscc view`: draw a program's shutters over time and its map of codes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.files import write_whole
from nscc_cli.programs import BuildChoice, build_options, load_program
from nscc_cli.support import CommonCommand, done, say


@click.command(name="view", cls=CommonCommand)
@click.argument("program", metavar="FILE.nsl|FILE.icw", type=click.Path(path_type=Path))
@click.option(
    "-o",
    "out",
    type=click.Path(path_type=Path),
    help="The picture (default: the program's name with .png, in this folder).",
)
@build_options
def command(program: Path, out: Path | None, **options: Any) -> None:
    """Draw the shutters of a program as a time chart, and the map of its codes, as a PNG."""
    container, messages = load_program(program, BuildChoice.of(options))
    say(messages)
    from nscc_runtime.chart import view_png

    out = out or Path(program.stem + ".png")
    write_whole(out, view_png(container, program.name))
    done(f"wrote {out.as_posix()}")
