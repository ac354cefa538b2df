"""What plans promise beside the mean square error: their worst pixels, and the frame's noise."""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects.parts import (
    Counted,
    CountedLight,
    Exchange,
    Fading,
    LitLevel,
    SlowWords,
)
from nscc_runtime.planner.accounts import Errors
from nscc_runtime.planner.chip import whole_chip
from nscc_runtime.planner.effect_fields import BOTH, FORCED
from nscc_runtime.planner.lacking import Lacking, guesses
from nscc_runtime.planner.plan import Plan
from nscc_runtime.planner.predict import Forecast
from nscc_runtime.planner.prepared import Prepared
from nscc_runtime.planner.short_cuts import FORMULA, UNDRAWN
from nscc_runtime.planner.tolerance import (
    OPTION_MAX,
    Given,
    Tolerance,
    mean_signal_e,
    tolerance_of,
    with_readout_e,
)
from nscc_runtime.planner.worst import Worst, worst_measured, worst_of
from nscc_runtime.remembered import remembered

Values = NDArray[np.float64]
Path = Literal["sums", "words", "reference"]

_RARE = 2.0
"""Standard deviations of the counts of the few brightest pixels."""
_WORSE = 3.0
_MATTERS = 0.01
"""Of the tolerance: what is smaller goes with what it hangs on."""
_UNTOLD = 0.01
"""By so much the ratio of noise may depend on pixels near saturation."""


@dataclass(frozen=True, eq=False)
class Promises(Forecast):
    """A forecast beside what is asked of it."""

    tolerance: Given
    tolerance_max: Given | None

    @abstractmethod
    def path(self, dropped: frozenset[str]) -> Path:
        """What has all effects that are left: sums over slots, the loop over the words of single
        pixels for all of them, or the reference alone.
        """

    @cached_property
    def allowed(self) -> Tolerance:
        """What the tolerance means here. Raises Rejected (NS0746) where it is none."""
        return tolerance_of(self.tolerance, self.program.sensor, self)

    @cached_property
    def allowed_max(self) -> Tolerance | None:
        """The same of the tolerance of the worst pixel; None: it may be anything."""
        asked = self.tolerance_max
        if asked is None:
            return None
        return tolerance_of(asked, self.program.sensor, self, OPTION_MAX)

    @property
    def tolerance_e(self) -> float:
        """The tolerance in electrons."""
        return self.allowed.electrons

    @property
    def bounded(self) -> bool:
        """Whether the worst pixel has a tolerance of its own."""
        return self.tolerance_max is not None

    def with_what_hangs_on_it(
        self, name: str, free: frozenset[str], dropped: frozenset[str]
    ) -> frozenset[str]:
        """What leaving an effect out takes along of the `free` ones, itself included: nothing is
        left of black suns where words take no time. Empty where some of that has to stay.
        """
        if name not in self.every.names(SlowWords):
            return frozenset({name})
        lit = (self.every.names(LitLevel) & self.here) - dropped
        return lit | {name} if lit <= free else frozenset()

    @cached_property
    def prices_ns(self) -> dict[str, float]:
        """Nanoseconds a pixel that leaving each effect out of sums saves: dead time stays where
        black suns matter, which are told of."""
        lit, least_e = self.every.names(LitLevel), _MATTERS * self.tolerance_e
        told = any(self.contribution(e)[0] > least_e for e in self.present if e.name in lit)
        stays = self.every.names(SlowWords) if told else ()
        return {e.name: 0.0 if e.name in stays else e.summed_ns(self.passes) for e in self.present}

    @property
    def passes(self) -> int:
        """How many frames of light are added up, over all buckets."""
        return len(self.light.frames) * len(self.program.container.buckets)

    def signal_e(self) -> float:
        """See `nscc_runtime.planner.tolerance.Follows`."""
        plan = Plan.of_nothing()
        exact = Prepared(self.program, self.light, plan, self.device_seed, self.threads)
        return mean_signal_e(exact.expected, self.program.sensor)

    def noise_e(self) -> float:
        """See `nscc_runtime.planner.tolerance.Follows`. Where the full well is passed, charge is
        not random."""
        return with_readout_e(math.sqrt(self.sampled.rough.noise_e2), self.program.sensor)

    @property
    def coarse(self) -> bool:
        """Whether errors may be larger than the noise of exposures. Where they are, effects are
        left out that squeeze the noise as well, and no prediction of it is a promise."""
        return self.tolerance_e**2 > self.fields.noise_e2

    @remembered
    def lacking(self, state: str) -> Lacking:
        """What pixels can do without that run through their words in a state."""
        return Lacking(
            self.program, self.light, self.charges(state), self.spilt,
            self.fields, self.runs(state), self.forced_off, self.device_seed, self.threads,
        )  # fmt: skip

    def worst(
        self, dropped: frozenset[str], everywhere: bool, lacking: frozenset[str] = frozenset()
    ) -> Worst:
        """The predicted errors of the worst pixels; those that run through their words because they
        may saturate are without the effects that are `lacking` there."""
        errors = self.errors(dropped, everywhere, lacking)
        weight, pixels = self.fields.sample.weight, len(self.program.lanes)
        found = worst_of(errors, weight, pixels)
        if not everywhere and FORMULA in self.taken(dropped):
            # A count is right or one off, beside all else: its variance tells nothing of that.
            found = replace(found, max_e=max(found.max_e, found.p999_e + 1.0))
        if not everywhere and len(self.running(self.state(dropped))):
            found = replace(found, max_e=max(found.max_e, self._evened_e(dropped, lacking)))
        near, taken = self.fields.sample.near, self._taken_near(dropped)
        if taken is None:
            return found
        # What saturation would take is of one frame's noise: another's takes it farther.
        # Those that see most stand for themselves: no other pixel is beyond them.
        alone = near & (weight <= 1.0)
        tails = [
            worst_measured(taken[:, which], weight[which] / weight.sum(), pixels).max_e
            for which in (alone, near & ~alone)
        ]
        rarely_e = (self.fields.rarely_e.get(name, 0.0) for name in self.saturation & dropped)
        return replace(found, max_e=max(found.max_e, *tails, *rarely_e))

    def _taken_near(self, dropped: frozenset[str]) -> Values | None:
        """What a plan lacks near saturation that one frame was measured for (buckets, pixels of the
        sample); None where that is nothing."""
        fixed = self.fields.fixed
        cut = self.inside(dropped) & (self.saturation | {BOTH, FORCED}) & fixed.keys()
        if not cut or not self.fields.sample.near.any():
            return None
        return np.asarray(np.sum([fixed[name] for name in sorted(cut)], axis=0))

    def _evened_e(self, dropped: frozenset[str], lacking: frozenset[str]) -> float:
        """How far the worst pixel near saturation may be off as counts are taken as even over
        slots: its own, of which words that take time see a part, where that does not fill PIX; and
        those of suns beside it, of which so much comes over that PIX is not full. One read may
        count many times, as that of a level does from which several exposures are told."""
        kept = self.every.without(*self.forced_off, *lacking)
        if kept.part(CountedLight) is None:
            return 0.0
        full_e = whole_chip(self.program, self.device_seed).full_e
        running = self.running(self.state(dropped))
        slot_e = self.light.sum_e.reshape(-1)[running] / self.light.slots
        part = self.program.read_part if kept.part(SlowWords) is not None else 0.0
        own_e2 = np.minimum(part * slot_e, full_e) ** 2 / np.maximum(slot_e, 1.0)
        exchange = kept.part(Exchange)
        spilt = exchange is not None and len(self.spilt) > 0
        beside_e2 = exchange.fraction(self.program.sensor) * full_e if exchange and spilt else 0.0
        read = self.program.tables.most_read(self.program.full).max(axis=1)
        weight = read[self.program.lanes[running]]
        return _RARE * float((weight * np.sqrt(np.maximum(own_e2, beside_e2))).max())

    def sampling_error(self, dropped: frozenset[str], everywhere: bool) -> NDArray[np.float64]:
        """The standard error (buckets,) of predicted mean squares: a sample is not the scene, nor
        one frame another."""
        mean, variance, _ = self.errors(dropped, everywhere)
        found = self.fields.sample.error(mean**2 + variance)
        taken = self._taken_near(dropped)
        if taken is None:
            return found
        # What saturation takes of a few pixels is more in one frame than in another.
        noise_e2 = np.maximum(np.sum([*self.fields.noise.values()], axis=0), 0.0)
        return np.hypot(found, self.fields.sample.spread(2.0 * taken * np.sqrt(noise_e2)))

    @remembered
    def errors(
        self, dropped: frozenset[str], everywhere: bool, lacking: frozenset[str] = frozenset()
    ) -> Errors:
        """What a plan leaves wrong with each pixel of the sample."""
        state = self.state(dropped)
        lost = self.wrong(dropped, everywhere)
        found = self.account_of(dropped, everywhere).errors(*lost)
        found.variance[...] += self.rounding_of(dropped)
        if lacking:
            near = guesses(self.fields, self.runs(state), lacking).errors(lacking, lacking)
            found = Errors(*(each + more for each, more in zip(found, near, strict=True)))
        return found

    def noise_ratio(
        self,
        dropped: frozenset[str],
        everywhere: bool,
        lacking: frozenset[str] = frozenset(),
        readout: bool = False,
    ) -> float | None:
        """The predicted standard deviation of a plan's exposures over frames by that with every
        effect, in root mean square over pixels and buckets; of what is read out with `readout`.
        None where nothing is random."""
        state = self.state(dropped)
        far, near = self._lost_near(dropped, lacking)
        square = kept_e2 = 0.0
        for name, noise in self._noise(state).items():
            square += noise.all
            # What is left of infinite noise is no number where nothing is.
            if left := self._left(name, far):
                kept_e2 += left * noise.far * self._louder(name, dropped)
            if left := self._left(name, near):
                kept_e2 += left * noise.near
        if not everywhere:
            kept_e2 -= float(self.account(state).variance(self._undrawn(dropped)).mean())
        for name in self.off_for_good(dropped, everywhere):
            more = self.sampled.reweighed.noise[name] * self._where(state)
            kept_e2 -= float(self.fields.sample.mean(more).mean())
        added = with_readout_e(0.0, self.program.sensor) ** 2 if readout else 0.0
        if not square + added > 0:
            return None
        return math.sqrt(max(kept_e2 + added, 0.0) / (square + added))

    def _lost_near(
        self, dropped: frozenset[str], lacking: frozenset[str]
    ) -> tuple[frozenset[str], frozenset[str]]:
        """What a plan lacks far from saturation, and near it, where pixels run through their words
        with more than the others, unless the reference runs."""
        by_reference = self.path(dropped) == "reference"
        return dropped, dropped if by_reference else self.forced_off | lacking

    @remembered
    def _left(self, name: str, lost: frozenset[str]) -> float:
        """Which part of an effect's noise is left where some are lost: of what evens out counts the
        part of those that there are."""
        if name in lost or name not in self.every.names(Exchange):
            return float(name not in lost)
        noise, counts = self.fields.noise, self.every.names(Counted)
        e2 = {each: float(np.mean(noise[each])) for each in counts & noise.keys()}
        every = sum(e2.values())
        return sum(e2[each] for each in e2.keys() - lost) / every if every > 0 else 1.0

    def _louder(self, name: str, dropped: frozenset[str]) -> float:
        """By what factor the variance of an effect is larger in sums that lack what weighs counts;
        what is left out by choice weighs errors all the same."""
        if name not in self.every.names(Counted):
            return 1.0
        louder = self.sampled.louder
        return math.prod(louder[each] for each in louder.keys() & dropped)

    def _undrawn(self, dropped: frozenset[str]) -> list[str]:
        """The short cuts of a plan whose squares are variance that is not drawn."""
        return [name for name in self.taken(dropped) if name in UNDRAWN]

    def noise_told(
        self, dropped: frozenset[str], everywhere: bool, lacking: frozenset[str]
    ) -> float | None:
        """`noise_ratio` where it is a promise, else None.

        It is none where registers fade and are simulated as if they did not: other words act then.
        Saturation leaves less of the noise of pixels near it, of one effect's more than of
        another's: beside such pixels it is no promise where saturation is left out or what weighs
        errors is off, nor where none of that noise, all of it, losing `_WORSE` times as much of it,
        or what leaving effects out was measured to change there, would make another; nor, where
        they have any of it, with noise forced off, which may cancel in all other pixels and not in
        them."""
        ratio = self.noise_ratio(dropped, everywhere, lacking)
        mean, near = self.fields.sample.mean, self.fields.sample.near
        as_if_fresh = self.program.tables.decays and self.every.names(Fading) <= dropped
        if ratio is None or self.coarse or as_if_fresh or not near.any():
            return None if self.coarse or as_if_fresh else ratio
        if dropped & self.saturation or self.off_for_good(dropped, everywhere):
            return None
        full, mine = self._noise_e2_of(dropped, everywhere, lacking)
        noise, (_, lost_near) = self.fields.noise, self._lost_near(dropped, lacking)
        none = np.zeros(full.shape)
        uncut = sum(noise.values(), none)
        parts = {name: self._left(name, lost_near) for name in noise}
        left = sum((part * noise[name] for name, part in parts.items() if part), none)
        far, far_kept, all_e2, kept, more, more_left = (
            float(np.mean(mean(each)))
            for each in (
                np.where(near, 0.0, full), np.where(near, 0.0, mine), full, mine,
                np.where(near, uncut - full, 0.0), np.where(near, left - mine, 0.0),
            )
        )  # fmt: skip
        lost = (all_e2 - far) - (kept - far_kept)
        if lost > 0 and not far > 0:
            return None
        if self.forced_off & self.fields.noise.keys() and (all_e2 - far + more) > _UNTOLD * all_e2:
            return None
        cases = [(kept - (_WORSE - 1.0) * lost, all_e2), (kept + more_left, all_e2 + more)]
        if lacking:
            # Errors that cancel elsewhere are left where PIX is full: they are noise as well.
            measured = self.lacking(self.state(dropped)).square(dropped, lacking)
            cases.append((kept - max(float(measured.mean()) - lost, 0.0), all_e2))
        if far > 0:
            cases.append((far_kept, far))
        off = max(abs(math.sqrt(max(rest, 0.0) / every) - ratio) for rest, every in cases)
        return ratio if off <= _UNTOLD else None

    def _noise_e2_of(
        self, dropped: frozenset[str], everywhere: bool, lacking: frozenset[str]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The variance over frames (buckets, pixels of the sample) with every effect, and under a
        plan."""
        found, state = self.fields, self.state(dropped)
        lost_far, lost_near = self._lost_near(dropped, lacking)
        runs = self.runs(state)
        full, mine = (np.zeros(found.expected.shape) for _ in range(2))
        for name, there in found.noise_left.items():
            full += there
            far = self._left(name, lost_far) * self._louder(name, dropped)
            part = np.where(runs, self._left(name, lost_near), far)
            kept = found.noise[name] if state == "sums" else there
            mine += np.multiply(part, kept, out=np.zeros(full.shape), where=part > 0)
        if not everywhere:
            mine -= self.account(state).errors((), self._undrawn(dropped))[1]
        return full, mine

    @remembered
    def _noise(self, state: str) -> dict[str, _Noise]:
        """What each effect adds to the noise in a state of the pixels that may saturate."""
        found, runs = self.fields, self.runs(state)
        left = np.array([*found.noise_left.values()])
        kept = np.array([*found.noise.values()]) if state == "sums" else left
        parts = (left, np.where(runs, 0.0, kept), np.where(runs, kept, 0.0))
        means = np.stack([found.sample.mean(each).mean(axis=1) for each in parts], axis=1)
        return {name: _Noise(*each) for name, each in zip(found.noise, means.tolist(), strict=True)}


@dataclass(frozen=True)
class _Noise:
    """An effect's part in the variance over frames, mean over pixels and buckets: with `all`
    simulated, and of that of a plan's pixels `far` from saturation and `near` to it."""

    all: float
    far: float
    near: float
