"""The message where a plan is wanted for a chip that is sent planes of bits."""

from __future__ import annotations

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected


def planless(subject: str) -> Rejected:
    """Return NS0750: `subject` needs a plan."""
    return rejected(
        "NS0750",
        f"{subject} needs a plan, and a chip that is sent planes of bits has none",
        notes=("light is sorted slot by slot, with every effect that is on",),
        helps=(f"leave {subject} out: nothing is approximated",),
    )
