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
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from lowering_oracle import FadingChip

from nscc.chips.target import Target
from nscc.operations import NEIGHBOURS, Word
from nscc.words.container import Container, state_registers
from nscc.words.encoding import decode

STUB = ROOT / "tests" / "devkit_stub"
COMPILER = shutil.which("g++") or shutil.which("clang++")
WARNINGS = ("-Wall", "-Wextra", "-Werror", "-pedantic")
SIDE = 256

needs_compiler = pytest.mark.skipif(COMPILER is None, reason="no C++ compiler here")

# What a call may take, on the slow side: an array of pixels is drawn in 0.3 s.
PIXEL_US, PATTERN_US, LAUNCH_US = 4.6, 100.0, 5.0

# What launches, words and looks at the clock take at most in the stub.
MOST_LAUNCH_NS, MOST_WORD_NS, MOST_LOOKS_NS = 1900, 220, 1200

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


CHIP = "-D__LPC43XX__"
"""The build for the chip; without it, that for the devkit's simulator."""


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
    # Frames are the turns of the loop that show something.
    shown = [i for i, (name, _) in enumerate(events) if name == "output"]
    first = max(i for i, (name, _) in enumerate(events[: shown[0]]) if name == "loop")
    found.loading, rest = events[:first], events[first:-1]
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
                if operation.name.startswith("DNEWS"):  # it leaves what is not known here
                    store(operation.destinations[0], random.random(shape) < 0.5)
                    continue
                if {*NEIGHBOURS} & {*operation.destinations, *operation.sources}:
                    continue  # analog registers do not matter for the codes
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
            assert name in ("display", "request", "in", "slider", "wait"), name
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
    """Each frame launches the container's words in their order and at their times, with their
    values of IN, and shows its registers."""
    wanted = [container.kernels[launch.kernel].words for launch in container.launches]
    for exposure in exposures(recording, container):
        launched = [recording.kernels[int(v[0])] for name, v in exposure if name == "launch"]
        assert launched == [list(words) for words in wanted]
        check_levels(exposure, container)
        check_times(exposure, container)


def exposures(recording: Recording, container: Container) -> list[list[Event]]:
    """What happens in each frame up to the readout, which is looked at here."""
    shown = [readout.register for readout in container.readouts]
    shown += list(state_registers(container))
    found = []
    for events in recording.frames:
        outputs = [values for name, values in events if name == "output"]
        assert outputs == [[register, str(i)] for i, register in enumerate(shown)]
        reading = ("output", "post", "scan", "scan_bits")
        exposure = [event for event in events if event[0] not in reading]
        check_readout(exposure, recording, container)
        found.append(exposure)
    return found


def check_readout(exposure: list[Event], recording: Recording, container: Container) -> None:
    """What comes last, and is taken away here: FLAG is set everywhere, and registers are made what
    the converter turns into the codes that the target promises; its own zero is code 128."""
    target = container.target
    name, values = exposure.pop()
    assert name == "launch"
    level = 0
    buckets = {*container.buckets}
    own = [readout.register for readout in container.readouts if readout.bucket in buckets]
    # A copy goes through a register that is neither read out nor the scratch register. Images are
    # converted as they are.
    read = len(container.readouts)
    spread = target.readout == "spread" and 0 < len(own) <= read < len(target.analog_registers) - 1
    if spread:
        if exposure[-1][0] == "wait":
            exposure.pop()
        name, settings = exposure.pop()
        assert name == "in"
        level = int(settings[0])
    for electrons, wanted in ((0.0, 0), (target.full_well_e / 2, 128), (target.full_well_e, 255)):
        held = dict.fromkeys((*target.analog_registers, "IN"), 12345.0)
        held |= {**dict.fromkeys(own, electrons), "IN": level * target.register_max_e / 127}
        words = [decode(word) for word in recording.kernels[int(values[0])]]
        assert str(words[0]) == "all"
        for word in words[1:]:
            assert word.name == "bus"
            held[word.destinations[0]] = -sum(held[source] for source in word.sources)
        for register in own:
            code = 128 + round(held[register] / (2 * target.full_well_e / 255))
            if not spread:
                wanted = 128 + round(electrons / (2 * target.full_well_e / 255))
            assert min(code, 255) == min(wanted, 255), register


def check_levels(events: list[Event], container: Container) -> None:
    """IN has the value that each launch is to have, and as long as it needs to settle."""
    level, settled = None, 0
    launches = iter(container.launches)
    for name, values in events:
        if name == "in":
            level = int(values[0])
            settled = int(values[1]) + int(1000 * container.target.in_settle_us)
        elif name == "launch":
            launch = next(launches)
            if launch.level is not None:
                assert level == launch.level
                assert int(values[1]) >= settled


def check_times(events: list[Event], container: Container) -> None:
    """What a boundary begins with comes when its slots are over and not three microseconds later,
    however late anything was before: on the library's clock, where all takes longer than it
    should. Words that a slot is too short for are followed at once."""
    passed = [setup_us(container)]
    for length in container.slot_us:
        passed.append(passed[-1] + decimal(length))
    launches = iter(container.launches)
    first_ns = next(int(values[1]) for name, values in events if name == "launch")
    waiting: int | None = None
    before, free_ns = 0, 0
    for name, values in events:
        if name == "in":
            waiting = int(values[1])
        if name != "launch":
            continue
        launch, at_ns = next(launches), int(values[1])
        begin_ns = at_ns if waiting is None else waiting
        if launch.instant != before:
            over = Fraction(begin_ns - first_ns, 1000) - passed[launch.instant]
            assert over >= 0, launch
            assert over < 3 or begin_ns <= free_ns, (launch, float(over))
        before, waiting = launch.instant, None
        words = len(container.kernels[launch.kernel].words)
        free_ns = at_ns + MOST_LAUNCH_NS + words * MOST_WORD_NS + MOST_LOOKS_NS


def setup_us(container: Container) -> Fraction:
    """From the first word to the end of the reset that begins the exposure, as words should
    take."""
    target = container.target
    now = end = Fraction(0)
    for launch in container.launches:
        if launch.instant:
            break
        now += decimal(target.launch_us)
        for word in container.kernels[launch.kernel].words:
            operation = decode(word)
            now += decimal(target.analog_word_us if operation.analog else target.digital_word_us)
            if operation.name == "rpix":
                end = now
    return end


def decimal(value: float) -> Fraction:
    """The decimal fraction that is written like this number."""
    return Fraction(str(value))
