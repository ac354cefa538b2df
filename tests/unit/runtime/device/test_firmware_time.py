"""The frame's loop keeps its schedule: against a clock of the test's, and fractions."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import accumulate
from pathlib import Path
from struct import pack

import pytest

from nscc.operations import op
from nscc.words.encoding import encode
from nscc_runtime.device import firmware
from nscc_runtime.device.messages import LoaderFault

pytestmark = pytest.mark.skipif(firmware.compiler() is None, reason="no C++ compiler")
Run = Callable[..., list[str]]
NEVER = (1 << 32) - 1


@pytest.fixture(scope="module")
def run(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Run:
    """Runs a frame: (slots of equal lengths), (rows), ticks a launch takes; what was printed."""
    program = tmp_path_factory.mktemp("time") / "frame"
    parts = ("core", "host", "targets/scamp5")
    compiler = firmware.compiler()
    assert compiler is not None
    sources = [
        *sorted((firmware.SOURCES / "core").glob("*.cpp")),
        root / "tests/firmware_time/main.cpp",
    ]
    command = [compiler, *firmware.CORE_FLAGS, *firmware.WARNINGS, "-O1"]
    command += [f"-I{firmware.SOURCES / part}" for part in parts]
    subprocess.run([*command, *map(str, sources), "-o", str(program)], check=True)

    def frame(
        runs: Sequence[tuple[int, float]],
        rows: Sequence[tuple[int, int, int]],
        each: int = 0,
        *,
        grace_ns: int = 0,
        most_late: int = 0,
        nops: int = 0,
    ) -> list[str]:
        words = [[encode(op("rpix"))], [encode(op("nop"))] * nops]
        head = pack("<3I", 2, 1, nops)
        kernels = head + b"".join(pack("<5I", *word) for kernel in words for word in kernel)
        slots = sum(count for count, _ in runs)
        data = pack("<4I", slots, grace_ns, most_late, len(runs))
        data += b"".join(pack("<Id", *each_run) for each_run in runs)
        data += pack("<I", len(rows)) + b"".join(pack("<IHH", *row) for row in rows)
        given = pack("<I", each) + b"".join(pack("<I", len(o)) + o for o in (kernels, data))
        done = subprocess.run([str(program)], input=given, capture_output=True, check=True)
        return done.stdout.decode().splitlines()

    return frame


SETUP = Fraction(12, 10)
"""Microseconds of a launch and an rpix, by the target's figures."""


def test_boundaries_of_the_firmware_do_not_drift(run: Run) -> None:
    """After 4199 slots of fractional lengths, each launch is at the rounded exact sum of the
    lengths, and none is late."""
    lengths = [3.37, 7.1, 1e6 / 3]
    runs = [(4096, lengths[0]), (100, lengths[1]), (3, lengths[2])]
    *launches, end = run(runs, [(0, 0, 1), (1, 1, 4199)], each=1)
    slot_us = [Fraction(us) for count, us in runs for _ in range(count)]
    due = [SETUP + us for us in accumulate(slot_us)]
    assert int(launches[0]) == 0
    assert [int(tick) for tick in launches[1:]] == [int(us + Fraction(1, 2)) for us in due]
    assert end.split()[0] == "ended"
    assert end.split()[3:5] == ["0", "0"]


def test_a_launch_that_takes_long_makes_no_other_late(run: Run) -> None:
    """Each launch takes 9 us of a slot of 10 us. All 50 start on time, 10 us apart."""
    *launches, end = run([(50, 10.0)], [(0, 0, 1), (1, 1, 50)], each=9)
    assert [int(tick) - int(SETUP + Fraction(1, 2)) for tick in launches[1:]] == [
        10 * n for n in range(1, 51)
    ]
    assert end.split()[3:5] == ["0", "0"]


def test_late_launches_are_counted_and_end_the_frame(run: Run) -> None:
    """Launches of 12 us in slots of 10 us come late: their number and the longest delay are
    reported. With `most_late=3` the fourth ends the frame."""
    rows = [(0, 0, 1), (1, 1, 20)]
    *launches, end = run([(20, 10.0)], rows, each=12, most_late=NEVER)
    late = [max(0, int(tick) - (10 * n + 1)) for n, tick in enumerate(launches[1:], 1)]
    assert max(late) > 20
    assert end.split()[:2] == ["ended", "1"]
    assert end.split()[3:5] == [str(sum(map(bool, late))), str(max(late))]
    assert int(end.split()[2]) == int(launches[-1]) + 12
    *launches, end = run([(20, 10.0)], rows, each=12, most_late=3)
    assert (end.split()[0], end.split()[3]) == ("late", "4")
    assert run([(20, 10.0)], rows, each=12, grace_ns=50_000)[-1].split()[0] == "ended"


def test_long_waits_let_the_main_loop_go_round(run: Run) -> None:
    """The main loop runs once in each of five slots of 1 ms, and not in slots of 100 us. It runs
    once more at the end."""
    end = run([(5, 1000.0)], [(0, 0, 1), (1, 1, 5)])[-1]
    assert end.split()[:2] == ["ended", "6"]
    assert run([(5, 100.0)], [(0, 0, 1), (1, 1, 5)])[-1].split()[1] == "1"


@pytest.mark.parametrize(
    ("slot_us", "each"),
    [(100.0, 7), (25.0, 2), (8.0, 8), (8.0, 7), (0.001, 3)],
    ids=["room for a look", "just enough of it", "none", "almost none", "words alone"],
)
def test_the_line_is_looked_at_every_ten_milliseconds(run: Run, slot_us: float, each: int) -> None:
    """This holds for waits of any length. If a wait is long enough, looking at the line delays no
    launch."""
    count = min(200_000, int(1.9e6 / max(slot_us, each)))
    rows = [(0, 0, 1), *[(1, 1, part) for part in (60_000,) * (count // 60_000)]]
    slots = sum(times for advance, _, times in rows if advance) or count
    if slots == count:
        rows.append((1, 1, count))
    end = run([(slots, slot_us)], rows, each, grace_ns=NEVER, nops=1)[-1].split()
    assert end[0] == "ended"
    assert 0 < int(end[5]) <= 10_000 + 2 * max(slot_us, each)
    assert int(end[4]) == 0 or each >= slot_us


@pytest.mark.parametrize(
    ("runs", "rows", "nops", "detail"),
    [
        ([(1, 1.3e9)], [], 0, 7),
        ([(1200, 1e6)], [], 0, None),
        ([(1, 1.0)], [(0, 1, 65535)] * 16, 1000, 8),
        ([(1 << 20, 100.0)], [(1, 1, 65535)], 0, 8),
        ([(1 << 14, 100.0)], [(1, 1, 1 << 14)], 0, None),
    ],
    ids=[
        "a slot of twenty minutes",
        "twenty minutes of slots",
        "words without end",
        "slots without a breath",
        "slots for less than two seconds",
    ],
)
def test_the_firmware_refuses_schedules_that_take_too_long_and_ends_all_others(
    run: Run,
    runs: list[tuple[int, float]],
    rows: list[tuple[int, int, int]],
    nops: int,
    detail: int | None,
) -> None:
    end = run(runs, rows, nops=nops)[-1].split()
    if detail is None:
        assert end[0] == "ended"
    else:
        assert end == ["refused", str(LoaderFault.SCHEDULE.value), str(detail)]
