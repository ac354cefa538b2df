"""Place texts beside the marks and lines that they belong to.

Every text takes the first free position around its anchors, from near to far: inside the panel, and
not on a text, mark or line. The name of a line may be written on other lines if there is no free
position."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.pictures.sheet import look

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.path import Path

Points = NDArray[np.float64]
"""Coordinates (n, 2): x and y in dots."""
Boxes = NDArray[np.float64]
"""Rectangles (n, 4): left, bottom, right and top in dots."""

_NAME, _SMALL = 7.8, 7.0
"""Font size of names, and of other texts, in points."""
_NEAR, _FAR = (3.0, 5.5, 8.5), (4.0, 7.0, 11.0, 16.0, 22.0, 30.0, 40.0, 52.0, 66.0)
"""Distances in points between a mark and its text, and for texts that may be further away."""
_LEADER = 9.0
"""A text further away than this distance in points is joined to its anchor by a line."""
_HALO = 2.0
"""Width in points of the outline of letters, half of which is outside the letters."""
_CLEAR = np.array([-1.0, -1.0, 1.0, 1.0]) * (_HALO / 2 + 0.8)
"""Margin in points around a text, so that its outline covers no line."""
_APART = np.array([-4.0, -1.0, 4.0, 1.0])
"""Distance in points between texts, horizontally and vertically."""
_ANCHOR, _TURN, _ASTRAY = 5.0, 2.0, 2.0
"""Costs in points of distance: of a later anchor, of a less usual direction, and per point by which
the text is nearer to another mark than to its own."""


@dataclass(frozen=True)
class ChartLabel:
    """A text to place beside one of its `anchors` (x, y) in data coordinates, best first.

    `name`: whether it is the name of a line, which is larger. `sought`: whether readers look for
    it. Both kinds may be further away, joined to their anchor by a thin line."""

    text: str
    anchors: Sequence[tuple[float, float]]
    colour: str
    name: bool = False
    sought: bool = False

    @property
    def far(self) -> bool:
        """Whether the text may be far from its anchor."""
        return self.name or self.sought


def place_labels(axes: Axes, labels: Sequence[ChartLabel]) -> list[ChartLabel]:
    """Write the labels in this order, and return those for which there is no free position. The
    figure must have its final layout (`sheet.lay_out`)."""
    drawn = _Drawn(axes)
    return [label for label in labels if label.text and not drawn.write(label)]


def halo() -> list[Any]:
    """Return the `path_effects` of a text that stays legible on lines."""
    from matplotlib.patheffects import withStroke

    return [withStroke(linewidth=_HALO, foreground=look().paper)]


class _Drawn:
    """The content of a panel: boxes of its texts and marks, its lines, and leaders to texts."""

    def __init__(self, axes: Axes) -> None:
        self.axes, self.dots = axes, axes.figure.dpi / 72
        texts = [text.get_window_extent().extents for text in axes.texts if text.get_text()]
        self.texts = np.array(texts).reshape(-1, 4)
        self.lines: list[Path] = []
        self.leaders: list[Path] = []
        marks = [np.empty((0, 4))]
        for line in axes.lines:
            path = line.get_path().transformed(line.get_transform())
            if line.get_linestyle() != "None":
                self.lines.append(path)
            if line.get_marker() not in (None, "None", "", " "):
                reach = self.dots * (line.get_markersize() + line.get_markeredgewidth()) / 2
                points = np.asarray(path.vertices, float)
                points = points[np.isfinite(points).all(1)]
                marks.append(np.hstack([points - reach, points + reach]))
        self.marks = np.vstack(marks)

    def write(self, label: ChartLabel) -> bool:
        """Write a label if there is a free position for it, and return whether there is."""
        text = self.axes.annotate(
            label.text, label.anchors[0], (0, 0), textcoords="offset points", ha="left",
            va="bottom", size=_NAME if label.name else _SMALL, color=look().type_in(label.colour),
            weight="bold" if label.name else "normal", path_effects=halo(),
        )  # fmt: skip
        text.set_in_layout(False)
        extent = text.get_window_extent()
        place = self._place(label, np.array([extent.width, extent.height]))
        if place is None:
            text.remove()
            return False
        number, anchor, box = place
        text.xy = label.anchors[number]
        text.set_position(tuple((box[:2] - anchor) / self.dots))
        nearest = np.clip(anchor, box[:2], box[2:])
        if label.far and np.hypot(*(nearest - anchor)) > _LEADER * self.dots:
            self.leaders.append(_segment(anchor, nearest))
            self.axes.annotate(
                "", text.xy, tuple((nearest - anchor) / self.dots), textcoords="offset points",
                arrowprops={"arrowstyle": "-", "color": label.colour, "linewidth": 0.7,
                            "shrinkA": 1, "shrinkB": 4, "zorder": 1.5},
            ).set_in_layout(False)  # fmt: skip
        self.texts = np.vstack([self.texts, box])
        return True

    def _place(self, label: ChartLabel, size: Points) -> tuple[int, Points, Points] | None:
        """Return the best free position: the number of its anchor, the anchor, and the text's box
        in dots; None if there is none."""
        numbers, anchors, boxes, costs = self._places(label, size)
        room = self.axes.bbox
        clear = boxes + self.dots * _CLEAR
        inside = (clear[:, :2] > room.min) & (clear[:, 2:] < room.max)
        free: NDArray[np.bool_] = np.asarray(inside.all(1))
        free &= ~_overlaps(clear, self.marks).any(1)
        free &= ~_overlaps(boxes + self.dots * _APART, self.texts).any(1)
        order = [k for k in np.argsort(costs, kind="stable").tolist() if free[k]]
        for lines in [self.lines, []] if label.name else [self.lines]:
            for k in order:
                if _cross([*lines, *self.leaders], clear[k : k + 1]):
                    continue
                nearest = np.clip(anchors[k], boxes[k, :2], boxes[k, 2:])
                if not label.far or not _cross([_segment(anchors[k], nearest)], self.texts):
                    return int(numbers[k]), anchors[k], boxes[k]
        return None

    def _places(
        self, label: ChartLabel, size: Points
    ) -> tuple[NDArray[np.int64], Points, Boxes, Any]:
        """Return all positions around all anchors, with the cost of each in points."""
        gaps = np.array(_FAR if label.far else _NEAR)
        numbers, gap, angle = (
            axis.ravel()
            for axis in np.meshgrid(np.arange(len(label.anchors)), gaps, np.arange(16) * np.pi / 8)
        )
        anchors = self.axes.transData.transform(np.array(label.anchors, float))[numbers]
        ahead = np.column_stack([np.cos(angle), np.sin(angle)])
        # In a diagonal direction the box's corner is nearest, otherwise the middle of its side.
        leaning = np.clip(1.6 * ahead, -1, 1) * size / 2
        middle = anchors + ahead * (gap[:, None] + 2.5) * self.dots + leaning
        boxes = np.hstack([middle - size / 2, middle + size / 2])
        # Names continue a line to the right, other texts are above or below.
        turn = 1 - np.cos(angle) if label.name else 1 - np.abs(np.sin(angle))
        costs = gap + _ANCHOR * numbers + _TURN * turn
        anchor_distances = _distances(boxes, anchors)
        for mark in (self.marks[:, :2] + self.marks[:, 2:]) / 2:
            costs += _ASTRAY / self.dots * np.maximum(anchor_distances - _distances(boxes, mark), 0)
        return numbers, anchors, boxes, costs


def _distances(boxes: Boxes, points: Points) -> NDArray[np.float64]:
    nearest = np.clip(points, boxes[:, :2], boxes[:, 2:])
    return np.asarray(np.hypot(*(nearest - points).T))


def _overlaps(boxes_a: Boxes, boxes_b: Boxes) -> NDArray[np.bool_]:
    """Return a mask (n, m): which of the boxes (n, 4) overlap which of the boxes (m, 4)."""
    a, b = boxes_a[:, None], boxes_b[None]
    return np.asarray((a[..., :2] < b[..., 2:]).all(2) & (b[..., :2] < a[..., 2:]).all(2))


def _segment(start: Points, end: Points) -> Path:
    from matplotlib.path import Path

    return Path(np.array([start, end]))


def _cross(paths: Sequence[Path], boxes: Boxes) -> bool:
    """Return whether one of the paths crosses one of the boxes."""
    from matplotlib.transforms import Bbox

    bboxes = [Bbox(box.reshape(2, 2)) for box in boxes]
    return any(path.intersects_bbox(box, filled=False) for path in paths for box in bboxes)
