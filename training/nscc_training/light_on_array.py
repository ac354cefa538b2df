"""Light of scenes on the array of a chip."""

from __future__ import annotations

import numpy as np

from nscc.arrays import Array
from nscc.chips.target import Target
from nscc_runtime.light import Light


def light_on_array(light_e: Array, slots: int, target: Target) -> Light:
    """Return `light_e`, electrons over a frame (rows, cols) or per slot (N, rows, cols), as light
    on the array of `target`.

    The light of a frame is spread evenly over `slots` slots; light per slot keeps its own N slots.
    A scene smaller than the array is extended by its edge pixels; of a larger scene the upper left
    part is taken."""
    visible = light_e[..., : target.rows, : target.cols].astype(np.float32)
    missing = (target.rows - visible.shape[-2], target.cols - visible.shape[-1])
    margins = [(0, 0)] * (visible.ndim - 2) + [(0, count) for count in missing]
    padded = np.pad(visible, margins, mode="edge")
    if padded.ndim == 2:
        return Light.of_still(padded, np.full(slots, 1 / slots))
    return Light.of_clip(padded)
