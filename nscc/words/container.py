"""The compiled program: everything that a device, the emulator or the proof needs, as one value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.chips.target import Target
from nscc.words.machine import StateMachine, StatePlanes
from nscc.words.pictures import Pictures
from nscc.words.stream import Stream

Word = tuple[int, int, int, int, int]
"""One ICW: five 32-bit words as the chip takes them."""


@dataclass(frozen=True)
class StoredKernel:
    """A recorded list of words, stored once and launched as often as the schedule says."""

    name: str
    words: tuple[Word, ...]


@dataclass(frozen=True)
class Launch:
    """Kernel number `kernel` runs at boundary `instant` (0..N: before slot `instant`'s light).

    `level` are the steps to which IN is set before; None leaves it as it is.
    """

    instant: int
    kernel: int
    level: int | None = None


@dataclass(frozen=True)
class Readout:
    """After the frame, the exposure of `bucket` in electrons is `register` times `gain`.

    Of a chip without logic `register` is a tap, and the electrons are those at the converter.
    """

    register: str
    bucket: str
    gain: float = 1.0


@dataclass(frozen=True, eq=False, repr=False)
class DecodeTable:
    """What each code means.

    `codes` int64 (codes, fields): the field values of every code that the program knows.
    `shutter_of_code` int32 (codes,): which of the distinct shutters each one opens.
    `shutters` bool (shutters, buckets, slots): S[n] of every distinct shutter, in each bucket.
    A program without fields has one code of no fields.
    """

    fields: tuple[str, ...]
    codes: NDArray[np.int64]
    shutter_of_code: NDArray[np.int32]
    shutters: NDArray[np.bool_]

    def __repr__(self) -> str:
        fields, (shutters, buckets, slots) = ", ".join(self.fields), self.shutters.shape
        return (
            f"DecodeTable({len(self.codes)} codes of ({fields}), {shutters} shutters, "
            f"{buckets} buckets, {slots} slots)"
        )


@dataclass(frozen=True, eq=False, repr=False)
class Container:
    """A compiled shutter program (`.icw`).

    `encoding` bool (shutters, registers of the target): what each digital register of a pixel with
    that shutter holds when a frame starts. `pixel_codes` int32 (rows, cols): row of
    `table.codes` at each pixel, None for a program without data. `code_registers` names the digital
    registers that carry code, in the order in which a device must load them (R12 before R0).
    `source_lines` is the program's text for listings; `notes` holds what the compiler wants to
    remember (lowering, class, open or fixed codes), strings only.

    Where shutters depend on the light, `machine` says how, and the rows of `encoding` and of the
    table's shutters are its behaviours: those are the shutters in the dark. `state_planes` says by
    name how registers hold the states that are read or kept.

    A chip without logic has no words: `stream` is what it is sent. It follows from table and
    pixels (`nscc.stream.lay`), and is None without pixels.

    `pictures` are images and planes that are computed after the last slot; their words follow all
    `launches`. `readouts` then say where the exposures are held before that.
    """

    target: Target
    slot_us: tuple[float, ...]
    buckets: tuple[str, ...]
    table: DecodeTable
    kernels: tuple[StoredKernel, ...]
    launches: tuple[Launch, ...]
    code_registers: tuple[str, ...]
    encoding: NDArray[np.bool_]
    pixel_codes: NDArray[np.int32] | None
    readouts: tuple[Readout, ...]
    source_lines: tuple[str, ...] = ()
    notes: Mapping[str, str] = field(default_factory=dict)
    machine: StateMachine | None = None
    state_planes: Mapping[str, StatePlanes] = field(default_factory=dict)
    stream: Stream | None = None
    pictures: Pictures | None = None

    def __getstate__(self) -> dict[str, Any]:
        """What copies and pickles take: the fields, without what others have analysed."""
        return {field.name: getattr(self, field.name) for field in fields(self)}

    @property
    def slot_s(self) -> NDArray[np.float64]:
        """The lengths of the slots (N,) in seconds."""
        return np.array(self.slot_us, np.float64) * 1e-6

    @property
    def slots(self) -> int:
        """Number of slots in the frame."""
        return len(self.slot_us)

    @property
    def buckets_read(self) -> tuple[str, ...]:
        """The buckets that come with a frame, in its order."""
        if self.pictures is None:
            return self.buckets
        return tuple(name for name in self.pictures.reads if name in self.buckets)

    @property
    def keeps_planes(self) -> bool:
        """Whether planes go on from frame to frame."""
        return self.pictures is not None and bool(self.pictures.states)

    @property
    def words_stored(self) -> int:
        """How many words the chip's store holds."""
        after = self.pictures.kernels if self.pictures else ()
        return sum(len(kernel.words) for kernel in self.kernels) + sum(map(len, after))

    @property
    def words_per_frame(self) -> int:
        """How many words a frame executes."""
        after = self.pictures.words if self.pictures else 0
        return sum(len(self.kernels[launch.kernel].words) for launch in self.launches) + after

    def __repr__(self) -> str:
        if self.target.streamed:
            planes = "no planes yet" if self.stream is None else f"{self.slots} planes"
            codes = len(self.table.codes)
            return f"Container({codes} codes, {self.slots} slots, {planes}, for {self.target.name})"
        return (
            f"Container({len(self.table.codes)} codes, {self.slots} slots, {self.words_stored} "
            f"words, {self.words_per_frame} a frame, for {self.target.name})"
        )

    @property
    def has_table(self) -> bool:
        """Whether the decode table says what codes mean; hand-written words may come without."""
        return self.notes.get("table") != "none"

    def planes(self) -> dict[str, NDArray[np.bool_]]:
        """The code planes (rows, cols) by register; empty without `pixel_codes`."""
        if self.pixel_codes is None:
            return {}
        shutter = self.table.shutter_of_code.astype(np.intp).take(self.pixel_codes)
        column = {name: i for i, name in enumerate(self.target.digital_registers)}
        return {name: self.encoding[:, column[name]].take(shutter) for name in self.code_registers}


def state_registers(container: Container) -> tuple[str, ...]:
    """The digital registers of which a host makes the states that are read, in their order."""
    machine = container.machine
    read = [state.name for state in machine.states if state.read] if machine else []
    registers = (r for name in read for r in container.state_planes[name].registers)
    return tuple(dict.fromkeys(registers))


def packed_shutters(
    container: Container, shutters: NDArray[np.bool_]
) -> tuple[NDArray[np.uint8], NDArray[np.int64]]:
    """`shutter` and `shutter_shape` of a container with pixels, as in a frame file.

    `shutters` bool (distinct shutters, buckets, N), the order of the decode table. The first is
    uint8 (buckets, rows, cols, ceil(N / 8)), packed along N with the first slot in the lowest bit,
    the second (buckets, rows, cols, N). ValueError for a container without pixels.
    """
    if container.pixel_codes is None:
        raise ValueError("a container without pixels has no shutters on the array")
    packed = np.packbits(shutters, axis=-1, bitorder="little")
    at_pixel = container.table.shutter_of_code[container.pixel_codes]
    laid = np.stack([packed[:, b][at_pixel] for b in range(shutters.shape[1])])
    shape = (*laid.shape[:3], shutters.shape[2])
    return laid, np.array(shape, np.int64)


def fields_at_pixels(container: Container) -> dict[str, NDArray[np.int64]]:
    """`codes_FIELD` (rows, cols) for each field of the code; empty without `pixel_codes`."""
    table, pixels = container.table, container.pixel_codes
    if pixels is None:
        return {}
    return {f"codes_{name}": table.codes[:, i][pixels] for i, name in enumerate(table.fields)}
