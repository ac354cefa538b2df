"""The public names for diagnostics, and the exception that carries them."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.diagnostics.message import Diagnostic, Fix, Label, Severity

__all__ = ["Diagnostic", "Fix", "Label", "Rejected", "Severity"]


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
