"""The message where a plan is wanted for a chip that is sent planes of bits."""

from __future__ import annotations

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected


def planless(what: str) -> Rejected:
    """NS0750; `what` wants a plan."""
    return rejected(
        "NS0750",
        f"{what} needs a plan, and a chip that is sent planes of bits has none",
        notes=("light is sorted slot by slot, with every effect that is on",),
        helps=(f"leave {what} out: nothing is approximated",),
    )
