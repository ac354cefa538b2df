"""The reference: the words of a program executed in every pixel in float64, with sensor effects.

A frame starts with arbitrary values in PIX and in registers that contain neither codes nor kept
states, determined by the device seed. FLAG decides in each pixel whether a word acts there; a
comparison sets it from the light, and a launch sets IN. PIX counts relative to its reset level.

The charge of slot n reaches PIX between boundaries n and n + 1. Slots between two boundaries with
words are one interval, which changes no distribution: in between charge is only collected, PIX may
fill, and registers leak. A slot at whose boundary words run is an interval of its own. All random
numbers are keyed (`nscc_runtime.noise`), so a draw depends neither on the other effects nor on how
the array is cut into rows."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from nscc.arrays import Bools, Floats
from nscc.words.container import Container
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.effects.views import Scene
from nscc_runtime.emulator.capture import check
from nscc_runtime.exposed_frame import Executed, Exposure
from nscc_runtime.frame_file import Frame, converted
from nscc_runtime.light import Light
from nscc_runtime.noise import key, uniforms
from nscc_runtime.reference.charge import charge_of_rows, places_of
from nscc_runtime.reference.digital import Digital
from nscc_runtime.reference.stream import expose_stream
from nscc_runtime.reference.trace import RunningWord, analog_words, retention_us, running_words
from nscc_runtime.reference.weights import backward
from nscc_runtime.reference.words import START, Marked, WordPixels, in_rows
from nscc_runtime.run_kinds import KINDS

Bits = Bools
Planes = Mapping[str, Bits]
"""Digital registers (rows, cols) by name."""

_FIRST_BIT = 256
"""Group number, in the stream START, of the first digital register, after analog ones."""


@dataclass(frozen=True, eq=False)
class Reference:
    """A program prepared for simulation with the given effects of `sensor`. `words`: all words of
    a frame in the order of execution."""

    container: Container
    sensor: Sensor
    effects: Selection
    words: tuple[RunningWord, ...]

    @classmethod
    def of(cls, container: Container, sensor: Sensor, effects: Selection) -> Reference:
        """Prepare a program. Raises ValueError for a container without pixels, Rejected if a word
        is invalid (as `nscc.words.legality.decoded`), and Rejected with NS0442 if the words of a
        program without looks open no shutters. A container is a compiled program."""
        if container.pixel_codes is None:
            raise ValueError("the program has no pixel codes: add a `pixels` statement")
        if KINDS.of(container).open_times_known:
            # Only for its error: a weight other than 0 or 1 is no shutter.
            backward(container, analog_words(container)).open()
        return cls(container, sensor, effects, tuple(running_words(container)))

    @cached_property
    def starts(self) -> tuple[int, ...]:
        """The first slot of each interval; without effects each slot is an interval, because sums
        of light are defined slot by slot."""
        slots = self.container.slots
        if self.effects.without_effects:
            return tuple(range(slots))
        # A slot at whose start words run is an interval of its own, because a part of its light
        # falls while they run.
        boundaries = {launch.instant for launch in self.container.launches}
        # After the last slot the light goes on as in that slot, which must not share an interval.
        first = {
            0,
            *boundaries,
            *(n + 1 for n in boundaries),
            *(slots - 1 for n in boundaries if n == slots),
        }
        return tuple(sorted(n for n in first if n < slots))

    def expose(
        self,
        scene: Scene,
        seed: int = 0,
        device_seed: int = 0,
        frame: int = 0,
        threads: int | None = None,
    ) -> Exposure:
        """Return the exposure of frame number `frame` of a scene. `seed`: of the noise.
        `device_seed`: of the fixed patterns and the contents of registers at the start. Results do
        not depend on `threads` (None: all processors)."""
        loaded = self.container.planes()
        return self.execute(scene, loaded, (seed, device_seed), frame, threads=threads).exposure

    def execute(
        self,
        scene: Scene,
        loaded: Planes,
        seeds: tuple[int, int],
        frame: int,
        rows: range | None = None,
        threads: int | None = None,
    ) -> Executed:
        """Return the exposure of frame number `frame` (from 0) and the final bits of the registers
        that hold states or code; the latter are empty for a program without states.

        `loaded`: the digital registers of the whole array (rows, cols) at the start
        (`Container.planes`, then those that the previous frame left). `seeds`: noise seed, device
        seed. `rows`: consecutive rows to simulate, None for all; they are identical to these rows
        of the whole frame. Results do not depend on `threads` (None: all processors)."""
        container, (height, cols) = self.container, scene.light.shape
        rows = range(height) if rows is None else rows
        states = {name for planes in container.state_planes.values() for name in planes.registers}
        names = sorted(states | {*container.code_registers}) if states else []
        final_planes = {name: np.empty((len(rows), cols), np.bool_) for name in names}

        # The rows are exposed in strips, so that memory does not grow with the array.
        def run(part_rows: range) -> tuple[Marked, Bits]:
            """Run the program in the rows `part_rows` with the charge that falls on them. Return
            its readouts with marks, and which pixels are valid; store the final bits of registers
            in `final_planes`."""
            charge, valid = charge_of_rows(
                scene, self.sensor, self.effects, seeds, frame, part_rows, self.starts
            )
            array_rows = slice(part_rows.start, part_rows.stop)
            pixels = ProgramPixels(
                sensor=self.sensor,
                seed=seeds[0],
                device_seed=seeds[1],
                frame=frame,
                places=places_of(part_rows, cols),
                container=container,
                effects=self.effects,
                program=self,
                code={name: plane[array_rows].reshape(-1) for name, plane in loaded.items()},
            )
            marked = pixels.run(charge.reshape(len(self.starts), -1))
            chunk = slice(part_rows.start - rows.start, part_rows.stop - rows.start)
            for name, plane in final_planes.items():
                plane[chunk] = pixels.digital.bits[name].reshape(len(part_rows), cols)
            return marked, valid

        shape = len(container.buckets), cols, len(self.starts)
        return Executed(in_rows(run, rows, shape, threads), final_planes)


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
    """Return an iterator over frames 0 to `count` - 1 of `light` with converter codes, computed one
    by one, also for chips without logic.

    `seed`: of the noise. `device_seed`: of the fixed patterns. `threads`: None for all processors.
    Raises Rejected at the call, not at the first frame, for programs and light that do not fit."""
    check(container, light)
    scene, seeds = reference_scene(container, light), (seed, device_seed)
    reference = Reference.of(container, sensor, effects) if container.stream is None else None

    def expose(number: int) -> Exposure:
        """Return the exposure of frame `number`."""
        if reference is None:
            return expose_stream(container, scene, sensor, effects, seeds, number, threads)
        return reference.expose(scene, *seeds, number, threads)

    return (
        converted(expose(number), container.target, sensor, effects, seeds, number)
        for number in range(count)
    )


def reference_scene(container: Container, light: Light) -> Scene:
    """Return the light of a frame and of an equal previous frame, in a program's slots."""
    return Scene(light, light, container.slot_s)


@dataclass(eq=False, kw_only=True)
class ProgramPixels(WordPixels):
    """Some pixels of a program during one frame. `program` gives its words and intervals. `code`:
    the digital registers (pixels,) at the start of the frame, by name; others are arbitrary."""

    program: Reference
    code: Planes

    def __post_init__(self) -> None:
        """Set the digital registers and FLAG: those in `code` as given, others to arbitrary bits of
        the device seed; PIX (the photodiode) and the analog registers to arbitrary values. FLAG is
        the bit that lets a pixel act."""
        super().__post_init__()
        bits = {
            name: uniforms(key(self.device_seed, START, group=_FIRST_BIT + i), self.places) < 0.5
            for i, name in enumerate((*self.target.digital_registers, "FLAG"))
        }
        self.digital = Digital(
            self.target, {**bits, **self.code}, retention_us(self.effects, self.sensor)
        )

    def run(self, charge: Floats) -> Marked:
        """Run all words of the frame, and return exposures (buckets, pixels) in electrons and their
        saturation marks. `charge`: electrons (intervals, pixels) that fall in each interval."""
        slots, starts = self.container.slots, self.program.starts
        slot_us = np.array(self.container.slot_us)
        interval_us = np.add.reduceat(slot_us, starts).tolist()
        words = iter(self.program.words)
        word = next(words, None)
        for number, n in enumerate((*starts, slots)):
            self.fallen = 0.0
            while word is not None and word.boundary == n:
                if word.op.analog:
                    # Words after the last slot see its light: there is no further interval.
                    self._until(word, charge[min(number, len(charge) - 1)])
                self.run_word(word)
                word = next(words, None)
            if n < slots:
                # A product with 1 is the same number, but costs an array.
                self.fall(charge[number] * (1.0 - self.fallen) if self.fallen else charge[number])
                self.hold(interval_us[number] * 1e-6)
                self.digital.now_us += interval_us[number]
        return self.read_out()

    def _until(self, word: RunningWord, slot_charge: Floats) -> None:
        """Add to PIX the part of `slot_charge` (pixels,), the charge of the slot that begins at the
        word's boundary, that is collected until the word ends. Without the effect of slow words,
        this is nothing. Update `fallen`, the fraction of the slot collected so far. PIX is the
        photodiode."""
        slots, slot_us = self.container.slots, self.container.slot_us
        for ends_us in self.at("time"):
            now = ends_us(word) / slot_us[min(word.boundary, slots - 1)]
            # A slot has no more than its charge; after the last slot the light goes on.
            now = now if word.boundary == slots else min(now, 1.0)
            self.fall(slot_charge * (now - self.fallen))
            self.fallen = now
