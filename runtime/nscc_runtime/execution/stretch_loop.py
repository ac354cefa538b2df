"""The charge of stretches of slots: its mean, once for a scene, and its counts, in every frame.

A stretch is the time between two boundaries at which words of a pixel's code read or reset PIX. A
site is a pixel that runs through its words or, with crosstalk, a neighbour of such a pixel. Pixels
exchange counted charge: what a neighbour collects in a stretch of the pixel is the neighbour's own
count, in proportion to time, and a normal number for the part that is not known then."""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np

from nscc_runtime.loop import Floats, Ints, Ints32, Written, compiled, loop, record
from nscc_runtime.noise.gaussian import normal_fast
from nscc_runtime.noise.keys import bits, unit
from nscc_runtime.sizes_loop import LightMatrix

NEIGHBOURS = 4
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
def _light_of_slot(sizes: Laying, light: LightMatrix, n: int, place: int) -> float:
    """Return the light of slot n at a place, rounded to float32 like `Light.slot`."""
    total = 0.0
    for k in range(light.row_start[n], light.row_start[n + 1]):
        at = light.frame_index[k] * sizes.pixels + place
        total += float(light.frames[at]) * light.weight[k]
    return float(np.float32(total))


@compiled
def _light_between(
    sizes: Laying, light: LightMatrix, sites: Sites, site: int, begin: int, stop: int
) -> float:
    """Return the mean light of the slots `begin` to `stop` - 1 at a site, in electrons."""
    total, place, factor = 0.0, sites.place[site], sites.factor[site]
    count = 1 if sizes.even and stop > begin else stop - begin
    for n in range(begin, begin + count):
        rate = _light_of_slot(sizes, light, n, place) * factor
        # Light below 0 is none; NaN stays NaN.
        rate = 0.0 if rate < 0.0 else rate
        total += sizes.rate_cap if rate > sizes.rate_cap else rate
    summed: float = total * (stop - begin) if sizes.even else total
    return summed


@compiled
def _charge_between(
    sizes: Laying, light: LightMatrix, stretches: Stretches, sites: Sites, i: int, begin: int,
    stop: int,
) -> float:  # fmt: skip
    """Return the mean charge of pixel i in the slots `begin` to `stop` - 1, after crosstalk."""
    seconds = stretches.start_s[stop] - stretches.start_s[begin]
    own: float = _light_between(sizes, light, sites, i, begin, stop)
    own += sites.dark_e_per_s[i] * seconds
    if sizes.exchanged == 0.0:
        return own
    flow = 0.0
    for side in range(NEIGHBOURS):
        other = sites.beside[NEIGHBOURS * i + side]
        if other >= 0:
            lit = _light_between(sizes, light, sites, other, begin, stop)
            flow += lit + sites.dark_e_per_s[other] * seconds - own
    exchanged: float = own + sizes.exchanged * flow
    return exchanged


@compiled
def _overlap(stretches: Stretches, first: int, k: int, begin: int, stop: int) -> float:
    """Return the part of the time of a lane's stretch k that lies in the slots `begin` to `stop` -
    1. `first`: where the lane's boundaries start."""
    other_begin, other_stop = stretches.boundary[first + k], stretches.boundary[first + k + 1]
    low = begin if begin > other_begin else other_begin
    high = stop if stop < other_stop else other_stop
    if high <= low:
        return 0.0
    times = stretches.start_s
    share: float = (times[high] - times[low]) / (times[other_stop] - times[other_begin])
    return share


@compiled
def _missing_e2(
    sizes: Laying, stretches: Stretches, sites: Sites, means: StretchMeans, i: int, begin: int,
    stop: int,
) -> float:  # fmt: skip
    """Return the variance of the counts of pixel i's neighbours in the slots `begin` to `stop` - 1
    that the counts of the neighbours' own stretches do not determine."""
    missing_e2 = 0.0
    for side in range(NEIGHBOURS):
        other = sites.beside[NEIGHBOURS * i + side]
        if other < 0:
            continue
        first = stretches.start[sites.lane[other]]
        for k in range(stretches.start[sites.lane[other] + 1] - first - 1):
            share = _overlap(stretches, first, k, begin, stop)
            if 0.0 < share < 1.0:
                mean = 0.0
                if sizes.counts_light:
                    mean += means.lit[k * sizes.sites + other]
                if sizes.counts_dark:
                    mean += means.dark[k * sizes.sites + other]
                missing_e2 += share * (1.0 - share) * mean
    return missing_e2


@loop
def count_means(
    sizes: Laying, light: LightMatrix, stretches: Stretches, sites: Sites, means: StretchMeans
) -> None:
    """Compute the means of the counted charge of sites in their stretches; they are 0 before."""
    for i in range(sizes.begin, sizes.end):
        first = stretches.start[sites.lane[i]]
        for e in range(stretches.start[sites.lane[i] + 1] - first - 1):
            begin, stop = stretches.boundary[first + e], stretches.boundary[first + e + 1]
            if sizes.counts_light:
                lit_e = _light_between(sizes, light, sites, i, begin, stop)
                means.lit[e * sizes.sites + i] = lit_e
            if sizes.counts_dark:
                seconds = stretches.start_s[stop] - stretches.start_s[begin]
                means.dark[e * sizes.sites + i] = sites.dark_e_per_s[i] * seconds


@loop
def charge_means(
    sizes: Laying,
    light: LightMatrix,
    stretches: Stretches,
    slot_us: Annotated[Floats, "slots"],
    sites: Sites,
    means: StretchMeans,
) -> None:
    """Compute the other means, for pixels; the means of counted charge are known. All are 0
    before."""
    pixels = sizes.own
    for i in range(sizes.begin, sizes.end):
        first = stretches.start[sites.lane[i]]
        last = stretches.start[sites.lane[i] + 1] - first - 1
        for e in range(last):
            begin, stop = stretches.boundary[first + e], stretches.boundary[first + e + 1]
            charge = _charge_between(sizes, light, stretches, sites, i, begin, stop)
            means.charge[e * pixels + i] = charge
            if sizes.exchanged > 0.0 and (sizes.counts_light or sizes.counts_dark):
                missing_e2 = _missing_e2(sizes, stretches, sites, means, i, begin, stop)
                means.missing_e2[e * pixels + i] = missing_e2
            for side in range(2 if sizes.slow_words else 0):
                # The first slot, and the last slot of the frame.
                n = begin if side == 0 else stop - 1
                if side == 1 and e + 1 < last:
                    continue
                slot_e = _charge_between(sizes, light, stretches, sites, i, n, n + 1)
                us = slot_us[n]
                if charge <= 0.0:
                    # Without charge, the fraction of the time.
                    charge, slot_e = stretches.start_s[stop] - stretches.start_s[begin], us * 1e-6
                means.pace[(e + side) * pixels + i] = slot_e / (charge * us)


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
    pixels, count, c = exchanging.pixels, exchanging.sites, exchanging.exchanged
    for i in range(exchanging.begin, exchanging.end):
        first = stretches.start[sites.lane[i]]
        for e in range(stretches.start[sites.lane[i] + 1] - first - 1):
            own = away[e * count + i]
            if c == 0.0:
                charge[e * pixels + i] = mean_e[e * pixels + i] + own
                continue
            begin, stop = stretches.boundary[first + e], stretches.boundary[first + e + 1]
            flow = 0.0
            for side in range(NEIGHBOURS):
                other = sites.beside[NEIGHBOURS * i + side]
                if other < 0:
                    continue
                flow -= own
                other_first = stretches.start[sites.lane[other]]
                other_count = stretches.start[sites.lane[other] + 1] - other_first - 1
                for k in range(other_count):
                    share = _overlap(stretches, other_first, k, begin, stop)
                    flow += share * away[k * count + other]
            if missing_e2[e * pixels + i] > 0.0:
                key = bits(exchanging.missing, exchanging.frame, np.uint64(e))
                z = float(normal_fast(unit(bits(key, sites.place[i], _FIRST_LANE))))
                flow += math.sqrt(missing_e2[e * pixels + i]) * z
            charge[e * pixels + i] = mean_e[e * pixels + i] + own + c * flow
