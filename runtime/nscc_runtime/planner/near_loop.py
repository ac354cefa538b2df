"""The loop that finds which pixels may see enough light to saturate."""

from __future__ import annotations

from typing import Annotated

from nscc_runtime.loop import Bytes, Floats, Ints32, Written, inlined, loop, record


@record
class Asked:
    """The array: `fraction` of each pixel's light goes to each of its neighbours, `frame_s` seconds
    of dark current are added."""

    rows: int
    cols: int
    fraction: float
    frame_s: float


@inlined
def _tried(
    asked: Asked, total: Floats, scale: Floats, current: Floats, lanes: Ints32, limit: Floats,
    p: int, up: int, down: int, left: int, right: int, above: float, below: float, before: float,
    behind: float, found: Bytes, inflow: Floats,
) -> None:  # fmt: skip
    """Pixel p, whose neighbours count as often as they are there: 1 or 0."""
    beside = above * (total[up] * scale[up]) + below * (total[down] * scale[down])
    beside += before * (total[left] * scale[left]) + behind * (total[right] * scale[right])
    inflow[p] = asked.fraction * beside
    charge = total[p] * scale[p] + inflow[p] + current[p] * asked.frame_s
    found[p] = 1 if charge >= limit[lanes[p]] else 0


@loop
def may_saturate(
    asked: Asked,
    total: Annotated[Floats, "rows cols"],
    scale: Annotated[Floats, "rows cols"],
    current: Annotated[Floats, "rows cols"],
    lanes: Annotated[Ints32, "rows cols"],
    limit: Floats,
    found: Written[Annotated[Bytes, "rows cols"]],
    inflow: Written[Annotated[Floats, "rows cols"]],
) -> None:
    """found := whether all of a frame's charge is at least the limit of the pixel's lane; inflow :=
    what neighbours give of the light, `total` times `scale`, that they take."""
    rows, cols = asked.rows, asked.cols
    for row in range(rows):
        first, last = row * cols, (row + 1) * cols - 1
        above, below = 1.0 if row > 0 else 0.0, 1.0 if row + 1 < rows else 0.0
        up, down = -cols if row > 0 else 0, cols if row + 1 < rows else 0
        # Those inside have neighbours on both sides: no branch, so LLVM makes vectors.
        for p in range(first + 1, last):
            _tried(
                asked, total, scale, current, lanes, limit, p, p + up, p + down, p - 1, p + 1,
                above, below, 1.0, 1.0, found, inflow,
            )  # fmt: skip
        for p in (first, last):
            left, right = 1 if p > first else 0, 1 if p < last else 0
            _tried(
                asked, total, scale, current, lanes, limit, p, p + up, p + down, p - left,
                p + right, above, below, float(left), float(right), found, inflow,
            )  # fmt: skip
