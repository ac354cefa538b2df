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
def _inflow(
    asked: Asked, total: Floats, scale: Floats, p: int, up: int, down: int, left: int, right: int,
    inflow: Floats,
) -> None:  # fmt: skip
    """What comes to pixel p from its neighbours, so many places away; from itself where there is
    none."""
    beside = total[p + up] * scale[p + up] + total[p + down] * scale[p + down]
    beside += total[p + left] * scale[p + left] + total[p + right] * scale[p + right]
    missing = (1.0 if up == 0 else 0.0) + (1.0 if down == 0 else 0.0)
    missing += (1.0 if left == 0 else 0.0) + (1.0 if right == 0 else 0.0)
    inflow[p] = asked.fraction * (beside - missing * (total[p] * scale[p]))


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
        up, down = -cols if row > 0 else 0, cols if row + 1 < rows else 0
        # Those inside have neighbours on both sides: no branch, so LLVM makes vectors.
        for p in range(first + 1, last):
            _inflow(asked, total, scale, p, up, down, -1, 1, inflow)
        _inflow(asked, total, scale, first, up, down, 0, 1 if last > first else 0, inflow)
        _inflow(asked, total, scale, last, up, down, -1 if last > first else 0, 0, inflow)
        for p in range(first, last + 1):
            charge = total[p] * scale[p] + inflow[p] + current[p] * asked.frame_s
            found[p] = 1 if charge >= limit[lanes[p]] else 0
