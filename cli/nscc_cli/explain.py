"""`nscc explain`: what a message means, with a program that raises it and one put right."""

from __future__ import annotations

import click

from nscc.diagnostics.explain import index, page
from nscc_cli.completion import MESSAGE
from nscc_cli.support import CommonCommand


@click.command("explain", cls=CommonCommand)
@click.argument("code", required=False, type=MESSAGE)
def command(code: str | None) -> None:
    """Explain CODE (NS0412, 412, or its name); without one, list all codes."""
    click.echo(index() if code is None else page(code), nl=False)
