"""The loop that finds which pixels may see enough light to saturate."""

from __future__ import annotations

import math
from typing import Annotated

from nscc_runtime.loop import Bytes, Floats, Ints32, Written, loop, record


@record
class Asked:
    """The array, and when a pixel counts as near: `sigmas` of its charge from its limit.

    `fraction` of each pixel's light goes to each of its neighbours, `frame_s` seconds of dark
    current are added.
    """

    rows: int
    cols: int
    fraction: float
    frame_s: float
    sigmas: float


@loop
def may_saturate(
    asked: Asked,
    light: Annotated[Floats, "rows cols"],
    scale: Annotated[Floats, "rows cols"],
    current: Annotated[Floats, "rows cols"],
    lanes: Annotated[Ints32, "rows cols"],
    limit: Floats,
    found: Written[Annotated[Bytes, "rows cols"]],
    inflow: Written[Annotated[Floats, "rows cols"]],
) -> None:
    """found := whether all of a frame's charge may pass the limit of the pixel's lane; inflow :=
    what neighbours give of their light, times `scale`."""
    rows, cols = asked.rows, asked.cols
    for row in range(rows):
        for col in range(cols):
            p, beside = row * cols + col, 0.0
            if row > 0:
                beside += light[p - cols] * scale[p - cols]
            if row + 1 < rows:
                beside += light[p + cols] * scale[p + cols]
            if col > 0:
                beside += light[p - 1] * scale[p - 1]
            if col + 1 < cols:
                beside += light[p + 1] * scale[p + 1]
            inflow[p] = asked.fraction * beside
            charge = light[p] * scale[p] + inflow[p] + current[p] * asked.frame_s
            most = charge + asked.sigmas * math.sqrt(charge)
            found[p] = 1 if most >= limit[lanes[p]] else 0
