"""Draw a program: its shutters over time, and their arrangement on the array."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from nscc.arrays import Array, Bools, Floats
from nscc.words.container import Container, tile_of
from nscc.words.shutters import Shutters, shutters_of
from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.sheet import theme
from nscc_runtime.run_kinds import KINDS

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOST_ROWS, _CHOSEN_ROWS = 64, 48
"""Largest number of shutters of which all are drawn, and number of those drawn of more."""
_COLUMNS = 1200
"""Largest number of columns of a chart. With more slots, a column shows its open fraction."""
_MOST_BOUNDARIES = 130
_MOST_NUMBERS = 16
"""Largest numbers of slots with lines between them, and of slots with numbers."""
_MOST_LABELLED = 8
"""Largest number of cells per side of a tile map with printed codes."""
_CORNER = 16
"""Number of cells per side of the corner that is shown of an array without a tile."""
_MAP, _BETWEEN = 3.5, 0.6
CHART_INCHES = 2 * _MAP + _BETWEEN
"""Inches: side of a map, gap between maps, width of the chart."""
_ABOVE, _BELOW = 0.36, 1.0
"""Inches: numbers of the slots above the chart, gap from the chart to the maps."""
_BAR = 0.84
"""Height of a bar; rows are 1 apart."""


def shutter_sheet(container: Container, title: str) -> Figure:
    """Return a drawing of a program under `title`: the time chart of its shutters, and below it the
    map of codes with a magnified tile, or the data flow of images and planes."""
    from matplotlib import colormaps

    shutters = shutters_of(container)
    count, lanes = len(shutters.rows), len(container.buckets)
    # All rows, or some at equal distances, including first and last.
    chosen = np.arange(count)
    if count > _MOST_ROWS:
        chosen = np.rint(np.linspace(0, count - 1, _CHOSEN_ROWS)).astype(np.int64)
    shades = np.linspace(0.08, 0.9, count) if count > 1 else np.array([0.35])
    colours = colormaps[sheet.SCALE](shades)[:, :3]
    chart_height = max(0.6, len(chosen) * (0.19 if lanes == 1 else 0.11 * lanes + 0.07))
    flow = KINDS.of(container).flow(container, CHART_INCHES)
    maps = [] if flow is not None and count == 1 else _maps(container, shutters, colours)
    top = _ABOVE + chart_height + _BELOW
    sizes = [sheet.zoomed(tile_map.colours.shape, _MAP) for tile_map in maps]
    flow_top = top + max((height + _BELOW for _, height in sizes), default=0.0)
    height = flow_top + flow.height if flow is not None else flow_top - _BELOW * bool(sizes)
    figure = sheet.blank(CHART_INCHES, height)
    chart = sheet.place(figure, 0, _ABOVE, CHART_INCHES, chart_height)
    _draw_chart(chart, container, shutters.rows[chosen], colours[chosen])
    chart.set_yticks(range(len(chosen)), [shutters.labels[i] for i in chosen])
    for number, (drawing, size) in enumerate(zip(maps, sizes, strict=True)):
        _draw_map(sheet.place(figure, number * (_MAP + _BETWEEN), top, *size), drawing)
    if flow is not None:
        flow.draw(figure, flow_top)
    note = subtitle(container, f"{count} shutter{'s' * (count != 1)}")
    if len(chosen) < count:
        note += f"   ·   {len(chosen)} of them shown, evenly chosen"
    sheet.head(figure, title, note, bucket_handles(container))
    return figure


def bucket_handles(container: Container) -> list[Artist]:
    """Return an entry of the legend for each bucket of a program; none for an only bucket."""
    from matplotlib.patches import Patch

    names = container.buckets if len(container.buckets) > 1 else ()
    return [Patch(color=theme().of(b)["color"], label=name) for b, name in enumerate(names)]


def subtitle(container: Container, subject: str) -> str:
    """Return a line with a program's class, frame and chip, and the `subject` of the picture, such
    as the number of shutters. What the program does not tell is left out."""
    lengths, lowering = container.slot_us, container.notes.get("lowering")
    length = _time(min(lengths))
    if min(lengths) < max(lengths):
        length += f" to {_time(max(lengths))}"
    name = container.notes.get("class", "")
    phrases = (
        f"class {name}" if len(name) == 1 else name,
        f"{container.slots} slot{'s' * (container.slots > 1)} of {length}",
        subject,
        f"{len(container.buckets)} buckets" if len(container.buckets) > 1 else "",
        f"{container.target.name}, {lowering}" if lowering else container.target.name,
    )
    return "   ·   ".join(phrase for phrase in phrases if phrase)


def _time(us: float) -> str:
    """Return a time of `us` microseconds as text with a suitable unit and four digits."""
    scale, name = unit(us)
    return f"{us * scale:.4g} {name}"


def unit(us: float) -> tuple[float, str]:
    """Return a factor and a unit with which a time of `us` microseconds is written in few digits:
    `us` times the factor is in s, ms, µs or ns."""
    if us >= 1e6:
        return 1e-6, "s"
    if us >= 1e3:
        return 1e-3, "ms"
    return (1.0, "µs") if us >= 1 else (1e3, "ns")


def _draw_chart(axes: Axes, container: Container, rows: Bools, row_colours: Floats) -> None:
    """Draw the open time of each shutter as a bar, into `axes`. `rows` bool (shutters, buckets,
    slots) are the shutters. `row_colours` (shutters, 3) are their colours in the map, used for the
    bars if there is one bucket."""
    from matplotlib.colors import to_rgb

    count, lanes, slots = rows.shape
    edges, columns = time_axis(axes, container)
    buckets = [to_rgb(theme().of(lane)["color"]) for lane in range(lanes)]
    image = np.empty((count, lanes + 1, len(columns) - 1, 3))
    image[:] = to_rgb(theme().paper)  # the colour of the gap, the last lane
    # A column may cover several slots; its colour says for which part of its time the shutter is
    # open.
    for row, lane in np.ndindex(count, lanes):
        share = open_share(rows[row, lane], edges, columns)
        colour = row_colours[row] if lanes == 1 else buckets[lane]
        image[row, lane] = np.outer(1 - share, to_rgb(theme().closed)) + np.outer(share, colour)
    lines = np.linspace(-_BAR / 2, _BAR / 2, lanes + 1)
    heights = (np.arange(count)[:, None] + lines).ravel()
    axes.pcolorfast(columns, heights, image.reshape(count * (lanes + 1), -1, 3)[:-1].clip(0, 1))
    axes.set_ylim(count - 0.5, -0.5)
    if slots <= _MOST_BOUNDARIES:
        axes.vlines(edges[1:-1], -0.5, count - 0.5, colors=theme().paper, linewidth=0.7)
    axes.tick_params(axis="y", length=0, pad=13, labelcolor=theme().ink)
    axes.scatter(
        np.full(count, -0.009),
        np.arange(count),
        s=36,
        c=row_colours,
        marker="s",
        clip_on=False,
        transform=axes.get_yaxis_transform(),
    )
    _number_slots(axes, edges)


def time_axis(axes: Axes, container: Container) -> tuple[Floats, Floats]:
    """Let `axes` show time in the frame of `container` to the right, without grid and spines.
    Return in units of its label the times at the edges of the slots (N + 1,), and at the edges of
    the columns of a chart: the same, or 1201 evenly spaced ones if there are more."""
    edges_us = np.concatenate(([0.0], np.cumsum(container.slot_us)))
    scale, name = unit(float(edges_us[-1]))
    edges = edges_us * scale
    axes.set_xlim(0, edges[-1])
    axes.set_xlabel(f"time in the frame, {name}")
    axes.grid(False)
    axes.spines[:].set_visible(False)
    return edges, edges if len(edges) <= _COLUMNS + 1 else np.linspace(0, edges[-1], _COLUMNS + 1)


def open_share(opened: Bools, edges: Floats, columns: Floats) -> Floats:
    """Return the fraction (columns,) of each column of a chart for which a shutter is open.
    `opened` bool (N,): its open slots. `edges` (N + 1,), `columns` (columns + 1,): times at the
    edges of slots and of columns."""
    open_until = np.concatenate(([0.0], np.cumsum(np.diff(edges) * opened)))
    # The open time up to each edge of a column, by interpolation within slots.
    return np.diff(np.interp(columns, edges, open_until)) / np.diff(columns)


def _number_slots(axes: Axes, edges: Floats) -> None:
    """Write slot numbers above `axes`, only as many as there is room for. `edges` (N + 1,): times
    at the edges of the slots."""
    slots = len(edges) - 1
    # A power of two, with which at most `_MOST_NUMBERS` slots have numbers.
    step = 1 << max(0, (slots - 1) // _MOST_NUMBERS).bit_length()
    middles = (edges[:-1] + edges[1:]) / 2
    numbers: list[int] = []
    for number in range(0, slots, step):
        if not numbers or middles[number] - middles[numbers[-1]] > 0.045 * edges[-1]:
            numbers.append(number)
    above = axes.secondary_xaxis("top")
    above.set_xticks(middles[numbers], [str(number) for number in numbers])
    above.tick_params(length=0, pad=1)
    above.spines[:].set_visible(False)
    above.set_xlabel("slot n")


@dataclass(frozen=True, eq=False)
class _Map:
    """A part of the array: colours (rows, cols, 3), 0..1, and the values of the fields of codes
    (rows, cols, fields), None if they do not fit."""

    title: str
    colours: Floats
    codes: Array | None = None


def _maps(container: Container, shutters: Shutters, colours: Floats) -> tuple[_Map, ...]:
    """Return maps of the pixel codes of `container`: of the whole array, and of the smallest
    repeating tile or of a corner. `colours` (shutters, 3) are those of its `shutters`.

    A program without pixel codes has no map; an array of one pixel, or without fields, has only the
    first."""
    codes = container.pixel_codes
    if codes is None:
        return ()
    table = container.table
    painted = colours[shutters.rank[table.shutter_of_code[codes]]]
    rows, cols = codes.shape
    array_map = _Map(f"codes of the array, {rows} x {cols}", painted)
    if not table.fields or (rows, cols) == (1, 1):
        return (array_map,)
    tile = tile_of(codes)
    if tile != (rows, cols) and max(tile) <= 4 * _CORNER:
        title = f"the tile that repeats, {tile[0]} x {tile[1]}"
    else:
        tile = (min(_CORNER, rows), min(_CORNER, cols))
        title = f"the top left corner, {tile[0]} x {tile[1]}"
    tile_slice = np.s_[: tile[0], : tile[1]]
    values = table.codes[codes[tile_slice]] if max(tile) <= _MOST_LABELLED else None
    return array_map, _Map(title, painted[tile_slice], values)


def _draw_map(axes: Axes, drawing: _Map) -> None:
    """Draw the map `drawing` into `axes`, with the field values in each cell, one per line, if the
    cells are large enough."""
    from matplotlib.colors import to_hex
    from matplotlib.ticker import MaxNLocator

    rows, cols = drawing.colours.shape[:2]
    sheet.show_pixels(axes, drawing.colours)
    axes.set_title(drawing.title)
    axes.spines[:].set_visible(False)
    extent = axes.get_window_extent()
    for axis, dots in ((axes.xaxis, extent.width), (axes.yaxis, extent.height)):
        axis.set_major_locator(MaxNLocator(max(1, int(dots / 55)), integer=True, min_n_ticks=1))
        axis.set_visible(dots > 55)
    if max(rows, cols) <= 2 * _CORNER:
        axes.hlines(np.arange(rows - 1) + 0.5, -0.5, cols - 0.5, colors=theme().paper)
        axes.vlines(np.arange(cols - 1) + 0.5, -0.5, rows - 0.5, colors=theme().paper)
    if drawing.codes is None:
        return
    widest = max(len(str(value)) for value in drawing.codes.flat)
    cell = extent.width / cols / sheet.DPI * 72
    size = min(18.0, 0.9 * cell / max(0.7 * widest, 1.3 * drawing.codes.shape[2], 1.6))
    for row, col in np.ndindex(rows, cols):
        # Smaller type is not legible: the cells stay empty.
        if size >= 4.5:
            axes.text(
                col,
                row,
                "\n".join(map(str, drawing.codes[row, col])),
                ha="center",
                va="center",
                size=size,
                color=theme().on(to_hex(tuple(drawing.colours[row, col]))),
            )
