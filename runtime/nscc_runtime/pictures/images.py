"""Draw images side by side, with a title above each and a note below, for frames."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from nscc.arrays import Array
from nscc_runtime.frame_file import Frame
from nscc_runtime.merge import BucketReadout, light_estimate
from nscc_runtime.pictures import sheet
from nscc_runtime.pictures.sheet import theme
from nscc_runtime.pictures.tone import fitted

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SIDE, _GAP, _LINE = 3.5, 0.2, 0.17
"""Side of an image, gap between images, and height of a line of text, in inches."""
_LETTERS = 11
"""Number of letters per inch of a line of text."""


@dataclass(frozen=True, eq=False)
class Image:
    """An image (rows, cols), or (rows, cols, 3) in colours, of 0..255, with the title above and the
    note below it."""

    values: Array
    title: str = ""
    note: str = ""


def image_sheet(rows: Sequence[Sequence[Image]], title: str, side: float | None = None) -> Figure:
    """Return a sheet of `rows` of images, each with one or more, under `title`. Images of equal
    size in a row have equal magnification. `side`: inches per side of an image; None for an equal
    share of the page width."""
    columns = max(map(len, rows))
    side = side or min(_SIDE, sheet.WIDTH / columns - _GAP)

    def lines(text: str) -> list[str]:
        """Return `text` in lines as wide as an image; [] if it is empty."""
        return textwrap.wrap(text, int(side * _LETTERS))

    # Each row is as high as its tallest image, with room for the longest title and note.
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
            "\n".join(lines(image.note)),
            (0, 0),
            (0, -4),
            "axes fraction",
            textcoords="offset points",
            va="top",
            color=theme().faint,
        )
    sheet.head(figure, title, "")
    return figure


def frame_sheet(readouts: Sequence[BucketReadout], title: str) -> Figure:
    """Return a sheet under `title` with a row for each of `readouts`: the converter codes as read
    out, and the tone-mapped light."""
    rows = []
    for readout in readouts:
        light, usable = light_estimate(readout)
        tone = fitted("log", light[usable])
        window = f"{readout.window[0]} x {readout.window[1]}"
        around = "each pixel" if window == "1 x 1" else f"unsaturated pixels in {window}"
        saturated = np.count_nonzero(readout.saturated) / readout.saturated.size
        readout_texts = f"{readout.name}: as read out", f"8 bit, {saturated:.1%} saturated"
        light_texts = (
            f"{readout.name}: light a second",
            f"electrons / open time of {around}, log scale",
        )
        rows.append((Image(readout.frame, *readout_texts), Image(tone(light), *light_texts)))
    return image_sheet(rows, title)


_COLUMNS = 2
"""Number of images side by side."""


def image_plane_sheet(frame: Frame, buckets: Sequence[str], title: str) -> Figure:
    """Return a sheet under `title` of the buckets of `frame`, its images (0.5th to 99.5th
    percentile), its planes in black and white, and the places of reported events.

    `buckets` are the names of the first of its readouts."""
    arrays = frame.told
    shown = [
        Image(codes, f"{name}", "bucket, as read out")
        for name, codes in zip(buckets, frame.frame[: len(buckets)], strict=True)
    ]
    for key, values in arrays.items():
        kind, _, name = key.partition("_")
        if kind == "plane":
            text = f"plane, {np.count_nonzero(values) / values.size:.1%} are 1"
            shown.append(Image((values * 255).astype(np.uint8), name, text))
        elif kind == "image" and f"image_codes_{name}" in arrays:
            low, high = (float(value) for value in np.percentile(values, (0.5, 99.5)))
            share = np.clip((values - low) / max(high - low, 1e-30), 0.0, 1.0)
            grey = np.rint(255 * share).astype(np.uint8)
            shown.append(Image(grey, name, f"image, {low:.4g} to {high:.4g} electrons"))
        elif key.startswith("report_events_") and f"{key}_count" in arrays:
            # Rows of -1 follow the last event.
            points = values[values[:, 0] >= 0]
            grey = np.zeros(arrays["margin"].shape, np.uint8)
            grey[points[:, 1], points[:, 0]] = 255
            name = key.removeprefix("report_events_")
            shown.append(Image(grey, name, f"{len(points)} events reported"))
    rows = [shown[k : k + _COLUMNS] for k in range(0, len(shown), _COLUMNS)]
    return image_sheet(rows, title)
