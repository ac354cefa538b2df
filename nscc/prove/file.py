"""The proof of a file: words that came from anywhere, against their own decode table."""

from __future__ import annotations

from pathlib import Path

from nscc.diagnostics.rejection import rejected
from nscc.prove.proof import Failure, Proof, prove
from nscc.prove.stream import prove_stream
from nscc.words.container import Container
from nscc.words.file import read_container
from nscc.words.legality import decoded


def prove_file(path: Path) -> tuple[Container, Proof]:
    """The container in `path` and the proof that its words open what its decode table says.

    Raises Rejected where it cannot be read or holds words that are none; with status 1, NS0443
    where it has no decode table, and NS0440 where the proof fails.
    """
    container = read_container(path)
    kernels = decoded(container)
    if container.target.streamed:
        return container, _held(path, prove_stream(container), "planes")
    if not container.has_table:
        raise rejected(
            "NS0443",
            f"'{path.as_posix()}' has no decode table, so there are no shutters to compare "
            "its words with",
            helps=(
                "`nscc shutters` prints the shutters that the words implement",
                "add a decode table to the assembly text: `.shutter` and `.code` lines",
            ),
            status=1,
        )
    return container, _held(path, prove(container, kernels), "words")


def _held(path: Path, proof: Proof, what: str) -> Proof:
    """A proof that holds; NS0440 where it does not."""
    if proof.failure is not None:
        raise rejected(
            "NS0440",
            f"the {what} of '{path.as_posix()}' do not match its decode table: "
            f"{proof.failure.what} ({_where(proof.failure)})",
            notes=proof.failure.doubts,
            helps=("build the program again; `nscc diff` shows which words changed",),
            data={
                "frame": proof.failure.frame,
                "bucket": proof.failure.bucket,
                "shutter": proof.failure.shutter,
            },
            status=1,
        )
    return proof


def _where(failure: Failure) -> str:
    places = {"frame": failure.frame, "bucket": failure.bucket, "shutter": failure.shutter}
    return ", ".join(f"{kind} {which}" for kind, which in places.items() if which is not None)
