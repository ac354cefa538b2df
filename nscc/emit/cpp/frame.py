"""The schedule of a frame: which kernel after what wait, as rows of a table.

The devkit waits in whole microseconds. A wait fills the slot after the time that the target's
figures give for the words since its start, and is rounded up, so that no slot is shorter than the
program says; what that adds to a frame is reported.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from itertools import accumulate
from math import ceil

from nscc.emit.cpp.text import part, remarked
from nscc.operations import Effect
from nscc.target.target import Target
from nscc.words.container import Container, Kernel
from nscc.words.encoding import decode
from nscc.words.text import ranges_text

LONGEST_WAIT_US = (1 << 32) - 1
MOST_TIMES = (1 << 16) - 1
_COMMENTED_ROWS = 256
_ROWS_A_LINE = 6


@dataclass(frozen=True)
class Row:
    """`times` times over: a wait, then a launch. `kernel` None only waits.

    `instants` are the boundaries of the launches.
    """

    wait_us: int
    kernel: int | None
    instants: tuple[int, ...]

    @property
    def times(self) -> int:
        """How often."""
        return len(self.instants)


@dataclass(frozen=True)
class Schedule:
    """The rows of a frame, and by how much rounding makes it longer than planned."""

    rows: tuple[Row, ...]
    excess_us: Fraction
    frame_us: Fraction

    @property
    def waits_at_end(self) -> bool:
        """Whether the frame goes on after its last launch."""
        return any(row.kernel is None for row in self.rows)


def schedule_of(container: Container) -> Schedule:
    """The schedule of a container's launches.

    Time 0 is the end of the last reset of PIX at boundary 0, which begins the exposure.
    """
    boundary = [Fraction(0), *accumulate(map(exact, container.slot_us))]
    busy = [kernel_us(kernel, container.target) for kernel in container.kernels]
    now = -_setup_us(container, busy)
    begin, excess = now, Fraction(0)
    rows: list[Row] = []
    for launch in container.launches:
        wait = max(Fraction(0), boundary[launch.instant] - now) if launch.instant else Fraction(0)
        excess += ceil(wait) - wait
        rows += _waits(ceil(wait), launch.kernel, launch.instant)
        now += wait + busy[launch.kernel]
    rest = boundary[-1] - now
    if rest > 0:
        excess += ceil(rest) - rest
        rows += _waits(ceil(rest), None, container.slots)
        now += rest
    return Schedule(tuple(_repeated(rows)), excess, now - begin)


def exact(value: float) -> Fraction:
    """The decimal fraction that a number was written as."""
    return Fraction(Decimal(repr(float(value))))


def kernel_us(kernel: Kernel, target: Target) -> Fraction:
    """Time of one launch of a kernel."""
    analog = sum(decode(word).analog for word in kernel.words)
    digital = len(kernel.words) - analog
    return (
        exact(target.launch_us)
        + analog * exact(target.analog_word_us)
        + digital * exact(target.digital_word_us)
    )


def _setup_us(container: Container, busy: Sequence[Fraction]) -> Fraction:
    """Time from the first word to the end of the reset that begins the exposure."""
    target = container.target
    elapsed = setup = Fraction(0)
    for launch in container.launches:
        if launch.instant:
            break
        words = container.kernels[launch.kernel].words
        for index, word in enumerate(words):
            if decode(word).operation.effect is Effect.RESET_PIX:
                setup = elapsed + kernel_us(Kernel("", words[: index + 1]), target)
        elapsed += busy[launch.kernel]
    return setup


def _waits(wait_us: int, kernel: int | None, instant: int) -> Iterator[Row]:
    """The rows of one launch: a wait may be longer than one call of the library allows."""
    while wait_us > LONGEST_WAIT_US:
        yield Row(LONGEST_WAIT_US, None, (instant,))
        wait_us -= LONGEST_WAIT_US
    yield Row(wait_us, kernel, (instant,))


def _repeated(rows: Sequence[Row]) -> Iterator[Row]:
    """Equal rows in a row as one."""
    at = 0
    while at < len(rows):
        end = at
        while (
            end < len(rows)
            and end - at < MOST_TIMES
            and (rows[end].wait_us, rows[end].kernel) == (rows[at].wait_us, rows[at].kernel)
        ):
            end += 1
        instants = tuple(row.instants[0] for row in rows[at:end])
        yield Row(rows[at].wait_us, rows[at].kernel, instants)
        at = end


def kernel_name(number: int) -> str:
    """What the function of a container's kernel is called."""
    return f"k{number}"


def schedule_lines(schedule: Schedule, container: Container) -> Iterator[str]:
    """The table of kernels, the schedule and the function that runs a frame."""
    count = len(container.kernels)
    if schedule.waits_at_end:
        yield "void rest() {}                      // no kernel: a wait by itself"
        yield ""
    names = [kernel_name(number) for number in range(count)] + ["rest"] * schedule.waits_at_end
    yield "void (*const kernels[])() = {"
    for start in range(0, len(names), 12):
        yield f"    {', '.join(names[start : start + 12])},"
    yield "};"
    yield ""
    yield from part("step")
    yield ""
    yield "const Step schedule[] = {"
    texts = [
        f"{{{row.wait_us}, {count if row.kernel is None else row.kernel}, {row.times}}},"
        for row in schedule.rows
    ]
    if len(texts) <= _COMMENTED_ROWS:
        yield from remarked(
            [
                (f"    {text}", f"boundary {_shortened(row.instants)}")
                for text, row in zip(texts, schedule.rows, strict=True)
            ],
            column=36,
        )
    else:
        for start in range(0, len(texts), _ROWS_A_LINE):
            some = schedule.rows[start : start + _ROWS_A_LINE]
            first, last = some[0].instants[0], some[-1].instants[-1]
            line = f"    {' '.join(texts[start : start + _ROWS_A_LINE])}"
            yield f"{line}  // boundary {first} to {last}"
    yield "};"
    yield ""
    yield from part("expose")


def _shortened(instants: Sequence[int]) -> str:
    text = ranges_text(sorted(set(instants)))
    return text if len(text) <= 50 else text[:46] + " ..."


def frame_rate(period_us: Fraction) -> int:
    """A rate in Hz that frames of `period_us` do not reach, so that the frame loop never waits."""
    return int(Fraction(1_000_000) / max(period_us, Fraction(1))) + 1
