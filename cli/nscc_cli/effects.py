"""`nscc effects`: describe the sensor model, and print a sensor file to start from."""

from __future__ import annotations

import json
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.chips.load import load_target
from nscc.columns import columns
from nscc_cli.completion import EFFECT
from nscc_cli.frames import sensor_of
from nscc_cli.options import PATH, flag, json_option, sensor_set_option, target_option
from nscc_cli.support import common_command

if TYPE_CHECKING:
    from nscc_runtime.sensor import Sensor

_WIDTH = 98


@common_command("effects")
@click.argument("name", required=False, type=EFFECT, metavar="[EFFECT]")
@json_option("Print every effect for programs.")
@flag("--toml", "Print a complete file that --sensor accepts.")
@flag("--cost", "Print the simulation times on this machine.")
@click.option(
    "--plan",
    type=PATH,
    metavar="FILE",
    help="Print the table of a plan, from a file of `nscc run --plan` or a frame file.",
)
@target_option("The chip whose values are the defaults.")
@click.option("--sensor", type=PATH, help="Show the values in this file, not the defaults.")
@sensor_set_option
def command(
    name: str | None,
    as_json: bool,
    toml: bool,
    cost: bool,
    plan: Path | None,
    target: str,
    **options: Any,
) -> None:
    """List the effects of the sensor model, or describe one (EFFECT)."""
    from nscc_runtime.effects import effects_json
    from nscc_runtime.sensor import sensor_toml

    # The number of outputs that are asked for.
    if as_json + toml + cost + (plan is not None) + (name is not None) > 1:
        raise click.UsageError(
            "EFFECT, --json, --toml, --cost and --plan print different things: use one of them"
        )
    if plan is not None:
        from nscc_runtime.planning.plan_file import stored_plan

        click.echo(stored_plan(plan))
        return
    sensor = sensor_of(load_target(target, Path()), options)
    if cost:
        click.echo(costs())
    elif toml:
        click.echo(sensor_toml(sensor), nl=False)
    elif as_json:
        click.echo(json.dumps({"effects": effects_json(sensor)}, indent=2))
    else:
        click.echo(listing() if name is None else details(name, sensor))


def listing() -> str:
    """Return a table with a line for each effect: its name, its kind, what its default values rest
    on, and its title. The kinds are explained below."""
    from nscc_runtime.effects import registered

    rows = [("effect", "kind", "defaults rest on", "")]
    for effect in registered():
        bases = sorted({row.basis for row in effect.parameters}) or ["no parameter"]
        rows.append((effect.name, effect.kind, ", ".join(bases), effect.title))
    return columns(rows, left_aligned=(0, 1, 2, 3)) + (
        "\n\nfixed: the same in every frame; random: new in every frame; after: in the readout\n"
        "chip frames: docs/silicon.md; `nscc effects NAME` names the source of each value\n"
        "`nscc effects NAME` shows one, --toml prints a sensor file"
    )


def costs() -> str:
    """Measure the simulation costs on this machine, which takes seconds. Return them as a table,
    text, beside the shipped costs that plans use."""
    from nscc_runtime.effects import registered
    from nscc_runtime.planning.measure_prices import measure_prices

    prices = measure_prices()
    rows = [("price", "shipped", "here", "unit", "of")]
    rows += [
        (e.name, f"{e.shipped:.4g}", f"{e.measured:.4g}", e.unit, e.description) for e in prices
    ]
    measured = {price.name for price in prices}
    rows += [
        (e.name, f"{e.cost_ns:.4g}", "", "ns", "a pixel that the effect changes")
        for e in registered()
        if e.cost_ns and e.name not in measured
    ]
    return columns(rows, left_aligned=(0, 3, 4)) + (
        "\n\ntimes of one core; plans use the prices in the column `shipped`, so that the same "
        "input gives the same bytes on every machine"
    )


def details(name: str, sensor: Sensor) -> str:
    """Return the description of the effect `name`, and of its parameters with their values in
    `sensor`. Raise Rejected (NS0756) if the effect is unknown."""
    from nscc_runtime.effects import named

    effect = named(name)
    lines = [f"{effect.name}: {effect.title} ({effect.kind})"]
    for heading in ("model", "size", "cost", "applied"):
        first, indent = f"  {heading:<11}", " " * 13
        text = getattr(effect, heading)
        lines += textwrap.wrap(text, _WIDTH, initial_indent=first, subsequent_indent=indent)
    for row in effect.parameters:
        value = f"{getattr(sensor, row.name):.10g} {row.kind.unit}"
        lines.append(f"  {row.name} = {value}, {row.kind.range}: {row.meaning} ({row.source})")
    return "\n".join(lines)
