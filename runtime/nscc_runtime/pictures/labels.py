"""Place texts beside their marks and lines, without overlaps.

Every text tries places around its anchors, from near to far. Places are excluded where the text or
its halo would cover a text, a mark or the edge of the panel; small texts also avoid lines, and
names avoid them if possible. The cheapest of the remaining places is near, and nearer to its own
mark than to others.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.pictures.picture_colours import look

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.text import Annotation

Points = NDArray[np.float64]
"""(n, 2): x and y in dots."""
Boxes = NDArray[np.float64]
"""(n, 4): left, bottom, right and top in dots."""

_NAME, _SMALL = 7.8, 7.0
"""Type sizes in points of names, and of other texts."""
_NEAR, _FAR = (3.0, 5.5, 8.5), (4.0, 7.0, 11.0, 16.0, 22.0, 30.0, 40.0, 52.0, 66.0)
"""Distances in points between a mark and its text, and for texts that may stand further off."""
_LEADER = 9.0
"""Distance in points beyond which a text is joined to its anchor by a line."""
_HALO = 2.0
"""Width in points of the halo around letters, half of which lies outside of them."""
_CLEAR = _HALO / 2 + 0.8
"""Margin in points around a text: its halo, and half of a line's width."""
_SPACE, _LEADING = 4.0, 1.0
"""Gaps in points between texts, within a line and between lines."""
_STEP = 3.0
"""Distance in dots of the points that represent lines."""
_ON_LINES, _ON_LINE, _CROSSED, _NEXT, _ASTRAY = 1000.0, 6.0, 2.0, 5.0, 2.0
"""Costs, in points of distance: covering any line, each covered point of a line or leader, a later
anchor, each point nearer to another mark."""


@dataclass(frozen=True)
class ChartLabel:
    """A text that may stand beside any of its `anchors` (x, y) in data coordinates, best first. The
    `name` of a line is larger. It may stand further off, joined to its anchor by a thin line, and
    so may a text that readers look for (`sought`)."""

    text: str
    anchors: Sequence[tuple[float, float]]
    colour: str
    name: bool = False
    sought: bool = False

    @property
    def far(self) -> bool:
        """Whether the text may stand far off."""
        return self.name or self.sought


class _Tally:
    """Points of a panel, counted in boxes in constant time by sums over areas."""

    def __init__(self, axes: Axes, points: Points) -> None:
        room = axes.bbox
        self._corner = np.array([room.x0, room.y0])
        shape = (int(room.width) + 1, int(room.height) + 1)
        at = np.floor(points - self._corner).astype(np.int64)
        at = at[((at >= 0) & (at < shape)).all(1)]
        counts = np.zeros((shape[0] + 1, shape[1] + 1), np.int64)
        np.add.at(counts, tuple(at.T + 1), 1)
        self._sums = counts.cumsum(0).cumsum(1)

    def count_in(self, boxes: Boxes) -> NDArray[np.int64]:
        """Return the number of points in each box, to a dot."""
        most = np.array(self._sums.shape * 2) - 1
        corners = np.rint(boxes - np.tile(self._corner, 2)).astype(np.int64)
        x0, y0, x1, y1 = np.clip(corners, 0, most).T
        sums = self._sums
        counted: NDArray[np.int64] = sums[x1, y1] - sums[x0, y1] - sums[x1, y0] + sums[x0, y0]
        return counted


@dataclass
class _Drawn:
    """The content of a panel: boxes of texts and marks, points along lines, and along leaders to
    names."""

    texts: Boxes
    marks: Boxes
    lines: _Tally
    leaders: Points = field(default_factory=lambda: np.empty((0, 2)))


def place_labels(axes: Axes, labels: Sequence[ChartLabel]) -> list[ChartLabel]:
    """Draw the labels in this order; return those that found no place. The figure must be laid out
    (`sheet.lay_out`), so that nothing in it moves afterwards."""
    drawn = _drawn(axes)
    return [label for label in labels if label.text and not _written(axes, label, drawn)]


def halo() -> list[Any]:
    """Return the `path_effects` of a text that stays legible on lines."""
    from matplotlib.patheffects import withStroke

    return [withStroke(linewidth=_HALO, foreground=look().paper)]


def _written(axes: Axes, label: ChartLabel, drawn: _Drawn) -> bool:
    dots = axes.figure.dpi / 72
    text = axes.annotate(
        label.text, label.anchors[0], (0, 0), textcoords="offset points", ha="left", va="bottom",
        size=_NAME if label.name else _SMALL, weight="bold" if label.name else "normal",
        color=look().type_in(label.colour), path_effects=halo(),
    )  # fmt: skip
    text.set_in_layout(False)
    extent = text.get_window_extent()
    places = _places(axes, label, (extent.width, extent.height), dots)
    best = _cheapest(label, places, drawn, _costs(axes, label, places, drawn, dots))
    if best is None:
        text.remove()
        return False
    box, anchor, corner = places.boxes[best], places.anchors[best], places.nearest[best]
    text.xy = label.anchors[places.number[best]]
    text.set_position(tuple((box[:2] - anchor) / dots))
    if label.far and places.gaps[best] > _LEADER:
        drawn.leaders = np.vstack([drawn.leaders, _between(anchor, corner)])
        _join(axes, text, (corner - anchor) / dots, label.colour)
    drawn.texts = np.vstack([drawn.texts, box])
    return True


def _join(axes: Axes, text: Annotation, reach: Points, colour: str) -> None:
    """Draw a thin line from a text's anchor to the text, `reach` points away."""
    length = np.hypot(*reach)
    leader = axes.annotate(
        "", text.xy, tuple(reach * (1 - 1 / length)), textcoords="offset points",
        arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.7, "shrinkA": 0,
                    "shrinkB": 4, "zorder": 1.5},
    )  # fmt: skip
    leader.set_in_layout(False)


@dataclass
class _Places:
    """The candidate places of a text: its box, and the point of the box nearest to the anchor."""

    boxes: Boxes
    anchors: Points
    nearest: Points
    gaps: NDArray[np.float64]
    number: NDArray[np.int64]
    turn: NDArray[np.float64]


def _places(axes: Axes, label: ChartLabel, size: tuple[float, float], dots: float) -> _Places:
    """Return all places around all anchors; sizes and boxes in dots, gaps in points."""
    gaps = np.array(_FAR if label.far else _NEAR)
    angles = np.arange(16) * np.pi / 8
    number, gap, angle = (
        grid_values.ravel()
        for grid_values in np.meshgrid(np.arange(len(label.anchors)), gaps, angles)
    )
    anchors = axes.transData.transform(np.array(label.anchors, float))[number]
    ahead = np.column_stack([np.cos(angle), np.sin(angle)])
    # At a slant the box's corner is nearest, straight ahead the middle of its side.
    leaning = np.clip(1.6 * ahead, -1, 1) * np.array(size) / 2
    middle = anchors + ahead * (gap[:, None] + 2.5) * dots + leaning
    boxes = np.hstack([middle - np.array(size) / 2, middle + np.array(size) / 2])
    nearest = np.clip(anchors, boxes[:, :2], boxes[:, 2:])
    # Names stand to the right, other texts above or below.
    turn = 1 - np.cos(angle) if label.name else 1 - np.abs(np.sin(angle))
    return _Places(boxes, anchors, nearest, gap, number, turn)


def _costs(
    axes: Axes, label: ChartLabel, places: _Places, drawn: _Drawn, dots: float
) -> NDArray[np.float64]:
    """Return the cost of each place in points; infinite if the text would cover something or leave
    the panel."""
    boxes = places.boxes
    room = axes.bbox
    grown = boxes + _CLEAR * dots * np.array([-1, -1, 1, 1])
    free = (grown[:, :2] > [room.x0, room.y0]).all(1) & (grown[:, 2:] < [room.x1, room.y1]).all(1)
    free &= ~_overlaps(grown, drawn.marks).any(1)
    apart = boxes + dots * np.array([-_SPACE, -_LEADING, _SPACE, _LEADING])
    free &= ~_overlaps(apart, drawn.texts).any(1)
    free &= _count_inside(grown, drawn.leaders) == 0
    costs = places.gaps + _NEXT * places.number + 2 * places.turn
    covered = drawn.lines.count_in(grown)
    if not label.name:
        free &= covered == 0
    costs += _ON_LINES * (covered > 0) + _ON_LINE * covered
    middles = (drawn.marks[:, :2] + drawn.marks[:, 2:]) / 2
    own_distance = np.hypot(*(places.nearest - places.anchors).T)
    for middle in middles:
        off = np.hypot(*(np.clip(middle, boxes[:, :2], boxes[:, 2:]) - middle).T)
        costs += _ASTRAY / dots * np.maximum(own_distance - off, 0)
    return np.where(free, costs, np.inf)


def _cheapest(
    label: ChartLabel, places: _Places, drawn: _Drawn, costs: NDArray[np.float64]
) -> int | None:
    """Return the cheapest place, including the crossings of its leader; None without any."""
    best, least = None, np.inf
    for place in map(int, np.argsort(costs, kind="stable")):
        if costs[place] >= least:
            break
        cost = costs[place]
        if label.far and places.gaps[place] > _LEADER:
            leader = _between(places.anchors[place], places.nearest[place])
            if _count_inside(drawn.texts, leader).any():
                continue
            cost += _CROSSED * np.count_nonzero(drawn.lines.count_in(_around(leader, _STEP)))
        if cost < least:
            best, least = place, cost
    return best


def _drawn(axes: Axes) -> _Drawn:
    dots = axes.figure.dpi / 72
    marks, lines = [np.empty((0, 4))], [np.empty((0, 2))]
    for line in axes.lines:
        points = line.get_transform().transform(line.get_xydata())
        points = points[np.isfinite(points).all(1)]
        if line.get_marker() not in (None, "None", "", " "):
            reach = (line.get_markersize() + line.get_markeredgewidth()) / 2
            marks.append(_around(points, reach * dots))
        if line.get_linestyle() != "None":
            lines += [_between(*pair) for pair in pairwise(points)]
    texts = [text.get_window_extent().extents for text in axes.texts if text.get_text()]
    return _Drawn(np.array(texts).reshape(-1, 4), np.vstack(marks), _Tally(axes, np.vstack(lines)))


def _between(start: Points, end: Points) -> Points:
    """Return points on the line between two points."""
    steps = max(1, int(np.abs(end - start).max() / _STEP))
    return start + np.linspace(0, 1, steps + 1)[:, None] * (end - start)


def _around(points: Points, reach: float) -> Boxes:
    return np.hstack([points - reach, points + reach])


def _overlaps(boxes: Boxes, other_boxes: Boxes) -> NDArray[np.bool_]:
    """Return which boxes (n, 4) overlap which boxes (m, 4): (n, m)."""
    a, b = boxes[:, None], other_boxes[None]
    return np.asarray((a[..., :2] < b[..., 2:]).all(2) & (b[..., :2] < a[..., 2:]).all(2))


def _count_inside(boxes: Boxes, points: Points) -> NDArray[np.int64]:
    """Return the number of points in each box."""
    inside: Any = (boxes[:, None, :2] < points).all(2) & (points < boxes[:, None, 2:]).all(2)
    counted: NDArray[np.int64] = inside.sum(1)
    return counted
