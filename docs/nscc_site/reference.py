"""Reference pages, made of what the tool says and knows of itself."""

from __future__ import annotations

import inspect
import tomllib
from pathlib import Path

import click

from nscc.chips.load import builtin_target, target_names
from nscc.diagnostics.explain import page
from nscc.diagnostics.render import names
from nscc_cli.group import group
from nscc_cli.support import CommonCommand
from nscc_cli.table import COMMANDS
from nscc_runtime.effects import registered
from nscc_runtime.sensor import default_sensor
from nscc_site.tool import block, said, table

_OF_ALL = ("-h", "--help", "--message-format", "--deny-warnings")
"""Options of all commands."""
_PROTOCOLS = Path(__file__).resolve().parents[2] / "training" / "protocols"


def reference_pages() -> dict[str, str]:
    """All pages by their path in `docs/generated`."""
    return {
        "commands.md": _commands(),
        "effects.md": _effects(),
        "targets.md": _targets(),
        "settings.md": _settings(),
        "protocols.md": _protocols(),
        **_messages(),
    }


def _commands() -> str:
    """All commands, and for each of them its use and a table of its options."""
    names = [("command", "does")]
    names += [(f"[{name}](#nscc-{name})", text) for name, text in COMMANDS.items()]
    parts = ["# Commands\n", "`nscc COMMAND --help` prints what stands here.\n", table(names)]
    for name in COMMANDS:
        command = group.get_command(click.Context(group), name)
        assert command is not None  # it is in the table
        parts += [f"## nscc {name}\n", _command(command, f"nscc {name}")]
        for part, inner in command.commands.items() if isinstance(command, click.Group) else ():
            parts += [f"### nscc {name} {part}\n", _command(inner, f"nscc {name} {part}")]
    return "\n".join(parts)


def _command(command: click.Command, path: str) -> str:
    """The usage line, the text, and the options by sections; those of all commands are left out."""
    context = click.Context(command, info_name=path)
    usage = " ".join([path, *command.collect_usage_pieces(context)])
    parts = [block(usage), f"{_plain(inspect.cleandoc(command.help or ''))}\n"]
    assert isinstance(command, CommonCommand)
    rows = [("option", "meaning")]
    for title, records in command.option_sections(context).items():
        known = [(f"`{option}`", _plain(text)) for option, text in records
                 if not option.startswith(_OF_ALL)]  # fmt: skip
        rows += [(f"**{title}**", "")] * (bool(known) and title != "Options") + known
    return "\n".join(parts + [table(rows)] * (len(rows) > 1))


def _messages() -> dict[str, str]:
    """A page for each message, as `nscc explain` prints it, and a list of them."""
    pages = {f"messages/{code}.md": page(code) for code in names()}
    rows = [("code", "name", "")]
    for code, name in names().items():
        title = page(code).partition("\n")[0].partition(":")[2].strip()
        rows.append((f"[{code}](messages/{code}.md)", f"`{name}`", title))
    hidden = "```{toctree}\n:hidden:\n:glob:\n\nmessages/*\n```\n"
    intro = (
        "Every error, warning and note has a page of its own, which `nscc explain CODE` prints.\n"
    )
    pages["messages.md"] = "\n".join(("# Messages\n", intro, table(rows), hidden))
    return pages


def _effects() -> str:
    """Every effect of the sensor with its parameters and their defaults for the default target."""
    sensor = default_sensor(builtin_target("scamp5"))
    rows = [("effect", "kind", "")]
    rows += [(f"[{each.name}](#{each.name})", each.kind, each.title) for each in registered()]
    parts = [
        "# Effects of the sensor\n",
        "What `nscc effects` lists. *Fixed* effects are the same in every frame, *random* ones new "
        "in every frame, those *after* act in the readout.\n",
        table(rows),
    ]
    for each in registered():
        parts += [f"({each.name})=\n## {each.name}: {each.title}\n"]
        for heading in ("model", "size", "cost", "applied"):
            parts.append(f"**{heading}**: {_plain(getattr(each, heading))}\n")
        if each.parameters:
            head = [("parameter", "default", "unit", "range", "meaning", "source")]
            parts.append(table(head + [
                (f"`{row.name}`", f"{getattr(sensor, row.name):.10g}", row.kind.unit,
                 _plain(row.kind.range), _plain(row.meaning), _plain(row.source))
                for row in each.parameters
            ]))  # fmt: skip
    return "\n".join(parts)


def _targets() -> str:
    """Every built-in chip, and the file that says all of it."""
    parts = ["# Targets\n", "What `nscc targets` knows.\n", block(said("targets"))]
    for name in target_names():
        parts += [
            f"## {name}\n", block(said(f"targets {name}")),
            f"As a file (`nscc targets {name} --toml`):\n",
            block(said(f"targets {name} --toml"), "toml"),
        ]  # fmt: skip
    return "\n".join(parts)


def _settings() -> str:
    return "\n".join((
        "# Settings of a training\n", "What `nscc train --schema` prints.\n",
        block(said("train --schema"), "toml"),
    ))  # fmt: skip


def _protocols() -> str:
    parts = ["# Protocols\n", "A score belongs to a protocol: a frozen file, here as it stands.\n"]
    for path in sorted(_PROTOCOLS.glob("*.toml")):
        text = path.read_text()
        tomllib.loads(text)
        parts += [f"## {path.stem}\n", block(text, "toml")]
    return "\n".join(parts)


def _plain(text: str) -> str:
    """Text that Markdown takes as it is."""
    for sign in "\\*_<>[]^~$":
        text = text.replace(sign, f"\\{sign}")
    return text
