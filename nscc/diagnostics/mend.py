"""Automatic application of safe fixes to a text."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from nscc.diagnostics.message import Diagnostic
from nscc.source import Source


def mended(source: Source, diagnostics: Iterable[Diagnostic]) -> tuple[Source, int]:
    """Apply the safe fixes of a text's diagnostics; return the text and the number of fixes.

    The first safe fix of each diagnostic is used. Of overlapping fixes, the last in the text is
    applied."""
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
