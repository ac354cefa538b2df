"""The limit on shown errors of one text; users fix a few at a time and compile again."""

from __future__ import annotations

from nscc.diagnostics.message import Diagnostic
from nscc.source import Source

MOST_ERRORS = 20


def more_errors(count: int, source: Source) -> Diagnostic:
    """NS0190: the number of errors that are not shown."""
    errors = "error" if count == 1 else "errors"
    return Diagnostic("NS0190", f"and {count} more {errors} in the text", source=source)
