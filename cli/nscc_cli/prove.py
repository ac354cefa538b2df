"""`nscc prove`: replay a container's words against its own decode table."""

from __future__ import annotations

from pathlib import Path

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_cli.support import CommonCommand


@click.command("prove", cls=CommonCommand)
@click.argument("file", metavar="FILE.icw", type=click.Path(path_type=Path))
def command(file: Path) -> None:
    """Replay FILE's words over all its codes and two frames of random light.

    Proves that every code opens the shutter of the decode table, equation (7), and that each
    bucket gathers the light of its open slots and nothing else, equation (3).
    """
    from nscc.program.problems import counted
    from nscc.prove.proof import prove
    from nscc.words.file import read_container
    from nscc.words.legality import decoded

    container = read_container(file)
    kernels = decoded(container)
    if not container.has_table:
        raise Rejected(
            Diagnostic(
                "NS0443",
                f"'{file.as_posix()}' has no decode table: it says what its words are, but not "
                "which shutters they should open",
                helps=(
                    "`nscc shutters` finds what they open",
                    "`.shutter` and `.code` lines in the assembly text are a decode table",
                ),
            )
        )
    proof = prove(container, kernels)
    if proof.failure is not None:
        failure = proof.failure
        where = f", bucket {failure.bucket}" if failure.bucket is not None else ""
        if failure.shutter is not None:
            where += f", shutter {failure.shutter}"
        raise Rejected(
            Diagnostic(
                "NS0440",
                f"the words of '{file.as_posix()}' do not do what its decode table says: "
                f"{failure.what} (frame {failure.frame}{where})",
                notes=failure.doubts,
                helps=("build the program again; `nscc diff` shows which words changed",),
                data={"frame": failure.frame, "bucket": failure.bucket, "shutter": failure.shutter},
            )
        )
    click.echo(
        f"{file.as_posix()}: proved: {counted(proof.codes, 'code')} x "
        f"{counted(proof.slots, 'slot')} x {counted(len(container.buckets), 'bucket')}, "
        f"{counted(proof.frames, 'frame')}"
    )
