"""The reference: the words of a program executed slot by slot in float64, with sensor effects.

A frame starts with arbitrary values in PIX and the analog registers, determined by the device seed.
The charge of slot n reaches PIX between boundaries n and n + 1. PIX counts relative to its reset
level. All random numbers are keyed (`nscc_runtime.noise`), so a draw depends neither on the other
effects nor on how the array is cut into rows."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.emulator.capture import check
from nscc_runtime.frame_file import Frame
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.reference.charge import Fallen, charge_of_rows, places_of
from nscc_runtime.reference.stream import expose_stream
from nscc_runtime.reference.trace import AnalogWord, analog_words, retention_us
from nscc_runtime.reference.weights import backward
from nscc_runtime.reference.words import Marked, WordPixels, converted_frames, in_rows

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Reference:
    """A program prepared for simulation with the given effects.

    `words`: its analog words. `lane` (rows, cols): the lane (code number) of each pixel."""

    container: Container
    sensor: Sensor
    effects: Selection
    words: tuple[AnalogWord, ...]
    lane: NDArray[np.intp]

    @classmethod
    def of(cls, container: Container, sensor: Sensor, effects: Selection) -> Reference:
        """Prepare a program. Raises Rejected if its words open no shutters (NS0442) or fail."""
        if container.pixel_codes is None:
            raise ValueError("a container without pixels")
        fresh = analog_words(container)
        backward(container, fresh).open()
        kept_us = retention_us(effects, sensor)
        words = fresh if kept_us == inf else analog_words(container, kept_us)
        lane = container.table.shutter_of_code[container.pixel_codes].astype(np.intp)
        return cls(container, sensor, effects, words, lane)

    def expose(
        self, scene: Scene, seed: int = 0, device_seed: int = 0, frame: int = 0,
        threads: int | None = None,
    ) -> Exposure:  # fmt: skip
        """Return the exposure of frame `frame`, equal for all `threads` (None: all processors)."""
        rows = range(scene.light.shape[0])
        return self.expose_rows(scene, rows, seed, device_seed, frame, threads)

    def expose_rows(
        self, scene: Scene, rows: range, seed: int = 0, device_seed: int = 0, frame: int = 0,
        threads: int | None = None,
    ) -> Exposure:  # fmt: skip
        """Return the exposure of consecutive rows, identical to these rows of the whole frame."""
        seeds = seed, device_seed

        def fall(part_rows: range) -> Fallen:
            return charge_of_rows(scene, self.sensor, self.effects, seeds, frame, part_rows)

        def run(part_rows: range, fallen: Fallen) -> Marked:
            pixels = _FixedShutterPixels(
                sensor=self.sensor, seed=seed, device_seed=device_seed, frame=frame,
                places=places_of(part_rows, self.lane.shape[1]), container=self.container,
                effects=self.effects, program=self,
                lanes=self.lane[part_rows.start : part_rows.stop].reshape(-1),
            )  # fmt: skip
            return pixels.run(fallen.charge.reshape(self.container.slots, -1))

        shape = len(self.container.buckets), scene.light.shape[1], self.container.slots
        return in_rows(fall, run, rows, shape, threads)


def expose(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: Selection,
    *,
    seed: int = 0,
    device_seed: int = 0,
    frame: int = 0,
    threads: int | None = None,
) -> Exposure:
    """Run the words of `container` over `light` with the `effects` of `sensor`, slot by slot, in
    float64.

    `frame`: number of the repeat of the scene. `threads`: None for all processors; results do not
    depend on it. Raises Rejected like `nscc_runtime.emulator.expose`, and NS0442 for words that
    open no shutters."""
    check(container, light)
    scene = scene_of(container, light)
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
    threads: int | None = None,
) -> Iterator[Frame]:
    """Yield frames 0 to `count` - 1 of `light` with converter codes, exposed like `expose`, also of
    chips without logic. Raises Rejected, before the first frame, for programs and light that cannot
    run."""
    check(container, light)
    scene, seeds = scene_of(container, light), (seed, device_seed)
    streamed = container.target.streamed
    reference = None if streamed else Reference.of(container, sensor, effects)

    def expose(number: int) -> Exposure:
        if reference is None:
            return expose_stream(container, scene, sensor, effects, seeds, number, threads)
        return reference.expose(scene, *seeds, number, threads)

    return converted_frames(expose, container, sensor, effects, seeds, count)


def scene_of(container: Container, light: Light) -> Scene:
    """Return the light of a frame and of an equal previous frame, in a program's slots."""
    return Scene(light, light, container.slot_s)


@dataclass(eq=False, kw_only=True)
class _FixedShutterPixels(WordPixels):
    """Some pixels of a program with fixed shutters, during one frame. `lanes`: shape (pixels,)."""

    program: Reference
    lanes: NDArray[np.intp]

    def run(self, charge: Values) -> Marked:
        """Return exposures and saturation marks for `charge` (N, pixels) in electrons."""
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
                    self.fall(charge[slot] * (now - fallen))
                    fallen = now
                acting = word.lanes[self.lanes]
                if acting.any():
                    run = self.reset if word.resets else self.bus
                    run(word, acting)
                word = next(words, None)
            if n < slots:
                self.fall(charge[n] * (1.0 - fallen) if fallen else charge[n])
                self.hold(self.container.slot_us[n] * 1e-6)
        return self.read_out()
