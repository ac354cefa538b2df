"""Running a plan: sums first, one draw a pixel, and single pixels through their words where needed.

The noise of all words is one draw a bucket. The draws are those of the reference
(`nscc_runtime.effects`), so that what a plan leaves out is the only difference from it. Pixels that
may saturate run through all their words. What only the reference has, the reference simulates.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Selection
from nscc_runtime.effects.counts import LIGHT, WITHOUT_LIGHT, count_key
from nscc_runtime.effects.parts import (
    CountedDark,
    CountedLight,
    Exchange,
    Soft,
    Well,
    WordGain,
)
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.noise import key, normals, poisson
from nscc_runtime.planner.fused import ROUNDING, Fused
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.pool import processors
from nscc_runtime.planner.prepared import Prepared
from nscc_runtime.planner.program import Program
from nscc_runtime.reference.capture import Reference, scene_of
from nscc_runtime.reference.noise import SUM

Values = NDArray[np.float64]
Marked = NDArray[np.uint8]


class Planned(Prepared):
    """A scene made ready under a plan, to be exposed."""

    @cached_property
    def fused(self) -> Fused | None:
        """The scene laid out for the loop that does it all, where the plan is simple."""
        return Fused.of(self)

    def expose(self, seed: int, frame: int) -> Exposure:
        """Frame number `frame`; threads change no bit."""
        if self.fused is not None:
            simple = self.fused.expose(seed, frame, read_out=False)
            return Exposure(simple.exposure_e, simple.valid, simple.saturated_by)
        if self.plan.slot_loop == "reference":
            return self._reference.expose(
                scene_of(self.program.container, self.light), seed, self.device_seed, frame
            )
        shape = (len(self.program.container.buckets), *self.light.shape)
        if self.plan.slot_loop == "all":
            found, marked = self._words(self.places, self.kept, seed, frame)
        else:
            found, marked = self._sums(seed, frame)
        if len(self.saturating):
            found[:, self.saturating], marked[:, self.saturating] = self._words(
                self.saturating, self.plan.kept_in_words, seed, frame
            )
        found += 0.0
        valid = np.isfinite(found)
        return Exposure(found.reshape(shape), valid.reshape(shape), marked.reshape(shape))

    @cached_property
    def _reference(self) -> Reference:
        return Reference.of(self.program.container, self.program.sensor, self.kept)

    def _words(
        self, chosen: NDArray[np.int64], kept: Selection, seed: int, frame: int
    ) -> tuple[Values, Marked]:
        program = self.program
        return program.words(kept).exposures(
            self.light,
            program.slot_s,
            chosen,
            kept,
            seed=seed,
            device_seed=self.device_seed,
            frame=frame,
            threads=self.threads,
        )

    def _sums(self, seed: int, frame: int) -> tuple[Values, Marked]:
        """Exposures (buckets, pixels) by sums over the slots, and what cut them off."""
        program, kept = self.program, self.kept
        away = self._counts(seed, frame)
        found = self.expected + self._spread(away) if away else self.expected.copy()
        marked = np.zeros(found.shape, np.uint8)
        mark = kept.marking("well")
        if kept.part(Well) and not kept.part(Soft):
            if mark is not None:
                # A well that is just full has lost nothing, however its charge was added up.
                marked[found > self.limits * (1.0 + ROUNDING)] = mark.bit
            np.minimum(found, self.limits, out=found)
        if kept.part(WordGain):
            found += self.patterns
        for effect, part in kept.errors():
            sigma = part.sigma_e(program.sensor)
            factor = sigma * program.tables.noise(part.at, self.wanted)[0]
            for draw in range(factor.shape[2]):
                if factor[:, :, draw].any():
                    z = normals(key(seed, effect.stream, SUM, frame, draw), self.places)
                    for bucket in range(len(found)):
                        found[bucket] += factor[program.lanes, bucket, draw] * z
        return found, marked

    def _counts(self, seed: int, frame: int) -> dict[int, Values]:
        """How far the counts of each group are from their means."""
        found = {}
        sources = [
            (effect, LIGHT, self.light_rates) for effect, _ in self.kept.having(CountedLight)
        ]
        sources += [
            (effect, WITHOUT_LIGHT, self.dark_rates) for effect, _ in self.kept.having(CountedDark)
        ]
        for group in self.counted:
            total = np.zeros(len(self.places))
            for effect, source, rates in sources:
                stream = count_key(seed, effect.stream, source, frame, group)
                counts, _ = poisson(stream, self.places, rates[group], exact=False)
                total += counts - rates[group]
            found[group] = total
        return found

    def _spread(self, away: dict[int, Values]) -> Values:
        """What the groups' deviations make of the exposures, neighbours' included."""
        program = self.program
        model, exchange = program.model(self.kept), self.kept.part(Exchange)
        if exchange is not None:
            return program.overlap(model, exchange).smeared(away)
        weights = program.mean_weights(model)
        lanes = program.lanes
        buckets = len(program.container.buckets)
        found = np.zeros((buckets, len(self.places)))
        for group, each in away.items():
            for bucket in range(buckets):
                found[bucket] += weights[group][lanes, bucket] * each
        return found


def prepared(
    program: Program,
    light: Light,
    plan: Plan,
    *,
    device_seed: int = 0,
    threads: int | None = None,
) -> Planned:
    """A scene made ready; raises Rejected as `nscc_runtime.emulator.expose` does."""
    check_size(program.container, light)
    return Planned(program, light, plan, device_seed, processors() if threads is None else threads)
