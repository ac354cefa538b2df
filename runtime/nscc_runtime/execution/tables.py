"""What a program does to light, as numbers for each lane: its words as weights.

As long as nothing saturates, an exposure is a weighted sum of the charge of the slots, of the
errors of the words, and of nothing else. The weights depend on the pixel's code (its lane), on the
gain of the words, on leakage, dead time and decay.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.reference.capture import Reference, numbered_errors
from nscc_runtime.reference.trace import AnalogWord, analog_words
from nscc_runtime.reference.weights import Backward, ByName, Model, backward
from nscc_runtime.remembered import remembered

Weights = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Tables:
    """A program's weights. `program` has every effect on, so that its draws are all there.

    `fresh` are the analog words as they are meant, `decayed` as they are with digital registers
    that lose their values; the same object where none does.
    """

    program: Reference
    fresh: tuple[AnalogWord, ...]
    decayed: tuple[AnalogWord, ...]

    @classmethod
    def of(cls, program: Reference) -> Tables:
        """The tables of a program made ready with every effect."""
        fresh = analog_words(program.container)
        alike = all(
            np.array_equal(a.lanes, b.lanes) for a, b in zip(fresh, program.words, strict=True)
        )
        return cls(program, fresh, fresh if alike else program.words)

    @property
    def container(self) -> Container:
        """The program's container."""
        return self.program.container

    @property
    def decays(self) -> bool:
        """Whether any word acts otherwise because a digital register has lost its value."""
        return self.decayed is not self.fresh

    def same(self, model: Model) -> Model:
        """The model that gives the same weights, one for all such."""
        decay, lit_level = model.decay and self.decays, model.lit_level and model.dead_time
        return replace(model, decay=decay, lit_level=lit_level)

    def weights(self, model: Model) -> Backward:
        """The weights under a model, kept."""
        return self._backward(self.same(model))

    @remembered
    def _backward(self, model: Model) -> Backward:
        words = self.decayed if model.decay else self.fresh
        return backward(self.container, words, model)

    def numbered(self, at: str, model: Model) -> ByName[int]:
        """The coefficients (lanes, buckets) of small errors, by the numbers of their draws."""
        return numbered_errors(self.container.target, self.weights(model))[at]

    @remembered
    def noise(self, at: str, full: Model) -> tuple[Weights, Weights]:
        """Coefficients L (lanes, buckets, draws) of the keyed draws of small errors at `reads`,
        `resets` or `words`, and the variance (lanes, buckets) of what they leave out, for unit
        errors.
        """
        lanes, buckets = len(self.container.encoding), len(self.container.buckets)
        coefficients = self.numbered(at, full)
        drawn = self.program.draws[at]
        factor = np.zeros((lanes, buckets, buckets))
        square = np.zeros((lanes, buckets))
        for number, weight in coefficients.items():
            square += weight * weight
            if number in drawn:
                factor += weight[:, :, None] * drawn[number][:, None, :]
        return factor, np.maximum(square - (factor * factor).sum(axis=2), 0.0)

    @remembered
    def pattern(self, full: Model) -> Weights:
        """The sum (lanes, buckets) of the signed coefficients of the analog words' errors."""
        return self.weights(full).error_sum

    @remembered
    def seen_slots(self) -> NDArray[np.bool_]:
        """The slots (N, lanes) whose charge is on PIX at some read: no register holds more."""
        container = self.container
        is_seen = np.zeros((container.slots, len(container.encoding)), np.bool_)
        live = np.zeros(len(container.encoding), np.bool_)
        later = container.slots
        for word in reversed(self.decayed):
            if word.boundary < later:
                is_seen[word.boundary : later] = live
                later = word.boundary
            if word.resets:
                live = live & ~word.lanes
            elif "PIX" in word.op.sources:
                live = live | word.lanes
        is_seen[:later] = live
        return is_seen
