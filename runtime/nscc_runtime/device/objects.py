"""A compiled program as the objects that a loader receives.

    READOUTS   u32 count; each: u8 analog register, u8 role, 6 free, f64 gain; the role is 0 for a
               bucket, 1 for an image, 2 for what is only kept, and 3 for a kept image
    KERNELS    u32 count, u32 words of each kernel, then the words, five u32 each
    SCHEDULE   u32 slots; u32 grace in nanoseconds; u32 most late launches;
               u32 runs, each: u32 slots, f64 microseconds of each of them;
               u32 rows, each: u32 advance, u16 kernel, u16 times
    PLANE      one bit a pixel, row by row from the top left, the first in the lowest bit
    LEVELS     u32 count; each: i16 steps of IN, for the rows of the SCHEDULE that follows
    STATES     u32 count; each: u8 digital register that comes with the frame
    REPORTS    u32 count; each: u8 digital register, 3 free, u32 most coordinates, u16 columns on
               the left and right and rows at the top and bottom that are left out
    PARAMS     u32 count; each: i32 low, i32 high, i32 start;
               u32 changes, each: u32 row, u8 parameter, u8 change, i16 factor, i32 offset

Registers are numbered as in the target table. A row of the schedule is executed `times` times: the
light of `advance` slots is collected, IN is set to the row's level (unless it is AS_IT_IS), and the
kernel runs. Remaining slots follow the last row. A launch later than `grace` after its boundary is
late. Only programs that look have LEVELS and STATES. A change 0 sets the level of a row to `factor`
times the parameter. A change 1 sets its number of launches to `offset` plus `factor` times the
parameter, at least 0 and at most `times`. A change 2 leaves a row out of all frames but the
first."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import replace
from enum import IntEnum
from functools import cached_property
from hashlib import sha256
from itertools import groupby
from math import ceil
from struct import Struct
from typing import Any

import numpy as np

from nscc.arrays import Bools
from nscc.chips.load import target_dict
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import rejected
from nscc.record import Record
from nscc.words.container import (
    Container,
    kept_starts,
    state_registers,
    steered_launches,
    with_picture_words,
)
from nscc.words.legality import loader_fault, refuse_planes
from nscc.words.picture_launches import SteeredLaunch
from nscc.words.pictures import Pictures
from nscc.words.reach import Reach, film_reaches
from nscc_runtime.caches import OfContainer
from nscc_runtime.device.messages import Begin, ObjectEntry, frame_bytes, plane_bytes
from nscc_runtime.emulator.capture import check_codes
from nscc_runtime.neighbours.plane_summary import NO_BOX, PlaneSummary

MOST_TIMES = (1 << 16) - 1
"""Largest number of launches of one row."""
MOST_LAUNCHES = 1 << 20
"""Largest number of launches of a frame, for any number of rows."""
READOUT = Struct("<BB6xd")
SCHEDULE_HEAD = Struct("<III")
RUN = Struct("<Id")
ROW = Struct("<IHH")
COUNT = Struct("<I")
_REGISTER = Struct("<B")
_REPORT = Struct("<B3xI4H")
PARAM = Struct("<3i")
CHANGE = Struct("<IBBhi")
SETS_LEVEL, SETS_TIMES, IS_START = 0, 1, 2
"""The kinds of changes in PARAMS."""
IS_IMAGE, IS_KEPT = 1, 2
"""The role of a register in READOUTS, a bit each; what is only kept is not read out."""
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
    PARAMS = 8


class Object(Record):
    """An object of an upload. `register`: the register of a plane, 0 for other kinds."""

    kind: ObjectKind
    register: int
    data: bytes

    @cached_property
    def entry(self) -> ObjectEntry:
        """The entry of the object in DECLARE."""
        return ObjectEntry(self.kind, self.register, len(self.data), sha256(self.data).digest())


class Upload(Record):
    """A program in the form that is sent.

    `target`, `label`: 32 bytes each, the digest of the target table and a label of the host.
    `objects`: in the order of sending. `words`, `kernels`, `rows`, `runs`: its demands on a
    loader's memory. `frame_ms`, `readout_ms`: its times. `readouts`, `states`: numbers of registers
    sent with a frame of `pixels`; `report_bytes`: bytes of its reports. `params`, `changes`:
    numbers of parameters, and of changes of rows.

    `gains`: whether a readout has a gain other than 1. `levels`: whether IN (the level sent to all
    pixels) is set. `pictures`: whether images and planes are computed. `host_values`: whether the
    host sets or loads values, or images are kept."""

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
    host_values: bool = False
    params: int = 0
    changes: int = 0

    @cached_property
    def digest(self) -> bytes:
        """The SHA-256 digest of the program: of its target, its label and the entries of its
        objects."""
        entries = b"".join(object_.entry.pack() for object_ in self.objects)
        return program_digest(self.target, self.label, entries)

    def needs(self, channels: int) -> dict[str, int]:
        """Return how much the program needs of each of a loader's RESOURCES, by its name.
        `channels`, bits of `Channel`, are the parts of a frame that the host wants."""
        size = frame_bytes(channels, self.pixels, self.readouts, self.states, self.report_bytes)
        fields = ("words", "kernels", "rows", "runs", "frame_ms", "params", "changes")
        return {"frame_bytes": size, **{name: getattr(self, name) for name in fields}}

    @cached_property
    def stream(self) -> bytes:
        """The bytes of all objects, concatenated."""
        return b"".join(object_.data for object_ in self.objects)

    @property
    def begin(self) -> Begin:
        """The message that announces the program."""
        return Begin(self.target, self.digest, self.label, len(self.stream), len(self.objects))


def program_digest(target: bytes, label: bytes, entries: bytes) -> bytes:
    """Return the digest (32 bytes) of a program from its target's digest, its label, both 32 bytes,
    and the packed `entries` of its objects."""
    return sha256(b"nscc-program-1" + target + label + entries).digest()


def target_digest(target: Target) -> bytes:
    """Return the SHA-256 digest (32 bytes) that identifies a target to loader and host: of all its
    values but the description."""
    values = target_dict(target)
    del values["description"]
    text = json.dumps(values, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return sha256(text.encode("ascii")).digest()


def upload_of(container: Container, label: bytes, *, reports: bool = True) -> Upload:
    """Return a container (a compiled program) in the form that is sent; `label` is 32 bytes. With
    `reports`, the device sends `device_reports` instead of their planes.

    Raises Rejected: NS0741 for a program without pixel codes, NS0510 for a program with planes
    instead of words, NS0765 for a program that no loader supports."""
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
    return program_of(container, label, reports=reports)


def program_of(
    container: Container, label: bytes, *, reports: bool = True, with_planes: bool = True
) -> Upload:
    """Return what `upload_of` does, without its checks; without `with_planes`, the planes of pixel
    codes are left out, and the container needs no codes."""
    reported = device_reports(container) if reports else {}
    starts, steered = kept_starts(container), steered_launches(container)
    pictures, container = container.pictures, with_picture_words(container)
    target, readouts = container.target, _readouts(container)
    rows = list(schedule_rows(container, steered))
    changes = _changes(rows, pictures)
    runs = [(len(list(same)), us) for us, same in groupby(container.slot_us)]
    levels = [(AS_IT_IS if row.level is None else row.level,) for row in rows]
    sets_in = any(level != (AS_IT_IS,) for level in levels) or bool(pictures.levels_of)
    # The time of the loop, whose clock may have a resolution of one microsecond.
    grace_ns = min(round(1000 * target.wait_us) + 1000, (1 << 32) - 1)
    schedule = SCHEDULE_HEAD.pack(container.slots, grace_ns, 0)
    schedule += _counted(RUN, runs)
    schedule += _counted(ROW, [(row.advance, row.kernel, row.times) for row in rows])
    number_of = target.digital_registers.index
    sent = (name for name in state_registers(container) if name not in reported)
    states = [(number_of(name),) for name in sent]
    kept = [target.analog_registers.index(name) for same in starts.values() for name in same]
    roles = [(r, role | IS_KEPT * (r in kept), gain) for r, role, gain in readouts]
    roles += [(r, IS_KEPT, 1.0) for r in kept if r not in {row[0] for row in readouts}]
    report_rows = [(number_of(name), most, *reach) for name, (most, reach) in reported.items()]
    lengths = [len(kernel.words) for kernel in container.kernels]
    # The kernel without words of `schedule_rows`, if a row uses it.
    lengths += [0] * any(row.kernel == len(lengths) for row in rows)
    words = [word for kernel in container.kernels for word in kernel.words]
    kernels = COUNT.pack(len(lengths)) + np.array(lengths, "<u4").tobytes()
    kernels += np.array(words, "<u4").reshape(-1, 5).tobytes()
    ranges = [(param.low, param.high, param.start) for param in pictures.params]
    # The objects in the order of sending, and whether the program has each.
    parts = (
        (ObjectKind.READOUTS, True, _counted(READOUT, roles)),
        (ObjectKind.STATES, states, _counted(_REGISTER, states)),
        (ObjectKind.REPORTS, reported, _counted(_REPORT, report_rows)),
        (ObjectKind.KERNELS, True, kernels),
        (ObjectKind.LEVELS, sets_in, _counted(LEVEL, levels)),
        (ObjectKind.SCHEDULE, True, schedule),
        (ObjectKind.PARAMS, ranges or kept, _counted(PARAM, ranges) + _counted(CHANGE, changes)),
    )
    objects = [Object(kind, 0, data) for kind, is_part, data in parts if is_part]
    if with_planes:
        objects += _plane_objects(container)
    return Upload(
        target_digest(target),
        label,
        tuple(objects),
        words=len(words),
        kernels=len(lengths),
        rows=len(rows),
        runs=len(runs),
        frame_ms=ceil(sum(container.slot_us) / 1000),
        readout_ms=ceil(len(readouts) * target.readout_us / 1000),
        readouts=len(readouts),
        states=len(states),
        report_bytes=sum(report_bytes(most) for most, _ in reported.values()),
        params=len(pictures.params),
        changes=len(changes),
        gains=any(gain != 1 for *_, gain in readouts),
        levels=sets_in,
        pictures=bool(pictures.kernels),
        host_values=pictures.has_host_values or bool(kept),
        pixels=target.rows * target.cols,
    )


def _plane_objects(container: Container) -> Iterator[Object]:
    """Yield the bit planes that a device loads before the program's first frame, each as an object
    of the upload, in the order of sending."""
    planes, target = container.planes(), container.target
    # Writes to the masked register use the mask, so its plane is sent before the mask's plane.
    for register in sorted(planes, key=lambda name: name != target.masked_register):
        number = target.digital_registers.index(register)
        yield Object(ObjectKind.PLANE, number, packed_plane(planes[register]))


def packed_plane(plane: Bools) -> bytes:
    """Return a plane (rows, cols) as the bytes of a PLANE object: a bit for each pixel, row by row,
    the first in the lowest bit."""
    return np.packbits(plane, axis=None, bitorder="little").tobytes()


def unpacked_plane(data: bytes, shape: tuple[int, int]) -> Bools:
    """Return the plane of `shape` (rows, cols) in the bytes of a PLANE object, which must have a
    bit for each pixel."""
    bits = np.frombuffer(data, np.uint8)
    flat = np.unpackbits(bits, count=shape[0] * shape[1], bitorder="little")
    return flat.view(np.bool_).reshape(shape)


def _readouts(container: Container) -> list[tuple[int, int, float]]:
    """Return the number, the role (0 bucket, 1 image) and the gain of each register that a device
    converts, in the order of readout."""
    registers, buckets = container.target.analog_registers, len(container.buckets_read)
    return [
        (registers.index(each.register), IS_IMAGE * (place >= buckets), each.gain)
        for place, each in enumerate(container.readouts)
    ]


def _counted(layout: Struct, rows: Sequence[tuple[float, ...]]) -> bytes:
    """Return the number of `rows` and the rows, each packed by `layout`, as bytes."""
    return COUNT.pack(len(rows)) + b"".join(layout.pack(*row) for row in rows)


class ScheduleRow(Record):
    """A row of a schedule.

    `advance`: number of slots that pass before it. `kernel`: number of the kernel. `times`: number
    of its launches (starts of kernels). `level`: steps of IN (the level sent to all pixels), None
    to leave it. `steered`: its first launch, if values of parameters or the number of the frame
    change the row, else None."""

    advance: int
    kernel: int
    times: int
    level: int | None
    steered: SteeredLaunch | None


def schedule_rows(
    container: Container, steered: Sequence[SteeredLaunch | None]
) -> Iterator[ScheduleRow]:
    """Yield the rows of a schedule, each for equal launches (starts of kernels) of `container`.

    `steered` says of each launch how parameters change it, as `steered_launches` returns it. The
    steps of a loop with one launch are one row. The light never falls before a launch that may be
    left out, but before a kernel without words, whose number is the next after those of the
    container. A kernel is a list of words."""
    at = 0
    steps: list[tuple[tuple[Any, ...], SteeredLaunch | None]] = []
    for number, (launch, of) in enumerate(zip(container.launches, steered, strict=True)):
        if of is not None and (of.times is not None or of.is_start) and launch.instant > at:
            steps.append(((launch.instant - at, len(container.kernels), None), None))
            at = launch.instant
        advance, at = launch.instant - at, launch.instant
        shared = of.shared(number) if of else ()
        steps.append(((advance, launch.kernel, launch.level, *shared), of))
    for (advance, kernel, level, *_), same in groupby(steps, lambda step: step[0]):
        (_, of), *others = same
        for done in range(0, 1 + len(others), MOST_TIMES):
            times = min(1 + len(others) - done, MOST_TIMES)
            later = replace(of, step=of.step + done) if of and of.is_changed else None
            yield ScheduleRow(advance, kernel, times, level, later)


def _changes(rows: Sequence[ScheduleRow], pictures: Pictures) -> list[tuple[int, ...]]:
    """Return how parameters change `rows` of a schedule, as the object PARAMS contains it: (row,
    parameter, change, factor, offset) each. `pictures` has the parameters, which are numbered in
    their order."""
    number = [param.name for param in pictures.params].index
    changes: list[tuple[int, ...]] = []
    for place, steering in enumerate(row.steered for row in rows):
        if steering is None:
            continue
        if steering.is_start:
            changes.append((place, 0, IS_START, 0, 0))
        if steering.level_of is not None:
            changes.append(
                (place, number(steering.level_of.param), SETS_LEVEL, steering.level_of.factor, 0)
            )
        if steering.times is not None:
            # A row that begins with a later step of a loop has as many launches fewer.
            offset = steering.times.offset - steering.step
            changes.append(
                (place, number(steering.times.param), SETS_TIMES, steering.times.factor, offset)
            )
    return changes


_COORDINATES = 4
"""Number of bytes of a pair of coordinates."""
_SUMMARY = Struct("<I4H")


def report_bytes(most: int) -> int:
    """Return the number of bytes of a report of at most `most` coordinates: the coordinates (u16 x,
    u16 y) of the first bits of a plane that are 1, then the u32 number of bits and the u16
    coordinates of the box around them. Coordinates that do not exist are 0xFFFF."""
    return _COORDINATES * most + _SUMMARY.size


@OfContainer
def device_reports(container: Container) -> dict[str, tuple[int, Reach]]:
    """Return the reports that need fewer bytes than their planes, by register: the most
    coordinates, and the margin of the plane that is left out.

    Planes that are read are sent anyway, and are not reported. A margin that changes from frame to
    frame, or with a parameter, is known to the host only: then there are no reports, {}."""
    pictures, target = container.pictures, container.target
    if not pictures.reports or pictures.steps_are_set:
        return {}
    film = film_reaches(container)
    if film is None or len(film) > 1:
        return {}
    reported: dict[str, tuple[int, Reach]] = {}
    for report in pictures.reports:
        if report.kind == "sum":
            continue
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
    """Return the bytes of a frame before its reports, and the summaries of planes by register.
    `data` is the whole frame; its last bytes are those of `reports`, in this order, as
    `device_reports` returns them."""
    summaries: dict[str, PlaneSummary] = {}
    for register, (most, _) in reversed(reports.items()):
        data, report = data[: -report_bytes(most)], data[-report_bytes(most) :]
        places = np.frombuffer(report, "<u2", 2 * most).reshape(most, 2)
        count, *box = _SUMMARY.unpack_from(report, _COORDINATES * most)
        places = places[: min(count, most)]
        summaries[register] = count, box if count else NO_BOX, places.astype(np.int32)
    return data, summaries
