"""`nscc sweep`: compute all combinations of settings, on one machine or several."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc_cli.options import OUT, PATH, declared, flag, settings_from
from nscc_cli.support import common_command, progress, say_done
from nscc_training.command_settings import SweepSettings

_KINDS = ("compile", "limits", "emulate", "train", "evaluate", "design")


def _print_part(context: click.Context, _option: click.Parameter, kind: str | None) -> None:
    """Print an example of a part of a grid, with points of this `kind`, and end the command. None
    does nothing."""
    if kind is not None and not context.resilient_parsing:
        from nscc_training.sweep.grid import part_text

        click.echo(part_text(kind), nl=False)
        context.exit()


@common_command("sweep")
@click.argument("grid", metavar="GRID.toml", type=PATH)
@click.option("--out", required=True, metavar="DIR", type=OUT, help="The folder of the results.")
@click.option(
    "--part",
    "grid_parts",
    multiple=True,
    metavar="PART",
    help="Compute only the points of this part of the grid, and the runs that they "
    "need; may be repeated.",
)
@declared(SweepSettings, show=True)
@flag("--dry-run", "Print the number of points and stop.")
@flag("--parquet", "Write the table as Parquet, too.")
@click.option(
    "--schema",
    type=click.Choice(_KINDS),
    is_eager=True,
    expose_value=False,
    callback=_print_part,
    metavar="KIND",
    help=f"Print a complete part of a kind ({', '.join(_KINDS)}), and exit.",
)
def command(
    grid: Path,
    out: Path,
    grid_parts: tuple[str, ...],
    dry_run: bool,
    parquet: bool,
    **options: Any,
) -> int:
    """Compute every point of a grid: compile programs, expose scenes, train and score runs.

    Lists in GRID.toml are axes. Each result row is stored in DIR, so that the same command resumes
    an interrupted sweep, and a changed grid computes only missing points. A point that does not fit
    the chip is a row with its error code. Exits with status 1 if a point failed or no point has
    results.

    \b
    nscc sweep --schema compile > grid.toml
    nscc sweep grid.toml --out results
    nscc sweep grid.toml --out results --scheduler tcp://10.0.0.1:8786"""
    from nscc_training.sweep.grid import of_parts, read_grid
    from nscc_training.sweep.run_sweep import (
        failures,
        known,
        summary_lines,
        sweep,
        work_text,
    )

    how = settings_from(SweepSettings, options)
    if how.scheduler is not None and how.workers is not None:
        raise click.UsageError(
            "--workers starts processes on this machine, but --scheduler has its own workers"
        )
    whole_grid = read_grid(grid)
    if dry_run:
        count, known_count = known(of_parts(whole_grid, grid_parts), out, how)
        click.echo(work_text(count, count - known_count))
        return 0
    swept = sweep(
        whole_grid,
        out,
        how,
        grid_parts=grid_parts,
        parquet=parquet,
        track=progress,
        report=say_done,
    )
    for line in summary_lines(swept):
        say_done(line)
    if swept.failed:
        # A sweep in which no program fits its chip has no results, which is a failure, too.
        raise failures(swept)
    return 1 if swept.misfits == len(swept.table) else 0
