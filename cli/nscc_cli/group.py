"""The click group of nscc: loads a command's module only when that command is called."""

from __future__ import annotations

from importlib import import_module

import click

from nscc import __version__
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_cli.table import COMMANDS

_MODULES = {entry.name: entry.module for entry in COMMANDS}


class LazyGroup(click.Group):
    """Finds commands in the table; an unknown one is rejected (NS0781)."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The names of this version's commands, as `--help` and completion show them."""
        return [entry.name for entry in COMMANDS]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of that name, imported now; None if there is none."""
        module = _MODULES.get(cmd_name)
        if module is None:
            return None
        command = import_module(module).command
        if not isinstance(command, click.Command):
            raise TypeError(f"{module}.command is no click command")
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The command named first in `args`, and what follows it."""
        name = args[0]
        command = self.get_command(ctx, name)
        if command is not None:
            return name, command, args[1:]
        if name.startswith("-"):
            raise click.NoSuchOption(name, ctx=ctx)
        raise Rejected(_unknown(name), status=2)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the commands from the table, importing none."""
        with formatter.section("Commands"):
            formatter.write_dl([(entry.name, entry.help) for entry in COMMANDS])


def _unknown(name: str) -> Diagnostic:
    known = [entry.name for entry in COMMANDS]
    from difflib import get_close_matches

    close = get_close_matches(name, known, n=1)
    if close:
        helps = (f"did you mean `nscc {close[0]}`?",)
    elif name.endswith((".nsl", ".icw")):
        helps = (f"name a command first: `nscc check {name}`",)
    else:
        helps = ("`nscc --help` lists the commands",)
    return Diagnostic("NS0781", f"nscc has no command '{name}'", helps=helps)


def _version(context: click.Context, _option: click.Parameter, value: bool) -> None:
    if value and not context.resilient_parsing:
        click.echo(f"nscc {__version__}")
        context.exit()


group = LazyGroup(
    name="nscc",
    help="Compile per-pixel shutter programs for SCAMP-5 class vision chips, and run them.",
    epilog="`nscc COMMAND --help` says more about one; `nscc explain NSxxxx` about a message.",
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    params=[
        click.Option(
            ["--version"],
            is_flag=True,
            is_eager=True,
            expose_value=False,
            callback=_version,
            help="Print the version and exit.",
        )
    ],
)
