"""Wrong input of the trainer as diagnostics: exit status 2 and a code of NS08xx."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nscc.diagnostics.model import Diagnostic, Rejected


def rejected(
    code: str,
    message: str,
    *,
    notes: Sequence[str] = (),
    helps: Sequence[str] = (),
    data: dict[str, Any] | None = None,
    status: int = 2,
) -> Rejected:
    """One error as the exception that ends the command."""
    diagnostic = Diagnostic(code, message, notes=tuple(notes), helps=tuple(helps), data=data or {})
    return Rejected(diagnostic, status=status)


def listed(names: Sequence[str], most: int = 12) -> str:
    """`a, b, c and 4 more`, or `nothing`."""
    shown = ", ".join(name[:40] for name in names[:most]) or "nothing"
    return shown + (f" and {len(names) - most} more" if len(names) > most else "")
