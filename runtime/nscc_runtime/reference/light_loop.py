"""The loop that adds up the light of slots, as `nscc_runtime.light.Light` defines it."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc_runtime.loop import Floats, Floats32, Ints, Ints32, Written, loop, record

_BLOCK = 1024


@record
class LitSizes:
    """Sizes for `add_light`. `pixels` pixels from number `first` on are computed."""

    slots: int
    pixels: int
    first: int
    all_pixels: int


@loop
def add_light(
    sizes: LitSizes,
    frames: Annotated[Floats32, "frames all_pixels"],
    row_start: Annotated[Ints, "slots+1"],
    frame_index: Annotated[Ints32, "shares"],
    weight: Annotated[Floats, "shares"],
    out: Written[Annotated[Floats, "slots pixels"]],
) -> None:
    """Set out[n, p] to the electrons of slot n at pixel p, rounded to float32."""
    pixels = sizes.pixels
    for begin in range(0, pixels, _BLOCK):
        stop = min(begin + _BLOCK, pixels)
        for n in range(sizes.slots):
            row = n * pixels
            for p in range(begin, stop):
                out[row + p] = 0.0
            for k in range(row_start[n], row_start[n + 1]):
                at = frame_index[k] * sizes.all_pixels + sizes.first
                for p in range(begin, stop):
                    out[row + p] += float(frames[at + p]) * weight[k]
            for p in range(begin, stop):
                out[row + p] = float(np.float32(out[row + p]))
