"""A stand-in for a chip at a serial port: the real loader over the emulator."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Literal

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc_runtime.device import firmware, qemu
from nscc_runtime.device.board import EmulatedChip
from nscc_runtime.device.firmware import RunningFirmware
from nscc_runtime.scenes import Scene, scene_light
from nscc_runtime.scenes.errors import Warn, unheard
from nscc_runtime.sensor import Sensor

Machine = Literal["host", "qemu", "qemu-m0"]
"""Where the firmware runs: on this computer, or on an emulated Cortex-M4 or Cortex-M0."""


def emulated_chip(
    scene: Scene,
    target: Target,
    sensor: Sensor,
    device_seed: int = 0,
    *,
    warn: Warn = unheard,
    failed: Callable[[Exception], None] = lambda _: None,
) -> EmulatedChip:
    """Return an emulated chip of `target` that sees `scene` with any program. `sensor` has the
    parameters of its effects, and `device_seed` numbers its fixed patterns.

    Raises Rejected now for a scene that suits no program; whether a clip has enough frames (NS0735)
    depends on the program. Later, `warn` is called with messages about the scene, and `failed` with
    the reason for a missing frame, because the host only learns that it is missing."""
    try:
        # One slot of any length: what fails with it but for the number of frames fails with all.
        scene_light(scene, (1000.0,), target)
    except Rejected as error:
        if Path(scene.name).is_dir() or error.diagnostics[0].code != "NS0735":
            raise
    return EmulatedChip(
        lambda slot_us: scene_light(scene, slot_us, target, warn),
        target,
        sensor,
        device_seed,
        failed,
    )


@contextmanager
def loaded(
    machine: Machine, target: Target, chip: EmulatedChip, say: Callable[[str], None]
) -> Iterator[RunningFirmware]:
    """Run the firmware for `target`, compiled for `machine`, in its own process for a with block,
    and yield it. `chip` executes its words.

    `qemu` and `qemu-m0` are an emulated Cortex-M4 and Cortex-M0. `say` is called with a text that
    describes the loader. Raises Rejected (NS0772, status 2) if the firmware cannot be compiled or
    does not start."""
    try:
        if machine == "host":
            built = firmware.built(target)
            with firmware.Process(built, chip) as process:
                say(f"loader: the firmware, compiled by {built.compiler}")
                yield process
        else:
            core: qemu.Core = "m0" if machine == "qemu-m0" else "m4"
            with qemu.Emulated(qemu.built(target, core), chip, core) as board:
                say(f"loader: the firmware on a Cortex-{core.upper()}, emulated by {qemu.EMULATOR}")
                yield board
    except firmware.NotBuilt as reason:
        problem = "cannot be compiled for this machine"
        helps = (
            "install a C++17 compiler, on Debian and Ubuntu with `apt-get install g++`, on "
            "macOS with `xcode-select --install`",
            "CXX names a compiler that is neither g++ nor clang++",
        )
        if isinstance(reason, firmware.NotStarted):
            problem = "cannot be run on this machine"
            helps = (
                "CXX names another compiler, for instance CXX=clang++",
                "allow the execution of programs in the cache folder (NSCC_CACHE_DIR)",
            )
        elif machine != "host":
            problem = "cannot be run on an emulated microcontroller"
            helps = (
                "install both programs, on Debian and Ubuntu with `apt-get install "
                "gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm`",
                "or serve the firmware on this machine: leave --on out",
            )
        raise rejected("NS0772", f"the firmware {problem}: {reason}", helps=helps) from None
