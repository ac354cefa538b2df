"""The loop that completes the moments of a scene's pixels, once for all its frames."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from nscc.arrays import Floats, Floats32
from nscc_runtime.loop import Written, compiled, inlined, loop, record
from nscc_runtime.noise.poisson_law import RATE_CAP

UP, DOWN, LEFT, RIGHT = range(4)
"""Neighbours, in the order of `nscc_runtime.execution.overlap`."""


@inlined
def on_side(row: int, rows: int, cols: int, side: int) -> tuple[int, int, int]:
    """Return the step from the number of a pixel to that of its neighbour on one `side` (UP, DOWN,
    LEFT or RIGHT), and the first pixel and the end (exclusive) of the pixels of `row` that have
    one. In an array of `rows` rows, the two are equal where no pixel has."""
    begin, end = row * cols, (row + 1) * cols
    if side == UP:
        return -cols, begin, end if row > 0 else begin
    if side == DOWN:
        return cols, begin, end if row + 1 < rows else begin
    if side == LEFT:
        return -1, begin + 1, end
    return 1, begin, end - 1


@record
class Completing:
    """Sizes for `complete_moments`, for the rows `begin` to `end` - 1.

    `light_pairs`, `dark_pairs`: numbers of covariances of light and of dark charge, 0 without
    them. `exchanges`: whether neighbours exchange counts. `overlaps`: whether a slot may count in
    several buckets."""

    begin: int
    end: int
    rows: int
    cols: int
    pixels: int
    buckets: int
    rates: int
    light_pairs: int
    dark_pairs: int
    exchanges: int
    overlaps: int


@compiled
def _separate(
    sizes: Completing,
    first: int,
    covariance_e2: Floats,
    electron_weights: Floats32,
    count_means: Floats,
    own_weights: Floats32,
) -> None:
    """Set the means `count_means` (buckets, pixels) of the independent Poisson counts of the row of
    pixels that begins with `first`. If buckets overlap, also set the weights `own_weights` of the
    counts.

    `covariance_e2`: covariances of the row, (pairs of buckets, cols). It becomes L D L^T, where L
    has a unit diagonal, and both replace it. Buckets that depend on earlier ones have no count of
    their own: its mean is 0. `electron_weights` (buckets, pixels): electrons for one count."""
    pixels, cols, buckets = sizes.pixels, sizes.cols, sizes.buckets
    # First a limit below which a remaining variance is a rounding error of the whole variance.
    for a in range(buckets):
        at, own = a * pixels + first, a * (a + 3) // 2 * cols
        for i in range(cols):
            count_means[at + i] = 1e-9 * abs(covariance_e2[own + i])
    for a in range(buckets):
        at, own = a * pixels + first, a * (a + 3) // 2 * cols
        for i in range(cols):
            variance_e2, weight = covariance_e2[own + i], electron_weights[at + i]
            # Written with `not`, so that NaN stays NaN.
            variance_e2 = variance_e2 if not variance_e2 <= count_means[at + i] else 0.0
            covariance_e2[own + i] = variance_e2
            count_means[at + i] = variance_e2 / (weight * weight)
        for b in range(buckets if sizes.overlaps else 0):
            out, pair = (a * buckets + b) * pixels + first, (b * (b + 1) // 2 + a) * cols
            for i in range(cols):
                own_weights[out + i] = electron_weights[at + i] if b == a else 0.0
            for i in range(cols if b > a else 0):
                variance_e2 = covariance_e2[own + i]
                # Without a branch, so that LLVM vectorises the loop.
                part = covariance_e2[pair + i] / (variance_e2 if variance_e2 > 0.0 else np.inf)
                covariance_e2[pair + i] = part
                own_weights[out + i] = part * electron_weights[at + i]
            for c in range(a + 1, b + 1):
                other, both = (c * (c + 1) // 2 + a) * cols, (b * (b + 1) // 2 + c) * cols
                for i in range(cols):
                    known = covariance_e2[pair + i] * covariance_e2[other + i]
                    covariance_e2[both + i] -= known * covariance_e2[own + i]


@loop
def complete_moments(
    sizes: Completing,
    sums: Annotated[Floats, "sums pixels"],
    rate_weights: Annotated[Floats32, "rates pixels"],
    fixed_e: Annotated[Floats32, "buckets pixels"],
    dark_e2: Annotated[Floats32, "dark_pairs pixels"],
    sum_e: Annotated[Floats32, "rows cols"],
    factor: Annotated[Floats32, "pixels"],
    dark_e: Annotated[Floats32, "pixels"],
    unknown: Annotated[Floats32, "4 buckets pixels"],
    electron_weights: Annotated[Floats32, "buckets pixels"],
    covariance_e2: Written[Floats],
    frame_e: Written[Floats],
    mean_e: Written[Annotated[Floats, "buckets pixels"]],
    count_means: Written[Annotated[Floats, "count_draws pixels"]],
    own_weights: Written[Floats32],
) -> None:
    """Compute the moments of pixels from sums of their light: mean exposures, and the means of
    independent Poisson counts.

    `sums`: covariances (e^2) that counts of light cause in pairs of buckets, then exposures (e) for
    each bucket and rate of leakage, which `rate_weights` interpolate. `fixed_e`, `dark_e2`: means
    and covariances that do not depend on the light. `factor` * `sum_e` and `dark_e`: the charge of
    each pixel in the frame; of that of the neighbour on each side, the part `unknown` is a variance
    that does not follow from its counts. `electron_weights`: electrons in a bucket for one count.

    Results: `mean_e`, the means `count_means`, and `own_weights` (draws, buckets, pixels), which is
    set only if buckets overlap. Without counts only `mean_e` is set. `covariance_e2` is working
    memory for a row: (pairs, cols), flat, where pair a * (a + 1) / 2 + b is that of the buckets a
    >= b; values above `RATE_CAP` are set to it. `frame_e` is that for three rows."""
    pixels, cols = sizes.pixels, sizes.cols
    for row in range(sizes.begin, sizes.end):
        first, stop = row * cols, (row + 1) * cols
        for bucket in range(sizes.buckets):
            at = bucket * pixels
            for rate in range(sizes.rates):
                sum_at = (sizes.light_pairs + bucket * sizes.rates + rate) * pixels
                for p in range(first, stop):
                    before = mean_e[at + p] if rate else fixed_e[at + p]
                    mean_e[at + p] = before + rate_weights[rate * pixels + p] * sums[sum_at + p]
        if not (sizes.light_pairs or sizes.dark_pairs):
            continue
        for pair in range(sizes.buckets * (sizes.buckets + 1) // 2):
            at, here = pair * pixels, pair * cols - first
            for p in range(first, stop):
                light_e2 = sums[at + p] if sizes.light_pairs else 0.0
                covariance_e2[here + p] = light_e2 + (dark_e2[at + p] if sizes.dark_pairs else 0.0)
        # Buckets share no charge whose count is unknown: it adds to variances only.
        above, below = max(row - 1, 0) * cols, min(row + 2, sizes.rows) * cols
        for p in range(above, below if sizes.exchanges else above):
            light_e = factor[p] * sum_e[p] if sizes.light_pairs else 0.0
            light_e = min(light_e, RATE_CAP) if light_e >= 0.0 else 0.0  # 0 for NaN
            frame_e[p - above] = dark_e[p] + light_e
        for bucket in range(sizes.buckets if sizes.exchanges else 0):
            here = bucket * (bucket + 3) // 2 * cols - first
            for side in range(4):
                step, begin, end = on_side(row, sizes.rows, cols, side)
                of_side = (side * sizes.buckets + bucket) * pixels
                for p in range(begin, end):
                    covariance_e2[here + p] += unknown[of_side + p] * frame_e[p + step - above]
        for i in range(sizes.buckets * (sizes.buckets + 1) // 2 * cols):
            covariance_e2[i] = RATE_CAP if covariance_e2[i] > RATE_CAP else covariance_e2[i]
        _separate(sizes, first, covariance_e2, electron_weights, count_means, own_weights)
