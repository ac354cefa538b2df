"""The loops that find pixels whose charge may reach saturation: by an upper bound, then exactly."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc.arrays import Bytes, Floats, Floats32, Ints, Ints32
from nscc_runtime.loop import Written, compiled, inlined, loop, record

SIGMAS = 6.0
"""Number of standard deviations of noise that are added to a pixel's mean charge."""


@record
class Candidates:
    """Sizes of the chip, and of the light in which candidates are compared. `exchanged`: fraction
    of its charge that a pixel gives to each neighbour."""

    rows: int
    cols: int
    exchanged: float
    lane_count: int
    candidates: int
    """Number of candidates that are compared, for each kind of sum."""
    kinds: int
    frames: int
    """Number of frames of light, each of `lit_rows` rows from row `first_row` of the chip on."""
    lit_rows: int
    first_row: int


@inlined
def _given_e(sum_e: Floats32, factor: Floats32, dark_e: Floats32, p: int) -> float:
    """Return the charge of pixel p in a frame, of which it gives a fraction to each neighbour.
    Light that is NaN or below 0 gives nothing."""
    light_e = sum_e[p] * factor[p]
    given_e: float = dark_e[p] + (light_e if light_e >= 0.0 else 0.0)
    return given_e


@compiled
def _give(
    sizes: Candidates,
    row: int,
    sum_e: Floats32,
    factor: Floats32,
    dark_e: Floats32,
    given_e: Floats,
) -> None:
    """Store the charge of the pixels of a row in `given_e`, rows of two more columns; 0 beyond the
    border."""
    first, at = row * sizes.cols, (row + 3) % 3 * (sizes.cols + 2) + 1
    for i in range(-1, sizes.cols + 1):
        given_e[at + i] = 0.0
    for i in range(sizes.cols if 0 <= row < sizes.rows else 0):
        given_e[at + i] = _given_e(sum_e, factor, dark_e, first + i)


@loop
def find_candidates(
    sizes: Candidates,
    sum_e: Annotated[Floats32, "rows cols"],
    factor: Annotated[Floats32, "pixels"],
    dark_e: Annotated[Floats32, "pixels"],
    lanes: Annotated[Ints32, "pixels"],
    most_part: Annotated[Floats, "lane_count"],
    mean_e: Annotated[Floats, "lane_count"],
    given_e: Written[Floats],
    bound_e: Written[Annotated[Floats, "cols"]],
    places: Written[Annotated[Ints, "pixels"]],
    count: Written[Ints],
) -> None:
    """Set the first count[0] of `places` to those of the pixels whose charge may reach
    mean_e[lane], ascending.

    The bound adds up the dark charge of the frame, crosstalk, and the largest fraction of the light
    that PIX (the photodiode) or a register of the lane can contain, `most_part`. `given_e`, three
    rows of cols + 2 pixels, and `bound_e` are working memory."""
    cols, found = sizes.cols, 0
    _give(sizes, -1, sum_e, factor, dark_e, given_e)
    _give(sizes, 0, sum_e, factor, dark_e, given_e)
    for row in range(sizes.rows):
        _give(sizes, row + 1, sum_e, factor, dark_e, given_e)
        first, here = row * cols, row % 3 * (cols + 2) + 1
        up, down = (row + 2) % 3 * (cols + 2) + 1, (row + 1) % 3 * (cols + 2) + 1
        # Reading from tables is a loop of its own: LLVM vectorises only the other one.
        for i in range(cols):
            bound_e[i] = most_part[lanes[first + i]]
        for i in range(cols):
            gained_e = given_e[up + i] + given_e[down + i]
            gained_e += given_e[here + i - 1] + given_e[here + i + 1]
            own_e = bound_e[i] * (sum_e[first + i] * factor[first + i])
            bound_e[i] = own_e + dark_e[first + i] + sizes.exchanged * gained_e
        for i in range(cols):
            # Written for every pixel, and overwritten by the next candidate: no branch.
            places[found] = first + i
            found += 1 if bound_e[i] >= mean_e[lanes[first + i]] else 0
    count[0] = found


@loop
def compare_candidates(
    sizes: Candidates,
    places: Annotated[Ints, "candidates"],
    light: Annotated[Floats32, "frames lit_rows cols"],
    table: Annotated[Floats, "kinds frames lane_count"],
    sum_e: Annotated[Floats32, "rows cols"],
    factor: Annotated[Floats32, "pixels"],
    dark_e: Annotated[Floats32, "pixels"],
    lanes: Annotated[Ints32, "pixels"],
    dark_part: Annotated[Floats, "kinds lane_count"],
    mean_e: Annotated[Floats, "kinds lane_count"],
    seen_e: Written[Annotated[Floats, "kinds candidates"]],
    pix_e: Written[Annotated[Floats, "candidates"]],
    is_near: Written[Annotated[Bytes, "candidates"]],
) -> None:
    """Set `is_near` to whether the mean of any sum of charge of a candidate reaches its limit
    `mean_e`, and `pix_e` to the mean charge on PIX (the photodiode).

    `table`: the weight of each frame of `light` in each sum. `sum_e`: the light of all slots, and
    `dark_e` the dark charge, of which each sum contains `dark_part`. `seen_e` is
    working memory, 0 before."""
    cols, count, lit_pixels = sizes.cols, sizes.candidates, sizes.lit_rows * sizes.cols
    # Frame by frame, so that candidates share cache lines of the light and of the table.
    for row in range(sizes.kinds * sizes.frames):
        at, weights = row // sizes.frames * count, row * sizes.lane_count
        first = row % sizes.frames * lit_pixels - sizes.first_row * cols
        for i in range(count):
            seen_e[at + i] += table[weights + lanes[places[i]]] * light[first + places[i]]
    for i in range(count):
        p, neighbours, gained_e = places[i], 0, 0.0
        column = np.int64(np.uint32(p) % np.uint32(cols))
        for side in range(4):
            step = (2 * side - 1) * cols if side < 2 else 2 * side - 5
            other = p + step
            is_inside = 0 <= other < sizes.rows * cols
            if is_inside and (side < 2 or 0 <= column + step < cols):
                neighbours += 1
                gained_e += _given_e(sum_e, factor, dark_e, other)
        gained_e *= sizes.exchanged
        for kind in range(sizes.kinds):
            seen = seen_e[kind * count + i] * factor[p]
            # Crosstalk is counted in the pixel's own slots, whatever the codes of the neighbours.
            mixed = (1.0 - sizes.exchanged * neighbours) * seen + gained_e
            at = kind * sizes.lane_count + lanes[p]
            charge_e = (seen if seen > mixed else mixed) + dark_e[p] * dark_part[at]
            if kind == 0:
                pix_e[i] = charge_e
            is_near[i] = charge_e >= mean_e[at]
            if is_near[i]:
                break
