"""How long a loader's frame takes, in its clock: the twin of the firmware's `schedule.cpp`.

Times are whole numbers: microseconds with 32 bits of fraction, as on a board whose clock has a tick
a microsecond.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from nscc.chips.target import Target
from nscc.operations import Word
from nscc.words.encoding import matching
from nscc_runtime.device.device_errors import FADES, NO_BREATH, TOO_LONG
from nscc_runtime.device.objects import AS_IT_IS
from nscc_runtime.device.tasks import LONGEST_US

TICK = 1 << 32
LONGEST_SLOT_US = 1 << 31
LONGEST = LONGEST_US * TICK
"""From the first word of a frame to its last, at most."""
BREATH = 200 * TICK
"""A boundary that is further away lets the loader's main loop go round before it."""
LONGEST_STRETCH = 2_000_000 * TICK
"""No frame keeps the main loop from its work for longer."""


def fixed_point(us: float) -> int:
    """Microseconds as a time, rounded half up."""
    return int(Fraction(us) * TICK + Fraction(1, 2))


def frame_time(
    kernels: Sequence[Sequence[Word]],
    runs: Sequence[tuple[int, float]],
    rows: Sequence[tuple[int, int, int]],
    levels: Sequence[int],
    held: set[int],
    target: Target,
    grace: tuple[int, int],
    changed: set[int],
) -> tuple[int, int, Kept]:
    """From a frame's first word to its last, in whole microseconds; why it does not go in time:
    TOO_LONG, NO_BREATH or FADES, or 0; and how it keeps its schedule.

    `held`: the digital registers that hold planes, by their number. `grace`: how many microseconds
    a launch may be late, and how many may be later. `changed`: rows whose level a parameter sets.
    """
    timeline = _Timeline(kernels, runs, rows, levels, target)
    now, cramped, faded = timeline.walk(held, changed)
    if now > LONGEST:
        return LONGEST_US, TOO_LONG, Kept(0, 0, 0)
    fault = NO_BREATH if cramped else FADES if faded else 0
    return now // TICK + 1, fault, timeline.kept(*grace)


@dataclass(frozen=True)
class Kept:
    """How a frame kept its schedule on a board whose words take what the target's figures say: how
    long it took, launches that were later than `grace` allows, and by how much the latest one."""

    lasted_us: int
    late: int
    latest_us: int


ON_TIME = Kept(0, 0, 0)


class _Timeline:
    def __init__(
        self,
        kernels: Sequence[Sequence[Word]],
        runs: Sequence[tuple[int, float]],
        rows: Sequence[tuple[int, int, int]],
        levels: Sequence[int],
        target: Target,
    ) -> None:
        self.runs, self.rows, self.target = runs, rows, target
        self.levels = levels or (AS_IT_IS,) * len(rows)
        self.launch, self.analog, self.digital, self.retention, self.settling, self.loop = (
            int(min(us, LONGEST_US) * TICK)
            for us in (
                target.launch_us,
                target.analog_word_us,
                target.digital_word_us,
                target.digital_retention_us,
                target.in_settle_us,
                target.wait_us,
            )
        )
        self.kernels = kernels
        self.busy = [self._busy(kernel) for kernel in kernels]
        self.written = [self._written(kernel) for kernel in kernels]

    def _busy(self, kernel: Sequence[Word]) -> int:
        analog = sum(word[0] >> 19 & 7 == 0 for word in kernel)
        return self.launch + analog * self.analog + (len(kernel) - analog) * self.digital

    def _written(self, kernel: Sequence[Word]) -> set[int]:
        names = self.target.digital_registers
        ops = [matching(word) for word in kernel]
        return {names.index(name) for op in ops if op for name in op.destinations if name in names}

    def _setup(self) -> int:
        """From the frame's first word to the end of the reset that begins the exposure."""
        elapsed = setup = 0
        for advance, number, times in self.rows:
            if advance:
                break
            ops = [matching(word) for word in self.kernels[number]]
            resets = [n for n, op in enumerate(ops) if op and op.operation.name == "rpix"]
            if resets:
                first = self._busy(self.kernels[number][: resets[-1] + 1])
                setup = elapsed + (times - 1) * self.busy[number] + first
            elapsed += times * self.busy[number]
        return setup

    def walk(self, held: set[int], changed: set[int]) -> tuple[int, bool, bool]:
        """When the frame ends, at most a little beyond LONGEST; whether the main loop has to wait
        for too long, and whether a register of `held` fades."""
        now, stretch_from = 0, 0
        boundary = self._setup()
        written = dict.fromkeys(held, 0)
        cramped = faded = False
        slots = _Slots(self.runs)

        def wait(advance: int) -> None:
            nonlocal now, boundary, stretch_from
            boundary += slots.passed(advance)
            if boundary > now + BREATH:
                stretch_from = boundary
            now = max(now, boundary)

        def see(registers: set[int]) -> None:
            nonlocal cramped, faded
            for register in registers & held:
                faded = faded or now > written[register] + self.retention
                written[register] = now
            cramped = cramped or now > stretch_from + LONGEST_STRETCH

        rest, now_in = sum(count for count, _ in self.runs), AS_IT_IS
        rows = zip(self.rows, self.levels, strict=True)
        for number, ((advance, kernel, times), level) in enumerate(rows):
            rest -= advance * times
            for _ in range(times):
                if now > LONGEST:
                    break
                if advance:
                    wait(advance)
                if number in changed or level not in (AS_IT_IS, now_in):
                    now += self.settling
                    now_in = AS_IT_IS if number in changed else level
                now += self.busy[kernel]
                see(self.written[kernel])
        if rest and now <= LONGEST:
            wait(rest)
        see(held)
        return now, cramped, faded

    def kept(self, grace_us: int, most_late: int) -> Kept:
        """How the frame keeps its schedule; up to the launch that is one too many too late."""
        now = late = latest = 0
        boundary, now_in = self._setup() + TICK // 2, AS_IT_IS
        slots = _Slots(self.runs)
        rest = sum(count for count, _ in self.runs)
        rows = [*zip(self.rows, self.levels, strict=True)]
        rest -= sum(advance * times for (advance, _, times), _ in rows)
        for (advance, kernel, times), level in [*rows, ((rest, -1, 1), AS_IT_IS)]:
            for _ in range(times):
                if advance:
                    boundary += slots.passed(advance)
                    due = boundary // TICK
                    past = max(now // TICK - due, 0)
                    now = max(now, due * TICK) + self.loop
                    latest = max(latest, past)
                    late += past > grace_us
                    if late > most_late:
                        return Kept(0, late, latest)
                if level not in (AS_IT_IS, now_in):
                    now += self.settling
                    now_in = level
                now += self.busy[kernel] if kernel >= 0 else 0
        return Kept(now // TICK, late, latest)


class _Slots:
    """The lengths of slots, one after the other."""

    def __init__(self, runs: Sequence[tuple[int, float]]) -> None:
        self._runs = iter(runs)
        self._left = self._each = 0

    def passed(self, slots: int) -> int:
        """How long so many slots are together."""
        length = 0
        while slots > self._left:
            length += self._left * self._each
            slots -= self._left
            self._left, us = next(self._runs)
            self._each = fixed_point(us)
        self._left -= slots
        return length + slots * self._each
