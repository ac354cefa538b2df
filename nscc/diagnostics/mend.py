"""Sure fixes applied to the text that they are for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from nscc.diagnostics.message import Diagnostic
from nscc.source import Source


def mended(source: Source, diagnostics: Iterable[Diagnostic]) -> tuple[Source, int]:
    """The text with the sure fixes of its diagnostics, and how many there were.

    Of several fixes of one diagnostic the first sure one is taken; of fixes that overlap the last
    one in the text.
    """
    fixes = []
    for diagnostic in diagnostics:
        sure = [fix for fix in diagnostic.fixes if fix.sure]
        if sure and diagnostic.source is not None and diagnostic.source.text == source.text:
            fixes.append(sure[0])
    text, count, begun = source.text, 0, len(source.text) + 1
    for fix in sorted(fixes, key=lambda fix: fix.span.start, reverse=True):
        if fix.span.end <= begun and fix.span.start < begun:
            text = text[: fix.span.start] + fix.replacement + text[fix.span.end :]
            begun = fix.span.start
            count += 1
    return replace(source, text=text), count
