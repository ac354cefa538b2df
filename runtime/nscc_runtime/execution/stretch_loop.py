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
from nscc_runtime.emulator.loops import same_light
from nscc_runtime.execution.layout import WORD_BLOCK
from nscc_runtime.light import BRIGHTEST_E, LightMatrix
from nscc_runtime.loop import Written, compiled, inlined, loop, record

NEIGHBOURS, NONE = 4, -1
"""Number of neighbours of a pixel. What stands for a number that is not known yet."""
OWN = NEIGHBOURS
"""The number of the pixel itself among its neighbours."""
STRETCH_BLOCK = 2048
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
    through its words, the indices of the sites above, below, left and right, its own beyond the
    border, and then its own."""

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
        beside[i] = p - cols if p >= cols else p
        beside[own + i] = p + cols if p + cols < sizes.pixels else p
        beside[2 * own + i] = p - 1 if col > 0 else p
        beside[3 * own + i] = p + 1 if col + 1 < cols else p
    for at in range(NEIGHBOURS * own):
        if number[beside[at]] == NONE:
            number[beside[at]] = wanted
    found = own
    for p in range(sizes.pixels):
        if number[p] == wanted:
            number[p], place[found] = found, p
            found += 1
    count[0] = found
    for at in range(NEIGHBOURS * own):
        beside[at] = number[beside[at]]


class StretchMeans(NamedTuple):
    """Means of the charge of stretches (groups of slots between reads or resets of PIX) in
    electrons.

    `lit`, `dark` (stretches, sites): counted charge of the sites (pixels whose charge is computed).
    `charge` (stretches, pixels): charge of the pixels after crosstalk; row 0 is NaN for pixels with
    light that is NaN in any slot. `pace` (stretches + 1, pixels): the fraction of it that is
    collected per microsecond of the stretch's first slot, then, after the pixel's last stretch, of
    the last slot. An array that is not needed is (1, 1)."""

    lit: Written[Floats]
    dark: Written[Floats]
    charge: Written[Floats]
    pace: Written[Floats]


@record
class StretchSizes:
    """Sizes and switches for the means of the sites (pixels whose charge is computed) number
    `begin` to `end` - 1 in the order in which they are taken. `sites`, `slots`: how many there are.
    Switches are 1 if the effect is on, else 0."""

    begin: int
    end: int
    sites: int
    slots: int
    own: int
    """Number of pixels that run through their words: the first sites."""
    pixels: int
    """Number of pixels of a frame of light."""
    together: int
    """Number of sites whose light is added up together."""
    even: int
    """Whether all slots have the same light."""
    counts_light: int
    counts_dark: int
    slow_words: int
    exchanged: float
    """Fraction of a pixel's charge that moves to each neighbour."""


class LightBlock(NamedTuple):
    """Working memory for sites (pixels whose charge is computed) that are taken together.

    `slot_e`: the light of these and of their neighbours in a slot. `frame_e`: the same in the frame
    so far, where NaN counts as 0. Without neighbours: `stretch_e`, the light in the stretch so far;
    `gained_e`, what came from neighbours in the frame until the stretch began; `dark_e_per_s`, the
    dark current after crosstalk. If all slots are equal, `stretch_e` and `gained_e` are those of a
    slot.

    A run is some successive sites of one lane (the pixels of one distinct shutter). Of each run:
    `run`, the number of its first site; `due`, the slot at which its next stretch begins;
    `counted`, `reached`, the numbers of its stretch of counts and of its stretch of charge, NONE
    before the frame. A stretch is a group of slots between reads or resets of PIX."""

    slot_e: Written[Floats]
    frame_e: Written[Floats]
    stretch_e: Written[Floats]
    gained_e: Written[Floats]
    dark_e_per_s: Written[Floats]
    run: Written[Ints]
    due: Written[Ints]
    counted: Written[Ints]
    reached: Written[Ints]

    @classmethod
    def of(cls, room: int) -> LightBlock:
        """Allocate the arrays for `room` sites (pixels whose charge is computed); the contents are
        arbitrary."""
        floats, ints = np.empty((5, room)), np.empty((4, room + 1), np.int64)
        return cls(*floats, *ints)


@inlined
def _positive(value: float) -> float:
    """Return `value`, or 0 if it is negative or NaN."""
    return value if value > 0.0 else 0.0


@inlined
def _gained(sizes: StretchSizes, sites: Sites, i: int, p: int, values: Floats, begin: int) -> float:
    """Return what site number p, which is pixel i that runs through its words, gains by crosstalk.
    `values`: charge of the sites from number `begin` on; NaN counts as 0."""
    own, flow = _positive(values[p - begin]), 0.0
    for side in range(NEIGHBOURS if sizes.exchanged > 0.0 else 0):
        flow += _positive(values[sites.beside[side * sizes.own + i] - begin]) - own
    return sizes.exchanged * flow


@compiled
def _set_up(
    sizes: StretchSizes, sites: Sites, index: Ints, first: int, stop: int, block: LightBlock
) -> tuple[int, int, int]:
    """Set up `block` for the sites number `first` to `stop` - 1. Return the number of its runs, the
    number of the first of these sites and their neighbours, and how many they are. A site is a
    pixel whose charge is computed."""
    begin, end, runs = first, stop, 0
    for p in range(first, stop):
        i, j = index[p], p - first
        block.dark_e_per_s[j] = sites.dark_e_per_s[p]
        if i < sizes.own:
            block.dark_e_per_s[j] += _gained(sizes, sites, i, p, sites.dark_e_per_s, 0)
        for side in range(NEIGHBOURS if i < sizes.own else 0):
            other = sites.beside[side * sizes.own + i]
            begin, end = min(begin, other), max(end, other + 1)
        follows = p > first and i == index[p - 1] + 1 and i != sizes.own
        alike = follows and sites.lane[p] == sites.lane[p - 1]
        if not (alike and sites.counted[p] == sites.counted[p - 1]):
            block.run[runs], block.due[runs] = p, 0
            block.counted[runs], block.reached[runs] = NONE, NONE
            runs += 1
    block.run[runs] = stop
    for j in range(end - begin):
        block.frame_e[j], block.stretch_e[j], block.gained_e[j] = 0.0, 0.0, 0.0
    return runs, begin, end - begin


@compiled
def _set_light(
    sizes: StretchSizes,
    light: LightMatrix,
    n: int,
    sites: Sites,
    begin: int,
    count: int,
    slot_e: Floats,
) -> None:
    """Set `slot_e` to the mean light of slot n, electrons, between 0 and `BRIGHTEST_E`, or NaN, for
    `count` sites from number `begin` on. A site is a pixel whose charge is computed."""
    for j in range(count):
        slot_e[j] = 0.0
    for k in range(light.row_start[n], light.row_start[n + 1]):
        frame, weight = light.frame_index[k] * sizes.pixels, light.weight[k]
        for j in range(count):
            slot_e[j] += float(light.frames[frame + sites.place[begin + j]]) * weight
    for j in range(count):
        # Rounded like `Light.slot`. Light below 0 is none; NaN stays NaN.
        rate = float(np.float32(slot_e[j])) * sites.factor[begin + j]
        rate = 0.0 if rate < 0.0 else rate
        slot_e[j] = BRIGHTEST_E if rate > BRIGHTEST_E else rate


@compiled
def _turn(
    sizes: StretchSizes,
    stretches: Stretches,
    sites: Sites,
    index: Ints,
    block: LightBlock,
    first: int,
    begin: int,
    r: int,
    n: int,
    means: StretchMeans,
) -> int:
    """End the stretch of run r of `block` before slot n: store its means, and begin the next
    stretch. Return the slot at which that ends.

    `first`, `begin`: numbers of the block's first site without and with neighbours. A stretch is a
    group of slots between reads or resets of PIX. A site is a pixel whose charge is computed."""
    run, k, e, own = block.run[r], block.counted[r], block.reached[r], sizes.own
    stop = block.run[r + 1]
    ended, at, is_own = stop if k >= 0 else run, index[run] - run, index[run] < own
    next_at = stretches.start[sites.counted[run]] + k + 1
    since = stretches.boundary[next_at - 1] if k >= 0 else 0
    seconds = stretches.start_s[n] - stretches.start_s[since]
    slots = n - since if sizes.even else 1
    for p in range(run, ended if sizes.counts_light else run):
        means.lit[k * sizes.sites + at + p] = slots * _positive(block.stretch_e[p - first])
    for p in range(run, ended if sizes.counts_dark else run):
        means.dark[k * sizes.sites + at + p] = seconds * sites.dark_e_per_s[p]
    for p in range(run, ended if is_own else run):
        light_e = slots * block.stretch_e[p - first]
        dark_e = seconds * block.dark_e_per_s[p - first]
        gained_e = slots * block.gained_e[p - first]
        if not sizes.even:
            block.gained_e[p - first] = _gained(sizes, sites, at + p, p, block.frame_e, begin)
            gained_e = block.gained_e[p - first] - gained_e
        means.charge[e * own + at + p] += light_e + dark_e + gained_e
        means.charge[at + p] += 0.0 * light_e  # NaN, if any slot is
    for p in range(run, run if sizes.even else stop):
        block.stretch_e[p - first] = 0.0
    block.counted[r] = k + 1
    lane_at = stretches.start[sites.lane[run]] + e
    if is_own and stretches.boundary[lane_at + 1] == n:
        block.reached[r] = e + 1
        last = min(n, sizes.slots - 1)
        slot_us = 1e6 * (stretches.start_s[last + 1] - stretches.start_s[last])
        for p in range(run, stop if sizes.slow_words else run):
            # The next stretch: electrons per microsecond of its first slot.
            gained_e = block.gained_e[p - first]
            if not sizes.even:
                gained_e = _gained(sizes, sites, at + p, p, block.slot_e, begin)
            light_e_per_us = (block.slot_e[p - begin] + gained_e) / slot_us
            dark_e_per_us = 1e-6 * block.dark_e_per_s[p - first]
            means.pace[(e + 1) * own + at + p] = light_e_per_us + dark_e_per_us
        # This stretch, also after the last slot: fractions of its charge; without, of its time.
        rows = e + 1 + (n == sizes.slots) if sizes.slow_words else 0
        for row in range(max(e, 0), rows):
            for p in range(run, stop):
                charge, pace = means.charge[e * own + at + p], means.pace[row * own + at + p]
                part = pace / charge if charge > 0.0 else 1e-6 * stretches.per_s[lane_at]
                means.pace[row * own + at + p] = part
    return stretches.boundary[next_at + 1] if n < sizes.slots else sizes.slots + 1


@loop
def stretch_means(
    sizes: StretchSizes,
    light: LightMatrix,
    stretches: Stretches,
    sites: Sites,
    index: Annotated[Ints, "sites"],
    block: LightBlock,
    means: StretchMeans,
) -> None:
    """Compute `means`, which are 0 before, of the sites number `begin` to `end` - 1.

    `sites` are in the order in which they are taken; their `place` is the index of their pixels in
    frames of `light`, and `beside` contains numbers in this order. `index`: the index of each in
    `means`, where the first are pixels that run through their words. `block` is working memory. A
    site is a pixel whose charge is computed."""
    first = sizes.begin
    while first < sizes.end:
        stop = min(first + sizes.together, sizes.end)
        runs, begin, count = _set_up(sizes, sites, index, first, stop, block)
        due, n = 0, 0
        while n <= sizes.slots:
            is_new = n == 0 or (n < sizes.slots and not sizes.even)
            if is_new and not same_light(light, n):
                _set_light(sizes, light, n, sites, begin, count, block.slot_e)
            for p in range(first, stop if sizes.even and n == 0 else first):
                if index[p] < sizes.own:
                    gained_e = _gained(sizes, sites, index[p], p, block.slot_e, begin)
                    block.gained_e[p - first] = gained_e
            if n == due:
                due = sizes.slots + 1
                for r in range(runs):
                    if block.due[r] == n:
                        block.due[r] = _turn(
                            sizes, stretches, sites, index, block, first, begin, r, n, means
                        )
                    due = min(due, block.due[r])
            for j in range(stop - first if is_new else 0):
                block.stretch_e[j] += block.slot_e[first - begin + j]
            for j in range(count if is_new and sizes.exchanged > 0.0 else 0):
                block.frame_e[j] += _positive(block.slot_e[j])
            n = due if sizes.even else n + 1
        first = stop


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


@compiled
def _receive(
    exchanging: Exchanging,
    stretches: Stretches,
    sites: Sites,
    away: Floats,
    side_at: int,
    first: int,
    stop: int,
    part: float,
    charge: Floats,
) -> None:
    """Add to the charge of the pixels `first` to `stop` - 1, which have one lane, what they receive
    from sites whose counts are drawn in the stretches of one lane. `side_at`: where these sites
    begin in sites.beside.

    They receive the fraction `part` of the deviations `away` (stretches, sites). If a stretch of
    the counts extends over several of the pixel's, it is spread evenly over time."""
    boundary, times, beside = stretches.boundary, stretches.start_s, sites.beside
    lane, counted = sites.lane[first], sites.counted[beside[side_at + first]]
    begin, theirs, own = 0, 0, 0
    e, k, last = stretches.start[lane], stretches.start[counted], stretches.start[lane + 1] - 2
    while e <= last:
        own_end, their_end = boundary[e + 1], boundary[k + 1]
        end = min(own_end, their_end)
        is_whole = end - begin == their_end - boundary[k]
        share = 1.0 if is_whole else (times[end] - times[begin]) * stretches.per_s[k]
        for i in range(first, stop):
            charge[own + i] += part * share * away[theirs + beside[side_at + i]]
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
    charge: Written[Floats],
) -> None:
    """Set `charge`, electrons (stretches, pixels), of the pixels begin to end - 1 in one frame. The
    charge is the sum of the means `mean_e` and the deviations `away` (stretches, sites) of Poisson
    counts from their means, after crosstalk.

    Slots of a stretch are counted as one number. A site is a pixel whose charge is computed."""
    pixels, c, beside = exchanging.pixels, exchanging.exchanged, sites.beside
    for first in range(exchanging.begin, exchanging.end, WORD_BLOCK):
        stop = min(first + WORD_BLOCK, exchanging.end)
        for e in range(exchanging.rows):
            for at in range(e * pixels + first, e * pixels + stop):
                charge[at] = mean_e[at]
        # A pixel at the border receives what a neighbour beyond it would get.
        for turn in range(1 + (NEIGHBOURS if c > 0.0 else 0)):
            part, side_at, begin = c, (OWN - turn) * pixels, first
            if turn == 0:
                part = 1.0 - NEIGHBOURS * c
            # Neighbours in these arrays usually have one lane, and so have those beside them.
            while begin < stop:
                counted, end = sites.counted[beside[side_at + begin]], begin + 1
                while end < stop and sites.lane[end] == sites.lane[begin]:
                    if sites.counted[beside[side_at + end]] != counted:
                        break
                    end += 1
                _receive(exchanging, stretches, sites, away, side_at, begin, end, part, charge)
                begin = end
