"""The public names for diagnostics, the exception that carries them, and its construction."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nscc.diagnostics.message import Diagnostic, Fix, Label, Severity
from nscc.diagnostics.suggest import meant

__all__ = ["Diagnostic", "Fix", "Label", "Rejected", "Severity", "rejected", "unknown_name"]


class Rejected(Exception):
    """Raised for input that nscc cannot accept; its text is what the command line prints.

    Parameters
    ----------
    diagnostics : Diagnostic or sequence of Diagnostic
        All diagnostics; at least one is an error.
    status : int
        Exit status of the command line: 1 for an invalid program, 2 for wrong usage or
        configuration, 3 for a failure of device or emulator.
    """

    def __init__(self, diagnostics: Sequence[Diagnostic] | Diagnostic, status: int = 1) -> None:
        """Store one or more diagnostics, and the exit status of the command; see the class."""
        listed = (diagnostics,) if isinstance(diagnostics, Diagnostic) else tuple(diagnostics)
        super().__init__(listed, status)
        self.diagnostics = listed
        self.status = status

    def __repr__(self) -> str:
        """Return the class name with code and message of each diagnostic."""
        text = "; ".join(
            f"{diagnostic.code}: {diagnostic.message}" for diagnostic in self.diagnostics
        )
        return f"{type(self).__name__}({text!r})"

    def __str__(self) -> str:
        """Return the diagnostics as text for a person."""
        from nscc.diagnostics.render import render  # computed only for diagnostics that are shown

        return render(self.diagnostics, "human").rstrip()


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
    for them. The help suggests the most similar name. If no name is similar, the help is to use one
    of the known names. `code` is that of the error, and the exit status is 2."""
    return rejected(
        code,
        message.format(name[:60]),
        notes=(listed.format(", ".join(known)),),
        helps=meant(name, known, "name one of them"),
    )
