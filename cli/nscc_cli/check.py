"""`nscc check`: parse, check, fit; writes nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.emit.summary import summary
from nscc.program.problems import counted
from nscc_cli.options import PATH, build_options
from nscc_cli.programs import compile_program
from nscc_cli.support import CommonCommand, done, say

_MOST_ROUNDS = 20
"""Of mending: each ends at least one mistake."""


@click.command("check", cls=CommonCommand)
@click.argument("files", nargs=-1, required=True, metavar="FILE...", type=PATH)
@click.option("--fix", is_flag=True,
              help="First mend what has one sure remedy, in the files; names are not guessed "
              "at.")  # fmt: skip
@build_options
def command(files: tuple[Path, ...], fix: bool, **options: Any) -> None:
    """Check programs: what they are, whether they fit the chip, and that their words are right.

    Lowers at -O1, unless -O says otherwise, and proves that. Where only a search can tell whether
    a program fits, a note says that `nscc build` decides.
    """
    if options["level"] is None:
        options["level"] = 1
    wrong: list[Diagnostic] = []
    status = 0
    for path in files:
        try:
            if fix:
                _mend(path, options)
            compiled = compile_program(path, options, unproved_is_error=False)
            say(compiled.diagnostics)
        except Rejected as rejected:
            wrong.extend(rejected.diagnostics)
            status = max(status, rejected.status)
        else:
            click.echo(summary(path.as_posix(), compiled))
    if wrong:
        raise Rejected(wrong, status)


def _mend(path: Path, options: dict[str, Any]) -> None:
    """Apply sure fixes until none is left: one mistake may have hidden another."""
    from nscc.diagnostics.mend import mended
    from nscc.files import write_back
    from nscc.syntax.reading import read_source

    count = 0
    for _ in range(_MOST_ROUNDS):
        source = read_source(path)
        try:
            compile_program(path, options, unproved_is_error=False)
        except Rejected as rejected:
            better, fixes = mended(source, rejected.diagnostics)
        else:
            break
        if not fixes:
            break
        count += fixes
        write_back(path, better.text.encode())
    if count:
        done(f"mended {path.as_posix()}: {counted(count, 'change')}")
