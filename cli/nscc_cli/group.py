"""The group `nscc` of all commands, which loads the module of the command in use."""

from __future__ import annotations

import gc
import shlex
from importlib import import_module

import click

from nscc import __version__
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.diagnostics.suggest import did_you_mean, meant
from nscc.plugins import added, unusable
from nscc_cli.support import show


class LazyGroup(click.Group):
    """The group of all commands: nscc's table, then the commands that other distributions add.

    Other distributions are searched only if the name is not in the table. An unknown name is
    rejected (NS0781)."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of all commands, nscc's own first."""
        return [*COMMANDS, *self._usable_added()]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import the module of the command `cmd_name` and return the command; None if the name is
        unknown."""
        if cmd_name not in COMMANDS:
            return added_by_packages().get(cmd_name)
        module = import_module(f"nscc_cli.{MODULES.get(cmd_name, cmd_name)}")
        name = cmd_name.replace("-", "_") if cmd_name in MODULES else "command"
        command: click.Command = getattr(module, name)
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the name and the command that the first of `args` names, and the arguments after
        it.

        Raises Rejected (NS0781) for an unknown command, and NoSuchOption for an option before the
        command. Here Python's garbage collector is turned on again."""
        name = args[0]
        if name.startswith("-"):
            raise click.NoSuchOption(name, ctx=ctx)
        command = self.get_command(ctx, name)
        if command is None:
            otherwise = "`nscc --help` lists the commands"
            if name.endswith((".nsl", ".icw")):
                otherwise = f"name a command first: `nscc check {shlex.quote(name)}`"
            helps = meant(name, self.list_commands(ctx), otherwise, "nscc {}")
            if name in SYNONYMS:
                helps = (did_you_mean(f"nscc {SYNONYMS[name]}"),)
            raise Rejected(Diagnostic("NS0781", f"unknown command '{name}'", helps=helps), status=2)
        if not gc.isenabled():  # `main` turned the collector off during the imports
            gc.freeze()
            gc.enable()
        return name, command, args[1:]

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write nscc's commands by task to `formatter` without importing them, then those of other
        packages."""
        width = max(map(len, COMMANDS))
        for title, lines in GROUPS.items():
            with formatter.section(title):
                formatter.write_dl([(f"{name:{width}}", line) for name, line in lines.items()])
        rows = [
            (name, command.get_short_help_str(80)) for name, command in self._usable_added().items()
        ]
        if rows:
            with formatter.section("Commands of other packages"):
                formatter.write_dl(rows)

    def _usable_added(self) -> dict[str, click.Command]:
        """Return the commands that other packages add, by name. If one is unusable, print its
        message and return none."""
        try:
            return added_by_packages()
        except Rejected as rejected:
            show(rejected.diagnostics)
            return {}


def added_by_packages() -> dict[str, click.Command]:
    """Return the commands that other packages add (entry points `nscc.commands`), by name. Raise
    Rejected (NS0905) for one that cannot be imported, is no click command, or has the name of
    another."""
    added_commands = added("nscc.commands", COMMANDS)
    for name, command in added_commands.items():
        if not isinstance(command, click.Command):
            raise unusable(
                "nscc.commands", name, f"a {type(command).__name__} is not a click command"
            )
    return added_commands


_version_option = click.version_option(
    __version__, message="nscc %(version)s", help="Print the version and exit."
)
group = _version_option(
    LazyGroup(
        name="nscc",
        help="Compile per-pixel shutter programs for SCAMP-5 class vision chips, and run them.",
        epilog=(
            "`nscc COMMAND --help` describes a command; `nscc explain NSxxxx` describes a message."
        ),
        context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    )
)


GROUPS = {
    "Start": {
        "play": "Try programs in a page of your browser.",
        "demo": "Expose and reconstruct a photo or a clip.",
        "examples": "List the programs that come with nscc, or copy one.",
        "new": "Write a first program, with comments.",
        "explain": "Explain an error code.",
        "doctor": "Report on this installation.",
    },
    "Write programs": {
        "check": "Report errors of programs, and whether they fit the chip.",
        "fmt": "Format programs in the standard style.",
        "lsp": "Start the language server for editors.",
        "design": "Compute a program for a scene.",
        "import-mask": "Write a program for the shutters in a mask file.",
        "import-network": "Write a program for a trained network of bits.",
    },
    "Compile and prove": {
        "build": "Compile a program to a container of words.",
        "view": "Draw a program's shutters and its map of codes.",
        "shutters": "Write the shutter of every pixel.",
        "export-mask": "Write the mask of a program for other tools.",
        "prove": "Prove that a container opens the shutters of its program.",
        "asm": "Assemble text into a container or words.",
        "disasm": "Write a container's words as assembly text.",
        "diff": "Print the differences between two containers.",
    },
    "Expose frames": {
        "run": "Expose one frame of a scene with a program.",
        "device": "Use a chip at a serial port, or simulate one.",
        "import-frame": "Write the frame file of pictures that a chip's host saved.",
        "targets": "List the known chips and their limits.",
        "effects": "List the sensor effects and their parameters.",
        "calibrate": "Measure a sensor from flat and dark frames.",
    },
    "Reconstruct and learn": {
        "reconstruct": "Decode a frame into a picture or a clip.",
        "metrics": "Compare a reconstruction with the ground truth.",
        "train": "Train shutters together with a decoder.",
        "classify": "Name the class of a frame's scene.",
        "evaluate": "Score reconstructions under a protocol.",
    },
    "Compare settings": {
        "tradeoff": "Measure error against computing time.",
        "sweep": "Compute all combinations of settings, in parallel.",
    },
}
"""The help line of each command by task, in the order of `nscc --help`."""
COMMANDS = {name: line for group in GROUPS.values() for name, line in group.items()}
"""The help line of each command.

A command is the function `command` in the module of its name. Commands in `MODULES` are functions
with their own name (with `_` for `-`) in the module that it names."""
MODULES = {
    **dict.fromkeys(("asm", "disasm", "diff", "export-mask", "prove", "shutters"), "containers"),
    **dict.fromkeys(("explain", "examples", "new", "doctor"), "guide"),
    **dict.fromkeys(("import-frame", "import-mask", "import-network"), "imports"),
    "classify": "reconstruct",
    "metrics": "evaluate",
}
SYNONYMS = {
    "compile": "build",
    "draw": "view",
    "plot": "view",
    "show": "view",
    "expose": "run",
    "simulate": "run",
    "verify": "prove",
    "decode": "reconstruct",
    "format": "fmt",
    "help": "--help",
}
"""Names that other tools have for a command, by that name."""
