"""`nscc targets`: the chips that nscc knows, and everything it knows of one."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.cli.support import CommonCommand
from nscc.target.load import builtin_names, builtin_target, load_target, target_toml
from nscc.target.model import Target
from nscc.target.schema import KEYS


@click.command(name="targets", cls=CommonCommand)
@click.argument("name", required=False)
@click.option("--toml", is_flag=True, help="Print a complete file that --target accepts.")
def command(name: str | None, toml: bool) -> None:
    """List the chips that nscc knows, or show all about one (NAME or FILE.toml)."""
    if name is None and not toml:
        click.echo(listing())
        return
    target = load_target(name or "scamp5", Path())
    click.echo(target_toml(target) if toml else details(target), nl=not toml)


def listing() -> str:
    """One line a builtin target."""
    rows = [("name", "array", "digital", "analog", "")]
    for name in builtin_names():
        target = builtin_target(name)
        rows.append(
            (
                name,
                f"{target.rows} x {target.cols}",
                str(len(target.digital_registers)),
                str(len(target.analog_registers)),
                target.description,
            )
        )
    widths = [max(len(row[i]) for row in rows) for i in range(5)]
    lines = ["  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True))
             for row in rows]  # fmt: skip
    return "\n".join(line.rstrip() for line in lines)


def details(target: Target) -> str:
    """Every key of a target, by section, with what is not public about it."""
    lines = [f"{target.name}: {target.description}" if target.description else target.name]
    width = max(len(_value(target, key.attribute)) for key in KEYS if key.section)
    section = ""
    for key in KEYS:
        if not key.section:
            continue
        if key.section != section:
            section = key.section
            lines += ["", section]
        mark = "" if key.public else " (not public)"
        lines.append(
            f"  {key.key:<22} {_value(target, key.attribute):<{width}}  {key.comment}{mark}"
        )
    lines += [
        "",
        f"electrons a code of the readout: {target.electrons_per_lsb:.6g}",
        "(not public): this project's default; a file of your own may say otherwise "
        f"(`nscc targets {target.name} --toml`)",
    ]
    return "\n".join(lines)


def _value(target: Target, attribute: str) -> str:
    value = getattr(target, attribute)
    if value is None:
        return "any" if attribute.endswith("_sources") else "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, tuple):
        return _names(value)
    return f"{value:.10g}" if isinstance(value, float) else str(value)


def _names(names: tuple[str, ...]) -> str:
    """Register names, a run such as R0, R1, .. R12 shortened."""
    run = [name for i, name in enumerate(names) if name == f"R{i}"]
    if len(run) > 3 and names[: len(run)] == tuple(run):
        return " ".join((f"R0..{run[-1]}", *names[len(run) :]))
    return " ".join(names) or "none"
