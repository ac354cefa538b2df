"""Sessions over bad cables, on a virtual clock: every frame is the emulator's, and none hangs."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from device_lockstep import Lockstep
from device_sessions import Example, chip_of, examples, python_loader, sanitized, session

from nscc_runtime.device.firmware import RunningFirmware

pytestmark = pytest.mark.xdist_group("firmware")
HALF = 100


def test_sessions_with_the_python_twin_end_correctly() -> None:
    accidents = 0
    for seed in range(HALF):
        right, line = session(seed, python_loader)
        assert right, line.faults
        accidents += len(line.events)
    assert accidents > HALF // 4


@pytest.fixture
def core() -> Iterator[Lockstep]:
    """The firmware's core in a process of its own, with sanitizers."""
    loader = Lockstep(sanitized(), chip_of(examples()[0]))
    yield loader
    assert loader.close() == 0, "a sanitizer complained"


def test_sessions_with_the_firmware_end_correctly(core: Lockstep) -> None:
    def started(example: Example) -> RunningFirmware:
        core.chip = chip_of(example)
        core.announce()
        return core

    for seed in range(HALF, 2 * HALF):
        right, line = session(seed, started)
        assert right, line.faults
