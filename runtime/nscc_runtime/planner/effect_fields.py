"""What each effect does to the exposures of a sample of pixels: the matter of predictions.

Every effect says so by its field (`nscc_runtime.effects.field`). Where pixels may saturate, what
the words make of them is found by running them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc_runtime.effects import (
    AfterExposure,
    ByWords,
    Effect,
    Field,
    Selection,
    everything,
    registered,
)
from nscc_runtime.effects.parts import Counted, Exchange, Leak, Soft, Well, WordGain
from nscc_runtime.light import Light
from nscc_runtime.planner.chip import Chip, all_by_words, whole_chip
from nscc_runtime.planner.pixels import Running
from nscc_runtime.planner.program import Program
from nscc_runtime.planner.rarely import beyond_registers, beyond_well
from nscc_runtime.planner.reweighed import Reweighed
from nscc_runtime.planner.sample import Sample, among
from nscc_runtime.planner.sampled import SampledScene
from nscc_runtime.remembered import remembered

Values = NDArray[np.float64]
Held = dict[tuple[str, ...], Values]
"""Exposures (buckets, pixels near saturation) by the effects that they lack."""

FORCED = "forced off"
"""What all that is forced off does where pixels run through their words: random parts included."""
BOTH = "saturation"
"""What saturation of PIX and of registers do together."""
_SURELY = 1.5
"""Times the tolerance: noise takes less than the rest from what saturation loses."""
TRIED = 2.2
"""Runs of a sample through its words that show what saturation loses."""
_CLIPPED_E = 1.0


@dataclass(frozen=True, eq=False)
class Fields:
    """Predictions for a sample; arrays are (buckets, pixels of the sample).

    `fixed` and `variance` by effect; `noise`: by how much each makes the variance over frames
    larger; `shifts`: the electrons by which an effect changes the counts; `count_e`: what one count
    makes of an exposure, as its third moment shows it;
    `expected`: the exposure with every effect; `thinning[closed]`: the variance that sums leave out
    because counts are not spread over the slots, with closed slots counted or not;
    `neighbours[closed]`: the same of crosstalk; `levels` (pixels,): the variance of what neighbours
    count before shutters open, which levels take away again but where PIX is full; `noise_cut`:
    that the noise of words is drawn as at the mean leakage. All but what saturation loses is as if
    nothing saturated; `clipped`: where the full well is passed; `after`: the fields there of
    effects that act on what the well lets through (0 where only their noise does); `unfilled`: at
    most the part of the light there whose reads are not full, as of a frame with many reads, 1
    elsewhere.
    """

    sample: Sample
    expected: Values
    fixed: dict[str, Values]
    variance: dict[str, Values]
    noise: dict[str, Values]
    shifts: dict[str, Values]
    count_e: Values
    thinning: dict[bool, Values]
    neighbours: dict[bool, Values]
    levels: Values
    noise_cut: Values
    clipped: NDArray[np.bool_]
    after: dict[str, Values]
    unfilled: Values
    spilt: NDArray[np.bool_]
    """Which pixels of the sample neighbours' light brings near saturation."""
    rarely_e: Mapping[str, float]
    """By effect, what noise alone takes of one pixel in one frame of some."""

    def skewed(self, random: Mapping[str, Values]) -> dict[str, Values]:
        """Of these variances the third moments: of counts, which are of few electrons in the
        dark."""
        names = everything().names(Counted) & random.keys()
        return {name: random[name] * self.count_e for name in names}

    @cached_property
    def noise_left(self) -> dict[str, Values]:
        """Of `noise` what the full well leaves."""
        return {
            name: each if name in self.after else np.where(self.clipped, 0.0, each)
            for name, each in self.noise.items()
        }

    @cached_property
    def noise_e2(self) -> float:
        """The variance of exposures over frames with every effect, mean over pixels and buckets;
        what is no number has none."""
        left = np.array([*self.noise_left.values()])
        return float(self.sample.mean(np.where(np.isfinite(left), left, 0.0)).sum(axis=0).mean())


@dataclass(frozen=True, eq=False)
class SampledFields:
    """The fields of a scene on a sample, each effect against all others. `forced_off` are effects
    that pixels near saturation lack as well, `unlimited` those of them that saturate; `spilt` the
    places of those of them that neighbours' light brings there. Threads change no bit.
    """

    program: Program
    light: Light
    sample: Sample
    spilt: NDArray[np.int64]
    device_seed: int
    forced_off: frozenset[str] = frozenset()
    unlimited: frozenset[str] = frozenset()
    threads: int = 1

    @cached_property
    def rough(self) -> Fields:
        """With what saturation loses of light without noise: counting light takes longest."""
        if not self.sample.near.any():
            return self._far
        return self._near.added(self._far, self._found, self._near.without_noise)

    def for_tolerance(self, tolerance_e: float) -> Fields:
        """The same, with what saturation loses of all that is random, unless that is so far above
        the tolerance that no noise decides on it."""
        if not self.noisy(tolerance_e):
            return self.rough
        near = self._near
        found = near.added(self._far, self._found, near.with_noise)
        return near.forced(found, self.unlimited) if self.forced_off else found

    @remembered
    def noisy(self, tolerance_e: float) -> bool:
        """Whether noise decides on what saturation loses."""
        if not self.sample.near.any():
            return False
        return bool(self.forced_off) or not self._near.surely_kept(tolerance_e)

    @cached_property
    def _scene(self) -> SampledScene:
        return SampledScene(self.program, self.light, self.sample, self.device_seed)

    @cached_property
    def louder(self) -> Mapping[str, float]:
        """By what factor the variance of counts is larger without an effect that weighs charge."""
        scene, found = self._scene, {}
        for name in scene.all.names(WordGain) | scene.all.names(Leak):
            kept, free = (
                float(self.sample.mean(np.abs(each)).mean())
                for each in (scene.charge, scene.without(name))
            )
            found[name] = (free / kept) ** 2 if 0 < kept < np.inf else 1.0
        return found

    @cached_property
    def reweighed(self) -> Reweighed:
        """What becomes of errors where what weighs them is off."""
        return Reweighed.of(self._scene)

    @cached_property
    def _near(self) -> _Near:
        return _Near(self._scene, self._far.spilt, self.forced_off, self.threads)

    @cached_property
    def _found(self) -> Mapping[str, Field]:
        return {effect.name: _field(effect, self._scene) for effect in registered()}

    @cached_property
    def _far(self) -> Fields:
        """As if nothing saturated."""
        scene, found = self._scene, self._found
        expected = scene.charge + scene.pattern
        noise_cut = np.zeros(expected.shape)
        for _, part in scene.all.errors():
            noise_cut += scene.errors_cut(part.at, part.sigma_e(self.program.sensor))
        thinning, neighbours = scene.left_out()
        return Fields(
            self.sample,
            expected,
            {name: each.fixed for name, each in found.items() if each.fixed is not None},
            {name: each.variance for name, each in found.items() if each.variance is not None},
            {name: each.noise for name, each in found.items() if each.noise is not None},
            {name: each.shift for name, each in found.items() if each.shift is not None},
            scene.count_e,
            thinning,
            neighbours,
            scene.levels,
            noise_cut,
            np.zeros(expected.shape, np.bool_),
            {},
            np.ones(expected.shape),
            among(self.sample.places, self.spilt, len(self.program.lanes)),
            {},
        )


def _field(effect: Effect, scene: SampledScene) -> Field:
    """What an effect does on the sample, all of it (buckets, pixels); ValueError for what has
    another shape.
    """
    if isinstance(effect.field, ByWords | AfterExposure):
        return Field()
    found, shape = effect.field(scene), (len(scene.buckets), len(scene.places))

    def whole(values: Values | float | None) -> Values | None:
        if values is None or (isinstance(values, np.ndarray) and values.shape == shape):
            return values
        return np.broadcast_to(np.asarray(values, np.float64), shape)

    try:
        noise = found.variance if found.noise is None else found.noise
        parts = (found.fixed, found.variance, found.shift, found.behind_well, noise)
        return Field(*(whole(values) for values in parts))
    except ValueError as error:
        raise ValueError(f"the field of the effect {effect.name!a}: {error}") from None


@dataclass(frozen=True, eq=False)
class _Near:
    """The pixels of a sample that may saturate, run through their words."""

    scene: SampledScene
    spilt: NDArray[np.bool_]
    forced_off: frozenset[str]
    threads: int

    @cached_property
    def _every(self) -> Selection:
        """All that the loop over words can have."""
        return all_by_words()

    @cached_property
    def _saturation(self) -> tuple[str, str]:
        (well,), (register,) = self._every.names(Well), self._every.names(Soft)
        return well, register

    def _by_selection(self, kept: Selection) -> Held:
        """What the words make of these pixels with all of `kept`, without what saturates first,
        last, and both; neighbours' charge where it brings some of them there, as it is dear.
        """
        well, register = self._saturation
        spilt = self.spilt[self.scene.sample.near]
        shape = len(self.scene.buckets), len(spilt)
        lacks: list[tuple[str, ...]] = [(), (well,), (register,), (well, register)]
        found: Held = {names: np.empty(shape) for names in lacks}
        alone = kept.without(*self._every.names(Exchange))
        for some, effects in ((spilt, kept), (~spilt, alone)):
            if some.any():
                ways = [self._chip.wired(effects.without(*names)) for names in lacks]
                held = self._running(effects, some).expose_in_ways(0, 0, ways)
                for names, here in zip(lacks, held, strict=True):
                    found[names][:, some] = here
        return found

    @cached_property
    def with_noise(self) -> Held:
        """Of light that is counted, and with all that is random."""
        return self._by_selection(self._every)

    @cached_property
    def without_noise(self) -> Held:
        """Of the mean light. Words keep their errors, whose noise is no effect of its own: it goes
        with what words do to charge."""
        return self._by_selection(self._every.without(*self._every.names(Counted)))

    def surely_kept(self, tolerance_e: float) -> bool:
        """Whether what saturates has to be kept whatever noise does. The well alone is never left
        out, as that saves nothing.
        """
        held, (_, register) = self.without_noise, self._saturation
        return all(
            self._rms(held[()] - held[names]) > _SURELY * tolerance_e
            for names in ((register,), self._saturation)
        )

    def _rms(self, lost: Values) -> float:
        """The root mean square of losses (buckets, pixels) here over the whole array."""
        weight = self.scene.sample.weight
        part = weight[self.scene.sample.near] / weight.sum()
        return math.sqrt(float(np.max(lost**2 @ part)))

    def added(self, fields: Fields, found: Mapping[str, Field], held: Held) -> Fields:
        """The fields with what the words make of these pixels."""
        near, (well, register) = self.scene.sample.near, self._saturation
        fixed, blank = dict(fields.fixed), np.zeros_like(fields.expected)
        for name, without in ((well, (well,)), (register, (register,)), (BOTH, (well, register))):
            fixed[name] = blank.copy()
            fixed[name][:, near] = held[()] - held[without]
        # What noise alone takes there: which way is not known, and it must not make up for others.
        told = {name: fixed[name][:, near] ** 2 for name in (well, register)}
        # Behind registers that are out of their range nothing is seen of a well.
        linear = np.asarray((told[register] <= _CLIPPED_E**2).all(axis=0))
        rarely = {
            well: beyond_well(self.scene, linear).but_for(told[well]),
            register: beyond_registers(self.scene, held[(register,)]),
        }
        variance = {**fields.variance, well: blank.copy(), register: blank.copy()}
        variance[well][:, near] = rarely[well].square_e2
        rare_e2 = rarely[register].square_e2
        variance[register][:, near] = np.where(told[register] < rare_e2, rare_e2, 0.0)
        expected = fields.expected.copy()
        expected[:, near] = held[()]
        clipped = np.zeros(expected.shape, np.bool_)
        clipped[:, near] = np.abs(held[(register,)] - held[(well, register)]) > _CLIPPED_E
        # Of the charge that effects after the well act on, the part that it lets through.
        pattern, passed = self.scene.pattern, np.ones_like(expected)
        free = np.maximum((fields.expected - pattern)[:, near], 1.0)
        passed[:, near] = (held[(register,)] - pattern[:, near]) / free
        after: dict[str, Values] = {}
        for name, each in found.items():
            if each.behind_well is not None:
                rest = 0.0 if each.fixed is None else (each.fixed - each.behind_well) * passed
                after[name] = np.asarray(each.behind_well + rest)
        program = self.scene.program
        full_e = self._chip.full_e * program.tables.least_read(program.full).T[:, self.scene.lanes]
        rest = np.clip(passed - full_e / np.maximum(fields.expected - pattern, 1.0), 0.0, 1.0)
        unfilled = np.where(clipped, rest, 1.0)
        return replace(
            fields, expected=expected, fixed=fixed, variance=variance, clipped=clipped,
            after=after, unfilled=unfilled,
            rarely_e={name: each.most_e for name, each in rarely.items()},
        )  # fmt: skip

    def forced(self, fields: Fields, unlimited: frozenset[str]) -> Fields:
        """The fields with what these pixels lack because it is forced off, beside what they lack of
        what saturates, where some of that is, too."""
        kept = self._every, self._every.without(*self.forced_off, *unlimited)
        lost = np.zeros_like(fields.expected)
        near = self.scene.sample.near
        every, without = (self._running(each).expose(0, 0)[0] for each in kept)
        lost[:, near] = every - without
        if unlimited:
            [name] = unlimited if len(unlimited) == 1 else [BOTH]
            lost -= fields.fixed[name]
        return replace(fields, fixed={**fields.fixed, FORCED: lost})

    def _running(self, kept: Selection, some: NDArray[np.bool_] | None = None) -> Running:
        """The sample's pixels that may saturate, or some of them, to be run through their words:
        noise alone may take them there."""
        places = self.scene.places[self.scene.sample.near]
        if some is not None:
            places = places[some]
        return Running(self._chip.wired(kept), self.scene.scene, places, self.threads)

    @cached_property
    def _chip(self) -> Chip:
        """The chip with every effect."""
        return whole_chip(self.scene.program, self.scene.device.device_seed)
