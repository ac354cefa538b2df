"""`nscc reconstruct`: what a decoder makes of a frame."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import click

from nscc.files import write_whole
from nscc_cli.options import PATH, trust_code_option
from nscc_cli.support import CommonCommand, done, say


@click.command("reconstruct", cls=CommonCommand)
@click.argument("run", metavar="any|RUN")
@click.argument("frame", metavar="FRAME.npz", type=PATH)
@click.option("-o", "out", required=True, metavar="OUT.npz", type=PATH)
@click.option("--as", "kind", type=click.Choice(("image", "video")),
              help="With any: a picture or a clip. Default: a picture where all shutters open with "
              "the frame (class b), else a clip.")  # fmt: skip
@click.option("--program", type=PATH, metavar="FILE",
              help="With any: the program that exposed FRAME, where the file is an older one that "
              "does not hold its shutters.")  # fmt: skip
@click.option("--force", is_flag=True,
              help="With RUN: only warn if the frame is of another program or sensor.")  # fmt: skip
@trust_code_option
def command(
    run: str, frame: Path, out: Path, kind: Literal["image", "video"] | None,
    program: Path | None, force: bool, trust_code: bool,
) -> None:  # fmt: skip
    """Make a picture or a clip of FRAME, which `nscc run` wrote.

    `any` is the decoder for any code: it needs no training and takes frames of every program. RUN
    is a run folder of `nscc train`, whose decoder knows the shutters of RUN/shutter.nsl alone (a
    folder that is called any is ./any).

    OUT holds `image` (rows, cols), electrons over the frame, or `video` (T, rows, cols), electrons
    a slot: the unit of the frame file's `truth_e`.
    """
    if run != "any" and (kind or program):
        raise click.UsageError("--as and --program are for `nscc reconstruct any`: a run has both")
    if run == "any" and force:
        raise click.UsageError("--force is for runs: `any` takes frames of every program")
    from nscc_training.reconstruct import reconstruct, reconstruct_any

    if run == "any":
        product = reconstruct_any(frame, program, kind)
    else:
        product, messages = reconstruct(Path(run), frame, force=force, trust_code=trust_code)
        say(messages)
    write_whole(out, product)
    done(f"wrote {out.as_posix()}")
