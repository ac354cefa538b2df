"""The loop for frames by weighted sums: exposures from counts and noise.

`nscc_runtime.execution.summed` prepares the arguments that all frames of a scene share."""

from __future__ import annotations

from typing import Annotated, NamedTuple

from nscc.arrays import Floats, Floats32, Ints, Ints32
from nscc_runtime.execution.block_draws import DRAW_BLOCK, drawn_normals
from nscc_runtime.execution.count_loop import add_deviations
from nscc_runtime.execution.moment_loop import DOWN, UP, on_side
from nscc_runtime.loop import Words, Written, compiled, loop, record

RING = 3
"""Number of rows whose counts are known at a time: a row, and those above and below."""


@record
class Adding:
    """Sizes for `add_up`, which exposes the rows `begin` to `end` - 1 of `rows` rows. `fraction`:
    part of a pixel's charge that moves to each neighbour."""

    begin: int
    end: int
    rows: int
    cols: int
    pixels: int
    buckets: int
    lane_count: int
    count_draws: int
    """Number of counts that are drawn for a pixel; 0 without counts."""
    error_draws: int
    """Number of normal numbers that are drawn for a pixel, for the errors of words."""
    exchanges: int
    """Whether neighbours exchange counts."""
    fraction: float


class FrameScratch(NamedTuple):
    """Working memory of `add_up`. `away` (draws, `RING`, cols): deviations of the counts of a row r
    from their means, in row r % `RING`. `drawn` (cols,): normal numbers. The others are that of
    `add_deviations`."""

    away: Written[Floats]
    drawn: Written[Floats]
    values: Written[Floats]
    scratch: Written[Floats]
    pending_rates: Written[Floats]
    pending_pixels: Written[Ints]


@compiled
def _draw_row(
    adding: Adding, row: int, keys: Words, places: Ints, count_means: Floats, work: FrameScratch
) -> None:
    """Draw the counts of a row: set its deviations from the means `count_means` (draws, pixels) in
    `work.away`. `keys`: the random key of each draw."""
    cols = adding.cols
    for draw in range(adding.count_draws):
        own = (draw * RING + row % RING) * cols
        for i in range(cols):
            work.away[own + i] = 0.0
        for i in range(0, cols, DRAW_BLOCK):
            first = row * cols + i
            add_deviations(
                keys[draw],
                places,
                first,
                min(first + DRAW_BLOCK, (row + 1) * cols),
                count_means,
                draw * adding.pixels + first,
                work.values,
                work.scratch,
                work.pending_rates,
                work.pending_pixels,
                work.away,
                own + i,
            )


@compiled
def _counted(
    adding: Adding,
    row: int,
    own_weights: Floats32,
    neighbour_weights: Floats32,
    away: Floats,
    exposure: Floats,
) -> None:
    """Add to the exposures of a row what counts of photons and of dark charge deviate from their
    means.

    `away`: see `FrameScratch`. `own_weights` (draws, buckets, pixels) and `neighbour_weights`
    (draws, 4, buckets, pixels): electrons in each bucket for one count of the pixel, and of a
    neighbour. All are flat. Pixels at a border get nothing from beyond it, and give nothing
    there."""
    cols, pixels, first = adding.cols, adding.pixels, row * adding.cols
    for bucket in range(adding.buckets):
        out = bucket * pixels
        for draw in range(adding.count_draws):
            own, at = (draw * adding.buckets + bucket) * pixels, draw * RING * cols - first
            here = at + row % RING * cols
            for p in range(first, first + cols):
                exposure[out + p] += own_weights[own + p] * away[here + p]
            for side in range(4 if adding.exchanges else 0):
                step, begin, end = on_side(row, adding.rows, cols, side)
                there = here + step
                if side in (UP, DOWN):
                    there = at + (row + (2 if side == UP else 1)) % RING * cols
                beside = ((draw * 4 + side) * adding.buckets + bucket) * pixels
                for p in range(begin, end):
                    given_e = own_weights[own + p] * away[here + p]
                    received_e = neighbour_weights[beside + p] * away[there + p]
                    exposure[out + p] += adding.fraction * (received_e - given_e)


@loop
def add_up(
    adding: Adding,
    count_keys: Annotated[Words, "count_draws"],
    noise_keys: Annotated[Words, "error_draws"],
    lanes: Annotated[Ints32, "pixels"],
    places: Annotated[Ints, "pixels"],
    expected: Annotated[Floats, "buckets pixels"],
    count_means: Annotated[Floats, "count_draws pixels"],
    own_weights: Annotated[Floats32, "count_draws buckets pixels"],
    neighbour_weights: Floats32,
    sigma: Annotated[Floats, "error_draws buckets lane_count"],
    work: FrameScratch,
    exposure: Written[Annotated[Floats, "buckets pixels"]],
) -> None:
    """Compute the exposures, in electrons, of some rows of a frame. Each is the sum of its mean
    `expected`, of the deviations of Poisson counts from their means `count_means`, and of normal
    errors.

    `count_keys`, `noise_keys`: the random key of each draw of counts and of errors, drawn at
    `places`. `sigma`: the standard deviation of each draw in each bucket and lane (the pixels of
    one distinct shutter); `lanes` has the lane of each pixel. `own_weights`: electrons for one
    count of the pixel itself. `neighbour_weights` (draws, 4, buckets, pixels): for one count of a
    neighbour, used if neighbours exchange counts."""
    pixels, cols, drawn = adding.pixels, adding.cols, work.drawn
    # With crosstalk a row needs the counts of the rows above and below.
    next_row = adding.begin - 1 if adding.exchanges and adding.begin > 0 else adding.begin
    for row in range(adding.begin, adding.end):
        last = row + 1 if adding.exchanges and row + 1 < adding.rows else row
        while next_row <= last:
            _draw_row(adding, next_row, count_keys, places, count_means, work)
            next_row += 1
        first = row * cols
        for bucket in range(adding.buckets):
            at = bucket * pixels + first
            for i in range(cols):
                exposure[at + i] = expected[at + i] + 0.0  # -0 + 0 is +0
        _counted(adding, row, own_weights, neighbour_weights, work.away, exposure)
        for draw in range(adding.error_draws):
            drawn_normals(noise_keys[draw], places, first, cols, drawn, 0)
            for bucket in range(adding.buckets):
                at = bucket * pixels + first
                size = (draw * adding.buckets + bucket) * adding.lane_count
                for i in range(cols):
                    exposure[at + i] += sigma[size + lanes[first + i]] * drawn[i]
