"""The proof of a container file, and its shutters, found by replaying its words."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.prove.proof import Proof, prove, prove_stream, shutters, unproved_error
from nscc.words.container import Container, fields_at_pixels, packed_shutters
from nscc.words.legality import decoded


def refuse_looking(container: Container, name: str = "this program") -> None:
    """Raise Rejected (NS0444, status 1) for programs whose shutters depend on the light."""
    if container.machine.stages:
        raise rejected(
            "NS0444",
            f"the shutters of {name} depend on the light: they are unknown before the exposure",
            notes=(
                "its pixels look at the light, and the answers decide when they open and close",
            ),
            helps=("`nscc run` writes how long each pixel was open: `open_slots`",),
            status=1,
        )


def replayed(container: Container, name: str = "this program") -> NDArray[np.bool_]:
    """Return the distinct shutters bool (shutters, buckets, N) that the words open.

    Raises Rejected (NS0442, status 1) if a slot's weight is neither 0 nor 1; the message calls the
    container `name`."""
    if container.target.streamed:
        failure = prove_stream(container).failure
        if failure is None:
            return container.table.shutters
        raise rejected(
            "NS0442",
            f"the planes of {name} do not match its decode table: {failure.reason}",
            helps=("build the program again",),
            status=1,
        )
    refuse_looking(container, name)
    opened = shutters(container, decoded(container))
    if opened is None:
        raise rejected(
            "NS0442",
            f"the words of {name} do not implement shutters: the light of some slot has a "
            "weight other than 0 or 1",
            helps=("`nscc prove` shows the error in the words",),
            status=1,
        )
    return opened


def shutters_of_pixels(container: Container, name: str = "this program") -> dict[str, NDArray[Any]]:
    """Return the shutters and codes of all pixels, named as in a frame file.

    The names are `shutter`, `shutter_shape` and `codes_FIELD`. A program with one code needs no
    pixel data. Raises Rejected: NS0441 (status 1) if pixels have no codes, NS0442 as for
    `replayed`."""
    pixels, sent = container.pixel_codes, container.stream
    if sent is not None:
        opened = sent.shutters(len(container.buckets), container.target.cols)
        size = np.array((*opened.shape[:3], container.slots), np.int64)
        return {"shutter": opened, "shutter_shape": size, **fields_at_pixels(container)}
    if pixels is None and len(container.table.codes) == 1:
        target = container.target
        pixels = np.zeros((target.rows, target.cols), dtype=np.int32)
    if pixels is None:
        raise rejected(
            "NS0441",
            f"{name} has no pixel data, so the shutters of its pixels are unknown",
            helps=("add a `pixels` statement to the program",),
            status=1,
        )
    laid = replace(container, pixel_codes=pixels)
    shutter, shape = packed_shutters(laid, replayed(container, name))
    return {"shutter": shutter, "shutter_shape": shape, **fields_at_pixels(laid)}


def prove_container(container: Container, name: str) -> Proof:
    """Return the proof that a container's words match its decode table.

    Messages call the container `name`. Raises Rejected if it has invalid words; with status 1,
    NS0443 if it has no decode table, and NS0440 if the proof fails."""
    kernels = decoded(container)
    if container.target.streamed:
        return _accepted_proof(name, prove_stream(container), "planes")
    if not container.has_table:
        raise rejected(
            "NS0443",
            f"'{name}' has no decode table, so there are no shutters to compare its words with",
            helps=(
                "`nscc shutters` prints the shutters that the words implement",
                "add a decode table to the assembly text: `.shutter` and `.code` lines",
            ),
            status=1,
        )
    return _accepted_proof(name, prove(container, kernels), "words")


def _accepted_proof(name: str, proof: Proof, subject: str) -> Proof:
    """Return a successful proof; raise NS0440 for a failed one, and that of `unproved_error`."""
    if proof.failure is not None and proof.failure.unproved is not None:
        raise Rejected(unproved_error(proof.failure))
    if proof.failure is not None:
        failure = proof.failure
        places = {"frame": failure.frame, "bucket": failure.bucket, "shutter": failure.shutter}
        place = ", ".join(f"{kind} {at}" for kind, at in places.items() if at is not None)
        raise rejected(
            "NS0440",
            f"the {subject} of '{name}' do not match its decode table: {failure.reason} ({place})",
            notes=failure.doubts,
            helps=("build the program again; `nscc diff` shows which words changed",),
            data=places,
            status=1,
        )
    return proof
