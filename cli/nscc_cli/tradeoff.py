"""`nscc tradeoff`: what more time buys, measured on this machine."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.lower.plan import LOWERINGS, Lowering
from nscc.pipeline import LEVELS
from nscc.tradeoff.device import processor_name
from nscc.tradeoff.points import Point, csv_text, table_text
from nscc.tradeoff.synthesis import (
    Count,
    builtin_cases,
    cases_of,
    every_way,
    measure,
    refusals_text,
)
from nscc_cli.support import CommonCommand, progress
from nscc_cli.tradeoff_decoder import command as decoder
from nscc_cli.tradeoff_emulator import command as emulator
from nscc_cli.tradeoff_files import output_files, output_options, some, write_files
from nscc_cli.tradeoff_sensor import command as sensor

_LEVELS = [str(level) for level in LEVELS]
_WORDS: dict[Count, str] = {"all": "words a frame", "logic": "logic words a frame"}


class _Tradeoffs(CommonCommand, click.Group):
    """The tradeoffs that there are; another name is rejected with their list."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The tradeoff named first in `args`, and what follows it."""
        name = args[0]
        if name in self.commands or name.startswith("-"):
            return super().resolve_command(ctx, args)
        known = ", ".join(self.commands)
        wrong = Diagnostic(
            "NS0781", f"nscc has no tradeoff '{name}'", helps=(f"there is: {known}",)
        )
        raise Rejected(wrong, status=2)


@click.group("tradeoff", cls=_Tradeoffs)
def command() -> None:
    """Measure what more time buys: a table, a CSV file, a diagram."""


for each in (emulator, sensor, decoder):
    command.add_command(each)


@command.command("synthesis", cls=CommonCommand)
@click.argument("files", nargs=-1, metavar="[FILE.nsl]...", type=click.Path(path_type=Path))
@output_options
@click.option(
    "--levels", callback=some(_LEVELS), metavar="0,1,..",
    default=",".join(_LEVELS), show_default=True, help="Levels of -O.",
)  # fmt: skip
@click.option(
    "--lowerings", callback=some(LOWERINGS), metavar="NAME,..", default=",".join(LOWERINGS),
    show_default=True, help="Lowerings.",
)  # fmt: skip
@click.option(
    "--repeats", type=click.IntRange(1, 1000), default=3, show_default=True,
    help="How often everything is compiled: the median counts.",
)  # fmt: skip
@click.option(
    "--count", type=click.Choice(["all", "logic"]), default="all", show_default=True,
    help="All words of a frame, or those that decode codes.",
)  # fmt: skip
def synthesis(
    files: tuple[Path, ...],
    out: Path | None,
    csv_path: Path | None,
    png_path: Path | None,
    levels: list[str],
    lowerings: list[Lowering],
    repeats: int,
    count: Count,
) -> int:
    """Measure what compile time buys: words a frame against time, at each level and lowering.

    Compiles FILEs, or else programs of all classes, from text to proof and without the cache. A
    point is dominated if another of the same program has neither more words nor more time. Ends
    with status 1 where nothing fits.
    """
    places = output_files(out, csv_path, png_path)
    cases = cases_of(files) or builtin_cases()
    ways = list(every_way(cases, lowerings, [int(level) for level in levels]))
    found = measure(ways, repeats, count, lambda turns: progress(turns, "compiling"))
    click.echo(table_text(found.points, ("lowering", "level", _WORDS[count])))
    for line in refusals_text(found.refused):
        click.echo(line)
    if not found.points:
        return 1
    points = found.points
    write_files(
        places,
        lambda: csv_text(points, processor_name()),
        lambda: _png(points, _WORDS[count], repeats),
    )
    return 0


def _png(points: Sequence[Point], words: str, repeats: int) -> bytes:
    from nscc_runtime.pictures.sheet import png_of
    from nscc_runtime.pictures.synthesis import synthesis_diagram

    return png_of(synthesis_diagram, points, words, repeats, processor_name())
