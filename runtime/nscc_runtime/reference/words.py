"""Execute analog words on some pixels, in float64 with the given effects."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.operations import OPERATIONS, WordEffect
from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.parts import Errors
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels, Word
from nscc_runtime.frame_file import Frame, converted
from nscc_runtime.interface import Exposure
from nscc_runtime.noise import key, uniforms
from nscc_runtime.pool import in_strips, threads_of
from nscc_runtime.reference.charge import Fallen
from nscc_runtime.reference.resets import Resets
from nscc_runtime.reference.saturation_marks import Marks
from nscc_runtime.reference.trace import RunningWord
from nscc_runtime.reference.weights import error_sign

Values = NDArray[np.float64]
Bits = NDArray[np.bool_]
Marked = tuple[Values, NDArray[np.uint8]]
"""Exposures (buckets, pixels) in electrons, and saturation marks (`nscc_runtime.effects.marks`)."""

CELLS = 1 << 21
"""Largest number of slots x pixels that are processed at once, in about ten arrays of that size."""
START = 0
"""Random stream of register contents at the start of a frame; effects have streams from 1."""


def readout_waits_s(container: Container) -> NDArray[np.float64]:
    """Return the waiting time (buckets,) in seconds: readouts happen one after the other."""
    order = {readout.bucket: i for i, readout in enumerate(container.readouts)}
    readout_us = container.target.readout_us
    return np.array([order[b] * readout_us * 1e-6 for b in container.buckets], np.float64)


def most_destinations(target: Target) -> int:
    """Return the difference between the draw numbers of consecutive words.

    Draws of errors are numbered by word and destination. The result is a power of two of at least
    the largest number of destinations, so that a target's own words rarely change other draws."""
    rows = (*OPERATIONS, *target.words)
    most = max(row.destinations[1] or 0 for row in rows if row.effect is WordEffect.BUS)
    return 1 << (most - 1).bit_length()


def in_rows(
    fall: Callable[[range], Fallen],
    run: Callable[[range, Fallen], Marked],
    rows: range,
    shape: tuple[int, int, int],
    threads: int | None,
) -> Exposure:
    """Return the exposure of consecutive rows of a frame, computed in strips of rows.

    `fall` returns the charge of a strip, and `run` its exposures. `shape`: buckets, cols, and the
    number of slots or intervals that are processed at once."""
    buckets, cols, slots = shape
    exposure = np.empty((buckets, len(rows), cols))
    saturated_by = np.empty(exposure.shape, np.uint8)
    valid = np.empty((len(rows), cols), np.bool_)

    def fill(strip: range) -> None:
        fallen = fall(strip)
        strip_exposure, marked = run(strip, fallen)
        chunk = slice(strip.start - rows.start, strip.stop - rows.start)
        exposure[:, chunk] = strip_exposure.reshape(-1, len(strip), cols)
        saturated_by[:, chunk] = marked.reshape(-1, len(strip), cols)
        valid[chunk] = fallen.valid

    in_strips(fill, rows, CELLS // (slots * cols), threads_of(threads))
    return Exposure(exposure, np.isfinite(exposure) & valid, saturated_by)


def converted_frames(
    expose: Callable[[int], Exposure],
    container: Container,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    count: int,
) -> Iterator[Frame]:
    """Yield frames 0 to `count` - 1 with converter codes; `seeds`: noise seed, device seed."""
    for number in range(count):
        yield converted(expose(number), container.target, sensor, effects, seeds, number)


@dataclass(eq=False, kw_only=True)
class WordPixels(Pixels):
    """The contents of some pixels while the words of one frame run. All arrays are (pixels,)."""

    container: Container
    effects: Selection

    def __post_init__(self) -> None:
        self.begin()
        names = ("PIX", *self.target.analog_registers)
        start = {name: self.arbitrary(i) for i, name in enumerate(names)}
        # Values well inside the range, so that reading an unwritten register causes a large error.
        self.charge = start.pop("PIX") * self.sensor.full_well_e / 2
        self.register = {name: u * self.sensor.register_max_e / 2 for name, u in start.items()}
        self.resets = Resets(self.effects, len(self.places))
        self.marks = Marks(self.effects, self.sensor, (*names, "IN"), len(self.places))

    def begin(self) -> None:
        """Look up everything that does not depend on pixels, such as the effects of each stage."""
        self.at, self.target = self.effects.at, self.container.target
        self.most = most_destinations(self.target)
        self.errors_at = {
            effect.name: error_part.at for effect, error_part in self.effects.having(Errors)
        }

    def arbitrary(self, group: int) -> Values:
        """Return uniform numbers (pixels,) of the chip for the initial values of a register."""
        return uniforms(key(self.device_seed, START, group=group), self.places)

    @abstractmethod
    def draw(self, name: str, number: int) -> Values:
        """Return the standard normal error (pixels,) of an effect in draw `number` of its words."""

    def error(self, name: str, word: Word, destination: int = 0) -> Values:
        number = word.number
        if self.errors_at.get(name) == "words":
            number = number * self.most + destination
        return self.draw(name, number)

    def fall(self, charge: Values) -> None:
        """Add charge to PIX."""
        self.charge = self.marks.fallen(self, self.charge + charge)

    def hold(self, seconds: float) -> None:
        """Let registers leak for a time in seconds."""
        for decay in self.at("hold"):
            remaining = decay(self, seconds)
            self.register = {name: value * remaining for name, value in self.register.items()}

    def reset(self, word: RunningWord, acting: Bits) -> None:
        """Reset PIX in the pixels of the mask `acting`."""
        self.charge = np.where(acting, 0.0, self.charge)
        self.marks.empty(acting)
        self.resets.reset(self, acting, word, word.boundary)

    def total(self, word: RunningWord) -> Values:
        """Return the sum of a word's sources in electrons."""
        total = np.zeros(len(self.places))
        for name in word.op.sources:
            if name == "IN":
                total += word.in_e
            elif name == "PIX":
                level = self.resets.read_level(self, self.charge, word, word.boundary)
                for read in self.at("reads"):
                    level = read(self, level, word)
                total += level
            else:
                total += self.source(name)
        return total

    def source(self, name: str) -> Values:
        """Return the value in electrons that a word reads from an analog register."""
        return self.register[name]

    def bus(self, word: RunningWord, acting: Bits) -> None:
        """Write -(sum of a word's sources) / divisor to its destinations where `acting`."""
        result, at = self.total(word) / -word.op.operation.divisor, word.boundary
        full, lost_e = self.marks.gathered(word.op, self.resets.unseen(at), self.resets.lit(at))
        for index, name in enumerate(word.op.destinations):
            value = result
            for written in self.at("words"):
                value = written(self, value, word, index, error_sign(name, self.container))
            value, lost_in_register_e = self.marks.clip_register(self, value, lost_e)
            self.register[name] = np.where(acting, value, self.register[name])
            self.marks.write(name, acting, full, lost_in_register_e)

    def read_out(self) -> Marked:
        """Return the exposures of the frame and their saturation marks."""
        exposures = np.empty((len(self.container.buckets), len(self.places)))
        marked = np.empty(exposures.shape, np.uint8)
        stays = self.container.pictures is not None  # readout follows the words of images
        for order, readout in enumerate(self.container.readouts):
            value = self.register[readout.register] * readout.gain
            for decay in () if stays else self.at("hold"):
                value = value * decay(self, order * self.target.readout_us * 1e-6)
            bucket = self.container.buckets.index(readout.bucket)
            for leaves in () if stays else self.at("readout"):
                value = leaves(self, value, bucket)
            exposures[bucket] = value + 0.0  # -0 + 0 is +0
            marked[bucket] = self.marks.read_out(readout.register, readout.gain)
        return exposures, marked
