"""The error if a plan is requested for a chip that receives planes of bits."""

from __future__ import annotations

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected


def planless(subject: str) -> Rejected:
    """Return the error NS0750: `subject` needs a plan."""
    return rejected(
        "NS0750",
        f"{subject} needs a plan, but a chip that receives planes of bits does not use plans",
        notes=("such frames are simulated slot by slot, with every enabled effect",),
        helps=(f"leave {subject} out: the simulation makes no approximation",),
    )
