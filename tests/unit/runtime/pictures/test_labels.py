"""Labels of pictures: what has room is to be read, and covers nothing."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.path import Path

from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.labels import ChartLabel, place_labels
from nscc_runtime.pictures.sheet import theme

PLACES = st.tuples(st.floats(0, 1), st.floats(0, 1))
LINES = st.lists(st.lists(PLACES, min_size=1, max_size=6), min_size=1, max_size=9)


@settings(deadline=None, max_examples=25)
@given(LINES, st.integers(1, 30), st.floats(1.2, 5))
def test_labels_never_cover_anything(
    lines: list[list[tuple[float, float]]], long: int, wide: float
) -> None:
    """No text or halo covers another text, a mark or the edge, whatever is drawn. No leader crosses
    a text, and no small text lies on a line."""
    with sheet.style():
        figure, [axes] = sheet.panels(1, (wide, 2.5), 1)
        axes.set(xlim=(-0.1, 1.1), ylim=(-0.1, 1.1))
        labels = []
        for number, points in enumerate(lines):
            own = theme().of(number)
            axes.plot(*zip(*points, strict=True), **own)
            labels.append(ChartLabel("m" * long, *points[-1], own["color"], name=True))
            labels += [
                ChartLabel(f"s{at}", *point, own["color"]) for at, point in enumerate(points)
            ]
        sheet.lay_out(figure)
        left_out = place_labels(axes, labels)
        texts = [text for text in axes.texts if text.get_text()]
        boxes = [text.get_window_extent() for text in texts]
    assert len(texts) + len(left_out) == len(labels)
    point = figure.dpi / 72
    halos = [box.padded(point) for box in boxes]
    assert all(axes.bbox.x0 <= box.x0 and box.x1 <= axes.bbox.x1 for box in halos)
    assert all(axes.bbox.y0 <= box.y0 and box.y1 <= axes.bbox.y1 for box in halos)
    assert not any(a.padded(3 * point, 0).overlaps(b) for a, b in combinations(boxes, 2))
    marks = axes.transData.transform([point for points in lines for point in points])
    assert not any(box.padded(2 * point).contains(*mark) for box in halos for mark in marks)
    drawn = [Path(axes.transData.transform(points)) for points in lines if len(points) > 1]
    small = [halo for halo, text in zip(halos, texts, strict=True) if text.get_text()[0] == "s"]
    assert not any(path.intersects_bbox(box, filled=False) for path in drawn for box in small)


@pytest.mark.parametrize("across", np.linspace(0.7, 0.9, 9))
def test_names_keep_off_lines_and_from_each_other(across: float) -> None:
    """Two names at one height beside a line across the panel, which has room for both."""
    with sheet.style():
        figure, [axes] = sheet.panels(1, (3, 2), 1)
        axes.set(xlim=(0, 1), ylim=(0, 1))
        axes.axvline(across)
        labels = [ChartLabel(f"a name {x}", x, 0.5, theme().ink, name=True) for x in (0.26, 0.52)]
        for label in labels:
            axes.plot(label.x, label.y, "o")
        sheet.lay_out(figure)
        assert not place_labels(axes, labels)
        one, other = (t.get_window_extent() for t in axes.texts if t.get_text())
    halo = figure.dpi / 72
    assert not one.padded(3 * halo, 0).overlaps(other)
    line = axes.transData.transform((across, 0.5))[0]
    assert not any(box.x0 - halo < line < box.x1 + halo for box in (one, other))


def test_labels_that_must_appear_move_away_with_a_line() -> None:
    """Marks and lines leave no room beside the label's own place; texts of other labels are left
    out."""
    with sheet.style():
        figure, [axes] = sheet.panels(1, (4, 3), 1)
        axes.set(xlim=(0, 1), ylim=(0, 1))
        x, y = np.meshgrid(np.linspace(0.4, 0.6, 9), np.linspace(0.4, 0.6, 7))
        axes.plot(x.ravel(), y.ravel(), "o", markersize=12, fillstyle="none")
        sheet.lay_out(figure)
        plain = ChartLabel("edges, -O0", 0.5, 0.5, theme().ink)
        sought = replace(plain, sought=True)
        assert place_labels(axes, [plain]) == [plain]
        assert place_labels(axes, [sought]) == []
        assert (len(axes.texts), len(axes.lines)) == (1, 2), "the text, and a line to its mark"


def test_a_label_without_room_is_returned_and_not_drawn() -> None:
    with sheet.style():
        figure, [axes] = sheet.panels(1, (2, 2), 1)
        sheet.lay_out(figure)
        long = ChartLabel(
            "a name that is longer than its panel is wide", 0.5, 0.5, theme().ink, True
        )
        assert place_labels(axes, [long]) == [long]
        assert not axes.texts
