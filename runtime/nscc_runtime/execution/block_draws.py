"""Counts of a block of pixels, for the loops over the pixels of a frame.

Random numbers are keyed by place, the index of a pixel on the chip. `scratch` (`ROOM` numbers),
`pending_rates` and `pending_pixels` (`DRAW_BLOCK` each) are working memory of the loops."""

from __future__ import annotations

import math

import numpy as np

from nscc.arrays import Floats, Ints
from nscc_runtime.loop import compiled, inlined
from nscc_runtime.noise.gaussian import normal_fast
from nscc_runtime.noise.noise_loops import uniform
from nscc_runtime.noise.poisson_law import (
    RATE_CAP,
    SEARCH_BELOW,
    SETTLED_ABOVE,
    exp_minus,
    quantile,
)

DRAW_BLOCK = 1024
"""Number of pixels of a block."""

ROOM = 5 * DRAW_BLOCK
"""Length of the array `scratch` for drawing counts."""

MOST_COUNTED = 80
"""The search for a count ends here; for rates below SEARCH_BELOW larger counts do not occur."""
_NOTHING = 1e-17
"""A probability below which the search for a count ends: it would not change the sum of 1."""

FORMULA_FROM = 2.0
"""Smallest rate for the formula. Below, the formula's value is too often near a whole number."""
MARGIN = 0.02
"""The formula's value is not used if it is nearer to a whole number than MARGIN (1 + |z|**5) /
rate**1.5. Its error is at most 0.016 (1 + |z|**5) / rate**1.5 between FORMULA_FROM and
SEARCH_BELOW."""
_UNSURE = -1.0
"""In place of a count: it must be searched. Counts are never negative."""
_FEW = 8
"""The formula is used if more than one pixel in this number has a rate for the formula."""


@compiled
def _searched(
    count: int,
    pending_rates: Floats,
    places: Ints,
    remainder_at: int,
    mass_at: int,
    count_at: int,
    scratch: Floats,
    out: int,
) -> None:
    """Find the Poisson counts of `count` pixels with rates of at most SEARCH_BELOW, as
    `poisson_law.search` does; nothing for 0 pixels.

    scratch[out + places[j]] is set to the count for the rate pending_rates[j] and the uniform
    number scratch[remainder_at + j]; places[j] is an index in the block. `remainder_at`, `mass_at`
    and `count_at` begin three parts of `scratch` of `count` numbers each, which are overwritten, as
    are `pending_rates` and `places`. All pixels advance together; finished pixels are removed in
    between."""
    for j in range(count):
        start = exp_minus(pending_rates[j])
        scratch[mass_at + j] = start
        scratch[remainder_at + j] -= start
        scratch[count_at + j] = 0.0
    # Removing finished pixels takes time too, so it is done after 4 steps, then 8, 16 and so on.
    step, together = 1, 4
    while count:
        end = min(step + together, MOST_COUNTED)
        for k in range(step, end):
            inverse = 1.0 / k
            for j in range(count):
                next_mass = scratch[mass_at + j] * (pending_rates[j] * inverse)
                remainder = scratch[remainder_at + j]
                scratch[mass_at + j] = next_mass
                scratch[remainder_at + j] = remainder - next_mass
                scratch[count_at + j] += 1.0 if remainder > 0.0 and next_mass > _NOTHING else 0.0
        going = 0
        for j in range(count):
            place = places[j]
            scratch[out + place] = scratch[count_at + j]
            scratch[remainder_at + going] = scratch[remainder_at + j]
            scratch[mass_at + going] = scratch[mass_at + j]
            scratch[count_at + going] = scratch[count_at + j]
            pending_rates[going], places[going] = pending_rates[j], place
            on = scratch[remainder_at + j] > 0.0 and scratch[mass_at + j] > _NOTHING
            going += 1 if on else 0
        count = going if end < MOST_COUNTED else 0
        step, together = end, 2 * together


@compiled
def _decided(count: int, rates: Floats, scratch: Floats, out: int) -> None:
    """Find the counts of `count` pixels by the formula, where its value is certain.

    scratch[out + i] is set to the Poisson quantile, rounded down, at the normal number scratch[i]
    and the rate rates[i], which is limited to SEARCH_BELOW. It is _UNSURE where the formula is
    uncertain, also for all rates below FORMULA_FROM, and 0 for rates of at least SETTLED_ABOVE,
    whose counts `_raised` computes."""
    for i in range(count):
        rate, z = rates[i], scratch[i]
        known = rate if rate > FORMULA_FROM else FORMULA_FROM
        known = known if known < SEARCH_BELOW else SEARCH_BELOW
        x = quantile(z, known)
        lower_count, square = np.floor(x), z * z
        margin = MARGIN * (1.0 + abs(z) * square * square) / (known * math.sqrt(known))
        sure = rate >= FORMULA_FROM and x - lower_count > margin and x - lower_count < 1.0 - margin
        decided = (lower_count if lower_count > 0.0 else 0.0) if sure else _UNSURE
        scratch[out + i] = 0.0 if rate >= SETTLED_ABOVE else decided


@compiled
def _raised(count: int, rates: Floats, scratch: Floats, out: int) -> None:
    """Raise scratch[out + i] to the formula's count at the normal number scratch[i], for each of
    `count` pixels with a rate of at least SEARCH_BELOW. Other counts stay.

    Before, scratch[out + i] contains the count at SEARCH_BELOW for rates from there up to
    SETTLED_ABOVE: the formula's error must not give a larger rate a smaller count."""
    for i in range(count):
        rate = rates[i]
        x = np.floor(quantile(scratch[i], rate if rate > SEARCH_BELOW else SEARCH_BELOW))
        x = x if rate >= SEARCH_BELOW else 0.0
        least = scratch[out + i]
        scratch[out + i] = x if x > least else least


@inlined
def drawn_normals(
    stream: np.uint64, places: Ints, first: int, count: int, out: Floats, at: int
) -> None:
    """Set out[at + i], for i below `count`, to the standard normal number of the random key
    `stream` at places[first + i]. The two steps are separate loops, because a single loop runs out
    of processor registers."""
    for i in range(count):
        out[at + i] = uniform(stream, places[first + i])
    for i in range(count):
        out[at + i] = float(normal_fast(out[at + i]))


@compiled
def counted(
    stream: np.uint64,
    places: Ints,
    first: int,
    stop: int,
    values: Floats,
    scratch: Floats,
    pending_rates: Floats,
    pending_pixels: Ints,
) -> None:
    """Replace the rates values[i] by Poisson counts drawn with the random key `stream` at
    places[first + i], for i from 0 to stop - first - 1, at most `DRAW_BLOCK` pixels.

    For rates below SEARCH_BELOW they equal those of `nscc_runtime.noise.poisson_law.search`, else
    `quantile` rounded down; below SETTLED_ABOVE, they are at least the count at SEARCH_BELOW. Rates
    are clipped to 0..`RATE_CAP`; NaN counts as 0."""
    count, low, middle, high = stop - first, 0, 0, 0
    for i in range(count):
        rate = values[i] if values[i] > 0.0 else 0.0
        values[i] = rate if rate < RATE_CAP else RATE_CAP
    # How many pixels are below the range in which the formula is used without a check, within the
    # range in which it is checked, and in that in which counts are raised.
    for i in range(count):
        low += 1 if values[i] < SETTLED_ABOVE else 0
        middle += 1 if values[i] >= FORMULA_FROM and values[i] < SETTLED_ABOVE else 0
        high += 1 if values[i] >= SEARCH_BELOW else 0
    if not low:
        drawn_normals(stream, places, first, count, scratch, 0)
        for i in range(count):
            x = np.floor(quantile(scratch[i], values[i]))
            values[i] = x if x > 0.0 else 0.0
        return
    uniforms, normals, counts = DRAW_BLOCK, 0, 2 * DRAW_BLOCK
    for i in range(count):
        scratch[uniforms + i] = uniform(stream, places[first + i])
    uses_formula = middle > count // _FEW
    if uses_formula or high:
        for i in range(count):
            scratch[normals + i] = float(normal_fast(scratch[uniforms + i]))
    if uses_formula:
        _decided(count, values, scratch, counts)
    else:
        for i in range(count):
            # exp(-rate) is at least 1 - rate, so the count is 0 if u is at most 1 - rate.
            is_unsure = values[i] < SETTLED_ABOVE and scratch[uniforms + i] > 1.0 - values[i]
            scratch[counts + i] = _UNSURE if is_unsure else 0.0
    unsure = 0
    for i in range(count):
        # Written for every pixel, and overwritten by the next if this one is sure: no branch.
        pending_pixels[unsure] = i
        unsure += 1 if scratch[counts + i] < 0.0 else 0
    for j in range(unsure):
        rate = values[pending_pixels[j]]
        pending_rates[j] = rate if rate < SEARCH_BELOW else SEARCH_BELOW
        scratch[uniforms + j] = scratch[uniforms + pending_pixels[j]]
    _searched(
        unsure,
        pending_rates,
        pending_pixels,
        uniforms,
        3 * DRAW_BLOCK,
        4 * DRAW_BLOCK,
        scratch,
        counts,
    )
    if high:
        _raised(count, values, scratch, counts)
    for i in range(count):
        values[i] = scratch[counts + i]
