"""Generate reference pages from the tool's own output and tables."""

from __future__ import annotations

import inspect
import tomllib
from pathlib import Path

import click

from nscc.chips.load import builtin_target, target_names
from nscc.diagnostics.explain import page
from nscc.diagnostics.render import names
from nscc_cli.group import COMMANDS, group
from nscc_cli.support import CommonCommand
from nscc_runtime.effects import registered
from nscc_runtime.sensor import default_sensor
from nscc_site.tool import block, said, table

_OF_ALL = ("-h", "--help", "--message-format", "--deny-warnings")
"""Options of all commands."""
_PROTOCOLS = Path(__file__).resolve().parents[2] / "training" / "protocols"


def reference_pages() -> dict[str, str]:
    """Return all reference pages by their path in `docs/generated`."""
    return {
        "effects.md": _effects(),
        "targets.md": _targets(),
        "settings.md": _settings(),
        "protocols.md": _protocols(),
        **_commands(),
        **_messages(),
    }


def _commands() -> dict[str, str]:
    """Return the list of all commands, and a page for each with its usage and its options."""
    rows = [("command", "does")]
    rows += [(f"[{name}](commands/{name}.md)", text) for name, text in COMMANDS.items()]
    hidden = "```{toctree}\n:hidden:\n:glob:\n\ncommands/*\n```\n"
    intro = "`nscc COMMAND --help` prints the same texts.\n"
    pages = {"commands.md": "\n".join(("# Commands\n", intro, table(rows), hidden))}
    for name in COMMANDS:
        command = group.get_command(click.Context(group), name)
        assert command is not None  # it is in the table
        parts = [f"# nscc {name}\n", _command(command, f"nscc {name}")]
        for part, inner in _subcommands(command):
            parts += [f"## nscc {name} {part}\n", _command(inner, f"nscc {name} {part}")]
        parts.append("Options of all commands: [](../../commands.md#all-commands).\n")
        pages[f"commands/{name}.md"] = "\n".join(parts)
    return pages


def _subcommands(command: click.Command) -> list[tuple[str, click.Command]]:
    """Return the listed subcommands of a command by name."""
    if not isinstance(command, click.Group):
        return []
    listed = command.list_commands(click.Context(command))
    return [(name, command.commands[name]) for name in listed]


def _command(command: click.Command, path: str) -> str:
    """Return usage, text and options of a command, without the options of all commands."""
    context = click.Context(command, info_name=path)
    usage = " ".join([path, *command.collect_usage_pieces(context)])
    parts = [block(usage), f"{_plain(inspect.cleandoc(command.help or ''))}\n"]
    assert isinstance(command, CommonCommand)
    rows = [("option", "meaning")]
    for title, records in command.option_sections(context).items():
        known = [
            (f"`{option}`", _plain(text))
            for option, text in records
            if not option.startswith(_OF_ALL)
        ]
        rows += [(f"**{title}**", "")] * (bool(known) and title != "Options") + known
    return "\n".join(parts + [table(rows)] * (len(rows) > 1))


def _messages() -> dict[str, str]:
    """Return a page for each message, as `nscc explain` prints it, and a list of all messages."""
    pages = {f"messages/{code}.md": page(code) for code in names()}
    rows = [("code", "name", "")]
    for code, name in names().items():
        title = page(code).partition("\n")[0].partition(":")[2].strip()
        rows.append((f"[{code}](messages/{code}.md)", f"`{name}`", title))
    hidden = "```{toctree}\n:hidden:\n:glob:\n\nmessages/*\n```\n"
    intro = "`nscc explain CODE` prints the page of an error, a warning or a note.\n"
    pages["messages.md"] = "\n".join(("# Messages\n", intro, table(rows), hidden))
    return pages


def _effects() -> str:
    """Return the page of all effects, with their parameters and the defaults for scamp5."""
    sensor = default_sensor(builtin_target("scamp5"))
    rows = [("effect", "kind", "")]
    rows += [(f"[{each.name}](#{each.name})", each.kind, each.title) for each in registered()]
    parts = [
        "# Effects of the sensor\n",
        "`nscc effects` prints this list. *Fixed* effects are the same in every frame. *Random* "
        "effects are new in every frame. Effects *after* act in the readout.\n",
        table(rows),
    ]
    for each in registered():
        parts += [f"({each.name})=\n## {each.name}: {each.title}\n"]
        for heading in ("model", "size", "cost", "applied"):
            parts.append(f"**{heading}**: {_plain(getattr(each, heading))}\n")
        if each.parameters:
            head = [("parameter", "default", "unit", "range", "meaning", "source")]
            parts.append(
                table(
                    head
                    + [
                        (
                            f"`{row.name}`",
                            f"{getattr(sensor, row.name):.10g}",
                            row.kind.unit,
                            _plain(row.kind.range),
                            _plain(row.meaning),
                            _plain(row.source),
                        )
                        for row in each.parameters
                    ]
                )
            )
    return "\n".join(parts)


def _targets() -> str:
    """Return the page of all built-in chips, with their target files."""
    parts = ["# Targets\n", "`nscc targets` prints this list.\n", block(said("targets"))]
    for name in target_names():
        parts += [
            f"## {name}\n",
            block(said(f"targets {name}")),
            f"As a file (`nscc targets {name} --toml`):\n",
            block(said(f"targets {name} --toml"), "toml"),
        ]
    return "\n".join(parts)


def _settings() -> str:
    return "\n".join(
        (
            "# Training settings\n",
            "`nscc train --schema` prints this text.\n",
            block(said("train --schema"), "toml"),
        )
    )


def _protocols() -> str:
    parts = ["# Protocols\n", "Every evaluation follows a protocol. Its file never changes.\n"]
    for path in sorted(_PROTOCOLS.glob("*.toml")):
        text = path.read_text()
        tomllib.loads(text)
        parts += [f"## {path.stem}\n", block(text, "toml")]
    return "\n".join(parts)


def _plain(text: str) -> str:
    """Return text with the special characters of Markdown escaped."""
    for sign in "\\*_<>[]^~$":
        text = text.replace(sign, f"\\{sign}")
    return text
