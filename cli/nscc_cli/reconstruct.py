"""`nscc reconstruct`: what a trained decoder makes of a frame."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.files import write_whole
from nscc_cli.options import OUT, PATH
from nscc_cli.support import CommonCommand, done, say


@click.command("reconstruct", cls=CommonCommand)
@click.argument("run", metavar="RUN", type=PATH)
@click.argument("frame", metavar="FRAME.npz", type=PATH)
@click.option("-o", "out", required=True, metavar="OUT.npz", type=OUT)
@click.option("--force", is_flag=True,
              help="Only warn if the frame is of another program or sensor.")  # fmt: skip
def command(run: Path, frame: Path, out: Path, force: bool) -> None:
    """Make a picture or a clip of FRAME, which `nscc run RUN/shutter.nsl` wrote.

    OUT holds `image` (rows, cols), electrons over the frame, or `video` (T, rows, cols), electrons
    a slot: the unit of the frame file's `truth_e`.
    """
    from nscc_training.reconstruct import reconstruct

    product, messages = reconstruct(run, frame, force=force)
    say(messages)
    write_whole(out, product)
    done(f"wrote {out.as_posix()}")
