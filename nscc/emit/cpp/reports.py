"""C++ that sends reports about planes as text."""

from __future__ import annotations

from collections.abc import Iterator

from nscc.emit.cpp.cpp_text import template_lines
from nscc.words.container import Container
from nscc.words.reach import Reach

MARGINS_GROW = (
    "the states carry what is beyond the border one step further with every frame, so that reports "
    "soon cover no pixel"
)


def report_lines(container: Container, film: list[dict[str, Reach]]) -> Iterator[str]:
    """Yield the function `report`, and for each report the margins of its plane in the frames of
    `film`."""
    pictures, target = container.pictures, container.target
    yield "#ifdef __LPC43XX__"
    for number, report in enumerate(pictures.reports if pictures else ()):
        rows = (f"{{{', '.join(map(str, reaches[report.plane]))}}}" for reaches in film)
        yield f"const uint16_t margin_{number}[][4] = {{{', '.join(rows)}}};"
    yield from template_lines("report", rows=target.rows, cols=target.cols)
    yield ""
