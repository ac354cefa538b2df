"""Poisson counts of the electrons of pixels, as deviations from their means."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import numpy as np

from nscc.arrays import Floats, Ints
from nscc_runtime.execution.block_draws import DRAW_BLOCK, ROOM, counted
from nscc_runtime.loop import Words, Written, loop, record
from nscc_runtime.noise import RATE_CAP, keys
from nscc_runtime.pool import in_parts


@record
class Counting:
    """Sizes for `draw_counts`. Pixels `begin` to `end` - 1 of `pixels` are counted, in `groups`
    groups of slots. `accumulates`: 1 to add to the deviations of another source, 0 to replace
    them."""

    begin: int
    end: int
    pixels: int
    groups: int
    accumulates: int


@loop
def draw_counts(
    counting: Counting,
    keys: Annotated[Words, "groups"],
    rates: Annotated[Floats, "groups pixels"],
    places: Annotated[Ints, "pixels"],
    values: Written[Floats],
    scratch: Written[Floats],
    pending_rates: Written[Floats],
    pending_pixels: Written[Ints],
    away: Written[Annotated[Floats, "groups pixels"]],
) -> None:
    """Draw a Poisson count of mean rates[g, p] for each group g of slots and pixel p, and set
    away[g, p] to the count minus the mean; with `accumulates`, add it.

    `keys`: the random key of each group. `places`: the place of each pixel on the chip. Arrays of
    two axes are flat here, row after row. `values`, `pending_rates` and `pending_pixels` are
    working memory for `DRAW_BLOCK` pixels, `scratch` for five times as many."""
    for first in range(counting.begin, counting.end, DRAW_BLOCK):
        stop = min(first + DRAW_BLOCK, counting.end)
        for group in range(counting.groups):
            at = group * counting.pixels + first
            for i in range(stop - first):
                values[i] = rates[at + i]
            counted(
                keys[group],
                places,
                first,
                stop,
                values,
                scratch,
                pending_rates,
                pending_pixels,
            )
            for i in range(stop - first):
                # Counts are clipped to the cap, but sums contain the light: no deviation there.
                mean = rates[at + i] if rates[at + i] < RATE_CAP else values[i]
                before = away[at + i] if counting.accumulates else 0.0
                away[at + i] = before + (values[i] - mean)


def draw_deviations(
    sources: Sequence[tuple[int, int, Floats]],
    places: Ints,
    seed: int,
    frame: int,
    threads: int,
) -> Floats:
    """Return the deviations of Poisson counts of electrons from their means, (rows, pixels), added
    up over sources (light and dark charge).

    `sources`, at least one: of each the random stream, the number of the source, and the means
    (rows, pixels). A row is a stretch or group of slots, and row r is drawn with the key of group
    r. `places` (pixels,): places on the chip. `seed`: of the noise. `frame`: number of the frame.
    Results do not depend on `threads`. Slots of a stretch are counted as one number."""
    rows, pixels = sources[0][2].shape
    away = np.empty((rows, pixels))
    # One key for each source and row, so that a draw depends only on these and on the pixel.
    keyed = [(keys(seed, stream, source, frame, rows), means) for stream, source, means in sources]

    def run(begin: int, end: int) -> None:
        """Draw the counts of the pixels `begin` to `end` - 1 from all sources, and write their
        deviations from the means into `away`."""
        values, scratch, pending_rates = np.empty(DRAW_BLOCK), np.empty(ROOM), np.empty(DRAW_BLOCK)
        for number, (of_rows, means) in enumerate(keyed):
            draw_counts(
                counting=Counting(
                    begin=begin,
                    end=end,
                    pixels=pixels,
                    groups=rows,
                    accumulates=int(number > 0),
                ),
                keys=of_rows,
                rates=means,
                places=places,
                away=away,
                values=values,
                scratch=scratch,
                pending_rates=pending_rates,
                pending_pixels=np.empty(DRAW_BLOCK, np.int64),
            )

    in_parts(run, pixels, threads, DRAW_BLOCK)
    return away
