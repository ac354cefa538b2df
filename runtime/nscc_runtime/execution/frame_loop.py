"""The loop for frames by weighted sums: exposures from counts and noise.

`nscc_runtime.execution.summed` prepares the arguments that all frames of a scene share."""

from __future__ import annotations

from typing import Annotated

from nscc.arrays import Floats, Floats32, Ints, Ints32
from nscc_runtime.execution.block_draws import DRAW_BLOCK, drawn_normals
from nscc_runtime.execution.moment_loop import on_side
from nscc_runtime.loop import Words, Written, compiled, loop, record


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


@compiled
def _counted(
    adding: Adding,
    first: int,
    stop: int,
    own_weights: Floats32,
    neighbour_weights: Floats32,
    away: Floats,
    total: Floats,
) -> None:
    """Set total[bucket, i] to the deviation of the exposure of pixel first + i from its mean, due
    to counts of photons and of dark charge; 0 without counts. Pixels `first` to `stop` - 1 are
    computed; if neighbours exchange counts, they are in one row.

    `away` (draws, pixels): deviations of counts from their means. `own_weights` (draws, buckets,
    pixels) and `neighbour_weights` (draws, 4, buckets, pixels): electrons in each bucket for one
    count of the pixel, and of a neighbour. All are flat. Pixels at a border get nothing from beyond
    it, and give nothing there."""
    cols, pixels = adding.cols, adding.pixels
    for bucket in range(adding.buckets):
        at = bucket * DRAW_BLOCK - first
        for p in range(first, stop):
            total[at + p] = 0.0
        for draw in range(adding.count_draws):
            own, draw_start = (draw * adding.buckets + bucket) * pixels, draw * pixels
            for p in range(first, stop):
                total[at + p] += own_weights[own + p] * away[draw_start + p]
            for side in range(4 if adding.exchanges else 0):
                step, begin, end = on_side(first // cols, adding.rows, cols, side)
                beside = ((draw * 4 + side) * adding.buckets + bucket) * pixels
                for p in range(max(begin, first), min(end, stop)):
                    given_e = own_weights[own + p] * away[draw_start + p]
                    received_e = neighbour_weights[beside + p] * away[draw_start + p + step]
                    total[at + p] += adding.fraction * (received_e - given_e)


@loop
def add_up(
    adding: Adding,
    noise_keys: Annotated[Words, "error_draws"],
    lanes: Annotated[Ints32, "pixels"],
    places: Annotated[Ints, "pixels"],
    expected: Annotated[Floats, "buckets pixels"],
    away: Annotated[Floats, "count_draws pixels"],
    own_weights: Annotated[Floats32, "count_draws buckets pixels"],
    neighbour_weights: Floats32,
    sigma: Annotated[Floats, "error_draws buckets lane_count"],
    total: Written[Floats],
    drawn: Written[Floats],
    exposure: Written[Annotated[Floats, "buckets pixels"]],
) -> None:
    """Compute the exposures, in electrons, of some rows of a frame. Each is the sum of its mean
    `expected`, of the deviations `away` of Poisson counts of electrons from their means, and of
    normal errors.

    `noise_keys`: the random key of each draw of errors, drawn at `places`. `sigma`: the standard
    deviation of each draw in each bucket and lane (the pixels of one distinct shutter); `lanes`
    has the lane of each pixel. `own_weights`: electrons for one count of the pixel itself.
    `neighbour_weights` (draws, 4, buckets, pixels): for one count of a neighbour, used if
    neighbours exchange counts. `total` and `drawn` are working memory for `DRAW_BLOCK` pixels,
    `total` for each bucket."""
    pixels, cols, end = adding.pixels, adding.cols, adding.end * adding.cols
    first = adding.begin * cols
    while first < end:
        # With crosstalk a block must not extend over several rows: `_counted` has one row's limits.
        last = (first // cols + 1) * cols if adding.exchanges else end
        stop = min(first + DRAW_BLOCK, last)
        _counted(adding, first, stop, own_weights, neighbour_weights, away, total)
        for bucket in range(adding.buckets):
            at, pixel_start = bucket * DRAW_BLOCK, bucket * pixels + first
            for i in range(stop - first):
                total[at + i] += expected[pixel_start + i]
        for draw in range(adding.error_draws):
            drawn_normals(noise_keys[draw], places, first, stop - first, drawn, 0)
            for bucket in range(adding.buckets):
                at = bucket * DRAW_BLOCK
                size = (draw * adding.buckets + bucket) * adding.lane_count
                for i in range(stop - first):
                    total[at + i] += sigma[size + lanes[first + i]] * drawn[i]
        for bucket in range(adding.buckets):
            at, pixel_start = bucket * DRAW_BLOCK, bucket * pixels + first
            for i in range(stop - first):
                exposure[pixel_start + i] = total[at + i] + 0.0  # -0 + 0 is +0
        first = stop
