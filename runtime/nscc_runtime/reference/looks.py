"""Programs that look, word by word: every pixel has its own bits, because they hang on its light.

As `nscc_runtime.reference.capture`, in float64 with the effects that are on; `where` compares what
pixels hold, IN is what a launch sets, and what a word does in a pixel is decided by the FLAG that
the pixel has at that moment. Random numbers are keyed by the word, not by the sum of words: no plan
has to meet them. A frame starts with arbitrary bits in registers that carry neither code nor a kept
state.

Slots between two boundaries with words are one interval (`nscc_runtime.reference.intervals`).
Without effects every slot is added by itself, as the exposure is defined.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Effect, Op, Phase
from nscc.words.container import Container
from nscc.words.cost import word_us
from nscc.words.legality import decoded
from nscc.words.readout import converter_of
from nscc_runtime.effects import Selection, selected
from nscc_runtime.effects.parts import Errors
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels, Scene, Word
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.interface import Executed, Exposure
from nscc_runtime.light import Light
from nscc_runtime.noise import key, normals, uniforms
from nscc_runtime.pool import in_strips, threads_of
from nscc_runtime.reference.capture import START, most_destinations, scene_of
from nscc_runtime.reference.charge import charge_of_rows
from nscc_runtime.reference.intervals import Intervals
from nscc_runtime.reference.marks import Marks
from nscc_runtime.reference.resets import Resets
from nscc_runtime.reference.trace import retention_us
from nscc_runtime.reference.weights import error_sign
from nscc_runtime.sensor import default_sensor

Values = NDArray[np.float64]
Bits = NDArray[np.bool_]

WORD_DRAWS = 1
"""The source, in the keys, of what is drawn word by word."""
_CELLS = 1 << 21
"""Most slots x pixels of a chunk of rows."""
_FIRST_BIT = 256
"""The group of the first digital register among the streams of START; analog ones stand before."""


@dataclass(frozen=True)
class Running:
    """An analog word as it runs: `number` counts those of a frame."""

    number: int
    after_us: float
    op: Op


@dataclass(frozen=True, eq=False)
class LookingReference:
    """A container whose pixels compare, made ready. Raises Rejected for words that cannot run.
    `threads`, None for all processors, change no bit.

    Without a machine (what a loader has of a program) `before` is of no use: what registers hold
    when the frame starts are the container's own planes.
    """

    container: Container
    sensor: Sensor
    effects: Selection
    threads: int | None = None
    kernels: tuple[tuple[Op, ...], ...] = field(init=False)

    def __post_init__(self) -> None:
        if self.container.pixel_codes is None:
            raise ValueError("a container without pixels")
        object.__setattr__(self, "kernels", decoded(self.container))

    @cached_property
    def intervals(self) -> Intervals:
        """What is simulated as one."""
        return Intervals.of(self.container, every_slot=self.effects.noiseless)

    def expose(
        self,
        scene: Scene,
        loaded: Mapping[str, Bits],
        seeds: tuple[int, int],
        frame: int,
        rows: range | None = None,
    ) -> Executed:
        """Frame number `frame`, or consecutive rows of it: bit for bit as the whole frame has them.

        `loaded`: the digital registers (rows, cols) with which it starts (`Container.planes`, then
        `next_planes`). `seeds` are those of the frames' noise and of the device.
        """
        container, cols = self.container, scene.light.shape[1]
        rows = range(scene.light.shape[0]) if rows is None else rows
        pace = self.intervals.paced(scene, self.effects)
        scene = self.intervals.joined(scene)
        told = {r for planes in container.state_planes.values() for r in planes.registers}
        told |= set(container.code_registers)
        exposure = np.empty((len(container.buckets), len(rows), cols))
        saturated_by = np.empty(exposure.shape, np.uint8)
        valid = np.empty((len(rows), cols), np.bool_)
        planes = {name: np.empty((len(rows), cols), np.bool_) for name in sorted(told)}

        def fill(part: range) -> None:
            fallen = charge_of_rows(scene, None, self.sensor, self.effects, seeds, frame, part)
            here = slice(part.start, part.stop)
            places = np.arange(part.start * cols, part.stop * cols, dtype=np.int64)
            pixels = WordPixels(
                sensor=self.sensor, seed=seeds[0], device_seed=seeds[1], frame=frame,
                places=places, program=self, pace=pace(here, fallen.light),
                code={name: plane[here].reshape(-1) for name, plane in loaded.items()},
            )  # fmt: skip
            found, marked = pixels.run(fallen.charge.reshape(len(self.intervals), -1))
            chunk = slice(part.start - rows.start, part.stop - rows.start)
            exposure[:, chunk] = found.reshape(-1, len(part), cols)
            saturated_by[:, chunk] = marked.reshape(-1, len(part), cols)
            valid[chunk] = fallen.valid
            for name, plane in planes.items():
                plane[chunk] = pixels.bits[name].reshape(len(part), cols)

        in_strips(fill, rows, _CELLS // (len(self.intervals) * cols), threads_of(self.threads))
        valid_here = np.isfinite(exposure) & valid
        return Executed(Exposure(exposure, valid_here, saturated_by), planes)


def executed(
    container: Container, light: Light, sensor: Sensor | None = None, device_seed: int = 0
) -> Executed:
    """One frame without effects, of a container that a loader has checked."""
    check_size(container, light)
    reference = LookingReference(
        container, sensor or default_sensor(converter_of(container)), selected("none")
    )
    return reference.expose(
        scene_of(container, light, None), container.planes(), (0, device_seed), 0
    )


@dataclass(eq=False, kw_only=True)
class WordPixels(Pixels):
    """Some pixels while the words of one frame run. All arrays are (pixels,) but `pace`, which
    `nscc_runtime.reference.intervals` has made."""

    program: LookingReference
    code: Mapping[str, Bits]
    pace: Values

    def __post_init__(self) -> None:
        self.at = self.program.effects.at
        self.container, target = self.program.container, self.program.container.target
        self.target = target
        self.most = most_destinations(target)
        self.errors_at = {e.name: p.at for e, p in self.program.effects.having(Errors)}
        names = ("PIX", *target.analog_registers)
        start = {name: self.arbitrary(i) for i, name in enumerate(names)}
        self.charge = start.pop("PIX") * self.sensor.full_well_e / 2
        self.register = {name: u * self.sensor.register_max_e / 2 for name, u in start.items()}
        self.resets = Resets(self.program.effects, len(self.places))
        self.marks = Marks(self.program.effects, self.sensor, (*names, "IN"), len(self.places))
        bits = (*target.digital_registers, "FLAG")
        self.bits = {name: self.arbitrary(_FIRST_BIT + i) < 0.5 for i, name in enumerate(bits)}
        nothing = np.zeros(len(self.places), np.bool_)
        self.bits |= {"SELECT": nothing, "bus": nothing, **self.code}
        self.written_us = dict.fromkeys(self.bits, 0.0)
        self.retention_us = retention_us(self.program.effects, self.sensor)
        self.now_us, self.after_us, self.in_e, self.number = 0.0, 0.0, 0.0, 0

    def arbitrary(self, group: int) -> Values:
        """Uniform numbers, fixed by the device, of which a register's first value is made."""
        return uniforms(key(self.device_seed, START, group=group), self.places)

    def error(self, name: str, word: Word, destination: int = 0) -> Values:
        number = word.number
        if self.errors_at.get(name) == "words":
            number = number * self.most + destination
        return self.draw(name, number)

    def draw(self, name: str, number: int) -> Values:
        effect = next(each for each in self.program.effects.effects if each.name == name)
        return normals(key(self.seed, effect.stream, WORD_DRAWS, self.frame, number), self.places)

    def run(self, charge: Values) -> tuple[Values, NDArray[np.uint8]]:
        """The exposures (buckets, pixels) of a frame of `charge` (intervals, pixels), and what cut
        them off (`nscc_runtime.effects.marks`)."""
        slots, target = self.container.slots, self.target
        launches = iter(self.container.launches)
        launch = next(launches, None)
        intervals = self.program.intervals
        interval_us = intervals.us.tolist()
        for number, n in enumerate((*intervals.starts, slots)):
            self.fallen, self.after_us = np.zeros(1), 0.0
            while launch is not None and launch.instant == n:
                if launch.level is not None:
                    self.in_e = launch.level * target.electrons_per_step
                self.after_us += target.launch_us
                for op in self.program.kernels[launch.kernel]:
                    self.after_us += word_us(op, target)
                    if op.analog:
                        self._until(op, charge[min(number, len(charge) - 1)], number, n)
                    self._run(op)
                launch = next(launches, None)
            if n < slots:
                self._fall(charge[number] * (1.0 - self.fallen))
                for held in self.at("hold"):
                    kept = held(self, interval_us[number] * 1e-6)
                    self.register = {name: v * kept for name, v in self.register.items()}
                self.now_us += interval_us[number]
        return self._read_out()

    def _until(self, op: Op, charge: Values, number: int, boundary: int) -> None:
        """The light that falls while words run, up to the end of this one."""
        for ends_us in self.at("time"):
            now_us = ends_us(Running(self.number, self.after_us, op))
            if boundary < self.container.slots:
                now_us = min(now_us, self.container.slot_us[boundary])
            now = now_us * self.pace[number]
            self._fall(charge * (now - self.fallen))
            self.fallen = now

    def _fall(self, charge: Values) -> None:
        self.charge = self.marks.fallen(self, self.charge + charge)

    def _run(self, op: Op) -> None:
        match op.operation.effect:
            case Effect.NONE:
                pass
            case Effect.RESET_PIX:
                self._reset(op)
            case Effect.BUS:
                self._bus(op)
            case Effect.FLAG_ALL:
                self._write("FLAG", np.ones(len(self.places), np.bool_))
            case Effect.FLAG_ANALOG:
                self._compare(op)
            case Effect.FLAG_DIGITAL:
                self._write("FLAG", self._some(op))
            case Effect.DIGITAL:
                self._digital(op)

    def _running(self, op: Op) -> Running:
        self.number += 1
        return Running(self.number - 1, self.after_us, op)

    def _reset(self, op: Op) -> None:
        word = self._running(op)
        here = np.ones(len(self.places), np.bool_)
        if self.target.reset_honours_flag != "no":
            here = self._read("FLAG")
        self.charge = np.where(here, 0.0, self.charge)
        self.marks.empty(here)
        self.resets.reset(self, here, word, self.now_us)

    def _total(self, word: Running) -> Values:
        total = np.zeros(len(self.places))
        for name in word.op.sources:
            if name == "IN":
                total += self.in_e
            elif name == "PIX":
                level = self.resets.found(self, self.charge, word, self.now_us)
                for found in self.at("reads"):
                    level = found(self, level, word)
                total += level
            else:
                total += self._source(name)
        return total

    def _source(self, name: str) -> Values:
        """What a word reads of an analog register."""
        return self.register[name]

    def _bus(self, op: Op) -> None:
        word = self._running(op)
        here = self._read("FLAG")
        result = self._total(word) / -op.operation.divisor
        at = self.now_us
        full, lost = self.marks.gathered(op, self.resets.unseen(at), self.resets.lit(at))
        for index, name in enumerate(op.destinations):
            value = result
            for written in self.at("words"):
                value = written(self, value, word, index, error_sign(name, self.container))
            value, lost_here = self.marks.held(self, value, lost)
            self.register[name] = np.where(here, value, self.register[name])
            self.marks.write(name, here, full, lost_here)

    def _compare(self, op: Op) -> None:
        word = self._running(op)
        total = self._total(word)
        for seen in self.at("compare"):
            total = seen(self, total, word)
        found = total > 0
        if self.target.where_obeys_flag:
            found &= self._read("FLAG")
        self._write("FLAG", found)

    def _read(self, name: str) -> Bits:
        if self.now_us - self.written_us[name] > self.retention_us:
            return np.zeros(len(self.places), np.bool_)
        return self.bits[name]

    def _some(self, op: Op) -> Bits:
        some = np.zeros(len(self.places), np.bool_)
        for name in op.sources:
            some = some | self._read(name)
        return some

    def _digital(self, op: Op) -> None:
        row = op.operation
        if row.phase is not Phase.WRITE:
            self.bits["bus"] = self._some(op) ^ row.inverted
        if row.phase is Phase.READ:
            return
        # What guards the masked register is the mask as it was before this word.
        masked, mask = self.target.masked_register, self.target.mask_register
        guard = None if mask is None else self._read(mask)
        for name in op.destinations:
            value = self.bits["bus"]
            if name == masked and guard is not None:
                value = np.where(guard, value, self._read(name))
            self._write(name, value)

    def _write(self, name: str, value: Bits) -> None:
        self.bits[name] = value
        self.written_us[name] = self.now_us

    def _read_out(self) -> tuple[Values, NDArray[np.uint8]]:
        exposures = np.empty((len(self.container.buckets), len(self.places)))
        marked = np.empty(exposures.shape, np.uint8)
        for order, readout in enumerate(self.container.readouts):
            value = self.register[readout.register] * readout.gain
            for held in self.at("hold"):
                value = value * held(self, order * self.target.readout_us * 1e-6)
            bucket = self.container.buckets.index(readout.bucket)
            for leaves in self.at("readout"):
                value = leaves(self, value, bucket)
            exposures[bucket] = value + 0.0  # -0 + 0 is +0
            marked[bucket] = self.marks.read_out(readout.register, readout.gain)
        return exposures, marked
