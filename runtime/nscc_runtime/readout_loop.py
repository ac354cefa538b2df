"""The compiled loop that adds up the noise of a readout."""

from __future__ import annotations

from typing import Annotated

from nscc.arrays import Floats
from nscc_runtime.loop import Written, loop, record


@record
class NoiseSizes:
    """Sizes for `add_noise`: the numbers of pixels, of columns (a row), and of weights, which is
    6."""

    pixels: int
    cols: int
    weights: int


@loop
def add_noise(
    sizes: NoiseSizes,
    weights: Annotated[Floats, "weights"],
    normals: Floats,
    pattern: Annotated[Floats, "pixels"],
    out: Written[Annotated[Floats, "pixels"]],
) -> None:
    """Set out[p] to pattern[p] plus the weighted sum of the normal numbers of pixel p and of the
    five pixels below it in its column.

    Pixels are in the order of places, row after row. `normals` has five rows of pixels more than
    the array, so that all pixels have five below them."""
    own, one, two = weights[0], weights[1], weights[2]
    three, four, five = weights[3], weights[4], weights[5]
    cols = sizes.cols
    # A single pass: a loop over weights would read and write `out` for each of them.
    for p in range(sizes.pixels):
        near = own * normals[p] + one * normals[p + cols] + two * normals[p + 2 * cols]
        far = three * normals[p + 3 * cols] + four * normals[p + 4 * cols]
        out[p] = pattern[p] + near + (far + five * normals[p + 5 * cols])
