"""`nscc classify`: name the class of a frame with a run's decoder."""

from __future__ import annotations

import json
from pathlib import Path

import click

from nscc_cli.completion import RUN
from nscc_cli.options import PATH, trust_code_option
from nscc_cli.support import CommonCommand, say


@click.command("classify", cls=CommonCommand)
@click.argument("run", type=RUN, metavar="RUN")
@click.argument("frame", metavar="FRAME.npz", type=PATH)
@click.option("--json", "as_json", is_flag=True, help="Print the likelihoods as JSON.")
@click.option("--dark", type=PATH, metavar="DARK.npz",
              help="A frame file of the same program without light, with many "
                   "repeats: it is subtracted from FRAME.")  # fmt: skip
@click.option("--force", is_flag=True,
              help="Only warn if the frame belongs to another program or sensor.")  # fmt: skip
@trust_code_option
def command(
    run: Path, frame: Path, as_json: bool, dark: Path | None, force: bool, trust_code: bool
) -> None:
    """Name the class of FRAME, which `nscc run` wrote, with the likelihood of each class.

    RUN is the folder of a run that was trained with classes ([data] protocol = "class-v1")."""
    from nscc_training.frame_reading import refuse_missing
    from nscc_training.reconstruct import classify

    refuse_missing(frame)
    classes, messages = classify(run, frame, force=force, dark=dark, trust_code=trust_code)
    say(messages)
    if as_json:
        click.echo(json.dumps(classes))
        return
    width = max(map(len, classes))
    for name, share in classes.items():
        click.echo(f"{name:{width}}  {share:6.1%}")
