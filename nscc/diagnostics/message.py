"""The type of all errors, warnings and notes, and the application of their safe fixes.

The number of printed errors of one text is limited, because users fix a few at a time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any

from nscc.record import Record
from nscc.source import Source, Span

MOST_ERRORS = 20
"""Most errors shown for one file; a further message (NS0190) counts the others."""


def more_errors(count: int, source: Source) -> Diagnostic:
    """Return the diagnostic (NS0190) that tells how many further errors of a text are not printed.
    `count` is at least 1."""
    errors = "error" if count == 1 else "errors"
    return Diagnostic("NS0190", f"and {count} more {errors} in the text", source=source)


class Severity(StrEnum):
    """The severity of a diagnostic: an error rejects the program; warnings and notes do not."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"


class Label(Record):
    """A place (`span`) in a source text, with a short text that is printed beside its marks."""

    span: Span
    text: str = ""


class Fix(Record):
    """A change that resolves a diagnostic: replace `span` by `replacement`; "" removes it, and an
    empty span only inserts. `title` says so in words.

    A fix is `sure` (safe) if it cannot change the meaning that the author intended."""

    title: str
    span: Span
    replacement: str
    sure: bool = True


@dataclass(frozen=True)
class Diagnostic:
    """An error, warning or note.

    Parameters
    ----------
    code : str
        `NSxxxx`, the name of a page in `nscc/diagnostics/pages` (`nscc explain NSxxxx`).
    message : str
        One line that says what is wrong.
    severity : Severity
    source : Source, optional
        The text that the diagnostic is about.
    label : Label, optional
        The place in the text that the user can change.
    related : tuple of Label
        Further places, such as the origin of a limit.
    notes : tuple of str
        Facts, printed after `=`.
    helps : tuple of str
        Suggestions, printed after `help:`.
    ways_out : tuple of str
        Similar programs that were compiled and fit.
    fixes : tuple of Fix
        Changes of the text that would resolve the diagnostic.
    data : mapping
        JSON values for programs. For a resource error: `resource`, `required`, `available`,
        `proved`.
    """

    code: str
    message: str
    severity: Severity = Severity.ERROR
    source: Source | None = None
    label: Label | None = None
    related: tuple[Label, ...] = ()
    notes: tuple[str, ...] = ()
    helps: tuple[str, ...] = ()
    ways_out: tuple[str, ...] = ()
    fixes: tuple[Fix, ...] = ()
    data: Mapping[str, Any] = field(default_factory=dict)


def with_safe_fixes(source: Source, diagnostics: Iterable[Diagnostic]) -> tuple[Source, int]:
    """Apply the safe fixes of a text's diagnostics; return the new text and the number of fixes.

    Only the first safe fix of each diagnostic is used, and only diagnostics of this text count. Of
    overlapping fixes, the last in the text is applied."""
    fixes = []
    for diagnostic in diagnostics:
        sure = [fix for fix in diagnostic.fixes if fix.sure]
        if sure and diagnostic.source is not None and diagnostic.source.text == source.text:
            fixes.append(sure[0])
    text, count, changed_from = source.text, 0, len(source.text) + 1
    # From the end of the text, so that the places of the fixes before stay valid.
    for fix in sorted(fixes, key=lambda fix: fix.span.start, reverse=True):
        # The second condition leaves out a second insertion at the same place.
        if fix.span.end <= changed_from and fix.span.start < changed_from:
            text = text[: fix.span.start] + fix.replacement + text[fix.span.end :]
            changed_from = fix.span.start
            count += 1
    return replace(source, text=text), count
