"""The picture of a program: its shutters over time, and which pixel has which."""

from __future__ import annotations

import io
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.pictures import tile_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOST_ROWS = 64
_CHOSEN_ROWS = 48
_MOST_BARS = 6000
"""Above this many bars the chart is an image of the share of open time in each of its columns."""
_COLUMNS = 2400
_MOST_BOUNDARIES = 130
_MOST_LABELLED = 8
"""Cells a side of a tile map that still have room for their codes."""
_CORNER = 16
_INK, _FAINT, _GRID, _CLOSED = "#1d2129", "#6b7280", "#c9ced8", "#f1f3f6"
_BUCKETS = ("#2563a8", "#d9722b", "#2f9268", "#8a4fb5", "#c2405a", "#8c7a2d")
_DPI = 150
_WIDTH = 12.0
_MAP = 5.12
"""Inches for a side of a map: 256 pixels at three times their size."""


@dataclass(frozen=True, eq=False)
class Shutters:
    """The shutters that a picture shows, in the order in which it shows them.

    `rows` bool (rows, buckets, N); `labels` one a row; `rank` int (shutters of the table,), the
    place of each in the order, -1 for those that no pixel has.
    """

    rows: NDArray[np.bool_]
    labels: tuple[str, ...]
    rank: NDArray[np.int64]


def shutters_of(container: Container) -> Shutters:
    """The distinct shutters in use (all of a program without pixels), by opening and length."""
    table = container.table
    if container.pixel_codes is None:
        used_codes = np.arange(len(table.codes))
    else:
        used_codes = np.unique(container.pixel_codes)
    used = np.unique(table.shutter_of_code[used_codes])
    patterns = table.shutters[used]
    slots = patterns.shape[2]
    union: NDArray[np.bool_] = np.any(patterns, axis=1)
    first = np.where(np.any(union, axis=1), np.argmax(union, axis=1), slots)
    order = np.lexsort((used, (patterns[:, 0] @ np.array(container.slot_us)), first))
    rank = np.full(len(table.shutters), -1, np.int64)
    rank[used[order]] = np.arange(len(used))
    codes_by_rank: list[list[int]] = [[] for _ in used]
    for code in used_codes:
        codes_by_rank[rank[table.shutter_of_code[code]]].append(int(code))
    labels = tuple(_label(container, codes) for codes in codes_by_rank)
    return Shutters(patterns[order], labels, rank)


def _label(container: Container, codes: list[int]) -> str:
    """The first code of a shutter in words, and how many more mean the same."""
    fields = container.table.fields
    if not fields:
        return "all pixels"
    text = ", ".join(
        f"{name} {value}"
        for name, value in zip(fields, container.table.codes[codes[0]], strict=True)
    )
    text = text if len(text) <= 30 else text[:29] + "…"
    return text if len(codes) == 1 else f"{text}  (+{len(codes) - 1})"


def view_png(container: Container, title: str) -> bytes:
    """A PNG: the time chart, and below it the map of codes with a magnified tile.

    The same container gives the same bytes, whatever the user's plotting settings.
    """
    import matplotlib

    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        figure = _figure(container, shutters_of(container), title)
        data = io.BytesIO()
        figure.savefig(data, format="png", dpi=_DPI, metadata={"Software": None})
    return data.getvalue()


def _figure(container: Container, shutters: Shutters, title: str) -> Figure:
    """Everything on one sheet, in inches from its top left corner, on whole pixels."""
    from matplotlib.figure import Figure

    lanes = len(container.buckets)
    rows = len(_chosen(len(shutters.rows)))
    chart_height = max(0.6, rows * (0.21 if lanes == 1 else 0.12 * lanes + 0.08))
    chart_top, left, right = 1.2, 2.2, 0.42
    colours = _colours(len(shutters.rows))
    maps = _maps(container, shutters, colours)
    maps_top = chart_top + chart_height + 1.15
    tallest = max((m.height for m in maps), default=0.0)
    height = _whole(maps_top + tallest + 0.4 if maps else chart_top + chart_height + 0.75)
    figure = Figure(figsize=(_WIDTH, height), facecolor="white")

    def place(x: float, top: float, w: float, h: float) -> Axes:
        bottom = height - _whole(top) - _whole(h)
        box = (_whole(x) / _WIDTH, bottom / height, _whole(w) / _WIDTH, _whole(h) / height)
        return figure.add_axes(box)

    figure.text(0.3 / _WIDTH, 1 - 0.42 / height, title, size=15, weight="bold", color=_INK)
    figure.text(
        0.3 / _WIDTH, 1 - 0.68 / height, _subtitle(container, shutters), size=9.5, color=_FAINT
    )
    if lanes > 1:
        _legend(figure, container.buckets, (1 - right / _WIDTH, 1 - 0.38 / height))
    chart = place(left, chart_top, _WIDTH - left - right, chart_height)
    _draw_chart(chart, container, shutters, colours)
    x = 0.6
    for drawing in maps:
        axes = place(x, maps_top, drawing.width, drawing.height)
        _draw_map(axes, drawing)
        x += _MAP + 0.7
    return figure


def _whole(inches: float) -> float:
    """The nearest length of whole pixels: maps are magnified by whole numbers, without moire."""
    return round(inches * _DPI) / _DPI


def _subtitle(container: Container, shutters: Shutters) -> str:
    parts = []
    name = container.notes.get("class")
    if name:
        parts.append(f"class {name}" if len(name) == 1 else name)
    slots = container.slots
    lengths = container.slot_us
    if min(lengths) == max(lengths):
        parts.append(f"{slots} slot{'s' * (slots > 1)} of {_time(lengths[0])}")
    else:
        parts.append(f"{slots} slots of {_time(min(lengths))} to {_time(max(lengths))}")
    parts.append(f"{len(shutters.rows)} shutter{'s' * (len(shutters.rows) != 1)}")
    if len(container.buckets) > 1:
        parts.append(f"{len(container.buckets)} buckets")
    lowering = container.notes.get("lowering")
    parts.append(f"{container.target.name}, {lowering}" if lowering else container.target.name)
    return "   ·   ".join(parts)


def _time(us: float) -> str:
    scale, unit = _unit(us)
    return f"{us * scale:.4g} {unit}"


def _unit(us: float) -> tuple[float, str]:
    """A factor and a unit that keep a time readable."""
    if us >= 1e6:
        return 1e-6, "s"
    if us >= 1e3:
        return 1e-3, "ms"
    return (1.0, "µs") if us >= 1 else (1e3, "ns")


def _colours(count: int) -> NDArray[np.float64]:
    """RGB (count, 3), dark to light in the order of the shutters."""
    from matplotlib import colormaps

    places = np.linspace(0.08, 0.9, count) if count > 1 else np.array([0.35])
    colours: NDArray[np.float64] = colormaps["viridis"](places)[:, :3]
    return colours


def _chosen(count: int) -> NDArray[np.int64]:
    """The rows that a chart has room for: all, or some at equal distances, first and last too."""
    if count <= _MOST_ROWS:
        return np.arange(count)
    return np.rint(np.linspace(0, count - 1, _CHOSEN_ROWS)).astype(np.int64)


def _draw_chart(
    axes: Axes, container: Container, shutters: Shutters, colours: NDArray[np.float64]
) -> None:
    chosen = _chosen(len(shutters.rows))
    rows = shutters.rows[chosen]
    edges_us = np.concatenate(([0.0], np.cumsum(container.slot_us)))
    scale, unit = _unit(float(edges_us[-1]))
    edges = edges_us * scale
    lanes = rows.shape[1]
    lane_height = 0.84 / lanes
    axes.set_xlim(0, edges[-1])
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_facecolor("white")
    for number in range(len(rows)):
        axes.axhspan(number - 0.42, number + 0.42, facecolor=_CLOSED, edgecolor="none", zorder=0)
    changes = np.count_nonzero(np.diff(rows, axis=2)) // 2 + rows[:, :, 0].sum()
    for lane in range(lanes):
        bars = [
            (number - 0.42 + lane * lane_height, rows[number, lane], _bar_colour(lanes, lane, c))
            for number, c in enumerate(colours[chosen])
        ]
        draw = _draw_bars if changes <= _MOST_BARS else _draw_shares
        for bottom, opened, colour in bars:
            draw(axes, edges, opened, (bottom, lane_height), colour)
    if container.slots <= _MOST_BOUNDARIES:
        axes.vlines(edges[1:-1], -0.5, len(rows) - 0.5, colors="white", linewidth=0.7, zorder=3)
    _label_rows(axes, shutters, chosen, colours)
    _label_times(axes, edges, unit)
    if len(chosen) < len(shutters.rows):
        note = f"{len(chosen)} of {len(shutters.rows)} shutters, evenly chosen"
        axes.annotate(
            note, (1, 0), (0, -33), "axes fraction", textcoords="offset points", ha="right",
            size=9, color=_FAINT,
        )  # fmt: skip


def _bar_colour(lanes: int, lane: int, own: NDArray[np.float64]) -> Any:
    """One bucket: the colour that the map has; several: the bucket's."""
    return tuple(own) if lanes == 1 else _BUCKETS[lane % len(_BUCKETS)]


def _draw_bars(
    axes: Axes,
    edges: NDArray[Any],
    opened: NDArray[np.bool_],
    span: tuple[float, float],
    colour: Any,
) -> None:
    """A bar for each run of open slots."""
    change = np.flatnonzero(np.diff(np.concatenate(([0], opened.astype(np.int8), [0]))))
    runs = [(edges[a], edges[b] - edges[a]) for a, b in change.reshape(-1, 2)]
    axes.broken_barh(runs, span, facecolor=colour, edgecolor="none", zorder=2)


def _draw_shares(
    axes: Axes,
    edges: NDArray[Any],
    opened: NDArray[np.bool_],
    span: tuple[float, float],
    colour: Any,
) -> None:
    """Where bars would be finer than the picture: the share of open time, as opacity."""
    from matplotlib.colors import to_rgb

    open_until = np.concatenate(([0.0], np.cumsum(np.diff(edges) * opened)))
    columns = np.linspace(0.0, edges[-1], _COLUMNS + 1)
    share = np.diff(np.interp(columns, edges, open_until)) / (edges[-1] / _COLUMNS)
    image = np.empty((1, _COLUMNS, 4))
    image[..., :3] = to_rgb(colour)
    image[..., 3] = np.clip(share, 0.0, 1.0)
    extent = (0.0, float(edges[-1]), span[0] + span[1], span[0])
    axes.imshow(image, extent=extent, aspect="auto", interpolation="nearest", zorder=2)


def _label_rows(
    axes: Axes, shutters: Shutters, chosen: NDArray[np.int64], colours: NDArray[np.float64]
) -> None:
    axes.set_yticks(range(len(chosen)), [shutters.labels[i] for i in chosen], size=8.5, color=_INK)
    axes.tick_params(axis="y", length=0, pad=15)
    x = np.full(len(chosen), -0.0085)
    axes.scatter(
        x, np.arange(len(chosen)), s=46, c=colours[chosen], marker="s", clip_on=False,
        transform=axes.get_yaxis_transform(),
    )  # fmt: skip


def _label_times(axes: Axes, edges: NDArray[Any], unit: str) -> None:
    """Time below, slot numbers above, at the true lengths of the slots."""
    axes.set_xlabel(f"time in the frame ({unit})", size=9.5, color=_FAINT)
    axes.tick_params(axis="x", labelsize=8.5, colors=_FAINT, length=3)
    for side in axes.spines.values():
        side.set_visible(False)
    slots = len(edges) - 1
    step = next(s for k in range(13) for s in (2**k,) if slots / s <= 20)
    numbers = [n for n in range(0, slots, step) if _roomy(edges, n, step)]
    above = axes.secondary_xaxis("top")
    above.set_xticks((edges[numbers] + edges[np.array(numbers) + 1]) / 2, [str(n) for n in numbers])
    above.tick_params(labelsize=8.5, colors=_FAINT, length=0, pad=1)
    above.spines["top"].set_visible(False)
    above.set_xlabel("slot n", size=9.5, color=_FAINT, labelpad=4)


def _roomy(edges: NDArray[Any], slot: int, step: int) -> bool:
    """Is the distance to the next number wide enough for its digits?"""
    after = min(slot + step, len(edges) - 1)
    return bool((edges[after] - edges[slot]) / edges[-1] > 0.018) or slot + step >= len(edges) - 1


def _legend(figure: Figure, buckets: tuple[str, ...], corner: tuple[float, float]) -> None:
    from matplotlib.patches import Patch

    marks = [Patch(color=_BUCKETS[b % len(_BUCKETS)], label=n) for b, n in enumerate(buckets)]
    figure.legend(
        handles=marks, loc="upper right", bbox_to_anchor=corner, ncols=len(marks), frameon=False,
        fontsize=9.5, borderaxespad=0, labelcolor=_INK, columnspacing=1.4, handlelength=1.0,
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Map:
    """A part of the array to draw: colours (rows, cols, 3), the codes' values where they fit."""

    title: str
    colours: NDArray[np.float64]
    values: list[list[list[str]]]
    grid: bool

    @property
    def zoom(self) -> float:
        """Pixels of the sheet for a pixel of the array: a whole number where there is room."""
        room = _MAP * _DPI / max(self.colours.shape[:2])
        return float(int(room)) if room >= 1 else room

    @property
    def width(self) -> float:
        """Inches."""
        return int(self.colours.shape[1]) * self.zoom / _DPI

    @property
    def height(self) -> float:
        """Inches."""
        return int(self.colours.shape[0]) * self.zoom / _DPI


def _maps(
    container: Container, shutters: Shutters, colours: NDArray[np.float64]
) -> tuple[_Map, ...]:
    """The array, and the smallest tile of codes that repeats; its corner if none does."""
    codes = container.pixel_codes
    if codes is None:
        return ()
    table = container.table
    painted = colours[shutters.rank[table.shutter_of_code[codes]]]
    rows, cols = codes.shape
    whole = _Map(f"codes of the array, {rows} x {cols}", painted, [], grid=False)
    tile = tile_of(codes)
    if not table.fields or (rows, cols) == (1, 1):
        return (whole,)
    if tile != (rows, cols) and max(tile) <= 4 * _CORNER:
        title = f"the tile that repeats, {tile[0]} x {tile[1]}"
    else:
        tile = (min(_CORNER, rows), min(_CORNER, cols))
        title = f"the top left corner, {tile[0]} x {tile[1]}"
    values = []
    if max(tile) <= _MOST_LABELLED:
        part = table.codes[codes[: tile[0], : tile[1]]]
        values = [[[str(v) for v in cell] for cell in row] for row in part]
    grid = max(tile) <= 2 * _CORNER
    return whole, _Map(title, painted[: tile[0], : tile[1]], values, grid)


def _draw_map(axes: Axes, drawing: _Map) -> None:
    rows, cols = drawing.colours.shape[:2]
    axes.imshow(drawing.colours, interpolation="nearest", aspect="auto", extent=(0, cols, rows, 0))
    if drawing.grid:
        axes.hlines(range(1, rows), 0, cols, colors="white", linewidth=1.0)
        axes.vlines(range(1, cols), 0, rows, colors="white", linewidth=1.0)
    _label_cells(axes, drawing)
    axes.set_title(drawing.title, size=10.5, color=_INK, loc="left", pad=7)
    axes.tick_params(labelsize=8, colors=_FAINT, length=2, color=_GRID)
    for axis, count in ((axes.xaxis, cols), (axes.yaxis, rows)):
        # Short axes get no numbers that would lie on top of each other.
        step = next(s for s in (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1 << 30) if count / s <= 8)
        step = step if count * drawing.zoom > 40 else 1 << 30
        numbers = range(0, count, step)
        axis.set_ticks([n + 0.5 for n in numbers], [str(n) for n in numbers])
    for side in axes.spines.values():
        side.set_color(_GRID)


def _label_cells(axes: Axes, drawing: _Map) -> None:
    """Each cell's field values, one a line, in white or ink, whichever reads better."""
    if not drawing.values:
        return
    widest = max(len(v) for row in drawing.values for cell in row for v in cell)
    lines = max(len(cell) for row in drawing.values for cell in row)
    size = min(20.0, 0.45 * drawing.zoom / max(0.7 * widest, 1.3 * lines, 1.6))
    if size < 4.5:
        return
    for r, row in enumerate(drawing.values):
        for c, cell in enumerate(row):
            light = drawing.colours[r, c] @ np.array([0.2126, 0.7152, 0.0722]) > 0.5
            axes.text(
                c + 0.5, r + 0.5, "\n".join(cell), ha="center", va="center", size=size,
                color=_INK if light else "white",
            )  # fmt: skip
