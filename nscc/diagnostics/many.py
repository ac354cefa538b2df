"""Limit on the number of printed errors of one text, because users fix a few at a time."""

from __future__ import annotations

from nscc.diagnostics.message import Diagnostic
from nscc.source import Source

MOST_ERRORS = 20


def more_errors(count: int, source: Source) -> Diagnostic:
    """Return the message (NS0190) with the number of errors that are not printed."""
    errors = "error" if count == 1 else "errors"
    return Diagnostic("NS0190", f"and {count} more {errors} in the text", source=source)
