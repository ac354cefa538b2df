"""One error as an exception, in one call: what input that cannot be used ends in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected


def rejected(
    code: str,
    message: str,
    *,
    notes: Sequence[str] = (),
    helps: Sequence[str] = (),
    status: int = 2,
    **about: Any,
) -> Rejected:
    """The exception that ends the command with `status`; by default 2, wrong input.

    `about` are further members of `Diagnostic`.
    """
    diagnostic = Diagnostic(code, message, notes=tuple(notes), helps=tuple(helps), **about)
    return Rejected(diagnostic, status=status)
