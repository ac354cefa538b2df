"""The words of a program as weights of slots and of errors, for each lane (code number).

Without saturation an exposure is a weighted sum of the charge of slots and of the errors of words.
The weights depend on the pixel's code, on gain, leakage, dead time and decay."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.method_cache import remembered
from nscc_runtime.reference.capture import Reference, numbered_errors
from nscc_runtime.reference.trace import AnalogWord, analog_words
from nscc_runtime.reference.weights import Backward, WeightModel, backward

Weights = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Tables:
    """The weights of a program; `program` is the reference with every effect, so that all draws
    exist.

    `fresh`: the analog words without decay of digital registers. `decayed`: the words with decay;
    the same object as `fresh` if decay changes nothing."""

    program: Reference
    fresh: tuple[AnalogWord, ...]
    decayed: tuple[AnalogWord, ...]

    @classmethod
    def of(cls, program: Reference) -> Tables:
        """Return the tables of a program with every effect."""
        fresh = analog_words(program.container)
        alike = all(
            np.array_equal(a.lanes, b.lanes) for a, b in zip(fresh, program.words, strict=True)
        )
        return cls(program, fresh, fresh if alike else program.words)

    @property
    def container(self) -> Container:
        return self.program.container

    @property
    def decays(self) -> bool:
        """Whether decay of digital registers changes where a word acts."""
        return self.decayed is not self.fresh

    def same(self, model: WeightModel) -> WeightModel:
        """Return a representative of all models with the same weights."""
        decay, lit_level = model.decay and self.decays, model.lit_level and model.dead_time
        return replace(model, decay=decay, lit_level=lit_level)

    def weights(self, model: WeightModel) -> Backward:
        """Return the weights of slots and of words' errors under a model, cached."""
        return self._backward(self.same(model))

    @remembered
    def _backward(self, model: WeightModel) -> Backward:
        words = self.decayed if model.decay else self.fresh
        return backward(self.container, words, model)

    @remembered
    def noise(self, at: str, full: WeightModel) -> tuple[Weights, Weights]:
        """Return coefficients of small errors of kind `at`: "reads", "resets" or "words".

        The first array contains the coefficients (lanes, buckets, draws) of the keyed draws. The
        second contains the remaining variance (lanes, buckets). Both are for errors of standard
        deviation 1."""
        lanes, buckets = len(self.container.encoding), len(self.container.buckets)
        coefficients = numbered_errors(self.container.target, self.weights(full))[at]
        drawn = self.program.draws[at]
        factor = np.zeros((lanes, buckets, buckets))
        square = np.zeros((lanes, buckets))
        for number, weight in coefficients.items():
            square += weight * weight
            if number in drawn:
                factor += weight[:, :, None] * drawn[number][:, None, :]
        return factor, np.maximum(square - (factor * factor).sum(axis=2), 0.0)

    @remembered
    def pattern(self, full: WeightModel) -> Weights:
        """Return the sum (lanes, buckets) of the signed coefficients of analog words' errors."""
        return self.weights(full).error_sum

    @remembered
    def seen_slots(self) -> NDArray[np.bool_]:
        """Return a mask (N, lanes) of the slots whose charge is on PIX at some read."""
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
