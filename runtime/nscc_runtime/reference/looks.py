"""The reference for programs that look: every pixel has its own bits, which depend on its light.

It is like `nscc_runtime.reference.capture`, in float64 with the given effects. A comparison reads
register contents, a launch sets IN, and FLAG decides whether a word acts in a pixel. Random numbers
are keyed by word. A frame starts with arbitrary bits in registers that contain neither codes nor
kept states. Slots between two boundaries with words are one interval
(`nscc_runtime.reference.looks`). Without effects every slot is added separately, as the
exposure is defined."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

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
from nscc_runtime.noise import key, uniforms
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.reference.charge import Fallen, charge_of_rows
from nscc_runtime.reference.digital import Digital
from nscc_runtime.reference.trace import RunningWord, retention_us, running_words
from nscc_runtime.reference.words import START, Marked, WordPixels, in_rows
from nscc_runtime.sensor import default_sensor

Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Intervals:
    """The intervals of a frame between the boundaries at which words run. `starts`: their first
    slots. `slot_us` (N,): slot lengths.

    Between these boundaries charge is collected, registers leak and PIX may saturate, so the charge
    of an interval is counted at once, which changes no distribution. While the words of a boundary
    run, the fraction of the interval's charge that is collected follows from the light of its first
    slot."""

    starts: tuple[int, ...]
    slot_us: Values

    @classmethod
    def of(cls, container: Container, every_slot: bool) -> Intervals:
        """Return a program's intervals; with `every_slot` one per slot, as exact exposures need."""
        at = {0, *(launch.instant for launch in container.launches)}
        slots = container.slots
        starts = range(slots) if every_slot else sorted(n for n in at if n < slots)
        return cls(tuple(starts), np.array(container.slot_us, np.float64))

    def __len__(self) -> int:
        return len(self.starts)

    @property
    def us(self) -> Values:
        """Length (intervals,) of each interval in microseconds."""
        return np.add.reduceat(self.slot_us, self.starts)

    def joined(self, scene: Scene) -> Scene:
        """Return a scene whose light is given in intervals instead of slots."""
        light = scene.light.joined(self.starts)
        same = scene.previous is scene.light
        previous = light if same else scene.previous.joined(self.starts)
        return Scene(light, previous, self.us * 1e-6)

    def paced(self, scene: Scene, effects: Selection) -> Callable[[slice, Values], Values]:
        """Return a function of a slice of rows and their light (intervals, rows, cols).

        The function returns the fraction of an interval's light that is collected per microsecond
        while words run, shape (intervals + 1, pixels), or (intervals + 1, 1) if all pixels have the
        same. The last row is for the words after the last slot, as if the light of that slot
        continued. All fractions are 0 if words take no time."""
        for choose in effects.at("scene"):
            scene = choose(scene)
        light = scene.light
        first = [*self.starts, len(self.slot_us) - 1]
        interval = [*range(len(self)), len(self) - 1]
        slot_us, us = self.slot_us[first][:, None], self.us[interval][:, None]
        if not effects.at("time"):
            return lambda _rows, _light: np.zeros((len(first), 1))
        if len(light.frames) == 1 and len(light.weight) == light.slots:
            # A still: the light of a slot is its weight times the only picture.
            slot_light = light.weight[first][:, None]
            interval_light = np.add.reduceat(light.weight, self.starts)[interval][:, None]
            return lambda _rows, _light: _light_share_per_us(
                slot_light, interval_light, slot_us, us
            )

        def of_rows(rows: slice, all_of_it: Values) -> Values:
            slot_light = np.stack([light.slot(n, rows).reshape(-1) for n in first])
            return _light_share_per_us(
                slot_light, all_of_it[interval].reshape(len(interval), -1), slot_us, us
            )

        return of_rows


def _light_share_per_us(
    slot_light: NDArray[Any], interval_light: NDArray[Any], slot_us: Values, us: Values
) -> Values:
    """Return the fraction of an interval's light that is collected in one microsecond of its first
    slot; without light, the fraction of its time."""
    even = np.broadcast_to(slot_us / us, interval_light.shape).copy()
    return np.asarray(
        np.divide(slot_light, interval_light, out=even, where=interval_light > 0) / slot_us
    )


Bits = NDArray[np.bool_]

_FIRST_BIT = 256
"""Group number, in the stream START, of the first digital register, after analog ones."""


@dataclass(frozen=True, eq=False)
class LookingReference:
    """A program whose pixels look, prepared for simulation with the given effects. Raises Rejected
    for words that cannot run. Results do not depend on `threads` (None: all processors)."""

    container: Container
    sensor: Sensor
    effects: Selection
    threads: int | None = None

    def __post_init__(self) -> None:
        if self.container.pixel_codes is None:
            raise ValueError("a container without pixels")
        self.words  # noqa: B018  # computes the cached property: words are checked now

    @cached_property
    def words(self) -> tuple[RunningWord, ...]:
        """All words of a frame."""
        return tuple(running_words(self.container))

    @cached_property
    def intervals(self) -> Intervals:
        """The intervals of the frame: single slots without noise, else runs of slots without
        words."""
        return Intervals.of(self.container, every_slot=self.effects.noiseless)

    def expose(
        self,
        scene: Scene,
        loaded: Mapping[str, Bits],
        seeds: tuple[int, int],
        frame: int,
        rows: range | None = None,
    ) -> Executed:
        """Return the exposure of frame number `frame`, or of consecutive rows of it, and its state
        registers.

        `loaded`: the digital registers (rows, cols) at the start (`Container.planes`, then
        `next_planes`). `seeds`: noise seed, device seed. Rows are identical to these rows of the
        whole frame."""
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
            return charge_of_rows(scene, self.sensor, self.effects, seeds, frame, part_rows)

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
    """Return one frame without effects of a container that its loader has checked."""
    check_size(container, light)
    reference = LookingReference(
        container, sensor or default_sensor(converter_of(container)), selected("none")
    )
    return reference.expose(scene_of(container, light), container.planes(), (0, device_seed), 0)


@dataclass(eq=False, kw_only=True)
class _LookingPixels(WordPixels):
    """Some pixels that look, during one frame; `pace` is the result of `Intervals.paced`."""

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

    def run(self, charge: Values) -> Marked:
        """Return exposures and saturation marks for `charge` (intervals, pixels) in electrons."""
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
        """Add the light that is collected while words run, up to the end of this word."""
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
        """Return the electrons (pixels,) of which a comparison tests whether they are above 0."""
        total = self.total(word)
        for compare in self.at("compare"):
            total = compare(self, total, word)
        return total
