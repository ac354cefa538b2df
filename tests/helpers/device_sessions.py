"""Whole sessions with a loader over a bad cable, on a virtual clock: for tests and benchmarks."""

from __future__ import annotations

import random
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest
from device_lockstep import SANITIZERS, Lockstep
from device_simulation import Simulation
from emulator_programs import bumps, target_of
from loader_twin.loader import Loader
from loader_twin.parsing import Held

from nscc.chips.target import Target
from nscc.words.container import Container, Readout
from nscc.words.legality import decoded
from nscc_runtime.device import firmware, tasks
from nscc_runtime.device.board import BoardProgram, EmulatedChip
from nscc_runtime.device.firmware import RunningFirmware
from nscc_runtime.device.host import Host, Task
from nscc_runtime.device.objects import Upload, upload_of
from nscc_runtime.device.serving import LineFaults
from nscc_runtime.device.tasks import FrameRequest
from nscc_runtime.emulator import expose
from nscc_runtime.emulator.chip_program import ChipProgram
from nscc_runtime.light import Light

SHAPE, SLOTS = (6, 10), 8
TARGET: Target = target_of(SHAPE)
BOTH = 3
"""Both channels of a frame."""


@dataclass(frozen=True, eq=False)
class Example:
    """A program as the loader gets it, and the frame that the emulator makes of the container
    itself, laid out by hand."""

    container: Container
    light: Light
    upload: Upload
    frame: bytes


@lru_cache
def examples(slot_us: float = 100.0) -> tuple[Example, ...]:
    """One program for each lowering; the last one has a gain. `slot_us` is the shortest slot."""
    random_numbers = np.random.default_rng(3)
    stop = random_numbers.integers(1, SLOTS + 1, SHAPE)
    start = random_numbers.integers(0, SLOTS, SHAPE)
    made = []
    for number, (begin, lowering) in enumerate(
        [(None, "latch"), (start, "accumulate"), (None, "edges"), (start, "edges")]
    ):
        container = bumps(TARGET, begin, stop, SLOTS, lowering)
        lengths = tuple(slot_us * (1 + n // 3) for n in range(SLOTS))
        container = replace(container, slot_us=lengths)
        if number == 3:
            container = replace(container, readouts=(Readout("A", "frame", -0.5),))
        light = Light.of_clip(random_numbers.random((SLOTS, *SHAPE), np.float32) * 5000)
        made.append(
            Example(
                container,
                light,
                upload_of(container, bytes([number] * 32)),
                emulated(container, light),
            )
        )
    return tuple(made)


def emulated(container: Container, light: Light) -> bytes:
    """What a frame has to be, both channels: straight from the emulator."""
    exposure = expose(container, light).exposure_e
    codes = np.clip(np.rint(exposure / (30000 / 255)), 0, 255).astype(np.uint8)
    columns = [np.ascontiguousarray(each.swapaxes(1, 2)) for each in (codes, exposure)]
    return columns[0].tobytes() + columns[1].astype("<f8").tobytes()


def board_program(container: Container) -> BoardProgram:
    """What a loader's board executes for a container without images."""
    chip = ChipProgram(
        container.target,
        container.slots,
        decoded(container),
        container.launches,
        container.planes(),
    )
    readouts = tuple((readout.register, readout.gain) for readout in container.readouts)
    return BoardProgram(chip, container.slot_us, readouts, (), ())


class ChipAtOnce(EmulatedChip):
    """A loader's board whose frame is there as soon as it is asked for."""

    frame: bytes | None = None

    def expose(self, held: Held, channels: int) -> None:
        """Expose a program that a loader has checked."""
        self.frame = None
        with suppress(Exception):
            program = held.program(self.target, channels)
            executed = self.execute(program, held.board_channels(channels))
            held.take(executed, self.target)
            self.frame = executed.frame

    def exposed(self) -> bytes:
        """The frame; RuntimeError where there is none."""
        if self.frame is None:
            raise RuntimeError("no frame")
        return self.frame


def chip_of(example: Example, target: Target = TARGET) -> ChipAtOnce:
    """A chip that sees the example's light, whatever the slots."""
    return ChipAtOnce(lambda _: example.light, target)


def python_loader(example: Example) -> Loader:
    """The Python twin in front of the example's light."""
    return Loader(TARGET, chip_of(example), "nscc-loader 2 (Python)")


def sanitized(folder: Path | None = None, target: Target = TARGET) -> firmware.Built:
    """The firmware's core for a target, with sanitizers; skips where it cannot be built."""
    if firmware.compiler() is None:
        pytest.skip("no C++ compiler: the firmware's core cannot be run")
    return firmware.built(target, ("-O1", "-Werror", *SANITIZERS), folder)


def new_host(seed: int, **more: float) -> Host:
    """A host whose sessions have numbers of their own."""
    numbers = random.Random(seed)
    return Host(lambda: numbers.randrange(1, 1 << 32), **more)


def faults_of(seed: int, length: int) -> LineFaults:
    """A bad cable: every kind of fault, alone and together, somewhere in a session."""
    numbers = random.Random(f"faults {seed}")
    rates = [numbers.choice([0.0, 10 ** numbers.uniform(-5, -2.7)]) for _ in range(2)]
    accidents = [
        numbers.randrange(1, 2 * length) if numbers.random() < 0.5 else None for _ in range(2)
    ]
    return LineFaults(
        corrupt=rates[0],
        drop=rates[1],
        delay_s=numbers.choice([0.0, 0.001, 0.02, 0.05]),
        disconnect_after=accidents[0],
        reboot_after=accidents[1],
        outage_s=numbers.choice([0.01, 0.3, 1.5]),
        seed=seed,
    )


def uploaded_and_captured(
    host: Host, upload: Upload, number: int, channels: int = BOTH
) -> Callable[[], Task[tasks.FetchedFrame]]:
    """The work of a session."""
    wanted = FrameRequest(number, channels, upload)

    def work() -> Task[tasks.FetchedFrame]:
        yield from tasks.upload(host, upload)
        return (yield from tasks.capture(host, wanted))

    return work


def session(
    seed: int,
    loader_of: Callable[[Example], RunningFirmware],
    line_of: type[Simulation] = Simulation,
    slot_us: float = 100.0,
    channels: int = BOTH,
) -> tuple[bool, Simulation]:
    """One session with faults of its own: whether its frame is the emulator's, bit for bit.

    Raises what the host raises where there is no frame at all.
    """
    example = examples(slot_us)[seed % len(examples(slot_us))]
    host = new_host(seed)
    length = len(example.upload.stream) + len(example.frame)
    line = line_of(host, loader_of(example), faults_of(seed, length))
    work = uploaded_and_captured(host, example.upload, seed + 1, channels)
    taken = line.run(host.lasting(work), limit_s=300)
    assert isinstance(taken, tasks.FetchedFrame)
    whole = len(example.frame) if channels == BOTH else TARGET.rows * TARGET.cols
    return taken.data == example.frame[:whole], line


def fresh_loader(
    kind: str, chip: EmulatedChip, request: pytest.FixtureRequest, target: Target = TARGET
) -> RunningFirmware:
    """A loader that has just started: the Python twin, or the firmware of the fixture `core`."""
    if kind == "python":
        return Loader(target, chip, "nscc-loader 2 (Python)")
    core: Lockstep = request.getfixturevalue("core")
    core.chip = chip
    core.announce()
    return core
