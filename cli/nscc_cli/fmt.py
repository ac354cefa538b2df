"""`nscc fmt`: format programs in the standard style."""

from __future__ import annotations

import sys
from difflib import unified_diff
from pathlib import Path

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.files import write_back
from nscc.syntax.format import format_source
from nscc.syntax.parse import MOST_BYTES, read_source, source_of
from nscc_cli.options import PATH, flag
from nscc_cli.support import common_command, say_done

_STANDARD_INPUT = Path("-")


@common_command("fmt")
@click.argument("files", nargs=-1, required=True, metavar="FILE...|-", type=PATH)
@flag("--check", "Write nothing; exit with status 1 if a file would change.")
@flag("--diff", "Write nothing; print the changes.")
def command(files: tuple[Path, ...], check: bool, diff: bool) -> int:
    """Format programs in the standard style; `-` formats standard input and prints the result.

    Only blanks and line breaks change; statements, comments and groups of lines stay. A file with
    an error is not changed."""
    diagnostics: list[Diagnostic] = []
    status = changed = 0
    for path in files:
        piped = path == _STANDARD_INPUT
        try:
            source = (
                source_of(path, sys.stdin.buffer.read(MOST_BYTES + 1))
                if piped
                else read_source(path)
            )
            text = format_source(source)
        except Rejected as rejected:
            diagnostics.extend(rejected.diagnostics)
            status = max(status, rejected.status)
            continue
        differs = text != source.text
        changed += differs
        # `--diff` and `--check` only report; standard input is printed, and other files are
        # rewritten.
        if diff:
            lines = source.text.splitlines(keepends=True), text.splitlines(keepends=True)
            click.echo("".join(unified_diff(*lines, source.name, source.name)), nl=False)
        elif check:
            if differs:
                say_done(f"{path.as_posix()} would change")
        elif piped:
            click.echo(text, nl=False)
        elif differs:
            write_back(path, text.encode())
            say_done(f"wrote {path.as_posix()}")
    if diagnostics:
        raise Rejected(diagnostics, status)
    return 1 if check and changed else 0
