"""Record a loader's commands to its board, as programs for the emulator."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from struct import Struct
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nscc.operations import Op, Word, WordEffect
from nscc.words.container import Container, DecodeTable, Launch, Readout, StoredKernel
from nscc.words.encoding import decode
from nscc.words.machine import StatePlanes
from nscc.words.pictures import Constant, KeptPlane, Picture, Pictures, Source, TailLaunch
from nscc.words.plane_files import codes_of_planes
from nscc.words.reach import live_registers
from nscc_runtime.device.objects import RUN, WORD, unpacked_plane

if TYPE_CHECKING:
    from nscc.chips.target import Target

_JOB = Struct("<IIII")
_READOUT = Struct("<Id")
_EVENT = Struct("<Ii")
_LIGHT_FALLS = 0xFFFF_FFFF
_IN_IS_SET = 0xFFFF_FFFE
IMAGE = 256
"""Added to the register number of a readout that is an image, not a bucket."""


class BoardJob(NamedTuple):
    """A frame that a loader requests: number, channels to read out as a bit mask, program."""

    number: int
    channels: int
    container: Container


class Recording:
    """The commands of a loader to its board, received as records (`emulated/records.hpp`)."""

    def __init__(self, target: Target) -> None:
        self.target = target
        self._forget()

    def _forget(self) -> None:
        self._planes: dict[int, bytes] = {}
        self._latest: BoardJob | None = None
        self._words = self._runs = b""
        self._events: list[tuple[int, int]] = []

    def take(self, kind: bytes, data: bytes) -> BoardJob | None:
        """Process a record; return a job for the kind "J". Raises ValueError for an unknown
        kind."""
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
            case b"J":
                number, channels, readouts, states = _JOB.unpack_from(data)
                split = _JOB.size + readouts * _READOUT.size
                read = list(_READOUT.iter_unpack(data[_JOB.size : split]))
                container = self._container(read, list(data[split : split + states]))
                self._latest = BoardJob(number, channels, container)
                return self._latest
            case _:
                raise ValueError(f"a record of kind {kind!r}")
        return None

    def keep(self, job: BoardJob, planes: Mapping[str, bytes]) -> None:
        """Store the code registers after a frame, with which the program's next frame starts."""
        if job is self._latest:
            names = self.target.digital_registers
            self._planes = {names.index(name): plane for name, plane in planes.items()}

    def _container(self, readouts: Sequence[tuple[int, float]], states: Sequence[int]) -> Container:
        numbers: dict[tuple[int, int], int] = {}
        launches: list[Launch] = []
        boundary, level = 0, None
        for event, count in self._events:
            if event == _LIGHT_FALLS:
                boundary += count
            elif event == _IN_IS_SET:
                level = count
            else:
                kernel = numbers.setdefault((event, count), len(numbers))
                launches.append(Launch(boundary, kernel, level))
                level = None
        return container_of(
            self.target,
            readouts=readouts,
            kernels=[
                tuple(WORD.iter_unpack(self._words[first : first + count * WORD.size]))
                for first, count in numbers
            ],
            launches=launches,
            runs=list(RUN.iter_unpack(self._runs)),
            states=states,
            planes=self._planes,
        )


def container_of(
    target: Target,
    *,
    readouts: Sequence[tuple[int, float]],
    kernels: Sequence[tuple[Word, ...]],
    launches: Sequence[Launch],
    runs: Sequence[tuple[int, float]],
    states: Sequence[int],
    planes: dict[int, bytes],
) -> Container:
    """Return the commands to a chip as a container for the emulator. Each digital register that is
    sent with the frame is a state of one bit, with the register's name. Readouts are registers with
    gains; a register of an image has IMAGE added to it."""
    shape = (target.rows, target.cols)
    slot_us = tuple(us for count, us in runs for _ in range(count))
    bits: dict[str, NDArray[np.bool_]] = {}
    for number, data in planes.items():
        bits[target.digital_registers[number]] = unpacked_plane(data, shape)
    encoding, codes = codes_of_planes(bits, target)
    names = tuple(f"bucket{number}" for number in range(len(readouts)))
    registers = [register % IMAGE for register, _ in readouts]
    read = [target.digital_registers[number] for number in states]
    bit = np.array([[False], [True]])
    count = len(encoding)
    container = Container(
        target=target,
        slot_us=slot_us,
        buckets=names,
        table=DecodeTable(
            (),
            np.zeros((count, 0), np.int64),
            np.arange(count, dtype=np.int32),
            np.zeros((count, len(names), len(slot_us)), bool),
        ),
        kernels=tuple(StoredKernel(f"k{number}", words) for number, words in enumerate(kernels)),
        launches=tuple(launches),
        code_registers=tuple(bits),
        encoding=encoding,
        pixel_codes=np.zeros(shape, np.int32) if codes is None else codes,
        readouts=tuple(
            Readout(target.analog_registers[register], name, gain)
            for register, (_, gain), name in zip(registers, readouts, names, strict=True)
        ),
        notes={"table": "none"},
        state_planes={name: StatePlanes((name,), (0, 1), bit) for name in read},
    )
    return with_recorded_pictures(container, readouts, states) or container


def with_recorded_pictures(
    container: Container, readouts: Sequence[tuple[int, float]], states: Sequence[int]
) -> Container | None:
    """Return `container` with its last launches that do not read PIX as images and planes.

    Return None if there are no such launches, if earlier words compare analog values, or if the
    launches read a digital register that is not a code bit or that earlier words wrote.

    The exposures of the result are the contents of analog registers before these words. `readouts`
    are pairs of a register number, plus IMAGE for an image, and a gain. `states` are the numbers of
    digital registers that are read. Outputs are named after their registers. Code registers that
    these words write are kept states."""
    target, launches = container.target, container.launches
    kernels = [[decode(word) for word in kernel.words] for kernel in container.kernels]
    first = len(launches)
    while first and launches[first - 1].instant == container.slots:
        if "PIX" in live_registers(kernels[launches[first - 1].kernel], target)[0]:
            break
        first -= 1
    tail, before = launches[first:], launches[:first]
    live, written = live_registers(_ops(kernels, [each.kernel for each in tail]), target)
    exposing = _ops(kernels, [each.kernel for each in before])
    written_before = live_registers(exposing, target)[1]
    looks = any(op.operation.effect is WordEffect.FLAG_ANALOG for op in exposing)
    planes = frozenset(container.code_registers)
    known = frozenset((*target.analog_registers, "IN")) | (planes - written_before)
    if not tail or looks or not live <= known:
        return None
    images = [target.analog_registers[n - IMAGE] for n, _ in readouts if n >= IMAGE]
    buckets = [target.analog_registers[n] for n, _ in readouts if n < IMAGE]
    exposed = [name for name in target.analog_registers if name in {*live, *buckets}] or ["A"]
    bits = [target.digital_registers[number] for number in states]
    kept = [name for name in container.code_registers if name in written]
    level = None
    tail_launches = []
    for index, launch in enumerate(launches):
        level = launch.level if launch.level is not None else level
        if index >= first:
            tail_launches.append(TailLaunch(launch.kernel, level))
    names = {f"image {register}": register for register in images}
    names |= {f"plane {register}": register for register in bits}
    items = [
        Picture(name, Constant(False) if name.startswith("plane") else Source(exposed[0]))
        for name in names
    ]
    pictures = Pictures(
        (), tuple(items), None, dict.fromkeys(exposed, float("inf")), (*buckets, *names), (),
        tuple(kernel.words for kernel in container.kernels), tuple(tail_launches),
        {**names, **{register: register for register in (*buckets, *kept)}},
        states=tuple(KeptPlane(register, False, Constant(False)) for register in kept),
    )  # fmt: skip
    shutters = np.zeros((len(container.encoding), len(exposed), container.slots), np.bool_)
    numbers = sorted({launch.kernel for launch in before})
    return replace(
        container,
        buckets=tuple(exposed),
        table=replace(container.table, shutters=shutters),
        kernels=tuple(container.kernels[number] for number in numbers),
        launches=tuple(replace(each, kernel=numbers.index(each.kernel)) for each in before),
        pictures=pictures,
        readouts=tuple(Readout(register, register) for register in exposed),
        state_planes={},
    )


def _ops(kernels: Sequence[Sequence[Op]], numbers: Sequence[int]) -> list[Op]:
    return [op for number in numbers for op in kernels[number]]
