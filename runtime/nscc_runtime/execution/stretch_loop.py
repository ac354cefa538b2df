"""The charge of stretches of slots: its mean, once for a scene, and its counts, in every frame.

A stretch is the time between two boundaries at which words of a pixel's code read or reset PIX. A
site is a pixel that runs through its words or, with crosstalk, a neighbour of such a pixel. Pixels
exchange counted charge: what a neighbour collects in a stretch of the pixel is the neighbour's own
count, in proportion to time, and a normal number for the part that is not known then."""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np

from nscc_runtime.loop import Floats, Ints, Ints32, Written, compiled, inlined, loop, record
from nscc_runtime.noise.gaussian import normal_fast
from nscc_runtime.noise.keys import bits, unit
from nscc_runtime.sizes_loop import LightMatrix

NEIGHBOURS = 4
TOGETHER = 16
"""Number of sites whose light is added up together."""
_FIRST_LANE = np.uint64(0)


class Stretches(NamedTuple):
    """The stretches of each lane: lane l has the boundaries boundary[start[l] : start[l + 1]], from
    slot 0 to the number of slots. `start_s`: the time at which each slot begins, and the end of the
    frame."""

    start: Annotated[Ints, "lanes+1"]
    boundary: Annotated[Ints32, "boundaries"]
    start_s: Annotated[Floats, "slots+1"]


class Sites(NamedTuple):
    """The sites. `place`: on the chip. `lane`: whose stretches the site has. `factor`: of its
    light. `dark_e_per_s`: its dark current. `beside`: the sites above, below, left and right of
    each pixel that runs through its words, -1 beyond the border."""

    place: Annotated[Ints, "sites"]
    lane: Annotated[Ints32, "sites"]
    factor: Annotated[Floats, "sites"]
    dark_e_per_s: Annotated[Floats, "sites"]
    beside: Annotated[Ints32, "own 4"]


class StretchMeans(NamedTuple):
    """Means of the charge of stretches in electrons.

    `lit`, `dark`: counted charge of the sites. `charge`: charge of the pixels after crosstalk.
    `pace`: the fraction of it that is collected per microsecond of the stretch's first slot, then,
    after the pixel's last stretch, of the last slot. `missing_e2`: the variance of neighbours'
    counts that the counts of their own stretches do not determine."""

    lit: Written[Floats]
    dark: Written[Floats]
    charge: Written[Floats]
    pace: Written[Floats]
    missing_e2: Written[Floats]


@record
class Laying:
    """Sizes and switches for the means: sites or pixels `begin` to `end` - 1."""

    begin: int
    end: int
    sites: int
    slots: int
    own: int
    """Number of pixels that run through their words: the first sites. `pixels`: on the chip."""
    pixels: int
    even: int
    """Whether all slots have the same light."""
    counts_light: int
    counts_dark: int
    slow_words: int
    exchanged: float
    """Fraction of a pixel's charge that moves to each neighbour."""
    rate_cap: float


@compiled
def _light_of_slot(sizes: Laying, light: LightMatrix, sites: Sites, n: int, site: int) -> float:
    """Return the mean light of slot n at a site, in electrons."""
    total, place = 0.0, sites.place[site]
    for k in range(light.row_start[n], light.row_start[n + 1]):
        at = light.frame_index[k] * sizes.pixels + place
        total += float(light.frames[at]) * light.weight[k]
    # Rounded like `Light.slot`. Light below 0 is none; NaN stays NaN.
    rate = float(np.float32(total)) * sites.factor[site]
    rate = 0.0 if rate < 0.0 else rate
    capped: float = sizes.rate_cap if rate > sizes.rate_cap else rate
    return capped


@compiled
def _exchanged(sizes: Laying, light: LightMatrix, sites: Sites, n: int, i: int, own: float) -> float:
    """Return the light of slot n that pixel i collects after crosstalk; `own`: before."""
    flow = 0.0
    for side in range(NEIGHBOURS if sizes.exchanged > 0.0 else 0):
        other = sites.beside[NEIGHBOURS * i + side]
        if other >= 0:
            flow += _light_of_slot(sizes, light, sites, n, other) - own
    return own + sizes.exchanged * flow


@inlined
def _store(
    sizes: Laying, means: StretchMeans, e: int, i: int, slots: int, own: float, total: float
) -> None:
    """Add `slots` slots to the light of stretch e of site i."""
    if sizes.counts_light:
        means.lit[e * sizes.sites + i] += own * slots
    if i < sizes.own:
        means.charge[e * sizes.own + i] += total * slots


@loop
def light_means(
    sizes: Laying,
    light: LightMatrix,
    stretches: Stretches,
    sites: Sites,
    order: Annotated[Ints, "sites"],
    reached: Written[Ints],
    means: StretchMeans,
) -> None:
    """Compute the light of sites and pixels in their stretches; `means` is 0 before. `pace` is set
    to the light of the first slot of each stretch, then of the last slot.

    Sites are taken some at a time, in the `order` of their places: neighbours share cache lines of
    every frame. `reached`, the stretch of each of them, is working memory."""
    for first in range(sizes.begin, sizes.end, TOGETHER):
        count = min(TOGETHER, sizes.end - first)
        for j in range(count):
            reached[j] = -1
        for n in range(1 if sizes.even else sizes.slots):
            for j in range(count):
                i = order[first + j]
                own = _light_of_slot(sizes, light, sites, n, i)
                total = _exchanged(sizes, light, sites, n, i, own) if i < sizes.own else own
                start, is_slow = stretches.start[sites.lane[i]], sizes.slow_words and i < sizes.own
                if sizes.even:
                    last = stretches.start[sites.lane[i] + 1] - start - 1
                    for e in range(last):
                        begin, stop = stretches.boundary[start + e], stretches.boundary[start + e + 1]
                        _store(sizes, means, e, i, stop - begin, own, total)
                    for e in range(last + 1 if is_slow else 0):
                        means.pace[e * sizes.own + i] = total
                    continue
                begins = stretches.boundary[start + reached[j] + 1] == n
                reached[j] += 1 if begins else 0
                _store(sizes, means, reached[j], i, 1, own, total)
                if is_slow and begins:
                    means.pace[reached[j] * sizes.own + i] = total
                if is_slow and n + 1 == sizes.slots:
                    means.pace[(reached[j] + 1) * sizes.own + i] = total


@inlined
def _share(stretches: Stretches, first: int, e: int, other_first: int, k: int) -> float:
    """Return the part of the time of stretch k of another lane that lies in stretch e of a lane.
    `first`, `other_first`: where the boundaries of the lanes start."""
    begin, stop = stretches.boundary[first + e], stretches.boundary[first + e + 1]
    other_begin, other_stop = stretches.boundary[other_first + k], stretches.boundary[other_first + k + 1]
    low = begin if begin > other_begin else other_begin
    high = stop if stop < other_stop else other_stop
    if high <= low:
        return 0.0
    times = stretches.start_s
    share: float = (times[high] - times[low]) / (times[other_stop] - times[other_begin])
    return share


@compiled
def _add_missing(
    sizes: Laying, stretches: Stretches, sites: Sites, means: StretchMeans, i: int
) -> None:
    """Set the variance of the counts of pixel i's neighbours, in its stretches, that the counts of
    the neighbours' own stretches do not determine."""
    first = stretches.start[sites.lane[i]]
    count = stretches.start[sites.lane[i] + 1] - first - 1
    for side in range(NEIGHBOURS):
        other = sites.beside[NEIGHBOURS * i + side]
        other_first = stretches.start[sites.lane[other]] if other >= 0 else 0
        other_count = stretches.start[sites.lane[other] + 1] - other_first - 1 if other >= 0 else 0
        e, k = 0, 0
        while e < count and k < other_count:
            share = _share(stretches, first, e, other_first, k)
            mean = means.lit[k * sizes.sites + other] if sizes.counts_light else 0.0
            if sizes.counts_dark:
                mean += means.dark[k * sizes.sites + other]
            means.missing_e2[e * sizes.own + i] += share * (1.0 - share) * mean
            if stretches.boundary[other_first + k + 1] <= stretches.boundary[first + e + 1]:
                k += 1
            else:
                e += 1


@loop
def dark_means(sizes: Laying, stretches: Stretches, sites: Sites, means: StretchMeans) -> None:
    """Compute the means of the counted dark charge of sites in their stretches."""
    for i in range(sizes.begin, sizes.end):
        first = stretches.start[sites.lane[i]]
        for e in range(stretches.start[sites.lane[i] + 1] - first - 1):
            begin, stop = stretches.boundary[first + e], stretches.boundary[first + e + 1]
            seconds = stretches.start_s[stop] - stretches.start_s[begin]
            means.dark[e * sizes.sites + i] = sites.dark_e_per_s[i] * seconds


@loop
def charge_means(sizes: Laying, stretches: Stretches, sites: Sites, means: StretchMeans) -> None:
    """Complete the means of pixels, from light: add dark charge to `charge`, convert `pace`, and
    compute `missing_e2`."""
    times = stretches.start_s
    for i in range(sizes.begin, sizes.end):
        flow = 0.0
        for side in range(NEIGHBOURS if sizes.exchanged > 0.0 else 0):
            other = sites.beside[NEIGHBOURS * i + side]
            flow += sites.dark_e_per_s[other] - sites.dark_e_per_s[i] if other >= 0 else 0.0
        dark_e_per_s = sites.dark_e_per_s[i] + sizes.exchanged * flow
        first = stretches.start[sites.lane[i]]
        last = stretches.start[sites.lane[i] + 1] - first - 1
        for e in range(last):
            begin, stop = stretches.boundary[first + e], stretches.boundary[first + e + 1]
            seconds = times[stop] - times[begin]
            charge = means.charge[e * sizes.own + i] + dark_e_per_s * seconds
            means.charge[e * sizes.own + i] = charge
            for side in range(1 + (e + 1 == last) if sizes.slow_words else 0):
                at = (e + side) * sizes.own + i
                n = begin if side == 0 else stop - 1
                slot_s = times[n + 1] - times[n]
                slot_e = means.pace[at] + dark_e_per_s * slot_s
                # Without charge, the fraction of the time.
                part = slot_e / charge if charge > 0.0 else slot_s / seconds
                means.pace[at] = part / (1e6 * slot_s)
        if sizes.exchanged > 0.0 and (sizes.counts_light or sizes.counts_dark):
            _add_missing(sizes, stretches, sites, means, i)


@record
class Exchanging:
    """Sizes for `exchange_counts`: pixels `begin` to `end` - 1."""

    begin: int
    end: int
    sites: int
    pixels: int
    frame: int
    exchanged: float
    missing: np.uint64
    """First half of the random key of the part of neighbours' counts that is not known."""


@loop
def exchange_counts(
    exchanging: Exchanging,
    stretches: Stretches,
    sites: Sites,
    mean_e: Floats,
    missing_e2: Floats,
    away: Floats,
    charge: Written[Floats],
) -> None:
    """Set the charge of the stretches of pixels from the deviations `away` of the counts of sites
    from their means."""
    pixels, c, boundary = exchanging.pixels, exchanging.exchanged, stretches.boundary
    for i in range(exchanging.begin, exchanging.end):
        first = stretches.start[sites.lane[i]]
        count = stretches.start[sites.lane[i] + 1] - first - 1
        for e in range(count):
            flow = 0.0
            if c > 0.0 and missing_e2[e * pixels + i] > 0.0:
                key = bits(exchanging.missing, exchanging.frame, np.uint64(e))
                z = float(normal_fast(unit(bits(key, sites.place[i], _FIRST_LANE))))
                flow = c * math.sqrt(missing_e2[e * pixels + i]) * z
            charge[e * pixels + i] = mean_e[e * pixels + i] + away[e * exchanging.sites + i] + flow
        for side in range(NEIGHBOURS if c > 0.0 else 0):
            other = sites.beside[NEIGHBOURS * i + side]
            if other < 0:
                continue
            for e in range(count):
                charge[e * pixels + i] -= c * away[e * exchanging.sites + i]
            other_first = stretches.start[sites.lane[other]]
            other_count = stretches.start[sites.lane[other] + 1] - other_first - 1
            e, k = 0, 0
            while e < count and k < other_count:
                share = _share(stretches, first, e, other_first, k)
                charge[e * pixels + i] += c * share * away[k * exchanging.sites + other]
                if boundary[other_first + k + 1] <= boundary[first + e + 1]:
                    k += 1
                else:
                    e += 1
