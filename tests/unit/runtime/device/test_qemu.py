"""The loader on an emulated Cortex-M: the frames of the host's build, over the same bad cables."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from select import select
from time import monotonic
from typing import Any

import numpy as np
import pytest
from device_real_time import RealTime
from device_sessions import (
    SHAPE,
    TARGET,
    ChipAtOnce,
    Example,
    chip_of,
    examples,
    new_host,
    session,
    uploaded_and_captured,
)

from nscc.operations import op
from nscc.words.encoding import encode
from nscc_runtime.device import qemu, tasks
from nscc_runtime.device.firmware import RunningFirmware
from nscc_runtime.device.measured_times import measured
from nscc_runtime.device.messages import CaptureReply, CaptureRequest, Channel, LoaderState
from nscc_runtime.device.objects import (
    COUNT,
    READOUT,
    ROW,
    RUN,
    SCHEDULE_HEAD,
    Object,
    ObjectKind,
    Upload,
)
from nscc_runtime.device.packets import PacketKind, Unpacker
from nscc_runtime.light import Light

pytestmark = pytest.mark.skipif(
    qemu.missing() is not None, reason=f"{qemu.missing()} is not installed: nothing to emulate with"
)
SLOT_US = 500.0
"""Long enough for every launch, which the board tells its emulator over a serial port."""
CORES: tuple[qemu.Core, ...] = ("m0", "m4")


@pytest.fixture(params=CORES)
def started(request: pytest.FixtureRequest) -> Iterator[Callable[[Example], RunningFirmware]]:
    """An emulated board; what starts its loader anew for an example."""
    core: qemu.Core = request.param
    with qemu.Emulated(qemu.built(TARGET, core), chip_of(examples(SLOT_US)[0]), core) as board:

        def start(example: Example) -> RunningFirmware:
            board.chip = chip_of(example)
            board.announce()
            return board

        yield start


def test_faulty_sessions_end_with_the_right_frame(
    started: Callable[[Example], RunningFirmware],
) -> None:
    for seed in range(2):
        right, line = session(seed, started, RealTime, SLOT_US, Channel.CODES)
        assert right, line.faults


def program_without_waiting(launches: int) -> Upload:
    """A program whose launches take 21 us each and follow one another at once."""
    words, slot = np.array([encode(op("nop"))] * 100, "<u4"), 1e-3
    schedule = SCHEDULE_HEAD.pack(1, 0, 0) + COUNT.pack(1) + RUN.pack(1, slot)
    schedule += COUNT.pack(1) + ROW.pack(0, 0, launches)
    return replace(
        examples(SLOT_US)[0].upload,
        objects=(
            Object(ObjectKind.READOUTS, 0, COUNT.pack(1) + READOUT.pack(0, False, 1.0)),
            Object(ObjectKind.KERNELS, 0, COUNT.pack(1) + COUNT.pack(100) + words.tobytes()),
            Object(ObjectKind.SCHEDULE, 0, schedule),
        ),
        frame_ms=1500,
    )


def test_a_frame_without_any_waiting_is_cancelled_at_once(
    started: Callable[[Example], RunningFirmware],
) -> None:
    """The board's own clock measures the time. The whole frame would take more than a second."""
    host = new_host(1)
    line = RealTime(host, started(examples(SLOT_US)[0]))
    program = program_without_waiting(65_535)

    def work() -> tasks.Task[float]:
        yield from tasks.upload(host, program)
        before = yield from host.status()
        reply = yield from host.ask(PacketKind.CAPTURE, CaptureRequest(1, Channel.CODES).pack())
        began = CaptureReply.unpack(reply.body)
        assert not began.ready
        assert began.estimate_ms > 1300
        yield from host.cancel()
        status = yield from host.status()
        assert status.state == LoaderState.READY
        return (status.uptime_us - before.uptime_us) / 1e6

    took_s = line.run(host.lasting(work), limit_s=120)
    assert isinstance(took_s, float)
    assert took_s < 0.2


@pytest.mark.slow
def test_a_board_that_is_stuck_starts_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    """The emulator of the board stops reading, so the board blocks and its watchdog restarts it."""
    monkeypatch.setattr(qemu, "_TIME", "shift=8,sleep=off")  # four seconds are soon over
    loader, chip = qemu.built(TARGET, "m4"), chip_of(examples(SLOT_US)[0])
    with qemu.Emulated(loader, chip, "m4") as board:
        host, packets = new_host(1, patience_s=300.0), Unpacker()
        end = monotonic() + 300
        upload = program_without_waiting(65_535)
        work = uploaded_and_captured(host, upload, 1, Channel.CODES)
        host.start(host.lasting(work), monotonic())
        [line, _] = board.watched()
        boots = 0
        while boots < 2 and monotonic() < end:
            with suppress(BlockingIOError):
                os.write(line, host.poll(monotonic()))
            if select([line], [], [], 0.05)[0]:
                data = os.read(line, 4096)
                boots += sum(packet.kind == PacketKind.BOOTED for packet in packets.feed(data))
                host.receive(data, monotonic())
        assert boots == 2


@pytest.mark.slow
def test_words_take_the_time_that_the_target_states() -> None:
    """Measured by `nscc device calibrate`; telling the emulator takes a part of a launch."""
    dark = ChipAtOnce(
        lambda slots: Light.of_clip(np.zeros((len(slots), *SHAPE), np.float32)), TARGET
    )
    with qemu.Emulated(qemu.built(TARGET, "m4"), dark, "m4") as board:
        wire: Any = Wire(board)
        times = measured(wire, TARGET)
    assert times.analog_word_us == pytest.approx(TARGET.analog_word_us, rel=0.02)
    assert times.digital_word_us == pytest.approx(TARGET.digital_word_us, rel=0.02)
    assert TARGET.launch_us <= times.launch_us < 2 * TARGET.launch_us
    assert 0 < times.wait_us < 2 * TARGET.wait_us


class Wire:
    """A link to a board in real time."""

    path = "wire"

    def __init__(self, board: RunningFirmware) -> None:
        self.host = new_host(5)
        self.line = RealTime(self.host, board)

    def run(self, work: Callable[[], Any]) -> Any:
        """What comes of a task."""
        return self.line.run(self.host.lasting(work))


@pytest.mark.slow
def test_a_hundred_faulty_sessions_end_with_the_right_frame(
    started: Callable[[Example], RunningFirmware],
) -> None:
    for seed in range(4, 104):
        right, line = session(seed, started, RealTime, SLOT_US, Channel.CODES)
        assert right, line.faults
