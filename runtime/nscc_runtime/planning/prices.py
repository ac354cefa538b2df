"""Predicted times of each kind of simulation, called prices.

Plans are chosen by the constant prices in `SHIPPED` instead of measured times, so that the same
input gives the same plan on every machine."""

from __future__ import annotations

from dataclasses import dataclass

from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Counted, Exchange, Saturates
from nscc_runtime.execution.block_program import block_program
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.reference.trace import retention_us


@dataclass(frozen=True)
class Prices:
    """Times of parts of a simulation, in nanoseconds of one core unless the name says otherwise.

    `slot_of_reference`: the reference, per pixel and slot. Per pixel in the loop over words:
    `pixel`, to begin; `word`, each word; `error`, each small error of a word; `stretch`, the charge
    between two words; `count`, its photon count, at the pixel and at each neighbour that exchanges
    charge. Per pixel of a frame by sums: `summed`, and `light` for each frame of its light; effects
    declare their own. `trial_ms`: each set of effects on a sample."""

    slot_of_reference: float
    pixel: float
    word: float
    error: float
    stretch: float
    count: float
    summed: float
    light: float
    frame_ms: float
    trial_ms: float


SHIPPED = Prices(
    slot_of_reference=450.0, pixel=60.0, word=6.0, error=8.0, stretch=20.0, count=25.0, summed=4.0,
    light=0.5, frame_ms=0.6, trial_ms=0.7,
)  # fmt: skip
"""Measured on one core of an x86 server at about 3 GHz by `nscc effects --cost`. Predicted times
are right to a factor of about 2."""

_SHARED_SITES, _SITES = 2.0, 5.0
"""Pixels whose counts are drawn for each pixel with crosstalk: if all pixels run, and if few do."""


@dataclass(frozen=True)
class Work:
    """The work of a frame of a scene.

    `words`, `stretches`: words of a pixel that act, and stretches of slots between them, as means.
    `slots`: number of slots. `frames_of_light`: frames of light times buckets. `pixels`: number of
    pixels, of which `near` may saturate. `looks`: whether all pixels run through their words.
    `motion`: whether light moves inside slots."""

    scene: PlannedScene
    words: float
    stretches: float
    near: int

    @classmethod
    def of(cls, scene: PlannedScene) -> Work:
        """Return the work of a scene."""
        effects = everything()
        near = scene.pixels if scene.looks else len(scene.near_pixels(effects).places)
        if scene.needs_reference(effects):
            return cls(scene, 0.0, 0.0, near)
        program = block_program(scene.container, retention_us(effects, scene.sensor))
        lanes = len(program.stretches.start) - 1
        words = len(program.words.words) if scene.looks else len(program.segments.word) / lanes
        return cls(scene, words, len(program.stretches.boundary) / lanes - 1.0, near)

    def loop_ns(self, effects: Selection, sites: float = _SITES) -> float:
        """Return the nanoseconds of a pixel that runs through its words with these effects.
        `sites`: pixels whose counts are drawn for it if charge is exchanged."""
        prices, counted = SHIPPED, len(effects.names(Counted))
        if effects.find_part(Exchange) is None:
            sites = 1.0
        errors_ns = prices.error * len(effects.errors())
        charge_ns = prices.stretch + prices.count * counted * sites
        return prices.pixel + self.words * (prices.word + errors_ns) + self.stretches * charge_ns

    def frame_ms(self, effects: Selection) -> float:
        """Return the milliseconds of a frame with these effects."""
        scene, prices = self.scene, SHIPPED
        if scene.needs_reference(effects):
            return prices.slot_of_reference * scene.light.slots * scene.pixels * 1e-6
        if scene.looks:
            return prices.frame_ms + self.loop_ns(effects, _SHARED_SITES) * scene.pixels * 1e-6
        passes = len(scene.light.frames) * len(scene.container.buckets)
        summed_ns = prices.summed + prices.light * passes
        summed_ns += sum(effect.summed_ns(passes) for effect in effects.effects)
        near = self.near if effects.names(Saturates) else 0
        return prices.frame_ms + (summed_ns * scene.pixels + self.loop_ns(effects) * near) * 1e-6

    def trials_ms(self, sets: int, pixels: int) -> float:
        """Return the milliseconds of exposing a sample of `pixels` with some sets of effects."""
        scene, effects = self.scene, everything()
        if scene.needs_reference(effects):
            return sets * self.frame_ms(effects)
        pixels = min(pixels, scene.pixels)
        return sets * (SHIPPED.trial_ms + 1e-6 * self.loop_ns(effects) * pixels)
