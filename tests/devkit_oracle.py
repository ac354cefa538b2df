"""What a program for the devkit does, found by running it: compiled against `tests/devkit_stub`,
whose library prints every kernel, launch, wait and drawing instead of driving a chip.

Nothing here knows how such programs are written. The codes that they load are found by running the
recorded words on `emulator_oracle.Chip`, on an array of the devkit's size whose bits fade.
"""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from lowering_oracle import FadingChip

from nscc.target.target import Target
from nscc.words.container import Container, Word
from nscc.words.encoding import decode

STUB = Path(__file__).parent / "devkit_stub"
COMPILER = shutil.which("g++") or shutil.which("clang++")
WARNINGS = ("-Wall", "-Wextra", "-Werror", "-pedantic")
SIDE = 256

needs_compiler = pytest.mark.skipif(COMPILER is None, reason="no C++ compiler here")

# What a call may take, on the slow side: an array of pixels is drawn in 0.3 s.
PIXEL_US, PATTERN_US, LAUNCH_US = 4.6, 100.0, 5.0

Event = tuple[str, list[str]]


def compile_program(text: Path, program: Path, *options: str) -> None:
    """Compiles one file; warnings are errors."""
    run([COMPILER, *WARNINGS, "-I", STUB, *options, text, "-o", program])


def check_syntax(text: Path, *options: str) -> None:
    """Only looks whether a file is in order."""
    run([COMPILER, "-fsyntax-only", *WARNINGS, "-I", STUB, *options, text])


def run(command, folder: Path | None = None) -> str:
    """The standard output of a command that must succeed."""
    done = subprocess.run(
        list(map(str, command)), cwd=folder, capture_output=True, text=True, timeout=100
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@dataclass
class Recording:
    """What a program did: the words of its kernels by number, and all events in their order.

    `loading` are the events before the frame loop, `frames` those of each turn of it.
    """

    kernels: dict[int, list[Word]] = field(default_factory=dict)
    loading: list[Event] = field(default_factory=list)
    frames: list[list[Event]] = field(default_factory=list)

    @property
    def events(self) -> list[Event]:
        """All events."""
        return [*self.loading, *(event for frame in self.frames for event in frame)]


def record(text: Path, *options: str) -> Recording:
    """Compiles a program and runs it, in its own folder, for two frames."""
    program = text.with_suffix(".exe")
    compile_program(text, program, *options)
    found = Recording()
    events: list[Event] = []
    for line in run([program], text.parent).splitlines():
        name, *values = line.split()
        if name == "kernel":
            numbers = [int(value, 16) for value in values[1:]]
            words = [tuple(numbers[i : i + 5]) for i in range(0, len(numbers), 5)]
            found.kernels[int(values[0])] = words
        else:
            events.append((name, values))
    assert events[-1] == ("end", [])
    last_setting = max(i for i, (name, _) in enumerate(events) if name == "trigger")
    found.loading, rest = events[: last_setting + 1], events[last_setting + 1 : -1]
    assert rest[0] == ("loop", [])
    for event in rest:
        if event[0] == "loop":
            found.frames.append([])
        else:
            found.frames[-1].append(event)
    assert len(found.frames) == 2
    return found


def loaded_planes(
    recording: Recording, target: Target, rest_is_cleared: bool, seed: int = 1
) -> dict[str, np.ndarray]:
    """Every digital register bool (rows, cols) after loading, as one looks at the array.

    The devkit's column 0 is the right one. `rest_is_cleared` says whether a pattern also writes 0
    where it does not match. Nothing is known about the registers before.
    """
    random = np.random.default_rng(seed)
    shape = (SIDE, SIDE)
    row, col = np.mgrid[0:SIDE, 0:SIDE]
    digital = {name: random.random(shape) < 0.5 for name in (*target.digital_registers, "SELECT")}
    analog = {name: np.zeros(shape) for name in (*target.analog_registers, "PIX", "IN")}
    chip = FadingChip(
        random, target, analog, digital, random.random(shape) < 0.5, np.zeros(shape), False, False
    )

    def store(register: str, value: np.ndarray) -> None:
        allowed = chip.digital["R0"] if register == "R12" else True
        chip.digital[register] = np.where(allowed, value, chip.digital[register])

    rate = 1
    for name, values in recording.loading:
        if name == "launch":
            chip.now_us += LAUNCH_US
            for word in recording.kernels[int(values[0])]:
                operation = decode(word)
                chip.run(operation.name, operation.destinations, operation.sources)
        elif name == "pattern":
            chip.now_us += PATTERN_US
            r, c, rx, cx = map(int, values[1:])
            match = (((row ^ r) & ~rx & 255) == 0) & (((col ^ c) & ~cx & 255) == 0)
            chip.run("nop", (), ())
            store(values[0], match if rest_is_cleared else chip.digital[values[0]] | match)
            chip.written_us[values[0]] = chip.now_us
        elif name == "draw":
            addresses = np.array(list(map(int, values[1:]))).reshape(-1, 2)
            chip.now_us += PIXEL_US * len(addresses)
            chip.run("nop", (), ())
            drawn = np.zeros(shape, dtype=bool)
            drawn[addresses[:, 0], addresses[:, 1]] = True
            store(values[0], chip.digital[values[0]] | drawn)
        elif name == "trigger":
            rate = int(values[1])
        elif name == "loop":
            chip.now_us += 1e6 / rate
        else:
            assert name in ("display", "request"), name
    chip.run("nop", (), ())
    corner = (slice(0, target.rows), slice(0, target.cols))
    return {name: plane[corner][:, ::-1] for name, plane in chip.digital.items()}


def check_codes(recording: Recording, container: Container) -> None:
    """The code planes are loaded, whatever a pattern does to the pixels that do not match."""
    wanted = container.planes()
    for rest_is_cleared in (True, False):
        found = loaded_planes(recording, container.target, rest_is_cleared)
        for register, plane in wanted.items():
            assert np.array_equal(found[register], plane), (register, rest_is_cleared)


def check_frames(recording: Recording, container: Container) -> None:
    """Each frame launches the container's words in their order and at their times."""
    wanted = [container.kernels[launch.kernel].words for launch in container.launches]
    boundary_us = [Fraction(0)]
    for length in container.slot_us:
        boundary_us.append(boundary_us[-1] + decimal(length))
    for events in recording.frames:
        outputs = [values for name, values in events if name == "output"]
        assert outputs == [[r.register, str(i)] for i, r in enumerate(container.readouts)]
        exposure = [event for event in events if event[0] != "output"]
        # Before readout FLAG is set everywhere, and nothing else happens.
        last_name, last_values = exposure.pop()
        assert last_name == "launch"
        assert [str(decode(w)) for w in recording.kernels[int(last_values[0])]] == ["all"]
        launched = [recording.kernels[int(v[0])] for name, v in exposure if name == "launch"]
        assert launched == [list(words) for words in wanted]
        check_times(exposure, recording, container, boundary_us)


def check_times(
    events: list[Event],
    recording: Recording,
    container: Container,
    boundary_us: list[Fraction],
) -> None:
    """No slot between launches is shorter than it should be, nor a microsecond longer."""
    target = container.target
    now = Fraction(0)
    starts: list[Fraction] = []
    exposed = Fraction(0)
    for name, values in events:
        if name == "wait":
            assert int(values[0]) > 0
            now += int(values[0])
            continue
        instant = container.launches[len(starts)].instant
        starts.append(now)
        now += decimal(target.launch_us)
        for word in recording.kernels[int(values[0])]:
            operation = decode(word)
            us = target.analog_word_us if operation.analog else target.digital_word_us
            now += decimal(us)
            if operation.name == "rpix" and instant == 0:
                exposed = now
    begin: dict[int, Fraction] = {}
    for launch, start in zip(container.launches, starts, strict=True):
        begin.setdefault(launch.instant, start)
    begin[0] = exposed
    if container.launches[-1].instant < container.slots:
        begin[container.slots] = now
    instants = sorted(begin)
    for before, after in pairwise(instants):
        slot_us = begin[after] - begin[before]
        meant_us = boundary_us[after] - boundary_us[before]
        assert meant_us <= slot_us < meant_us + 1, (before, after)


def decimal(value: float) -> Fraction:
    """The decimal fraction that is written like this number."""
    return Fraction(str(value))
