"""Chips without logic, plane by plane: the light of each pixel goes where its bit sends it.

In float64 with the effects that are on. Taps are emptied when a frame starts, which leaves them off
by the noise of a reset; they collect the charge of their slots, may fill, leak, and are read once,
each through its gain. Words there are none, so effects of words, registers and comparisons do
nothing. Where light waits for planes to load, that is the chip's dead time.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nscc.words.container import Container
from nscc.words.stream import Stream
from nscc_runtime.effects import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.effects.views import Pixels, Scene, Word
from nscc_runtime.emulator.capture import check
from nscc_runtime.frame_file import Frame
from nscc_runtime.interface import Exposure
from nscc_runtime.light import Light
from nscc_runtime.noise import key, normals
from nscc_runtime.reference.capture import scene_of
from nscc_runtime.reference.charge import Fallen, charge_of_rows
from nscc_runtime.reference.words import Marked, converted_frames, in_rows

Values = NDArray[np.float64]

_ACTING = {
    "scene", "light", "response", "count", "charge", "neighbours", "well", "resets", "reads",
    "hold", "readout", "converter", "codes",
}  # fmt: skip
"""The stages of a frame that such a chip has; where light waits for planes, `time` as well."""


def absent_effects(container: Container, effects: Selection) -> Mapping[str, str]:
    """Those of `effects` that this chip cannot have, with the reason."""
    stages = _ACTING if container.target.pipelined else _ACTING | {"time"}
    return {
        effect.name: f"the pixels of {container.target.name} run no words"
        for effect in effects.effects
        if not stages & effect.reference.keys()
    }


def stream_frames(
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
    """Frames 0 .. `count` - 1 of `light`. What can be refused is refused before the first one."""
    check(container, light)
    scene = scene_of(container, light)
    seeds = seed, device_seed

    def expose(number: int) -> Exposure:
        return expose_stream(container, scene, sensor, effects, seeds, number, threads)

    return converted_frames(expose, container, sensor, effects, seeds, count)


def expose_stream(
    container: Container,
    scene: Scene,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    frame: int,
    threads: int | None = None,
) -> Exposure:
    """Frame number `frame` of a scene; `seeds` are those of the frames' noise and of the device.
    `threads`, None for all processors, change no bit."""
    sent, (rows, cols) = container.stream, scene.light.shape
    if sent is None:
        raise ValueError("a container without planes")

    def fall(part: range) -> Fallen:
        return charge_of_rows(scene, None, sensor, effects, seeds, frame, part)

    def run(part: range, fallen: Fallen) -> Marked:
        pixels = _Taps(
            sensor=sensor, seed=seeds[0], device_seed=seeds[1], frame=frame,
            places=np.arange(part.start * cols, part.stop * cols, dtype=np.int64),
            container=container, sent=sent, effects=effects, rows=slice(part.start, part.stop),
        )  # fmt: skip
        return pixels.run(fallen.charge.reshape(container.slots, -1))

    shape = len(container.buckets), cols, container.slots
    return in_rows(fall, run, range(rows), shape, threads)


@dataclass(frozen=True)
class _Step:
    """What stands for a word where effects number them: of a tap, or of a slot's loading."""

    number: int
    after_us: float = 0.0


@dataclass(eq=False, kw_only=True)
class _Taps(Pixels):
    """Some rows of pixels during one frame; arrays are (pixels,)."""

    container: Container
    sent: Stream
    effects: Selection
    rows: slice

    def error(self, name: str, word: Word, destination: int = 0) -> Values:
        effect = next(each for each in self.effects.effects if each.name == name)
        return normals(key(self.seed, effect.stream, 1, self.frame, word.number), self.places)

    def run(self, charge: Values) -> Marked:
        """A frame of `charge` (N, pixels)."""
        container, target = self.container, self.container.target
        shape = len(container.buckets), len(self.places)
        held, marked = np.zeros(shape), np.zeros(shape, np.uint8)
        for slot, slot_us in enumerate(container.slot_us):
            place = self.sent.place(slot, target.cols)[self.rows].reshape(-1)
            fallen = charge[slot] * self._lit(slot, slot_us)
            for tap in range(len(held)):
                for leaks in self.effects.at("hold"):
                    held[tap] *= leaks(self, slot_us * 1e-6)
                held[tap] += np.where(place == tap, fallen, 0.0)
                held[tap], full = self._kept(held[tap])
                marked[tap] |= full
        return self._read_out(held), marked

    def _lit(self, slot: int, slot_us: float) -> float:
        """The part of a slot in which light is collected."""
        target = self.container.target
        if target.pipelined:
            return 1.0
        waits_us = [ends(_Step(slot, target.plane_load_us)) for ends in self.effects.at("time")]
        return 1.0 - float(sum(waits_us)) / slot_us

    def _kept(self, charge: Values) -> tuple[Values, NDArray[np.uint8]]:
        """What a tap holds, and the bits of what it has lost to."""
        found = np.zeros(len(charge), np.uint8)
        for effect, holds in self.effects.acting("well"):
            given, charge = charge, holds(self, charge)
            if "well" in effect.marks:
                found |= np.where(charge < given, effect.marks["well"].bit, 0).astype(np.uint8)
        return charge, found

    def _read_out(self, held: Values) -> Values:
        for tap, readout in enumerate(self.container.readouts):
            level = np.zeros(len(self.places))
            for left in self.effects.at("resets"):
                level = left(self, level, _Step(tap))
            value = (held[tap] + level) * readout.gain
            for found in self.effects.at("reads"):
                value = found(self, value, _Step(tap))
            for leaves in self.effects.at("readout"):
                value = leaves(self, value, tap)
            held[tap] = value + 0.0  # -0 + 0 is +0
        return held
