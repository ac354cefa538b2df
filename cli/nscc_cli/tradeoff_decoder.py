"""`nscc tradeoff decoder`: measure PSNR and SSIM against decoding time on the same captures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.tradeoff.points import csv_text, table_text
from nscc.tradeoff.stopwatch import processor_name
from nscc_cli import options as shared
from nscc_cli.options import COUNT, PATH
from nscc_cli.support import CommonCommand, NumberRange, progress, say_compiling
from nscc_cli.tradeoff_files import kept_rows, output_files, write_files


@click.command("decoder", cls=CommonCommand)
@click.option("--run", "runs", multiple=True, type=PATH, metavar="RUN",
              help="A run folder of nscc train; may be repeated.")  # fmt: skip
@shared.made_scenes_option
@click.option("--scenes", type=COUNT, default=2, show_default=True,
              help="Number of scenes of each kind.")  # fmt: skip
@click.option("--size", type=click.IntRange(32, 512), default=128, show_default=True,
              help="Rows and columns of a scene.")  # fmt: skip
@shared.repeats_option(3)
@click.option("--budget", type=NumberRange(0, 1e6), default=40.0, show_default=True,
              metavar="S", help="Seconds after which no repeat starts; everything is measured at "
              "least once.")  # fmt: skip
@shared.made_seed_option
@shared.trust_code_option
@shared.tradeoff_options
def command(runs: tuple[Path, ...], trust_code: bool, **options: Any) -> int:
    """Measure PSNR and SSIM against decoding time per scene, in milliseconds.

    Decoders without training are measured at several numbers of iterations: GAP-TV, ADMM-TV and a
    dictionary; for stills merging neighbours and sparse coding. Networks come from run folders, in
    f32 and bf16, FC-net with 4, 2 and 1 blocks a pixel. All decode captures with the same code:
    that of the runs (runs with another code are compared separately), else random bits, and 2 x 2
    stops for stills."""
    from nscc_runtime.pictures.sheet import png_of
    from nscc_training.baselines.tv_loop import denoise
    from nscc_training.run_folder import load_run
    from nscc_training.tradeoff.decoder import DecoderStudySettings, cases, measure, not_measured
    from nscc_training.tradeoff.diagrams import TITLES, decoder_diagram

    files = output_files(options)
    named = ("data", "scenes", "size", "repeats", "budget", "seed")
    settings = DecoderStudySettings(*(options[name] for name in named))
    folders = [load_run(path, trust_code=trust_code) for path in dict.fromkeys(runs)]
    todo = cases(folders, settings)
    say_compiling(denoise, "the loop of total variation")
    with kept_rows(files, {**options, "runs": runs}) as rows:
        points, repeats = measure(todo, settings, lambda turns: progress(turns, "decoding"), rows)
        tables = (
            table_text([p for p in points if p.error_unit == unit], ("decoder", "setting", title))
            for unit, title in TITLES.items()
        )
        click.echo("\n\n".join(tables))
        for line in not_measured(folders):
            click.echo(line)
        device = processor_name()
        makers = {
            "csv": lambda: csv_text(points, device).encode(),
            "png": lambda: png_of(decoder_diagram, points, repeats, device),
        }
        write_files(files, makers, rows)
    return 0
