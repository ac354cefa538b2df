"""`nscc tradeoff`: measure error against time on this machine."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from nscc.files import Product
from nscc.lower.exposure_plan import LOWERINGS, Lowering
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
from nscc_cli.options import COUNT, PATH, some_option, tradeoff_options
from nscc_cli.support import CommonCommand, Subcommands, progress
from nscc_cli.tradeoff_decoder import command as decoder
from nscc_cli.tradeoff_emulator import command as emulator
from nscc_cli.tradeoff_files import kept_rows, output_files, write_files
from nscc_cli.tradeoff_joint import command as joint
from nscc_cli.tradeoff_sensor import command as sensor

_LEVELS = [str(level) for level in LEVELS]
_WORDS: dict[Count, str] = {"all": "words a frame", "logic": "logic words a frame"}


class _Tradeoffs(Subcommands):
    """The subcommands of `nscc tradeoff`; other names are programs or runs."""

    unknown = "tradeoff '{}': there is no such command, file or run"

    def or_else(self) -> Sequence[str]:
        from nscc_training.run_files import shipped_runs

        return (
            f"or name a program (FILE.nsl, FILE.icw) or a run: RUN, {', '.join(shipped_runs())}",
        )

    def resolve_unknown(
        self, name: str, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Pass the name of a program or run to `nscc tradeoff of`; reject other names (NS0781)."""
        if _may_be_program(Path(name)):
            return "of", self.commands["of"], args
        return super().resolve_unknown(name, args)


def _may_be_program(path: Path) -> bool:
    from nscc_training.run_files import shipped_runs

    return path.suffix.lower() in (".nsl", ".icw") or path.exists() or str(path) in shipped_runs()


@click.group("tradeoff", cls=_Tradeoffs)
def command() -> None:
    """Measure what more computing time improves: a table, a CSV file, a diagram.

    `nscc tradeoff PROGRAM|RUN --scene S --target-error 1%` is short for `nscc tradeoff of PROGRAM
    ..`. It finds the setting of every stage for that error."""


for subcommand in (joint, emulator, sensor, decoder):
    command.add_command(subcommand)


@command.command("synthesis", cls=CommonCommand)
@click.argument("files", nargs=-1, metavar="[FILE.nsl]...", type=PATH)
@tradeoff_options
@some_option("--levels", _LEVELS, "0,1,..", "Levels of -O.")
@some_option("--lowerings", LOWERINGS, "NAME,..", "Lowerings.")
@click.option("--repeats", type=COUNT, default=3, show_default=True,
              help="How often each setting is compiled; the median is used.")  # fmt: skip
@click.option("--count", type=click.Choice(["all", "logic"]), default="all", show_default=True,
              help="All words of a frame, or only those that decode codes.")  # fmt: skip
def synthesis(
    files: tuple[Path, ...], levels: tuple[str, ...], lowerings: tuple[Lowering, ...], repeats: int,
    count: Count, **places: Any,
) -> int:  # fmt: skip
    """Measure the words per frame against compile time, at each level and lowering.

    Compiles FILEs, or else programs of all classes, from text to proof and without the cache. A
    point is dominated if another point of the same program has no more words and no more time.
    Exits with status 1 if no program fits."""
    outputs = output_files(places)
    cases = cases_of(files) or builtin_cases()
    ways = list(every_way(cases, lowerings, [int(level) for level in levels]))
    with kept_rows(outputs, {"files": files, "count": count}) as rows:
        measured = measure(ways, repeats, count, lambda turns: progress(turns, "compiling"), rows)
        points, device = measured.points, processor_name()
        click.echo(table_text(points, ("lowering", "level", _WORDS[count])))
        for line in refusals_text(measured.refused):
            click.echo(line)
        if not points:
            rows.remove()
            return 1
        makers = {
            "csv": lambda: csv_text(points, device).encode(),
            "png": lambda: _png(points, _WORDS[count], repeats, device),
        }
        write_files(outputs, makers, rows)
    return 0


@command.command("images", cls=CommonCommand)
@click.argument("file", metavar="FILE.nsl", type=PATH)
@click.option("-O", "level", type=click.Choice(_LEVELS), default="2", show_default=True,
              help="Level of optimisation of the search.")  # fmt: skip
@tradeoff_options
def images(file: Path, level: str, **places: Any) -> int:
    """Compare programs of words for the kernels of a program's images: noise against time.

    Noise is the standard deviation of the error that a kernel's words add, relative to one word.
    Among programs that fit the registers' range, the compiler takes the one with the fewest words.
    Exits with status 1 if no image has a kernel."""
    from nscc.tradeoff.images import image_points

    outputs = output_files(places)
    points = image_points(file, int(level))
    click.echo(table_text(points, ("kernel", "program", "noise"), ("us", 1000.0)))
    if points:
        with kept_rows(outputs, {}) as rows:
            makers = {
                "csv": lambda: csv_text(points, "the chip's table").encode(),
                "png": lambda: _images_png(points),
            }
            write_files(outputs, makers, rows)
    return 0 if points else 1


def _images_png(points: Sequence[Point]) -> Product:
    from nscc_runtime.pictures.precision import images_diagram
    from nscc_runtime.pictures.sheet import png_of

    return png_of(images_diagram, points)


def _png(points: Sequence[Point], words: str, repeats: int, device: str) -> Product:
    from nscc_runtime.pictures.precision import synthesis_diagram
    from nscc_runtime.pictures.sheet import png_of

    return png_of(synthesis_diagram, points, words, repeats, device)
