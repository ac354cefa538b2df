"""Draw a program as an editor shows it, with hints and messages from `nscc.editing`."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

from pygments import lex
from pygments.token import Comment, Keyword, Number

from nscc.editing.document import Document
from nscc.editing.hover import hints, hover
from nscc_runtime.pictures.sheet import WIDTH, png_of, theme
from nscc_site.lexer import NslLexer

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_RIGHT = """nsl 1

let long = 4 * 48
frame 256 slots of 125us

code stop : 1..long
open when n < stop

pixels stop = tile [[long, 64],
                    [  16,  4]]
"""
_WRONG = _RIGHT.replace("n < stop", "n < stp")
_SIZE = 8.5
_LETTER = 0.602 * _SIZE / 72
"""The width in inches of a letter of DejaVu Sans Mono."""
_LINE, _AROUND = 0.2, 0.35
_COLUMNS = 96
"""Characters per line of the box, whose font is proportional."""


def editor_picture(repository: Path) -> bytes:
    """Draw a correct program with a hover text, and the same program with a spelling mistake."""
    return png_of(_figure, repository / "examples")


def _figure(folder: Path) -> Figure:
    from matplotlib.figure import Figure

    right, wrong = (Document("hdr.nsl", text, folder) for text in (_RIGHT, _WRONG))
    told = hover(right, _RIGHT.index("stop ="))
    (message,) = wrong.checked.diagnostics
    assert told is not None
    assert message.label is not None
    said = [f"{message.code}: {message.message}", *(fix.title for fix in message.fixes)]
    panels = [(right, told.span.start, [told.text]), (wrong, message.label.span.start, said)]
    lines = [text.text.count("\n") + _height(box) + 1 for text, _, box in panels]
    figure = Figure((WIDTH, _LINE * sum(lines)))
    top = figure.get_figheight()
    for (document, offset, box), count in zip(panels, lines, strict=True):
        top -= _LINE * count
        axes = figure.add_axes(
            (0, top / figure.get_figheight(), 1, _LINE * count / figure.get_figheight())
        )
        axes.set(xlim=(0, WIDTH), ylim=(_LINE * count, 0))
        axes.axis("off")
        _write(axes, document, offset, box)
        if document is wrong:
            _underline(axes, document, message.label.span.start, message.label.span.end)
    return figure


def _height(box: list[str]) -> float:
    return len(_wrapped(box)) + 0.6


def _wrapped(box: list[str]) -> list[str]:
    return [line for text in box for line in textwrap.wrap(text.replace("`", ""), _COLUMNS)]


def _write(axes: Axes, document: Document, offset: int, box: list[str]) -> None:
    """Draw the text with colours and hints, and the box below the line of `offset`."""
    chosen, row = theme(), 0
    below = document.text.count("\n", 0, offset)
    shift = [0.0 if k <= below else _height(box) for k in range(document.text.count("\n") + 1)]
    column = 0
    for kind, text in lex(document.text, NslLexer()):
        for piece in re.split(r"(\n)", text):
            if piece == "\n":
                row, column = row + 1, 0
                continue
            _text(axes, row + shift[row], column, piece, _colour(kind))
            column += len(piece)
    for hint in hints(document):
        row = document.text.count("\n", 0, hint.offset)
        column = hint.offset - document.text.rfind("\n", 0, hint.offset) + 1
        _text(axes, row + shift[row], column, hint.text, chosen.faint, style="italic")
    for k, line in enumerate(_wrapped(box)):
        _text(axes, below + 1.2 + k, 4, line, chosen.ink, family="sans-serif")
    from matplotlib.patches import Rectangle

    left, height = _AROUND + 3 * _LETTER, (_height(box) - 0.1) * _LINE
    axes.add_patch(
        Rectangle(
            (left, (below + 1.05) * _LINE),
            WIDTH - left - _AROUND,
            height,
            facecolor=chosen.grid,
            edgecolor=chosen.faint,
            zorder=0,
        )
    )


def _text(axes: Axes, row: float, column: int, text: str, colour: str, **more: str) -> None:
    x, y = _AROUND + column * _LETTER, (row + 0.75) * _LINE
    axes.text(x, y, text, color=colour, size=_SIZE, **{"family": "monospace", **more})


def _underline(axes: Axes, document: Document, start: int, end: int) -> None:
    row = document.text.count("\n", 0, start)
    column = start - document.text.rfind("\n", 0, start) - 1
    x = _AROUND + column * _LETTER
    axes.plot((x, x + (end - start) * _LETTER), [(row + 0.92) * _LINE] * 2, color="#d1495b", lw=1.6)


def _colour(kind: object) -> str:
    chosen = theme()
    if kind in Comment:
        return chosen.faint
    return (
        chosen.series[0] if kind in Keyword else chosen.series[1] if kind in Number else chosen.ink
    )
