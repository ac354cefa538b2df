"""Instructions that the loader takes where time counts, counted on an emulated Cortex-M."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from nscc_runtime.device import qemu
from nscc_runtime.device.firmware import SOURCES

pytestmark = pytest.mark.skipif(
    qemu.missing() is not None, reason=f"{qemu.missing()} is not installed: nothing to count with"
)
MOST_A_LAUNCH: dict[qemu.Core, int] = {"m0": 200, "m4": 120}
MOST_A_BYTE = 25


@pytest.mark.parametrize("core", ["m0", "m4"])
def test_launches_and_sums_stay_within_their_budget(
    core: qemu.Core, root: Path, tmp_path: Path
) -> None:
    """A launch: of one row again and again, and of a new row in a new run of slots each time."""
    image = tmp_path / "budget.elf"
    sources = [*sorted((SOURCES / "core").glob("*.cpp")), SOURCES / "qemu/start.cpp"]
    sources.append(root / "tests/firmware_time/budget.cpp")
    parts = ("core", "port", "qemu", "targets/scamp5")
    command = [qemu.COMPILER, *qemu.CHIP_FLAGS, f"-mcpu=cortex-{core}"]
    command += [f"-I{SOURCES / part}" for part in parts]
    command += [f"-L{SOURCES / 'port'}", f"-T{SOURCES / 'qemu/mps2.ld'}"]
    subprocess.run([*command, *map(str, sources), "-o", str(image)], check=True)
    started = qemu.command(core, image, "shift=0,sleep=off")
    with subprocess.Popen([*started, "-serial", "stdio"], stdout=subprocess.PIPE) as board:
        assert board.stdout is not None
        same, other, byte = (int(board.stdout.readline()) for _ in range(3))
        board.kill()
    assert 20 < same <= other <= MOST_A_LAUNCH[core]
    assert 5 < byte <= MOST_A_BYTE
