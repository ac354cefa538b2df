"""`nscc prove`: replay a container's words against its own decode table."""

from __future__ import annotations

from pathlib import Path

import click

from nscc_cli.options import PATH
from nscc_cli.support import CommonCommand


@click.command("prove", cls=CommonCommand)
@click.argument("file", metavar="FILE.icw", type=PATH)
def command(file: Path) -> None:
    """Replay FILE's words over all its codes and two frames of random light.

    Proves that every code opens the shutter of the decode table, equation (7), and that each
    bucket gathers the light of its open slots and nothing else, equation (3). Of a chip without
    logic it follows the light of every pixel through the planes of bits.
    """
    from nscc.program.problems import counted
    from nscc.prove.file import prove_file

    container, proof = prove_file(file)
    pixels = f"{counted(proof.pixels, 'pixel')} x " if proof.pixels else ""
    click.echo(
        f"{file.as_posix()}: proved: {pixels}{counted(proof.codes, 'code')} x "
        f"{counted(proof.slots, 'slot')} x {counted(len(container.buckets), 'bucket')}, "
        f"{counted(proof.frames, 'frame')}"
    )
