"""`nscc lsp`: the language server that editors start."""

from __future__ import annotations

import os
import sys

import click

from nscc_cli.support import common_command, say_done


@common_command("lsp")
@click.option(
    "--stdio", is_flag=True, help="Use standard input and output, the only supported transport."
)
def command(stdio: bool) -> None:
    """Serve editors over standard input and output, by the Language Server Protocol.

    Offers messages while typing, fixes, hover texts with the cost of slots, completion, outline,
    renaming and formatting. `docs/editors.md` explains how to set up editors."""
    from nscc_cli.language_server import make_server

    if sys.stdin.isatty():
        say_done("waiting for an editor on standard input: Ctrl-C ends it")
    with os.fdopen(os.dup(sys.stdout.fileno()), "wb") as out:  # the server closes these streams
        make_server().start_io(stdout=out)
