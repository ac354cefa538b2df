"""What is said about frames that no calibration can be made of. All of it ends in status 2."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nscc.diagnostics.model import Diagnostic, Rejected

UNUSABLE, TOO_FEW, NOT_TRANSFER = "NS0757", "NS0758", "NS0759"
UNDETERMINED, NOT_A_LINE = "NS0791", "NS0792"


def rejected(
    code: str,
    message: str,
    *,
    notes: Sequence[str] = (),
    helps: Sequence[str] = (),
    data: dict[str, Any] | None = None,
) -> Rejected:
    """One error about the frames."""
    found = Diagnostic(code, message, notes=tuple(notes), helps=tuple(helps), data=data or {})
    return Rejected(found, status=2)
