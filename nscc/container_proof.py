"""The proof of a container file, and its shutters, found by replaying its words."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nscc.arrays import Array, Bools
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.pipeline import KINDS
from nscc.prove.proof import Proof, unproved_error
from nscc.words.container import Container, fields_at_pixels, packed_shutters
from nscc.words.legality import decoded


def require_known_shutters(container: Container, name: str = "this program") -> None:
    """Raise Rejected (NS0444, status 1) if the shutters of a program depend on the light; else do
    nothing.

    `name` is the program in the message."""
    if not KINDS.of(container).shutters_known:
        raise rejected(
            "NS0444",
            f"the shutters of {name} depend on the light: they are unknown before the exposure",
            notes=(
                "its pixels look at the light, and the answers decide when they open and close",
            ),
            helps=("`nscc run` writes how long each pixel was open: `open_slots`",),
            status=1,
        )


def replayed(container: Container, name: str = "this program") -> Bools:
    """Return the distinct shutters that the words open, bool (shutters, buckets, N), in the order
    of the decode table: sorted as rows of bits.

    Raises Rejected (status 1): NS0442 if the words do not implement shutters, NS0444 if the
    shutters depend on the light. `name` is the program in the message."""
    require_known_shutters(container, name)
    return KINDS.of(container).replayed(container, name)


def shutters_of_pixels(container: Container, name: str = "this program") -> dict[str, Array]:
    """Return the shutters and codes of all pixels as arrays, named as in a frame file.

    The names are `shutter`, uint8 (buckets, rows, cols, ceil(N / 8)) with the first slot in the
    lowest bit, and `shutter_shape`, which is (buckets, rows, cols, N). Further names are
    `codes_FIELD`, int64 (rows, cols), one for each field. A program with one code needs no pixel
    data. `name` is the program in messages. Raises Rejected: NS0441 (status 1) if pixels have no
    codes, NS0442 if the words do not implement shutters, NS0444 if these depend on the light."""
    pixels = container.pixel_codes
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

    `name` is the container (a compiled program) in messages. Raises Rejected for invalid words and,
    with status 1, NS0443 if it has no decode table, NS0440 if the proof fails, and NS0533 or NS0544
    if an image or plane cannot be proved."""
    kind, kernels = KINDS.of(container), decoded(container)
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
    proof = kind.prove(container, kernels)
    if proof.failure is not None and proof.failure.unproved is not None:
        raise Rejected(unproved_error(proof.failure))
    if proof.failure is not None:
        failure = proof.failure
        places = {"frame": failure.frame, "bucket": failure.bucket, "shutter": failure.shutter}
        place = ", ".join(f"{kind} {at}" for kind, at in places.items() if at is not None)
        raise rejected(
            "NS0440",
            f"the {kind.subject} of '{name}' do not match its decode table: {failure.reason} "
            f"({place})",
            notes=failure.doubts,
            helps=("build the program again; `nscc diff` shows which words changed",),
            data=places,
            status=1,
        )
    return proof
