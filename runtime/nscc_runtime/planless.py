"""The message where a plan is wanted for a chip that is sent planes of bits."""

from __future__ import annotations

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected


def planless(what: str) -> Rejected:
    """NS0750; `what` wants a plan."""
    return rejected(
        "NS0750",
        f"{what} needs a plan, but a chip that receives planes of bits does not use plans",
        notes=("such frames are simulated slot by slot, with every enabled effect",),
        helps=(f"leave {what} out: the simulation makes no approximation",),
    )
