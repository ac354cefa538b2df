"""The error for a plan that is requested for a program to which plans do not apply."""

from __future__ import annotations

from nscc.diagnostics.rejection import rejected
from nscc.words.container import Container
from nscc_runtime.run_kinds import KINDS


def refuse_planless(container: Container, subject: str) -> None:
    """Raise NS0750 (status 2) if `subject` needs a plan, but plans do not apply to a program."""
    reason = KINDS.of(container).without_plan
    if reason:
        raise rejected(
            "NS0750",
            f"{subject} needs a plan, but plans do not apply to this program",
            notes=(f"{reason}, so every selected effect is simulated slot by slot",),
            helps=(f"leave {subject} out: the simulation makes no approximation",),
        )
