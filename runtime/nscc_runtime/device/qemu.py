"""The firmware compiled for a Cortex-M, on QEMU.

Its first serial port is the line; the second one connects it to the emulator of the pixels."""

from __future__ import annotations

import shutil
import socket
import tempfile
from pathlib import Path
from struct import Struct
from typing import Literal

from nscc.chips.target import Target
from nscc_runtime.device.board import BoardJob, EmulatedChip
from nscc_runtime.device.firmware import (
    CORE_FLAGS,
    SOURCES,
    WARNINGS,
    Built,
    NotBuilt,
    RunningFirmware,
    compiled,
)

Core = Literal["m0", "m4"]
COMPILER, EMULATOR = "arm-none-eabi-g++", "qemu-system-arm"
_MACHINES: dict[Core, str] = {"m0": "mps2-an385", "m4": "mps2-an386"}
"""The QEMU machine for each core. A Cortex-M3 runs the code of a Cortex-M0, with traps enabled."""
_PARTS = ("core", "port", "emulated", "qemu")
CHIP_FLAGS = (
    *CORE_FLAGS,
    *WARNINGS,
    "-O2",
    "-mthumb",
    "-fno-threadsafe-statics",
    "-ffunction-sections",
    "-fdata-sections",
    "-nostartfiles",
    "--specs=nosys.specs",
    "-Wl,--gc-sections",
)
_TIME = "shift=2,sleep=off"
"""An instruction takes 4 ns, about as on the SCAMP-5d, so that the load of this machine does not
make launches late."""
_WANTED = Struct("<III")
_START_S = 20.0


def missing() -> str | None:
    """Return the name of a required program that is not installed; None if both are installed."""
    return next((name for name in (COMPILER, EMULATOR) if shutil.which(name) is None), None)


def built(target: Target, core: Core = "m4") -> Built:
    """Return the loader for `target`, compiled for a Cortex of the kind `core`. Raises NotBuilt if
    a program is missing or compiling fails."""
    absent = missing()
    if absent is not None:
        raise NotBuilt(f"{absent} is not installed")
    command = [
        COMPILER,
        *CHIP_FLAGS,
        f"-mcpu=cortex-{core}",
        f"-L{SOURCES / 'port'}",
        f"-T{SOURCES / 'qemu/mps2.ld'}",
    ]
    return Built(compiled(command, _PARTS, target), COMPILER, target)


def command(core: Core, image: Path, time: str) -> list[str]:
    """Return the command that runs the program file `image` on an emulated `core`, without serial
    ports. `time`: the argument of QEMU's -icount, such as `_TIME`."""
    return [
        EMULATOR,
        "-M",
        _MACHINES[core],
        "-kernel",
        str(image),
        "-icount",
        time,
        "-display",
        "none",
        "-monitor",
        "none",
    ]


class Emulated(RunningFirmware):
    """A loader on an emulated board."""

    def __init__(self, loader: Built, chip: EmulatedChip, core: Core = "m4") -> None:
        """Start the firmware `loader` on an emulated Cortex-M, with a socket as its serial line.
        `chip` executes its words. `core` must be the one that it was compiled for.

        Raises NotBuilt if the emulator does not connect within `_START_S` seconds."""
        self._frame: tuple[int, bytes] = 0, b""
        with tempfile.TemporaryDirectory(prefix="nscc-qemu-") as name:
            path = f"{name}/line"
            with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as listening:
                listening.bind(path)
                listening.listen(1)
                listening.settimeout(_START_S)
                super().__init__(
                    [
                        *command(core, loader.path, _TIME),
                        "-chardev",
                        f"socket,id=line,path={path}",
                        "-serial",
                        "chardev:line",
                        "-chardev",
                        "stdio,id=records,signal=off",
                        "-serial",
                        "chardev:records",
                    ],
                    loader.target,
                    chip,
                )
                # The emulator connects once it runs; the socket then is its serial line.
                try:
                    line, _ = listening.accept()
                except TimeoutError:
                    self.close()
                    raise NotBuilt(f"{EMULATOR} does not start") from None
            line.setblocking(False)
            self._line = line.detach()

    def sent(self, job: BoardJob, frame: bytes) -> bytes:
        """Store the `frame` of `job` and return no bytes: the board requests them column by
        column."""
        self._frame = job.number, frame
        return b""

    def follow(self, kind: bytes, data: bytes) -> None:
        """Handle a record of the loader, by `kind` (one byte) and `data`. A request for bytes of
        the last frame is answered here, with no bytes if it is for another frame; any other goes to
        the base class."""
        if kind != b"C":
            super().follow(kind, data)
            return
        number, offset, count = _WANTED.unpack(data)
        frame_number, frame = self._frame
        self.write_record(b"B", frame[offset : offset + count] if number == frame_number else b"")

    def close(self) -> int:
        """End the emulator, which does not stop by itself; return its exit status."""
        self._process.kill()
        return super().close()
