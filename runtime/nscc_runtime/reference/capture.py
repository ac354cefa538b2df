"""The reference: the words of a program executed slot by slot in float64, with sensor effects.

A frame starts with arbitrary values in PIX and the analog registers, fixed by the device seed. The
charge of slot n falls on PIX between boundaries n and n + 1. PIX counts from its reset level, which
is the zero of the scale. Everything random is keyed (`nscc_runtime.noise`), so neither the chunks
of rows nor the other effects change a draw.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import inf

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.operations import OPERATIONS, Effect
from nscc.words.container import Container
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Errors, Leak, WordGain
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels, Scene, Word
from nscc_runtime.emulator.capture import check
from nscc_runtime.frame_file import Frame, converted
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.noise import key, uniforms
from nscc_runtime.pool import in_strips, threads_of
from nscc_runtime.reference.charge import Groups, charge_of_rows
from nscc_runtime.reference.marks import Marks
from nscc_runtime.reference.noise import SpreadNoise
from nscc_runtime.reference.resets import Resets
from nscc_runtime.reference.trace import AnalogWord, analog_words, retention_us
from nscc_runtime.reference.weights import (
    Backward,
    ByName,
    Model,
    backward,
    error_sign,
    orthonormal,
)

Values = NDArray[np.float64]

_CELLS = 1 << 21
"""Most slots x pixels in work at once: some ten arrays of that size are alive then."""
START = 0
"""The stream of what registers hold when a frame starts; effects have streams from 1."""


def readout_waits_s(container: Container) -> NDArray[np.float64]:
    """How long values of buckets (buckets,) wait for their readouts, one after the other."""
    order = {readout.bucket: i for i, readout in enumerate(container.readouts)}
    readout_us = container.target.readout_us
    return np.array([order[b] * readout_us * 1e-6 for b in container.buckets], np.float64)


def most_destinations(target: Target) -> int:
    """By how much the numbers of the draws of two words differ: at least what a word writes.

    Draws of errors are numbered word by word, destination by destination; by a power of two, so
    that few words of a target's own change the draws of the others.
    """
    rows = (*OPERATIONS, *target.words)
    most = max(row.destinations[1] or 0 for row in rows if row.effect is Effect.BUS)
    return 1 << (most - 1).bit_length()


@dataclass(frozen=True, eq=False)
class Reference:
    """A program made ready: its words, its groups of slots, and `draws`, how small errors (by
    where they are made, as `nscc_runtime.effects.parts.Errors` has it) reach its exposures.
    """

    container: Container
    sensor: Sensor
    effects: Selection
    words: tuple[AnalogWord, ...]
    groups: Groups
    draws: Mapping[str, ByName[int]]

    @classmethod
    def of(cls, container: Container, sensor: Sensor, effects: Selection) -> Reference:
        """Raises Rejected where the words open no shutters (NS0442) or cannot run."""
        if container.pixel_codes is None:
            raise ValueError("a container without pixels")
        fresh = analog_words(container)
        opened = backward(container, fresh).open()
        bits = np.int64(1) << np.arange(len(container.buckets), dtype=np.int64)
        # After decay other lanes may act; the draws stay those of the words as they were meant.
        kept_us = retention_us(effects, sensor)
        words = fresh if kept_us == inf else analog_words(container, kept_us)
        # The sensor's gain and leakage, on or off: no effect changes the draws of another.
        gain, leak = everything().the(WordGain), everything().the(Leak)
        model = Model(gain.gain(sensor), 1.0 / leak.tau_s(sensor))
        weights = backward(container, fresh, model)
        errors = numbered_errors(container.target, weights)
        draws = {at: orthonormal(found) for at, found in errors.items()}
        lane = container.table.shutter_of_code[container.pixel_codes].astype(np.intp)
        groups = Groups(np.ascontiguousarray((opened @ bits).T), lane)
        return cls(container, sensor, effects, words, groups, draws)

    @cached_property
    def errors_at(self) -> dict[str, str]:
        """Where the effects that have small errors make them."""
        return {effect.name: part.at for effect, part in self.effects.having(Errors)}

    def expose(
        self, scene: Scene, seed: int = 0, device_seed: int = 0, frame: int = 0,
        threads: int | None = None,
    ) -> Exposure:  # fmt: skip
        """Frame number `frame` of a scene; `threads`, None for all processors, change no bit."""
        rows = range(scene.light.shape[0])
        return self.expose_rows(scene, rows, seed, device_seed, frame, threads)

    def expose_rows(
        self, scene: Scene, rows: range, seed: int = 0, device_seed: int = 0, frame: int = 0,
        threads: int | None = None,
    ) -> Exposure:  # fmt: skip
        """Consecutive rows of a frame, bit for bit as the whole frame has them."""
        container = self.container
        cols = scene.light.shape[1]
        exposure = np.empty((len(container.buckets), len(rows), cols))
        valid = np.empty((len(rows), cols), np.bool_)
        saturated_by = np.empty(exposure.shape, np.uint8)

        def fill(part: range) -> None:
            fallen = charge_of_rows(
                scene, self.groups, self.sensor, self.effects, (seed, device_seed), frame, part
            )
            chunk = slice(part.start - rows.start, part.stop - rows.start)
            pixels = _Pixels(
                sensor=self.sensor, seed=seed, device_seed=device_seed, frame=frame,
                places=self.groups.places_of(part), program=self,
                lanes=self.groups.lane[part.start : part.stop].reshape(-1),
            )  # fmt: skip
            found, marked = pixels.run(fallen.charge.reshape(container.slots, -1))
            exposure[:, chunk] = found.reshape(-1, len(part), cols)
            saturated_by[:, chunk] = marked.reshape(-1, len(part), cols)
            valid[chunk] = fallen.valid

        in_strips(fill, rows, _CELLS // (container.slots * cols), threads_of(threads))
        return Exposure(exposure, np.isfinite(exposure) & valid, saturated_by)


def expose(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: Selection,
    *,
    seed: int = 0,
    device_seed: int = 0,
    frame: int = 0,
    previous: Light | None = None,
    threads: int | None = None,
) -> Exposure:
    """Run `container`'s words over `light` with `effects` of `sensor`, slot by slot, in float64.

    `frame` numbers the repeats of a scene; `previous` is what the array saw in the frame before,
    the same light unless given. `threads`, by default as many as there are processors, change no
    bit. Raises Rejected as `nscc_runtime.emulator.expose` does, and NS0442
    for words that open no shutters.
    """
    check(container, light)
    scene = scene_of(container, light, previous)
    return Reference.of(container, sensor, effects).expose(scene, seed, device_seed, frame, threads)


def frames(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: Selection,
    *,
    seed: int = 0,
    device_seed: int = 0,
    count: int = 1,
    previous: Light | None = None,
    threads: int | None = None,
) -> Iterator[Frame]:
    """Frames 0 .. `count` - 1 of `light`, as `nscc_runtime.reference.expose` exposes them.

    What can be refused is refused before the first frame.
    """
    check(container, light)
    reference = Reference.of(container, sensor, effects)
    scene = scene_of(container, light, previous)
    return (
        converted(
            reference.expose(scene, seed, device_seed, number, threads), container.target, sensor,
            effects, (seed, device_seed), number,
        )
        for number in range(count)
    )  # fmt: skip


def scene_of(container: Container, light: Light, previous: Light | None = None) -> Scene:
    """The light of a frame, the one before it (the same unless given), the slots of a program."""
    if previous is not None:
        check(container, previous)
    return Scene(light, light if previous is None else previous, container.slot_s)


def numbered_errors(target: Target, weights: Backward) -> dict[str, ByName[int]]:
    """The weights of small errors, by where they are made and under the numbers of their draws."""
    most = most_destinations(target)
    words = weights.errors.renamed(lambda name: name[0] * most + name[1])
    return {"reads": weights.reads, "resets": weights.resets, "words": words}


@dataclass(eq=False, kw_only=True)
class _Pixels(Pixels):
    """Some pixels while the words of one frame run. All arrays are (pixels,)."""

    program: Reference
    lanes: NDArray[np.intp]

    def __post_init__(self) -> None:
        self.at = self.program.effects.at
        self.container = self.program.container
        self.most = most_destinations(self.container.target)
        names = ("PIX", *self.container.target.analog_registers)
        start = {
            name: uniforms(key(self.device_seed, START, group=i), self.places)
            for i, name in enumerate(names)
        }
        # Well inside the range, so that a program that reads what it has not written is far off.
        self.charge = start.pop("PIX") * self.sensor.full_well_e / 2
        self.register = {name: u * self.sensor.register_max_e / 2 for name, u in start.items()}
        self.resets = Resets(self.program.effects, len(self.places))
        self.marks = Marks(self.program.effects, self.sensor, (*names, "IN"), len(self.places))
        self.noise = {
            effect.name: SpreadNoise(
                self.seed, effect.stream, self.frame, self.program.draws[part.at],
                len(self.container.buckets), self.lanes, self.places,
            )
            for effect, part in self.program.effects.having(Errors)
        }  # fmt: skip

    def run(self, charge: Values) -> tuple[Values, NDArray[np.uint8]]:
        """The exposures (buckets, pixels) of a frame of `charge` (N, pixels), and what cut them off
        (`nscc_runtime.effects.marks`)."""
        slots = self.container.slots
        words = iter(self.program.words)
        word = next(words, None)
        for n in range(slots + 1):
            slot = min(n, slots - 1)
            fallen = 0.0
            while word is not None and word.boundary == n:
                for ends_us in self.at("time"):
                    now = ends_us(word) / self.container.slot_us[slot]
                    now = now if n == slots else min(now, 1.0)
                    self._fall(charge[slot] * (now - fallen))
                    fallen = now
                self._run(word)
                word = next(words, None)
            if n < slots:
                self._fall(charge[n] * (1.0 - fallen) if fallen else charge[n])
                for held in self.at("hold"):
                    kept = held(self, self.container.slot_us[n] * 1e-6)
                    for name in self.register:
                        self.register[name] = self.register[name] * kept
        return self._read_out()

    def error(self, name: str, word: Word, destination: int = 0) -> Values:
        number = word.number
        if self.program.errors_at[name] == "words":
            number = number * self.most + destination
        return self.noise[name].draw(number)

    def _fall(self, charge: Values) -> None:
        self.charge = self.marks.fallen(self, self.charge + charge)

    def _run(self, word: AnalogWord) -> None:
        here = word.lanes[self.lanes]
        if not here.any():
            return
        if word.resets:
            self.charge = np.where(here, 0.0, self.charge)
            self.marks.empty(here)
            self.resets.reset(self, here, word, word.boundary)
            return
        total = np.zeros(len(self.lanes))
        for name in word.op.sources:
            total = total + self._source(name, word)
        result = total / -word.op.operation.divisor
        at = word.boundary
        full, lost = self.marks.gathered(word.op, self.resets.unseen(at), self.resets.lit(at))
        for index, name in enumerate(word.op.destinations):
            value = result
            for written in self.at("words"):
                value = written(self, value, word, index, error_sign(name, self.container))
            value, lost_here = self.marks.held(self, value, lost)
            self.register[name] = np.where(here, value, self.register[name])
            self.marks.write(name, here, full, lost_here)

    def _source(self, name: str, word: AnalogWord) -> Values:
        if name == "IN":
            return np.zeros(len(self.lanes))
        if name != "PIX":
            return self.register[name]
        level = self.resets.found(self, self.charge, word, word.boundary)
        for found in self.at("reads"):
            level = found(self, level, word)
        return level

    def _read_out(self) -> tuple[Values, NDArray[np.uint8]]:
        exposures = np.empty((len(self.container.buckets), len(self.lanes)))
        marked = np.empty(exposures.shape, np.uint8)
        stays = self.container.pictures is not None  # images are made of it before readout
        for order, readout in enumerate(self.container.readouts):
            value = self.register[readout.register] * readout.gain
            for held in () if stays else self.at("hold"):
                value = value * held(self, order * self.container.target.readout_us * 1e-6)
            bucket = self.container.buckets.index(readout.bucket)
            for leaves in () if stays else self.at("readout"):
                value = leaves(self, value, bucket)
            # -0 + 0 is +0.
            exposures[bucket] = value + 0.0
            marked[bucket] = self.marks.read_out(readout.register, readout.gain)
        return exposures, marked
