"""The loop that finds which pixels may see enough light to saturate."""

from __future__ import annotations

import math
from typing import Annotated

from nscc_runtime.loop import (
    Floats,
    Floats32,
    Ints,
    Ints32,
    Written,
    compiled,
    inlined,
    loop,
    record,
)


@record
class Asked:
    """The array: `fraction` of each pixel's light goes to each of its neighbours, `frame_s` seconds
    of dark current are added; the light has `count` frames."""

    rows: int
    cols: int
    count: int
    lane_count: int
    fraction: float
    frame_s: float
    sigmas: float


@inlined
def _inflow(
    asked: Asked, total: Floats, scale: Floats, p: int, up: int, down: int, left: int, right: int,
    inflow: Floats, first: int,
) -> None:  # fmt: skip
    """What comes to pixel p from its neighbours, so many places away; from itself where there is
    none."""
    beside = total[p + up] * scale[p + up] + total[p + down] * scale[p + down]
    beside += total[p + left] * scale[p + left] + total[p + right] * scale[p + right]
    missing = (1.0 if up == 0 else 0.0) + (1.0 if down == 0 else 0.0)
    missing += (1.0 if left == 0 else 0.0) + (1.0 if right == 0 else 0.0)
    inflow[p - first] = asked.fraction * (beside - missing * (total[p] * scale[p]))


@compiled
def _see(
    asked: Asked, frames: Floats32, weights: Floats, scale: Floats, lanes: Ints32, places: Ints,
    first: int, stop: int, seen: Floats,
) -> None:  # fmt: skip
    """seen[i] := the light that the pixels places[i] see, from number `first` on."""
    for i in range(first, stop):
        seen[i] = 0.0
    for k in range(asked.count):
        frame, row = k * asked.rows * asked.cols, k * asked.lane_count
        for i in range(first, stop):
            seen[i] += weights[row + lanes[places[i]]] * frames[frame + places[i]]
    for i in range(first, stop):
        seen[i] *= scale[places[i]]


@compiled
def _reaching(charge: float, sigmas: float) -> float:
    """How far a count of this mean may go."""
    return charge + sigmas * math.sqrt(charge)


@loop
def may_saturate(
    asked: Asked,
    total: Annotated[Floats, "rows cols"],
    scale: Annotated[Floats, "rows cols"],
    current: Annotated[Floats, "rows cols"],
    lanes: Annotated[Ints32, "rows cols"],
    frames: Annotated[Floats32, "count rows cols"],
    weights: Annotated[Floats, "count lane_count"],
    dark_s: Annotated[Floats, "lane_count"],
    limit: Annotated[Floats, "lane_count"],
    inflow: Written[Annotated[Floats, "cols"]],
    found: Written[Ints],
    places: Written[Ints],
    most: Written[Floats],
    own: Written[Floats],
    gained: Written[Floats],
) -> None:
    """places := where all of a frame's charge is at least the limit of the pixel's lane, in order;
    `found`: how many these are.

    Of each of them `most` := what it may see at a read: the light of its open slots, weighed by
    `weights`, or that with what neighbours give, and the dark charge of `dark_s` seconds, `sigmas`
    standard deviations above their mean; `own`: without neighbours. `gained` := what neighbours
    give of the frame's light, `total` times `scale`, less what they take. `inflow` is scratch; what
    is written has room for all pixels.
    """
    rows, cols, count = asked.rows, asked.cols, 0
    kept = 1.0 - 4.0 * asked.fraction
    for row in range(rows):
        first, last = row * cols, (row + 1) * cols - 1
        up, down = -cols if row > 0 else 0, cols if row + 1 < rows else 0
        # Those inside have neighbours on both sides: no branch, so LLVM makes vectors.
        for p in range(first + 1, last):
            _inflow(asked, total, scale, p, up, down, -1, 1, inflow, first)
        _inflow(asked, total, scale, first, up, down, 0, 1 if last > first else 0, inflow, first)
        _inflow(asked, total, scale, last, up, down, -1 if last > first else 0, 0, inflow, first)
        many = 0
        for p in range(first, last + 1):
            charge = total[p] * scale[p] + inflow[p - first] + current[p] * asked.frame_s
            many += 1 if charge >= limit[lanes[p]] else 0
        begin = count
        for p in range(first, last + 1 if many else first):
            charge = total[p] * scale[p] + inflow[p - first] + current[p] * asked.frame_s
            if charge >= limit[lanes[p]]:
                places[count] = p
                count += 1
        _see(asked, frames, weights, scale, lanes, places, begin, count, own)
        for i in range(begin, count):
            p = places[i]
            given, dark = inflow[p - first], current[p] * dark_s[lanes[p]]
            # Neighbours' light counts in the pixel's own slots, whatever their own codes are.
            lit = kept * own[i] + given
            most[i] = _reaching((own[i] if own[i] > lit else lit) + dark, asked.sigmas)
            own[i] = _reaching(own[i] + dark, asked.sigmas)
            gained[i] = given - 4.0 * asked.fraction * total[p] * scale[p]
    found[0] = count
