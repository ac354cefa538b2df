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

TOGETHER = 256
"""Pixels whose sums stay in the cache while the frames go by."""


@record
class Asked:
    """The array: `fraction` of each pixel's light goes to each of its neighbours, `frame_s` seconds
    of dark current are added; the light has `count` frames. There are `kinds` of charge,
    which `places` are asked for."""

    rows: int
    cols: int
    count: int
    lane_count: int
    kinds: int
    places: int
    fraction: float
    frame_s: float
    sigmas: float


@inlined
def _inflow(
    asked: Asked, total: Floats, scale: Floats, p: int, up: int, down: int, left: int, right: int
) -> float:
    """What comes to pixel p from its neighbours, so many places away; from itself where there is
    none."""
    beside = total[p + up] * scale[p + up] + total[p + down] * scale[p + down]
    beside += total[p + left] * scale[p + left] + total[p + right] * scale[p + right]
    missing = (1.0 if up == 0 else 0.0) + (1.0 if down == 0 else 0.0)
    missing += (1.0 if left == 0 else 0.0) + (1.0 if right == 0 else 0.0)
    return float(asked.fraction * (beside - missing * (total[p] * scale[p])))


@inlined
def _most(
    asked: Asked, total: Floats, scale: Floats, current: Floats, part: Floats, lanes: Ints32,
    inflow: Floats, first: int, p: int,
) -> float:  # fmt: skip
    """What pixel p sees at most; `inflow` is that of the row that begins with pixel `first`."""
    light = part[lanes[p]] * (total[p] * scale[p])
    return float(light + inflow[p - first] + current[p] * asked.frame_s)


@loop
def may_saturate(
    asked: Asked,
    total: Annotated[Floats, "rows cols"],
    scale: Annotated[Floats, "rows cols"],
    current: Annotated[Floats, "rows cols"],
    lanes: Annotated[Ints32, "rows cols"],
    part: Annotated[Floats, "lane_count"],
    limit: Annotated[Floats, "lane_count"],
    inflow: Written[Annotated[Floats, "cols"]],
    found: Written[Ints],
    places: Written[Ints],
) -> None:
    """places := where charge is at least the limit of the pixel's lane, in order; `found`: how many
    these are. The charge is the lane's part of the light, `total` times `scale`, with all that
    neighbours give of theirs, and the frame's dark current. `inflow` is scratch; `places` has room
    for all.
    """
    rows, cols, count = asked.rows, asked.cols, 0
    for row in range(rows):
        first, last = row * cols, (row + 1) * cols - 1
        up, down = -cols if row > 0 else 0, cols if row + 1 < rows else 0
        left, right = -1 if cols > 1 else 0, 1 if cols > 1 else 0
        # Those inside have neighbours on both sides: no branch, so LLVM makes vectors.
        for p in range(first + 1, last):
            inflow[p - first] = _inflow(asked, total, scale, p, up, down, -1, 1)
        inflow[0] = _inflow(asked, total, scale, first, up, down, 0, right)
        inflow[cols - 1] = _inflow(asked, total, scale, last, up, down, left, 0)
        many = 0
        for p in range(first, last + 1):
            charge = _most(asked, total, scale, current, part, lanes, inflow, first, p)
            many += 1 if charge >= limit[lanes[p]] else 0
        for p in range(first, last + 1 if many else first):
            charge = _most(asked, total, scale, current, part, lanes, inflow, first, p)
            if charge >= limit[lanes[p]]:
                places[count] = p
                count += 1
    found[0] = count


@compiled
def _see(
    asked: Asked, frames: Floats32, weights: Floats, scale: Floats, lanes: Ints32, places: Ints,
    light: Floats, seen: Floats,
) -> None:  # fmt: skip
    """seen[kind, i] := the light of a kind at the pixels places[i]; each frame passes once."""
    pixels, count, step = asked.rows * asked.cols, asked.places, asked.count * asked.lane_count
    for i in range(asked.kinds * count):
        seen[i] = 0.0
    for first in range(0, count, TOGETHER):
        stop = min(first + TOGETHER, count)
        for k in range(asked.count):
            frame, row = k * pixels, k * asked.lane_count
            for i in range(first, stop):
                light[i - first] = frames[frame + places[i]]
            for kind in range(asked.kinds):
                at, weight = kind * count, kind * step + row
                for i in range(first, stop):
                    seen[at + i] += weights[weight + lanes[places[i]]] * light[i - first]
    for kind in range(asked.kinds):
        for i in range(count):
            seen[kind * count + i] *= scale[places[i]]


@inlined
def _taken(asked: Asked, p: int) -> float:
    """The part of pixel p's light that its neighbours take."""
    row, col = p // asked.cols, p % asked.cols
    count = (1.0 if row > 0 else 0.0) + (1.0 if row + 1 < asked.rows else 0.0)
    count += (1.0 if col > 0 else 0.0) + (1.0 if col + 1 < asked.cols else 0.0)
    return asked.fraction * count


@compiled
def _reaching(charge: float, sigmas: float) -> float:
    """How far a count of this mean may go."""
    return charge + sigmas * math.sqrt(charge)


@loop
def charges_at(
    asked: Asked,
    places: Annotated[Ints, "places"],
    total: Annotated[Floats, "rows cols"],
    scale: Annotated[Floats, "rows cols"],
    current: Annotated[Floats, "rows cols"],
    lanes: Annotated[Ints32, "rows cols"],
    frames: Annotated[Floats32, "count rows cols"],
    weights: Annotated[Floats, "kinds count lane_count"],
    dark_s: Annotated[Floats, "kinds lane_count"],
    light: Written[Floats],
    most: Written[Annotated[Floats, "kinds places"]],
    own: Written[Annotated[Floats, "kinds places"]],
    gained: Written[Annotated[Floats, "places"]],
) -> None:
    """Of some places and each kind of charge `most` := how much it may be: the light of the slots,
    weighed by `weights`, or that with what neighbours give, and the dark charge of `dark_s`
    seconds, `sigmas` standard deviations above their mean; `own`: without neighbours. `gained` :=
    what neighbours give of the frame's light less what they take. `light`: scratch for `TOGETHER`
    pixels.
    """
    rows, cols = asked.rows, asked.cols
    for i in range(asked.places):
        p = places[i]
        row, col = p // cols, p % cols
        up, down = -cols if row > 0 else 0, cols if row + 1 < rows else 0
        left, right = -1 if col > 0 else 0, 1 if col + 1 < cols else 0
        gained[i] = _inflow(asked, total, scale, p, up, down, left, right)
    _see(asked, frames, weights, scale, lanes, places, light, own)
    for kind in range(asked.kinds):
        at = kind * asked.places
        for i in range(asked.places):
            p = places[i]
            dark = current[p] * dark_s[kind * asked.lane_count + lanes[p]]
            # Neighbours' light counts in the pixel's own slots, whatever their own codes are.
            seen_e = own[at + i]
            lit = (1.0 - _taken(asked, p)) * seen_e + gained[i]
            most[at + i] = _reaching((seen_e if seen_e > lit else lit) + dark, asked.sigmas)
            own[at + i] = _reaching(seen_e + dark, asked.sigmas)
    for i in range(asked.places):
        p = places[i]
        gained[i] -= _taken(asked, p) * total[p] * scale[p]
