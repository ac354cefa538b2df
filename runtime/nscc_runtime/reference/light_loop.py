"""The loop that adds up the light of slots, as `nscc_runtime.light.Light` defines it."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc_runtime.light_matrix import LightMatrix
from nscc_runtime.loop import Floats, Written, loop, record

_BLOCK = 1024


@record
class LitSizes:
    """Sizes for `add_light`. Of `pixels` pixels, `length` from number `first` on are computed."""

    slots: int
    pixels: int
    first: int
    length: int


@loop
def add_light(
    sizes: LitSizes,
    light: LightMatrix,
    out: Written[Annotated[Floats, "slots length"]],
) -> None:
    """Set out[n, p] to the electrons of slot n at pixel p, rounded to float32."""
    for begin in range(0, sizes.length, _BLOCK):
        stop = min(begin + _BLOCK, sizes.length)
        for n in range(sizes.slots):
            row = n * sizes.length
            for p in range(begin, stop):
                out[row + p] = 0.0
            for k in range(light.row_start[n], light.row_start[n + 1]):
                at = light.frame_index[k] * sizes.pixels + sizes.first
                for p in range(begin, stop):
                    out[row + p] += float(light.frames[at + p]) * light.weight[k]
            for p in range(begin, stop):
                out[row + p] = float(np.float32(out[row + p]))
