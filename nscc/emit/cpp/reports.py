"""C++ that sends reports about planes as text."""

from __future__ import annotations

from collections.abc import Iterator

from nscc.emit.cpp.cpp_text import template_lines
from nscc.words.container import Container
from nscc.words.reach import film_reaches


def margins_fault(container: Container) -> str | None:
    """Return why the reports of a container cannot be written, as half a sentence, or None."""
    pictures = container.pictures
    if pictures is None or not pictures.reports or film_reaches(container) is not None:
        return None
    return (
        "the states carry what is beyond the border one step further with every frame, so that "
        "reports soon cover no pixel"
    )


def report_lines(container: Container) -> Iterator[str]:
    """Yield the function `report`, and for each report the margins of its plane, frame by frame."""
    pictures, target = container.pictures, container.target
    if pictures is None or not pictures.reports:
        return
    film = film_reaches(container)
    assert film is not None, "margins_fault"
    yield "#ifdef __LPC43XX__"
    for number, report in enumerate(pictures.reports):
        rows = (f"{{{', '.join(map(str, reaches[report.plane]))}}}" for reaches in film)
        yield f"const uint16_t margin_{number}[][4] = {{{', '.join(rows)}}};"
    yield from template_lines("report", rows=target.rows, cols=target.cols)
    yield ""
