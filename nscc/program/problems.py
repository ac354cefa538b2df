"""Collection of diagnostics about a program, without duplicates."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partialmethod
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Fix, Label, Rejected, Severity
from nscc.diagnostics.message import MOST_ERRORS, more_errors
from nscc.diagnostics.suggest import closest, did_you_mean
from nscc.source import Source, Span

_MOST_SUGGESTIONS = 20
"""Most unknown names for which a similar name is searched."""


class Problems:
    """Collects the errors, warnings and notes about one source text."""

    def __init__(self, source: Source) -> None:
        """Begin without diagnostics; `source` is the text that their places refer to."""
        self.source = source
        self._found: list[Diagnostic] = []
        self._unknown: set[str] = set()

    def add(
        self,
        severity: Severity,
        code: str,
        message: str,
        span: Span,
        text: str = "",
        **members: Any,
    ) -> None:
        """Add a diagnostic at `span`, beside whose marks `text` is printed. `code` is that of the
        message, such as "NS0214".

        `members` are further fields of `Diagnostic`, such as `helps`."""
        label = Label(span, text)
        self._found.append(Diagnostic(code, message, severity, self.source, label, **members))

    error = partialmethod(add, Severity.ERROR)
    warning = partialmethod(add, Severity.WARNING)
    note = partialmethod(add, Severity.NOTE)

    def unknown(self, kind: str, name: str, span: Span, known: Iterable[str]) -> None:
        """Add the error (NS0214) for an unknown name, with the most similar of the names `known`.

        `kind` says what was expected, with an article, such as "a field". Each name is reported
        once. Only the first `_MOST_SUGGESTIONS` get a help with a suggestion, because the search is
        slow."""
        if name in self._unknown:
            return
        self._unknown.add(name)
        is_helped = len(self._unknown) <= _MOST_SUGGESTIONS
        candidates = sorted(set(known)) if is_helped else []
        nearest = closest(name, candidates)
        shown = ", ".join(f"`{c}`" for c in candidates[:12])
        help_text = (
            did_you_mean(nearest)
            if nearest
            else f"names that can be used here: {shown}"
            if shown
            else f"the program declares no name of {kind}"
        )
        helps = (help_text,) if is_helped else ()
        fixes = (Fix(f"write `{nearest}`", span, nearest, sure=False),) if nearest else ()
        message = f"`{clipped(name)}` is not the name of {kind}"
        self.error("NS0214", message, span, "not known", helps=helps, fixes=fixes)

    def adopt(self, rejected: Rejected, span: Span) -> None:
        """Add the diagnostics of `rejected`, an exception such as one from reading a file.

        Those without a source (their text) get the program's text and the place `span`."""
        for diagnostic in rejected.diagnostics:
            if diagnostic.source is None:
                diagnostic = replace(diagnostic, source=self.source, label=Label(span))
            self._found.append(diagnostic)

    def has_errors(self) -> bool:
        """Return whether an error was added."""
        return any(d.severity is Severity.ERROR for d in self._found)

    def sorted(self) -> tuple[Diagnostic, ...]:
        """Return all diagnostics in the order of the text.

        Errors beyond MOST_ERRORS are replaced by one message with their number (NS0190)."""
        errors = 0
        shown: list[Diagnostic] = []
        for diagnostic in sorted(self._found, key=_place):
            errors += diagnostic.severity is Severity.ERROR
            if diagnostic.severity is not Severity.ERROR or errors <= MOST_ERRORS:
                shown.append(diagnostic)
        if errors > MOST_ERRORS:
            shown.append(more_errors(errors - MOST_ERRORS, self.source))
        return tuple(shown)

    def stop_on_errors(self) -> None:
        """Raise Rejected with all diagnostics if there is an error."""
        if self.has_errors():
            raise Rejected(self.sorted())


def _place(diagnostic: Diagnostic) -> tuple[int, int]:
    """Return the key that sorts diagnostics: start and end of their place, (-1, -1)
    without one."""
    if diagnostic.label is None:
        return (-1, -1)
    return (diagnostic.label.span.start, diagnostic.label.span.end)


def clipped(text: object, most: int = 60) -> str:
    """Return a value as text of at most `most` characters (at least 7), shortened in the middle by
    ` ... `."""
    shown = printable(text)
    if len(shown) <= most:
        return shown
    half = (most - 5) // 2  # ` ... ` between the halves has 5 characters
    return f"{shown[:half]} ... {shown[-half:]}"


def printable(text: object) -> str:
    """Return a value as text; of an integer of more than 256 bits only its sign and number of
    bits."""
    # Nobody reads so many digits, and Python refuses to write more than 4300.
    if isinstance(text, int) and not isinstance(text, bool) and text.bit_length() > 256:
        sign = "negative " if text < 0 else ""
        return f"a {sign}number of {text.bit_length()} bits"
    return str(text)


def counted(number: int, noun: str, plural: str | None = None) -> str:
    """Return a number with its noun: `1 slot`, `2 slots`. Without `plural`, the plural is the noun
    with an s."""
    return f"{number} {noun if number == 1 else plural or noun + 's'}"
