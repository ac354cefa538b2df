"""The loop for frames by weighted sums: exposures from counts and noise.

`nscc_runtime.execution.summed` prepares the arguments that all frames of a scene share."""

from __future__ import annotations

from typing import Annotated

from nscc_runtime.execution.block_draws import BLOCK, drawn_normals
from nscc_runtime.execution.moment_loop import on_side
from nscc_runtime.loop import (
    Floats,
    Floats32,
    Ints,
    Ints32,
    Words,
    Written,
    compiled,
    loop,
    record,
)


@record
class Adding:
    """Sizes for `add_up`. `fraction`: part of a pixel's charge that moves to each neighbour."""

    begin: int
    end: int
    rows: int
    cols: int
    pixels: int
    buckets: int
    lane_count: int
    draws: int
    """Number of counts that are drawn for a pixel; 0 without counts."""
    sources: int
    """Number of sources of small errors."""
    exchanges: int
    """Whether neighbours exchange counts."""
    fraction: float


@compiled
def _beside(
    adding: Adding,
    direction: int,
    draw: int,
    bucket: int,
    first: int,
    stop: int,
    own_weights: Floats32,
    neighbour_weights: Floats32,
    away: Floats,
    total: Floats,
) -> None:
    """Add to total[bucket, i], for pixel first + i, the charge from the neighbour in one
    `direction` minus the charge given to it.

    `away`: deviation of the count of number `draw` from its mean, by pixel. The weights say how
    much of it this bucket of the pixel, or of the neighbour, collects."""
    cols, pixels = adding.cols, adding.pixels
    step, begin, end = on_side(first // cols, adding.rows, cols, direction)
    draw_start = draw * adding.pixels
    own_start = (draw * adding.buckets + bucket) * pixels
    neighbour_start = ((draw * 4 + direction) * adding.buckets + bucket) * pixels
    at = bucket * BLOCK - first
    for p in range(max(begin, first), min(end, stop)):
        given_e = own_weights[own_start + p] * away[draw_start + p]
        received_e = neighbour_weights[neighbour_start + p] * away[draw_start + p + step]
        total[at + p] += adding.fraction * (received_e - given_e)


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
    to counts of photons.

    `away` (draws, pixels) has the deviations of counts; `own_weights` and `neighbour_weights` say
    how much of them each bucket collects."""
    for bucket in range(adding.buckets):
        at = bucket * BLOCK - first
        for p in range(first, stop):
            total[at + p] = 0.0
        for draw in range(adding.draws):
            own_start = (draw * adding.buckets + bucket) * adding.pixels
            draw_start = draw * adding.pixels
            for p in range(first, stop):
                total[at + p] += own_weights[own_start + p] * away[draw_start + p]
            for direction in range(4 if adding.exchanges else 0):
                _beside(
                    adding,
                    direction,
                    draw,
                    bucket,
                    first,
                    stop,
                    own_weights,
                    neighbour_weights,
                    away,
                    total,
                )


@loop
def add_up(
    adding: Adding,
    noise_keys: Annotated[Words, "sources"],
    lanes: Annotated[Ints32, "pixels"],
    places: Annotated[Ints, "pixels"],
    expected: Annotated[Floats, "buckets pixels"],
    away: Annotated[Floats, "draws pixels"],
    own_weights: Annotated[Floats32, "draws buckets pixels"],
    neighbour_weights: Floats32,
    sigma: Annotated[Floats, "sources buckets lane_count"],
    total: Written[Floats],
    drawn: Written[Floats],
    exposure: Written[Annotated[Floats, "buckets pixels"]],
) -> None:
    """Compute exposures of some rows of a frame from their means and from deviations of counts.

    `own_weights`: weights of a pixel's own deviations. `neighbour_weights` (draws, 4, buckets,
    pixels): weights of its neighbours' deviations, used if neighbours exchange counts. `total` and
    `drawn` are working memory for `BLOCK` pixels, `total` for each bucket."""
    pixels, cols, end = adding.pixels, adding.cols, adding.end * adding.cols
    first = adding.begin * cols
    while first < end:
        # With crosstalk a block must not extend over several rows.
        last = (first // cols + 1) * cols if adding.exchanges else end
        stop = min(first + BLOCK, last)
        _counted(adding, first, stop, own_weights, neighbour_weights, away, total)
        for bucket in range(adding.buckets):
            at, pixel_start = bucket * BLOCK, bucket * pixels + first
            for i in range(stop - first):
                total[at + i] += expected[pixel_start + i]
        for source in range(adding.sources):
            drawn_normals(noise_keys[source], places, first, stop - first, drawn)
            for bucket in range(adding.buckets):
                at = bucket * BLOCK
                size = (source * adding.buckets + bucket) * adding.lane_count
                for i in range(stop - first):
                    total[at + i] += sigma[size + lanes[first + i]] * drawn[i]
        for bucket in range(adding.buckets):
            at, pixel_start = bucket * BLOCK, bucket * pixels + first
            for i in range(stop - first):
                exposure[pixel_start + i] = total[at + i] + 0.0
        first = stop
