"""Predicted times of each kind of simulation, called prices.

Plans are chosen by constant prices instead of measured times, so that the same input gives the
same plan on every machine."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nscc.words.container import Container
from nscc_runtime.caches import OfContainer, remembered
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Counted, Exchange, Leak, Saturates
from nscc_runtime.effects.parts import Errors as SmallErrors
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.execution.block_program import block_program
from nscc_runtime.execution.moments import exchanges_much, on_chip
from nscc_runtime.execution.program import analysed
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.run_kinds import KINDS

FRAME_NS, _COUNTS_NS, _EXCHANGE_NS, _ERRORS_NS = 15.0, 15.0, 6.0, 7.0
"""A frame by sums, for each pixel and bucket: the frame, counts of light or dark charge, their
exchange between neighbours, and the small errors of all words together. These prices were measured
on one core of an x86 server at about 3 GHz by `nscc effects --cost`; predicted times are right to
a factor of about 2."""
_SCENE_NS, _LIGHT_NS = 10.0, 1.0
"""Once for a scene by sums, for each pixel, and for each frame of light and bucket; effects declare
their own."""
_LOOP_NS, _WORD_NS, _ERROR_NS, _COUNT_NS = 115.0, 13.0, 4.0, 20.0
"""A frame by the loop over words, for each pixel: the frame, each word, each effect that adds an
error to a word, and each source of charge in each stretch. A stretch is the slots between two
reads or resets of PIX, the photodiode."""
SLOT_NS, _TRIAL_MS = 250.0, 1.2
"""A slot of the reference, for each pixel, and each set of effects on a sample."""


@OfContainer
def _words_and_stretches(container: Container, sensor: Sensor) -> tuple[float, float]:
    """Return the numbers of words and of stretches of slots of a pixel under every effect, as means
    over lanes (the pixels of one distinct shutter each); all words if pixels look. A stretch is the
    slots between two reads or resets of PIX, the photodiode."""
    program = block_program(container, sensor, everything())
    lanes, counted = len(program.segments.start) - 1, np.diff(program.stretches.start)
    # Lanes whose counts also end where a neighbour's do follow those of the words.
    counted = counted[lanes:] if len(counted) > lanes else counted
    looks = not KINDS.of(container).open_times_known
    words = len(program.words.words) if looks else len(program.segments.word) / lanes
    return words, float(counted.mean()) - 1.0


@dataclass(frozen=True, eq=False)
class Work:
    """The work of a frame of a scene: means over pixels of the number of `words` and of `stretches`
    of slots between them, and the numbers of pixels that run through their words because they may
    saturate (`near`), or leak unlike most (`uneven`). With strong crosstalk all pixels do."""

    scene: PlannedScene
    words: float
    stretches: float
    near: int
    uneven: int

    @classmethod
    def of(cls, scene: PlannedScene) -> Work:
        """Return how much work a frame of `scene` is: words and stretches per pixel, as a mean over
        lanes (all words if pixels look), and pixels that run through their words under every
        effect. If only the reference simulates it, words and stretches (groups of slots between
        reads or resets of PIX) are 0. PIX is the photodiode."""
        effects, near, uneven = everything(), scene.pixels, 0
        if not scene.looks:
            near = len(scene.near_pixels(effects).places)
            analysis = analysed(scene.container, scene.sensor)
            uneven = len(on_chip(analysis, effects, scene.device_seed).uneven)
        if scene.needs_reference(effects):
            return cls(scene, 0.0, 0.0, near, uneven)
        return cls(scene, *_words_and_stretches(scene.container, scene.sensor), near, uneven)

    def loop_ns(self, effects: Selection) -> float:
        """Return the predicted nanoseconds of one core for one pixel that runs through its words in
        one frame with `effects`."""
        # With exchange, the charge of neighbours is counted too: about one more site per pixel.
        sites = len(effects.names(Counted)) * (1 + len(effects.names(Exchange)))
        word_ns = _WORD_NS + _ERROR_NS * len(effects.errors())
        return _LOOP_NS + self.words * word_ns + self.stretches * _COUNT_NS * sites

    @remembered
    def milliseconds(self, effects: Selection, frames: int = 1) -> float:
        """Return the predicted milliseconds of one core for the first `frames` frames of the scene
        with `effects`, including what is computed once for a scene."""
        scene = self.scene
        if scene.needs_reference(effects):
            return frames * SLOT_NS * scene.light.slots * scene.pixels * 1e-6
        sums_ns, near = 0.0, scene.pixels
        if not scene.looks:
            sums_ns = _sums_ns(
                effects, len(scene.container.buckets), len(scene.light.frames), frames
            )
            near = self.near * bool(effects.names(Saturates))
            near += self.uneven * bool(effects.names(Leak))
            if exchanges_much(effects, analysed(scene.container, scene.sensor)):
                near = scene.pixels
        near_ns = frames * near * self.loop_ns(effects) if near else 0.0
        return (sums_ns * scene.pixels + near_ns) * 1e-6

    def saved_ms(self, effects: Selection, names: frozenset[str], frames: int = 1) -> float:
        """Return the predicted milliseconds that leaving out the effects `names` of `effects`
        saves of the first `frames` frames; below 0 if that takes longer."""
        without = effects.without(*names)
        return self.milliseconds(effects, frames) - self.milliseconds(without, frames)

    def trial_ms(self, pixels: int) -> float:
        """Return the predicted milliseconds of one core for exposing a sample of `pixels` pixels,
        at most those of the scene, with a set of effects. The reference exposes the whole scene."""
        if self.scene.needs_reference(everything()):
            return self.milliseconds(everything())
        sampled_ns = self.loop_ns(everything()) * min(pixels, self.scene.pixels)
        return _TRIAL_MS + 2e-6 * sampled_ns


def _sums_ns(effects: Selection, buckets: int, passes: int, frames: int) -> float:
    """Return the predicted nanoseconds of one core for a pixel by sums, with `effects`: of the
    first `frames` frames of a scene with `passes` frames of light."""
    passes *= buckets
    scene_ns = _SCENE_NS + _LIGHT_NS * passes
    scene_ns += sum(effect.summed_ns(passes) for effect in effects.effects)
    frame_ns = FRAME_NS + _ERRORS_NS * bool(effects.names(SmallErrors))
    if effects.names(Counted):
        frame_ns += _COUNTS_NS + _EXCHANGE_NS * len(effects.names(Exchange))
    return scene_ns + frames * buckets * frame_ns
