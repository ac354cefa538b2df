"""`nscc disasm`: a container as assembly text."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.files import write_whole
from nscc.words.disassembly import disassemble
from nscc.words.file import read_container
from nscc_cli.support import CommonCommand, OutPath


@click.command(name="disasm", cls=CommonCommand)
@click.argument("file", metavar="FILE.icw")
@click.option("-o", "output", type=OutPath(str), metavar="OUT",
              help="Where to write (default: standard output).")  # fmt: skip
def command(file: str, output: str | None) -> None:
    """List FILE.icw as text that `nscc asm` turns into the same file again."""
    text = disassemble(read_container(Path(file)))
    if output is None or output == "-":
        click.echo(text.encode("utf-8"), nl=False)
    else:
        write_whole(Path(output), text.encode("utf-8"))
