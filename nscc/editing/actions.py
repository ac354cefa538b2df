"""Changes that an editor offers: the fixes that messages carry."""

from __future__ import annotations

from collections.abc import Iterator

from nscc.diagnostics.diagnostic import Diagnostic, Fix
from nscc.diagnostics.mend import mended
from nscc.editing.document import Document
from nscc.source import Span


def fixes_at(document: Document, span: Span) -> Iterator[tuple[Diagnostic, Fix]]:
    """The fixes of messages whose place or whose change touches `span`, with their messages."""
    for diagnostic in document.checked.diagnostics:
        if diagnostic.source is None or diagnostic.source.text != document.text:
            continue
        for fix in diagnostic.fixes:
            places = [fix.span] if diagnostic.label is None else [fix.span, diagnostic.label.span]
            if any(place.start <= span.end and span.start <= place.end for place in places):
                yield diagnostic, fix


def all_mended(document: Document) -> str | None:
    """The text with every sure fix made, as one round of `nscc check --fix`; None if none is."""
    better, count = mended(document.source, document.checked.diagnostics)
    return better.text if count else None
