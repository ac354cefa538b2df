"""A compiled program as the objects that a loader receives.

    READOUTS   u32 count; each: u8 analog register, u8 whether it is an image, 6 free, f64 gain
    KERNELS    u32 count, u32 words of each kernel, then the words, five u32 each
    SCHEDULE   u32 slots; u32 grace in nanoseconds; u32 most late launches;
               u32 runs, each: u32 slots, f64 microseconds of each of them;
               u32 rows, each: u32 advance, u16 kernel, u16 times
    PLANE      one bit a pixel, row by row from the top left, the first in the lowest bit
    LEVELS     u32 count; each: i16 steps of IN, for the rows of the SCHEDULE that follows
    STATES     u32 count; each: u8 digital register that comes with the frame
    REPORTS    u32 count; each: u8 digital register, 3 free, u32 most coordinates, u16 columns on
               the left and right and rows at the top and bottom that are left out

Registers are numbered as in the target table. A row of the schedule is executed `times` times: the
light of `advance` slots is collected, IN is set to the row's level (unless it is AS_IT_IS), and the
kernel runs. Remaining slots follow the last row. A launch later than `grace` after its boundary is
late. Only programs that look have LEVELS and STATES."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property
from hashlib import sha256
from itertools import groupby
from math import ceil
from struct import Struct

import numpy as np
from numpy.typing import NDArray

from nscc.chips.load import target_dict
from nscc.chips.target import Target
from nscc.diagnostics.rejection import rejected
from nscc.words.container import Container, state_registers, with_picture_words
from nscc.words.legality import loader_fault, refuse_planes
from nscc.words.reach import Reach, film_reaches
from nscc_runtime.caches import OfContainer
from nscc_runtime.device.messages import Begin, ObjectEntry, plane_bytes
from nscc_runtime.emulator.capture import check_codes
from nscc_runtime.neighbours.plane_summary import NO_BOX, PlaneSummary

MOST_TIMES = (1 << 16) - 1
MOST_LAUNCHES = 1 << 20
"""Largest number of launches of a frame, for any number of rows."""
READOUT = Struct("<BB6xd")
SCHEDULE_HEAD = Struct("<III")
RUN = Struct("<Id")
ROW = Struct("<IHH")
COUNT = Struct("<I")
_REGISTER = Struct("<B")
_REPORT = Struct("<B3xI4H")
WORD = Struct("<5I")
LEVEL = Struct("<h")
AS_IT_IS = -32768
"""The level of a row that leaves IN unchanged."""


class ObjectKind(IntEnum):
    """The kind of an object of an upload."""

    READOUTS = 1
    KERNELS = 2
    SCHEDULE = 3
    PLANE = 4
    LEVELS = 5
    STATES = 6
    REPORTS = 7


@dataclass(frozen=True)
class Object:
    """An object of an upload. `register`: the register of a plane, 0 for other kinds."""

    kind: ObjectKind
    register: int
    data: bytes

    @cached_property
    def entry(self) -> ObjectEntry:
        """The entry of the object in DECLARE."""
        return ObjectEntry(self.kind, self.register, len(self.data), sha256(self.data).digest())


@dataclass(frozen=True)
class Upload:
    """A program in the form that is sent.

    `words`, `kernels`, `rows`, `runs`: its demands on a loader's memory. `frame_ms`, `readout_ms`:
    its times. `readouts`, `states`: numbers of registers sent with a frame of `pixels`;
    `report_bytes`: bytes of its reports. `gains`: whether readouts are scaled. `levels`: whether IN
    is set; `pictures`: images and planes are computed."""

    target: bytes
    label: bytes
    objects: tuple[Object, ...]
    words: int
    kernels: int
    rows: int
    runs: int
    frame_ms: int
    readout_ms: int
    readouts: int
    states: int
    report_bytes: int
    gains: bool
    levels: bool
    pictures: bool
    pixels: int

    @cached_property
    def digest(self) -> bytes:
        """The SHA-256 digest of the program."""
        entries = b"".join(object_.entry.pack() for object_ in self.objects)
        return program_digest(self.target, self.label, entries)

    @cached_property
    def stream(self) -> bytes:
        """The bytes of all objects, concatenated."""
        return b"".join(object_.data for object_ in self.objects)

    @property
    def begin(self) -> Begin:
        """The message that announces the program."""
        return Begin(self.target, self.digest, self.label, len(self.stream), len(self.objects))


def program_digest(target: bytes, label: bytes, entries: bytes) -> bytes:
    """Return the digest of a program from its target's digest, label and packed entries."""
    return sha256(b"nscc-program-1" + target + label + entries).digest()


def target_digest(target: Target) -> bytes:
    """Return the SHA-256 digest by which loader and host identify a target."""
    values = target_dict(target)
    del values["description"]
    text = json.dumps(values, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return sha256(text.encode("ascii")).digest()


def upload_of(container: Container, label: bytes, *, reports: bool = True) -> Upload:
    """Return a container in the form that is sent; `label` is 32 bytes. With `reports`, the device
    sends `device_reports` instead of their planes. Raises Rejected: NS0741 for a program without
    pixel codes, NS0510 for a program with planes instead of words."""
    refuse_planes(
        container.target,
        "the loader runs words, but this program has planes of bits",
        "`nscc build --emit planes` writes an .npz for a driver of the chip",
    )
    check_codes(container)
    fault = loader_fault(container)
    if fault is not None:
        raise rejected(
            "NS0765",
            f"no loader of this version of nscc supports the program: {fault}",
            helps=("run it on the emulator: leave --on out",),
        )
    reported = device_reports(container) if reports else {}
    pictures, container = container.pictures, with_picture_words(container)
    target, readouts = container.target, _readouts(container)
    rows = list(schedule_rows(container))
    runs = [(len(list(same)), us) for us, same in groupby(container.slot_us)]
    levels = [(AS_IT_IS if level is None else level,) for *_, level in rows]
    sets_in = any(level != (AS_IT_IS,) for level in levels)
    # The time of the loop, whose clock may have a resolution of one microsecond.
    grace_ns = min(round(1000 * target.wait_us) + 1000, (1 << 32) - 1)
    schedule = SCHEDULE_HEAD.pack(container.slots, grace_ns, 0)
    schedule += _counted(RUN, runs) + _counted(ROW, [row[:3] for row in rows])
    number_of = target.digital_registers.index
    sent = (name for name in state_registers(container) if name not in reported)
    states = [(number_of(name),) for name in sent]
    objects = [Object(ObjectKind.READOUTS, 0, _counted(READOUT, readouts))]
    if states:
        objects.append(Object(ObjectKind.STATES, 0, _counted(_REGISTER, states)))
    if reported:
        report_rows = [(number_of(name), most, *reach) for name, (most, reach) in reported.items()]
        objects.append(Object(ObjectKind.REPORTS, 0, _counted(_REPORT, report_rows)))
    lengths = [len(kernel.words) for kernel in container.kernels]
    words = [word for kernel in container.kernels for word in kernel.words]
    kernels = COUNT.pack(len(lengths)) + np.array(lengths, "<u4").tobytes()
    kernels += np.array(words, "<u4").reshape(-1, 5).tobytes()
    objects.append(Object(ObjectKind.KERNELS, 0, kernels))
    if sets_in:
        objects.append(Object(ObjectKind.LEVELS, 0, _counted(LEVEL, levels)))
    objects.append(Object(ObjectKind.SCHEDULE, 0, schedule))
    planes = container.planes()
    # Writes to the masked register use the mask, so its plane is sent before the mask's plane.
    for register in sorted(planes, key=lambda name: name != target.masked_register):
        plane = packed_plane(planes[register])
        objects.append(Object(ObjectKind.PLANE, number_of(register), plane))
    return Upload(
        target_digest(target),
        label,
        tuple(objects),
        words=len(words),
        kernels=len(container.kernels),
        rows=len(rows),
        runs=len(runs),
        frame_ms=ceil(sum(container.slot_us) / 1000),
        readout_ms=ceil(len(readouts) * target.readout_us / 1000),
        readouts=len(readouts),
        states=len(states),
        report_bytes=sum(report_bytes(most) for most, _ in reported.values()),
        gains=any(gain != 1 for *_, gain in readouts),
        levels=sets_in,
        pictures=bool(pictures.kernels),
        pixels=target.rows * target.cols,
    )


def packed_plane(plane: NDArray[np.bool_]) -> bytes:
    """Return a plane (rows, cols) as the bytes of a PLANE object."""
    return np.packbits(plane, axis=None, bitorder="little").tobytes()


def unpacked_plane(data: bytes, shape: tuple[int, int]) -> NDArray[np.bool_]:
    """Return the plane (rows, cols) of a PLANE object."""
    bits = np.frombuffer(data, np.uint8)
    flat = np.unpackbits(bits, count=shape[0] * shape[1], bitorder="little")
    return flat.view(np.bool_).reshape(shape)


def _readouts(container: Container) -> list[tuple[int, bool, float]]:
    """Return for each register that a device converts its number, whether it holds an image, and
    its gain."""
    registers, buckets = container.target.analog_registers, container.buckets
    return [
        (registers.index(each.register), each.bucket not in buckets, each.gain)
        for each in container.readouts
    ]


def _counted(layout: Struct, rows: Sequence[tuple[float, ...]]) -> bytes:
    """Return the number of rows and the rows as bytes."""
    return COUNT.pack(len(rows)) + b"".join(layout.pack(*row) for row in rows)


def schedule_rows(container: Container) -> Iterator[tuple[int, int, int, int | None]]:
    """Yield the rows of a schedule: slots to advance, kernel, number of equal launches, and
    value of IN or None."""
    at = 0
    steps = []
    for launch in container.launches:
        steps.append((launch.instant - at, launch.kernel, launch.level))
        at = launch.instant
    for (advance, kernel, level), same in groupby(steps):
        times = len(list(same))
        for launched in range(0, times, MOST_TIMES):
            yield advance, kernel, min(times - launched, MOST_TIMES), level


_COORDINATES = 4
_SUMMARY = Struct("<I4H")


def report_bytes(most: int) -> int:
    """Return the number of bytes of a report of at most `most` coordinates: the coordinates (u16 x,
    u16 y) of the first bits of a plane that are 1, then the u32 number of bits and the u16
    coordinates of the box around them. Coordinates that do not exist are 0xFFFF."""
    return _COORDINATES * most + _SUMMARY.size


@OfContainer
def device_reports(container: Container) -> dict[str, tuple[int, Reach]]:
    """Return the reports that need fewer bytes than their planes, by register: the most
    coordinates, and the margin of the plane.

    Planes that are read are sent anyway, and a margin that changes from frame to frame is known to
    the host only."""
    pictures, target = container.pictures, container.target
    if not pictures.reports:
        return {}
    film = film_reaches(container)
    if film is None or len(film) > 1:
        return {}
    reported: dict[str, tuple[int, Reach]] = {}
    for report in pictures.reports:
        register = pictures.registers[report.plane]
        most = max(report.most, reported.get(register, (0,))[0])
        reported[register] = most, film[0][report.plane]
    read = {pictures.registers[name] for name in pictures.reads}
    size = plane_bytes(target.rows * target.cols)
    return {
        name: (most, reach)
        for name, (most, reach) in reported.items()
        if name not in read and report_bytes(most) < size
    }


def split_reports(
    reports: dict[str, tuple[int, Reach]], data: bytes
) -> tuple[bytes, dict[str, PlaneSummary]]:
    """Return the bytes of a frame before its reports, and the summaries of planes by register."""
    summaries: dict[str, PlaneSummary] = {}
    for register, (most, _) in reversed(reports.items()):
        data, report = data[: -report_bytes(most)], data[-report_bytes(most) :]
        places = np.frombuffer(report, "<u2", 2 * most).reshape(most, 2)
        count, *box = _SUMMARY.unpack_from(report, _COORDINATES * most)
        places = places[: min(count, most)]
        summaries[register] = count, box if count else NO_BOX, places.astype(np.int32)
    return data, summaries
