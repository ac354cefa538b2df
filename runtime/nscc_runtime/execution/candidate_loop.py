"""The loops that find pixels whose charge may reach saturation: by an upper bound, then exactly."""

from __future__ import annotations

import math
from typing import Annotated

from nscc.arrays import Bytes, Floats, Ints, Ints32
from nscc_runtime.execution.moment_loop import on_side
from nscc_runtime.loop import Written, loop, record

SIGMAS = 6.0
"""Number of standard deviations of noise that are added to a pixel's mean charge."""


@record
class Bounding:
    """Sizes for `find_candidates`. `exchanged`: fraction of its charge that a pixel gives to each
    neighbour."""

    rows: int
    cols: int
    exchanged: float


@loop
def find_candidates(
    sizes: Bounding,
    sum_e: Annotated[Floats, "rows cols"],
    factor: Annotated[Floats, "pixels"],
    dark_e: Annotated[Floats, "pixels"],
    lanes: Annotated[Ints32, "pixels"],
    most_part: Annotated[Floats, "lane_count"],
    mean_e: Annotated[Floats, "lane_count"],
    gained_e: Written[Annotated[Floats, "pixels"]],
    may_saturate: Written[Annotated[Bytes, "pixels"]],
) -> None:
    """Set `may_saturate` to whether the charge of a pixel may reach mean_e[lane], and `gained_e` to
    the charge that it gets from its neighbours.

    The bound adds up the dark charge of the frame, crosstalk, and the largest fraction of the light
    that PIX (the photodiode) or a register of the lane can contain, `most_part`."""
    cols = sizes.cols
    for row in range(sizes.rows):
        first, stop = row * cols, (row + 1) * cols
        for p in range(first, stop):
            gained_e[p] = 0.0
        for side in range(4 if sizes.exchanged > 0.0 else 0):
            step, begin, end = on_side(row, sizes.rows, cols, side)
            for p in range(begin, end):
                given_e = sum_e[p + step] * factor[p + step]
                gained_e[p] += given_e if given_e >= 0.0 else 0.0  # 0 for NaN
                gained_e[p] += dark_e[p + step]
        for p in range(first, stop):
            gained_e[p] *= sizes.exchanged
            own_e = most_part[lanes[p]] * (sum_e[p] * factor[p])
            bound_e = own_e + dark_e[p] + gained_e[p]
            may_saturate[p] = bound_e >= mean_e[lanes[p]]


@record
class CandidateSizes:
    """Sizes for `compare_candidates`: of `candidates` pixels, for each kind of sum and lane.
    `exchanged`: fraction of its charge that a pixel gives to each neighbour."""

    rows: int
    cols: int
    pixels: int
    exchanged: float
    candidates: int
    kinds: int
    lane_count: int


@loop
def compare_candidates(
    sizes: CandidateSizes,
    places: Annotated[Ints, "candidates"],
    lanes: Annotated[Ints32, "candidates"],
    seen_e: Annotated[Floats, "kinds candidates"],
    gained_e: Annotated[Floats, "pixels"],
    dark_e: Annotated[Floats, "pixels"],
    dark_part: Annotated[Floats, "kinds lane_count"],
    saturation_e: Annotated[Floats, "kinds lane_count"],
    most_e: Written[Annotated[Floats, "candidates"]],
    is_near: Written[Annotated[Bytes, "candidates"]],
) -> None:
    """Set `is_near` to whether any sum of charge of a candidate, with noise, reaches its smallest
    sum of saturation, and `most_e` to its charge on PIX (the photodiode), with noise.

    `seen_e`: the light in each sum. `gained_e`: the charge from neighbours. `dark_e`: dark charge
    of the frame, of which each sum contains `dark_part`. Candidates are at ascending `places`."""
    row, count = 0, sizes.candidates
    for i in range(count):
        p, near = places[i], 0
        while p >= (row + 1) * sizes.cols:
            row += 1
        neighbours = (row > 0) + (row + 1 < sizes.rows)
        neighbours += (p > row * sizes.cols) + (p + 1 < (row + 1) * sizes.cols)
        for kind in range(sizes.kinds - 1, -1, -1):
            seen, at = seen_e[kind * count + i], kind * sizes.lane_count + lanes[i]
            # Crosstalk is counted in the pixel's own slots, whatever the codes of the neighbours.
            mixed = (1.0 - sizes.exchanged * neighbours) * seen + gained_e[p]
            charge_e = (seen if seen > mixed else mixed) + dark_e[p] * dark_part[at]
            most_e[i] = charge_e + SIGMAS * math.sqrt(charge_e)
            near |= most_e[i] >= saturation_e[at]
        is_near[i] = near
