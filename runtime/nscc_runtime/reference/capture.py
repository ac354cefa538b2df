"""The reference: the words of a program executed slot by slot in float64, with sensor effects.

A frame starts with arbitrary values in PIX and the analog registers, determined by the device seed.
The charge of slot n reaches PIX between boundaries n and n + 1. PIX counts relative to its reset
level. All random numbers are keyed (`nscc_runtime.noise`), so a draw depends neither on the other
effects nor on how the array is cut into rows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from math import inf

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.words.container import Container
from nscc_runtime.effects import Selection, everything
from nscc_runtime.effects.parts import Errors, Leak, WordGain
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.emulator.capture import check
from nscc_runtime.frame_file import Frame
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.noise import key, normals
from nscc_runtime.reference.charge import Fallen, Groups, charge_of_rows
from nscc_runtime.reference.stream import expose_stream
from nscc_runtime.reference.trace import AnalogWord, analog_words, retention_us
from nscc_runtime.reference.weights import (
    Backward,
    ByName,
    WeightModel,
    Weights,
    backward,
    orthonormal,
)
from nscc_runtime.reference.words import (
    Marked,
    WordPixels,
    converted_frames,
    in_rows,
    most_destinations,
)

SUM, PART = 0, 1
"""Source numbers in random keys: the draw z of a bucket (SUM), the draw x of a word (PART)."""


@dataclass
class SpreadNoise:
    """The normal errors of one effect in one frame at some pixels. Their weighted sum in each
    bucket is one draw. `weights`: orthonormal weights by draw number. `lanes`, `pixels` (P,): the
    lane and the place of each pixel.

    Let e be the standard normal errors of the words, and Q the orthonormal weights of the buckets.
    Then e = x + Q (z - Q^T x), where x is drawn for each word and z for each bucket. The errors e
    are independent, and Q^T e = z for any words: a plan that needs only the sum draws only z."""

    seed: int
    stream: int
    frame: int
    weights: Mapping[int, Weights]
    buckets: int
    lanes: NDArray[np.intp]
    pixels: NDArray[np.int64]
    _missing: list[NDArray[np.float64]] = field(init=False)

    def __post_init__(self) -> None:
        """Draw z for each bucket, and subtract the contribution Q^T x of the words' draws."""
        self._missing = [
            normals(self._key(SUM, bucket), self.pixels) for bucket in range(self.buckets)
        ]
        for number, weight in self.weights.items():
            lane_weights = weight[self.lanes]
            word_draw = normals(self._key(PART, number), self.pixels)
            for bucket, missing in enumerate(self._missing):
                missing -= lane_weights[:, bucket] * word_draw

    def draw(self, number: int) -> NDArray[np.float64]:
        """Return the standard normal error (P,) of draw `number`."""
        error = normals(self._key(PART, number), self.pixels)
        weight = self.weights.get(number)
        if weight is not None:
            lane_weights = weight[self.lanes]
            for bucket, missing in enumerate(self._missing):
                error = error + lane_weights[:, bucket] * missing
        return error

    def _key(self, source: int, group: int) -> np.uint64:
        return key(self.seed, self.stream, source, self.frame, group)


Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Reference:
    """A program prepared for simulation with the given effects.

    `words`: its analog words. `groups`: its groups of slots. `draws`: the weights of small errors
    in its exposures, by kind (`nscc_runtime.effects.parts.Errors.at`) and draw number."""

    container: Container
    sensor: Sensor
    effects: Selection
    words: tuple[AnalogWord, ...]
    groups: Groups
    draws: Mapping[str, ByName[int]]

    @classmethod
    def of(cls, container: Container, sensor: Sensor, effects: Selection) -> Reference:
        """Prepare a program. Raises Rejected if its words open no shutters (NS0442) or fail."""
        if container.pixel_codes is None:
            raise ValueError("a container without pixels")
        fresh = analog_words(container)
        opened = backward(container, fresh).open()
        bits = np.int64(1) << np.arange(len(container.buckets), dtype=np.int64)
        # Decay may change where words act; draws stay those of the words without decay.
        kept_us = retention_us(effects, sensor)
        words = fresh if kept_us == inf else analog_words(container, kept_us)
        # Use the sensor's gain and leakage even if these are off: draws then stay the same.
        gain, leak = everything().require_part(WordGain), everything().require_part(Leak)
        model = WeightModel(gain.gain(sensor), 1.0 / leak.tau_s(sensor))
        weights = backward(container, fresh, model)
        errors = numbered_errors(container.target, weights)
        draws = {at: orthonormal(error_weights) for at, error_weights in errors.items()}
        lane = container.table.shutter_of_code[container.pixel_codes].astype(np.intp)
        groups = Groups(np.ascontiguousarray((opened @ bits).T), lane)
        return cls(container, sensor, effects, words, groups, draws)

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
            return charge_of_rows(
                scene, self.groups, self.sensor, self.effects, seeds, frame, part_rows
            )

        def run(part_rows: range, fallen: Fallen) -> Marked:
            pixels = _FixedShutterPixels(
                sensor=self.sensor, seed=seed, device_seed=device_seed, frame=frame,
                places=self.groups.places_of(part_rows), container=self.container,
                effects=self.effects, program=self,
                lanes=self.groups.lane[part_rows.start : part_rows.stop].reshape(-1),
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


def numbered_errors(target: Target, weights: Backward) -> dict[str, ByName[int]]:
    """Return the weights of small errors by kind ("reads", "resets" or "words") and draw number."""
    most = most_destinations(target)
    words = weights.errors.renamed(lambda name: name[0] * most + name[1])
    return {"reads": weights.reads, "resets": weights.resets, "words": words}


@dataclass(eq=False, kw_only=True)
class _FixedShutterPixels(WordPixels):
    """Some pixels of a program with fixed shutters, during one frame. `lanes`: shape (pixels,)."""

    program: Reference
    lanes: NDArray[np.intp]

    def __post_init__(self) -> None:
        super().__post_init__()
        self.noise = {
            effect.name: SpreadNoise(
                self.seed, effect.stream, self.frame, self.program.draws[error_part.at],
                len(self.container.buckets), self.lanes, self.places,
            )
            for effect, error_part in self.effects.having(Errors)
        }  # fmt: skip

    def draw(self, name: str, number: int) -> Values:
        return self.noise[name].draw(number)

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
