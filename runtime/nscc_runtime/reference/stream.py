"""The reference for chips without logic: each pixel's bit selects the tap that collects its light.

In float64 with the given effects. Taps are emptied at the start of a frame, with reset noise. They
collect the charge of their slots, may saturate, leak, and are read once with their gain. Such chips
run no words, so effects of words, registers and comparisons have no influence. If light is not
collected while planes are loaded, this is the chip's dead time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from nscc.arrays import Bools, Floats
from nscc.words.container import Container
from nscc.words.stream import Stream
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.effects.views import Pixels, Scene, Word
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.noise import key, normals
from nscc_runtime.reference.charge import charge_of_rows, places_of
from nscc_runtime.reference.words import Marked, clipped, in_rows

_ACTING = {
    "scene", "light", "response", "count", "charge", "neighbours", "well", "resets", "reads",
    "hold", "readout", "converter", "codes",
}  # fmt: skip
"""The stages of a frame on such a chip; also `time` if light is not collected while planes load."""


def absent_effects(container: Container, effects: Selection) -> Mapping[str, str]:
    """Return the names of those `effects` that the chip of `container`, one without logic, cannot
    have, each with the reason; empty if it can have all."""
    stages = _ACTING if container.target.pipelined else _ACTING | {"time"}
    return {
        effect.name: f"the pixels of {container.target.name} run no words"
        for effect in effects.effects
        if not stages & effect.reference.keys()
    }


def expose_stream(
    container: Container,
    scene: Scene,
    sensor: Sensor,
    effects: Selection,
    seeds: tuple[int, int],
    frame: int,
    threads: int | None = None,
) -> Exposure:
    """Return the exposure of frame number `frame` (from 0) of a scene on a chip without logic.

    `seeds`: noise seed, device seed. Results do not depend on `threads` (None: all processors).
    Raises ValueError for a container (a compiled program) that sends no bit planes, that is, of a
    chip with logic."""
    sent, (rows, cols) = container.stream, scene.light.shape
    if sent is None:
        raise ValueError("the program has no bit planes: its target has pixels with logic")

    def run(part_rows: range) -> tuple[Marked, Bools]:
        """Expose the rows `part_rows` with the charge that falls on them in each slot, and return
        the exposures of their buckets and the saturation marks, each (buckets, pixels), and which
        pixels are valid."""
        charge, valid = charge_of_rows(
            scene, sensor, effects, seeds, frame, part_rows, range(container.slots)
        )
        pixels = _Taps(
            sensor=sensor,
            seed=seeds[0],
            device_seed=seeds[1],
            frame=frame,
            places=places_of(part_rows, cols),
            container=container,
            sent=sent,
            effects=effects,
            rows=slice(part_rows.start, part_rows.stop),
        )
        return pixels.run(charge.reshape(container.slots, -1)), valid

    shape = len(container.buckets), cols, container.slots
    return in_rows(run, range(rows), shape, threads)


@dataclass(frozen=True)
class _Step:
    """A stand-in for a word in effects: the use of a tap (`number` is that of the tap), or the
    loading of a slot's planes (`number` is that of the slot, `after_us` the end of loading)."""

    number: int
    after_us: float = 0.0


@dataclass(eq=False, kw_only=True)
class _Taps(Pixels):
    """Some rows of pixels during one frame; arrays are (pixels,), row after row. `sent`: the bit
    planes that select taps. `rows`: the rows of the array that are simulated."""

    container: Container
    sent: Stream
    effects: Selection
    rows: slice

    def error(self, name: str, word: Word, destination: int = 0) -> Floats:
        """Return standard normal numbers (pixels,) for the effect called `name` at the step `word`.
        `destination` is ignored: there is one for each step. The effect must be simulated."""
        effect = next(candidate for candidate in self.effects.effects if candidate.name == name)
        return normals(key(self.seed, effect.stream, 1, self.frame, word.number), self.places)

    def run(self, charge: Floats) -> Marked:
        """Return exposures (buckets, pixels) in electrons, and their saturation marks. `charge`:
        electrons (N, pixels) that fall in each slot."""
        container, target = self.container, self.container.target
        shape = len(container.buckets), len(self.places)
        tap_charge, is_full = np.zeros(shape), np.zeros(shape, np.bool_)
        for slot, slot_us in enumerate(container.slot_us):
            taps = self.sent.destinations(slot, target.cols)[self.rows].reshape(-1)
            fallen = charge[slot] * self._lit(slot, slot_us)
            for tap in range(len(tap_charge)):
                for leaks in self.effects.at("hold"):
                    tap_charge[tap] *= leaks(self, slot_us * 1e-6)
                tap_charge[tap] += np.where(taps == tap, fallen, 0.0)
                tap_charge[tap], lost_e = clipped(self, self.effects, "well", tap_charge[tap])
                is_full[tap] |= lost_e > 0
        mark = self.effects.marking("well")
        marked = is_full * np.uint8(0 if mark is None else mark.bit)
        return self._read_out(tap_charge), marked

    def _lit(self, slot: int, slot_us: float) -> float:
        """Return the fraction of a slot (number `slot`, of `slot_us` microseconds) in which light
        is collected. A chip that is not pipelined first loads the slot's bit plane; whether this
        takes time is an effect (stage `time`)."""
        target = self.container.target
        if target.pipelined:
            return 1.0
        waits_us = [ends(_Step(slot, target.plane_load_us)) for ends in self.effects.at("time")]
        return 1.0 - float(sum(waits_us)) / slot_us

    def _read_out(self, tap_charge: Floats) -> Floats:
        """Apply reset level, gain, read errors and readout to `tap_charge` (taps, pixels), which
        holds electrons, in place, and return it."""
        for tap, readout in enumerate(self.container.readouts):
            level = np.zeros(len(self.places))
            for change in self.effects.at("resets"):
                level = change(self, level, _Step(tap))
            value = (tap_charge[tap] + level) * readout.gain
            for read in self.effects.at("reads"):
                value = read(self, value, _Step(tap))
            for leaves in self.effects.at("readout"):
                value = leaves(self, value, tap)
            tap_charge[tap] = value + 0.0  # -0 + 0 is +0
        return tap_charge
