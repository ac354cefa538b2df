"""What nscc tells its user, and the exception that carries it."""

from __future__ import annotations

from collections.abc import Sequence

from nscc.diagnostics.message import Diagnostic, Fix, Label, Severity

__all__ = ["Diagnostic", "Fix", "Label", "Rejected", "Severity"]


class Rejected(Exception):
    """The user's input cannot be accepted: carries every diagnostic found and the exit status.

    Exit status 1: the program is rejected; 2: wrong usage or configuration; 3: device or
    emulator failure. At least one diagnostic is an error. As text it is all of them, as the command
    line shows them: with place, notes and help.
    """

    def __init__(self, diagnostics: Sequence[Diagnostic] | Diagnostic, status: int = 1) -> None:
        found = (diagnostics,) if isinstance(diagnostics, Diagnostic) else tuple(diagnostics)
        super().__init__(found, status)
        self.diagnostics = found
        self.status = status

    def __repr__(self) -> str:
        said = "; ".join(f"{each.code}: {each.message}" for each in self.diagnostics)
        return f"{type(self).__name__}({said!r})"

    def __str__(self) -> str:
        from nscc.diagnostics.render import render  # only where somebody reads it

        return render(self.diagnostics, "human").rstrip()
