"""Frames of programs with images and planes: the exposure, then the words that follow it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Op
from nscc.words.container import Container
from nscc.words.legality import picture_words
from nscc.words.pictures import Pictures, Report
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.frame_file import Frame, check_adc, converted
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pixels import RANGE_BIT, ArrayPixels
from nscc_runtime.sensor import default_sensor

FrameArrays = dict[str, NDArray[Any]]


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
        default_values, full_values = (
            default_sensor(variant).values for variant in (target, replace(target, readout="full"))
        )
        sensor_values = self.sensor.values
        changed = {
            name: full_values[name]
            for name in full_values
            if sensor_values[name] == default_values[name] != full_values[name]
        }
        return self.sensor.changed(**changed)

    def frames(self, light: Light, seed: int, device_seed: int, count: int) -> Iterator[Frame]:
        """Frames 0 .. `count` - 1 of `light`."""
        check_adc(self.container.target)
        for number in range(count):
            exposure = self._exposed(light, seed, device_seed, number)
            yield self.frame_of(exposure, (seed, device_seed), number)

    def _exposed(self, light: Light, seed: int, device_seed: int, number: int) -> Exposure:
        if self.effects.noiseless:
            from nscc_runtime.emulator import expose

            return expose(self.container, light, device_seed=device_seed, threads=self.threads)
        from nscc_runtime.reference.capture import expose as expose_slots

        return expose_slots(
            self.container, light, self.sensor, self.effects,
            seed=seed, device_seed=device_seed, frame=number, threads=self.threads,
        )  # fmt: skip

    def frame_of(self, exposure: Exposure, seeds: tuple[int, int], number: int) -> Frame:
        """What the words after an exposure make of it, and what is then read out."""
        pixels = self._computed(exposure, seeds, number)
        pictures, buckets = self.pictures, list(self.container.buckets)
        valid = np.asarray(exposure.valid.all(axis=0))
        arrays: FrameArrays = {}
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
        for name, values, frame in self._converted(images, read, valid, seeds, number):
            arrays[f"image_{name}"] = values
            arrays[f"image_codes_{name}"] = frame.frame[0]
            arrays[f"image_saturated_by_{name}"] = frame.saturated_by[0]
        margin = np.zeros(pixels.shape, np.bool_)
        for name in pictures.wanted:
            margin |= pixels.tainted[pictures.registers[name]].reshape(pixels.shape)
        for name in pictures.reads:
            if name not in read:
                bits = pixels.digital.read(pictures.registers[name]) == 1
                arrays[f"plane_{name}"] = bits.reshape(pixels.shape)
        for report in pictures.reports:
            register = pictures.registers[report.plane]
            bits = (pixels.digital.read(register) == 1) & ~pixels.tainted[register]
            arrays |= reported(report, bits.reshape(pixels.shape))
        arrays["margin"] = margin
        read_buckets = [name for name in read if name in buckets]
        frame = self._bucket_frame(read_buckets, read, valid, seeds, number)
        return replace(frame, told=arrays)

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
    ) -> Iterator[tuple[str, NDArray[np.float64], Frame]]:  # fmt: skip
        """Images with what the converter makes of them, one after the other."""
        target = replace(self.container.target, readout="full")
        buckets = len(self.container.buckets)
        for index, name in enumerate(names):
            values, marks = read[name]
            # The draws of a converter go by the place in the array: behind those of the buckets.
            place = buckets + index
            shape = (place + 1, *valid.shape)
            stack, stacked = np.zeros(shape), np.zeros(shape, np.uint8)
            stack[place], stacked[place] = values, marks
            exposure = Exposure(stack, np.broadcast_to(valid, shape), stacked)
            frame = converted(exposure, target, self._image_sensor, self.effects, seeds, number)
            image_slice = slice(place, place + 1)
            yield (
                name,
                values,
                Frame(
                    frame.frame[image_slice],
                    stack[image_slice],
                    frame.valid[image_slice],
                    frame.saturated_by[image_slice],
                ),
            )

    def _computed(self, exposure: Exposure, seeds: tuple[int, int], number: int) -> ArrayPixels:
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
            code={name: plane.reshape(-1) for name, plane in container.planes().items()},
            shape=(shape[0], shape[1]), exposed=exposed, exposed_by=exposed_by,
        )  # fmt: skip
        pixels.run_words(self._words)
        return pixels


def reported(report: Report, bits: NDArray[np.bool_]) -> FrameArrays:
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
    coordinates = np.full((report.most, 2), -1, np.int32)
    count = min(len(rows), report.most)
    coordinates[:count, 0], coordinates[:count, 1] = cols[:count], rows[:count]
    return {
        name: coordinates,
        f"{name}_count": np.array(count, np.int32),
        f"{name}_overflow": np.array(len(rows) > report.most),
    }
