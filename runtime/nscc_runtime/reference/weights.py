"""Weights of each slot's charge and of each word's noise in the exposures, computed by running the
words backwards over the lanes.

Words are linear, so without saturation an exposure is a weighted sum of the charge of slots and of
all errors."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from math import exp
from typing import Literal, TypeVar

import numpy as np

from nscc.arrays import Bools, Floats, Ints32
from nscc.words.container import Container
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.effects.parts import Fading, Leak, LitLevel, SlowWords, WordGain
from nscc_runtime.reference.trace import AnalogWord, opens_no_shutters, readout_waits_s

Weights = Floats
Name = TypeVar("Name", int, tuple[int, int])


class ByName(Mapping[Name, Weights]):
    """Weights, each an array (lanes, buckets), by name: the number of a word, or this and the index
    of a destination. Names whose weights are all 0 are missing: reading one raises KeyError.

    In long frames most words act in one lane (the pixels of one distinct shutter) of thousands.
    Only nonzero rows are stored, and arrays are built on access."""

    def __init__(self) -> None:
        """Begin without weights."""
        self._held: dict[Name, tuple[int, Ints32, Weights]] = {}

    def keep(self, name: Name, weight: Weights) -> None:
        """Store the weights (lanes, buckets) of a name, in place of those stored before; all 0
        changes nothing. A lane is the pixels of one distinct shutter."""
        lanes = np.flatnonzero(weight.any(axis=1)).astype(np.int32)
        if len(lanes):
            self._held[name] = len(weight), lanes, weight[lanes]

    def __getitem__(self, name: Name) -> Weights:
        """Return the weights (lanes, buckets) of a name, 0 in the lanes (the pixels of one distinct
        shutter each) that are not stored. Raises KeyError for a name whose weights are all 0 or
        were never stored."""
        count, lanes, lane_weights = self._held[name]
        weights = np.zeros((count, lane_weights.shape[1]))
        weights[lanes] = lane_weights
        return weights

    def __iter__(self) -> Iterator[Name]:
        """Yield the names with weights."""
        return iter(self._held)

    def __len__(self) -> int:
        """Return the number of names with weights."""
        return len(self._held)


@dataclass(frozen=True)
class WeightModel:
    """The parameters on which weights depend.

    `gain`, `move_gain`: gains of a word that adds sources, and of one that moves a value.
    `move_noise`: random error of a move, as a fraction of that of an addition. `leak_per_s`: rate
    (1/s) at which analog registers leak. `slow_words`: whether light is collected while words run.
    `decay`: whether digital registers decay. `lit_level`: whether a reset level is read with the
    light collected since. The defaults are words without errors."""

    gain: float = 1.0
    move_gain: float = 1.0
    move_noise: float = 1.0
    leak_per_s: float = 0.0
    slow_words: bool = False
    decay: bool = False
    lit_level: bool = False

    @classmethod
    def of(cls, effects: Selection, sensor: Sensor) -> WeightModel:
        """Return the model of words under these effects with the values of `sensor`; effects that
        are off have the defaults. Leakage is the mean of the pixels."""
        gain, leak = effects.find_part(WordGain), effects.find_part(Leak)
        return cls(
            gain=gain.gain(sensor) if gain else 1.0,
            move_gain=gain.move_gain(sensor) if gain else 1.0,
            move_noise=gain.move_noise(sensor) if gain else 1.0,
            leak_per_s=1.0 / leak.tau_s(sensor) if leak else 0.0,
            slow_words=effects.find_part(SlowWords) is not None,
            decay=effects.find_part(Fading) is not None,
            lit_level=effects.find_part(LitLevel) is not None,
        )


@dataclass(frozen=True, eq=False)
class Backward:
    """Weights in the exposures; each array ends in (lanes, buckets).

    `slots` (N, ..): weights of each slot's charge. The others map the number of an analog word to
    the weight of its error: `reads`, the noise of reading PIX (the photodiode); `resets`, the noise
    that PIX keeps after a reset; `errors`, the fixed error that an addition adds to its result,
    keyed by word number and destination index (signed by `error_sign`); `noise`, the random error
    that a word adds, for that of an addition. A lane is the pixels of one distinct shutter."""

    slots: Weights
    reads: ByName[int]
    resets: ByName[int]
    errors: ByName[tuple[int, int]]
    noise: ByName[tuple[int, int]]

    def covariance(self, at: Literal["reads", "resets", "words"]) -> Weights:
        """Return the covariance (buckets, buckets, lanes) of exposures if the errors of one kind
        are independent, each of variance 1. `at`: errors of reading PIX (the photodiode), errors of
        resets, or the random errors of words. Without such errors it is 0. A lane is the pixels of
        one distinct shutter."""
        weights = {"reads": self.reads, "resets": self.resets, "words": self.noise}[at]
        _, lanes, buckets = self.slots.shape
        total = np.zeros((buckets, buckets, lanes))
        for weight in weights.values():  # type: ignore[attr-defined]
            total += weight.T[:, None] * weight.T
        return total

    def variance(self, at: Literal["reads", "resets", "words"]) -> Weights:
        """Return the variance (lanes, buckets) of exposures if the errors of one kind are
        independent, each of variance 1. `at`: errors of reading PIX (the photodiode), errors of
        resets, or the random errors of words. Without such errors it is 0. A lane is the pixels of
        one distinct shutter."""
        return np.asarray(np.einsum("bbl->lb", self.covariance(at)))

    @cached_property
    def error_sum(self) -> Weights:
        """Sum (lanes, buckets) of the weights `errors` of all additions: the change of exposures if
        each addition has an error of 1 e. It is 0 without additions. A lane is the pixels of one
        distinct shutter."""
        return sum(self.errors.values(), np.zeros(self.slots.shape[1:]))

    def open(self) -> Bools:
        """Return the shutters (N, lanes, buckets), True where open. Raises Rejected with NS0442 if
        the weight of a slot is neither 0 nor 1 up to rounding, as with a model that has losses. A
        lane is the pixels of one distinct shutter."""
        is_open = self.slots > 0.5
        if not np.allclose(self.slots, is_open, rtol=0, atol=1e-9):
            raise opens_no_shutters(
                "the words of this program do not implement shutters: the light of some "
                "slot has a weight other than 0 or 1"
            )
        return is_open


def backward(
    container: Container, words: Sequence[AnalogWord], model: WeightModel = WeightModel()
) -> Backward:
    """Return the weights of the slots' charge and of the words' errors in the exposures, for each
    lane (the pixels of one distinct shutter).

    `words`: all bus and reset words of a frame in the order of execution (`analog_words`); empty or
    ignored for a chip without logic. Digital decay must already be contained in them: they are
    computed with the retention time. `model`: gains, leakage and times of words, by default words
    without errors. With its `slow_words`, a slot's charge reaches PIX (the photodiode) at a
    constant rate while the words of its boundary run. With `lit_level`, words that read PIX after
    its reset at the same boundary also read this charge.

    A shutter that is open in the slots 1 and 2 of four counts their charge once. If every word
    loses a tenth, the two words between a slot and the readout leave 0.81 of it, and the
    subtraction of the charge from before the shutter opened is no longer exact:

        >>> import nscc
        >>> from nscc_runtime.reference.trace import analog_words
        >>> program = nscc.compile('''nsl 1
        ... frame 4 slots of 1ms
        ... code start : 0..3
        ... code stop : 1..4
        ... require start < stop
        ... open when start <= n < stop
        ... pixels start = 1
        ... pixels stop = 3''').container
        >>> words = analog_words(program)
        >>> backward(program, words).slots[:, 0, 0].tolist()
        [0.0, 1.0, 1.0, 0.0]
        >>> lossy = WeightModel(gain=0.9, move_gain=0.9)
        >>> backward(program, words, lossy).slots[:, 0, 0].round(3).tolist()
        [0.081, 0.81, 0.81, 0.0]
    """
    leak_per_s, slow_words = model.leak_per_s, model.slow_words
    if container.target.taps:
        return _of_taps(container, leak_per_s, slow_words)
    lanes = len(words[0].lanes) if words else len(container.encoding)
    buckets = len(container.buckets)
    names = (*container.target.analog_registers, "PIX", "IN")
    weight = {name: np.zeros((lanes, buckets)) for name in names}
    waits_s = readout_waits_s(container)
    for readout in container.readouts:
        bucket = container.buckets.index(readout.bucket)
        remaining = exp(-leak_per_s * waits_s[bucket])
        weight[readout.register][:, bucket] += readout.gain * remaining
    slots = np.zeros((container.slots, lanes, buckets))
    result = Backward(slots, ByName(), ByName(), ByName(), ByName())
    start_s = np.concatenate(([0.0], np.cumsum(container.slot_us))) * 1e-6
    later = container.slots  # the boundary at which the words handled last, later in time, run
    after_the_last = np.zeros((lanes, buckets))
    by_boundary = groupby(words, key=lambda word: word.boundary)
    for boundary, executed in reversed([(n, [*group]) for n, group in by_boundary]):
        result.slots[boundary:later] = weight["PIX"]
        remaining = exp(-leak_per_s * (start_s[later] - start_s[boundary]))
        if remaining != 1.0:
            for name in container.target.analog_registers:
                weight[name] = weight[name] * remaining
        later = boundary
        slot = min(boundary, container.slots - 1)
        ends = _ends(executed, container.slot_us[slot], boundary == container.slots)
        # Charge that falls while words run after the last slot is a multiple of that slot's.
        fallen = after_the_last if boundary == container.slots else result.slots[slot]
        if slow_words:
            fallen *= 1.0 - ends[-1]
        fresh, unseen = _fresh(executed, lanes), np.zeros((lanes, buckets))
        for index in reversed(range(len(executed))):
            word, before = executed[index], weight["PIX"]
            _through(word, weight, container, model, result)
            if not model.lit_level:
                # Later readings of the fresh PIX give its reset level, without this charge.
                read = np.zeros_like(before) if word.resets else weight["PIX"] - before
                unseen = (unseen + read * fresh[index]) * ~(word.lanes[:, None] & word.resets)
            if slow_words:
                waited = ends[index] - (ends[index - 1] if index else 0.0)
                fallen += waited * (weight["PIX"] - unseen)
    result.slots[:later] = weight["PIX"]
    result.slots[-1] += after_the_last
    return result


def _of_taps(container: Container, leak_per_s: float, slow_words: bool) -> Backward:
    """Return the weights for a chip without logic, whose taps are reset and read once. The numbers
    of reads and resets are those of taps. `leak_per_s`: rate (1/s) at which taps leak.
    `slow_words`: whether no light is collected while bit planes are loaded.

    Errors of reading are added after the gain, so their weights are 1; errors of resets before
    it."""
    target, shutters = container.target, container.table.shutters
    gains = np.array([readout.gain for readout in container.readouts])
    slot_us = np.array(container.slot_us)
    age_s = (slot_us.sum() - np.cumsum(slot_us)) * 1e-6
    lit = np.exp(-leak_per_s * age_s)
    if slow_words and not target.pipelined:
        lit = lit * (1.0 - target.plane_load_us / slot_us)
    slots = shutters.transpose(2, 0, 1) * gains * lit[:, None, None]
    tap_weights = np.broadcast_to(np.eye(len(gains))[:, None, :], (len(gains), *slots.shape[1:]))
    result = Backward(slots, ByName(), ByName(), ByName(), ByName())
    for number, weight in enumerate(tap_weights):
        result.reads.keep(number, weight)
        result.resets.keep(number, weight * gains)
    return result


def _fresh(executed: Sequence[AnalogWord], lanes: int) -> Bools:
    """Return a mask (words, lanes, 1): True if an earlier word of the same boundary has reset PIX
    (the photodiode) in this lane (the pixels of one distinct shutter). `executed`: the words of one
    boundary in order, at least one. The last axis fits the buckets of weights."""
    is_fresh = np.zeros((len(executed), lanes), np.bool_)
    for index, word in enumerate(executed[:-1]):
        is_fresh[index + 1] = is_fresh[index] | (word.lanes & word.resets)
    return is_fresh[:, :, None]


def _ends(executed: Sequence[AnalogWord], slot_us: float, after_the_last: bool) -> list[float]:
    """Return the end of each word of a boundary as a fraction of the slot that begins there, which
    lasts `slot_us` microseconds.

    It is at most 1, except after the last slot (`after_the_last`), where the slot is the last one
    and its light goes on."""
    ends = [word.after_us / slot_us for word in executed]
    return ends if after_the_last else [min(end, 1.0) for end in ends]


def _through(
    word: AnalogWord,
    weight: dict[str, Weights],
    container: Container,
    model: WeightModel,
    result: Backward,
) -> None:
    """Change the weights of registers from those after `word` to those before it, in place, and
    store the weights of the word's errors in `result`.

    `weight`: by name of an analog register, PIX (the photodiode) and IN, how much of its content
    reaches the exposures, (lanes, buckets). In lanes (the pixels of one distinct shutter each) in
    which the word does not act nothing changes."""
    acts = word.lanes[:, None]
    if word.resets:
        result.resets.keep(word.number, weight["PIX"] * acts)
        weight["PIX"] = weight["PIX"] * ~acts
        return
    through = np.zeros_like(weight["PIX"])
    for index, name in enumerate(word.op.destinations):
        acting_weight = weight[name] * acts
        weight[name] = weight[name] * ~acts
        through += acting_weight
        error_weight = error_sign(name, container) * acting_weight
        if word.adds:
            result.errors.keep((word.number, index), error_weight)
        if word.adds or model.move_noise:
            noise_weight = error_weight if word.adds else model.move_noise * error_weight
            result.noise.keep((word.number, index), noise_weight)
    through *= -(model.gain if word.adds else model.move_gain) / word.op.operation.divisor
    for name in word.op.sources:
        weight[name] = weight[name] + through
    if "PIX" in word.op.sources:
        result.reads.keep(word.number, through)


def error_sign(destination: str, container: Container) -> float:
    """Return the sign of errors written to a register: -1 for the scratch register, which contains
    inverted values, otherwise 1."""
    return -1.0 if destination == container.target.analog_scratch else 1.0
