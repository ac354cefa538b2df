"""What ways of simulating cost: the prices by which plans are chosen.

Plans are chosen by `SHIPPED`, so that the same input gives the same plan on every machine.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Counted, Exchange, SlowWords
from nscc_runtime.planner.charge_loop import SITES
from nscc_runtime.planner.layout import ACTS
from nscc_runtime.planner.pixels import Pixels
from nscc_runtime.remembered import remembered

Beside = Literal["sums", "all", "nothing"]
"""What is simulated beside a pixel that runs through its words."""


@dataclass(frozen=True, eq=False)
class Prices:
    """Nanoseconds of one core, each for one pixel.

    `slot_of_reference`: the reference, a slot. Of the loop over words: `pixel` to begin one;
    `word`; `error`, one of a word's small errors; `slot`, the light of a slot at one site (a pixel
    or a neighbour); `run`, that of a run of slots at a neighbour whose counts are given; `count`,
    the electrons of a group of slots drawn at a site; `split`, one count halved. `summed`: a pixel
    by sums over slots, `light` one frame of its light and `fetched` the same of a scene that no
    cache holds, beside the milliseconds `frame_ms` of any frame. `planned`: a pixel of the scene
    that is planned, beside the milliseconds `plan_ms` and `sampled`, a slot of a pixel of the
    sample. `looked`: a pixel that looks.
    """

    slot_of_reference: float
    pixel: float
    word: float
    error: float
    slot: float
    run: float
    count: float
    split: float
    summed: float
    light: float
    fetched: float
    frame_ms: float
    planned: float
    sampled: float
    plan_ms: float
    looked: float


SHIPPED = Prices(
    slot_of_reference=450.0, pixel=300.0, word=40.0, error=10.0, slot=5.0, run=12.0,
    count=100.0, split=15.0, summed=4.0, light=0.5, fetched=0.7, frame_ms=0.6, planned=15.0,
    sampled=30.0, plan_ms=5.0, looked=1200.0,
)  # fmt: skip
"""Measured on a core of an x86 server at about 3 GHz; what they add up to is right to a factor of
about 2."""


_CACHED = 1 << 23
"""Numbers of a scene that stay in a cache from one time through it to the next."""
_SHARED_SITES = 2.5
"""What a pixel and its neighbours cost, in sites, where all of these are simulated as well."""


def fetching_ns(prices: Prices, pixels: int, frames: int) -> float:
    """Nanoseconds a pixel of getting a scene's light, beside adding it up."""
    return prices.fetched * frames if pixels * frames > _CACHED else 0.0


@dataclass(frozen=True)
class Work:
    """What a pixel has to do in the loop over words, in the mean over lanes: words that act, the
    boundaries where they do, groups of slots; and the slots of a frame."""

    words: float
    boundaries: float
    groups: float
    slots: int

    @classmethod
    def of(cls, pixels: Pixels, slots: int) -> Work:
        """Of a program laid out for the loop."""
        acting = pixels.flags & ACTS > 0
        lanes = len(pixels.entry_start) - 1
        lane = np.repeat(np.arange(lanes), np.diff(pixels.entry_start))[acting]
        places = lane * (slots + 1) + pixels.entries["boundary"][pixels.entry_of[:-1][acting]]
        groups = len(np.unique(pixels.groups + np.arange(lanes)[:, None] * len(pixels.group_ids)))
        return cls(len(lane) / lanes, len(np.unique(places)) / lanes, groups / lanes, slots)

    def reference_ns(self, prices: Prices) -> float:
        """Of a pixel in the reference."""
        return prices.slot_of_reference * self.slots

    @remembered
    def words_ns(self, kept: Selection, prices: Prices, beside: Beside) -> float:
        """Of a pixel through its words with the effects in `kept`: beside sums, which have its
        neighbours' counts, among all pixels, or alone, where its neighbours' are its own affair."""
        errors = len(kept.errors()) * self.words
        own = prices.pixel + prices.word * self.words + prices.error * errors
        splits = self._nodes(beside != "sums" and kept.part(SlowWords) is not None)
        counted = self.groups * (prices.count + prices.split * splits)
        sources = len(kept.having(Counted))
        if beside == "sums":
            beside_ns = (SITES - 1) * prices.run * self.groups * self.boundaries
            return own + sources * counted + beside_ns * (kept.part(Exchange) is not None)
        sites = _SHARED_SITES if beside == "all" else SITES
        sites = 1.0 if kept.part(Exchange) is None else sites
        return own + sites * (prices.slot * self.slots + sources * counted)

    def _nodes(self, slow: bool) -> float:
        """Nodes of the tree over the slots that a pixel's counts are split at: those on the way to
        its boundaries, and to the slots behind them where light falls while words run."""
        ends, found, width = self.boundaries * (2.0 if slow else 1.0), 0.0, 1
        while width < self.slots:
            found += min(width, ends)
            width *= 2
        return found
