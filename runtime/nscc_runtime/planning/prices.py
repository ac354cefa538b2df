"""Predicted times of each kind of simulation, called prices.

Plans are chosen by the constant prices in `SHIPPED` instead of measured times, so that the same
input gives the same plan on every machine."""

from __future__ import annotations

from dataclasses import dataclass

from nscc_runtime.caches import remembered
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Counted, Exchange, Saturates
from nscc_runtime.effects.parts import Errors as SmallErrors
from nscc_runtime.execution.block_program import block_program
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.reference.trace import retention_us


@dataclass(frozen=True)
class Prices:
    """Times of parts of a simulation, in nanoseconds of one core per pixel.

    A frame by sums, for each bucket: `frame`, `counts` of light or dark charge, their `exchange`
    between neighbours, and the small `errors` of all words together. Once for a scene by sums:
    `scene`, and `light` for each frame of light and bucket; effects declare their own. A frame by
    the loop over words: `loop`; for each word of a pixel `word`, and `error` for each effect that
    adds an error to it; for each stretch between two words `count`, of each source of charge. The
    reference: `slot`, each slot. In milliseconds: `trial_ms`, each set of effects on a sample. A
    stretch is the slots between two reads or resets of PIX, the photodiode."""

    frame: float = 15.0
    counts: float = 15.0
    exchange: float = 6.0
    errors: float = 7.0
    scene: float = 10.0
    light: float = 1.0
    loop: float = 115.0
    word: float = 13.0
    error: float = 4.0
    count: float = 20.0
    slot: float = 250.0
    trial_ms: float = 1.2


SHIPPED = Prices()
"""Measured on one core of an x86 server at about 3 GHz by `nscc effects --cost`. Predicted times
are right to a factor of about 2."""


@dataclass(frozen=True, eq=False)
class Work:
    """The work of a frame of a scene: means over pixels of the number of `words` and of `stretches`
    of slots between them, and the number of pixels that run through their words (`near`)."""

    scene: PlannedScene
    words: float
    stretches: float
    near: int

    @classmethod
    def of(cls, scene: PlannedScene) -> Work:
        """Return how much work a frame of `scene` is: words and stretches per pixel, as a mean over
        lanes (all words if pixels look), and pixels near saturation under every effect. If only the
        reference simulates it, words and stretches (groups of slots between reads or resets of PIX)
        are 0. PIX is the photodiode."""
        effects = everything()
        near = scene.pixels if scene.looks else len(scene.near_pixels(effects).places)
        if scene.needs_reference(effects):
            return cls(scene, 0.0, 0.0, near)
        program = block_program(scene.container, retention_us(effects, scene.sensor))
        lanes = len(program.stretches.start) - 1
        words = len(program.words.words) if scene.looks else len(program.segments.word) / lanes
        return cls(scene, words, len(program.stretches.boundary) / lanes - 1.0, near)

    def loop_ns(self, effects: Selection) -> float:
        """Return the predicted nanoseconds of one core for one pixel that runs through its words in
        one frame with `effects`."""
        # With exchange, the charge of neighbours is counted too: about one more site per pixel.
        prices, sites = SHIPPED, 1.0 if effects.find_part(Exchange) is None else 2.0
        word_ns = prices.word + prices.error * len(effects.errors())
        count_ns = prices.count * sites * len(effects.names(Counted))
        return prices.loop + self.words * word_ns + self.stretches * count_ns

    @remembered
    def milliseconds(self, effects: Selection, frames: int = 1) -> float:
        """Return the predicted milliseconds of one core for the first `frames` frames of the scene
        with `effects`, including what is computed once for a scene; remembered."""
        scene, prices = self.scene, SHIPPED
        if scene.needs_reference(effects):
            return frames * prices.slot * scene.light.slots * scene.pixels * 1e-6
        if scene.looks:
            return frames * self.loop_ns(effects) * scene.pixels * 1e-6
        buckets, passes = len(scene.container.buckets), len(scene.light.frames)
        scene_ns = prices.scene + prices.light * passes * buckets
        scene_ns += sum(effect.summed_ns(passes * buckets) for effect in effects.effects)
        frame_ns = buckets * prices.frame
        if effects.names(Counted):
            exchanges = effects.find_part(Exchange) is not None
            frame_ns += buckets * (prices.counts + prices.exchange * exchanges)
        if effects.names(SmallErrors):
            frame_ns += buckets * prices.errors
        near_ns = self.near * self.loop_ns(effects) if effects.names(Saturates) else 0.0
        return ((scene_ns + frames * frame_ns) * scene.pixels + frames * near_ns) * 1e-6

    def saved_ms(self, effects: Selection, names: frozenset[str], frames: int = 1) -> float:
        """Return the predicted milliseconds that leaving out the effects `names` of `effects`
        saves of the first `frames` frames; below 0 if that takes longer."""
        without = effects.without(*names)
        return self.milliseconds(effects, frames) - self.milliseconds(without, frames)

    def trials_ms(self, sets: int, pixels: int) -> float:
        """Return the predicted milliseconds of one core for exposing a sample of `pixels` pixels,
        at most those of the scene, once with each of `sets` sets of effects. The reference exposes
        the whole scene each time."""
        effects = everything()
        if self.scene.needs_reference(effects):
            return self.milliseconds(effects, sets)
        pixels = min(pixels, self.scene.pixels)
        return sets * (SHIPPED.trial_ms + 2e-6 * self.loop_ns(effects) * pixels)
