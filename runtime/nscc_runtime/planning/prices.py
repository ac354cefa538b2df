"""Predicted times of each kind of simulation, called prices.

Plans are chosen by the prices in `SHIPPED` instead of measured times, so that the same input gives
the same plan on every machine."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from nscc_runtime.caches import remembered
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Counted, Exchange
from nscc_runtime.execution.charge_loop import SITES
from nscc_runtime.execution.layout import ACTS
from nscc_runtime.execution.program import AnalysedProgram

Beside = Literal["sums", "all", "nothing"]
"""How the other pixels are simulated while one pixel runs through its words."""


@dataclass(frozen=True, eq=False)
class Prices:
    """Times of parts of a simulation, in nanoseconds of one core.

    `slot_of_reference`: the reference, per pixel and slot.

    Per pixel in the loop over words: `pixel`, to begin a pixel; `word`, each word; `error`, each
    small error of a word; `run`, the charge of a group of slots between two words at one site (a
    pixel or a neighbour); `given_count`, the same if the photon count is known already; `count`,
    drawing the photon count of a group at a site; `split`, each halving of a count to divide it
    between words.

    Per pixel in other simulations: `summed`, a pixel by sums over slots; `light`, each frame of its
    light; `looked`, a pixel that looks; `sampled`, a pixel of a planning sample, with and without
    every effect; `sampled_light`, each frame of its light.

    In milliseconds: `frame_ms`, each frame; `plan_ms`, each plan."""

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
"""Measured on one core of an x86 server at about 3 GHz by `nscc effects --cost`. Predicted times
are right to a factor of about 2."""


_SHARED_SITES = 2.5
"""Number of sites with own counts per pixel if all pixels are simulated, which share counts."""


@dataclass(frozen=True)
class Work:
    """The work of a pixel in the loop over words, as means over codes of pixels.

    `words`: words that act. `boundaries`: boundaries with such words. `groups`: groups of slots.
    `slots`: number of slots of a frame."""

    words: float
    boundaries: float
    groups: float
    slots: int

    @classmethod
    def of(cls, program: AnalysedProgram) -> Work:
        """Return the work of a program; the result is cached."""
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
        """Nanoseconds per pixel of a frame by the reference."""
        return SHIPPED.slot_of_reference * self.slots

    @remembered
    def words_ns(self, kept_effects: Selection, beside: Beside) -> float:
        """Return the nanoseconds of a pixel that runs through its words with the effects in
        `kept_effects`.

        `beside`: how its neighbours' counts are obtained: "sums" provides them, "all" pixels run
        and share them, or with "nothing" the pixel draws them itself."""
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
