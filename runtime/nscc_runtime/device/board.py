"""The board of a stand-in: a loader's commands to it, recorded as programs, and its chip, the
emulator exposed to a scene."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field, replace
from struct import Struct
from threading import Thread
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from nscc.arrays import Array
from nscc.chips.target import Target
from nscc.operations import Word
from nscc.words.container import Launch
from nscc.words.encoding import decode
from nscc.words.readout import converter_of_registers
from nscc_runtime.device.messages import Channel
from nscc_runtime.device.objects import RUN, WORD, packed_plane, unpacked_plane
from nscc_runtime.emulator.chip_program import ChipProgram

if TYPE_CHECKING:
    from nscc_runtime.light import Light
    from nscc_runtime.sensor import Sensor


_JOB = Struct("<5I")
_READOUT = Struct("<Id")
_EVENT = Struct("<Ii")
_LIGHT_FALLS = 0xFFFF_FFFF
_IN_IS_SET = 0xFFFF_FFFE
"""Numbers of events that are no launches. A launch has the offset of its kernel in the words."""
IMAGE = 256
"""Added to the register number of a readout that is an image, not a bucket."""


class BoardProgram(NamedTuple):
    """What a board executes in a frame, and what it reads out.

    `chip`: the words and launches (starts of kernels). `slot_us`: lengths of the slots in
    microseconds. `readouts`: names and gains of the registers of buckets. `images`: names of those
    of images. `states`: names of the digital registers that are sent with the frame. `kept`: names
    of the analog registers that are kept from frame to frame."""

    chip: ChipProgram
    slot_us: tuple[float, ...]
    readouts: tuple[tuple[str, float], ...]
    images: tuple[str, ...]
    states: tuple[str, ...]
    kept: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class ExecutedFrame:
    """One frame of the emulator.

    `frame`: its bytes as a loader sends them. `planes`: the digital registers with codes after the
    frame, as bytes of PLANE objects, by register; kept states are stored in them. `kept`: electrons
    (rows, cols) of the analog registers that are kept, by register."""

    frame: bytes
    planes: Mapping[str, bytes]
    kept: Mapping[str, Any]


class BoardJob(NamedTuple):
    """A frame that a loader requests: its number, the channels to read out (bits of `Channel`), and
    the program."""

    number: int
    channels: int
    program: BoardProgram


class Recording:
    """The commands of a loader to its board, received as records (`emulated/records.hpp`)."""

    def __init__(self, target: Target) -> None:
        """Begin without a program. The words are those of `target`."""
        self.target = target
        self._forget()

    def _forget(self) -> None:
        """Forget all recorded commands: planes, words, jobs and events."""
        self._planes: dict[int, bytes] = {}
        self._analog: Mapping[str, Any] = {}
        self._latest: BoardJob | None = None
        self._words = self._runs = b""
        self._events: list[tuple[int, int]] = []

    def take(self, kind: bytes, data: bytes) -> BoardJob | None:
        """Process a record of this `kind`, one letter, with its `data`; return a job for the kind
        "J", None for others.

        F forgets all; D is a plane after the number of its register; W are the words; S are runs of
        equal slots; N begins a frame; E is an event; J asks for the frame. Raises ValueError for an
        unknown kind."""
        match kind:
            case b"F":
                self._forget()
            case b"D":
                self._planes[data[0]] = data[1:]
            case b"W":
                self._words = data
            case b"S":
                self._runs = data
            case b"N":
                self._events = []
            case b"E":
                self._events.append(_EVENT.unpack(data))
            # A job is a head, its readouts, then the numbers of the registers of states.
            case b"J":
                number, channels, readouts, states, kept = _JOB.unpack_from(data)
                split = _JOB.size + readouts * _READOUT.size
                read = list(_READOUT.iter_unpack(data[_JOB.size : split]))
                registers = enumerate(self.target.analog_registers)
                names = tuple(name for place, name in registers if kept >> place & 1)
                program = self._program(read, list(data[split : split + states]), names)
                self._latest = BoardJob(number, channels, program)
                return self._latest
            case _:
                raise ValueError(f"a record of kind {kind!r}")
        return None

    def keep(self, job: BoardJob, executed: ExecutedFrame) -> None:
        """Store the registers after a frame `executed`, with which the program's next frame starts.
        A `job` that is not the latest changes nothing, because the program was replaced since."""
        if job is self._latest:
            names = self.target.digital_registers
            self._planes = {names.index(name): plane for name, plane in executed.planes.items()}
            self._analog = executed.kept

    def _program(
        self,
        readouts: Sequence[tuple[int, float]],
        states: Sequence[int],
        kept: Sequence[str],
    ) -> BoardProgram:
        """Return the commands since the frame began as a program of the board.

        Events become launches (starts of kernels) of kernels at boundaries, with the value of IN
        set before them. `readouts` are numbers of registers (see IMAGE) with their gains, `states`
        numbers of digital registers that are sent, and `kept` names of analog registers that go on
        to the next frame. IN is the level sent to all pixels."""
        numbers: dict[tuple[int, int], int] = {}
        launches: list[Launch] = []
        boundary, level = 0, None
        for event, count in self._events:
            if event == _LIGHT_FALLS:
                boundary += count
            elif event == _IN_IS_SET:
                level = count
            else:
                # A launch is the byte offset of its kernel in the words, and their number.
                kernel = numbers.setdefault((event, count), len(numbers))
                launches.append(Launch(boundary, kernel, level))
                level = None
        return BoardCommands(
            readouts=readouts,
            kernels=[
                tuple(WORD.iter_unpack(self._words[first : first + count * WORD.size]))
                for first, count in numbers
            ],
            launches=launches,
            runs=list(RUN.iter_unpack(self._runs)),
            states=states,
            planes=self._planes,
            kept=kept,
            analog=self._analog,
        ).program(self.target)


class BoardCommands(NamedTuple):
    """The commands to a board for a frame.

    Registers are numbers, those of `kept` names; IMAGE is added to the number of an image's
    register in `readouts`, which have gains. `kernels`: the words of each. `launches`: kernels at
    boundaries. `runs`: numbers of equal slots, with their lengths in microseconds. `states`:
    digital registers that are sent. `planes`: bytes of PLANE objects by register. `kept`: registers
    that go on from frame to frame; `analog` are the electrons (rows, cols) that the previous frame
    left in them."""

    readouts: Sequence[tuple[int, float]]
    kernels: Sequence[Sequence[Word]]
    launches: Sequence[Launch]
    runs: Sequence[tuple[int, float]]
    states: Sequence[int]
    planes: Mapping[int, bytes]
    kept: Sequence[str]
    analog: Mapping[str, Any]

    def program(self, target: Target) -> BoardProgram:
        """Return the commands to a chip of `target` as a program for the emulator."""
        registers, digital = target.analog_registers, target.digital_registers
        slot_us = tuple(us for count, us in self.runs for _ in range(count))
        shape = target.rows, target.cols
        loaded = {digital[n]: unpacked_plane(data, shape) for n, data in self.planes.items()}
        ops = [[decode(word) for word in words] for words in self.kernels]
        return BoardProgram(
            ChipProgram(target, len(slot_us), ops, self.launches, loaded, self.analog),
            slot_us,
            tuple((registers[number], gain) for number, gain in self.readouts if number < IMAGE),
            tuple(registers[number - IMAGE] for number, _ in self.readouts if number >= IMAGE),
            tuple(digital[number] for number in self.states),
            tuple(self.kept),
        )


Scene = Callable[[Sequence[float]], "Light"]
"""A function of slot lengths in microseconds that returns the light on the array in these slots."""


@dataclass
class EmulatedChip:
    """A chip that exposes frames of `scene` with the emulator; slots of equal lengths see equal
    light.

    `sensor`: None for the defaults of `target`. `device_seed` numbers the chip's fixed patterns.
    `report` is called with each error, because the host only learns that an error occurred."""

    scene: Scene
    target: Target
    sensor: Sensor | None = None
    device_seed: int = 0
    report: Callable[[Exception], None] = lambda _: None
    _light: tuple[tuple[float, ...], Light] | None = field(default=None, init=False)

    def execute(self, program: BoardProgram, channels: int) -> ExecutedFrame:
        """Expose one frame of `program`. `channels` are the bits of `Channel` that are read out.

        The bytes of the frame are, as far as they are requested, all converter codes, then all
        exposures, then all planes of states. Codes and exposures are in the order of readout,
        column and row. Raises what the scene raises for these slots."""
        from nscc_runtime.exposed_frame import Exposure
        from nscc_runtime.frame_file import read_out
        from nscc_runtime.neighbours.pictured_program import image_sensor

        # The light depends on the lengths of the slots only, so it is computed once for a
        # program.
        if self._light is None or self._light[0] != program.slot_us:
            self._light = (program.slot_us, self.scene(program.slot_us))
        registers = [*(name for name, _ in program.readouts), *program.images]
        digital = [*program.states, *program.chip.planes]
        contents, bits = program.chip.run(
            self._light[1], [*registers, *program.kept], digital, device_seed=self.device_seed
        )
        kept = dict(zip(program.kept, contents[len(registers) :], strict=True))
        contents = contents[: len(registers)]
        gains = np.array([gain for _, gain in program.readouts] + [1.0] * len(program.images))
        exposure_e = contents * gains[:, None, None] + 0.0  # -0 + 0 is +0
        sensor = self._converting([*registers, *program.kept])
        # Buckets are converted as the target says; images, whose values may be negative, in full
        # range.
        full = replace(self.target, readout="full")
        codes = [
            read_out(Exposure(values, np.isfinite(values)), target, of_readouts).frame
            for values, target, of_readouts in (
                (exposure_e[: len(program.readouts)], self.target, sensor),
                (exposure_e[len(program.readouts) :], full, image_sensor(sensor, self.target)),
            )
        ]
        chunks = [in_columns(values) for values in codes] if channels & Channel.CODES else []
        if channels & Channel.EXPOSURE:
            chunks.append(in_columns(exposure_e.astype("<f8")))
        planes = [packed_plane(plane) for plane in bits]
        if channels & Channel.STATES:
            chunks += planes[: len(program.states)]
        loaded = zip(program.chip.planes, planes[len(program.states) :], strict=True)
        return ExecutedFrame(b"".join(chunks), dict(loaded), kept)

    def _converting(self, registers: Sequence[str]) -> Sensor:
        """Return the sensor with the converter's scale (electrons per code, and offset) for a
        program that reads the analog registers named `registers`. Exposures are not spread over the
        whole scale if these registers forbid it."""
        from nscc_runtime.sensor import default_sensor

        program_sensor = default_sensor(converter_of_registers(self.target, registers))
        if self.sensor is None:
            return program_sensor
        # The chip's sensor describes a program that spreads: what this program changes is applied
        # to it.
        common = default_sensor(self.target)
        return self.sensor.changed(
            electrons_per_lsb=self.sensor.electrons_per_lsb
            * (program_sensor.electrons_per_lsb / common.electrons_per_lsb),
            adc_offset_lsb=self.sensor.adc_offset_lsb
            + program_sensor.adc_offset_lsb
            - common.adc_offset_lsb,
        )


def in_columns(frame: Array) -> bytes:
    """Return the bytes of `frame` (.., rows, cols) column by column, each from the top, as loaders
    send them."""
    return np.ascontiguousarray(frame.swapaxes(-2, -1)).tobytes()


def in_background(work: Callable[[], ExecutedFrame]) -> Future[ExecutedFrame]:
    """Run `work` in a daemon thread, which does not delay exit, and return the future of its
    result. An exception of `work` is raised by the future."""
    future: Future[ExecutedFrame] = Future()

    def run() -> None:
        """Call `work` and store its result or its exception in the future, for the thread that
        waits."""
        try:
            future.set_result(work())
        except Exception as error:
            future.set_exception(error)

    Thread(target=run, daemon=True).start()
    return future
