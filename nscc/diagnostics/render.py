"""Diagnostics as text: for people, for editors (`short`), for programs (`json`)."""

from __future__ import annotations

import json
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Literal

from nscc.diagnostics.model import Diagnostic, Label, Severity
from nscc.source import Source

Format = Literal["human", "short", "json"]

PAGES = Path(__file__).parent / "pages"
_WIDEST = 100
_TAB = 4
_PAINT = {
    Severity.ERROR: "\x1b[1;31m",
    Severity.WARNING: "\x1b[1;33m",
    Severity.NOTE: "\x1b[1;36m",
}
_BOLD, _BLUE, _PLAIN = "\x1b[1m", "\x1b[1;34m", "\x1b[0m"


@cache
def names() -> dict[str, str]:
    """The kebab-case name of every code that has a page."""
    return {p.stem[:6]: p.stem[7:] for p in sorted(PAGES.glob("NS[0-9][0-9][0-9][0-9]-*.md"))}


def render(diagnostics: Sequence[Diagnostic], form: Format, color: bool = False) -> str:
    """Diagnostics as text that ends in a line break; `json` has one object a line."""
    if form == "json":
        return "".join(_json(d) for d in diagnostics)
    if form == "short":
        return "".join(_short(d) + "\n" for d in diagnostics)
    return "\n".join(_human(d, color) for d in diagnostics)


def _place(diagnostic: Diagnostic) -> str:
    source = diagnostic.source
    if source is None:
        return ""
    if diagnostic.label is None:
        return source.name
    row, column = source.row_column(diagnostic.label.span.start)
    return f"{source.name}:{row}:{column}"


def _short(diagnostic: Diagnostic) -> str:
    place = _place(diagnostic)
    head = f"{diagnostic.severity}[{diagnostic.code}]: {_one_line(diagnostic.message)}"
    return f"{place}: {head}" if place else head


def _json(diagnostic: Diagnostic) -> str:
    source, label = diagnostic.source, diagnostic.label
    location = end_location = None
    if source is not None and label is not None:
        location = _row_column(source, label.span.start)
        end_location = _row_column(source, label.span.end)
    value = {
        "code": diagnostic.code,
        "name": names().get(diagnostic.code, ""),
        "severity": str(diagnostic.severity),
        "message": diagnostic.message,
        "filename": None if source is None else source.name,
        "location": location,
        "end_location": end_location,
        "data": dict(diagnostic.data),
        "fixes": [
            {"title": fix.title, "replacement": fix.replacement}
            | (
                {}
                if source is None
                else {
                    "location": _row_column(source, fix.span.start),
                    "end_location": _row_column(source, fix.span.end),
                }
            )
            for fix in diagnostic.fixes
        ],
        "rendered": _human(diagnostic, False),
    }
    return json.dumps(value) + "\n"


def _row_column(source: Source, offset: int) -> dict[str, int]:
    row, column = source.row_column(offset)
    return {"row": row, "column": column}


def _human(diagnostic: Diagnostic, color: bool) -> str:
    def paint(code: str, text: str) -> str:
        return f"{code}{text}{_PLAIN}" if color else text

    head = paint(_PAINT[diagnostic.severity], f"{diagnostic.severity}[{diagnostic.code}]")
    lines = [head + paint(_BOLD, f": {diagnostic.message}")]
    source = diagnostic.source
    margin = 2
    if source is not None:
        labels = [] if diagnostic.label is None else [diagnostic.label]
        labels += diagnostic.related
        rows = [source.row_column(label.span.start)[0] for label in labels]
        margin = max((len(str(row)) for row in rows), default=1) + 1
        lines.append(paint(_BLUE, " " * margin + "--> ") + _place(diagnostic))
        if labels:
            bar = paint(_BLUE, " " * (margin + 1) + "|")
            lines.append(bar)
            for i, (label, row) in enumerate(zip(labels, rows, strict=True)):
                mark = "^" if i == 0 and diagnostic.label is not None else "-"
                text, pointer = _excerpt(source, label, row, mark)
                lines.append(paint(_BLUE, f"{row:>{margin}} |") + f" {text}".rstrip())
                tone = _PAINT[diagnostic.severity] if mark == "^" else _BLUE
                lines.append(f"{bar} {paint(tone, pointer)}".rstrip())
            if diagnostic.notes:
                lines.append(bar)
    for note in diagnostic.notes:
        lines.append(paint(_BLUE, " " * (margin + 1) + "= ") + note)
    lines += _helps(diagnostic)
    return "\n".join(lines) + "\n"


def _helps(diagnostic: Diagnostic) -> list[str]:
    helps = [*diagnostic.helps, *(fix.title for fix in diagnostic.fixes)]
    if diagnostic.code == "NS0412" and helps:
        lines = ["help: each of these was compiled and fits"]
        lines += [f"   {i}. {text}" for i, text in enumerate(helps, 1)]
        return [*lines, f"   = more: nscc explain {diagnostic.code}"]
    return [f"help: {text}" for text in helps]


def _excerpt(source: Source, label: Label, row: int, mark: str) -> tuple[str, str]:
    """The label's line, cut around the label, and the marks under it with the label's words."""
    line = source.line(row)
    _, column = source.row_column(label.span.start)
    start = min(column - 1, len(line))
    end = min(max(start + label.span.end - label.span.start, start + 1), max(len(line), start + 1))
    first = 0
    if len(line) > _WIDEST:
        first = max(0, min(start - _WIDEST // 4, len(line) - _WIDEST))
        end = min(end, first + _WIDEST)
    before, marked = line[first:start], line[start:end]
    after = line[end : first + _WIDEST]
    head = "..." if first else ""
    tail = "..." if first + _WIDEST < len(line) else ""
    text = head + _visible(before) + _visible(marked) + _visible(after) + tail
    pad = " " * (len(head) + _width(_visible(before)))
    words = f" {label.text}" if label.text else ""
    return text, pad + mark * max(1, _width(_visible(marked))) + words


def _visible(text: str) -> str:
    """Text with tabs as blanks and what does not print as `?`, so that columns can be counted."""
    if text.isascii() and text.isprintable():
        return text
    return "".join(
        " " * _TAB if ch == "\t" else ch if ch.isprintable() else "?" for ch in text
    )


def _width(text: str) -> int:
    """Columns that a terminal gives to visible text."""
    if text.isascii():
        return len(text)
    from unicodedata import combining, east_asian_width

    return sum(
        0 if combining(ch) else 2 if east_asian_width(ch) in "WF" else 1 for ch in text
    )


def _one_line(text: str) -> str:
    return " ".join(text.split())
