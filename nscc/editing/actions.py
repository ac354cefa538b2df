"""Fixes of messages that an editor offers."""

from __future__ import annotations

from collections.abc import Iterator

from nscc.diagnostics.diagnostic import Diagnostic, Fix
from nscc.diagnostics.mend import mended
from nscc.editing.document import Document
from nscc.source import Span


def fixes_at(document: Document, span: Span) -> Iterator[tuple[Diagnostic, Fix]]:
    """Yield the messages and their fixes at `span`: the message or the change touches it."""
    for diagnostic in document.checked.diagnostics:
        if diagnostic.source is None or diagnostic.source.text != document.text:
            continue
        for fix in diagnostic.fixes:
            places = [fix.span] if diagnostic.label is None else [fix.span, diagnostic.label.span]
            if any(place.start <= span.end and span.start <= place.end for place in places):
                yield diagnostic, fix


def all_mended(document: Document) -> str | None:
    """Return the text after applying all safe fixes once, as `nscc check --fix` does; None without
    fixes."""
    better, count = mended(document.source, document.checked.diagnostics)
    return better.text if count else None
