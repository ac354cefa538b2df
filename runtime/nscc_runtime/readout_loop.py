"""The compiled loops of a readout: its noise, and its codes."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc.arrays import Bytes, Floats
from nscc_runtime.loop import Written, loop, record
from nscc_runtime.noise.noise_loops import row_normals


@record
class NoiseSizes:
    """Sizes for `add_noise`: the numbers of rows, of columns, and of weights, which is 6, the
    random `key` of the noise, and the error that all codes share."""

    rows: int
    cols: int
    weights: int
    key: np.uint64
    common: float


@loop
def add_noise(
    sizes: NoiseSizes,
    weights: Annotated[Floats, "weights"],
    pattern: Annotated[Floats, "rows cols"],
    drawn: Written[Annotated[Floats, "weights cols"]],
    out: Written[Annotated[Floats, "rows cols"]],
) -> None:
    """Set out[p] to pattern[p] and the common error plus the weighted sum of the normal numbers of
    pixel p and of the five pixels below it in its column.

    Numbers are drawn in single precision, keyed by place, also for five rows below the array.
    `drawn` is working memory for the six rows that a row needs."""
    own, one, two = weights[0], weights[1], weights[2]
    three, four, five = weights[3], weights[4], weights[5]
    cols = sizes.cols
    for row in range(sizes.rows + 5):
        fifth = row % 6 * cols
        row_normals(sizes.key, row, cols, drawn, fifth)
        first = (row - 5) * cols
        start, second, third = (row + 1) % 6 * cols, (row + 2) % 6 * cols, (row + 3) % 6 * cols
        fourth, next_to_last = (row + 4) % 6 * cols, (row + 5) % 6 * cols
        for i in range(cols if row >= 5 else 0):
            near = own * drawn[start + i] + one * drawn[second + i] + two * drawn[third + i]
            far = three * drawn[fourth + i] + four * drawn[next_to_last + i]
            out[first + i] = (
                pattern[first + i] + sizes.common + near + (far + five * drawn[fifth + i])
            )


@record
class Converting:
    """The number of exposures that `convert` converts, the electrons of a code, the code of 0 e,
    and the largest code."""

    count: int
    electrons_per_lsb: float
    offset: float
    top: float


@loop
def convert(
    converting: Converting,
    exposure: Floats,
    noise: Floats,
    codes: Written[Bytes],
) -> None:
    """Set codes[p] to the converter code of exposure[p], in electrons, with the error noise[p], in
    codes before rounding; 0 for NaN. Halves are rounded to even numbers."""
    top = converting.top
    for p in range(converting.count):
        code = np.rint(exposure[p] / converting.electrons_per_lsb + noise[p])
        code = np.rint(code + converting.offset)  # the offset may be a fraction
        code = code if code > 0.0 else 0.0  # also for NaN
        codes[p] = np.uint8(code if code < top else top)
