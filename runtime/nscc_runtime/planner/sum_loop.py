"""The loops that add up light, each frame weighted by the pixel's lane, and smear it.

`nscc_runtime.planner.sums` has checked what they are given.
"""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc_runtime.loop import (
    Bytes,
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

BLOCK = 512
"""Pixels whose sums stay in the cache while the frames go by."""

TOGETHER = 4
"""Frames that are added for one time through the sums."""
FEW = 4
"""So many lanes have their weights chosen, not looked up: tables of fewer are filled up."""

DARK, EVEN, MIXED = range(3)
"""A frame's weights: all 0, one for all lanes, or any."""


@inlined
def _of_four(lane: int, a: float, b: float, c: float, d: float) -> float:
    """The weight of one of four lanes: chosen, not looked up, so that LLVM makes vectors."""
    low = b if lane == 1 else a
    high = d if lane == 3 else c
    return high if lane > 1 else low


@compiled
def _add_one(
    source: Floats32, at: int, table: Floats, row: int, lane_count: int, lanes: Ints32, first: int,
    stop: int, out: Floats, to: int,
) -> None:  # fmt: skip
    """out[to + p] += source[at + p] times the weight of the lane of p in a row of the table."""
    if lane_count == FEW:
        a, b, c, d = table[row], table[row + 1], table[row + 2], table[row + 3]
        for p in range(first, stop):
            out[to + p] += _of_four(lanes[p], a, b, c, d) * source[at + p]
    else:
        for p in range(first, stop):
            out[to + p] += table[row + lanes[p]] * source[at + p]


@compiled
def _add_four(
    source: Floats32, at: int, step: int, table: Floats, row: int, lane_count: int, lanes: Ints32,
    first: int, stop: int, out: Floats, to: int,
) -> None:  # fmt: skip
    """The same of four frames `step` apart, one after the other, for one time through `out`."""
    for p in range(first, stop):
        lane = row + lanes[p]
        total = out[to + p] + table[lane] * source[at + p]
        total += table[lane + lane_count] * source[at + step + p]
        total += table[lane + 2 * lane_count] * source[at + 2 * step + p]
        out[to + p] = total + table[lane + 3 * lane_count] * source[at + 3 * step + p]


@compiled
def _add_even(
    source: Floats32, at: int, step: int, table: Floats, row: int, lane_count: int, first: int,
    stop: int, out: Floats, to: int,
) -> None:  # fmt: skip
    """The same of four frames that have one weight for all lanes each."""
    a, b = table[row], table[row + lane_count]
    c, d = table[row + 2 * lane_count], table[row + 3 * lane_count]
    for p in range(first, stop):
        total = out[to + p] + a * source[at + p]
        total += b * source[at + step + p]
        total += c * source[at + 2 * step + p]
        out[to + p] = total + d * source[at + 3 * step + p]


@compiled
def _add(
    source: Floats32, at: int, step: int, together: int, table: Floats, row: int, lane_count: int,
    kinds: Bytes, kind: int, lanes: Ints32, first: int, stop: int, out: Floats, to: int,
) -> None:  # fmt: skip
    """out[to + p] += up to `TOGETHER` frames, each weighted by lane; kinds[kind ..]: of weights."""
    most = DARK
    for k in range(kind, kind + together):
        most = max(most, kinds[k])
    if most == DARK:
        return
    if together == TOGETHER and most == EVEN:
        _add_even(source, at, step, table, row, lane_count, first, stop, out, to)
    elif together == TOGETHER and lane_count != FEW:
        _add_four(source, at, step, table, row, lane_count, lanes, first, stop, out, to)
    else:
        for k in range(together):
            if kinds[kind + k] != DARK:
                _add_one(
                    source, at + k * step, table, row + k * lane_count, lane_count, lanes, first,
                    stop, out, to,
                )  # fmt: skip


@record
class SumSizes:
    """How much there is of everything; `begin` and `end` say which pixels are to be done."""

    pixels: int
    begin: int
    end: int
    count: int
    lane_count: int
    sums: int


@loop
def weighted_sums(
    sizes: SumSizes,
    frames: Annotated[Floats32, "count pixels"],
    lanes: Annotated[Ints32, "pixels"],
    table: Annotated[Floats, "sums count lane_count"],
    kinds: Annotated[Bytes, "sums count"],
    out: Written[Annotated[Floats, "sums pixels"]],
) -> None:
    """out[j, p] := the sum over k of table[j, k, lanes[p]] * frames[k, p].

    Products and sums in float64, frame after frame. `kinds`: of the frames' weights.
    """
    pixels, end, count, lane_count = sizes.pixels, sizes.end, sizes.count, sizes.lane_count
    for first in range(sizes.begin, end, BLOCK):
        stop = min(first + BLOCK, end)
        for j in range(sizes.sums):
            for p in range(first, stop):
                out[j * pixels + p] = 0.0
        for k in range(0, count, TOGETHER):
            together = min(TOGETHER, count - k)
            for j in range(sizes.sums):
                kind = j * count + k
                _add(
                    frames, k * pixels, pixels, together, table, kind * lane_count, lane_count,
                    kinds, kind, lanes, first, stop, out, j * pixels,
                )  # fmt: skip


@record
class SceneSizes:
    """The size of the frames, of which the rows from `begin` to `end` - 1 are to be done.

    Sums from number `smeared` on are of light that neighbours have exchanged `fraction` of.
    """

    begin: int
    end: int
    rows: int
    cols: int
    count: int
    lane_count: int
    sums: int
    smeared: int
    fraction: float


@inlined
def _moved(
    frames: Floats32, share: Floats32, frame: int, p: int, up: int, down: int, left: int,
    right: int, c: np.float32,
) -> np.float32:  # fmt: skip
    """The light of pixel p of a frame once its neighbours, so many places away, have exchanged."""
    own = share[p] * frames[frame + p]
    four = (
        share[p + up] * frames[frame + p + up]
        + share[p + down] * frames[frame + p + down]
        + share[p + left] * frames[frame + p + left]
        + share[p + right] * frames[frame + p + right]
    )
    found: np.float32 = own + c * (four - np.float32(4.0) * own)
    return found


@compiled
def _smear(
    sizes: SceneSizes, frames: Floats32, share: Floats32, frame: int, first: int, stop: int,
    lit: Floats32, at: int,
) -> None:  # fmt: skip
    """lit[at + i] := q + fraction laplacian(q) at pixel first + i, q = share * frame; the border
    reflects. The pixels are of one row.
    """
    cols, c = sizes.cols, np.float32(sizes.fraction)
    row = first // cols
    up = -cols if row > 0 else 0
    down = cols if row + 1 < sizes.rows else 0
    # Those inside have all neighbours: no branch, so LLVM makes vectors.
    for p in range(first + 1, stop - 1):
        lit[at + p - first] = _moved(frames, share, frame, p, up, down, -1, 1, c)
    left, right = -1 if first % cols else 0, 1 if first + 1 < (row + 1) * cols else 0
    lit[at] = _moved(frames, share, frame, first, up, down, left, right, c)
    left, right = -1 if (stop - 1) % cols else 0, 1 if stop % cols else 0
    lit[at + stop - 1 - first] = _moved(frames, share, frame, stop - 1, up, down, left, right, c)


@compiled
def _gather(
    source: Floats32, at: int, step: int, count: int, first: int, stop: int, gathered: Floats
) -> None:
    """gathered[i] += what `count` frames, `step` apart, have at first + i."""
    for k in range(0, count - count % TOGETHER, TOGETHER):
        frame = at + k * step
        for p in range(first, stop):
            total = gathered[p - first] + source[frame + p]
            total += source[frame + step + p]
            total += source[frame + 2 * step + p]
            gathered[p - first] = total + source[frame + 3 * step + p]
    for k in range(count - count % TOGETHER, count):
        frame = at + k * step
        for p in range(first, stop):
            gathered[p - first] += source[frame + p]


@compiled
def _add_gathered(
    gathered: Floats, table: Floats, row: int, lane_count: int, kind: int, lanes: Ints32,
    first: int, stop: int, out: Floats, to: int,
) -> None:  # fmt: skip
    """out[to + p] += gathered[p - first] times the weight of the lane of p in a table's row."""
    if kind == DARK:
        return
    if kind == EVEN:
        even = table[row]
        for p in range(first, stop):
            out[to + p] += even * gathered[p - first]
    elif lane_count == FEW:
        a, b, c, d = table[row], table[row + 1], table[row + 2], table[row + 3]
        for p in range(first, stop):
            out[to + p] += _of_four(lanes[p], a, b, c, d) * gathered[p - first]
    else:
        for p in range(first, stop):
            out[to + p] += table[row + lanes[p]] * gathered[p - first]


@compiled
def _gather_smeared(
    sizes: SceneSizes, frames: Floats32, share: Floats32, k: int, count: int, first: int,
    stop: int, lit: Floats32, gathered: Floats,
) -> None:  # fmt: skip
    """As `_gather`, of frames k .. k + count - 1 once neighbours have exchanged their light."""
    pixels = sizes.rows * sizes.cols
    for near in range(0, count, TOGETHER):
        together = min(TOGETHER, count - near)
        for each in range(together):
            frame = (k + near + each) * pixels
            _smear(sizes, frames, share, frame, first, stop, lit, each * BLOCK)
        _gather(lit, -first, BLOCK, together, first, stop, gathered)


@compiled
def _add_alike(
    sizes: SceneSizes, frames: Floats32, share: Floats32, k: int, alike: int, table: Floats,
    kinds: Bytes, lanes: Ints32, first: int, stop: int, lit: Floats32, gathered: Floats,
    out: Floats,
) -> None:  # fmt: skip
    """Add the frames from k on, whose weights are alike, to all sums."""
    pixels, count, lane_count = sizes.rows * sizes.cols, sizes.count, sizes.lane_count
    for smeared in range(2):
        begin, end = sizes.smeared * smeared, sizes.sums if smeared else sizes.smeared
        most = DARK
        for j in range(begin, end):
            most = max(most, kinds[j * count + k])
        if most == DARK:
            continue
        for i in range(stop - first):
            gathered[i] = 0.0
        if smeared:
            _gather_smeared(sizes, frames, share, k, alike, first, stop, lit, gathered)
        else:
            _gather(frames, k * pixels, pixels, alike, first, stop, gathered)
        for j in range(begin, end):
            kind = j * count + k
            _add_gathered(
                gathered, table, kind * lane_count, lane_count, kinds[kind], lanes, first, stop,
                out, j * pixels,
            )  # fmt: skip


@compiled
def _add_each(
    sizes: SceneSizes, frames: Floats32, share: Floats32, k: int, together: int, table: Floats,
    kinds: Bytes, lanes: Ints32, first: int, stop: int, lit: Floats32, out: Floats,
) -> None:  # fmt: skip
    """Add up to `TOGETHER` frames from k on to all sums."""
    pixels, count, lane_count = sizes.rows * sizes.cols, sizes.count, sizes.lane_count
    if sizes.smeared < sizes.sums:
        for near in range(together):
            frame = (k + near) * pixels
            _smear(sizes, frames, share, frame, first, stop, lit, near * BLOCK)
    for j in range(sizes.smeared):
        kind = j * count + k
        _add(
            frames, k * pixels, pixels, together, table, kind * lane_count, lane_count, kinds,
            kind, lanes, first, stop, out, j * pixels,
        )  # fmt: skip
    for j in range(sizes.smeared, sizes.sums):
        kind = j * count + k
        _add(
            lit, -first, BLOCK, together, table, kind * lane_count, lane_count, kinds, kind,
            lanes, first, stop, out, j * pixels,
        )  # fmt: skip


@loop
def scene_sums(
    sizes: SceneSizes,
    frames: Annotated[Floats32, "count rows cols"],
    scale: Annotated[Floats, "rows cols"],
    share: Floats32,
    lanes: Annotated[Ints32, "rows cols"],
    table: Annotated[Floats, "sums count lane_count"],
    kinds: Annotated[Bytes, "sums count"],
    alike: Annotated[Ints, "count"],
    lit: Written[Floats32],
    gathered: Written[Floats],
    out: Written[Annotated[Floats, "sums rows cols"]],
) -> None:
    """out[j, p] := the sum over k of table[j, k, lanes[p]] * scale[p] * frames[k, p].

    The frames pass once, for all sums. Products and sums in float64, frame after frame; smeared
    light in float32. `share`: the scale in float32 where light is smeared. `kinds`: of the frames'
    weights; `alike`: with how many after it each frame has all its weights in common, itself
    included: they are added up before they are weighted. `lit`, `gathered`: scratch for `TOGETHER`
    times `BLOCK` pixels, and for `BLOCK`.
    """
    cols, count, pixels = sizes.cols, sizes.count, sizes.rows * sizes.cols
    for row in range(sizes.begin, sizes.end):
        for first in range(row * cols, (row + 1) * cols, BLOCK):
            stop = min(first + BLOCK, (row + 1) * cols)
            for j in range(sizes.sums):
                for p in range(first, stop):
                    out[j * pixels + p] = 0.0
            k = 0
            while k < count:
                if alike[k] > 1:
                    _add_alike(
                        sizes, frames, share, k, alike[k], table, kinds, lanes, first, stop, lit,
                        gathered, out,
                    )  # fmt: skip
                    k += alike[k]
                    continue
                together = 1
                while together < TOGETHER and k + together < count and alike[k + together] == 1:
                    together += 1
                _add_each(
                    sizes, frames, share, k, together, table, kinds, lanes, first, stop, lit, out
                )
                k += together
            for j in range(sizes.smeared):
                for p in range(first, stop):
                    out[j * pixels + p] *= scale[p]
