"""The time of each kind of simulation: the prices by which plans are chosen.

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
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.method_cache import remembered

Beside = Literal["sums", "all", "nothing"]
"""The simulation of the other pixels while one pixel runs through its words."""


@dataclass(frozen=True, eq=False)
class Prices:
    """Nanoseconds of one core per pixel.

    `slot_of_reference`: the reference, a slot. Of the loop over words: `pixel` to begin one;
    `word`; `error`, one of a word's small errors; `run`, the charge of one group of slots between
    two words at one site (a pixel or a neighbour), `given_count` where its count is given; `count`,
    a group's electrons drawn at a site, and `split`, a halving of them on the way to their part
    between two words. `summed`: a pixel by sums over slots, and `light` one frame of its light,
    beside the milliseconds `frame_ms` of any frame. `looked`: a pixel that looks. `sampled`: a
    pixel of the sample, with and without every effect, and `sampled_light` one frame of its light,
    beside the milliseconds `plan_ms` of any plan."""

    slot_of_reference: float
    pixel: float
    word: float
    error: float
    run: float
    given_count: float
    count: float
    split: float
    summed: float
    light: float
    frame_ms: float
    looked: float
    sampled: float
    sampled_light: float
    plan_ms: float


SHIPPED = Prices(
    slot_of_reference=450.0, pixel=300.0, word=15.0, error=10.0, run=6.0, given_count=12.0,
    count=50.0, split=8.0, summed=4.0, light=0.5, frame_ms=0.6, looked=1200.0, sampled=1000.0,
    sampled_light=20.0, plan_ms=8.0,
)  # fmt: skip
"""Measured on a core of an x86 server at about 3 GHz by `nscc effects --cost`; what they add up to
is right to a factor of about 2."""


_SHARED_SITES = 2.5
"""Sites per pixel if all pixels are simulated, so that neighbours share counts."""


@dataclass(frozen=True)
class Work:
    """The work of a pixel in the loop over words, as means over lanes: words that act, boundaries
    with such words, and groups of slots; and the number of slots of a frame."""

    words: float
    boundaries: float
    groups: float
    slots: int

    @classmethod
    def of(cls, program: AnalysedProgram) -> Work:
        """Return the work of a program, computed once."""
        return program.recent.of("work", lambda: cls._of(program))

    @classmethod
    def _of(cls, program: AnalysedProgram) -> Work:
        pixels, slots = program.pixels, program.container.slots
        listed, begins = pixels.lanes, pixels.program.words["begins"]
        acting, lanes = listed.flags & ACTS > 0, len(listed.start) - 1
        lane = np.repeat(np.arange(lanes), np.diff(listed.start))[acting]
        places = lane * (slots + 1) + begins[listed.word[acting]]
        groups = len(np.unique(pixels.groups + np.arange(lanes)[:, None] * len(pixels.group_ids)))
        return cls(len(lane) / lanes, len(np.unique(places)) / lanes, groups / lanes, slots)

    @property
    def reference_ns(self) -> float:
        """Nanoseconds of a pixel in the reference."""
        return SHIPPED.slot_of_reference * self.slots

    @remembered
    def words_ns(self, kept_effects: Selection, beside: Beside) -> float:
        """Return the nanoseconds of a pixel through its words with the effects in `kept_effects`.

        `beside`: "sums" provide its neighbours' counts, "all" pixels run and share them, with
        "nothing" the pixel draws them itself."""
        prices, runs = SHIPPED, self.groups * self.boundaries
        own_ns = prices.pixel + self.words * (
            prices.word + prices.error * len(kept_effects.errors())
        )
        counted_ns = prices.count * self.groups + prices.split * runs * math.log2(self.slots + 1)
        counted_ns *= len(kept_effects.having(Counted))
        neighbour_sites = 0.0
        if kept_effects.find_part(Exchange) is not None:
            neighbour_sites = (_SHARED_SITES if beside == "all" else SITES) - 1.0
        if beside == "sums":
            return own_ns + counted_ns + neighbour_sites * prices.given_count * runs
        return own_ns + (1.0 + neighbour_sites) * (prices.run * runs + counted_ns)
