"""`nscc targets`: list the known chips, and describe one."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import click

from nscc.chips.load import DEFAULT_NAME, load_target, target_names, target_toml
from nscc.chips.target import Target, schema_of
from nscc.columns import columns
from nscc.options import Options
from nscc.toml.schema import Key
from nscc_cli.completion import TARGET
from nscc_cli.options import declared, flag, json_option
from nscc_cli.support import common_command, progress

DEFAULT_SLOTS = ("1ms", "10us")
"""Slot lengths for which limits are computed: one that fits any words, and one that does not."""

_TIME = re.compile(r"[0-9]{1,9}(\.[0-9]{1,6})?(ns|us|ms|s)")


def _checked_times(
    _context: click.Context, _option: click.Parameter, values: tuple[str, ...]
) -> tuple[str, ...]:
    """Return the times in `values` (such as 10us) without duplicates, in their order. Raise
    BadParameter for an invalid or zero time."""
    for value in values:
        if not _TIME.fullmatch(value):
            raise click.BadParameter(f"invalid time '{value}': write 10us, 1.5ms, 800ns or 2s")
        if not float(value.rstrip("nums")):
            raise click.BadParameter("a slot must be longer than 0")
    return tuple(dict.fromkeys(values))


@common_command("targets")
@click.argument("name", required=False, type=TARGET, metavar="[NAME|FILE.toml|FILE.nsl]")
@flag("--toml", "Print a complete file that --target accepts.")
@flag("--limits", "Compile every class at growing sizes: what fits, what cannot, what is unknown.")
@click.option(
    "--compare",
    "compared",
    nargs=2,
    type=TARGET,
    metavar="A B",
    help="Compile the program NAME for two chips: what fits, shortest slot, data rate, "
    "expected noise.",
)
@json_option("Print limits or comparison for programs.")
@click.option(
    "--slot",
    "slots",
    multiple=True,
    metavar="TIME",
    callback=_checked_times,
    help="Length of the slots that limits are found for; may be repeated (default: 1ms and 10us).",
)
@declared(Options, level=1)
def command(
    name: str | None,
    toml: bool,
    limits: bool,
    compared: tuple[str, str] | None,
    as_json: bool,
    slots: tuple[str, ...],
    level: int,
) -> None:
    """List the known chips, or describe one (NAME or FILE.toml)."""
    if compared is not None:
        if name is None or toml or limits or slots:
            raise click.UsageError("--compare A B needs a program: FILE.nsl")
        from nscc.compare import compare, compared_json, compared_text
        from nscc_runtime.response import expected_noise

        targets = [load_target(chip, Path()) for chip in compared]
        comparison = compare(Path(name), targets, level, expected_noise)
        as_text = json.dumps(compared_json(comparison), indent=2) if as_json else None
        click.echo(as_text or compared_text(comparison))
        return
    if limits and toml:
        raise click.UsageError("--limits and --toml print different things: use only one of them")
    if not limits and (as_json or slots):
        goes = "--json needs --limits or --compare" if as_json else "--slot needs --limits"
        raise click.UsageError(goes)
    if name is None and not toml and not limits:
        click.echo(listing())
        return
    target = load_target(name or DEFAULT_NAME, Path())
    if limits:
        click.echo(_limits(target, level, slots or DEFAULT_SLOTS, as_json=as_json))
    else:
        click.echo(target_toml(target) if toml else details(target), nl=not toml)


def _limits(target: Target, level: int, slots: tuple[str, ...], *, as_json: bool) -> str:
    """Return the limits of `target` for each length of a slot in `slots`, as text, or as JSON
    (`as_json`). Programs are compiled at this `level` to find them."""
    from nscc.limits.survey import Limit, limits_json, limits_text, survey

    limits: list[Limit] = []

    def trials() -> Iterator[object]:
        """Yield each size that is compiled, for the progress bar. The limits that were found are
        added to `limits` at the end."""
        limits.extend((yield from survey(target, Options(level=level), slots)))

    for _ in progress(trials(), "compiling programs"):
        pass
    if as_json:
        return json.dumps(limits_json(target, level, limits), indent=2)
    return limits_text(target, level, limits)


def listing() -> str:
    """Return a table, as text, with a line for each target of nscc and of installed packages: name,
    size of the array, numbers of registers, description."""
    rows: list[tuple[str, ...]] = [("name", "array", "digital", "analog", "")]
    for name in target_names():
        chip = load_target(name, Path())
        digital, taps = len(chip.digital_registers), len(chip.taps)
        holds = str(digital or "none"), f"{taps} taps" if taps else str(len(chip.analog_registers))
        rows.append((name, f"{chip.rows} x {chip.cols}", *holds, chip.description))
    return columns(rows)


def details(target: Target) -> str:
    """Return the values of all keys of a target with their meaning, by section. Keys without a
    section, such as the name, stand only in the first line. Values that are not published are
    marked."""
    lines = [f"{target.name}: {target.description}" if target.description else target.name]
    rows = [(key, _value(target, key)) for key in schema_of(target.kind).keys if key.section]
    width = max(len(value) for _, value in rows)
    section = ""
    for key, value in rows:
        if key.section != section:
            section = key.section
            lines += ["", section]
        mark = f" ({key.source})" if key.source else ""
        lines.append(f"  {key.name:<22} {value:<{width}}  {key.meaning}{mark}")
    if target.words:
        lines += ["", "words of its own", *(f"  {word.name}" for word in target.words)]
    lines += [
        "",
        f"electrons a code of the readout: {target.electrons_per_lsb:.6g}",
        "(not public): this project's default; a file of your own may say otherwise "
        f"(`nscc targets {target.name} --toml`)",
    ]
    return "\n".join(lines)


def _value(target: Target, key: Key) -> str:
    """Return the value of a target's key as text. Registers R0, R1, .. are shortened to `R0..R12`
    if there are more than three. No value is "none" or the file's word for it."""
    value = getattr(target, key.attribute)
    if value is None:
        return str(key.kind.plain(value))
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, tuple):
        names = tuple(map(str, value))
        run = [name for i, name in enumerate(names) if name == f"R{i}"]
        if len(run) > 3 and names[: len(run)] == tuple(run):
            return " ".join((f"R0..{run[-1]}", *names[len(run) :]))
        return " ".join(names) or "none"
    return f"{value:.10g}" if isinstance(value, float) else str(value)
