"""`nscc doctor`: what this installation has, and what it would need for the rest."""

from __future__ import annotations

from itertools import chain

import click

from nscc_cli.support import CommonCommand


@click.command("doctor", cls=CommonCommand)
def command() -> int:
    """Report versions, extras, the cache, compiled loops and serial ports.

    Exits with status 3 if something that nscc needs is missing or broken.
    """
    from nscc import installation
    from nscc_runtime import installation as runtime

    status = 0
    for state, text in chain(installation.findings(), runtime.findings()):
        click.echo(f"{state:8}{text}")
        status = 3 if state == installation.WRONG else status
    return status
