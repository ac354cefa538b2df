"""Programs with fixed shutters, tried on a sample of a scene: frames by weighted sums, where pixels
near saturation run through their words."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import Effect, Selection, everything, registered
from nscc_runtime.effects.parts import (
    Counted,
    CountedDark,
    CountedLight,
    Exchange,
    LitLevel,
    Moving,
    Saturates,
    SlowWords,
)
from nscc_runtime.effects.parts import Errors as SmallErrors
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.frames import Execution, Path, counts_agree
from nscc_runtime.execution.near import NearSaturation, near_saturation
from nscc_runtime.execution.program import Program
from nscc_runtime.execution.summed import APPROXIMATIONS
from nscc_runtime.light import Light
from nscc_runtime.planning.differences import Difference, Errors, WeightedPixels
from nscc_runtime.planning.prices import SHIPPED, Work
from nscc_runtime.planning.sample import TILES, Sample, near_sampled, sample_of
from nscc_runtime.planning.sampled_exposures import SampledExposures
from nscc_runtime.planning.trial import NONE, NOTHING, Move, Names, Setting, Trial
from nscc_runtime.remembered import remembered

Values = NDArray[np.float64]

_FRAMES = 4
"""In which pixels near saturation are measured where nothing of that is kept."""
_UNSEEN = 3.0
"""Of so many of any number of pixels none is drawn in one sample of twenty."""


@dataclass(frozen=True, eq=False)
class SummedTrial(Trial):
    """A program with fixed shutters on a scene."""

    program: Program
    light: Light
    device_seed: int
    threads: int

    approximations = APPROXIMATIONS

    @property
    def sensor(self) -> Sensor:
        """The sensor."""
        return self.program.sensor

    @property
    def pixels(self) -> int:
        """How many pixels the scene has."""
        return self.program.array.lanes.size

    @cached_property
    def near(self) -> NearSaturation:
        """The pixels of the scene that every effect together brings near saturation."""
        return near_saturation(self.program, self.light, self.device_seed, everything())

    @cached_property
    def running(self) -> int:
        """How many pixels of the scene run through their words."""
        wanted = self.wanted
        return len(near_saturation(self.program, self.light, self.device_seed, wanted).places)

    @cached_property
    def sample(self) -> Sample:
        """The measured pixels."""
        total_e = (self.light.motion or self.light).sum_e
        dark = everything().the(CountedDark)  # a few pixels may have most of it
        current = self.program.array.device(self.sensor, self.device_seed).fixed(dark.per_s)
        dark_e = (current * self.program.slot_s.sum()).reshape(total_e.shape)
        return sample_of(total_e + dark_e, self.near, self.sensor.full_well_e)

    @cached_property
    def exposures(self) -> SampledExposures:
        """What the measured pixels expose."""
        return SampledExposures(
            self.program, self.light, self.sample, self.device_seed, self.threads
        )

    @cached_property
    def saturation(self) -> Names:
        """The effects for which pixels run through their words."""
        return self.wanted.names(Saturates)

    @cached_property
    def absent(self) -> Names:
        """Effects that change nothing here for sure."""
        names = {e.name for e in registered() if e.reference.keys() == {"compare"}}
        if self.light.motion is None:
            names |= everything().names(Moving)
        if not self.program.tables.decays:
            names |= {e.name for e in registered() if e.reference.keys() == {"digital"}}
        if not len(self.near.places):
            names |= everything().names(Saturates)
        return frozenset(names)

    @property
    def alike(self) -> bool:
        """Not near saturation, where a pixel may differ from all others."""
        return not self.running

    @cached_property
    def _every(self) -> Selection:
        """Every effect that sums and words can have."""
        return everything().without(*self.slow)

    @cached_property
    def _wanted(self) -> Selection:
        """Those of them that the user did not force off."""
        return self.wanted.without(*self.slow)

    def executes(self, setting: Setting) -> Path:
        """Sums, or what takes their place."""
        return self.execution(setting).path

    @remembered
    def execution(self, setting: Setting) -> Execution:
        """What a setting comes to."""
        kept, near = self._wanted.without(*setting.dropped), self._wanted.without(*setting.near)
        return Execution("sums", kept, near, self.wanted, setting.exact)

    @cached_property
    def _lacked_e(self) -> Values:
        """What leaving out the effects changes that only the reference has."""
        if not self.slow - self.absent:
            return np.zeros(self._shape)
        by = self.exposures
        return by.by_reference(self._every) - by.by_reference(everything())

    # -- What is measured ---------------------------------------------------------------------

    def alone(self, effect: Effect, near: bool) -> Errors:
        """Of pixels far from saturation, by sums; of what saturates, of pixels near it."""
        by, name = self.exposures, effect.name
        if name in self.slow:
            return Errors.of(
                by.by_reference(everything().without(name)), by.by_reference(everything())
            )
        wanted = everything().without(*(self.forced_off - {name}))
        every = wanted.without(*self.slow)
        without = every.without(name)
        exposed, truth = np.zeros(self._shape), np.zeros(self._shape)
        if name not in self.saturation:
            exposed[:, self.sample.far] = by.by_sums(without, wanted, "far", 0)
            truth[:, self.sample.far] = by.by_sums(every, wanted, "far", 0)
            near = near and bool(self.settings(frozenset({name}))[0].near)
        if near or name in self.saturation:
            exposed[:, self.sample.near] = by.by_words(without, self.sample.near)
            truth[:, self.sample.near] = self._near_by_words(every)
        return Errors.of(exposed, truth)

    @remembered
    def _near_by_words(self, effects: Selection, frame: int = 0) -> Values:
        """Exposures near saturation through the words."""
        return self.exposures.by_words(effects, self.sample.near, frame)

    @property
    def _shape(self) -> tuple[int, int]:
        return len(self.program.container.buckets), len(self.sample.places)

    def approximated(self) -> Difference | None:
        """Of one pixel in each tile, and none near saturation."""
        some, sample = self.sample.one_each, self.sample
        by_sums = self.exposures.by_sums(self._every, everything(), "far", 0)[:, some]
        truth = self.exposures.by_words(self._every, some)
        pixels = WeightedPixels(sample.weight[some], np.arange(len(some)), sample.scene_pixels)
        part = math.sqrt(max(0.0, 1.0 - sample.near_part))
        return Difference(Errors.of(part * by_sums, part * truth), pixels)

    def forced(self) -> Errors:
        """By the reference where only that has some of it."""
        by, nothing = self.exposures, np.zeros(self._shape)
        if not self.forced_off:
            return Errors.of(nothing, nothing)
        if self.slow & self.forced_off:
            return Errors.of(by.by_reference(self.wanted), by.by_reference(everything()))
        return self.together(Setting(NONE, exact=True))

    def together(self, setting: Setting) -> Errors:
        """Far from saturation beside sums with every effect, near it beside the truth. Where noise
        decides how much is lost that saturates, one frame says little: each of several is an
        output."""
        execution, by, near = self.execution(setting), self.exposures, self.sample.near
        every = by.by_sums(self._every, everything(), "far", 0)
        exposed = [by.expose(execution, 0) + self._lacked_e]
        truth = [np.append(every, self._near_by_words(self._every), axis=1)]
        if execution.path == "sums" and setting.dropped >= self.saturation and self.running:
            for frame in range(1, _FRAMES):
                again_e = by.by_sums(execution.kept, execution.wanted, "near", frame)
                exposed.append(exposed[0].copy())
                exposed[-1][:, near] = again_e + self._lacked_e[:, near]
                truth.append(np.append(every, self._near_by_words(self._every, frame), axis=1))
        return Errors.of(np.concatenate(exposed), np.concatenate(truth))

    @remembered
    def square_e2(self, names: Names) -> float:
        """What all that saturates takes from pixels near saturation."""
        exposed, truth = np.zeros(self._shape), np.zeros(self._shape)
        kept = self._wanted.without(*names)
        exposed[:, self.sample.near] = self.exposures.by_sums(kept, self.wanted, "near", 0)
        truth[:, self.sample.near] = self._near_by_words(self._every)
        return Difference(Errors.of(exposed, truth), self.sample).likely_e2(0.0)

    def unseen_e2(self, setting: Setting) -> float:
        """Of pixels near saturation that differ from all that were measured: so few that none was
        drawn, each losing what a pixel would whose PIX is just full."""
        sample, lacking = self.sample, setting.near
        if not lacking or not sample.drawn_near:
            return 0.0
        kept = self._wanted.without(*self.saturation)
        some, every = (
            self.exposures.by_sums(each, self.wanted, "near", 0)
            for each in (kept.without(*lacking), kept)
        )
        order = np.searchsorted(self.near.places, sample.places[sample.near])
        just_full = np.minimum(1.0, self.sensor.full_well_e / self.near.most_e[order])
        weight = sample.weight[sample.near] * just_full / sample.weight[sample.near].sum()
        part = sample.near_part * min(1.0, _UNSEEN / sample.drawn_near)
        return float((np.nan_to_num(some - every) ** 2 * weight).sum(axis=1).max()) * part

    def noise_e(self) -> float:
        """Measured on two frames."""
        every = self._unforced.execution(NOTHING)
        exposures = [self._unforced.exposures.expose(every, frame) for frame in range(2)]
        variance = np.nan_to_num(np.var(exposures, axis=0, ddof=1))
        return float(np.sqrt(self._unforced.sample.mean(variance).mean()))

    def noise_ratio(self, setting: Setting) -> float | None:
        """From the steps between two frames, which have the same draws in both."""
        steps_e2 = []
        for trial, one in ((self, setting), (self._unforced, NOTHING)):
            execution = trial.execution(one)
            first, second = (trial.exposures.expose(execution, frame) for frame in range(2))
            steps_e2.append(float(trial.sample.mean(np.nan_to_num(second - first) ** 2).mean()))
        mine_e2, every_e2 = steps_e2
        return math.sqrt(mine_e2 / every_e2) if every_e2 > 1e-12 else None

    @cached_property
    def _unforced(self) -> SummedTrial:
        """The same with every effect."""
        return replace(self, forced_off=NONE) if self.forced_off else self

    # -- What may be left out -----------------------------------------------------------------

    def moves(self, free: Names) -> Sequence[Move]:
        """Effects that sums can have, one by one, and all that saturates at once."""
        free, every = free - self.absent - self.slow, everything()
        lit = every.names(LitLevel)
        moves = []
        for name in (e.name for e in registered() if e.name in free - self.saturation):
            names = frozenset({name})
            if name in every.names(SlowWords):
                # Nothing is left of black suns where words take no time.
                if not lit <= free | self.forced_off:
                    continue
                names |= lit & free
            moves.append(Move(names, self.saved_ns(name), name))
        # Noise that takes any pixel out of the registers' range does so in few: too rare to see.
        by_noise = (self.program.reach.least_e[:, self.program.lanes] <= 0).any()
        if self.saturation and self.saturation <= free and not by_noise:
            moves.append(Move(self.saturation, self._near_ns(NOTHING), None))
        return [move for move in moves if move.saved_ns > 0]

    @remembered
    def too_large(self, tolerance_e: float) -> Names:
        """Counts and noise of words, by their variance far from saturation."""
        if self.forced_off:
            return NONE
        program, lanes = self.program, self.program.lanes
        far = np.ones(lanes.size)
        far[self.near.places] = 0.0
        share, light_e = (
            np.bincount(lanes, values, len(program.container.encoding)) / lanes.size
            for values in (far, far * self.light.sum_e.reshape(-1))
        )
        square_e2 = {}
        for effect, part in self.wanted.errors():
            by_lane = (program.tables.noise(part.at, program.full)[0] ** 2).sum(axis=2)
            square_e2[effect.name] = share @ by_lane * part.sigma_e(self.sensor) ** 2
        seconds = program.uneven_seconds(program.full)[1]
        for name in self.wanted.names(CountedLight):
            square_e2[name] = seconds @ light_e / max(program.slot_s.sum(), 1e-300)
        return frozenset(name for name, e2 in square_e2.items() if e2.max() > tolerance_e**2)

    def settings(self, dropped: Names) -> Sequence[Setting]:
        """Pixels near saturation lack what is dropped as well and takes them time, or that but for
        neighbours' charge, or nothing."""
        every = everything()
        slow_words = every.names(SlowWords) | every.names(LitLevel)
        costly = every.names(Counted) | every.names(Exchange) | every.names(SmallErrors)
        lacking = (dropped & costly) - slow_words
        if not self.running or dropped >= self.saturation:
            return [Setting(dropped)]
        options = [lacking, lacking - every.names(Exchange), NONE]
        return [Setting(dropped, each) for each in dict.fromkeys(options)]

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        """Pixels that may saturate run through their words."""
        if not self.running or not self.execution(setting).kept.names(Saturates):
            return ()
        return (f"{self.running} pixels may saturate",)

    # -- Prices -------------------------------------------------------------------------------

    @cached_property
    def work(self) -> Work:
        """What a pixel does in the loop over words."""
        return Work.of(self.program)

    @property
    def passes(self) -> int:
        """How many frames of light are added up, over all buckets."""
        return len(self.light.frames) * len(self.program.container.buckets)

    @remembered
    def saved_ns(self, name: str) -> float:
        """Pixels near saturation included, whatever else is left out."""
        if name in self.absent:
            return 0.0
        if name in self.saturation:
            return self._near_ns(NOTHING) if len(self.saturation) == 1 else 0.0
        near_ns, names = 0.0, frozenset({name})
        if self.settings(names)[0].near:
            near_ns = self._near_ns(NOTHING) - self._near_ns(Setting(names, names))
        effect = next(each for each in registered() if each.name == name)
        return effect.summed_ns(self.passes) + max(near_ns, 0.0)

    @remembered
    def _near_ns(self, setting: Setting) -> float:
        """What pixels near saturation take, in nanoseconds of each pixel of the frame."""
        if not self.running:
            return 0.0
        execution = self.execution(setting)
        beside = counts_agree(execution)
        each_ns = self.work.words_ns(execution.near, "sums" if beside else "nothing")
        return each_ns * self.running / self.pixels

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        """By sums, and of pixels near saturation by words."""
        kept = self.execution(setting).kept
        near_ns = self._near_ns(setting) if kept.names(Saturates) else 0.0
        effects_ns = sum(
            each.summed_ns(self.passes) for each in kept.effects if each.name not in self.absent
        )
        light_ns = SHIPPED.light * self.passes
        return SHIPPED.summed + light_ns + effects_ns + near_ns, near_ns

    def planning_ms(self) -> float:
        """Words of the measured pixels, sums of the tiles without each effect."""
        near = near_sampled(self.running, self.pixels)
        measured = min(TILES + 4 * near, self.pixels)
        words_ns = self.work.words_ns(self._every, "nothing") * measured
        tiles = min(16 * TILES + 9 * near, self.pixels)
        summed_ns = (SHIPPED.tried + SHIPPED.tried_light * len(self.light.frames)) * tiles
        return SHIPPED.plan_ms + 1e-6 * (words_ns + summed_ns)
