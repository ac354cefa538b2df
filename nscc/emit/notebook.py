"""Notebook views of a program: its shutters over time, and its card."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nscc import html
from nscc.arrays import Bools, Floats
from nscc.diagnostics.render import render
from nscc.emit.summary import summary_rows
from nscc.lower.resources import time_text
from nscc.pipeline import KINDS, Compiled
from nscc.words.container import Container
from nscc.words.shutters import shutters_of

_MOST_ROWS = 24
"""Most shutters in a chart; of more, evenly spaced ones are drawn."""
_COLUMNS = 360
"""Most columns of a bar; with more slots, each column shows the share of open time."""
_SHADES = 4
"""Steps of opacity of a column, which shows its share of open time."""
_LABELS, _WIDTH, _ROW, _AXIS = 170.0, 530.0, 18.0, 20.0
"""Pixels for labels, chart width, row height and the time axis."""


def shutter_chart(
    rows: Bools, labels: Sequence[str], slot_us: Sequence[float], buckets: Sequence[str]
) -> html.Html:
    """Return a chart of shutters, bool (shutters, buckets, N), over time, with one row each.

    `labels` stand beside the rows, one for each shutter. `slot_us` are the lengths of the N slots
    in microseconds, `buckets` the names of the buckets. If there are many shutters, evenly spaced
    ones are shown, including the first and the last."""
    count = len(rows)
    chosen = np.unique(np.rint(np.linspace(0, count - 1, min(count, _MOST_ROWS))).astype(int))
    edges = np.concatenate(([0.0], np.cumsum(slot_us)))
    columns = edges if len(slot_us) <= _COLUMNS else np.linspace(0.0, edges[-1], _COLUMNS + 1)
    shapes = []
    for line, row in enumerate(chosen):
        top = line * _ROW
        shapes.append(html.words(_LABELS - 8, top + 13, labels[row], "end"))
        shapes.append(
            f"<rect x='{_LABELS:g}' y='{top + 2:g}' width='{_WIDTH:g}' height='{_ROW - 4:g}' "
            "fill-opacity='.1'/>"
        )
        lane = (_ROW - 4) / len(buckets)
        for bucket, opened in enumerate(rows[row]):
            # The open time up to each edge; its increase in a column is the column's share.
            until = np.concatenate(([0.0], np.cumsum(np.diff(edges) * opened)))
            share = np.diff(np.interp(columns, edges, until)) / np.diff(columns)
            shapes += _bars(columns / edges[-1], share, top + 2 + bucket * lane, lane, bucket)
    bottom = len(chosen) * _ROW
    shapes.append(html.words(_LABELS, bottom + 15, "0"))
    shapes.append(html.words(_LABELS + _WIDTH, bottom + 15, time_text(float(edges[-1])), "end"))
    title = f"when {count} shutters are open"
    chart = html.drawing(_LABELS + _WIDTH, bottom + _AXIS, shapes, title)
    count_note = (
        html.text(f"{len(chosen)} of {count} shutters") if len(chosen) < count else html.Html()
    )
    legend = html.legend(buckets) if len(buckets) > 1 else html.Html()
    return html.Html(f"{chart}{legend}{count_note}")


def _bars(
    column_edges: Floats,
    share: Floats,
    top: float,
    height: float,
    bucket: int,
) -> list[str]:
    """Return SVG paths of one shutter's bar, one for each shade, which shows for which part of each
    column it is open; columns that are closed have none.

    `column_edges` has the shape (columns + 1,), and `share` (columns,) the open part of each
    column, all 0..1; `top` and `height` are in pixels. `bucket` chooses the colour."""
    # Rounded up, so that a short open time is visible; the small number is for rounding errors.
    shade = np.ceil(share * _SHADES - 1e-9).astype(int)
    starts = np.concatenate(([0], np.flatnonzero(np.diff(shade)) + 1))
    ends = np.concatenate((starts[1:], [len(shade)]))
    paths: dict[int, list[str]] = {}
    for start, end in zip(starts, ends, strict=True):
        x0, x1 = (_LABELS + _WIDTH * column_edges[edge] for edge in (start, end))
        box = f"M{x0:.4g} {top:.4g}H{x1:.4g}v{height:.4g}H{x0:.4g}z"
        paths.setdefault(int(shade[start]), []).append(box)
    colour = html.SERIES[bucket % len(html.SERIES)]
    return [
        f"<path fill='{colour}' fill-opacity='{level / _SHADES:g}' d='{''.join(boxes)}'/>"
        for level, boxes in paths.items()
        if level
    ]


def container_chart(container: Container) -> html.Html:
    """Return the chart of a container's shutters; empty if they depend on the light, or are unknown
    because it has no decode table."""
    if not (container.has_table and KINDS.of(container).shutters_known):
        return html.Html()
    drawn = shutters_of(container)
    return shutter_chart(drawn.rows, drawn.labels, container.slot_us, container.buckets)


def program_card(name: str, container: Container, compiled: Compiled | None) -> str:
    """Return a card of a program in HTML: its shutters, summary and messages.

    `compiled` is None for a program that was loaded from words."""
    if compiled is not None:
        rows: list[tuple[str, str]] = summary_rows(compiled)
    else:
        kind = KINDS.of(container)
        stored = f"{container.words_stored} stored, {kind.size_text(container)} a frame"
        rows = [*sorted(container.notes.items()), (kind.subject, stored)]
    messages = () if compiled is None else compiled.diagnostics
    text = html.plain(render(messages, "human")) if messages else html.Html()
    chart = container_chart(container)
    return html.card(name, f"for {container.target.name}", chart, html.table(rows), text)
