"""The charge of stretches of slots: its mean, once for a scene, and its counts, in every frame.

A stretch is the time between two boundaries at which words of a pixel's code read or reset PIX. A
site is a pixel that runs through its words or, with crosstalk, a neighbour of such a pixel. Pixels
exchange counted charge. With strong crosstalk, the counts of a site are drawn between all
boundaries of its own code and its neighbours' (`block_program`); otherwise between its own, and
they are spread evenly over this time."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np

from nscc.arrays import Floats, Ints, Ints32
from nscc_runtime.execution.layout import WORD_BLOCK
from nscc_runtime.light import LightMatrix
from nscc_runtime.loop import Written, compiled, inlined, loop, record
from nscc_runtime.noise.poisson_law import RATE_CAP

NEIGHBOURS, NONE = 4, -1
"""Number of neighbours of a pixel. What stands for a site that does not exist."""
OWN = NEIGHBOURS
"""The number of the pixel itself among its neighbours."""
STRETCH_BLOCK = 128
"""Number of sites whose light is added up together."""


class Stretches(NamedTuple):
    """The stretches (groups of slots between reads or resets of PIX) of each lane: lane l has the
    boundaries boundary[start[l] : start[l + 1]], from slot 0 to the number of slots. `per_s`: 1
    divided by the seconds from each boundary to the next. `start_s`: the time at which each slot
    begins, and the end of the frame. A lane is the pixels of one distinct shutter."""

    start: Annotated[Ints, "lanes+1"]
    boundary: Annotated[Ints32, "boundaries"]
    per_s: Annotated[Floats, "boundaries"]
    start_s: Annotated[Floats, "slots+1"]

    @classmethod
    def of(cls, start: Ints, boundary: Ints32, start_s: Floats) -> Stretches:
        """Return the stretches (groups of slots between reads or resets of PIX) of lanes (the
        pixels of one distinct shutter each). `start` (lanes + 1,): index of each lane's first
        boundary in `boundary`, where a lane's boundaries ascend from 0 to the number of slots.
        `start_s` (slots + 1,): the second at which each slot begins, then the end of the frame."""
        # The last number of each lane, for no stretch, is meaningless and not read.
        seconds = np.diff(start_s[boundary], append=np.inf)
        return cls(start, boundary, 1.0 / seconds, start_s)


class Sites(NamedTuple):
    """The sites (pixels whose charge is computed). `place`: row * cols + col on the chip. `lane`:
    number of the lane whose stretches (groups of slots between reads or resets of PIX) the site
    has. `counted`: number of the lane in whose stretches its electrons are counted. `factor`:
    multiplies its light. `dark_e_per_s`: its dark current. `beside`: for each pixel that runs
    through its words, the indices of the sites above, below, left and right, -1 beyond the border,
    and then its own."""

    place: Annotated[Ints, "sites"]
    lane: Annotated[Ints32, "sites"]
    counted: Annotated[Ints32, "sites"]
    factor: Annotated[Floats, "sites"]
    dark_e_per_s: Annotated[Floats, "sites"]
    beside: Annotated[Ints32, "5 own"]


@record
class SiteSizes:
    """Sizes for `find_sites`, of an array of `pixels` pixels. `own`: number of pixels that run
    through their words."""

    rows: int
    cols: int
    pixels: int
    own: int


@loop
def find_sites(
    sizes: SiteSizes,
    own_places: Annotated[Ints, "own"],
    number: Written[Annotated[Ints32, "pixels"]],
    place: Written[Annotated[Ints, "pixels"]],
    beside: Written[Annotated[Ints32, "5 own"]],
    count: Written[Ints],
) -> None:
    """Number the sites (pixels whose charge is computed), and set count[0] to how many there are,
    place[k] to the place of site k, and `beside` as in `Sites`.

    The first sites are the pixels at `own_places`; their neighbours that are not among these follow
    in ascending order of places. `number`: working memory, NONE everywhere before."""
    wanted, own, cols = NONE - 1, sizes.own, sizes.cols
    for i in range(own):
        number[own_places[i]], place[i] = i, own_places[i]
    for i in range(own):
        p = own_places[i]
        col = np.uint32(p) % np.uint32(cols)
        beside[i] = p - cols if p >= cols else NONE
        beside[own + i] = p + cols if p + cols < sizes.pixels else NONE
        beside[2 * own + i] = p - 1 if col > 0 else NONE
        beside[3 * own + i] = p + 1 if col + 1 < cols else NONE
    for at in range(NEIGHBOURS * own):
        if beside[at] != NONE and number[beside[at]] == NONE:
            number[beside[at]] = wanted
    found = own
    for p in range(sizes.pixels):
        if number[p] == wanted:
            number[p], place[found] = found, p
            found += 1
    count[0] = found
    for at in range(NEIGHBOURS * own):
        beside[at] = number[beside[at]] if beside[at] != NONE else NONE


class StretchMeans(NamedTuple):
    """Means of the charge of stretches (groups of slots between reads or resets of PIX) in
    electrons.

    `lit`, `dark` (stretches, sites): counted charge of the sites (pixels whose charge is computed).
    `charge` (stretches, pixels): charge of the pixels after crosstalk. `pace` (stretches + 1,
    pixels): the fraction of it that is collected per microsecond of the stretch's first slot, then,
    after the pixel's last stretch, of the last slot. An array that is not needed is (1, 1)."""

    lit: Written[Floats]
    dark: Written[Floats]
    charge: Written[Floats]
    pace: Written[Floats]


@record
class StretchSizes:
    """Sizes and switches for the means: sites (pixels whose charge is computed) or pixels `begin`
    to `end` - 1 are computed. `sites`, `slots`: how many there are. Switches are 1 if the effect is
    on, else 0."""

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
    slow_words: int
    exchanged: float
    """Fraction of a pixel's charge that moves to each neighbour."""


@inlined
def _light_of_slot(
    sizes: StretchSizes, light: LightMatrix, sites: Sites, start: int, stop: int, site: int
) -> float:
    """Return the mean light of a slot at the site of index `site`, in electrons, between 0 and
    `RATE_CAP`, or NaN. The slot is the weighted sum of the frames of `light` in its entries
    `start` to `stop` - 1. A site is a pixel whose charge is computed."""
    total, place = 0.0, sites.place[site]
    for k in range(start, stop):
        at = light.frame_index[k] * sizes.pixels + place
        total += float(light.frames[at]) * light.weight[k]
    # Rounded like `Light.slot`. Light below 0 is none; NaN stays NaN.
    rate = float(np.float32(total)) * sites.factor[site]
    rate = 0.0 if rate < 0.0 else rate
    capped: float = RATE_CAP if rate > RATE_CAP else rate
    return capped


@inlined
def _exchanged(
    sizes: StretchSizes, light: LightMatrix, sites: Sites, start: int, stop: int, i: int, own: float
) -> float:
    """Return the light of one slot that pixel `i` collects after crosstalk, in electrons. `own` is
    its light before. The slot has the entries `start` to `stop` - 1 of `light`. A neighbour beyond
    the border neither gives nor takes, and light of a neighbour that is NaN counts as 0."""
    flow = 0.0
    for side in range(NEIGHBOURS if sizes.exchanged > 0.0 else 0):
        other = sites.beside[side * sizes.own + i]
        if other >= 0:
            given = _light_of_slot(sizes, light, sites, start, stop, other)
            flow += (given if given >= 0.0 else 0.0) - own
    return own + sizes.exchanged * flow


@inlined
def _store(
    sizes: StretchSizes, means: StretchMeans, e: int, i: int, own: float, total: float
) -> None:
    """Store the light of stretch e of site i in electrons: `own`, before crosstalk, in `means.lit`
    if light is counted; `total`, after crosstalk, in `means.charge` if the site is a pixel that
    runs through its words. Slots of a stretch are counted as one number."""
    if sizes.counts_light:
        means.lit[e * sizes.sites + i] = own if own >= 0.0 else 0.0  # 0 for NaN
    if i < sizes.own:
        means.charge[e * sizes.own + i] = total


@loop
def light_means(
    sizes: StretchSizes,
    light: LightMatrix,
    stretches: Stretches,
    sites: Sites,
    order: Annotated[Ints, "sites"],
    reached: Written[Ints],
    added: Written[Floats],
    means: StretchMeans,
) -> None:
    """Compute the light of the sites order[begin : end] in their stretches (groups of slots between
    reads or resets of PIX), in electrons.

    `means` is 0 before. Its `lit` gets the light of sites, `charge` that of pixels after crosstalk,
    and `pace` the light of the first slot of each stretch, then of the last slot, until
    `charge_means` converts it.

    Sites are taken some at a time, in the `order` of their places: neighbours share cache lines of
    every frame. The stretch of each of them (`reached`), and the light in it (`added`), are working
    memory. A site is a pixel whose charge is computed."""
    for first in range(sizes.begin, sizes.end, STRETCH_BLOCK):
        count = min(STRETCH_BLOCK, sizes.end - first)
        for j in range(count):
            reached[j] = -1
        for n in range(1 if sizes.even else sizes.slots):
            k, end = light.row_start[n], light.row_start[n + 1]
            for j in range(count):
                i, total_at = order[first + j], STRETCH_BLOCK + j
                own = total = _light_of_slot(sizes, light, sites, k, end, i)
                if i < sizes.own:
                    total = _exchanged(sizes, light, sites, k, end, i, own)
                start, is_slow = stretches.start[sites.lane[i]], sizes.slow_words and i < sizes.own
                if sizes.even:
                    last = stretches.start[sites.lane[i] + 1] - start - 1
                    for e in range(last):
                        begin = stretches.boundary[start + e]
                        slots = stretches.boundary[start + e + 1] - begin
                        _store(sizes, means, e, i, own * slots, total * slots)
                    for e in range(last + 1 if is_slow else 0):
                        means.pace[e * sizes.own + i] = total
                    continue
                # Slot n begins a stretch; `reached` is -1 before the first, at boundary 0.
                if stretches.boundary[start + reached[j] + 1] == n:
                    if n > 0:
                        _store(sizes, means, reached[j], i, added[j], added[total_at])
                    reached[j] += 1
                    added[j], added[total_at] = 0.0, 0.0
                    if is_slow:
                        means.pace[reached[j] * sizes.own + i] = total
                added[j] += own
                added[total_at] += total
                if n + 1 == sizes.slots:
                    _store(sizes, means, reached[j], i, added[j], added[total_at])
                    if is_slow:
                        means.pace[(reached[j] + 1) * sizes.own + i] = total


@loop
def dark_means(
    sizes: StretchSizes, stretches: Stretches, sites: Sites, means: StretchMeans
) -> None:
    """Set `means.dark` to the means of the counted dark charge of the sites begin to end - 1 in
    the stretches of their counts, in electrons. Slots of a stretch are counted as one number. A
    site is a pixel whose charge is computed."""
    for i in range(sizes.begin, sizes.end):
        first = stretches.start[sites.counted[i]]
        for e in range(stretches.start[sites.counted[i] + 1] - first - 1):
            begin, stop = stretches.boundary[first + e], stretches.boundary[first + e + 1]
            seconds = stretches.start_s[stop] - stretches.start_s[begin]
            means.dark[e * sizes.sites + i] = sites.dark_e_per_s[i] * seconds


@loop
def charge_means(
    sizes: StretchSizes, stretches: Stretches, sites: Sites, means: StretchMeans
) -> None:
    """Complete the means of the pixels begin to end - 1, which contain light (`light_means`): add
    dark charge to `charge`, and convert `pace` from electrons to fractions per microsecond."""
    times = stretches.start_s
    for i in range(sizes.begin, sizes.end):
        flow = 0.0
        for side in range(NEIGHBOURS if sizes.exchanged > 0.0 else 0):
            other = sites.beside[side * sizes.own + i]
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


@record
class Exchanging:
    """Sizes for `exchange_counts`: pixels `begin` to `end` - 1 of `pixels`, with at most `rows`
    stretches (groups of slots between reads or resets of PIX) each. `exchanged`: the fraction of
    its charge that a pixel gives to each neighbour. PIX is the photodiode."""

    begin: int
    end: int
    rows: int
    sites: int
    pixels: int
    exchanged: float


@inlined
def _counted_beside(sites: Sites, at: int) -> int:
    """Return the lane in whose stretches the counts of the site sites.beside[at] are drawn, NONE
    beyond the border."""
    other = sites.beside[at]
    return sites.counted[other] if other >= 0 else NONE


@compiled
def _receive(
    exchanging: Exchanging,
    stretches: Stretches,
    sites: Sites,
    away: Floats,
    side_at: int,
    first: int,
    stop: int,
    part: Floats,
    part_at: int,
    charge: Floats,
) -> None:
    """Add to the charge of the pixels `first` to `stop` - 1, which have one lane, what they receive
    from sites whose counts are drawn in the stretches of one lane. `side_at`: where these sites
    begin in sites.beside.

    Pixel i receives the fraction part[part_at + i] of the deviations `away` (stretches, sites). If
    a stretch of the counts extends over several of the pixel's, it is spread evenly over time."""
    boundary, times, beside = stretches.boundary, stretches.start_s, sites.beside
    lane, counted = sites.lane[first], _counted_beside(sites, side_at + first)
    begin, theirs, own = 0, 0, 0
    e, k, last = stretches.start[lane], stretches.start[counted], stretches.start[lane + 1] - 2
    while e <= last:
        own_end, their_end = boundary[e + 1], boundary[k + 1]
        end = min(own_end, their_end)
        is_whole = end - begin == their_end - boundary[k]
        share = 1.0 if is_whole else (times[end] - times[begin]) * stretches.per_s[k]
        for i in range(first, stop):
            received_e = share * away[theirs + beside[side_at + i]]
            charge[own + i] += part[part_at + i] * received_e
        begin = end
        if end == own_end:
            e, own = e + 1, own + exchanging.pixels
        if end == their_end:
            k, theirs = k + 1, theirs + exchanging.sites


@loop
def exchange_counts(
    exchanging: Exchanging,
    stretches: Stretches,
    sites: Sites,
    mean_e: Floats,
    away: Floats,
    part: Written[Floats],
    charge: Written[Floats],
) -> None:
    """Set `charge`, electrons (stretches, pixels), of the pixels begin to end - 1 in one frame. The
    charge is the sum of the means `mean_e` and the deviations `away` (stretches, sites) of Poisson
    counts from their means, after crosstalk.

    `part` is working memory for `WORD_BLOCK` pixels. Slots of a stretch are counted as one number.
    A site is a pixel whose charge is computed."""
    pixels, c = exchanging.pixels, exchanging.exchanged
    for first in range(exchanging.begin, exchanging.end, WORD_BLOCK):
        stop = min(first + WORD_BLOCK, exchanging.end)
        for e in range(exchanging.rows):
            for at in range(e * pixels + first, e * pixels + stop):
                charge[at] = mean_e[at]
        # Without crosstalk, a pixel keeps all of its own charge.
        for i in range(first, stop):
            part[i - first] = 1.0
        for side in range(NEIGHBOURS if c > 0.0 else 0):
            for i in range(first, stop):
                part[i - first] -= c if sites.beside[side * pixels + i] >= 0 else 0.0
        for turn in range(1 + (NEIGHBOURS if c > 0.0 else 0)):
            side_at, begin = (OWN - turn) * pixels, first
            for i in range(first, stop if turn == 1 else first):
                part[i - first] = c
            # Neighbours in these arrays usually have one lane, and so have those beside them.
            while begin < stop:
                counted, end = _counted_beside(sites, side_at + begin), begin + 1
                while end < stop and sites.lane[end] == sites.lane[begin]:
                    if _counted_beside(sites, side_at + end) != counted:
                        break
                    end += 1
                if counted != NONE:
                    _receive(
                        exchanging,
                        stretches,
                        sites,
                        away,
                        side_at,
                        begin,
                        end,
                        part,
                        -first,
                        charge,
                    )
                begin = end
