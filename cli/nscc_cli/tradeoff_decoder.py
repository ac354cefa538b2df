"""`nscc tradeoff decoder`: PSNR and SSIM against milliseconds, on the same captures."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.tradeoff.device import processor_name
from nscc.tradeoff.points import Point, csv_text, table_text
from nscc_cli.support import CommonCommand, NumberRange, done, progress
from nscc_cli.tradeoff_files import output_files, output_options, write_files

if TYPE_CHECKING:
    pass


@click.command("decoder", cls=CommonCommand)
@click.option("--run", "runs", multiple=True, type=click.Path(path_type=Path), metavar="RUN",
              help="A run folder of nscc train; more than once for several.")  # fmt: skip
@click.option("--data", type=click.Path(path_type=Path), metavar="DIR",
              help="A folder of clips, panoramas or both, instead of made scenes.")  # fmt: skip
@click.option("--scenes", type=click.IntRange(1, 1000), default=2, show_default=True,
              help="How many scenes of a kind.")  # fmt: skip
@click.option("--size", type=click.IntRange(32, 512), default=128, show_default=True,
              help="Rows and columns of a scene.")  # fmt: skip
@click.option("--repeats", type=click.IntRange(1, 1000), default=3, show_default=True,
              help="How often everything is timed, in turn: the median counts.")  # fmt: skip
@click.option("--budget", type=NumberRange(0, 1e6), default=40.0, show_default=True,
              metavar="S", help="Seconds after which repeats end; the first is done in any "
              "case.")  # fmt: skip
@click.option("--seed", type=click.IntRange(0, 2**31 - 1), default=0,
              help="Of made scenes, random codes and noise.")  # fmt: skip
@output_options
def command(runs: tuple[Path, ...], out: Path | None, csv_path: Path | None, png_path: Path | None,
            **options: Any) -> int:  # fmt: skip
    """Measure what decoding time buys: PSNR and SSIM against milliseconds a scene.

    Decoders that need no training, by their iterations: GAP-TV, ADMM-TV, a dictionary; for stills
    neighbours merged and sparse coding. Networks come from run folders, in f32 and bf16, FC-net
    with 4, 2 and 1 blocks a pixel. All decode the captures of one code: that of the runs, those
    with other codes apart; without runs random bits, and 2 x 2 stops for stills.
    """
    from nscc_training.baselines.loops import denoise
    from nscc_training.run_folder import load_run
    from nscc_training.tradeoff.decoder import Settings, cases, measure, not_measured

    files = output_files(out, csv_path, png_path)
    settings = Settings(
        options["data"], options["scenes"], options["size"], options["repeats"],
        options["budget"], options["seed"],
    )  # fmt: skip
    folders = [load_run(path) for path in dict.fromkeys(runs)]
    todo = cases(folders, settings)
    if not denoise.is_compiled():
        done("compiling the loop of total variation for this processor: once, some seconds")
    points, repeats = measure(todo, settings, lambda turns: progress(turns, "decoding"))
    click.echo(_tables(points))
    for line in not_measured(folders):
        click.echo(line)
    device = processor_name()
    write_files(files, lambda: csv_text(points, device), lambda: _png(points, repeats, device))
    return 0


def _tables(points: Sequence[Point]) -> str:
    from nscc_training.tradeoff.diagrams import TITLES

    return "\n\n".join(
        table_text([p for p in points if p.error_unit == unit], ("decoder", "setting", title))
        for unit, title in TITLES.items()
    )


def _png(points: Sequence[Point], repeats: int, device: str) -> bytes:
    from nscc_runtime.pictures.sheet import png_of
    from nscc_training.tradeoff.diagrams import decoder_diagram

    return png_of(decoder_diagram, points, repeats, device)
