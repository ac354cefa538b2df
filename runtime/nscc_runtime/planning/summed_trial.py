"""Trials of programs with fixed shutters on a sample of a scene: by weighted sums, with pixels near
saturation by words."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.caches import remembered
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
from nscc_runtime.execution.near_saturation import NearSaturation, near_saturation
from nscc_runtime.execution.program import AnalysedProgram
from nscc_runtime.execution.summed import APPROXIMATIONS
from nscc_runtime.light import Light
from nscc_runtime.planning.differences import Difference, ExposureErrors, WeightedPixels
from nscc_runtime.planning.planned_scene import NONE, NOTHING, Move, Names, Setting, Trial
from nscc_runtime.planning.prices import SHIPPED, Work
from nscc_runtime.planning.sample import TILES, Sample, near_sampled, sample_of
from nscc_runtime.planning.sampled_exposures import SampledExposures

Values = NDArray[np.float64]

_FRAMES = 4
"""Frames of pixels near saturation to expose if all saturating effects are dropped."""
_UNSEEN = 3.0
"""A set of pixels with this expected number of draws is missed by one sample in twenty."""


@dataclass(frozen=True, eq=False)
class SummedTrial(Trial):
    """The measurement of effects on a scene by weighted sums, for a program with fixed shutters."""

    program: AnalysedProgram
    light: Light
    device_seed: int
    threads: int

    approximations = APPROXIMATIONS

    @property
    def sensor(self) -> Sensor:
        return self.program.sensor

    @property
    def pixels(self) -> int:
        return self.program.array.lanes.size

    @cached_property
    def near_pixels(self) -> NearSaturation:
        """The pixels that are near saturation if every effect is simulated."""
        return near_saturation(self.program, self.light, self.device_seed, everything())

    @cached_property
    def running(self) -> int:
        """Number of pixels that run through their words, because they are near saturation."""
        requested_effects = self.requested_effects
        return len(
            near_saturation(self.program, self.light, self.device_seed, requested_effects).places
        )

    @cached_property
    def sample(self) -> Sample:
        total_e = (self.light.motion or self.light).sum_e
        dark = everything().require_part(CountedDark)  # it differs between pixels
        current = self.program.array.device(self.sensor, self.device_seed).fixed(dark.per_s)
        dark_e = (current * self.program.slot_s.sum()).reshape(total_e.shape)
        return sample_of(total_e + dark_e, self.near_pixels, self.sensor.full_well_e)

    @cached_property
    def exposures(self) -> SampledExposures:
        return SampledExposures(
            self.program, self.light, self.sample, self.device_seed, self.threads
        )

    @cached_property
    def saturation(self) -> Names:
        """Names of the requested effects that saturate."""
        return self.requested_effects.names(Saturates)

    @cached_property
    def absent(self) -> Names:
        names = {e.name for e in registered() if e.reference.keys() == {"compare"}}
        if self.light.motion is None:
            names |= everything().names(Moving)
        if not self.program.tables.decays:
            names |= {e.name for e in registered() if e.reference.keys() == {"digital"}}
        if not len(self.near_pixels.places):
            names |= everything().names(Saturates)
        return frozenset(names)

    @property
    def alike(self) -> bool:
        """Whether no pixel is near saturation. Then an effect that changes no sampled pixel changes
        none."""
        return not self.running

    @cached_property
    def _fast_effects(self) -> Selection:
        return everything().without(*self.slow)

    @cached_property
    def _requested_fast_effects(self) -> Selection:
        """The effects that sums and words support, without those that the user forced off."""
        return self.requested_effects.without(*self.slow)

    def executes(self, setting: Setting) -> Path:
        return self.execution(setting).path

    @remembered
    def execution(self, setting: Setting) -> Execution:
        """Return the execution that simulates frames of a setting."""
        kept_effects = self._requested_fast_effects.without(*setting.dropped)
        near_effects = self._requested_fast_effects.without(*setting.near_dropped)
        return Execution("sums", kept_effects, near_effects, self.requested_effects, setting.exact)

    @cached_property
    def _lacked_e(self) -> Values:
        """Change of exposures (buckets, pixels) in electrons by dropping the effects that only the
        reference supports."""
        if not self.slow - self.absent:
            return np.zeros(self._shape)
        by = self.exposures
        return by.by_reference(self._fast_effects) - by.by_reference(everything())

    # -- Measurements -------------------------------------------------------------------------

    def alone(self, effect: Effect, near_saturation: bool) -> ExposureErrors:
        """Return the error of dropping one effect: measured by sums far from saturation, and by
        words near saturation. Pixels near saturation are measured for effects that saturate, or on
        request."""
        by, name = self.exposures, effect.name
        if name in self.slow:
            return ExposureErrors.of(
                by.by_reference(everything().without(name)), by.by_reference(everything())
            )
        requested_effects = everything().without(*(self.forced_off - {name}))
        fast_effects = requested_effects.without(*self.slow)
        without = fast_effects.without(name)
        exposed, truth = np.zeros(self._shape), np.zeros(self._shape)
        if name not in self.saturation:
            exposed[:, self.sample.far_pixels] = by.by_sums(without, requested_effects, "far", 0)
            truth[:, self.sample.far_pixels] = by.by_sums(fast_effects, requested_effects, "far", 0)
            near_saturation = near_saturation and bool(
                self.settings(frozenset({name}))[0].near_dropped
            )
        if near_saturation or name in self.saturation:
            exposed[:, self.sample.near_pixels] = by.by_words(without, self.sample.near_pixels)
            truth[:, self.sample.near_pixels] = self._near_by_words(fast_effects)
        return ExposureErrors.of(exposed, truth)

    @remembered
    def _near_by_words(self, effects: Selection, frame: int = 0) -> Values:
        return self.exposures.by_words(effects, self.sample.near_pixels, frame)

    @property
    def _shape(self) -> tuple[int, int]:
        return len(self.program.container.buckets), len(self.sample.places)

    def approximated(self) -> Difference | None:
        """Return the error of sums relative to words with every effect, far from saturation."""
        one_per_tile, sample = self.sample.one_each, self.sample
        by_sums = self.exposures.by_sums(self._fast_effects, everything(), "far", 0)[
            :, one_per_tile
        ]
        truth = self.exposures.by_words(self._fast_effects, one_per_tile)
        pixels = WeightedPixels(
            sample.weight[one_per_tile], np.arange(len(one_per_tile)), sample.scene_pixels
        )
        far_fraction_root = math.sqrt(max(0.0, 1.0 - sample.near_part))
        return Difference(
            ExposureErrors.of(far_fraction_root * by_sums, far_fraction_root * truth), pixels
        )

    def forced(self) -> ExposureErrors:
        """Return the error of the effects that the user forced off; by the reference if only the
        reference supports one of them."""
        by, nothing = self.exposures, np.zeros(self._shape)
        if not self.forced_off:
            return ExposureErrors.of(nothing, nothing)
        if self.slow & self.forced_off:
            return ExposureErrors.of(
                by.by_reference(self.requested_effects), by.by_reference(everything())
            )
        return self.together(Setting(NONE, exact=True))

    def together(self, setting: Setting) -> ExposureErrors:
        """Return the error of a setting: relative to sums for pixels far from saturation, and
        relative to words for pixels near saturation.

        If all saturating effects are dropped, noise dominates the error; several frames are then
        exposed as additional outputs."""
        execution = self.execution(setting)
        by = self.exposures
        near_pixels = self.sample.near_pixels
        full_far_e = by.by_sums(self._fast_effects, everything(), "far", 0)
        exposed = [by.expose(execution, 0) + self._lacked_e]
        truth = [np.append(full_far_e, self._near_by_words(self._fast_effects), axis=1)]
        if execution.path == "sums" and setting.dropped >= self.saturation and self.running:
            for frame in range(1, _FRAMES):
                again_e = by.by_sums(
                    execution.kept_effects, execution.requested_effects, "near", frame
                )
                exposed.append(exposed[0].copy())
                exposed[-1][:, near_pixels] = again_e + self._lacked_e[:, near_pixels]
                truth.append(
                    np.append(full_far_e, self._near_by_words(self._fast_effects, frame), axis=1)
                )
        return ExposureErrors.of(np.concatenate(exposed), np.concatenate(truth))

    @remembered
    def square_e2(self, names: Names) -> float:
        """Return the mean square error of dropping all saturating effects, in square electrons."""
        exposed, truth = np.zeros(self._shape), np.zeros(self._shape)
        kept_effects = self._requested_fast_effects.without(*names)
        exposed[:, self.sample.near_pixels] = self.exposures.by_sums(
            kept_effects, self.requested_effects, "near", 0
        )
        truth[:, self.sample.near_pixels] = self._near_by_words(self._fast_effects)
        return Difference(ExposureErrors.of(exposed, truth), self.sample).likely_e2(0.0)

    def unseen_e2(self, setting: Setting) -> float:
        """Return an allowance for pixels near saturation that are too few to be drawn, in square
        electrons.

        Each of these pixels is assumed to lose as much as a pixel whose PIX is just full."""
        sample, lacking = self.sample, setting.near_dropped
        if not lacking or not sample.drawn_near:
            return 0.0
        kept_effects = self._requested_fast_effects.without(*self.saturation)
        lacking_e, complete_e = (
            self.exposures.by_sums(effects, self.requested_effects, "near", 0)
            for effects in (kept_effects.without(*lacking), kept_effects)
        )
        order = np.searchsorted(self.near_pixels.places, sample.places[sample.near_pixels])
        full_e = self.sensor.full_well_e
        just_full = full_e / np.maximum(self.near_pixels.most_e[order], full_e)
        weight = sample.weight[sample.near_pixels]
        weight = weight * just_full / weight.sum()
        square_e2 = (np.nan_to_num(lacking_e - complete_e) ** 2 * weight).sum(axis=1).max()
        # The noise of a reset cancels in a difference of two reads, unless one of them saturates.
        square_e2 += sum(
            error_part.sigma_e(self.sensor) ** 2
            for effect, error_part in everything().errors()
            if effect.name in lacking
        )
        return float(square_e2) * sample.near_part * min(1.0, _UNSEEN / sample.drawn_near)

    def noise_e(self) -> float:
        """Return the RMS standard deviation over two frames with every effect, in electrons."""
        full_execution = self._unforced.execution(NOTHING)
        exposures = [self._unforced.exposures.expose(full_execution, frame) for frame in range(2)]
        variance = np.nan_to_num(np.var(exposures, axis=0, ddof=1))
        return float(np.sqrt(self._unforced.sample.mean(variance).mean()))

    def noise_ratio(self, setting: Setting) -> float | None:
        """Return the noise of a setting divided by the noise with every effect, from the difference
        of two frames; None if there is no noise."""
        steps_e2 = []
        for trial, trial_setting in ((self, setting), (self._unforced, NOTHING)):
            execution = trial.execution(trial_setting)
            first, second = (trial.exposures.expose(execution, frame) for frame in range(2))
            steps_e2.append(float(trial.sample.mean(np.nan_to_num(second - first) ** 2).mean()))
        mine_e2, every_e2 = steps_e2
        return math.sqrt(mine_e2 / every_e2) if every_e2 > 1e-12 else None

    @cached_property
    def _unforced(self) -> SummedTrial:
        return replace(self, forced_off=NONE) if self.forced_off else self

    # -- Effects to drop ----------------------------------------------------------------------

    def moves(self, free: Names) -> Sequence[Move]:
        """Return a move for each effect that sums support, and one for all saturating effects."""
        free, all_effects = free - self.absent - self.slow, everything()
        lit = all_effects.names(LitLevel)
        moves = []
        for name in (e.name for e in registered() if e.name in free - self.saturation):
            names = frozenset({name})
            if name in all_effects.names(SlowWords):
                # Without dead time there are no black suns.
                if not lit <= free | self.forced_off:
                    continue
                names |= lit & free
            moves.append(Move(names, self.saved_ns(name), name))
        # Noise drives few pixels out of the registers' range, too few to be measured.
        by_noise = (self.program.reach.least_e[:, self.program.lanes] <= 0).any()
        if self.saturation and self.saturation <= free and not by_noise:
            moves.append(Move(self.saturation, self._near_ns(NOTHING), None))
        return [move for move in moves if move.saved_ns > 0]

    @remembered
    def too_large(self, tolerance_e: float) -> Names:
        """Return effects whose noise far from saturation certainly exceeds the tolerance."""
        if self.forced_off:
            return NONE
        program, lanes = self.program, self.program.lanes
        far = np.ones(lanes.size)
        far[self.near_pixels.places] = 0.0
        share, light_e = (
            np.bincount(lanes, values, len(program.container.encoding)) / lanes.size
            for values in (far, far * self.light.sum_e.reshape(-1))
        )
        square_e2 = {}
        for effect, error_part in self.requested_effects.errors():
            by_lane = (program.tables.noise(error_part.at, program.full)[0] ** 2).sum(axis=2)
            square_e2[effect.name] = share @ by_lane * error_part.sigma_e(self.sensor) ** 2
        seconds = program.uneven_seconds(program.full)[1]
        for name in self.requested_effects.names(CountedLight):
            square_e2[name] = seconds @ light_e / max(program.slot_s.sum(), 1e-300)
        return frozenset(name for name, e2 in square_e2.items() if e2.max() > tolerance_e**2)

    def settings(self, dropped: Names) -> Sequence[Setting]:
        """Return settings that drop these effects, cheapest first. Near saturation they drop those
        of `dropped` that cost time there, or these without crosstalk, or nothing."""
        all_effects = everything()
        costly = all_effects.names(Counted, Exchange, SmallErrors)
        lacking = (dropped & costly) - all_effects.names(SlowWords, LitLevel)
        if not self.running or dropped >= self.saturation:
            return [Setting(dropped)]
        options = [lacking, lacking - all_effects.names(Exchange), NONE]
        return [Setting(dropped, near_dropped) for near_dropped in dict.fromkeys(options)]

    def reasons(self, setting: Setting) -> tuple[str, ...]:
        if not self.running or not self.execution(setting).kept_effects.names(Saturates):
            return ()
        return (f"{self.running} pixels may saturate",)

    # -- Prices -------------------------------------------------------------------------------

    @cached_property
    def work(self) -> Work:
        return Work.of(self.program)

    @property
    def passes(self) -> int:
        """Number of sums of a pixel in a frame: frames of light times buckets."""
        return len(self.light.frames) * len(self.program.container.buckets)

    @remembered
    def saved_ns(self, name: str) -> float:
        """Return the nanoseconds per pixel, also near saturation, saved by dropping an effect."""
        if name in self.absent:
            return 0.0
        if name in self.saturation:
            return self._near_ns(NOTHING) if len(self.saturation) == 1 else 0.0
        near_ns, names = 0.0, frozenset({name})
        if self.settings(names)[0].near_dropped:
            near_ns = self._near_ns(NOTHING) - self._near_ns(Setting(names, names))
        effect = next(candidate for candidate in registered() if candidate.name == name)
        return effect.summed_ns(self.passes) + max(near_ns, 0.0)

    @remembered
    def _near_ns(self, setting: Setting) -> float:
        """Return the time of pixels near saturation, in nanoseconds per pixel of the frame."""
        if not self.running:
            return 0.0
        execution = self.execution(setting)
        beside = counts_agree(execution)
        each_ns = self.work.words_ns(execution.near_effects, "sums" if beside else "nothing")
        return each_ns * self.running / self.pixels

    def frame_ns(self, setting: Setting) -> tuple[float, float]:
        kept_effects = self.execution(setting).kept_effects
        near_ns = self._near_ns(setting) if kept_effects.names(Saturates) else 0.0
        effects_ns = sum(
            effect.summed_ns(self.passes)
            for effect in kept_effects.effects
            if effect.name not in self.absent
        )
        light_ns = SHIPPED.light * self.passes
        return SHIPPED.summed + light_ns + effects_ns + near_ns, near_ns

    def planning_ms(self) -> float:
        near_count = near_sampled(self.running, self.pixels)
        measured = min(TILES + 4 * near_count, self.pixels)
        words_ns = self.work.words_ns(self._fast_effects, "nothing") * measured
        tiles = min(16 * TILES + 9 * near_count, self.pixels)
        summed_ns = (SHIPPED.sampled + SHIPPED.sampled_light * len(self.light.frames)) * tiles
        return SHIPPED.plan_ms + 1e-6 * (words_ns + summed_ns)
