"""The loop that finds pixels whose charge may reach saturation, by an upper bound."""

from __future__ import annotations

from typing import Annotated

from nscc.arrays import Bytes, Floats, Ints32
from nscc_runtime.execution.moment_loop import on_side
from nscc_runtime.loop import Written, loop, record


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
    the light that it gets from its neighbours.

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
                gained_e[p] += sum_e[p + step] * factor[p + step]
        for p in range(first, stop):
            gained_e[p] *= sizes.exchanged
            own_e = most_part[lanes[p]] * (sum_e[p] * factor[p])
            bound_e = own_e + dark_e[p] + gained_e[p]
            may_saturate[p] = bound_e >= mean_e[lanes[p]]
