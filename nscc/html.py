"""HTML fragments for notebooks, without scripts, files or external style sheets.

Text has the page's colour (`currentColor`), for light and dark pages. The series colours (blue,
orange and green of Okabe and Ito) suit both and are distinguishable for colour-blind readers. All
text is escaped in this module."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Sequence
from html import escape

SERIES = ("#3b8fd4", "#e69f00", "#009e73", "#cc79a7")
"""Colours of series, repeated if there are more series."""

_FAINT = "opacity:.7"


class Html(str):
    """A string of HTML, which `text` does not escape again."""


def text(value: object) -> Html:
    """Escape a value for HTML, unless it is Html already."""
    return value if isinstance(value, Html) else Html(escape(str(value)))


def card(title: str, subtitle: str, *sections: Html) -> str:
    """Return a box with a title, a subtitle and sections below each other. Empty sections are left
    out."""
    head = (
        f"<div><strong>{text(title)}</strong> <span style='{_FAINT}'>{text(subtitle)}</span></div>"
    )
    inside = "".join(
        f"<div style='margin-top:.5em'>{section}</div>" for section in sections if section
    )
    return f"<div style='max-width:60em;line-height:1.4'>{head}{inside}</div>"


def table(rows: Iterable[Sequence[object]], head: Sequence[object] = ()) -> Html:
    """Return a table of left-aligned cells; each row has at least one.

    Without `head`, the first cell of each row is its label and fainter than the others."""
    cell = "text-align:left;padding:.1em .8em .1em 0;border:none;background:none"
    lines = []
    if head:
        lines.append("".join(f"<th style='{cell}'>{text(value)}</th>" for value in head))
    for first, *cells in rows:
        faint = cell if head else f"{cell};{_FAINT}"
        named = f"<td style='{faint}'>{text(first)}</td>"
        lines.append(named + "".join(f"<td style='{cell}'>{text(value)}</td>" for value in cells))
    body = "".join(f"<tr style='background:none'>{line}</tr>" for line in lines)
    return Html(f"<table style='border:none;margin:0'>{body}</table>")


def folded(summary: str, inside: Html) -> Html:
    """Return a line `summary` that shows `inside` after a click."""
    return Html(f"<details><summary>{text(summary)}</summary>{inside}</details>")


def plain(value: str) -> Html:
    """Return preformatted text."""
    return Html(f"<pre style='margin:0;background:none;color:inherit'>{text(value)}</pre>")


def side_by_side(blocks: Iterable[Html]) -> Html:
    """Return blocks in a row that wraps on narrow pages."""
    joined = "".join(f"<div>{block}</div>" for block in blocks)
    return Html(f"<div style='display:flex;flex-wrap:wrap;gap:1em'>{joined}</div>")


def legend(names: Sequence[str]) -> Html:
    """Return names, each beside a square in the colour of SERIES at its index; the colours
    repeat."""
    return side_by_side(
        Html(f"<span style='color:{SERIES[number % len(SERIES)]}'>&#9632;</span> {text(name)}")
        for number, name in enumerate(names)
    )


def picture(png: bytes, caption: str, width: int) -> Html:
    """Return a PNG with a caption, displayed `width` pixels wide, at most the page's width, without
    smoothing."""
    data = b64encode(png).decode()
    return Html(
        f"<figure style='margin:0'><img alt='{text(caption)}' src='data:image/png;base64,{data}' "
        f"style='width:{width}px;max-width:100%;image-rendering:pixelated'/>"
        f"<figcaption style='{_FAINT}'>{text(caption)}</figcaption></figure>"
    )


def drawing(width: float, height: float, shapes: Iterable[str], title: str) -> Html:
    """Return an SVG of `shapes`, which are SVG elements as text that is not escaped, `width` x
    `height` pixels, which shrinks with the page.

    `title` names it for screen readers."""
    return Html(
        f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width:g} {height:g}' "
        f"role='img' style='width:100%;max-width:{width:g}px;height:auto' "
        f"fill='currentColor' font-size='12' font-family='sans-serif'>"
        f"<title>{text(title)}</title>{''.join(shapes)}</svg>"
    )


def words(x: float, y: float, value: object, anchor: str = "start") -> str:
    """Return SVG text with its baseline at `y` pixels from the top; `anchor` "end" ends it `x`
    pixels from the left, "start" begins it there."""
    return f"<text x='{x:g}' y='{y:g}' text-anchor='{anchor}'>{text(value)}</text>"
