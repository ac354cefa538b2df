"""Diagnostics as text: for people, editors (`short`) and programs (`json`).

`nscc.diagnostics.reports` has the formats of code-review services."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Literal

from nscc.diagnostics.message import Diagnostic, Fix, Label, Severity
from nscc.source import Source

Format = Literal["human", "short", "json"]

PAGES = Path(__file__).parent / "pages"
"""The folder of pages that explain the error codes."""
_WIDEST = 100
"""Most columns of a program line in a message."""
_TAB = 4
"""Columns of a tab."""
_PAINT = {
    Severity.ERROR: "\x1b[1;31m",
    Severity.WARNING: "\x1b[1;33m",
    Severity.NOTE: "\x1b[1;36m",
}
_BOLD, _BLUE, _PLAIN = "\x1b[1m", "\x1b[1;34m", "\x1b[0m"


@cache
def names() -> dict[str, str]:
    """Return {code: name} of every diagnostic that has a page, such as {"NS0412":
    "too-many-shutters"}."""
    return {p.stem[:6]: p.stem[7:] for p in sorted(PAGES.glob("NS[0-9][0-9][0-9][0-9]-*.md"))}


def render(diagnostics: Sequence[Diagnostic], form: Format, color: bool = False) -> str:
    """Return diagnostics as text that ends in a line break; "" without diagnostics.

    `form` is the format: `human` quotes the source lines, `short` has one line for each diagnostic,
    and `json` one object per line. `color` adds escape sequences for terminals to `human`."""
    if form == "json":
        return "".join(_json(d) for d in diagnostics)
    if form == "short":
        return "".join(_short(d) + "\n" for d in diagnostics)
    return "\n".join(_human(d, color) for d in diagnostics)


def _place(diagnostic: Diagnostic) -> str:
    """Return "file:row:column" of a diagnostic, row and column counted from 1.

    Without a label, return only the file; without a source, ""."""
    source = diagnostic.source
    if source is None:
        return ""
    name = _one_line(source.name)
    if diagnostic.label is None:
        return name
    row, column = source.row_column(diagnostic.label.span.start)
    return f"{name}:{row}:{column}"


def _short(diagnostic: Diagnostic) -> str:
    """Return a diagnostic as one line: place, severity, code and message."""
    place = _place(diagnostic)
    head = f"{diagnostic.severity}[{diagnostic.code}]: {_one_line(diagnostic.message)}"
    return f"{place}: {head}" if place else head


def _json(diagnostic: Diagnostic) -> str:
    """Return a diagnostic as one line of JSON, with its line break: positions, fixes and the text
    for people. Without a source or a label, positions are null."""
    import json

    source, label = diagnostic.source, diagnostic.label
    value = {
        "code": diagnostic.code,
        "name": names().get(diagnostic.code, ""),
        "severity": str(diagnostic.severity),
        "message": diagnostic.message,
        "filename": None if source is None else source.name,
        **{"location": None, "end_location": None, **_locations(source, label)},
        "data": dict(diagnostic.data),
        "fixes": [
            {
                "title": fix.title,
                "replacement": fix.replacement,
                "sure": fix.sure,
                **_locations(source, fix),
            }
            for fix in diagnostic.fixes
        ],
        "rendered": _human(diagnostic, color=False),
    }
    return json.dumps(value) + "\n"


def _locations(source: Source | None, at: Label | Fix | None) -> dict[str, dict[str, int]]:
    """Return {"location": .., "end_location": ..}: row and column of the start and end of `at`.

    Rows and columns count from 1; the end is after the last character. The result is empty if there
    is no source or place."""
    if source is None or at is None:
        return {}
    rows_columns = (source.row_column(offset) for offset in (at.span.start, at.span.end))
    places = ({"row": row, "column": column} for row, column in rows_columns)
    return dict(zip(("location", "end_location"), places, strict=True))


def _human(diagnostic: Diagnostic, color: bool) -> str:
    """Return a diagnostic as text for a terminal: message, quoted source lines, notes and helps.

    With `color`, the text contains ANSI escape sequences."""
    paint = _painted if color else lambda _code, text: text
    head = paint(_PAINT[diagnostic.severity], f"{diagnostic.severity}[{diagnostic.code}]")
    lines = [head + paint(_BOLD, f": {_one_line(diagnostic.message)}")]
    source = diagnostic.source
    margin = 2
    if source is not None:
        labels = [] if diagnostic.label is None else [diagnostic.label]
        labels += diagnostic.related
        rows = [source.row_column(label.span.start)[0] for label in labels]
        margin = max((len(str(row)) for row in rows), default=1) + 1
        lines.append(paint(_BLUE, " " * margin + "--> ") + _place(diagnostic))
        if labels:
            lines += _labelled(diagnostic, source, labels, rows, margin, paint)
    for note in diagnostic.notes:
        lines.append(paint(_BLUE, " " * (margin + 1) + "= ") + _printable(note))
    lines += map(_printable, _helps(diagnostic))
    return "\n".join(lines) + "\n"


def _painted(code: str, text: str) -> str:
    """Return a text in the colour that the terminal's escape `code` sets."""
    return f"{code}{text}{_PLAIN}"


def _labelled(
    diagnostic: Diagnostic,
    source: Source,
    labels: Sequence[Label],
    rows: Sequence[int],
    margin: int,
    paint: Callable[[str, str], str],
) -> list[str]:
    """Return the source lines of the labels, with marks below them; neighbouring labels on one line
    share it.

    `labels` begins with the diagnostic's own label, if it has one; its marks are ^, others are -.
    `rows` are the line numbers of the labels, from 1. `margin` is the width of the column of line
    numbers. `paint` returns a text (second argument) in the colour of an escape sequence (first
    argument)."""
    bar = paint(_BLUE, " " * (margin + 1) + "|")
    lines = [bar]
    above = (0, "")  # the row and the text of the source line above, which labels may share
    for label, row in zip(labels, rows, strict=True):
        primary = label is diagnostic.label
        text, pointer = _excerpt(source, label, row, "^" if primary else "-")
        if (row, text) != above:
            lines.append(paint(_BLUE, f"{row:>{margin}} |") + f" {text}".rstrip())
            above = row, text
        tone = _PAINT[diagnostic.severity] if primary else _BLUE
        lines.append(f"{bar} {paint(tone, pointer)}".rstrip())
    return [*lines, bar] if diagnostic.notes else lines


def _helps(diagnostic: Diagnostic) -> list[str]:
    """Return the lines with help of a diagnostic, in this order: the helps, the titles of fixes
    that no help quotes, and numbered ways out."""
    helps_text = "".join(diagnostic.helps)
    fixes = [fix.title for fix in diagnostic.fixes if f"`{fix.replacement}`" not in helps_text]
    helps = [*diagnostic.helps, *fixes]
    lines = [f"help: {text}" for text in helps]
    if diagnostic.ways_out:
        lines.append("help: each of these was compiled and fits")
        lines += [f"   {i}. {text}" for i, text in enumerate(diagnostic.ways_out, 1)]
        lines.append(f"   = more: nscc explain {diagnostic.code}")
    return lines


def _excerpt(source: Source, label: Label, row: int, mark: str) -> tuple[str, str]:
    """Return the source line `row`, from 1, and a line with marks below the label's place and its
    text.

    A line longer than `_WIDEST` is cut around the label. `mark` is the character of the marks. Only
    the first line of a label that spans several is marked."""
    line = source.line(row)
    _, column = source.row_column(label.span.start)
    start = min(column - 1, len(line))
    # At least one column is marked, also for an empty place and one after the last character.
    end = min(max(start + label.span.end - label.span.start, start + 1), max(len(line), start + 1))
    first = 0  # the first character of the line that is shown
    if len(line) > _WIDEST:
        # A quarter of the width shows what stands before the label.
        first = max(0, min(start - _WIDEST // 4, len(line) - _WIDEST))
        end = min(end, first + _WIDEST)
    before, marked = line[first:start], line[start:end]
    after = line[end : first + _WIDEST]
    head = "..." if first else ""
    tail = "..." if first + _WIDEST < len(line) else ""
    text = head + _visible(before) + _visible(marked) + _visible(after) + tail
    pad = " " * (len(head) + _width(_visible(before)))
    words = f" {_one_line(label.text)}" if label.text else ""
    return text, pad + mark * max(1, _width(_visible(marked))) + words


def _visible(text: str) -> str:
    """Replace tabs by blanks and unprintable characters by `?`, so that columns can be counted.

    Bytes of file names that Python could not decode are decoded as UTF-8 first. A tab becomes
    `_TAB` blanks, whatever its column."""
    if text.isascii() and text.isprintable():
        return text
    with suppress(UnicodeError):
        # In an ASCII locale, Python escapes the UTF-8 bytes of file names.
        text = text.encode("utf-8", "surrogateescape").decode("utf-8")
    return "".join(" " * _TAB if ch == "\t" else ch if ch.isprintable() else "?" for ch in text)


def _width(text: str) -> int:
    """Return the number of terminal columns of a text: wide characters have 2, combining ones 0."""
    if text.isascii():
        return len(text)
    from unicodedata import combining, east_asian_width

    return sum(0 if combining(ch) else 2 if east_asian_width(ch) in "WF" else 1 for ch in text)


def _one_line(text: str) -> str:
    """Join the words of a message on one line, and replace control characters by `?`."""
    return _visible(" ".join(text.split()))


def _printable(text: str) -> str:
    """Replace control characters in a text of several lines by `?`; line breaks stay."""
    return "\n".join(map(_visible, text.split("\n")))
