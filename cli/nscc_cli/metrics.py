"""`nscc metrics`: measure the difference between a reconstruction and the ground truth."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import click

from nscc.files import write_whole
from nscc_cli.options import OUT, PATH
from nscc_cli.support import CommonCommand, NumberRange


@click.command("metrics", cls=CommonCommand)
@click.argument("truth", type=PATH)
@click.argument("result", metavar="REC", type=PATH)
@click.option("--data-range", type=float, required=True, metavar="R",
              help="The peak value that errors are compared with: 255 for 8-bit "
                   "values, 1 for values on [0, 1].")  # fmt: skip
@click.option("--truth-key", help="The array of TRUTH, if it contains several.")
@click.option("--rec-key", "result_key", help="The array of REC, if it contains several.")
@click.option("--nits", type=NumberRange(0.005, 10000.0, min_open=True), default=1000.0,
              show_default=True,
              help="The luminance in cd/m2 that the data range R represents, for "
                   "PU21-PSNR.")  # fmt: skip
@click.option("--json", "as_json", is_flag=True, help="Print JSON, with every frame of a clip.")
@click.option("-o", "out", type=OUT, help="Write the JSON to a file.")
def command(as_json: bool, out: Path | None, **pair: Any) -> None:
    """Compare REC with TRUTH: pictures (rows, cols) or clips (T, rows, cols).

    Prints PSNR, SSIM, mu-law PSNR (mu = 5000), PU21-PSNR and, for clips, the temporal error.
    Values are compared as stored; mu-law and PU21 clip them to 0..R."""
    from nscc_training.measures import measure_files, measures_text

    scores = measure_files(**pair)
    text = json.dumps(scores, indent=2, allow_nan=False) + "\n"
    if out is not None:
        write_whole(out, text.encode())
    click.echo(text if as_json else measures_text(scores), nl=False)
