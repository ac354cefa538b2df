"""Frames of a scene: sums for most pixels, words for pixels near saturation, or the reference.

    source = frame_source(container, sensor, light, effects, device_seed, threads)
    frames = source.frames(seed, count)

An exposure without saturation is a weighted sum, so it is drawn from the moments of the scene
(`nscc_runtime.execution.moments`). Pixels that may saturate, and with strong crosstalk all pixels,
run through their words instead (`nscc_runtime.execution.block_scene`). Frames agree with the
reference in mean, variance and covariance; the random numbers are others."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from nscc.arrays import Floats, Ints
from nscc.words.container import Container
from nscc_runtime.effects import CannotHave, Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.execution.block_scene import (
    BlockScene,
    PixelExposures,
    expose_pixels,
    prepare_pixels,
    without_draws,
)
from nscc_runtime.execution.moments import Moments, exchanges_much, on_chip, scene_moments
from nscc_runtime.execution.near_saturation import NO_PIXELS, near_saturation
from nscc_runtime.execution.overlap import MOST_EXCHANGED
from nscc_runtime.execution.program import analysed
from nscc_runtime.execution.summed import draw_exposures
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.frame_file import Frame, check_adc, converted
from nscc_runtime.light import Light
from nscc_runtime.pool import threads_of
from nscc_runtime.reference.capture import Reference, reference_scene


@dataclass(frozen=True, eq=False)
class FrameSource:
    """A program and a light on one chip, ready to be exposed frame by frame.

    Attributes
    ----------
    container, sensor, light, effects
        The program, the sensor, the light of the array, and the effects that are simulated.
    device_seed, threads : int
        Seed of the fixed patterns. Number of threads, on which results do not depend.
    simulator : Moments or Reference
        The sums of the light, or the reference, which exposes all pixels word by word.
    near : int64, shape (pixels,)
        Places of the pixels that run through their words because they may saturate or leak unlike
        most; all places with strong crosstalk.
    block : BlockScene or None
        These pixels, prepared; None without any.
    """

    container: Container
    sensor: Sensor
    light: Light
    effects: Selection
    device_seed: int
    threads: int
    simulator: Moments | Reference
    near: Ints
    block: BlockScene | None = None

    def expose(self, seed: int, number: int) -> Exposure:
        """Return frame `number` before the converter, with the noise of `seed`.

        It is computed by the reference, or all pixels by sums. Pixels near saturation then run
        through their words, whose results replace their sums; if all do, there are no sums. Values
        that are not finite are invalid, and so are pixels whose light is NaN."""
        if isinstance(self.simulator, Reference):
            scene = reference_scene(self.container, self.light)
            return self.simulator.expose(scene, seed, self.device_seed, number, self.threads)
        exposure_e: Floats = np.empty(self.simulator.mean_e.shape)
        if len(self.near) < exposure_e.shape[1]:
            exposure_e = draw_exposures(self.simulator, seed, number, self.threads)
        saturated_by = np.zeros(exposure_e.shape, np.uint8)
        if self.block is not None:
            endings = np.empty(exposure_e.shape[1], np.int32)
            every = PixelExposures(exposure_e, saturated_by, endings)
            expose_pixels(self.block, seed, number, self.threads, whole=every)
        whole = exposure_e.reshape(-1, *self.light.shape)
        if not self.light.most_e >= 0.0:  # NaN
            whole[:, self.light.is_nan] = np.nan
        return Exposure(whole, np.isfinite(whole), saturated_by.reshape(whole.shape))

    def without_draws(self) -> FrameSource:
        """Return this source with frames that draw no random numbers: expected exposures, except
        where noise saturates. The reference draws them all the same."""
        moments = self.simulator
        if isinstance(moments, Moments):
            none_e, no_counts = 0.0 * moments.error_e, 0.0 * moments.count_means
            moments = replace(moments, count_means=no_counts, error_e=none_e)
        return replace(self, simulator=moments, block=self.block and without_draws(self.block))

    def frames(self, seed: int, count: int) -> Iterator[Frame]:
        """Yield frames 0 to `count` - 1, with converter codes and the noise of `seed`. Raises
        ValueError at the first frame if `count` < 1."""
        if count < 1:
            raise ValueError(f"{count} frames")
        target, seeds = self.container.target, (seed, self.device_seed)
        for number in range(count):
            exposure = self.expose(seed, number)
            yield converted(exposure, target, self.sensor, self.effects, seeds, number)


@lru_cache(64)
def reference_reasons(effects: Selection) -> tuple[str, ...]:
    """Return a reason, with its name, for each of those `effects` that only the reference simulates
    for fixed shutters: neither sums of light nor the loop over words have them. Empty if the
    reference is not needed."""
    # Programs with fixed shutters compare nothing, so effects of comparators do not act.
    return tuple(
        f"{effect.name}: only the reference has it"
        for effect in effects.effects
        if isinstance(effect.words, CannotHave)
        or (isinstance(effect.sums, CannotHave) and not {"compare"} >= effect.reference.keys())
    )


def word_reasons(
    container: Container,
    sensor: Sensor,
    lights: Sequence[Light],
    effects: Selection,
    device_seed: int,
) -> tuple[str, ...]:
    """Return why `frame_source` runs pixels through their words in frames of `lights`: effects that
    only the reference has, else strong crosstalk, else the largest number of pixels near saturation
    in a frame, and the number of pixels that leak unlike most. Empty if sums suffice for all
    pixels."""
    reasons = reference_reasons(effects)
    if reasons:
        return reasons
    program = analysed(container, sensor)
    if exchanges_much(effects, program):
        return (f"crosstalk is above {MOST_EXCHANGED:.0%}",)
    near = max(len(near_saturation(program, x, device_seed, effects).places) for x in lights)
    uneven = len(on_chip(program, effects, device_seed).uneven)
    reasons = (f"{near} pixels may saturate",) if near else ()
    return (*reasons, f"the leakage of {uneven} pixels is far from the mean") if uneven else reasons


def frame_source(
    container: Container,
    sensor: Sensor,
    light: Light,
    effects: Selection,
    device_seed: int = 0,
    threads: int | None = None,
    by_words: bool = False,
) -> FrameSource:
    """Prepare a scene with fixed shutters for exposing frames.

    Parameters
    ----------
    container : Container
        A program with fixed shutters.
    sensor : Sensor
    light : Light
    effects : Selection
        The effects that are simulated.
    device_seed : int
        Seed of the fixed patterns.
    threads : int, optional
        Number of threads, by default that of the processors. Results do not depend on it.
    by_words : bool
        Whether the reference exposes frames, word by word.

    Returns
    -------
    FrameSource

    Raises
    ------
    Rejected
        NS0734 for light of another size, NS0741 for a program without pixel codes, NS0442 for
        words that open no shutters, NS0742 for a converter with more bits than frames store.
    """
    check_size(container, light)
    check_adc(container.target)
    count = threads_of(threads)
    chip = container, sensor, light, effects, device_seed, count
    # Some effects exist word by word only; then the reference exposes every pixel.
    if by_words or reference_reasons(effects):
        return FrameSource(*chip, Reference.of(container, sensor, effects), NO_PIXELS.places)
    program = analysed(container, sensor)
    # Sums of light expose all pixels. Pixels that may saturate or leak unlike most also run their
    # words, whose results replace the sums; with strong crosstalk all do. `program.recent` stores
    # the search by light: planning made it for all effects (`Work.of`).
    near = near_saturation(program, light, device_seed, effects).places
    uneven = on_chip(program, effects, device_seed).uneven
    if exchanges_much(effects, program):
        near = np.arange(program.lane.size)
    elif len(uneven):
        near = np.union1d(near, uneven)
    moments = scene_moments(program, light, effects, device_seed, count)
    block = None
    if len(near):
        block = prepare_pixels(container, sensor, light, effects, near, device_seed, count)
    return FrameSource(*chip, moments, near, block)
