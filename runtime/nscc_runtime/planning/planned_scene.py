"""A program on a scene, and the exposures of sampled pixels with any set of effects."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from nscc.arrays import Floats, Ints32
from nscc.words.container import Container
from nscc_runtime.caches import remembered
from nscc_runtime.effects import Selection, everything, registered, selected
from nscc_runtime.effects.parts import FixedCodes, Saturates
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.execution.block_program import block_program, lacks
from nscc_runtime.execution.block_scene import expose_pixels, prepare_pixels
from nscc_runtime.execution.frames import frame_source, reference_reasons
from nscc_runtime.execution.near_saturation import NO_PIXELS, NearSaturation, near_saturation
from nscc_runtime.execution.program import analysed
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.looked_frames import Planes, block_exposer, frame_exposer, next_planes
from nscc_runtime.looked_frames import frames as looked_frames
from nscc_runtime.planning.sample import (
    Sample,
    SampledErrors,
    draw_sample,
    drawing_chances,
    sampled_errors,
)
from nscc_runtime.planning.tolerance import mean_signal_e
from nscc_runtime.pool import threads_of
from nscc_runtime.run_kinds import KINDS, refuse_planless

SAMPLED = 4000
"""Number of pixels on which a plan is measured."""
SEED = 0
"""Noise seed of measurements, whatever the seed of a run. With seed 0 a run draws the same numbers
for pixels near saturation as the trial."""
_ENOUGH, _MOST_REPEATS = 512, 16
"""Samples of fewer than `_ENOUGH` pixels are exposed several times, at most `_MOST_REPEATS`."""
_MOST_FRAMES, _SETTLED = 16, 0.005
"""The frames of a program with kept states are measured until at most the fraction `_SETTLED` of
the pixels begins a frame in a state in which it did not begin before."""


@dataclass(frozen=True, eq=False)
class PlannedScene:
    """A program on a scene and a chip, to be planned, exposed and audited. `device_seed`: seed of
    the chip's fixed patterns. Results do not depend on `threads` (None: all processors).

    Raises Rejected for programs to which plans do not apply (NS0750), for light of another size
    (NS0734), and if the words cannot be simulated or open no shutters (NS0442)."""

    container: Container
    sensor: Sensor
    light: Light
    device_seed: int = 0
    threads: int | None = None

    def __post_init__(self) -> None:
        """Check the program and the light, and analyse the program: its analyses are cached."""
        refuse_planless(self.container, "planning")
        check_size(self.container, self.light)
        if not self.looks:
            analysed(self.container, self.sensor)
        if not self.needs_reference(everything()):
            block_program(self.container, self.sensor, everything())

    @cached_property
    def looks(self) -> bool:
        """Whether pixels look at their light."""
        return not KINDS.of(self.container).open_times_known

    @property
    def pixels(self) -> int:
        """The number of pixels."""
        return math.prod(self.light.shape)

    def near_pixels(self, effects: Selection) -> NearSaturation:
        """Return the pixels that may saturate under `effects`; none for pixels that look, which all
        run through their words anyway. Raises Rejected (NS0442) for words that open no shutters."""
        if self.looks:
            return NO_PIXELS
        program = analysed(self.container, self.sensor)
        return near_saturation(program, self.light, self.device_seed, effects)

    def needs_reference(self, effects: Selection) -> tuple[str, ...]:
        """Return the reasons, each a text, why only the reference simulates `effects`; empty if the
        compiled simulations do."""
        if self.looks:
            return lacks(self.container, self.sensor, effects)
        return reference_reasons(effects)

    def frames(self, effects: Selection, seed: int, count: int) -> Iterable[Frame]:
        """Return an iterator over frames 0 to `count` - 1 with `effects` and the noise of `seed`,
        with converter codes. `count` is at least 1."""
        if self.looks:
            return looked_frames(
                self.container,
                self.light,
                self.sensor,
                effects,
                seed=seed,
                device_seed=self.device_seed,
                count=count,
                threads=self.threads,
            )
        source = frame_source(
            self.container, self.sensor, self.light, effects, self.device_seed, self.threads
        )
        return source.frames(seed, count)

    def signal_e(self) -> float:
        """Return the mean signal of a frame without effects, in electrons: the mean of absolute
        exposures, each limited to the full well; 0 if no exposure is a number."""
        [frame] = self.frames(selected("none"), 0, 1)
        return mean_signal_e(frame.exposure_e, self.sensor)

    def noise_e(self) -> float:
        """Return the noise of a frame with every effect, including readout and rounding, in
        electrons.

        The noise is the standard deviation over frames, as a root mean square over pixels and
        buckets, measured on a sample."""
        return trial_of(self).noise_e()


class SampledExposures(NamedTuple):
    """Exposures of sampled pixels.

    `exposure_e` (series, frames, buckets, pixels): electrons; `frames` are repeats of a frame of a
    series with other noise. `endings` (series, frames, 1, pixels): the states in which each pixel
    ended, as numbers (`_states`); a single 0 for all pixels without states."""

    exposure_e: Floats
    endings: Ints32


Expose = Callable[[Planes, int], tuple[Floats, Planes]]
"""A function of (loaded registers, frame number) that exposes the sampled pixels, and returns
exposures (buckets, pixels) in electrons and the registers at the end. Registers are bits (pixels,)
by name; there are none for fixed shutters."""


@dataclass(frozen=True, eq=False)
class Trial:
    """Exposes a sample of a scene's pixels with any set of effects. All sets use the same random
    numbers, so that two exposures differ only by what the effects cause.

    `begins`: the registers with which the pixels begin, one entry for each frame of a series.
    `repeats`: how often each entry of `begins` is exposed, each time with other noise.
    `expose_full`: the function that exposes the sample with all effects. `truth`: what it returned
    for all `begins` and `repeats`; the errors of other sets are measured from it."""

    scene: PlannedScene
    sample: Sample
    repeats: int
    begins: Sequence[Planes]
    expose_full: Expose
    truth: SampledExposures

    @remembered
    def exposed(self, effects: Selection) -> SampledExposures:
        """Return the exposures of the sampled pixels with `effects`, for all `begins` and
        `repeats`, with the random numbers of `truth`; remembered for each selection."""
        if effects.on == everything().on:
            return self.truth
        expose = _sampled(self.scene, self.sample, effects)
        return _exposures(self.scene, expose, self.begins, self.repeats)[0]

    def errors(self, effects: Selection, true: Selection) -> SampledErrors:
        """Return the differences of exposures with `effects` from those with the effects `true`."""
        return self._between(self.exposed(effects), self.exposed(true))

    def frames(self, count: int, first_number: int = 0) -> SampledExposures:
        """Return `count` frames of the sample with every effect, numbered from `first_number`,
        which selects their noise. All begin with the states that the program starts with."""
        return _exposures(self.scene, self.expose_full, self.begins[:1], count, first_number)[0]

    def noise_e(self) -> float:
        """Return the noise of a frame with every effect, including readout and rounding, in
        electrons: the standard deviation over frames, as a root mean square over the sample and the
        buckets."""
        # Frame numbers that `truth` does not use have independent noise.
        other = self.frames(self.repeats, len(self.begins) * self.repeats)
        first = SampledExposures(self.truth.exposure_e[:1], self.truth.endings[:1])
        # The difference of two independent frames has twice the variance of one.
        noise_e2 = float(self._between(other, first).mean_e2.mean()) / 2.0
        # The fixed pattern of the readout does not vary over frames.
        varying = (effect for effect in registered() if not effect.parts_of_kind(FixedCodes))
        sensor = self.scene.sensor
        readout_lsb = math.hypot(*(effect.code_error_lsb(sensor) or 0.0 for effect in varying))
        return math.hypot(math.sqrt(noise_e2), readout_lsb * sensor.electrons_per_lsb)

    @remembered
    def unseen_e2(self, effects: Selection) -> float:
        """Return an allowance for the mean square error of exposures with `effects`, in square
        electrons, for pixels near saturation of a kind that is too rare to be sampled.

        For example, nearly all pixels may be full, so that noise changes nothing, except a few.
        Each of these pixels is assumed to change as much as the sampled pixels would if nothing
        saturated and their light just filled PIX. PIX is the photodiode."""
        sample, full = self.sample, everything()
        saturating = full.names(Saturates)
        if not sample.unseen_share or effects.on | saturating >= full.on:
            return 0.0
        near, full_e = sample.near_only, self.scene.sensor.full_well_e
        kept_e, complete_e = (
            _sampled(self.scene, near, each.without(*saturating))({}, 0)[0]
            for each in (effects, full)
        )
        just_full = full_e / np.maximum(np.nan_to_num(np.abs(complete_e)), full_e)
        square_e2 = (np.nan_to_num(kept_e - complete_e) * just_full) ** 2
        return float((square_e2 @ near.weight).max() / near.weight.sum()) * sample.unseen_share

    def _between(self, exposed: SampledExposures, true: SampledExposures) -> SampledErrors:
        """Return the differences of the exposures `exposed` from the exposures `true`, both of this
        sample and of equal shape; pixels that ended in other states are not compared."""
        same = exposed.endings == true.endings
        return sampled_errors(exposed.exposure_e, true.exposure_e, same, self.sample.weight)


def trial_of(scene: PlannedScene, count: int = SAMPLED, repeats: int | None = None) -> Trial:
    """Draw about `count` pixels of `scene` (all of a smaller scene), expose them with every effect,
    and return the trial.

    `repeats`: number of frames with other noise; None for more than one for small samples, else
    one. For programs with kept states, further frames begin with the states that earlier ones left,
    until hardly any new states occur or there are `_MOST_FRAMES`."""
    full, sensor, frame_s = everything(), scene.sensor, float(scene.container.slot_s.sum())
    near = scene.near_pixels(full)
    chance = drawing_chances(scene.light, near, sensor, scene.device_seed, frame_s)
    sample = draw_sample(near, sensor.full_well_e, count, chance)
    repeats = repeats or min(-(-_ENOUGH // len(sample.places)), _MOST_REPEATS)
    container, expose = scene.container, _sampled(scene, sample, full)
    loaded = container.planes() if scene.looks else {}
    begins = [{name: bits.reshape(-1)[sample.places] for name, bits in loaded.items()}]
    truth, planes = _exposures(scene, expose, begins, repeats)
    keeps_states = container.keeps_states and not scene.needs_reference(full)
    while keeps_states and len(begins) < _MOST_FRAMES:
        following = next_planes(container, begins[0], planes)
        is_known = np.zeros(len(sample.places), np.bool_)
        for before in begins:
            is_known |= np.all([bits == before[name] for name, bits in following.items()], axis=0)
        if sample.weight[~is_known].sum() <= _SETTLED * sample.weight.sum():
            break
        begins.append(following)
        truth, planes = _exposures(scene, expose, begins, repeats)
    return Trial(scene, sample, repeats, begins, expose, truth)


def _sampled(scene: PlannedScene, sample: Sample, effects: Selection) -> Expose:
    """Return a function that exposes the pixels of `sample` with `effects`: by the loop over words
    or, if the loop lacks any effect at all, by the reference.

    All sets of effects of a scene are exposed in the same way, because the two have different
    random numbers."""
    container, sensor, light = scene.container, scene.sensor, scene.light
    places, threads, device_seed = sample.places, threads_of(scene.threads), scene.device_seed
    # The loop over words exposes the sample alone; the reference needs the whole scene.
    if scene.needs_reference(everything()):
        seeds, shown = (SEED, device_seed), places
        run = frame_exposer(container, light, sensor, effects, seeds, threads, by_words=True)
    else:
        block = prepare_pixels(
            container, sensor, light, effects, places, device_seed, threads, sample.known_means
        )
        if not scene.looks:
            return lambda _, number: (expose_pixels(block, SEED, number, threads).exposure_e, {})
        shown = np.arange(len(places))
        run = block_exposer(container, sensor, block, places.shape, SEED, threads)

    def expose(loaded: Planes, number: int) -> tuple[Floats, Planes]:
        """Expose a frame, and return the sampled pixels. A whole scene begins with the states that
        the program starts with."""
        executed = run(container.planes() if shown is places else loaded, number)
        exposure_e = executed.exposure.exposure_e
        planes = {name: bits.reshape(-1)[shown] for name, bits in executed.planes.items()}
        return exposure_e.reshape(len(exposure_e), -1)[:, shown], planes

    return expose


def _exposures(
    scene: PlannedScene,
    expose: Expose,
    begins: Sequence[Planes],
    repeats: int,
    first_number: int = 0,
) -> tuple[SampledExposures, Planes]:
    """Return `repeats` frames for each element of `begins`, at least one, and the registers at the
    end of the first frame of the last element.

    Frames are numbered from `first_number`, all repeats of an element one after the other."""
    frames = [
        [expose(begin, first_number + series * repeats + turn) for turn in range(repeats)]
        for series, begin in enumerate(begins)
    ]
    exposure_e = np.array([[frame_e for frame_e, _ in same] for same in frames])
    endings = np.array([[_states(scene, planes) for _, planes in same] for same in frames])
    endings = endings.reshape(len(frames), repeats, 1, -1)
    return SampledExposures(exposure_e, endings), frames[-1][0][1]


def _states(scene: PlannedScene, planes: Planes) -> Ints32:
    """Return the states in which pixels ended as numbers (pixels,): bit k is that of the k-th state
    register; a register that is missing is 0. A single 0 without any."""
    names = (name for each in scene.container.state_planes.values() for name in each.registers)
    bits = (planes[name].astype(np.int32) << k for k, name in enumerate(names) if name in planes)
    return np.asarray(sum(bits), np.int32)
