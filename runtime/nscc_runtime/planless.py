"""The error for a plan that is requested for a program to which plans do not apply."""

from __future__ import annotations

from nscc.diagnostics.diagnostic import rejected
from nscc.words.container import Container
from nscc_runtime.run_kinds import KINDS


def refuse_planless(container: Container, subject: str) -> None:
    """Raise Rejected (NS0750) if plans do not apply to the program of `container`. `subject`: what
    needs a plan (the effects that are simulated), such as an option or a function's name; the
    message begins with it."""
    reason = KINDS.of(container).without_plan
    if reason:
        raise rejected(
            "NS0750",
            f"{subject} needs a plan, but plans do not apply to this program",
            notes=(f"{reason}, so all selected effects are simulated",),
            helps=(f"leave {subject} out",),
        )
