"""Simulate programs with images and planes: the exposure, then the words that follow it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import chain, repeat
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Array, Bools, Bytes, Floats
from nscc.chips.target import Target
from nscc.mappings import NamedValues
from nscc.operations import Op
from nscc.record import Record
from nscc.truth import unpacked_bits
from nscc.words.container import Container, state_registers
from nscc.words.cost import word_us
from nscc.words.legality import picture_words
from nscc.words.pictures import Pictures
from nscc.words.reach import Reach, beyond_reaches, reaches_of_frames
from nscc_runtime.caches import OfContainer
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.effects.in_loops import draws_keys, figures, patterns
from nscc_runtime.effects.views import whole_device
from nscc_runtime.emulator.array_loop import run_array_words
from nscc_runtime.emulator.array_words import ArrayWords, packed, unpacked
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.frame_file import Frame, check_adc, converted
from nscc_runtime.host_setting import HostSetting
from nscc_runtime.light import Light
from nscc_runtime.neighbours.plane_summary import PlaneSummary, report_of, reported
from nscc_runtime.reference.array_pixels import RANGE_BIT, ArrayPixels
from nscc_runtime.reference.trace import retention_us
from nscc_runtime.reference.words import most_destinations
from nscc_runtime.sensor import default_sensor


@dataclass(frozen=True, eq=False)
class ArrayContents:
    """The contents of registers after the words, by name.

    `register`: analog registers (rows, cols) in electrons. `cut_by`: their saturation marks, also
    (rows, cols), 0 where nothing saturated. `planes`: digital registers (rows, words of 64 pixels),
    as `unpacked` reads them. `leak_per_s`: leakage rate of each pixel (rows, cols)."""

    register: Mapping[str, Floats]
    cut_by: Mapping[str, Bytes]
    planes: Mapping[str, NDArray[np.uint64]]
    leak_per_s: Floats

    def bit(self, name: str) -> Bools:
        """Return the digital register called `name`, such as `R3`, as bits (rows, cols). Raises
        KeyError for other names."""
        return unpacked(self.planes[name], next(iter(self.register.values())).shape[1])

    def hold(self, seconds: float) -> None:
        """Let analog registers leak for a time in seconds."""
        if self.leak_per_s.any():
            kept = np.exp(-self.leak_per_s * seconds)
            for value in self.register.values():
                value *= kept


class PictureWords:
    """Words in the order of execution, prepared for arrays of a target. They may be run any number
    of times. `words`: as given. `after_us`: their duration in microseconds."""

    def __init__(self, target: Target, words: Sequence[tuple[Op, int | None]]) -> None:
        """Translate `words` to tables for the compiled loop. Each is an operation and the value of
        IN set before it, in steps of `target.electrons_per_step`; None leaves IN (the level sent to
        all pixels) as it was, at first 0."""
        self._target, self._table, self.words = target, ArrayWords(target), words
        self.after_us = sum(word_us(op, target) for op, _ in words)
        steps = 0
        self._table.append(
            (op, (steps := steps if level is None else level) * target.electrons_per_step)
            for op, level in words
        )
        self._rows, self._operands = self._table.table

    def run(
        self,
        shape: tuple[int, int],
        exposed: Mapping[str, Floats],
        exposed_by: Mapping[str, Bytes],
        code: Mapping[str, Bools],
        errors: Mapping[str, Any] = MappingProxyType({}),
    ) -> ArrayContents:
        """Return the contents of registers after the words, for an array of `shape` (rows, cols).

        Before the words, analog registers hold `exposed` (electrons) with the saturation marks
        `exposed_by`, which has the same names; digital registers hold the bits `code`. All map the
        name of a register to an array (pixels,), row after row. Other registers hold 0. `errors`:
        the effects that act on words, fields of `ArrayErrors` and `FixedPatterns` by name; without
        them there are none."""
        (rows, cols), table, analog = shape, self._table, self._target.analog_registers
        names, length, digital = (*analog, *_PATTERNS), cols + 1, table.digital
        array = table.shape(rows, cols, length, len(names), RANGE_BIT)
        state = table.state(array, self._operands)
        planes = state.planes.reshape(len(digital), rows, -1)
        register, cut_by = (
            dict(zip(names, inner.reshape(-1, rows + 1, length)[:, :-1, :cols], strict=True))
            for inner in (each[length : array.total] for each in (state.values, state.marks))
        )
        for name in state.errors.dtype.names or ():
            state.errors[name] = errors.get(name, 0)
        for name in {*errors} & {*_PATTERNS}:
            register[name][:] = errors[name].reshape(shape)
        for name, exposure in exposed.items():
            register[name][:] = exposure.reshape(shape)
            cut_by[name][:] = exposed_by[name].reshape(shape)
        for name, plane in code.items():
            planes[digital[name]] = packed(plane.reshape(shape))
        state.marked[0] = any(by.any() for by in exposed_by.values())
        run_array_words(shape=array, words=self._rows, state=state)
        planes_by_name = dict(zip(digital, planes, strict=True))
        leak_per_s = np.reshape(errors.get("leak_per_s", np.zeros(shape)), shape)
        return ArrayContents(register, cut_by, planes_by_name, leak_per_s)


_PATTERNS = "error_e", "offset_e"
"""Fixed patterns of `FixedPatterns` that words use; they are rows of values after the registers."""

Told = dict[str, Array]
Planes = dict[str, Bools]
"""Bits (pixels,) by register."""


class KeptRegisters(Record, eq=False):
    """What registers keep from frame to frame, all by name of a register and (pixels,).

    `bits`: the bits of states and input planes. `images`, `marks`: the electrons and the saturation
    marks of kept images; both have the same names."""

    bits: Planes
    images: Mapping[str, Floats] = MappingProxyType({})
    marks: Mapping[str, Bytes] = MappingProxyType({})

    @classmethod
    def at_start(cls, container: Container) -> KeptRegisters:
        """Return the registers that the host loads before the first frame: kept states, input
        planes and kept images with their declared starts, without saturation marks."""
        pictures, target = container.pictures, container.target
        shape, registers = (target.rows, target.cols), pictures.registers
        bits = {
            registers[name]: unpacked_bits(number, shape).reshape(-1)
            for name, number in pictures.held_planes.items()
        }
        images, marks = {}, {}
        for image in pictures.kept_images:
            # The words compute some images with the opposite sign; their registers begin with it.
            sign = -1 if image.name in pictures.negated else 1
            images[registers[image.name]] = np.full(target.rows * target.cols, sign * image.start_e)
            marks[registers[image.name]] = np.zeros(target.rows * target.cols, np.uint8)
        return cls(bits, images, marks)

    def with_inputs(self, container: Container, inputs: Mapping[str, Any]) -> KeptRegisters:
        """Return the registers after the host has loaded `inputs`: bits (rows, cols) by name of an
        input plane. Planes that are not named keep their bits. The caller has checked the names."""
        registers = container.pictures.registers
        loaded = {registers[name]: bits.reshape(-1) for name, bits in inputs.items()}
        return replace(self, bits=self.bits | loaded) if loaded else self


@dataclass(frozen=True, eq=False)
class PicturedProgram:
    """A container (a compiled program) with images and planes, prepared for a sensor and a set of
    effects.

    `threads`: number of threads (None: all processors); results do not depend on it. `by_words`:
    whether the reference simulates exposures with effects, instead of the faster loops."""

    container: Container
    sensor: Sensor
    effects: Selection
    threads: int | None = None
    by_words: bool = False

    @property
    def pictures(self) -> Pictures:
        """The images, planes and reports of the program."""
        return self.container.pictures

    @cached_property
    def _image_sensor(self) -> Sensor:
        """The sensor that converts images."""
        return image_sensor(self.sensor, self.container.target)

    def film(
        self,
        lights: Iterable[Light],
        seed: int,
        device_seed: int,
        settings: Sequence[HostSetting] = (),
    ) -> Iterator[Frame]:
        """Yield a frame of each light; states and kept images go on from frame to frame.

        `seed`: seed of the noise. `device_seed`: seed of the chip's fixed patterns. `settings`:
        what the host sets before each frame; the last one also holds for all later frames, and
        without any, parameters and input planes have their declared starts. Raises Rejected before
        the first frame if the converter has more bits than frames store (`check_adc`)."""
        check_adc(self.container.target)
        kept = KeptRegisters.at_start(self.container)
        settings = settings or (HostSetting.at_start(self.container),)
        params = chain((each.params for each in settings), repeat(settings[-1].params))
        # The cached reaches hold for the starts of parameters, which `settings` may change.
        first = None if self.pictures.params else _beyond_reaches(self.container)
        all_reaches = reaches_of_frames(self.container, first, params)
        previous: Light | None = None
        for number, light in enumerate(lights):
            reaches, seeds = next(all_reaches), (seed, device_seed)
            # A film of one light prepares it once.
            if light is not previous:
                expose, previous = self.exposer_of(light, device_seed), light
            exposure = expose(seed, number)
            setting = settings[min(number, len(settings) - 1)]
            kept = kept.with_inputs(self.container, setting.inputs)
            frame, kept = self.next_frame(exposure, kept, reaches, seeds, number, setting.params)
            yield frame

    def next_frame(
        self,
        exposure: Exposure,
        kept: KeptRegisters,
        reaches: Mapping[str, Reach] | None,
        seeds: tuple[int, int],
        number: int,
        params: Mapping[str, int] = MappingProxyType({}),
    ) -> tuple[Frame, KeptRegisters]:
        """Return frame `number` of a film (from 0), and what registers keep for the next frame.

        `exposure`: the frame's light in the buckets, before images are computed. `kept` is what the
        previous frame left; a register without bits in it contains its code bits. `seeds`: seed of
        the noise, then that of the device. `reaches`: by name of an output, how far around a pixel
        it depends on values outside the array; None for those of a first frame. `params`: values of
        parameters by name, by default their starts."""
        container, pictures = self.container, self.pictures
        pixels = self._computed(exposure, seeds, number, kept, params)
        frame = self._read_out_in_turn(pixels, exposure, seeds, number, reaches)
        # Bits of states are 0 if exposure and readouts take longer than registers keep them.
        # Planes take no time here: only readouts of values use the converter.
        values_read = sum(name not in pictures.planes for name in pictures.reads)
        between_us = sum(container.slot_us) + values_read * container.target.readout_us
        is_kept = between_us <= retention_us(self.effects, self.sensor)
        names = [pictures.registers[name] for name in pictures.held_planes]
        bits = {name: pixels.bit(name).reshape(-1) & is_kept for name in names}
        if not pictures.kept_images:
            return frame, KeptRegisters(bits)
        pixels.hold(sum(container.slot_us) * 1e-6)  # kept images leak during the next exposure
        images = [pictures.registers[image.name] for image in pictures.kept_images]
        values = {name: pixels.register[name].reshape(-1) for name in images}
        marks = {name: pixels.cut_by[name].reshape(-1) for name in images}
        return frame, KeptRegisters(bits, values, marks)

    def exposer_of(self, light: Light, device_seed: int) -> Callable[[int, int], Exposure]:
        """Return a function of (noise seed, frame number) that exposes a frame of `light`, without
        the words of images and planes. Without noise both arguments are ignored."""
        container, effects = self.container, self.effects
        if effects.without_effects:
            from nscc_runtime.emulator import expose

            return lambda _seed, _number: expose(
                container, light, device_seed=device_seed, threads=self.threads
            )
        from nscc_runtime.execution.frames import frame_source

        return frame_source(
            container, self.sensor, light, effects, device_seed, self.threads, self.by_words
        ).expose

    def _read_out_in_turn(
        self,
        pixels: ArrayPixels | ArrayContents,
        exposure: Exposure,
        seeds: tuple[int, int],
        number: int,
        reaches: Mapping[str, Reach] | None,
    ) -> Frame:
        """Read out the frame after the last word, and return it with images, planes and reports.

        The registers of `pixels` leak here, in place, while values are read one after the other,
        and reports follow from the decayed values. `exposure` tells only which pixels are valid.
        `seeds` are those of noise and device, `number` is that of the frame, and `reaches` tells
        which pixels depend on light beyond the array (None: as in a first frame)."""
        pictures, buckets = self.pictures, list(self.container.buckets)
        valid = np.asarray(exposure.valid.all(axis=0))
        told: Told = {}
        wait_s = self.container.target.readout_us * 1e-6
        read: dict[str, tuple[Floats, Bytes]] = {}
        # Readouts follow each other, and registers leak while they wait for theirs.
        for name in pictures.reads:
            register = pictures.registers[name]
            if register not in pixels.register:
                continue  # a plane: its register is digital, and `told_of_planes` reports it
            values = pixels.register[register].reshape(valid.shape) + 0.0  # -0 + 0 is +0
            read[name] = values, pixels.cut_by[register].reshape(valid.shape)
            pixels.hold(wait_s)
        # Buckets are converted like an exposure, and images in a range of their own, which has a
        # sign.
        images = [name for name in read if name not in buckets]
        if images:
            full = replace(self.container.target, readout="full")
            # The converter draws noise by index: images follow the buckets.
            exposure = _exposure_of(images, read, valid, len(buckets))
            frame = converted(exposure, full, self._image_sensor, self.effects, seeds, number)
        for index, name in enumerate(images, len(buckets)):
            told[f"image_{name}"] = read[name][0]
            told[f"image_codes_{name}"] = frame.frame[index]
            told[f"image_saturated_by_{name}"] = frame.saturated_by[index]
        planes = {
            name: pixels.bit(name).reshape(valid.shape) for name in state_registers(self.container)
        }
        told |= told_of_planes(self.container, planes, reaches)
        told |= sums_of_images(self.container, pixels.register, reaches)
        exposure = _exposure_of([name for name in read if name in buckets], read, valid)
        target = self.container.target
        frame = converted(exposure, target, self.sensor, self.effects, seeds, number)
        return replace(frame, told=told)

    def _computed(
        self,
        exposure: Exposure,
        seeds: tuple[int, int],
        number: int,
        kept: KeptRegisters,
        params: Mapping[str, int],
    ) -> ArrayPixels | ArrayContents:
        """Return the registers of all pixels after the words of images and planes.

        `exposure`: the light in the buckets, with which their registers begin. `seeds`: of noise
        and device. `number`: number of the frame. `kept`: the registers that the frame before left.
        `params`: values of parameters by name, in steps of IN."""
        container, pictures = self.container, self.pictures
        shape = exposure.exposure_e.shape[1:]
        exposed, exposed_by = {}, {}
        for readout in container.readouts:
            index = container.buckets.index(readout.bucket)
            values = exposure.exposure_e[index].reshape(-1)
            marks = exposure.saturated_by
            by = np.zeros(values.shape, np.uint8) if marks is None else marks[index].reshape(-1)
            # An exposure at the limit may exceed it by a rounding error.
            beyond = values > pictures.limits_e[readout.bucket] * (1 + 1e-9)
            exposed[readout.register] = values / readout.gain
            exposed_by[readout.register] = by | beyond.view(np.uint8) * np.uint8(RANGE_BIT)
        exposed |= kept.images
        exposed_by |= kept.marks
        code = {name: plane.reshape(-1) for name, plane in container.planes().items()} | kept.bits
        words = _words(container, tuple(sorted(params.items())))
        if not self._by_reference:
            errors = self.errors(seeds, number, shape[0] * shape[1])
            contents = words.run((shape[0], shape[1]), exposed, exposed_by, code, errors)
            contents.hold(words.after_us * 1e-6)
            return contents
        pixels = ArrayPixels(
            sensor=self.sensor,
            seed=seeds[0],
            device_seed=seeds[1],
            frame=number,
            places=np.arange(shape[0] * shape[1], dtype=np.int64),
            container=container,
            effects=self.effects,
            code=code,
            shape=(shape[0], shape[1]),
            exposed=exposed,
            exposed_by=exposed_by,
        )
        pixels.run_words(words.words)
        pixels.hold(words.after_us * 1e-6)
        return pixels

    @cached_property
    def _by_reference(self) -> bool:
        """Whether the reference runs the words: on request, or for effects that only it has."""
        from nscc_runtime.execution.frames import reference_reasons

        wanted = self.by_words or reference_reasons(self.effects)
        return bool(wanted) and not self.effects.without_effects

    def errors(self, seeds: tuple[int, int], number: int, pixels: int) -> NamedValues:
        """Return the effects that act on words in frame `number`, as `PictureWords.run` takes them,
        for all `pixels` pixels; empty without effects. `seeds`: of noise and device."""
        sensor, effects, target = self.sensor, self.effects, self.container.target
        if effects.without_effects:
            return {}
        device = whole_device(sensor, seeds[1], pixels)
        return {
            **figures(sensor, effects),
            **draws_keys(seeds[0], ArrayPixels.word_draws),
            **patterns(effects, device),
            "frame": number,
            "numbered": most_destinations(target),
            "patterns": len(target.analog_registers),
            "inverted": [*target.analog_registers].index(target.analog_scratch),
        }


def _exposure_of(
    names: list[str], read: dict[str, tuple[Floats, Bytes]], valid: Bools, buckets: int = 0
) -> Exposure:
    """Return the values `names` of `read` (electrons and saturation marks by name, each (rows,
    cols)) as an exposure, after this number of empty `buckets`. `valid` (rows, cols) holds for
    all."""
    shape = (buckets + len(names), *valid.shape)
    values, marks = np.zeros(shape), np.zeros(shape, np.uint8)
    for index, name in enumerate(names, buckets):
        values[index], marks[index] = read[name]
    return Exposure(values, np.broadcast_to(valid, shape).copy(), marks)


@lru_cache(4)
def _words(container: Container, params: tuple[tuple[str, int], ...]) -> PictureWords:
    """Return the words of images and planes for the values of parameters by name; the last results
    are cached."""
    return PictureWords(container.target, picture_words(container, dict(params)))


_beyond_reaches = OfContainer(beyond_reaches)


def image_sensor(sensor: Sensor, target: Target) -> Sensor:
    """Return the sensor whose converter reads images: its codes are symmetric around 0, and the
    words before it do not spread the values.

    A value of `sensor` is replaced by that of a full readout only where it is still the target's
    default; values that the user set stay."""
    own, full = (default_sensor(each).values for each in (target, replace(target, readout="full")))
    given = sensor.values
    changed = {name: full[name] for name in full if given[name] == own[name] != full[name]}
    return sensor.changed(**changed)


def sums_of_images(
    container: Container,
    values: Mapping[str, Floats],
    reaches: Mapping[str, Reach] | None = None,
) -> Told:
    """Return the reports of sums, each an array without axes, by the report's key: the electrons of
    all pixels outside the margin of an image, 0 if all lie in it.

    `values`: analog registers by name, of any shape with rows * cols values. `reaches`: by name,
    how far around a pixel an image depends on values outside the array; None for those of a first
    frame. Reports of other kinds are left out."""
    pictures, shape = container.pictures, (container.target.rows, container.target.cols)
    reaches = _beyond_reaches(container) if reaches is None else reaches
    told: Told = {}
    for report in pictures.reports:
        if report.kind == "sum":
            image = values[pictures.registers[report.plane]].reshape(shape)
            told |= report_of(report, image, reaches[report.plane].margin(shape))
    return told


def told_of_planes(
    container: Container,
    planes: Mapping[str, Bools],
    reaches: Mapping[str, Reach] | None = None,
    summaries: Mapping[str, PlaneSummary] = MappingProxyType({}),
) -> Told:
    """Return the planes, reports and margin of a frame: `margin` and `plane_NAME` are bits (rows,
    cols), `states_NAME` the values of states with a range, and reports have the keys of `reported`.
    Sums of images are not among them.

    `planes`: the bits (rows, cols) by digital register. `summaries`: by digital register, the
    summary of a plane that is only reported, without the pixels of its margin; other reported
    planes must be in `planes`. `reaches`: by name, how far around a pixel an output depends on
    values outside the array; None for those of a first frame."""
    pictures = container.pictures
    reaches = _beyond_reaches(container) if reaches is None else reaches
    shape = container.target.rows, container.target.cols
    outputs = (reaches[name] for name in pictures.outputs)
    told: Told = {"margin": Reach().joined(*outputs).margin(shape)}
    for name in pictures.reads:
        if pictures.registers[name] in planes:
            told[f"plane_{name}"] = planes[pictures.registers[name]]
    for state in pictures.ranges:
        if {*state.bits} <= {*pictures.reads}:
            bits = [told[f"plane_{name}"] << k for k, name in enumerate(state.bits)]
            told[f"states_{state.name}"] = np.sum([*bits, np.full(shape, state.low)], axis=0)
    for report in pictures.reports:
        if report.kind == "sum":
            continue
        register = pictures.registers[report.plane]
        if register in summaries:
            told |= reported(report, summaries[register])
        else:
            told |= report_of(report, planes[register], reaches[report.plane].margin(shape))
    return told
