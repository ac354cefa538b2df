"""What plans cost: the way of simulating what is left of the effects, and its price."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from nscc_runtime.effects import CannotHave, Effect, Selection, registered
from nscc_runtime.effects.parts import Counted, Exchange
from nscc_runtime.planner.effect_fields import TRIED
from nscc_runtime.planner.plan_parts import Cost
from nscc_runtime.planner.predict import WORDS
from nscc_runtime.planner.prices import SHIPPED, fetching_ns
from nscc_runtime.planner.promises import Path, Promises
from nscc_runtime.remembered import remembered

MARGIN = 0.9
"""Effects are left out while the prediction stays below this part of the tolerance."""
BOUND_ERRORS = 3.0
"""Standard errors of a sample that a bound allows for."""
_SHORT_CUTS = 0.6
"""Short cuts may take this part of the tolerance; beyond it, all pixels run through their words."""


@dataclass(frozen=True, eq=False)
class Costs(Promises):
    """Plans of a scene, with what they take. `effects` is the choice that the user leaves."""

    effects: Selection

    @cached_property
    def forced_off(self) -> frozenset[str]:
        """Of the exposure, what the user wants off."""
        return frozenset(
            effect.name for effect in registered()
            if effect.kind != "after" and self.is_forced(effect) and effect not in self.effects
        )  # fmt: skip

    def is_forced(self, effect: Effect) -> bool:
        """Whether the user decides on it."""
        return not self.effects.auto or effect.name in self.effects.forced

    @remembered
    def path(self, dropped: frozenset[str]) -> Path:
        """See `Promises`."""
        summed = self._unsummed <= dropped and not self.everywhere
        if summed and not self.state(dropped).startswith(WORDS):
            return "sums"
        if not self.slow & self.here <= dropped:
            return "reference"
        if summed:
            return "sums"
        cheaper = self._all_words_ns(dropped) < self._reference_ns
        return "words" if cheaper else "reference"

    @cached_property
    def _unsummed(self) -> frozenset[str]:
        """Effects that sums cannot have."""
        return frozenset(e.name for e in self.present if isinstance(e.sums, CannotHave))

    @cached_property
    def everywhere(self) -> bool:
        """Whether short cuts would cost too much, so that all pixels run through their words."""
        cuts = self.account(self.state(self.forced_off)).variance(self.taken(self.forced_off))
        if math.sqrt(float(cuts.max())) > _SHORT_CUTS * self.tolerance_e:
            return True
        most = self.allowed_max
        # Their own part: what is forced off is beside it.
        return most is not None and self.worst(frozenset(), False).max_e > MARGIN * most.electrons

    @cached_property
    def _reference_ns(self) -> float:
        return self.program.work.reference_ns(SHIPPED)

    @remembered
    def _all_words_ns(self, dropped: frozenset[str]) -> float:
        """Nanoseconds a pixel of all pixels running through their words."""
        return self.program.work.words_ns(self.every.without(*dropped), SHIPPED, "all")

    def _near_ns(self, lacking: frozenset[str]) -> float:
        """Nanoseconds of one pixel near saturation that runs through its words."""
        return self.program.work.words_ns(self.every.without(*lacking), SHIPPED, "sums")

    @remembered
    def _path_ns(self, dropped: frozenset[str]) -> float:
        """Nanoseconds a pixel that the way of simulating what is left costs."""
        path = self.path(dropped)
        if path == "reference":
            return self._reference_ns
        if path == "words":
            return self._all_words_ns(dropped)
        return self._running_ns(self.state(dropped), self.forced_off)

    @remembered
    def _running_ns(self, state: str, lacking: frozenset[str]) -> float:
        """Nanoseconds a pixel of those that run through their words as they may saturate."""
        running = len(self.running(state))
        return self._near_ns(lacking) * running / len(self.program.lanes) if running else 0.0

    def saved_ns(self, names: frozenset[str], dropped: frozenset[str]) -> float:
        """Nanoseconds a pixel that leaving effects out saves, beside those in `dropped`."""
        saved = self._path_ns(dropped - names) - self._path_ns(dropped | names)
        if self.path(dropped) != "sums":
            return saved
        return saved + sum(ns for name, ns in self.prices_ns.items() if name in names)

    def own_ns(self, name: str, dropped: frozenset[str]) -> float:
        """The same of one effect, without what single pixels near saturation take: the table has a
        row for these."""
        if self.path(dropped - {name}) == self.path(dropped | {name}) == "sums":
            return self.prices_ns.get(name, 0.0)
        return self.saved_ns(frozenset({name}), dropped)

    def _frame_ns(self, dropped: frozenset[str], lacking: frozenset[str]) -> tuple[float, float]:
        """Nanoseconds a pixel of a frame, and those of them of pixels near saturation."""
        if self.path(dropped) != "sums":
            return self._path_ns(dropped), 0.0
        near = self._running_ns(self.state(dropped), lacking)
        kept = [each for each in self.present if each.name not in dropped]
        effects = sum(each.summed_ns(self.passes) for each in kept)
        light = SHIPPED.light * self.passes + self._fetching_ns
        return SHIPPED.summed + light + effects + near, near

    @property
    def _fetching_ns(self) -> float:
        """Nanoseconds a pixel of getting the scene's light."""
        return fetching_ns(SHIPPED, len(self.program.lanes), len(self.light.frames))

    def _planned_ns(self) -> float:
        """Nanoseconds a pixel of planning, but for the pixels near saturation that it runs."""
        frames, pixels = len(self.light.frames), len(self.program.lanes)
        sampled = SHIPPED.sampled * len(self.fields.sample.places) * self.light.slots / pixels
        return SHIPPED.planned + SHIPPED.light * frames + self._fetching_ns + sampled

    def _trying_ns(self) -> float:
        """Nanoseconds of running a sample of pixels near saturation through their words."""
        work, every = self.program.work, self.every
        alone = every.without(*every.names(Exchange))
        quiet = alone.without(*every.names(Counted))
        tried = len(self.near) and np.count_nonzero(self.fields.sample.near)
        tries = [quiet, alone] if self.sampled.noisy(self.tolerance_e) else [quiet]
        return sum(float(tried) * TRIED * work.words_ns(each, SHIPPED, "nothing") for each in tries)

    def cost(self, dropped: frozenset[str], lacking: frozenset[str]) -> Cost:
        """What the plan takes that leaves these effects out."""
        ms = len(self.program.lanes) * 1e-6
        least_ms = SHIPPED.plan_ms + self._planned_ns() * ms + self._trying_ns() * 1e-6
        # What pixels near saturation can do without is asked where something may be left out.
        planning_ms = least_ms + self.lacking(self.state(dropped)).tried_ns * 1e-6
        total, near = self._frame_ns(dropped, self.forced_off | lacking)
        every, _ = self._frame_ns(frozenset(), frozenset())
        return Cost(
            total * ms + SHIPPED.frame_ms + planning_ms, near * ms, planning_ms,
            every * ms + SHIPPED.frame_ms + least_ms, least_ms,
        )  # fmt: skip
