"""What a program does to light, as numbers for each lane: its words as weights.

As long as nothing saturates, an exposure is a weighted sum of the charge of the slots, of the
errors of the words, and of nothing else. The weights depend on the pixel's code (its lane), on the
gain of the words, on leakage, dead time and decay.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, reduce

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.reference.capture import Reference, numbered_errors
from nscc_runtime.reference.trace import AnalogWord, analog_words
from nscc_runtime.reference.weights import Backward, ByName, backward
from nscc_runtime.remembered import remembered

Weights = NDArray[np.float64]


@dataclass(frozen=True)
class Model:
    """What weights depend on: the gain of a word, the rate at which registers leak, whether light
    falls while words run, whether digital registers fade, and whether the level of a reset is read
    with the light that fell since.
    """

    gain: float = 1.0
    leak_per_s: float = 0.0
    dead_time: bool = False
    decay: bool = False
    lit_level: bool = False


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
        return backward(
            self.container, words, model.gain, model.leak_per_s, model.dead_time, model.lit_level
        )

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
        found = self.numbered(at, full)
        drawn = self.program.draws[at]
        factor = np.zeros((lanes, buckets, buckets))
        square = np.zeros((lanes, buckets))
        for number, weight in found.items():
            square += weight * weight
            if number in drawn:
                factor += weight[:, :, None] * drawn[number][:, None, :]
        return factor, np.maximum(square - (factor * factor).sum(axis=2), 0.0)

    @remembered
    def pattern(self, full: Model) -> Weights:
        """The sum (lanes, buckets) of the signed coefficients of the analog words' errors."""
        none = np.zeros((len(self.container.encoding), len(self.container.buckets)))
        return sum(self.weights(full).errors.values(), none)

    @remembered
    def seen(self) -> NDArray[np.bool_]:
        """The slots (N, lanes) whose charge is on PIX at some read: no register holds more."""
        container = self.container
        found = np.zeros((container.slots, len(container.encoding)), np.bool_)
        live = np.zeros(len(container.encoding), np.bool_)
        later = container.slots
        for word in reversed(self.decayed):
            if word.boundary < later:
                found[word.boundary : later] = live
                later = word.boundary
            if word.resets:
                live = live & ~word.lanes
            elif "PIX" in word.op.sources:
                live = live | word.lanes
        found[:later] = live
        return found

    @cached_property
    def held_slots(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The first of the slots whose charge PIX holds when it is read, and the one after the
        last of them, (kinds, lanes) each: one kind for the last read before each reset, no slots
        where a lane has fewer."""
        words, slots = self.decayed, self.container.slots
        shape = sum(word.resets for word in words) + 1, len(self.container.encoding)
        first, stop = np.zeros(shape, np.int64), np.zeros(shape, np.int64)
        reset_at, read_at, count = (np.zeros(shape[1], np.int64) for _ in range(3))

        def end(here: NDArray[np.bool_], boundary: int) -> None:
            """PIX is reset in these lanes, or the frame ends."""
            held = np.flatnonzero(here & (read_at > reset_at))
            first[count[held], held], stop[count[held], held] = reset_at[held], read_at[held]
            count[held] += 1
            reset_at[here] = boundary

        for word in words:
            if word.resets:
                end(word.lanes, word.boundary)
            elif "PIX" in word.op.sources:
                read_at[word.lanes] = word.boundary
        end(np.ones(shape[1], np.bool_), slots)
        most = max(1, int(count.max(initial=0)))
        return first[:most].copy(), stop[:most].copy()

    @remembered
    def least_read(self, full: Model) -> Weights:
        """The least size (lanes, buckets) of the coefficients of reads that reach a bucket; 0 where
        none does."""
        found = np.full((len(self.container.encoding), len(self.container.buckets)), np.inf)
        for weight in self.weights(full).reads.values():
            found = np.where(weight != 0.0, np.minimum(found, np.abs(weight)), found)
        return np.where(np.isinf(found), 0.0, found)

    @remembered
    def most_read(self, full: Model) -> Weights:
        """The largest size (lanes, buckets) of the coefficients of reads."""
        none = np.zeros((len(self.container.encoding), len(self.container.buckets)))
        sizes = (np.abs(weight) for weight in self.weights(full).reads.values())
        return reduce(np.maximum, sizes, none)

    @remembered
    def squared_reads(self, full: Model) -> Weights:
        """The sum (lanes, buckets) of the squared coefficients of reads."""
        none = np.zeros((len(self.container.encoding), len(self.container.buckets)))
        return sum((weight**2 for weight in self.weights(full).reads.values()), none)

    @remembered
    def single(self, full: Model) -> Weights:
        """The coefficient (lanes, buckets) of the one read through which all charge reaches the
        bucket; NaN where there are several such reads, as where light falls on PIX between a reset
        and the read of its level.
        """
        container = self.container
        shape = len(container.encoding), len(container.buckets)
        reset_at = np.zeros(shape[0], np.int64)
        count, found = np.zeros(shape, np.int64), np.zeros(shape)
        reads = self.weights(full).reads
        for word in self.decayed:
            if word.resets:
                reset_at = np.where(word.lanes, word.boundary, reset_at)
            elif word.number in reads:
                weight = reads[word.number]
                after = (reset_at < word.boundary) | (full.dead_time and full.lit_level)
                loaded = (weight != 0.0) & after[:, None]
                count += loaded
                found = np.where(loaded, weight, found)
        return np.where(count > 1, np.nan, found)
