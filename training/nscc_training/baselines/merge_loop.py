"""Merging of neighbours for stills: the mean of nearby pixels by precision, in compiled loops."""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools, Floats
from nscc_runtime.loop import Written, inlined, loop, record

Picture = Floats

_OWN = 8.0
"""Weight of a pixel's own measurement relative to that of a direct neighbour."""


def merged(
    frame: NDArray[np.floating],
    open_share: Picture,
    electrons_per_lsb: float,
    saturated: Bools,
    read_noise_e: float,
) -> Picture:
    """Estimate the light over the whole frame in electrons (rows, cols), as if every pixel had
    always been open.

    All arrays are (rows, cols): `frame` are converter codes above the offset, each of
    `electrons_per_lsb`; `open_share` is the open fraction of the frame of each pixel, and
    `saturated` marks codes that are lower limits. `read_noise_e` is the standard deviation of the
    readout in electrons. The light of a pixel is the mean of the measurements around it, weighted
    by precision; saturated measurements have weight 0. The neighbourhood grows until it contains a
    measurement. A saturated pixel has at least the light that saturates it; one that never opens
    has its neighbours' light."""
    exposure = frame.astype(np.float64) * electrons_per_lsb
    share = np.where(open_share > 0, open_share, 1.0)
    usable = ~saturated & (open_share > 0)
    # Noise may give a dark pixel less than the offset, but photons have no negative variance.
    # Rounding to whole codes adds the variance 1 / 12 of a squared code.
    variance = (np.maximum(exposure, 0) + read_noise_e**2 + electrons_per_lsb**2 / 12) / share**2
    precision = np.where(usable, 1.0 / variance, 0.0)
    light = exposure / share
    return merge_neighbours(
        light, precision, np.where(saturated & (open_share > 0), light, -np.inf)
    )


def merge_neighbours(light: Picture, precision: Picture, least: Picture) -> Picture:
    """Return the mean of `light` (rows, cols) around each pixel, weighted by `precision`, and at
    least `least`.

    The neighbourhood of a pixel doubles until it holds a pixel with a precision above 0. If no
    pixel of the picture has one, the larger of `light` and `least` is returned. All are (rows,
    cols); `least` may be -inf."""
    result = light.copy()
    near = precision > 0
    missing = np.full(light.shape, bool(near.any()))
    reach = 2
    while missing.any():
        # Windows of twice the reach are three of these side by side, along each axis.
        for pixels in (near, near.T):
            before = pixels.copy(order="K")
            pixels[reach // 2 :] |= before[: -(reach // 2)]
            pixels[: -(reach // 2)] |= before[reach // 2 :]
        # Sums are needed around the pixels that this reach fills only.
        fillable = missing & near
        missing &= ~fillable
        for box in _boxes_of(fillable, reach):
            around = tuple(slice(max(0, axis.start - reach), axis.stop + reach) for axis in box)
            inside = tuple(
                slice(own.start - wide.start, own.stop - wide.start)
                for own, wide in zip(box, around, strict=True)
            )
            own = precision[around]
            total, value = (
                # `tent_sums` counts a pixel itself once; the second term makes that `_OWN` times.
                tent_sums(values, reach)[inside] + (_OWN - 1) * values[inside]
                for values in (own, own * light[around])
            )
            np.divide(value, total, out=result[box], where=fillable[box])
        reach *= 2
    return np.maximum(result, least)


_BLOCK = 128
"""Least side in pixels of the blocks that are filled one by one."""


def _boxes_of(marked: Bools, margin: int) -> list[tuple[slice, slice]]:
    """Return boxes of rows and columns that together hold the true elements of `marked` (rows,
    cols), each of them once: one box, or a box for each block of elements.

    It returns those boxes that have fewer elements with `margin` more at all sides."""
    rows, cols = marked.shape
    boxes_by_side = []
    for side in (max(rows, cols), max(_BLOCK, 4 * margin)):
        blocks = (
            (row, col, marked[row : row + side, col : col + side])
            for row in range(0, rows, side)
            for col in range(0, cols, side)
        )
        boxes = [
            (_from_first_to_last(block, 0, row), _from_first_to_last(block, 1, col))
            for row, col, block in blocks
            if block.any()
        ]
        boxes_by_side.append(boxes)
    return min(
        boxes_by_side,
        key=lambda boxes: sum(
            math.prod(axis.stop - axis.start + 2 * margin for axis in box) for box in boxes
        ),
    )


def _from_first_to_last(marked: Bools, axis: int, begin: int) -> slice:
    """Return the slice along `axis` from the first to the last true element of `marked` (rows,
    cols), whose first row or column has the index `begin`. At least one element is true."""
    indices = np.flatnonzero(np.any(marked, axis=1 - axis)) + begin
    return slice(int(indices[0]), int(indices[-1]) + 1)


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
