"""`nscc device calibrate` finds the times of the board that it measures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from device_lockstep import Lockstep
from device_sessions import SHAPE, ChipAtOnce, new_host
from device_simulation import Simulation
from emulator_programs import target_of
from loader_twin.loader import Loader

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.device import firmware
from nscc_runtime.device.firmware import RunningFirmware
from nscc_runtime.device.measured_times import MeasuredTimes, measured
from nscc_runtime.light import Light

CHIP = replace(
    target_of(SHAPE), launch_us=2.5, analog_word_us=0.37, digital_word_us=0.11, wait_us=1.75
)


def dark(target: Target) -> ChipAtOnce:
    """A chip without light, in any number of slots."""
    return ChipAtOnce(
        lambda slots: Light.of_clip(np.zeros((len(slots), *SHAPE), np.float32)), target
    )


class Wire:
    """A link to a loader on a virtual clock."""

    path = "wire"

    def __init__(self, loader: RunningFirmware) -> None:
        self.host = new_host(5)
        self.line = Simulation(self.host, loader)

    def run(self, work: Callable[[], Any]) -> Any:
        """Runs a task, and returns its result."""
        return self.line.run(self.host.lasting(work))


def check(times: MeasuredTimes) -> None:
    """Checks that measured times are those of CHIP, in microseconds."""
    assert times.launch_us == pytest.approx(2.5, abs=0.002)
    assert times.analog_word_us == pytest.approx(0.37, abs=0.0002)
    assert times.digital_word_us == pytest.approx(0.11, abs=0.0002)
    assert times.wait_us == pytest.approx(1.75, abs=0.002)
    assert times.of(CHIP).launch_us == times.launch_us


def test_the_times_measured_on_the_twin_are_those_of_its_target() -> None:
    wire: Any = Wire(Loader(CHIP, dark(CHIP), "a twin"))
    check(measured(wire, CHIP))


@pytest.mark.skipif(firmware.compiler() is None, reason="no C++ compiler")
def test_the_times_measured_on_the_firmware_are_those_of_its_target() -> None:
    with Lockstep(firmware.built(CHIP, ("-O1",)), dark(CHIP)) as loader:
        wire: Any = Wire(loader)
        check(measured(wire, CHIP))


def test_a_board_without_pixels_is_refused() -> None:
    """On this chip a word takes 0.1 ns, as if it took no time: there is nothing to measure, so
    NS0723."""
    quick = replace(CHIP, analog_word_us=1e-4, digital_word_us=1e-4)
    wire: Any = Wire(Loader(quick, dark(quick), "a twin"))
    with pytest.raises(Rejected) as caught:
        measured(wire, quick)
    assert caught.value.diagnostics[0].code == "NS0723"
