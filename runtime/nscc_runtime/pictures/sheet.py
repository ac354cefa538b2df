"""Common parts of all pictures: type, heading, placement in inches, and saving.

A kind of picture is a function that returns a matplotlib figure of the size of its panels.
Headings, legends and row names extend outside the panels, and saving includes them."""

from __future__ import annotations

import io
import logging
import textwrap
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, ParamSpec

import numpy as np

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import rejected
from nscc.mappings import NamedValues
from nscc_runtime.scenes.colour import luminance, srgb_to_linear

MARKERS = "osD^vP"
"""Markers of series. Their number is coprime with that of the series colours, so 42 series differ
in colour or marker."""
_LEGIBLE = 4.5
"""Smallest contrast of small type (Web Content Accessibility Guidelines 2.2, 1.4.3)."""


@dataclass(frozen=True)
class Theme:
    """The colours of a picture, all as `#rrggbb`.

    `paper`: background. `ink`, `faint`: type. `grid`: thinnest lines. `closed`: empty areas. `bar`:
    bars behind marks. `series`: seven colours that colour-blind readers can distinguish."""

    paper: str
    ink: str
    faint: str
    grid: str
    closed: str
    bar: str
    series: tuple[str, ...]

    def of(self, number: int) -> NamedValues:
        """Return the colour and the marker of series `number`, as arguments for matplotlib."""
        return {
            "color": self.series[number % len(self.series)],
            "marker": MARKERS[number % len(MARKERS)],
        }

    def type_in(self, colour: str) -> str:
        """Return `colour` (#rrggbb), mixed with ink until small type in it is legible on the
        background."""
        # The last step is ink itself, which is legible.
        mixed = (_mix(colour, self.ink, step / 20) for step in range(21))
        return next(shade for shade in mixed if contrast(shade, self.paper) >= _LEGIBLE)

    def on(self, colour: str) -> str:
        """Return the more legible type colour, ink or paper, on an area of `colour` (#rrggbb)."""
        return max(self.ink, self.paper, key=lambda type_: contrast(type_, colour))


LIGHT = Theme(
    paper="#ffffff",
    ink="#1d2129",
    faint="#5b6270",
    grid="#e3e7ee",
    closed="#f1f3f6",
    bar="#bcc8da",
    # The colours of Okabe and Ito, except yellow, which is illegible on white.
    series=("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#1d2129", "#56b4e9", "#e69f00"),
)
DARK = Theme(
    paper="#131416",
    ink="#e6e9ee",
    faint="#a3abb8",
    grid="#2c3037",
    closed="#22252b",
    bar="#46536b",
    series=("#1f78c8", "#e0682f", "#12a87c", "#d588b4", "#e6e9ee", "#8ccbf5", "#f0b429"),
)
THEMES = {"light": LIGHT, "dark": DARK}

_current: ContextVar[Theme] = ContextVar("theme", default=LIGHT)


def theme() -> Theme:
    """Return the colours of the pictures being drawn."""
    return _current.get()


@contextmanager
def themed(chosen: Theme) -> Iterator[None]:
    """Draw and save the pictures of a `with` block in the colours of `chosen`."""
    before = _current.set(chosen)
    try:
        yield
    finally:
        _current.reset(before)


def contrast(colour: str, other_colour: str) -> float:
    """Return the contrast of two colours (#rrggbb), 1 to 21, as the WCAG defines it; their order
    does not matter."""
    dark, light = sorted((_luminance(colour), _luminance(other_colour)))
    return (light + 0.05) / (dark + 0.05)


def _luminance(colour: str) -> float:
    """Return the relative luminance of an sRGB colour (#rrggbb), 0..1 (WCAG 2)."""
    return float(luminance(srgb_to_linear(np.array(_rgb_levels(colour)) / 255)))


def _mix(colour: str, target_colour: str, share: float) -> str:
    """Return the colour between `colour` (`share` 0) and `target_colour` (`share` 1), all as
    #rrggbb."""
    pairs = zip(_rgb_levels(colour), _rgb_levels(target_colour), strict=True)
    return "#" + "".join(f"{round(a + (b - a) * share):02x}" for a, b in pairs)


def _rgb_levels(colour: str) -> list[int]:
    """Return red, green and blue (0 to 255) of a colour such as #8090a0."""
    return [int(colour[at : at + 2], 16) for at in (1, 3, 5)]


if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

P = ParamSpec("P")

SCALE = "viridis"
"""Colour map of ordered values; its lightness is monotonic."""
WIDTH = 8.4
"""Width of panels in inches; the type is legible at the width of a README."""
DPI = 150
"""Dots per inch of saved pictures."""
SIZE = 8.5
"""Type size in points."""
_MARGIN = 0.15
"""Margin around a saved picture, in inches."""


def _settings(chosen: Theme) -> dict[Any, Any]:  # matplotlib lists every key as a type
    """Return the settings of matplotlib for the theme `chosen`."""
    return {
        "figure.dpi": DPI,
        "savefig.dpi": "figure",
        "font.size": SIZE,
        "text.color": chosen.ink,
        "figure.facecolor": chosen.paper,
        "axes.facecolor": chosen.paper,
        "axes.edgecolor": chosen.faint,
        "axes.labelcolor": chosen.ink,
        "axes.axisbelow": True,
        "axes.grid": True,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.titlelocation": "left",
        "axes.titlesize": SIZE + 1,
        "axes.titleweight": "bold",
        "grid.color": chosen.grid,
        "grid.linewidth": 0.7,
        "xtick.color": chosen.faint,
        "ytick.color": chosen.faint,
        "legend.frameon": False,
        "legend.borderpad": 0,
        "legend.borderaxespad": 0,
        "legend.handletextpad": 0.5,
        "legend.columnspacing": 1.4,
        "lines.linewidth": 1.4,
        "lines.markersize": 5,
    }


@cache
def _matplotlib() -> Any:
    """Import matplotlib and return it, without its warnings about a missing cache folder: they
    would stand among the messages of nscc and demand nothing. The log level is restored afterwards.

    The import is cached. Raises Rejected (NS0784) if there is no folder for its list of fonts."""
    logger = logging.getLogger("matplotlib")
    level = logger.level
    logger.setLevel(logging.ERROR)
    try:
        import matplotlib.font_manager
    except OSError as error:
        raise rejected(
            "NS0784",
            "pictures need a folder for matplotlib's list of fonts: none can be written",
            helps=("name one: MPLCONFIGDIR=FOLDER, or TMPDIR=FOLDER",),
        ) from error
    finally:
        logger.setLevel(level)
    return matplotlib


@contextmanager
def style() -> Iterator[None]:
    """Use the style and the current colours in a with block, independent of the user's settings."""
    matplotlib = _matplotlib()
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_settings(theme()))
        yield


def png_of(draw: Callable[P, Figure], *args: P.args, **options: P.kwargs) -> bytes:
    """Return the figure that `draw` returns for `args` and `options` as the bytes of a PNG file;
    equal arguments give equal bytes. Raises Rejected (NS0784) if matplotlib has no folder for its
    list of fonts."""
    with style():
        figure, data = draw(*args, **options), io.BytesIO()
        box = figure.get_tightbbox().padded(_MARGIN)
        # Use whole dots, to keep images sharp.
        box.set_points(np.round(box.get_points() * DPI) / DPI)
        figure.savefig(data, format="png", bbox_inches=box, metadata={"Software": None})
    return data.getvalue()


def blank(width: float, height: float) -> Figure:
    """Return a figure of `width` x `height` inches, rounded to dots, without a window and global
    state."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure((_round_to_dots(width), _round_to_dots(height)))
    FigureCanvasAgg(figure)
    return figure


def panels(count: int, size: tuple[float, float], columns: int) -> tuple[Figure, list[Axes]]:
    """Return a figure with `count` panels of about `size` (width, height) in inches, at most
    `columns` side by side, and the panels row by row."""
    columns = min(columns, count)
    rows = -(-count // columns)
    figure = blank(columns * size[0], rows * size[1])
    figure.set_layout_engine("constrained", w_pad=0.08, h_pad=0.08)
    return figure, [figure.add_subplot(rows, columns, i + 1) for i in range(count)]


def place(figure: Figure, x_inches: float, y_inches: float, width: float, height: float) -> Axes:
    """Add axes of `width` x `height` inches to `figure`, and return them. Their top left corner is
    `x_inches` to the right of that of the figure and `y_inches` below."""
    across, down = figure.get_size_inches()
    box = [_round_to_dots(value) for value in (x_inches, y_inches, width, height)]
    return figure.add_axes(
        (box[0] / across, 1 - (box[1] + box[3]) / down, box[2] / across, box[3] / down)
    )


def _round_to_dots(inches: float) -> float:
    """Return the length `inches`, rounded to a whole number of dots."""
    return round(inches * DPI) / DPI


def zoomed(shape: Sequence[int], room: float) -> tuple[float, float]:
    """Return width and height in inches of an image of `shape` (rows, cols, ..) in a square of side
    `room` inches.

    The image is magnified by a whole number, to avoid moire. One with more pixels than dots has one
    dot per pixel, and extends beyond the square."""
    dots = room * DPI / max(shape[:2])
    zoom = max(1, int(dots)) / DPI
    return shape[1] * zoom, shape[0] * zoom


def show_pixels(axes: Axes, image: Array) -> None:
    """Draw a grey (0..255) image (rows, cols), or an RGB image (rows, cols, 3), over all of `axes`,
    one square per pixel."""
    axes.imshow(image, cmap="gray", vmin=0, vmax=255, interpolation="nearest", aspect="auto")
    axes.grid(False)


def lay_out(figure: Figure) -> None:
    """Fix the positions of all panels of `figure` as they are drawn; labels are placed
    afterwards."""
    figure.draw_without_rendering()
    figure.set_layout_engine("none")


def head(figure: Figure, title: str, note: str, handles: Sequence[Artist] = ()) -> None:
    """Add `title`, a subtitle `note` and a legend of `handles` above the figure; empty ones are
    left out. Call it last: it fixes the layout."""
    lay_out(figure)
    width, height = figure.get_size_inches()
    left_edge, bottom = figure.get_tightbbox().x0 / width, 1 + 0.12 / height
    # As many columns of the legend as fit into the width.
    for columns in range(len(handles), 0, -1):
        legend = figure.legend(
            handles=handles, loc="lower left", bbox_to_anchor=(left_edge, bottom), ncols=columns
        )
        box = legend.get_window_extent()
        if box.width <= figure.bbox.width or columns == 1:
            bottom += (box.height / DPI + 0.1) / height
            break
        legend.remove()
    # The width of a letter relative to its size.
    texts = ((note, SIZE, "normal", 0.56, theme().faint), (title, 14, "bold", 0.64, theme().ink))
    for text, size, weight, letter, colour in texts:
        if text:
            lines = textwrap.fill(text, max(40, int(width * 72 / (letter * size))))
            written = figure.text(left_edge, bottom, lines, size=size, weight=weight, color=colour)
            written.set_verticalalignment("bottom")
            bottom += (written.get_window_extent().height / DPI + 0.07) / height


def round_ticks(axis: Axis, most: int = 7) -> None:
    """Set round ticks, written in full, on an axis with fixed limits: about five on a linear axis,
    at most `most` on a logarithmic one."""
    from matplotlib.ticker import LogLocator, MaxNLocator, NullLocator

    low, high = axis.get_view_interval()
    axis.set_minor_locator(NullLocator())
    # A logarithmic axis below two octaves has too few powers and simple multiples of them.
    if axis.get_scale() == "linear" or high < 4 * low:
        axis.set_major_locator(MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]))
    else:
        choices = ((1, 1.5, 2, 3, 5, 7), (1, 2, 5), (1, 3), (1,))
        decades = np.log10(high / low)
        subs = next((steps for steps in choices if len(steps) * decades <= most), (1,))
        axis.set_major_locator(LogLocator(subs=subs, numticks=most))
    axis.set_major_formatter(lambda value, _: f"{value:g}")
