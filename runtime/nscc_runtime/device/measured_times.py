"""Measure the times of launches, words, waits and readouts of a device, as keys of its target.

Each time is the difference of two frames that differ in nothing else, so common times cancel. The
loader's clock measures the duration."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from math import ceil
from random import SystemRandom

import numpy as np

from nscc.chips.target import Target
from nscc.operations import Op, op
from nscc.words.encoding import encode
from nscc_runtime.device import tasks
from nscc_runtime.device.device_errors import rejected
from nscc_runtime.device.host import Task
from nscc_runtime.device.link import SerialLink
from nscc_runtime.device.messages import CaptureReply, Channel
from nscc_runtime.device.objects import (
    COUNT,
    READOUT,
    ROW,
    RUN,
    SCHEDULE_HEAD,
    Object,
    ObjectKind,
    Upload,
    target_digest,
)

LAUNCHES = 2001
"""Number of launches of a measured frame: many, so that the clock's resolution matters little."""
WORDS = 100
"""Number of words that are measured in each launch."""
_NO_LIMIT = (1 << 32) - 1
"""Grace, and number of late launches, that no program exceeds."""
_NO_TIME_US = 1e-3
"""A word that takes less is not executed by a chip. Also the length of a negligible slot."""
_LONGEST_MS = 10_000
"""Upper limit of the time of a frame's words, in milliseconds."""


@dataclass(frozen=True)
class MeasuredTimes:
    """Measured times in microseconds: of a launch, of an analog and of a digital word, of the loop
    that waits for a boundary (`wait_us`), and of the readout of a register. The names are those of
    the target's keys. A launch is the start of a kernel, a list of words."""

    launch_us: float
    analog_word_us: float
    digital_word_us: float
    wait_us: float
    readout_us: float

    def of(self, target: Target) -> Target:
        """Return a copy of the target with these times."""
        return replace(target, **asdict(self))


def measured(link: SerialLink, target: Target) -> MeasuredTimes:
    """Measure the times of the device behind `link`, of the chip `target`; its program is replaced.
    Raises Rejected (status 3): NS0723 for a device on which words take no time, and others if the
    device fails."""
    register = target.digital_registers[-1]
    analog, digital = op("nop"), op("CLR", [register])

    def took(kernel: Sequence[Op], launches: int, waits: bool = False) -> CaptureReply:
        """Return the reply of a frame that runs `kernel` in this number of launches: at once, or
        with `waits` each at a boundary of its own. A launch is the start of a kernel, a list of
        words."""
        return _captured(link, _program(target, kernel, launches, waits))

    once = took([analog], 1).lasted_us
    plain = took([analog], LAUNCHES)
    with_analog = took([analog] * (1 + WORDS), LAUNCHES).lasted_us
    with_digital = took([analog, *[digital] * WORDS], LAUNCHES).lasted_us
    waiting = took([analog], LAUNCHES, waits=True).lasted_us
    analog_us = (with_analog - plain.lasted_us) / (LAUNCHES * WORDS)
    digital_us = (with_digital - plain.lasted_us) / (LAUNCHES * WORDS)
    if min(analog_us, digital_us) < _NO_TIME_US:
        raise rejected(
            "NS0723",
            f"words take no time on the device at '{link.path[:200]}', because it has no "
            "pixels of its own",
            "calibrate a real chip, or `nscc device serve`, which simulates the word times "
            "of its target",
        )
    return MeasuredTimes(
        # The frames differ in all launches but one; each of these also runs the word of its kernel.
        round((plain.lasted_us - once) / (LAUNCHES - 1) - analog_us, 4),
        round(analog_us, 4),
        round(digital_us, 4),
        round(max(waiting - plain.lasted_us, 0) / LAUNCHES, 4),
        float(plain.readout_us or target.readout_us),
    )


def _captured(link: SerialLink, program: Upload) -> CaptureReply:
    """Upload a program, capture and fetch a frame of it, and return the loader's reply about it.
    Raises Rejected (status 3) if the device fails."""
    request = tasks.FrameRequest(SystemRandom().randrange(1 << 63), Channel.CODES, program)

    def work() -> Task[tasks.FetchedFrame]:
        """Upload the program, capture a frame of it and return that frame."""
        yield from tasks.upload(link.host, program)
        return (yield from tasks.capture(link.host, request))

    return link.run(work).captured


def _program(target: Target, kernel: Sequence[Op], launches: int, waits: bool) -> Upload:
    """Return a program for `target` that launches `kernel`, its operations, `launches` times (at
    most 65535): at once, or with `waits` after a slot of negligible length each. Late launches
    (starts of kernels) are allowed. A kernel is a list of words."""
    slots = launches if waits else 1
    words = np.array([encode(op("rpix")), *(encode(word) for word in kernel)], "<u4")
    objects = (
        Object(ObjectKind.READOUTS, 0, COUNT.pack(1) + READOUT.pack(0, False, 1.0)),
        Object(
            ObjectKind.KERNELS, 0,
            COUNT.pack(2) + COUNT.pack(1) + COUNT.pack(len(kernel)) + words.tobytes(),
        ),
        Object(
            ObjectKind.SCHEDULE, 0,
            SCHEDULE_HEAD.pack(slots, _NO_LIMIT, _NO_LIMIT) + COUNT.pack(1)
            + RUN.pack(slots, _NO_TIME_US) + COUNT.pack(2) + ROW.pack(0, 0, 1)
            + ROW.pack(int(waits), 1, launches),
        ),
    )  # fmt: skip
    return Upload(
        target_digest(target),
        bytes(32),
        objects,
        words=len(words),
        kernels=2,
        rows=2,
        runs=1,
        frame_ms=_LONGEST_MS,
        readout_ms=ceil(target.readout_us / 1000),
        readouts=1,
        states=0,
        report_bytes=0,
        gains=False,
        levels=False,
        pictures=False,
        pixels=target.rows * target.cols,
    )
