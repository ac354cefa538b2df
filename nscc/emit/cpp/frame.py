"""The launch schedule of a frame as a C++ table: time, kernel and value of IN for each launch.

Times are measured from the frame's first word, so that errors of waits, launches and words do not
accumulate. The exposure begins a whole number of microseconds after the first word. Each launch
happens in the first whole microsecond after its boundary, never before the boundary."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from itertools import accumulate
from math import ceil
from typing import Any, Self

from nscc.chips.target import Target
from nscc.emit.cpp.cpp_text import remarked, safe, template_lines
from nscc.operations import WordEffect
from nscc.words.assembly_text import ranges_text
from nscc.words.container import Container, StoredKernel
from nscc.words.encoding import decode
from nscc.words.picture_launches import HostParam, SteeredLaunch

LONGEST_GAP_US = 1 << 30
"""Longest wait: a 32-bit clock can order times that differ by less than half of its range."""
MOST_TIMES = (1 << 16) - 1
"""Most launches of a table row: its count has 16 bits."""
AS_IT_IS = -32768
"""The value in the table for a launch that does not set IN."""
_COMMENTED_ROWS = 256
"""Most table rows that are written one a line, with a comment each."""
_ROWS_A_LINE = 6
"""Table rows in a line of a longer table."""
_PART = 1 << 32
"""Units per microsecond in the second number of a time."""
_US = 1 << 32
"""The period of the 32-bit clock in microseconds."""


@dataclass(frozen=True)
class Row:
    """A row of the schedule: `times` launches of a kernel (list of words) at equal intervals.

    The first launch is `at` microseconds after the frame's first word, each next one `interval_us`
    later. IN (the level sent to all pixels) is set to `level` steps before, unless that is None. A
    row with `kernel` None only waits. `instants` are the boundaries of the launches. `steered`: the
    first launch, if parameters or the number of the frame change the row."""

    at: Fraction
    interval_us: Fraction
    kernel: int | None
    level: int | None
    instants: tuple[int, ...]
    steered: SteeredLaunch | None = None

    @classmethod
    def waiting(cls, at: Fraction, instant: int) -> Self:
        """Return a row that only waits until `at`, the time of the boundary `instant`."""
        return cls(at, Fraction(0), kernel=None, level=None, instants=(instant,))

    @property
    def times(self) -> int:
        """The number of launches (starts of kernels) in this row, or for a row without a kernel, of
        moments that it waits for. A kernel is a list of words."""
        return len(self.instants)


@dataclass(frozen=True)
class LaunchSchedule:
    """The rows of a frame, with times in microseconds after its first word.

    The exposure begins at `begin_us`, and the last slot ends at `end`."""

    rows: tuple[Row, ...]
    begin_us: int
    end: Fraction

    @property
    def waits(self) -> bool:
        """Whether some rows only wait."""
        return any(row.kernel is None for row in self.rows)

    @property
    def in_whole_us(self) -> bool:
        """Whether all times are whole microseconds."""
        return all(
            moment.denominator == 1 for row in self.rows for moment in (row.at, row.interval_us)
        )

    @property
    def sets_in(self) -> bool:
        """Whether some launches (starts of kernels) set IN (the level sent to all pixels). A kernel
        is a list of words."""
        return any(
            row.level is not None or (row.steered is not None and row.steered.level_of)
            for row in self.rows
        )

    @property
    def changed(self) -> list[tuple[int, Row, SteeredLaunch]]:
        """The rows that change from frame to frame, with their numbers and first launches (starts
        of kernels). A kernel is a list of words."""
        rows = ((number, row, row.steered) for number, row in enumerate(self.rows))
        return [(number, row, of) for number, row, of in rows if of is not None and of.is_changed]


def schedule_of(container: Container, steered: Sequence[SteeredLaunch | None]) -> LaunchSchedule:
    """Return the times of all launches (starts of kernels) of a frame.

    Launches at equal intervals with the same kernel (list of words) and level are one row. Rows
    that only wait divide long intervals, and the last row is not before the end of the last slot.
    `steered` says of each launch how parameters change it, as `steered_launches` returns it."""
    begin_us = ceil(_setup_us(container))
    boundary = list(accumulate(map(exact, container.slot_us), initial=Fraction(begin_us)))
    rows: list[Row] = []
    before = Fraction(0)
    for launch, steering in zip(container.launches, steered, strict=True):
        # Launches at boundary 0 set up the frame, before the exposure begins.
        launch_us = boundary[launch.instant] if launch.instant else Fraction(0)
        rows += _rests(before, launch_us, launch.instant)
        rows.append(
            Row(launch_us, Fraction(0), launch.kernel, launch.level, (launch.instant,), steering)
        )
        before = launch_us
    rows += _rests(before, boundary[-1], container.slots)
    if not rows or rows[-1].at < boundary[-1]:
        rows.append(Row.waiting(boundary[-1], container.slots))
    return LaunchSchedule(tuple(_repeated(rows)), begin_us, boundary[-1])


def exact(value: float) -> Fraction:
    """Return a float as the exact fraction of the shortest decimal number that prints it, such as
    1/10 for 0.1."""
    return Fraction(Decimal(repr(float(value))))


def kernel_us(kernel: StoredKernel, target: Target) -> Fraction:
    """Return the time of one launch (the start of a kernel) of a kernel (list of words), in
    microseconds, exactly: the launch and all its words."""
    analog = sum(decode(word).analog for word in kernel.words)
    digital = len(kernel.words) - analog
    return (
        exact(target.launch_us)
        + analog * exact(target.analog_word_us)
        + digital * exact(target.digital_word_us)
    )


def _setup_us(container: Container) -> Fraction:
    """Return the time in microseconds from a frame's first word to the end of the reset that begins
    the exposure: the last reset at boundary 0. 0 if boundary 0 has no reset."""
    target = container.target
    elapsed = setup = Fraction(0)
    for launch in container.launches:
        if launch.instant:
            break
        words = container.kernels[launch.kernel].words
        for index, word in enumerate(words):
            if decode(word).operation.effect is WordEffect.RESET_PIX:
                setup = elapsed + kernel_us(StoredKernel("", words[: index + 1]), target)
        elapsed += kernel_us(container.kernels[launch.kernel], target)
    return setup


def _rests(before: Fraction, at: Fraction, instant: int) -> Iterator[Row]:
    """Yield rows that only wait, between launches (starts of kernels) at `before` and `at`
    microseconds, so that no interval exceeds LONGEST_GAP_US; none if the interval is shorter.

    `instant` is the boundary of the second launch. A kernel is a list of words."""
    while at - before > LONGEST_GAP_US:
        before += LONGEST_GAP_US
        yield Row.waiting(before, instant)


def _repeated(rows: Sequence[Row]) -> Iterator[Row]:
    """Yield the rows, with launches (starts of kernels) of the same kernel (list of words) and
    level at equal intervals merged into one.

    `rows` have one launch each, in the order of time. A row of the result has at most `MOST_TIMES`
    launches; `interval_us` is 0 if it has one."""

    def shared(number: int) -> Any:
        """Return what launches (starts of kernels) in one row have in common. A kernel is a list of
        words."""
        row = rows[number]
        return row.kernel, row.level, row.steered and row.steered.shared(number)

    start = 0
    while start < len(rows):
        first, end = rows[start], start + 1
        interval_us = rows[end].at - first.at if end < len(rows) else Fraction(0)
        while (
            end < len(rows)
            and end - start < MOST_TIMES
            and shared(end) == shared(start)
            and rows[end].at - rows[end - 1].at == interval_us
        ):
            end += 1
        instants = tuple(row.instants[0] for row in rows[start:end])
        interval_us = interval_us if end - start > 1 else Fraction(0)
        yield Row(first.at, interval_us, first.kernel, first.level, instants, first.steered)
        start = end


def kernel_name(number: int) -> str:
    """Return the C++ name of the kernel (list of words) with this number, such as `k3`."""
    return f"k{number}"


def schedule_lines(schedule: LaunchSchedule, container: Container) -> Iterator[str]:
    """Yield the C++ table of kernels (lists of words), the table of launches (starts of kernels),
    and the function that runs a frame.

    Up to _COMMENTED_ROWS rows have a comment with their boundaries each; more are written several a
    line."""
    count = len(container.kernels)
    if schedule.waits:
        yield "void rest() {}                      // no kernel: a moment to wait for"
        yield ""
    names = [kernel_name(number) for number in range(count)] + ["rest"] * schedule.waits
    yield "void (*const kernels[])() = {"
    for start in range(0, len(names), 12):
        yield f"    {', '.join(names[start : start + 12])},"
    yield "};"
    yield ""
    settings = {"begin": schedule.begin_us, "end": float(schedule.end)}
    yield from template_lines("await", **settings)
    yield ""
    fields = "step" if schedule.in_whole_us else "step_parts"
    if schedule.sets_in:
        fields += "_in"
    yield from template_lines(fields)
    yield ""
    yield "Step schedule[] = {" if schedule.changed else "const Step schedule[] = {"
    texts = [_row_text(row, count, schedule) for row in schedule.rows]
    if len(texts) <= _COMMENTED_ROWS:
        boundaries = [ranges_text(sorted(set(row.instants))) for row in schedule.rows]
        # Long lists of boundaries are cut, so that comments fit beside the rows.
        shown = [text if len(text) <= 50 else text[:46] + " ..." for text in boundaries]
        remarks = [f"boundary {text}" for text in shown]
        lines = [f"    {text}" for text in texts]
        yield from remarked([*zip(lines, remarks, strict=True)], column=36)
    else:
        for start in range(0, len(texts), _ROWS_A_LINE):
            line_rows = schedule.rows[start : start + _ROWS_A_LINE]
            first, last = line_rows[0].instants[0], line_rows[-1].instants[-1]
            line = f"    {' '.join(texts[start : start + _ROWS_A_LINE])}"
            yield f"{line}  // boundary {first} to {last}"
    yield "};"
    yield ""
    moment = template_lines("moment" if schedule.in_whole_us else "moment_parts")
    after = template_lines("after" if schedule.in_whole_us else "after_parts")
    settle = (
        template_lines("settle", settle=ceil(exact(container.target.in_settle_us)))
        if schedule.sets_in
        else []
    )
    yield from _change_lines(schedule, container.pictures.params)
    begin = template_lines("begin_in") if schedule.sets_in else []
    begin = begin + ["    set_params();"] * bool(schedule.changed)
    lines = template_lines("expose")
    inserted = {"@begin@": begin, "@moment@": moment, "@settle@": settle, "@after@": after}
    for line in lines:
        yield from inserted.get(line.strip(), [line])


def _change_lines(schedule: LaunchSchedule, params: Sequence[HostParam]) -> Iterator[str]:
    """Yield the variables of parameters, and the function that changes the schedule to their values
    before a frame; nothing if no row of the schedule changes.

    The variable of parameter number i is `param_i`."""
    if not schedule.changed:
        return
    names = {param.name: f"param_{number}" for number, param in enumerate(params)}
    for param in params:
        yield f"int {names[param.name]} = {param.start};  // {safe(param.name)}"
    yield from template_lines("limited")
    yield "void set_params() {"
    for number, row, steering in schedule.changed:
        if steering.is_start:
            yield f"    schedule[{number}].times = is_first_frame ? {row.times} : 0;"
        if steering.level_of is not None:
            value = f"{steering.level_of.factor} * {names[steering.level_of.param]}"
            yield f"    schedule[{number}].in = int16_t({value});"
        if steering.times is not None:
            times = steering.times
            value = f"{times.offset - steering.step} + {times.factor} * {names[times.param]}"
            yield f"    schedule[{number}].times = limited({value}, {row.times});"
    yield from ("    is_first_frame = false;", "}", "")


def _row_text(row: Row, rest_kernel: int, schedule: LaunchSchedule) -> str:
    """Return a row of the schedule as C++, with times in microseconds.

    If not all times are whole, each has a second number: its fraction in units of 2^-32 us, rounded
    up so that no launch is early. `rest_kernel` is the number that stands for a row without a
    kernel (list of words)."""
    numbers: list[int] = []
    for moment in (row.at, row.interval_us):
        fixed = ceil(moment * _PART)
        # The clock of 32 bits begins again at 0, and differences of its times stay right.
        numbers.append(fixed // _PART % _US)
        if not schedule.in_whole_us:
            numbers.append(fixed % _PART)
    numbers += [rest_kernel if row.kernel is None else row.kernel, row.times]
    if schedule.sets_in:
        numbers.append(AS_IT_IS if row.level is None else row.level)
    return f"{{{', '.join(map(str, numbers))}}},"
