"""The loader on an emulated Cortex-M: the frames of the host's build, over the same bad cables."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from device_real_time import RealTime
from device_sessions import TARGET, Example, chip_of, examples, session

from nscc_runtime.device import qemu
from nscc_runtime.device.messages import Channel
from nscc_runtime.device.serving import Loaded

pytestmark = pytest.mark.skipif(
    qemu.missing() is not None, reason=f"{qemu.missing()} is not installed: nothing to emulate with"
)
SLOT_US = 500.0
"""Long enough for every launch, which the board tells its emulator over a serial port."""
CORES: tuple[qemu.Core, ...] = ("m0", "m4")


@pytest.fixture(params=CORES)
def started(request: pytest.FixtureRequest) -> Iterator[Callable[[Example], Loaded]]:
    """An emulated board; what starts its loader anew for an example."""
    core: qemu.Core = request.param
    with qemu.Emulated(qemu.built(TARGET, core), chip_of(examples(SLOT_US)[0]), core) as board:

        def start(example: Example) -> Loaded:
            board.chip = chip_of(example)
            board.announce()
            return board

        yield start


def test_faulty_sessions_end_with_the_right_frame(
    started: Callable[[Example], Loaded],
) -> None:
    for seed in range(4):
        right, line = session(seed, started, RealTime, SLOT_US, Channel.CODES)
        assert right, line.faults


@pytest.mark.slow
def test_a_hundred_faulty_sessions_end_with_the_right_frame(
    started: Callable[[Example], Loaded],
) -> None:
    for seed in range(4, 104):
        right, line = session(seed, started, RealTime, SLOT_US, Channel.CODES)
        assert right, line.faults
