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
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nscc.operations import WordEffect
from nscc.words.container import Container
from nscc.words.readout import converter_of
from nscc_runtime.effects import Selection, selected
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.emulator.capture import check_size
from nscc_runtime.interface import Executed
from nscc_runtime.light import Light
from nscc_runtime.noise import key, normals, uniforms
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.reference.charge import Fallen, charge_of_rows
from nscc_runtime.reference.digital import Digital
from nscc_runtime.reference.intervals import Intervals
from nscc_runtime.reference.trace import RunningWord, retention_us, running_words
from nscc_runtime.reference.words import START, Marked, WordPixels, in_rows
from nscc_runtime.sensor import default_sensor

Values = NDArray[np.float64]
Bits = NDArray[np.bool_]

WORD_DRAWS = 1
"""The source, in the keys, of what is drawn word by word."""
_FIRST_BIT = 256
"""The group of the first digital register among the streams of START; analog ones stand before."""


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

    def __post_init__(self) -> None:
        if self.container.pixel_codes is None:
            raise ValueError("a container without pixels")
        self.words  # noqa: B018  # made when it is asked for: what can be refused is refused

    @cached_property
    def words(self) -> tuple[RunningWord, ...]:
        """Every word of a frame."""
        return tuple(running_words(self.container))

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
        state_registers = {
            r for planes in container.state_planes.values() for r in planes.registers
        }
        state_registers |= set(container.code_registers)
        planes = {name: np.empty((len(rows), cols), np.bool_) for name in sorted(state_registers)}

        def fall(part_rows: range) -> Fallen:
            return charge_of_rows(scene, None, self.sensor, self.effects, seeds, frame, part_rows)

        def run(part_rows: range, fallen: Fallen) -> Marked:
            array_rows = slice(part_rows.start, part_rows.stop)
            pixels = _LookingPixels(
                sensor=self.sensor, seed=seeds[0], device_seed=seeds[1], frame=frame,
                places=np.arange(part_rows.start * cols, part_rows.stop * cols, dtype=np.int64),
                container=container, effects=self.effects, program=self,
                pace=pace(array_rows, fallen.light),
                code={name: plane[array_rows].reshape(-1) for name, plane in loaded.items()},
            )  # fmt: skip
            marked = pixels.run(fallen.charge.reshape(len(self.intervals), -1))
            chunk = slice(part_rows.start - rows.start, part_rows.stop - rows.start)
            for name, plane in planes.items():
                plane[chunk] = pixels.digital.bits[name].reshape(len(part_rows), cols)
            return marked

        shape = len(container.buckets), cols, len(self.intervals)
        return Executed(in_rows(fall, run, rows, shape, self.threads), planes)


def executed(
    container: Container, light: Light, sensor: Sensor | None = None, device_seed: int = 0
) -> Executed:
    """One frame without effects, of a container that a loader has checked."""
    check_size(container, light)
    reference = LookingReference(
        container, sensor or default_sensor(converter_of(container)), selected("none")
    )
    return reference.expose(scene_of(container, light), container.planes(), (0, device_seed), 0)


@dataclass(eq=False, kw_only=True)
class _LookingPixels(WordPixels):
    """Some pixels that look; `pace` is what `nscc_runtime.reference.intervals` has made."""

    program: LookingReference
    code: Mapping[str, Bits]
    pace: Values

    def __post_init__(self) -> None:
        super().__post_init__()
        bits = {
            name: uniforms(key(self.device_seed, START, group=_FIRST_BIT + i), self.places) < 0.5
            for i, name in enumerate((*self.target.digital_registers, "FLAG"))
        }
        self.digital = Digital(
            self.target, {**bits, **self.code}, retention_us(self.effects, self.sensor)
        )

    def draw(self, name: str, number: int) -> Values:
        effect = next(candidate for candidate in self.effects.effects if candidate.name == name)
        return normals(key(self.seed, effect.stream, WORD_DRAWS, self.frame, number), self.places)

    def run(self, charge: Values) -> Marked:
        """A frame of `charge` (intervals, pixels)."""
        slots, intervals = self.container.slots, self.program.intervals
        words = iter(self.program.words)
        word = next(words, None)
        interval_us = intervals.us.tolist()
        for number, n in enumerate((*intervals.starts, slots)):
            self.fallen = np.zeros(1)
            while word is not None and word.boundary == n:
                if word.op.analog:
                    self._until(word, charge[min(number, len(charge) - 1)], number)
                self._run(word)
                word = next(words, None)
            if n < slots:
                self.fall(charge[number] * (1.0 - self.fallen))
                self.hold(interval_us[number] * 1e-6)
                self.digital.now_us += interval_us[number]
        return self.read_out()

    def _until(self, word: RunningWord, charge: Values, number: int) -> None:
        """The light that falls while words run, up to the end of this one."""
        for ends_us in self.at("time"):
            now_us = ends_us(word)
            if word.boundary < self.container.slots:
                now_us = min(now_us, self.container.slot_us[word.boundary])
            now = now_us * self.pace[number]
            self.fall(charge * (now - self.fallen))
            self.fallen = now

    def _run(self, word: RunningWord) -> None:
        flag = self.digital.read("FLAG") == 1
        match word.op.operation.effect:
            case WordEffect.RESET_PIX:
                everywhere = self.target.reset_honours_flag == "no"
                self.reset(word, np.ones_like(flag) if everywhere else flag)
            case WordEffect.BUS:
                self.bus(word, flag)
            case WordEffect.FLAG_ANALOG:
                is_above = self._compared_total(word) > 0
                self.digital.write(
                    "FLAG", is_above & flag if self.target.where_obeys_flag else is_above
                )
            case _:
                self.digital.run(word.op)

    def _compared_total(self, word: RunningWord) -> Values:
        """What a comparison with 0 sees."""
        total = self.total(word)
        for compare in self.at("compare"):
            total = compare(self, total, word)
        return total
