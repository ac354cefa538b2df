"""`nscc examples`: what comes with nscc, to read and to copy."""

from __future__ import annotations

from pathlib import Path

import click

from nscc_cli.completion import EXAMPLE
from nscc_cli.options import OUT
from nscc_cli.support import CommonCommand, done


@click.command("examples", cls=CommonCommand)
@click.argument("names", type=EXAMPLE, metavar="[NAME..]", nargs=-1)
@click.option("-o", "folder", type=OUT, metavar="DIR", default=Path(),
              help="Where copies go (default: this folder).")  # fmt: skip
def command(names: tuple[str, ...], folder: Path) -> None:
    """List the programs that come with nscc, or copy those that are named."""
    from nscc.examples import about, example, examples
    from nscc.files import write_new

    if names:
        files = [example(name) for name in names]
        write_new({folder / path.name: path.read_bytes() for path in files})
        done("\n".join(f"wrote {(folder / path.name).as_posix()}" for path in files))
        return
    known = examples()
    width = max(map(len, known))
    for name, path in known.items():
        click.echo(f"{name:<{width}}  {about(path)}")
    done("\n`nscc examples NAME` copies one, `nscc check` and `nscc run` take it from there")
