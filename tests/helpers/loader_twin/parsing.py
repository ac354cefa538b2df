"""What a loader makes of an object: checked before it is believed, sizes before anything else.

This is the Python twin of the firmware's `program.cpp`: same checks, in the same order, with the
same faults. What a word may be comes from `nscc.words`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from math import isfinite
from struct import Struct
from typing import Any

import numpy as np

from loader_twin.reports import Report
from loader_twin.timing import (
    LONGEST,
    LONGEST_SLOT_US,
    ON_TIME,
    TOO_LONG,
    Kept,
    fixed_point,
    frame_time,
)
from nscc.chips.target import Target
from nscc.operations import Word
from nscc.words.container import Launch
from nscc.words.encoding import matching
from nscc.words.legality import picture_fault, split_pairs
from nscc.words.soundness import MOST_SLOTS
from nscc_runtime.device.board import IMAGE, BoardCommands, BoardProgram, ExecutedFrame
from nscc_runtime.device.loaders import MOST_CHANGES, MOST_PARAMS
from nscc_runtime.device.messages import Channel, LoaderFault, frame_bytes, plane_bytes
from nscc_runtime.device.objects import (
    AS_IT_IS,
    CHANGE,
    COUNT,
    IS_IMAGE,
    IS_KEPT,
    IS_START,
    LEVEL,
    MOST_LAUNCHES,
    PARAM,
    READOUT,
    ROW,
    RUN,
    SCHEDULE_HEAD,
    SETS_LEVEL,
    WORD,
    ObjectKind,
)


@dataclass(eq=False)
class Refusal(Exception):
    """An object is not accepted: why, and where in it."""

    fault: LoaderFault
    detail: int = 0


@dataclass(frozen=True)
class Limits:
    """What a loader has room for."""

    words: int
    kernels: int = 1024
    rows: int = 16384
    runs: int = 4096
    frame_bytes: int = 1 << 23


@dataclass
class Held:
    """The objects of a program that a loader has accepted so far."""

    readouts: tuple[tuple[int, float], ...] | None = None
    kernels: tuple[tuple[Word, ...], ...] | None = None
    slots: int = 0
    runs: tuple[tuple[int, float], ...] | None = None
    rows: tuple[tuple[int, int, int], ...] = ()
    levels: tuple[int, ...] = ()
    states: tuple[int, ...] = ()
    reports: tuple[Report, ...] = ()
    planes: dict[int, bytes] | None = None
    grace: tuple[int, int] = (0, 0)
    """How many microseconds a launch may be late, and how many may be later."""
    params: tuple[tuple[int, int, int], ...] = ()
    """Lowest value, highest value and start."""
    values: tuple[int, ...] = ()
    changes: tuple[tuple[int, int, int, int, int], ...] = ()
    is_first: bool = True
    """Whether no frame of the program has ended yet."""
    kept_registers: tuple[int, ...] = ()
    analog: Mapping[str, Any] = field(default_factory=dict)
    kept: Kept = ON_TIME
    frame_us: int = 0
    """From a frame's first word to its last, once the program is whole."""

    def accept(self, kind: int, register: int, data: bytes, target: Target, most: Limits) -> None:
        """Check an object and keep it; raises Refusal."""
        match kind:
            case ObjectKind.READOUTS:
                self.readouts, self.kept_registers = _readouts(data, target)
            case ObjectKind.KERNELS:
                self.kernels = _kernels(data, target, most)
                # A schedule is one of certain kernels: it has to come again.
                self.runs, self.rows = None, ()
            case ObjectKind.SCHEDULE:
                self._schedule(data, most)
            case ObjectKind.PLANE:
                self._plane(register, data, target)
            case ObjectKind.LEVELS:
                self.runs, self.rows, self.levels = None, (), ()
                self.levels = _levels(data, target, most)
            case ObjectKind.STATES:
                self.states, self.reports = (), ()
                self.states = _states(data, target)
            case ObjectKind.REPORTS:
                self.reports = ()
                self.reports = _reports(data, target, self.states)
            case ObjectKind.PARAMS:
                self._take_params(data, target)
            case _:
                raise Refusal(LoaderFault.MALFORMED, kind)

    @staticmethod
    def check_room(kind: int, length: int, target: Target, most: Limits) -> None:
        """Refuse an object that is too long for its kind before any of it is kept."""
        rooms = {
            ObjectKind.READOUTS: COUNT.size + len(target.analog_registers) * READOUT.size,
            ObjectKind.KERNELS: COUNT.size * (1 + most.kernels) + most.words * WORD.size,
            ObjectKind.SCHEDULE: 5 * COUNT.size + most.runs * RUN.size + most.rows * ROW.size,
            ObjectKind.PLANE: plane_bytes(target.rows * target.cols),
            ObjectKind.LEVELS: COUNT.size + most.rows * LEVEL.size,
            ObjectKind.STATES: COUNT.size + len(target.digital_registers),
            ObjectKind.REPORTS: COUNT.size + len(target.digital_registers) * REPORT.size,
            ObjectKind.PARAMS: 2 * COUNT.size
            + MOST_PARAMS * PARAM.size
            + MOST_CHANGES * CHANGE.size,
        }
        if kind not in set(ObjectKind):
            raise Refusal(LoaderFault.MALFORMED, kind)
        if length > rooms[ObjectKind(kind)]:
            raise Refusal(LoaderFault.TOO_LARGE, length)

    def check_whole(self, target: Target) -> None:
        """Refuse a program of which something is missing, or whose frames take too long."""
        if self.readouts is None or self.kernels is None or self.runs is None:
            raise Refusal(LoaderFault.NO_PROGRAM)
        changed = {row for row, _, what, *_ in self.changes if what == SETS_LEVEL}
        self.frame_us, fault, self.kept = self._frame_time(self.rows, self.levels, target, changed)
        if fault:
            raise Refusal(LoaderFault.SCHEDULE, fault)

    def _frame_time(
        self, rows: Any, levels: Any, target: Target, changed: set[int]
    ) -> tuple[int, int, Kept]:
        held = set(self.planes or ())
        assert self.kernels is not None
        assert self.runs is not None
        return frame_time(self.kernels, self.runs, rows, levels, held, target, self.grace, changed)

    def keep_schedule(self, target: Target) -> None:
        """How the next frame keeps its schedule, with the values of parameters."""
        if self.changes:
            *_, self.kept = self._frame_time(*self.with_values(), target, set())

    def set_params(self, data: bytes) -> None:
        """Take values for all parameters, or none of them."""
        values = tuple(np.frombuffer(data, "<i4").tolist())
        for number, ((low, high, _), value) in enumerate(zip(self.params, values, strict=True)):
            if not low <= value <= high:
                raise Refusal(LoaderFault.PARAM, number)
        self.values = values

    def with_values(self) -> tuple[tuple[tuple[int, int, int], ...], tuple[int, ...]]:
        """The rows and levels for the values of parameters."""
        rows, levels = [*self.rows], [*self.levels]
        for row, param, what, factor, offset in self.changes:
            starts = what == IS_START
            result = (
                self.is_first * rows[row][2] if starts else offset + factor * self.values[param]
            )
            if what == SETS_LEVEL:
                levels[row] = result
            else:
                advance, kernel, most = self.rows[row]
                rows[row] = advance, kernel, min(max(result, 0), most)
        return tuple(rows), tuple(levels)

    def _take_params(self, data: bytes, target: Target) -> None:
        self.params, self.values, self.changes = (), (), ()
        if self.runs is None:
            raise Refusal(LoaderFault.SCHEDULE, 0)
        reader = Reader(data, LoaderFault.SCHEDULE)
        params = [*reader.rows(PARAM, reader.count(MOST_PARAMS))]
        changes = [*reader.rows(CHANGE, reader.count(MOST_CHANGES))]
        reader.end()
        for number, (low, high, start) in enumerate(params):
            if not low <= start <= high:
                raise Refusal(LoaderFault.PARAM, number)
        before = 0
        for row, param, what, factor, offset in changes:
            inside = before <= row < len(self.rows) and (what == IS_START or param < len(params))
            known = what <= IS_START and (self.levels if what == SETS_LEVEL else True)
            if not inside or not known or (what != SETS_LEVEL and self.rows[row][0]):
                raise Refusal(LoaderFault.SCHEDULE, 10)
            of_param = () if what == IS_START else params[param][:2]
            ends = [offset + factor * value for value in of_param]
            if what == SETS_LEVEL and not all(target.in_low <= e <= target.in_high for e in ends):
                raise Refusal(LoaderFault.SCHEDULE, 6)
            before = row
        self.params, self.changes = tuple(params), tuple(changes)
        self.values = tuple(start for *_, start in params)

    def _schedule(self, data: bytes, most: Limits) -> None:
        if self.kernels is None:
            raise Refusal(LoaderFault.SCHEDULE, 0)
        self.params, self.values, self.changes = (), (), ()
        reader = Reader(data, LoaderFault.SCHEDULE)
        slots, grace_ns, most_late = next(reader.rows(SCHEDULE_HEAD, 1))
        if not 1 <= slots <= MOST_SLOTS:
            raise Refusal(LoaderFault.SCHEDULE, 1)
        lengths = tuple(reader.rows(RUN, reader.count(most.runs)))
        if sum(count for count, _ in lengths) != slots or any(not n for n, _ in lengths):
            raise Refusal(LoaderFault.SCHEDULE, 2)
        if not all(0 < us < LONGEST_SLOT_US for _, us in lengths):
            raise Refusal(LoaderFault.SCHEDULE, 3)
        if sum(count * fixed_point(us) for count, us in lengths) > LONGEST:
            raise Refusal(LoaderFault.SCHEDULE, TOO_LONG)
        rows = tuple(ROW.iter_unpack(reader.take(reader.count(most.rows) * ROW.size)))
        reader.end()
        at = launches = 0
        for advance, kernel, times in rows:
            at += advance * times
            launches += times
            if not times or at > slots or launches > MOST_LAUNCHES or kernel >= len(self.kernels):
                raise Refusal(LoaderFault.SCHEDULE, 4)
        if self.levels and len(self.levels) != len(rows):
            raise Refusal(LoaderFault.SCHEDULE, 5)
        self.slots, self.runs, self.rows = slots, lengths, rows
        self.grace = grace_ns // 1000, most_late

    def _plane(self, register: int, data: bytes, target: Target) -> None:
        pixels = target.rows * target.cols
        planes = self.planes or {}
        if register >= len(target.digital_registers) or register in planes:
            raise Refusal(LoaderFault.PLANE, register)
        if len(data) != plane_bytes(pixels) or (pixels % 8 and data[-1] >> pixels % 8):
            raise Refusal(LoaderFault.PLANE, register)
        if target.digital_registers[register] == target.masked_register:
            # It takes a write only where the mask is 1, so the mask's own code has to come later.
            mask = target.mask_register
            if mask is not None and target.digital_registers.index(mask) in planes:
                raise Refusal(LoaderFault.PLANE, register)
        self.planes = {**planes, register: data}

    def take(self, executed: ExecutedFrame, target: Target) -> None:
        """What a frame left in registers: the next one begins with it."""
        numbers = {name: number for number, name in enumerate(target.digital_registers)}
        self.planes = {numbers[name]: plane for name, plane in executed.planes.items()}
        self.analog = executed.kept

    def load(self, register: int, plane: bytes, target: Target) -> None:
        """Another plane in place of one that the program has."""
        planes = dict(self.planes or {})
        if planes.pop(register, None) is None:
            raise Refusal(LoaderFault.PLANE, register)
        self.planes, before = planes, self.planes
        try:
            self._plane(register, plane, target)
        except Refusal:
            self.planes = before
            raise

    def frame_bytes(self, channels: int, target: Target) -> int:
        """Bytes of a frame in these channels."""
        pixels = target.rows * target.cols
        reports = sum(report.length for report in self.reports)
        return frame_bytes(channels, pixels, len(self.readouts or ()), len(self.states), reports)

    def with_reports(self, data: bytes, channels: int, target: Target) -> bytes:
        """A frame for the host: reports replace the planes that come last in the board's."""
        size = plane_bytes(target.rows * target.cols)
        reports = self.reports if channels & Channel.REPORTS else ()
        end = len(data) - size * len(reports)
        told = [
            report.of(data[end + size * n :][:size], target) for n, report in enumerate(reports)
        ]
        return data[:end] + b"".join(told)

    @property
    def too_late(self) -> bool:
        """Whether more launches are late than may be."""
        return self.kept.late > self.grace[1]

    def launches(self) -> Iterator[Launch]:
        """Every launch, in order."""
        at = 0
        rows, levels = self.with_values()
        for (advance, kernel, times), level in zip(
            rows, levels or (AS_IT_IS,) * len(rows), strict=True
        ):
            for _ in range(times):
                at += advance
                yield Launch(at, kernel, None if level == AS_IT_IS else level)

    def board_channels(self, channels: int) -> int:
        """What the board has to send: it knows no reports, but reads their planes as states."""
        reports = channels & Channel.REPORTS and self.reports
        return channels & ~Channel.REPORTS | (Channel.STATES if reports else 0)

    def program(self, target: Target, channels: int) -> BoardProgram:
        """The program for the emulator."""
        states = self.states if channels & Channel.STATES else ()
        if channels & Channel.REPORTS:
            states += tuple(report.register for report in self.reports)
        assert self.readouts is not None
        assert self.kernels is not None
        assert self.runs is not None
        commands = BoardCommands(
            readouts=self.readouts,
            kernels=self.kernels,
            launches=list(self.launches()),
            runs=self.runs,
            states=states,
            planes=self.planes or {},
            kept=[target.analog_registers[number] for number in self.kept_registers],
            analog=self.analog,
        )
        return commands.program(target)


class Reader:
    """Takes an object apart; `fault` for one that is too short or too long."""

    def __init__(self, data: bytes, fault: LoaderFault) -> None:
        self.data, self.fault, self.at = data, fault, 0

    def take(self, count: int) -> bytes:
        """So many bytes."""
        if len(self.data) - self.at < count:
            raise Refusal(self.fault, self.at)
        self.at += count
        return self.data[self.at - count : self.at]

    def count(self, most: int | None = None) -> int:
        """How many of something follow; TOO_LARGE where they are more than `most`."""
        count = int(COUNT.unpack(self.take(COUNT.size))[0])
        if most is not None and count > most:
            raise Refusal(LoaderFault.TOO_LARGE, count)
        return count

    def rows(self, layout: Struct, count: int) -> Iterator[Any]:
        """So many rows, one after the other."""
        for _ in range(count):
            yield layout.unpack(self.take(layout.size))

    def end(self) -> None:
        """Refuse what is left over."""
        if self.at != len(self.data):
            raise Refusal(self.fault, self.at)


def _readouts(data: bytes, target: Target) -> tuple[tuple[tuple[int, float], ...], tuple[int, ...]]:
    """The registers that are converted, with their gains, and those that are kept, in order."""
    reader = Reader(data, LoaderFault.READOUT)
    count = reader.count()
    if count > len(target.analog_registers):
        raise Refusal(LoaderFault.READOUT, count)
    found: list[tuple[int, int, float]] = []
    for row in reader.rows(READOUT, count):
        if row[0] >= len(target.analog_registers) or row[1] > IS_IMAGE | IS_KEPT:
            raise Refusal(LoaderFault.READOUT, row[0])
        found.append(row)
    reader.end()
    converted = [row for row in found if row[1] != IS_KEPT]
    for register, _, gain in converted:
        if not isfinite(gain):
            raise Refusal(LoaderFault.READOUT, register)
    kept = sorted({register for register, role, _ in found if role & IS_KEPT})
    readouts = ((register + IMAGE * (role & IS_IMAGE), gain) for register, role, gain in converted)
    return tuple(readouts), tuple(kept)


def _kernels(data: bytes, target: Target, most: Limits) -> tuple[tuple[Word, ...], ...]:
    reader = Reader(data, LoaderFault.MALFORMED)
    lengths = [reader.count() for _ in range(reader.count(most.kernels))]
    if sum(lengths) > most.words:
        raise Refusal(LoaderFault.TOO_LARGE, sum(lengths))
    kernels, number = [], 0
    for length in lengths:
        ops, words = [], []
        for word in reader.rows(WORD, length):
            operation = matching(word, target.words)
            if operation is None or picture_fault(operation, target) is not None:
                raise Refusal(LoaderFault.WORD, number)
            ops.append(operation)
            words.append(word)
            number += 1
        if split_pairs("", ops):
            raise Refusal(LoaderFault.WORD, number)
        kernels.append(tuple(words))
    reader.end()
    return tuple(kernels)


def _levels(data: bytes, target: Target, most: Limits) -> tuple[int, ...]:
    reader = Reader(data, LoaderFault.SCHEDULE)
    levels = tuple(level for (level,) in reader.rows(LEVEL, reader.count(most.rows)))
    reader.end()
    if any(level != AS_IT_IS and not target.in_low <= level <= target.in_high for level in levels):
        raise Refusal(LoaderFault.SCHEDULE, 6)
    return levels


def _states(data: bytes, target: Target) -> tuple[int, ...]:
    reader = Reader(data, LoaderFault.READOUT)
    count = reader.count()
    if count > len(target.digital_registers):
        raise Refusal(LoaderFault.READOUT, count)
    registers = tuple(reader.take(count))
    reader.end()
    for register in registers:
        if register >= len(target.digital_registers):
            raise Refusal(LoaderFault.READOUT, register)
    return registers


REPORT = Struct("<B3xI4H")


def _reports(data: bytes, target: Target, sent: tuple[int, ...]) -> tuple[Report, ...]:
    reader = Reader(data, LoaderFault.READOUT)
    count = reader.count()
    if count > len(target.digital_registers):
        raise Refusal(LoaderFault.READOUT, count)
    reports: list[Report] = []
    for row in (next(reader.rows(REPORT, 1)) for _ in range(count)):
        report = Report(*row)
        known = {*sent, *(each.register for each in reports)}
        inside = report.register < len(target.digital_registers)
        if not inside or report.register in known or report.most > target.rows * target.cols:
            raise Refusal(LoaderFault.READOUT, report.register)
        reports.append(report)
    reader.end()
    return tuple(reports)
