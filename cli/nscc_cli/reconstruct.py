"""`nscc reconstruct`: what a trained decoder makes of a frame."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.files import write_whole
from nscc_cli.options import PATH, trust_code_option
from nscc_cli.support import CommonCommand, done, say


@click.command("reconstruct", cls=CommonCommand)
@click.argument("run", metavar="[RUN]", type=PATH)
@click.argument("frame", metavar="FRAME.npz", type=PATH, required=False)
@click.option("-o", "out", required=True, metavar="OUT.npz", type=PATH)
@click.option("--force", is_flag=True,
              help="Only warn if the frame is of another program or sensor.")  # fmt: skip
@trust_code_option
def command(run: Path, frame: Path | None, out: Path, force: bool, trust_code: bool) -> None:
    """Make a picture or a clip of FRAME, which `nscc run RUN/shutter.nsl` wrote.

    A frame whose pixels looked at the light needs no RUN: it says itself how long each was open.

    OUT holds `image` (rows, cols), electrons over the frame, or `video` (T, rows, cols), electrons
    a slot: the unit of the frame file's `truth_e`.
    """
    if frame is None:
        from nscc_runtime.looked_light import image_of

        write_whole(out, image_of(run))
        done(f"wrote {out.as_posix()}")
        return
    from nscc_training.reconstruct import reconstruct

    product, messages = reconstruct(run, frame, force=force, trust_code=trust_code)
    say(messages)
    write_whole(out, product)
    done(f"wrote {out.as_posix()}")
