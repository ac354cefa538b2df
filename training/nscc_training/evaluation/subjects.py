"""`nscc evaluate NAME --data DIR --protocol P`: who can be evaluated under which protocol."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from nscc_training.evaluation.hdr_baselines import BASELINES, evaluate_hdr_baseline
from nscc_training.problems import rejected
from nscc_training.protocols import load_protocol

_OF_PROTOCOL = {"hdr-v1": BASELINES}


def evaluate(
    subject: str, data: Path, protocol: str, seed: int
) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """The result of a baseline and the arrays it made, by name.

    Raises Rejected: NS0806 for the protocol, NS0810 for a subject that it does not know, NS0811
    for a folder without its data.
    """
    chosen = load_protocol(protocol)
    known = _OF_PROTOCOL.get(chosen.name, ())
    if subject in known:
        return evaluate_hdr_baseline(subject, data, seed)
    raise rejected(
        "NS0810",
        f"there is no '{subject[:60]}' to evaluate under protocol {chosen.name}",
        notes=(f"its baselines are {', '.join(known) or 'none yet'}",),
        helps=("`nscc evaluate sci8 CLIP.mat` evaluates clips of the benchmark",)
        if chosen.name == "sci8"
        else ("name one of them",),
    )
