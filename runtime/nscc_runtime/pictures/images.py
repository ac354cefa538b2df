"""Draw images side by side, with a title above each and a note below."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.picture_colours import look

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SIDE, _GAP, _LINE = 3.5, 0.2, 0.17
"""Side of an image, gap between images, and height of a line of text, in inches."""
_LETTERS = 11
"""Number of letters per inch of a line of text."""


@dataclass(frozen=True, eq=False)
class Image:
    """A grey image (rows, cols) of 0..255 with its title and a note."""

    values: NDArray[Any]
    title: str = ""
    note: str = ""


def image_sheet(rows: Sequence[Sequence[Image]], title: str, side: float | None = None) -> Figure:
    """Draw rows of images; images of equal size in a row have equal magnification. `side`: inches
    per side of an image; None for an equal share of the page width."""
    columns = max(map(len, rows))
    side = side or min(_SIDE, sheet.WIDTH / columns - _GAP)

    def lines(text: str) -> list[str]:
        return textwrap.wrap(text, int(side * _LETTERS))

    boxes, top = [], 0.0
    for row in rows:
        sizes = [sheet.zoomed(image.values.shape, side) for image in row]
        top += _LINE * max(len(lines(image.title)) for image in row)
        boxes += [
            (image, number * (side + _GAP), top, *size)
            for number, (image, size) in enumerate(zip(row, sizes, strict=True))
        ]
        below = _LINE * max(len(lines(image.note)) for image in row)
        top += max(height for _, height in sizes) + below + _GAP
    figure = sheet.blank(columns * (side + _GAP) - _GAP, top)
    for image, x_inches, y_inches, width, height in boxes:
        axes = sheet.place(figure, x_inches, y_inches, width, height)
        sheet.show_pixels(axes, image.values)
        axes.set_axis_off()
        axes.set_title("\n".join(lines(image.title)), pad=4)
        axes.annotate(
            "\n".join(lines(image.note)), (0, 0), (0, -4), "axes fraction",
            textcoords="offset points", va="top", color=look().faint,
        )  # fmt: skip
    sheet.head(figure, title, "")
    return figure
