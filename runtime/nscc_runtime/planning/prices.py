"""What ways of simulating cost: the prices by which plans are chosen.

Plans are chosen by `SHIPPED`, so that the same input gives the same plan on every machine.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Counted, Exchange
from nscc_runtime.execution.charge_loop import SITES
from nscc_runtime.execution.layout import ACTS
from nscc_runtime.execution.program import Program
from nscc_runtime.remembered import remembered

Beside = Literal["sums", "all", "nothing"]
"""What is simulated beside a pixel that runs through its words."""


@dataclass(frozen=True, eq=False)
class Prices:
    """Nanoseconds of one core, each for one pixel.

    `slot_of_reference`: the reference, a slot. Of the loop over words: `pixel` to begin one;
    `word`; `error`, one of a word's small errors; `run`, the charge of one group of slots between
    two words at one site (a pixel or a neighbour), `given` where its count is given; `count`, a
    group's electrons drawn at a site, and `split`, a halving of them on the way to their part
    between two words. `summed`: a pixel by sums over slots, and `light` one frame of its light,
    beside the milliseconds `frame_ms` of any frame. `looked`: a pixel that looks.
    `tried`: a pixel of the sample, with and without every effect, and `tried_light` one frame of
    its light, beside the milliseconds `plan_ms` of any plan.
    """

    slot_of_reference: float
    pixel: float
    word: float
    error: float
    run: float
    given: float
    count: float
    split: float
    summed: float
    light: float
    frame_ms: float
    looked: float
    tried: float
    tried_light: float
    plan_ms: float


SHIPPED = Prices(
    slot_of_reference=450.0, pixel=300.0, word=15.0, error=10.0, run=6.0, given=12.0, count=50.0,
    split=8.0, summed=4.0, light=0.5, frame_ms=0.6, looked=1200.0, tried=1000.0,
    tried_light=20.0, plan_ms=8.0,
)  # fmt: skip
"""Measured on a core of an x86 server at about 3 GHz by `nscc effects --cost`; what they add up to
is right to a factor of about 2."""


_SHARED_SITES = 2.5
"""What a pixel and its neighbours cost, in sites, where all of these are simulated as well."""


@dataclass(frozen=True)
class Work:
    """What a pixel has to do in the loop over words, in the mean over lanes: words that act, the
    boundaries where they do, groups of slots; and the slots of a frame."""

    words: float
    boundaries: float
    groups: float
    slots: int

    @classmethod
    def of(cls, program: Program) -> Work:
        """Of a program; kept with it."""
        return program.recent.of("work", lambda: cls._of(program))

    @classmethod
    def _of(cls, program: Program) -> Work:
        pixels, slots = program.pixels, program.container.slots
        listed, begins = pixels.lanes, pixels.program.words["begins"]
        acting, lanes = listed.flags & ACTS > 0, len(listed.start) - 1
        lane = np.repeat(np.arange(lanes), np.diff(listed.start))[acting]
        places = lane * (slots + 1) + begins[listed.word[acting]]
        groups = len(np.unique(pixels.groups + np.arange(lanes)[:, None] * len(pixels.group_ids)))
        return cls(len(lane) / lanes, len(np.unique(places)) / lanes, groups / lanes, slots)

    @property
    def reference_ns(self) -> float:
        """Of a pixel in the reference."""
        return SHIPPED.slot_of_reference * self.slots

    @remembered
    def words_ns(self, kept: Selection, beside: Beside) -> float:
        """Of a pixel through its words with the effects in `kept`: beside sums, which have its
        neighbours' counts, among all pixels, or alone, where its neighbours' are its own affair."""
        prices, runs = SHIPPED, self.groups * self.boundaries
        own_ns = prices.pixel + self.words * (prices.word + prices.error * len(kept.errors()))
        counted_ns = prices.count * self.groups + prices.split * runs * math.log2(self.slots + 1)
        counted_ns *= len(kept.having(Counted))
        others = 0.0
        if kept.part(Exchange) is not None:
            others = (_SHARED_SITES if beside == "all" else SITES) - 1.0
        if beside == "sums":
            return own_ns + counted_ns + others * prices.given * runs
        return own_ns + (1.0 + others) * (prices.run * runs + counted_ns)
