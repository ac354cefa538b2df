"""Record a loader's commands to its board, as programs for the emulator."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from struct import Struct
from typing import Any, NamedTuple

from nscc.chips.target import Target
from nscc.operations import Word
from nscc.words.container import Launch
from nscc.words.encoding import decode
from nscc_runtime.device.objects import RUN, WORD, unpacked_plane
from nscc_runtime.emulator.chip_program import ChipProgram

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
