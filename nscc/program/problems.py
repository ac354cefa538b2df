"""The collector of what is wrong with a program: everything is reported, and reported once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partialmethod
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Fix, Label, Rejected, Severity
from nscc.diagnostics.many import MOST_ERRORS, more_errors
from nscc.diagnostics.suggest import closest, did_you_mean
from nscc.source import Source, Span

_MOST_SUGGESTIONS = 20


class Problems:
    """Errors, warnings and notes about one source text, in the order found."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self._found: list[Diagnostic] = []
        self._unknown: set[str] = set()

    def add(
        self, severity: Severity, code: str, message: str, span: Span, text: str = "", **more: Any
    ) -> None:
        """Adds a diagnostic at `span`; `more` are further members of `Diagnostic`."""
        place = Label(span, text)
        self._found.append(Diagnostic(code, message, severity, self.source, place, **more))

    error = partialmethod(add, Severity.ERROR)
    warning = partialmethod(add, Severity.WARNING)
    note = partialmethod(add, Severity.NOTE)

    def unknown(self, what: str, name: str, span: Span, known: Iterable[str]) -> None:
        """Adds the error for a name that is not known, with the nearest of `known`.

        A name is reported where it first stands; to look for a near one costs time that grows with
        the names there are, so the first few unknown names get it.
        """
        if name in self._unknown:
            return
        self._unknown.add(name)
        if len(self._unknown) > _MOST_SUGGESTIONS:
            known = ()
        candidates = sorted(set(known))
        near = closest(name, candidates)
        shown = ", ".join(f"`{c}`" for c in candidates[:12])
        others = f"names that can be used here: {shown}" if shown else ""
        help_text = did_you_mean(near) if near else others
        helps = (help_text,) if help_text else ()
        fixes = (Fix(f"write `{near}`", span, near, sure=False),) if near else ()
        message = f"`{clipped(name)}` is not the name of {what}"
        self.error("NS0214", message, span, "not known", helps=helps, fixes=fixes)

    def adopt(self, rejected: Rejected, span: Span) -> None:
        """Takes over the diagnostics of a part that knows no source, placing them at `span`."""
        for diagnostic in rejected.diagnostics:
            if diagnostic.source is None:
                diagnostic = replace(diagnostic, source=self.source, label=Label(span))
            self._found.append(diagnostic)

    def has_errors(self) -> bool:
        """True once an error has been added."""
        return any(d.severity is Severity.ERROR for d in self._found)

    def sorted(self) -> tuple[Diagnostic, ...]:
        """What was found, by place in the text; equal places keep the order found.

        Of errors the first MOST_ERRORS, and NS0190 with the number of the rest at the end.
        """
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
        """Raises Rejected with what was found if any of it is an error."""
        if self.has_errors():
            raise Rejected(self.sorted())


def _place(diagnostic: Diagnostic) -> tuple[int, int]:
    if diagnostic.label is None:
        return (-1, -1)
    return (diagnostic.label.span.start, diagnostic.label.span.end)


def clipped(text: object, most: int = 60) -> str:
    """`text` for a message, cut in the middle where it is longer than `most` characters."""
    shown = printable(text)
    if len(shown) <= most:
        return shown
    half = (most - 5) // 2
    return f"{shown[:half]} ... {shown[-half:]}"


def printable(text: object) -> str:
    """`text` as a string; an integer too long to print is described instead."""
    if isinstance(text, int) and not isinstance(text, bool) and text.bit_length() > 256:
        sign = "negative " if text < 0 else ""
        return f"a {sign}number of {text.bit_length()} bits"
    return str(text)


def counted(number: int, noun: str, plural: str | None = None) -> str:
    """`1 slot`, `2 slots`: a number with its noun."""
    return f"{number} {noun if number == 1 else plural or noun + 's'}"
