"""Frames of programs with images and planes: the exposure, then the words that follow it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import repeat
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Op
from nscc.words.container import Container
from nscc.words.legality import picture_words
from nscc.words.pictures import Pictures, PlaneReport
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.frame_file import Frame, check_adc, converted
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pixels import RANGE_BIT, ArrayPixels
from nscc_runtime.reference.trace import retention_us
from nscc_runtime.sensor import default_sensor

Told = dict[str, NDArray[Any]]
Planes = dict[str, NDArray[np.bool_]]
"""Bits (pixels,) by register."""


@dataclass(frozen=True, eq=False)
class KeptBits:
    """The registers of states from one frame to the next, and where they depend on what is beyond
    the array."""

    bits: Planes
    tainted: Planes


@dataclass(frozen=True, eq=False)
class PicturedProgram:
    """A container with images and planes, made ready for a sensor and a set of effects."""

    container: Container
    sensor: Sensor
    effects: Selection
    threads: int | None = None

    @property
    def pictures(self) -> Pictures:
        """What is computed."""
        assert self.container.pictures is not None
        return self.container.pictures

    @cached_property
    def _words(self) -> list[tuple[Op, int | None]]:
        return picture_words(self.container)

    @cached_property
    def _image_sensor(self) -> Sensor:
        """The sensor where an image is converted: codes are symmetric around 0, not spread."""
        target = self.container.target
        own, full = (
            default_sensor(each).values for each in (target, replace(target, readout="full"))
        )
        given = self.sensor.values
        changed = {name: full[name] for name in full if given[name] == own[name] != full[name]}
        return self.sensor.changed(**changed)

    def frames(self, light: Light, seed: int, device_seed: int, count: int) -> Iterator[Frame]:
        """Frames 0 .. `count` - 1 of `light`, one after the other: states go on."""
        return self.film(repeat(light, count), seed, device_seed)

    def film(self, lights: Iterable[Light], seed: int, device_seed: int) -> Iterator[Frame]:
        """A frame of each light, one after the other: states go on."""
        check_adc(self.container.target)
        kept = self._at_start(self.container.target.rows * self.container.target.cols)
        for number, light in enumerate(lights):
            exposure = self._exposed(light, seed, device_seed, number)
            pixels = self._computed(exposure, (seed, device_seed), number, kept)
            yield self._frame_of(pixels, exposure, (seed, device_seed), number)
            kept = self._kept_of(pixels)

    def _at_start(self, pixels: int) -> KeptBits:
        """What the host loads once."""
        registers = {s.name: self.pictures.registers[s.name] for s in self.pictures.states}
        bits = {registers[s.name]: np.full(pixels, s.start) for s in self.pictures.states}
        return KeptBits(bits, {name: np.zeros(pixels, np.bool_) for name in bits})

    def _kept_of(self, pixels: ArrayPixels) -> KeptBits:
        """The states at the next frame's words: lost where its exposure and the readouts take
        longer than registers keep their bits."""
        container, pictures = self.container, self.pictures
        names = [pictures.registers[state.name] for state in pictures.states]
        values_read = sum(name not in pictures.planes for name in pictures.reads)
        between_us = sum(container.slot_us) + values_read * container.target.readout_us
        is_kept = between_us <= retention_us(self.effects, self.sensor)
        return KeptBits(
            {name: (pixels.digital.read(name) == 1) & is_kept for name in names},
            {name: pixels.tainted[name] for name in names},
        )

    def _exposed(self, light: Light, seed: int, device_seed: int, number: int) -> Exposure:
        if self.effects.noiseless:
            from nscc_runtime.emulator import expose

            return expose(self.container, light, device_seed=device_seed, threads=self.threads)
        from nscc_runtime.reference.capture import expose as expose_slots

        return expose_slots(
            self.container, light, self.sensor, self.effects,
            seed=seed, device_seed=device_seed, frame=number, threads=self.threads,
        )  # fmt: skip

    def _frame_of(
        self, pixels: ArrayPixels, exposure: Exposure, seeds: tuple[int, int], number: int
    ) -> Frame:
        """What is read out after the last word."""
        pictures, buckets = self.pictures, list(self.container.buckets)
        valid = np.asarray(exposure.valid.all(axis=0))
        told: Told = {}
        wait_s = self.container.target.readout_us * 1e-6
        pixels.hold(pixels.after_us * 1e-6)
        read: dict[str, tuple[NDArray[np.float64], NDArray[np.uint8]]] = {}
        for name in pictures.reads:
            register = pictures.registers[name]
            if register not in pixels.register:
                continue
            values = pixels.register[register].reshape(pixels.shape) + 0.0  # -0 + 0 is +0
            read[name] = values, pixels.cut_by[register].reshape(pixels.shape)
            pixels.hold(wait_s)
        images = [name for name in read if name not in buckets]
        if images:
            codes, saturated_by = self._converted(images, read, valid, seeds, number)
        for index, name in enumerate(images):
            told[f"image_{name}"] = read[name][0]
            told[f"image_codes_{name}"] = codes[index]
            told[f"image_saturated_by_{name}"] = saturated_by[index]
        margin = np.zeros(pixels.shape, np.bool_)
        for name in pictures.outputs:
            margin |= pixels.tainted[pictures.registers[name]].reshape(pixels.shape)
        for name in pictures.reads:
            if name not in read:
                bits = pixels.digital.read(pictures.registers[name]) == 1
                told[f"plane_{name}"] = bits.reshape(pixels.shape)
        for report in pictures.reports:
            register = pictures.registers[report.plane]
            bits = (pixels.digital.read(register) == 1) & ~pixels.tainted[register]
            told |= reported(report, bits.reshape(pixels.shape))
        told["margin"] = margin
        kept = [name for name in read if name in buckets]
        frame = self._bucket_frame(kept, read, valid, seeds, number)
        return replace(frame, told=told)

    def _bucket_frame(
        self, names: list[str], read: dict[str, Any], valid: NDArray[np.bool_],
        seeds: tuple[int, int], number: int,
    ) -> Frame:  # fmt: skip
        """The frame of the buckets that are read, which may be none."""
        shape = (len(names), *valid.shape)
        values, marks = np.zeros(shape), np.zeros(shape, np.uint8)
        for index, name in enumerate(names):
            values[index], marks[index] = read[name]
        exposure = Exposure(values, np.broadcast_to(valid, shape).copy(), marks)
        target = self.container.target
        if not names:
            empty = np.zeros(shape, np.uint8)
            return Frame(empty, values, exposure.valid, marks)
        return converted(exposure, target, self.sensor, self.effects, seeds, number)

    def _converted(
        self, names: list[str], read: dict[str, Any], valid: NDArray[np.bool_],
        seeds: tuple[int, int], number: int,
    ) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:  # fmt: skip
        """Codes and `saturated_by` (names, rows, cols) of images, by the converter that is
        symmetric around 0."""
        target = replace(self.container.target, readout="full")
        # The draws of a converter go by the place in the array: behind those of the buckets.
        buckets = len(self.container.buckets)
        shape = (buckets + len(names), *valid.shape)
        stack, stacked = np.zeros(shape), np.zeros(shape, np.uint8)
        for place, name in enumerate(names, buckets):
            stack[place], stacked[place] = read[name]
        exposure = Exposure(stack, np.broadcast_to(valid, shape), stacked)
        frame = converted(exposure, target, self._image_sensor, self.effects, seeds, number)
        return frame.frame[buckets:], frame.saturated_by[buckets:]

    def _computed(
        self, exposure: Exposure, seeds: tuple[int, int], number: int, kept: KeptBits
    ) -> ArrayPixels:
        """The array after the last word."""
        container, pictures = self.container, self.pictures
        shape = exposure.exposure_e.shape[1:]
        exposed, exposed_by = {}, {}
        for readout in container.readouts:
            index = container.buckets.index(readout.bucket)
            values = exposure.exposure_e[index].reshape(-1)
            marks = exposure.saturated_by
            by = np.zeros(values.shape, np.uint8) if marks is None else marks[index].reshape(-1)
            beyond = values > pictures.limits_e[readout.bucket] * (1 + 1e-9)
            exposed[readout.register] = values / readout.gain
            exposed_by[readout.register] = by | beyond.astype(np.uint8) * np.uint8(RANGE_BIT)
        pixels = ArrayPixels(
            sensor=self.sensor, seed=seeds[0], device_seed=seeds[1], frame=number,
            places=np.arange(shape[0] * shape[1], dtype=np.int64), container=container,
            effects=self.effects,
            code={name: plane.reshape(-1) for name, plane in container.planes().items()}
            | kept.bits,
            shape=(shape[0], shape[1]), exposed=exposed, exposed_by=exposed_by,
        )  # fmt: skip
        pixels.tainted |= kept.tainted
        pixels.run_words(self._words)
        return pixels


def reported(report: PlaneReport, bits: NDArray[np.bool_]) -> Told:
    """What the host is told of a plane (rows, cols).

    Events are (x, y) in reading order, -1 behind the last one; the box is the least and the largest
    x and y, -1 where no bit is 1.
    """
    name = f"report_{report.kind}_{report.plane}"
    if report.kind == "any":
        return {name: np.array(bits.any())}
    rows, cols = np.nonzero(bits)
    if report.kind == "box":
        box = [cols.min(), rows.min(), cols.max(), rows.max()] if rows.size else [-1] * 4
        return {name: np.array(box, np.int32)}
    found = np.full((report.most, 2), -1, np.int32)
    count = min(len(rows), report.most)
    found[:count, 0], found[:count, 1] = cols[:count], rows[:count]
    return {
        name: found,
        f"{name}_count": np.array(count, np.int32),
        f"{name}_overflow": np.array(len(rows) > report.most),
    }
