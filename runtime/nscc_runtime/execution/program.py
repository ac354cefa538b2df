"""A compiled program on a sensor, analysed once for any number of scenes and sets of effects."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from math import inf

import numpy as np

from nscc.arrays import Bools, Floats, Ints32
from nscc.words.container import Container
from nscc_runtime.caches import OfContainer, Recent, remembered
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Moving
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Device, whole_device
from nscc_runtime.emulator.capture import check_program
from nscc_runtime.execution.sum_loop import SlotWeights
from nscc_runtime.light import Light
from nscc_runtime.reference.trace import (
    AnalogWord,
    analog_words,
    readout_waits_s,
    retention_us,
)
from nscc_runtime.reference.weights import Backward, WeightModel, backward

_RECENT_MODELS, _RECENT_LARGE = 24, 12
"""Number of cached results: planning compares a dozen models."""
_MUCH = 1 << 20
"""If slots x lanes or the number of pixels is above this number, fewer results are cached."""


@dataclass(frozen=True, eq=False)
class AnalysedProgram:
    """A compiled program with fixed shutters on a sensor.

    Attributes
    ----------
    container : Container
    sensor : Sensor
    fresh, decayed : tuple of AnalogWord
        The analog words without and with decay of digital registers; the same object if decay
        changes nothing.
    lane : int32, shape (rows, cols)
        The number of each pixel's lane (the pixels of one distinct shutter): the row of its shutter
        in `container.encoding`. Several codes may have one shutter.
    slot_s : float64, shape (slots,)
        Slot lengths in seconds.
    """

    container: Container
    sensor: Sensor
    fresh: tuple[AnalogWord, ...]
    decayed: tuple[AnalogWord, ...]
    lane: Ints32
    slot_s: Floats

    @classmethod
    def of(cls, container: Container, sensor: Sensor) -> AnalysedProgram:
        """Return the analysis of the program of `container` on a chip with `sensor`.

        Raises Rejected if the program has no pixel codes (NS0741) or its words open no shutters
        (NS0442), and ValueError for an inconsistent container. A container is a compiled program.
        """
        check_program(container)
        if container.pixel_codes is None:
            raise ValueError("the program has no pixel codes: add a `pixels` statement")
        fresh = decayed = analog_words(container)
        backward(container, fresh).open()
        kept_us = retention_us(everything(), sensor)
        if kept_us < inf:
            fading = analog_words(container, kept_us)
            same = (np.array_equal(a.lanes, b.lanes) for a, b in zip(fresh, fading, strict=True))
            decayed = fresh if all(same) else fading
        lane = container.table.shutter_of_code[container.pixel_codes]
        lane = np.require(lane, np.int32, ["C", "A"])
        return cls(container, sensor, fresh, decayed, lane, container.slot_s)

    @property
    def lanes(self) -> Ints32:
        """The number of each pixel's lane, shape (pixels,)."""
        return self.lane.reshape(-1)

    @remembered
    def model(self, effects: Selection) -> WeightModel:
        """Return the parameters of weights under `effects`, at the mean leakage of the pixels;
        remembered for each selection."""
        return WeightModel.of(effects, self.sensor)

    def words(self, model: WeightModel) -> tuple[AnalogWord, ...]:
        """Return the analog words that run under `model`: with or without decay of digital
        registers."""
        return self.decayed if model.decay else self.fresh

    def weights(self, model: WeightModel) -> Backward:
        """Return the weights of slots and of words' errors under `model`; cached."""
        # Models with the same weights share a result: decay may change nothing, and light is in a
        # reset level only if it is collected while words run.
        decay = model.decay and self.decayed is not self.fresh
        lit_level = model.lit_level and model.slow_words
        return self._backward(replace(model, decay=decay, lit_level=lit_level))

    @remembered
    def _backward(self, model: WeightModel) -> Backward:
        """Return the weights of slots and words under `model`, which `weights` has simplified;
        cached."""
        return backward(self.container, self.words(model), model)

    def buckets_overlap(self, model: WeightModel) -> bool:
        """Return whether the charge of some slot reaches two or more buckets, in any lane (the
        pixels of one distinct shutter)."""
        return bool(((self.weights(model).slots != 0.0).sum(axis=2) > 1).any())

    @cached_property
    def opened(self) -> Bools:
        """The shutters (N, lanes, buckets). A lane is the pixels of one distinct shutter."""
        return self._backward(WeightModel()).open()

    @remembered
    def seen_slots(self, decay: bool) -> Bools:
        """Return the mask (N, lanes) of the slots whose charge is on PIX (the photodiode) when a
        word reads it: slots with no read between them and the next reset, or the end of the frame,
        are False. `decay`: whether digital registers decay. A lane is the pixels of one distinct
        shutter."""
        container = self.container
        is_seen = np.zeros((container.slots, len(container.encoding)), np.bool_)
        live = np.zeros(len(container.encoding), np.bool_)
        later = container.slots
        for word in reversed(self.decayed if decay else self.fresh):
            if word.boundary < later:
                is_seen[word.boundary : later] = live
                later = word.boundary
            if word.resets:
                live = live & ~word.lanes
            elif "PIX" in word.op.sources:
                live = live | word.lanes
        is_seen[:later] = live
        return is_seen

    @cached_property
    def oldest_s(self) -> float:
        """The longest time in seconds that an analog register may hold a charge: the frame, then
        the wait for the last readout."""
        return float(self.slot_s.sum() + readout_waits_s(self.container).max(initial=0.0))

    def device(self, device_seed: int) -> Device:
        """Return the fixed patterns of all pixels of the chip with this seed."""
        return whole_device(self.sensor, device_seed, self.lane.size)

    def slot_weights(
        self, model: WeightModel, leak_rates: tuple[float, ...], products: bool
    ) -> SlotWeights:
        """Return the weights (sums, N, lanes) of slots for the sums of a scene; cached.

        They are those of each bucket at each of the `leak_rates` (1/s), all rates of a bucket one
        after the other. If `products` is True, the products of the weights of two buckets come
        first: (0, 0), (0, 1), (1, 1), (0, 2) and so on. A lane is the pixels of one distinct
        shutter."""

        def make() -> SlotWeights:
            """Return the weights of each slot by lane: products of buckets if wanted, then each
            bucket for each rate of leakage. A lane is the pixels of one distinct shutter."""
            weights = self.weights(model).slots
            buckets = range(weights.shape[2])
            pairs = [(a, b) for b in buckets for a in range(b + 1)] if products else []
            by_rate = [self.weights(replace(model, leak_per_s=rate)).slots for rate in leak_rates]
            return SlotWeights(
                [
                    *(weights[:, :, a] * weights[:, :, b] for a, b in pairs),
                    *(of_rate[:, :, b] for b in buckets for of_rate in by_rate),
                ],
                len(pairs),
            )

        return self.recent.of((SlotWeights, model, leak_rates, products), make)

    @cached_property
    def recent(self) -> Recent:
        """Cache of what the last scenes and sets of effects needed. Keys begin with the class or
        the function of the result: `SlotWeights`, `RegisterReach`, `NearSaturation` (by light),
        `_Limits` of saturation, `_ChipMoments`, `_neighbour_weights`, `_word_errors`, and
        `_estimated_e2` of planning."""
        size = max(self.container.slots * len(self.container.encoding), self.lane.size * 16)
        return Recent(_RECENT_LARGE if size > _MUCH else _RECENT_MODELS)


def light_under(effects: Selection, light: Light) -> Light:
    """Return the light that pixels collect under `effects`: with the motion within slots if that
    effect is on and the scene has motion, else `light` itself."""
    return (effects.find_part(Moving) and light.motion) or light


analysed = OfContainer(AnalysedProgram.of)
"""Return the `AnalysedProgram` of a container on a sensor, cached for each pair."""
