"""The compiled loop that draws and adds up the noise of a readout."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc.arrays import Floats
from nscc_runtime.loop import Written, loop, record
from nscc_runtime.noise.gaussian import normal_fast
from nscc_runtime.noise.noise_loops import uniform


@record
class NoiseSizes:
    """Sizes for `add_noise`: the numbers of rows, of columns, and of weights, which is 6, and the
    random `key` of the noise."""

    rows: int
    cols: int
    weights: int
    key: np.uint64


@loop
def add_noise(
    sizes: NoiseSizes,
    weights: Annotated[Floats, "weights"],
    pattern: Annotated[Floats, "rows cols"],
    drawn: Written[Annotated[Floats, "weights cols"]],
    out: Written[Annotated[Floats, "rows cols"]],
) -> None:
    """Set out[p] to pattern[p] plus the weighted sum of the normal numbers of pixel p and of the
    five pixels below it in its column.

    Numbers are drawn in single precision, keyed by place, also for five rows below the array.
    `drawn` is working memory for the six rows that a row needs."""
    own, one, two = weights[0], weights[1], weights[2]
    three, four, five = weights[3], weights[4], weights[5]
    cols = sizes.cols
    for row in range(sizes.rows + 5):
        fifth = row % 6 * cols
        for i in range(cols):
            drawn[fifth + i] = uniform(sizes.key, row * cols + i)
        for i in range(cols):
            drawn[fifth + i] = float(normal_fast(drawn[fifth + i]))
        first = (row - 5) * cols
        start, second, third = (row + 1) % 6 * cols, (row + 2) % 6 * cols, (row + 3) % 6 * cols
        fourth, next_to_last = (row + 4) % 6 * cols, (row + 5) % 6 * cols
        for i in range(cols if row >= 5 else 0):
            near = own * drawn[start + i] + one * drawn[second + i] + two * drawn[third + i]
            far = three * drawn[fourth + i] + four * drawn[next_to_last + i]
            out[first + i] = pattern[first + i] + near + (far + five * drawn[fifth + i])
