"""Weighted sums over square windows of any size, by a compiled loop, in time linear in pixels.

Weights that fall linearly to 0 are two boxes one after the other. The sums of a box are additions
only, so they are exact to the last digits where light of very different size lies side by side."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.loop import Written, inlined, loop, record

_LANES = 8
"""Columns that are summed together: a line of the processor's cache."""


@record
class AxisLines:
    """The lines along one axis of a picture, as positions in its flat array of `pixels` elements.

    There are `count` lines of `length` pixels. Pixels of a line are `stride` elements apart, and
    neighbouring lines begin `step` elements apart. `padded` is the number of pixels of a line with
    its margins. Windows reach over `reach` - 1 pixels to both sides."""

    pixels: int
    count: int
    length: int
    stride: int
    step: int
    padded: int
    reach: int


@inlined
def _boxes(count: int, reach: int, lanes: int, values: Floats, sums: Floats) -> None:
    """Compute sums[i] = values[i] + .. + values[i + reach - 1] for i < count.

    Both arrays hold `lanes` independent sequences, interleaved: element i of a sequence is at `i *
    lanes + lane`."""
    # Blocks of `reach` sums: the part of a sum within the block is added from its end backwards,
    # the part beyond from there forwards. No term is ever subtracted.
    first = 0
    while first < count:
        end = min(first + reach, count)
        for lane in range(lanes):
            total = 0.0
            for i in range(first + reach - 1, first - 1, -1):
                total += values[i * lanes + lane]
                if i < end:
                    sums[i * lanes + lane] = total
            total = 0.0
            for i in range(first + 1, end):
                total += values[(i + reach - 1) * lanes + lane]
                sums[i * lanes + lane] += total
        first += reach


@loop
def tent_lines(
    lines: AxisLines,
    picture: Written[Annotated[Floats, "pixels"]],
    values: Written[Floats],
    sums: Written[Floats],
) -> None:
    """Replace `picture` by its weighted sums along the axis that `lines` describes.

    `values` and `sums` are working memory for `padded` pixels of eight lines. `values` must be 0,
    and is 0 again at the end."""
    reach, length, stride, step = lines.reach, lines.length, lines.stride, lines.step
    margin = (reach - 1) * _LANES
    for first in range(0, lines.count, _LANES):
        lanes = min(_LANES, lines.count - first)
        for i in range(length):
            for lane in range(lanes):
                values[margin + i * _LANES + lane] = picture[(first + lane) * step + i * stride]
        _boxes(length + reach - 1, reach, _LANES, values, sums)
        for i in range((length + reach - 1) * _LANES):
            values[i] = sums[i]
        _boxes(length, reach, _LANES, values, sums)
        for i in range(length):
            for lane in range(lanes):
                at = (first + lane) * step + i * stride
                picture[at] = sums[i * _LANES + lane] / reach
        for i in range(lines.padded * _LANES):
            values[i] = 0.0


def tent_sums(values: Floats, reach: int) -> Floats:
    """Sum over square windows, with weights that fall linearly to 0 at `reach` pixels.

    Parameters
    ----------
    values : array
        A picture (rows, cols).
    reach : int
        At least 1, which leaves the picture as it is. A pixel d rows (or columns) away has the
        weight 1 - d / `reach` along that axis; the weight of the pixel itself is 1.

    Returns
    -------
    array
        (rows, cols), float64.
    """
    sums = np.array(values, np.float64, order="C")
    rows, cols = sums.shape
    for count, length, stride, step in ((cols, rows, cols, 1), (rows, cols, 1, cols)):
        padded = length + 2 * reach
        lines = AxisLines(
            pixels=sums.size,
            count=count,
            length=length,
            stride=stride,
            step=step,
            padded=padded,
            reach=reach,
        )
        margins = np.zeros(padded * _LANES)
        tent_lines(
            lines=lines, picture=sums.reshape(-1), values=margins, sums=np.zeros_like(margins)
        )
    return sums
