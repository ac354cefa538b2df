"""Construction of exceptions for single errors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.diagnostics.suggest import meant


def rejected(
    code: str,
    message: str,
    *,
    notes: Sequence[str] = (),
    helps: Sequence[str] = (),
    status: int = 2,
    **about: Any,
) -> Rejected:
    """Return the exception for a single error, for the caller to raise.

    `status` is the exit status of the command, by default 2 (wrong input). `about` contains further
    fields of `Diagnostic`."""
    diagnostic = Diagnostic(code, message, notes=tuple(notes), helps=tuple(helps), **about)
    return Rejected(diagnostic, status=status)


def unknown_name(code: str, message: str, name: str, known: Sequence[str], listed: str) -> Rejected:
    """Return the exception for a name that is not in `known`.

    `message` contains {} for the name. `listed` is the note with the known names, and contains {}
    for them. The help suggests the most similar name; without one, to name one of them. `code` is
    that of the error, and the exit status is 2."""
    return rejected(
        code,
        message.format(name[:60]),
        notes=(listed.format(", ".join(known)),),
        helps=meant(name, known, "name one of them"),
    )
