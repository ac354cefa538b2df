"""What a figure shows, as lines of text, and its comparison with a recorded description.

A description lists the marks of each axes in the units of its data and the texts by their place in
inches. `pytest --update-cases` writes the descriptions again; look at the pictures first.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import Collection
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.text import Text
from matplotlib.transforms import BboxBase
from recorded import compare_with_recorded

_MOST_NUMBERS = 12
"""Longer arrays are described by their size and by weighted means of their numbers."""


def compare_figure(figure: Figure, name: str, update: bool) -> None:
    """Assert that a figure, drawn before, shows what is recorded under a name."""
    shown = "\n".join(description(figure)) + "\n"
    # Other versions of the drawing library measure type a little differently.
    compare_with_recorded(
        shown, f"figures/{name.replace(' ', '_')}", update, share=2e-3, spare=0.02
    )


def description(figure: Figure) -> Iterator[str]:
    """Describe all visible artists of a figure."""
    yield f"figure {_numbers(figure.get_size_inches())}"
    for text in figure.texts:
        yield _text(text)
    for legend in figure.legends:
        yield f"legend {_inches(figure, legend.get_window_extent())}"
        for handle, text in zip(legend.legend_handles, legend.get_texts(), strict=True):
            yield from _mark(handle)
            yield _text(text)
    for axes in figure.axes:
        for part in (axes, *axes.child_axes):
            yield from _axes(figure, part)


def _axes(figure: Figure, axes: Axes) -> Iterator[str]:
    yield f"axes {_inches(figure, axes.get_window_extent())} {'on' if axes.axison else 'off'}"
    for axis in (axes.xaxis, axes.yaxis):
        low, high = axis.get_view_interval()
        ticks = [t for t in axis.get_major_ticks() if low <= t.get_loc() <= high]
        labels = [t.label1.get_text() for t in ticks]
        yield f"axis {axis.get_scale()} {_numbers([low, high])} {axis.label.get_text()!r} {labels}"
        grid = {
            f"grid {_colour(line.get_color())} {line.get_linewidth():g}"
            for line in axis.get_gridlines()
            if line.get_visible()
        }
        yield " ".join([f"ticks {_numbers([t.get_loc() for t in ticks])}", *sorted(grid)])
    for artist in axes.get_children():
        if artist.get_visible():
            yield from _mark(artist)


def _mark(artist: Artist | None) -> Iterator[str]:
    match artist:
        case Line2D():
            line = f"line {_numbers(artist.get_xydata())} {_colour(artist.get_color())}"
            marker = f"{artist.get_marker()} {_colour(artist.get_markerfacecolor())}"
            width = _numbers([artist.get_linewidth(), artist.get_markersize()])
            yield f"{line} {artist.get_linestyle()} {width} {marker}"
        case Text() if artist.get_text().strip():
            yield _text(artist)
        case AxesImage():
            extent = _numbers(artist.get_extent())
            yield f"image {_numbers(artist.get_array())} {extent} {artist.cmap.name}"
        case Collection():
            paths = [np.asarray(path.vertices) for path in artist.get_paths()]
            yield f"collection {_numbers(np.concatenate([np.zeros((0, 2)), *paths]))}"
            yield f"at {_numbers(artist.get_offsets())} size {_numbers(artist.get_linewidths())}"
            yield f"fill {_numbers(artist.get_facecolor())} edge {_numbers(artist.get_edgecolor())}"
        case Patch():
            path = artist.get_patch_transform().transform_path(artist.get_path())
            fill = f"{_colour(artist.get_facecolor())} {_colour(artist.get_edgecolor())}"
            yield f"patch {_numbers(path.vertices)} {fill} {_numbers([artist.get_linewidth()])}"


def _text(text: Text) -> str:
    figure = text.get_figure(root=True)
    assert figure is not None
    place = _inches(figure, text.get_window_extent())
    looks = f"{_colour(text.get_color())} {_numbers([text.get_fontsize()])} {text.get_weight()}"
    return f"text {text.get_text()!r} {place} {looks}"


def _inches(figure: Figure, box: BboxBase) -> str:
    return _numbers(np.array(box.extents) / figure.dpi)


def _colour(colour: Any) -> str:
    return str(colour) if isinstance(colour, str) and colour == "none" else to_hex(colour, True)


def _numbers(values: Any) -> str:
    array = np.ma.filled(np.ma.asarray(values, np.float64), np.nan).ravel()
    if len(array) > _MOST_NUMBERS:
        finite = np.nan_to_num(array, nan=0.0, posinf=0.0, neginf=0.0)
        place = np.arange(len(array))
        weights = (np.ones(len(array)), np.sqrt(1.0 + place), 1.0 + place % 7)
        array = np.array([np.average(finite, weights=weight) for weight in weights])
        return f"{place.size} numbers, means [{_listed(array)}]"
    return f"[{_listed(array)}]"


def _listed(array: Any) -> str:
    return " ".join(f"{value:.6g}" for value in array)
