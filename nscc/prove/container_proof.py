"""The proof of a container file: its words match its decode table."""

from __future__ import annotations

from pathlib import Path

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.prove.proof import Proof, proof_too_large, prove, prove_stream
from nscc.words.container import Container
from nscc.words.file import read_container
from nscc.words.legality import decoded


def prove_file(path: Path) -> tuple[Container, Proof]:
    """Return the container in `path`, and the proof that its words match its decode table.

    Raises Rejected if the file cannot be read or has invalid words; with status 1, NS0443 if it has
    no decode table, and NS0440 if the proof fails."""
    container = read_container(path)
    kernels = decoded(container)
    if container.target.streamed:
        return container, _accepted_proof(path, prove_stream(container), "planes")
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
    return container, _accepted_proof(path, prove(container, kernels), "words")


def _accepted_proof(path: Path, proof: Proof, subject: str) -> Proof:
    """Return a successful proof; raise NS0440 for a failed one, and NS0544 if it is too large."""
    if proof.failure is not None and proof.failure.unproved is not None:
        raise Rejected(proof_too_large(proof.failure.unproved))
    if proof.failure is not None:
        failure = proof.failure
        places = {"frame": failure.frame, "bucket": failure.bucket, "shutter": failure.shutter}
        place = ", ".join(f"{kind} {at}" for kind, at in places.items() if at is not None)
        raise rejected(
            "NS0440",
            f"the {subject} of '{path.as_posix()}' do not match its decode table: "
            f"{failure.reason} ({place})",
            notes=failure.doubts,
            helps=("build the program again; `nscc diff` shows which words changed",),
            data=places,
            status=1,
        )
    return proof
