"""One error as an exception, in one call: what input that cannot be used ends in."""

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
    """The exception that ends the command with `status`; by default 2, wrong input.

    `about` are further members of `Diagnostic`.
    """
    diagnostic = Diagnostic(code, message, notes=tuple(notes), helps=tuple(helps), **about)
    return Rejected(diagnostic, status=status)


def unknown_name(code: str, message: str, name: str, known: Sequence[str], listed: str) -> Rejected:
    """The exception for a name that is none of `known`, which the note lists.

    `message` holds {} in place of the name, `listed` in place of the known names.
    """
    return rejected(
        code,
        message.format(name[:60]),
        notes=(listed.format(", ".join(known)),),
        helps=meant(name, known, "name one of them"),
    )
