"""A program on a scene, and the exposures of sampled pixels with any set of effects."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection, everything, selected
from nscc_runtime.effects.parts import Saturates
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator import expose as expose_without_effects
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.execution.block_program import block_program, lacks
from nscc_runtime.execution.block_scene import expose_pixels, lay_out
from nscc_runtime.execution.near_saturation import NO_PIXELS, NearSaturation, near_saturation
from nscc_runtime.execution.program import analysed
from nscc_runtime.frame_file import Frame, check_adc
from nscc_runtime.light import Light
from nscc_runtime.looked_frames import frames as looked_frames
from nscc_runtime.planless import refuse_planless
from nscc_runtime.planning.sample import Sample, SampledErrors, draw_sample, drawing_chances
from nscc_runtime.planning.tolerance import mean_signal_e, with_readout_e
from nscc_runtime.pool import threads_of
from nscc_runtime.reference.capture import Reference, scene_of
from nscc_runtime.reference.trace import retention_us

Values = NDArray[np.float64]
Places = NDArray[np.int64]

SAMPLED = 4000
"""Number of pixels on which a plan is measured."""
SEED = 0
"""Noise seed of measurements, independent of the seed of a run."""
_ENOUGH, _MOST_REPEATS = 512, 16
"""Samples of fewer than `_ENOUGH` pixels are exposed several times, at most `_MOST_REPEATS`."""
_MOST_FRAMES, _SETTLED = 16, 0.005
"""The frames of a program with kept states are measured until at most the fraction `_SETTLED` of
the pixels begins a frame in a state in which it did not begin before."""


@dataclass(frozen=True, eq=False)
class PlannedScene:
    """A program on a scene and a chip, to be planned, exposed and audited. Results do not depend on
    `threads` (None: all processors)."""

    container: Container
    sensor: Sensor
    light: Light
    device_seed: int = 0
    threads: int | None = None

    @property
    def looks(self) -> bool:
        """Whether pixels look at their light."""
        return self.container.machine is not None

    @property
    def pixels(self) -> int:
        return self.light.shape[0] * self.light.shape[1]

    def ready(self) -> None:
        """Analyse the program. Raises Rejected if it cannot be simulated."""
        if not self.needs_reference(everything()):
            block_program(self.container, retention_us(everything(), self.sensor))

    def near_pixels(self, effects: Selection) -> NearSaturation:
        """Return the pixels that may saturate; none for pixels that look, which all run through
        their words."""
        if self.looks:
            return NO_PIXELS
        program = analysed(self.container, self.sensor)
        return near_saturation(program, self.light, self.device_seed, effects)

    def needs_reference(self, effects: Selection) -> tuple[str, ...]:
        """Return the reasons why only the reference simulates these effects; empty if the compiled
        simulations do."""
        return lacks(self.container, self.sensor, effects)

    def frames(self, effects: Selection, seed: int, count: int) -> Iterable[Frame]:
        """Return frames 0 to `count` - 1 with these effects, with converter codes."""
        if self.looks:
            return looked_frames(
                self.container, self.light, self.sensor, effects, seed=seed,
                device_seed=self.device_seed, count=count, threads=self.threads,
            )  # fmt: skip
        from nscc_runtime.execution.frames import frame_source

        check_adc(self.container.target)
        source = frame_source(
            self.container, self.sensor, self.light, effects, self.device_seed,
            threads_of(self.threads),
        )  # fmt: skip
        return (source.frame(seed, number) for number in range(count))

    def signal_e(self) -> float:
        """Return the mean signal of a frame without effects, in electrons (see `mean_signal_e`)."""
        if self.looks:
            [frame] = self.frames(selected("none"), 0, 1)
            return mean_signal_e(frame.exposure_e, self.sensor)
        exact = expose_without_effects(self.container, self.light, threads=self.threads)
        return mean_signal_e(exact.exposure_e, self.sensor)

    def noise_e(self) -> float:
        """Return the noise of a frame with every effect, including readout and rounding, in
        electrons.

        The noise is the standard deviation over frames, as a root mean square over pixels and
        buckets, measured on a sample."""
        return trial_of(self).noise_e()


def planning_of(
    container: Container, sensor: Sensor, light: Light, device_seed: int = 0,
    threads: int | None = None,
) -> PlannedScene:  # fmt: skip
    """Return a program on a scene, to be planned. Raises Rejected for programs to which plans do
    not apply (NS0750), and for light of another size."""
    refuse_planless(container, "planning")
    check_size(container, light)
    return PlannedScene(container, sensor, light, device_seed, threads)


@dataclass(frozen=True, eq=False)
class SampledExposures:
    """Exposures of sampled pixels. `exposure_e` (outputs, frames, pixels) in electrons, see
    `SampledErrors`. `endings`, of the same shape: the state in which each pixel ended."""

    exposure_e: Values
    endings: NDArray[np.int32]


@dataclass(frozen=True, eq=False)
class Trial:
    """Exposures of a sample of a scene with any set of effects, with equal random numbers.

    `begins`: the first segments of the pixels in consecutive frames, for kept states; None for the
    states that the program starts with. `repeats`: number of frames with other noise for each of
    these. `truth`: the exposures with every effect."""

    scene: PlannedScene
    sample: Sample
    repeats: int
    begins: tuple[Places | None, ...]
    truth: SampledExposures

    def errors(self, effects: Selection, than: SampledExposures | None = None) -> SampledErrors:
        """Return the errors of exposures with `effects` relative to `than`, by default relative to
        the exposures with every effect."""
        return self.between(self.exposures(effects), than or self.truth)

    def between(self, exposed: SampledExposures, true: SampledExposures) -> SampledErrors:
        """Return the differences between two exposures of the sample."""
        return SampledErrors.between(
            exposed.exposure_e, true.exposure_e, exposed.endings == true.endings, self.sample.weight
        )

    def signal_e(self) -> float:
        """Return the mean signal of the scene (see `PlannedScene.signal_e`)."""
        return self.scene.signal_e()

    def noise_e(self) -> float:
        """Return the noise of a frame of the scene (see `PlannedScene.noise_e`)."""
        buckets, number = len(self.scene.container.buckets), len(self.begins) * self.repeats
        first = SampledExposures(self.truth.exposure_e[:buckets], self.truth.endings[:buckets])
        second = self.frames(everything(), self.repeats, number)
        mean_e2 = self.between(second, first).mean_square_e2 / 2.0
        return with_readout_e(math.sqrt(float(mean_e2.mean())), self.scene.sensor)

    def frames(self, effects: Selection, count: int, first_number: int = 0) -> SampledExposures:
        """Return consecutive frames of the sampled pixels, which all begin with the states that the
        program starts with."""
        return _exposures(self.scene, self.sample, effects, [None], count, first_number)

    def exposures(self, effects: Selection) -> SampledExposures:
        """Return the exposures of the sampled pixels with these effects."""
        return _exposures(self.scene, self.sample, effects, self.begins, self.repeats)


def trial_of(
    scene: PlannedScene, count: int = SAMPLED, repeats: int | None = None, *, even: bool = False
) -> Trial:
    """Draw about `count` pixels of a scene, and expose them with every effect.

    `repeats`: number of frames with other noise; by default more than one for small scenes. `even`:
    draw all pixels with equal probabilities, which is faster."""
    full_well_e, all_effects = scene.sensor.full_well_e, everything()
    chance = np.ones(scene.pixels) if even else drawing_chances(scene.light, full_well_e)
    sample = draw_sample(scene.near_pixels(all_effects), full_well_e, count, chance)
    repeats = repeats or min(-(-_ENOUGH // len(sample.places)), _MOST_REPEATS)
    first = _exposures(scene, sample, all_effects, [None], repeats)
    trial = Trial(scene, sample, repeats, (None,), first)
    if not scene.container.keeps_states or scene.needs_reference(all_effects):
        return trial
    begins: list[Places | None] = [None]
    while len(begins) < _MOST_FRAMES:
        following = -1 - trial.truth.endings[-1, 0].astype(np.int64)
        known = [following == before for before in begins[1:] if before is not None]
        new_weight = sample.weight[~np.any(known, axis=0)] if known else sample.weight
        if new_weight.sum() <= _SETTLED * sample.weight.sum():
            break
        begins.append(following)
        truth = _exposures(scene, sample, all_effects, begins, repeats)
        trial = replace(trial, begins=tuple(begins), truth=truth)
    return trial


def _exposures(
    scene: PlannedScene, sample: Sample, effects: Selection, begins: Sequence[Places | None],
    repeats: int, first_number: int = 0,
) -> SampledExposures:  # fmt: skip
    """Expose the sampled pixels in `repeats` frames for each element of `begins`; frames are
    numbered from `first_number`."""
    threads = threads_of(scene.threads)
    numbers = range(first_number, first_number + len(begins) * repeats)
    # One trial uses one simulation for all sets of effects: their random numbers are not the same.
    if scene.needs_reference(everything()):
        exposed = [_by_reference(scene, effects, number) for number in numbers]
        exposed = [(values[:, sample.places], ends[sample.places]) for values, ends in exposed]
    else:
        laid = lay_out(
            scene.container, scene.sensor, scene.light, effects, sample.places, scene.device_seed,
            threads,
        )  # fmt: skip
        results = (
            expose_pixels(laid, SEED, number, threads, begins[(number - first_number) // repeats])
            for number in numbers
        )
        exposed = [(result.exposure_e, result.endings) for result in results]
    buckets = len(scene.container.buckets)
    shape = len(begins), repeats, buckets, len(sample.places)
    exposure_e = np.array([values for values, _ in exposed]).reshape(shape).swapaxes(1, 2)
    endings = np.array([ends for _, ends in exposed]).reshape(len(begins), 1, repeats, -1)
    whole = len(begins) * buckets, repeats, -1
    return SampledExposures(
        exposure_e.reshape(whole), np.broadcast_to(endings, exposure_e.shape).reshape(whole)
    )


def _by_reference(
    scene: PlannedScene, effects: Selection, number: int
) -> tuple[Values, NDArray[np.int32]]:
    """Return the exposures (buckets, pixels) and endings (pixels,) of all pixels of a scene by the
    reference."""
    light = scene_of(scene.container, scene.light)
    reference = Reference.of(scene.container, scene.sensor, effects)
    seeds, loaded = (SEED, scene.device_seed), scene.container.planes()
    executed = reference.execute(light, loaded, seeds, number, threads=threads_of(scene.threads))
    endings = np.zeros(scene.pixels, np.int32)
    for bit, name in enumerate(sorted(executed.planes)):
        endings += executed.planes[name].reshape(-1).astype(np.int32) << bit
    exposure_e = executed.exposure.exposure_e
    return exposure_e.reshape(len(exposure_e), -1), endings


def unseen_square_e2(trial: Trial, effects: Selection) -> float:
    """Return an allowance for the mean square error of dropping effects, in square electrons, for
    pixels near saturation of a kind that is too rare to be sampled.

    For example, nearly all pixels may be full, so that noise changes nothing, except a few. Each of
    these pixels is assumed to change as much as the sampled pixels would if nothing saturated and
    their light just filled PIX."""
    sample, all_effects = trial.sample, everything()
    saturating = all_effects.names(Saturates)
    if not sample.unseen_share or effects.on >= all_effects.on - saturating:
        return 0.0
    near = replace(
        trial,
        sample=replace(
            sample, places=sample.places[sample.near], weight=sample.weight[sample.near],
            near=sample.near[sample.near],
        ),
        begins=(None,),
        repeats=1,
    )  # fmt: skip
    kept, complete = (
        near.exposures(selection.without(*saturating)).exposure_e
        for selection in (effects, all_effects)
    )
    full_e = trial.scene.sensor.full_well_e
    just_full = full_e / np.maximum(np.nan_to_num(np.abs(complete)), full_e)
    square_e2 = (np.nan_to_num(kept - complete) * just_full) ** 2
    weight = near.sample.weight / near.sample.weight.sum()
    return float((square_e2.mean(axis=1) * weight).sum(axis=-1).max()) * sample.unseen_share
