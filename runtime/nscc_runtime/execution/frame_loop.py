"""The loop for frames by weighted sums: counts, exposures and errors, row after row.

`nscc_runtime.execution.summed` prepares the arguments that all frames of a scene share."""

from __future__ import annotations

from typing import Annotated

from nscc.arrays import Floats, Floats32, Ints, Ints32
from nscc_runtime.execution.block_draws import DRAW_BLOCK, counted
from nscc_runtime.loop import Words, Written, compiled, loop, record
from nscc_runtime.noise.noise_loops import row_normals
from nscc_runtime.noise.poisson_law import RATE_CAP

ROWS_KEPT = 3
"""Number of rows whose counts are in memory: a row, and those above and below it."""


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
def _count(
    adding: Adding,
    row: int,
    count_keys: Words,
    count_means: Floats,
    places: Ints,
    values: Floats,
    scratch: Floats,
    pending_rates: Floats,
    pending_pixels: Ints,
    away: Floats,
) -> None:
    """Draw the counts of electrons of a row, and store their deviations from the means in `away`
    (rows kept, draws, cols), flat. `values`, `scratch` and those that follow: working memory."""
    cols = adding.cols
    for draw in range(adding.count_draws):
        at = (row % ROWS_KEPT * adding.count_draws + draw) * cols
        for begin in range(0, cols, DRAW_BLOCK):
            count, first = min(DRAW_BLOCK, cols - begin), row * cols + begin
            mean_at = draw * adding.pixels + first
            for i in range(count):
                values[i] = count_means[mean_at + i]
            counted(
                count_keys[draw],
                places,
                first,
                first + count,
                values,
                scratch,
                pending_rates,
                pending_pixels,
            )
            for i in range(count):
                mean = count_means[mean_at + i]
                # Counts are clipped to the cap, but sums contain the light: no deviation there.
                away[at + begin + i] = values[i] - mean if mean < RATE_CAP else 0.0


@compiled
def _add_counted(
    adding: Adding,
    row: int,
    bucket: int,
    draw: int,
    own_weights: Floats32,
    neighbour_weights: Floats32,
    away: Floats,
    exposure: Floats,
) -> None:
    """Add to the exposures of a row in a bucket what one draw of counts deviates from its mean: the
    part that the pixel keeps, and that from its neighbours.

    `away` (rows kept, draws, cols): deviations of counts from their means. `own_weights` (draws,
    buckets, pixels) and `neighbour_weights` (draws, 4, buckets, pixels): electrons in each bucket
    for one count of the pixel, and of a neighbour; 0 beyond the border, where a pixel gives nothing
    either."""
    cols, buckets, pixels, draws = adding.cols, adding.buckets, adding.pixels, adding.count_draws
    first, c = row * cols, adding.fraction if adding.exchanges else 0.0
    here = (row % ROWS_KEPT * draws + draw) * cols
    own, out = (draw * buckets + bucket) * pixels + first, bucket * pixels + first
    if not adding.exchanges:
        for i in range(cols):
            exposure[out + i] += own_weights[own + i] * away[here + i]
        return
    # A missing neighbour has the weight 0, so any count can stand for its own.
    has_up, has_down = int(row > 0), int(row + 1 < adding.rows)
    above = ((row + 2 * has_up) % ROWS_KEPT * draws + draw) * cols
    below = ((row + has_down) % ROWS_KEPT * draws + draw) * cols
    up = (draw * 4 * buckets + bucket) * pixels + first
    down, left, right = up + buckets * pixels, up + 2 * buckets * pixels, up + 3 * buckets * pixels
    kept = 1.0 - c * (2 + has_up + has_down)
    for i in range(cols):
        column = neighbour_weights[up + i] * away[above + i]
        column += neighbour_weights[down + i] * away[below + i]
        exposure[out + i] += kept * (own_weights[own + i] * away[here + i]) + c * column
    for i in range(1, cols):
        exposure[out + i] += c * (neighbour_weights[left + i] * away[here + i - 1])
    for i in range(cols - 1):
        exposure[out + i] += c * (neighbour_weights[right + i] * away[here + i + 1])
    for end in range(2):
        i = end * (cols - 1)
        exposure[out + i] += c * (own_weights[own + i] * away[here + i])


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
    values: Written[Floats],
    scratch: Written[Floats],
    pending_rates: Written[Floats],
    pending_pixels: Written[Ints],
    away: Written[Floats],
    drawn: Written[Floats],
    exposure: Written[Annotated[Floats, "buckets pixels"]],
) -> None:
    """Compute the exposures, in electrons, of some rows of a frame. Each is the sum of its mean
    `expected`, of the deviations of Poisson counts of electrons from their means `count_means`, and
    of normal errors.

    `count_keys`, `noise_keys`: the random key of each draw of counts and of errors. `places`: 0 to
    pixels - 1. `sigma`: the standard deviation of each draw of errors in each bucket and lane (the
    pixels of one distinct shutter); `lanes` has the lane of each pixel. `own_weights`: electrons
    for one count of the pixel itself. `neighbour_weights` (draws, 4, buckets, pixels): for one
    count of a neighbour, used if neighbours exchange counts. The other arrays are working memory:
    as for `counted`, `away` for `ROWS_KEPT` rows and draws, `drawn` for a row."""
    cols, pixels, around = adding.cols, adding.pixels, 1 if adding.exchanges else 0
    for counting in range(adding.begin - around, adding.end + around):
        if 0 <= counting < adding.rows:
            _count(
                adding,
                counting,
                count_keys,
                count_means,
                places,
                values,
                scratch,
                pending_rates,
                pending_pixels,
                away,
            )
        row = counting - around
        if row < adding.begin:
            continue
        first = row * cols
        for bucket in range(adding.buckets):
            at = bucket * pixels + first
            for i in range(cols):
                exposure[at + i] = expected[at + i] + 0.0  # -0 + 0 is +0
            for draw in range(adding.count_draws):
                _add_counted(
                    adding, row, bucket, draw, own_weights, neighbour_weights, away, exposure
                )
        for draw in range(adding.error_draws):
            row_normals(noise_keys[draw], row, cols, drawn, 0)
            for bucket in range(adding.buckets):
                at, size = bucket * pixels + first, draw * adding.buckets + bucket
                for i in range(cols):
                    sigma_e = sigma[size * adding.lane_count + lanes[first + i]]
                    exposure[at + i] += sigma_e * drawn[i]
