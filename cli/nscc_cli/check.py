"""`nscc check`: parse, check, fit; writes nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.emit.summary import summary
from nscc_cli.options import PATH, build_options
from nscc_cli.programs import compile_program
from nscc_cli.support import CommonCommand, say


@click.command("check", cls=CommonCommand)
@click.argument("files", nargs=-1, required=True, metavar="FILE...", type=PATH)
@build_options
def command(files: tuple[Path, ...], **options: Any) -> None:
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
            compiled = compile_program(path, options, unproved_is_error=False)
            say(compiled.diagnostics)
        except Rejected as rejected:
            wrong.extend(rejected.diagnostics)
            status = max(status, rejected.status)
        else:
            click.echo(summary(path.as_posix(), compiled))
    if wrong:
        raise Rejected(wrong, status)
