"""Fixes of messages, as an editor offers them."""

from __future__ import annotations

from collections.abc import Iterator

from nscc.diagnostics.diagnostic import Diagnostic, Fix
from nscc.diagnostics.mend import mended
from nscc.editing.document import Document
from nscc.source import Span


def fixes_at(document: Document, span: Span) -> Iterator[tuple[Diagnostic, Fix]]:
    """The fixes, with their messages, whose message or change touches `span`."""
    for diagnostic in document.checked.diagnostics:
        if diagnostic.source is None or diagnostic.source.text != document.text:
            continue
        for fix in diagnostic.fixes:
            places = [fix.span] if diagnostic.label is None else [fix.span, diagnostic.label.span]
            if any(place.start <= span.end and span.start <= place.end for place in places):
                yield diagnostic, fix


def all_mended(document: Document) -> str | None:
    """The text with all sure fixes applied once, as `nscc check --fix` does; None if there are
    none."""
    better, count = mended(document.source, document.checked.diagnostics)
    return better.text if count else None
