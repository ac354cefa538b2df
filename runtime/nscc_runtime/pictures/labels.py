"""Place texts beside the marks and lines that they belong to, with textalloc."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import redirect_stdout
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.pictures.sheet import theme

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Points = Floats
"""Coordinates (n, 2): x and y in units of the axes."""

_NAME, _SMALL = 7.8, 7.0
"""Font size of names, and of other texts, in points."""
_NEAREST, _NEAR, _FAR = 3.2, 18.0, 70.0
"""Distances in points between a mark and its text: the smallest, the largest, and the largest for
texts that may be further away."""
_LEADER = 12.0
"""A text further away than this distance in points is joined to its mark by a line."""
_HALO = 2.0
"""Width in points of the outline of letters, half of which is outside the letters."""
_MARGIN = 3.2
"""Least distance in points between a text and another text, a mark or a line."""
_CANDIDATES = 400
"""Number of positions that are tried for a text."""


@dataclass(frozen=True)
class ChartLabel:
    """A text to place beside a mark or the end of a line at (`x`, `y`) in data coordinates.
    `colour` is that of the line.

    `name`: whether it is the name of a line, which is larger. `sought`: whether readers look for
    it. Both kinds may be further away, joined to their mark by a thin line."""

    text: str
    x: float
    y: float
    colour: str
    name: bool = False
    sought: bool = False


def place_labels(axes: Axes, labels: Sequence[ChartLabel]) -> list[ChartLabel]:
    """Write `labels` inside the panel `axes`, not on a text, mark or line. Those that may be
    further away are placed first, else in their order. Return those for which there is no free
    position, which are not written; labels without text are ignored.

    The figure must have its final layout (`sheet.lay_out`)."""
    far = [label for label in labels if label.text and (label.name or label.sought)]
    near = [label for label in labels if label.text and not (label.name or label.sought)]
    return [*_placed(axes, far, _FAR), *_placed(axes, near, _NEAR)]


def halo() -> list[Any]:
    """Return the `path_effects` of a text that stays legible on lines."""
    from matplotlib.patheffects import withStroke

    return [withStroke(linewidth=_HALO, foreground=theme().paper)]


def _placed(axes: Axes, labels: list[ChartLabel], farthest: float) -> list[ChartLabel]:
    """Write `labels` into `axes`, at most `farthest` points from their marks. Return those that
    were not written, because there is no free position."""
    from textalloc import allocate

    if not labels:
        return []
    marks, radii, lines = _drawn(axes)
    point = axes.figure.dpi / 72
    # Lengths are fractions of the panel's width; those along y are scaled by `aspect`.
    width, height = axes.bbox.width - point * _HALO, axes.bbox.height - point * _HALO
    aspect = axes.figure.bbox.width / axes.figure.bbox.height
    points = point / min(width, height * aspect)
    room = axes.bbox.padded(-point * _HALO / 2)
    (left, bottom), (right, top) = axes.transData.inverted().transform(room.get_points())
    limits = axes.get_xlim(), axes.get_ylim()
    with redirect_stdout(None):  # textalloc prints if there is no free position
        *_, texts, leaders = allocate(
            axes,
            [label.x for label in labels],
            [label.y for label in labels],
            [label.text for label in labels],
            x_scatter=marks[:, 0],
            y_scatter=marks[:, 1],
            scatter_sizes=radii,
            x_lines=[line[:, 0] for line in lines],
            y_lines=[line[:, 1] for line in lines],
            textsize=[_NAME if label.name else _SMALL for label in labels],
            fontweight=["bold" if label.name else "normal" for label in labels],
            textcolor=[theme().type_in(label.colour) for label in labels],
            linecolor=[label.colour for label in labels],
            margin=_MARGIN * points,
            min_distance=_NEAREST * points,
            max_distance=farthest * points,
            draw_lines=farthest > _NEAR,
            draw_all=False,
            nbr_candidates=_CANDIDATES,
            linewidth=0.7,
            avoid_label_lines_overlap=farthest > _NEAR,
            xlims=(left, right),
            ylims=(bottom, top),
            path_effects=halo(),
            auto_ha=False,
            ha="left",
            va="bottom",
        )
    axes.set(xlim=limits[0], ylim=limits[1])
    joined: list[Any] = [leader for leader in leaders if leader is not None]
    for leader in joined:
        start, end = axes.transData.transform(leader.get_xydata())
        if np.hypot(*(end - start)) < _LEADER * point:
            leader.remove()
    written: list[Any] = [text for text in texts if text is not None]
    for artist in (*joined, *written):
        artist.set_in_layout(False)
    return [label for label, text in zip(labels, texts, strict=True) if text is None]


def _drawn(axes: Axes) -> tuple[Points, Any, list[Points]]:
    """Return the content of a panel in data coordinates: marks (n, 2), their radii in dots (n,),
    and lines (points, 2) each. A text is represented by the diagonals and the sides of its box."""
    to_data = axes.transData.inverted().transform
    marks, radii, lines = [np.empty((0, 2))], [np.empty(0)], []
    for line in axes.lines:
        points = to_data(line.get_transform().transform(line.get_path().vertices))
        points = points[np.isfinite(points).all(1)]
        if line.get_linestyle() != "None" and len(points) > 1:
            lines.append(points)
        if line.get_marker() not in (None, "None", "", " "):
            size = (line.get_markersize() + line.get_markeredgewidth()) / 2
            marks.append(points)
            radii.append(np.full(len(points), size * axes.figure.dpi / 72))
    for text in axes.texts:
        corners = text.get_window_extent().corners()
        lines.append(to_data(corners[[0, 1, 3, 2, 0, 3, 1, 2]]))
    return np.vstack(marks), np.concatenate(radii), lines
