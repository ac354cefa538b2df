"""`nscc lsp`: the language server that editors start."""

from __future__ import annotations

import os
import sys

import click

from nscc_cli.support import CommonCommand, say_done


@click.command("lsp", cls=CommonCommand)
@click.option("--stdio", is_flag=True,
              help="Use standard input and output, the only supported transport.")  # fmt: skip
def command(stdio: bool) -> None:
    """Serve editors, over standard input and output, as the Language Server Protocol has it.

    Messages as one types, their fixes, what names and slots mean and cost, completion, the outline,
    other names, the one style. `docs/editors.md` says how editors come to start it.
    """
    from nscc_cli.language_server import make_server

    if sys.stdin.isatty():
        say_done("waiting for an editor on standard input: Ctrl-C ends it")
    with os.fdopen(os.dup(sys.stdout.fileno()), "wb") as out:  # the server closes what it is given
        make_server().start_io(stdout=out)
