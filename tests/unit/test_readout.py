"""Codes mean what the target says they mean: black, half and full come back as electrons, whatever
the readout, from the emulator and from a device. (C++ and the SCAMP-5d's loader: test_emit_cpp,
test_device_firmware.)"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from device_sessions import ChipAtOnce, new_host
from device_simulation import Simulation
from emulator_programs import bumps, target_of

from nscc.target.target import Target
from nscc_runtime.device import firmware, tasks
from nscc_runtime.device.chip import frame_of
from nscc_runtime.device.loader import Loader
from nscc_runtime.device.messages import Channel
from nscc_runtime.device.objects import upload_of
from nscc_runtime.device.wanted import Wanted
from nscc_runtime.effects import selected
from nscc_runtime.emulator import expose
from nscc_runtime.frame_file import read_out
from nscc_runtime.light import Light
from nscc_runtime.planner.choose import plan_for
from nscc_runtime.planner.frames import made_ready, planned_frames
from nscc_runtime.sensor import default_sensor

WELL_E = 30_000.0
CODES = {"spread": (0, 128, 255), "full": (128, 192, 255), "half": (0, 64, 127)}
"""By hand: of nothing, half a well and a well. Steps are 30000 / 255 and twice that."""


def chip(readout: str) -> Target:
    """An array of three pixels in a row."""
    return replace(target_of((1, 3)), readout=readout)  # type: ignore[arg-type]


def program_and_light(target: Target) -> tuple[object, Light]:
    """Open all the time; one pixel each sees nothing, half a well, a well."""
    container = bumps(target, None, np.full((1, 3), 4), 4, "latch")
    container = replace(container, slot_us=(1000.0,) * 4)
    electrons = np.array([[0.0, WELL_E / 2, WELL_E]], np.float32)
    return container, Light.of_clip(np.repeat(electrons[None] / 4, 4, axis=0))


@pytest.mark.parametrize("readout", list(CODES))
def test_the_emulator(readout: str) -> None:
    target = chip(readout)
    container, light = program_and_light(target)
    sensor = default_sensor(target)
    frame = read_out(expose(container, light), target, sensor)  # type: ignore[arg-type]
    check(frame.frame, readout, target)
    assert frame.saturated.tolist() == [[[False, False, True]]]
    program = made_ready(container, sensor)  # type: ignore[arg-type]
    plan = plan_for(program, light, 5.0, selected("none"), 0)
    [planned] = planned_frames(program, light, plan, 0, 0, 1, 1)
    np.testing.assert_array_equal(planned.frame, frame.frame)


@pytest.mark.parametrize(
    ("kind", "readout"), [*(("python", readout) for readout in CODES), ("firmware", "full")]
)
def test_a_device(kind: str, readout: str, tmp_path: Path) -> None:
    target = chip(readout)
    container, light = program_and_light(target)
    emulated = ChipAtOnce(lambda _: light, target)
    if kind == "firmware" and firmware.compiler() is None:
        pytest.skip("no C++ compiler: the firmware cannot be built")
    host, upload = new_host(1), upload_of(container, bytes(32))  # type: ignore[arg-type]
    wanted = Wanted(1, Channel.CODES, upload)

    def work() -> tasks.Task[tasks.Taken]:
        yield from tasks.upload(host, upload)
        return (yield from tasks.capture(host, wanted))

    if kind == "python":
        taken = Simulation(host, Loader(target, emulated, "x")).run(host.lasting(work))
    else:
        from device_lockstep import Lockstep

        with Lockstep(firmware.built(target, ("-O0",), tmp_path), emulated) as loader:
            taken = Simulation(host, loader).run(host.lasting(work))
    assert isinstance(taken, tasks.Taken)
    sensor = default_sensor(target)
    frame = frame_of(taken.data, Channel.CODES, (1, 1, 3), sensor, target)
    check(frame.frame, readout, target)
    np.testing.assert_allclose(
        frame.exposure_e[0, 0], [0.0, WELL_E / 2, WELL_E], atol=sensor.electrons_per_lsb / 2
    )


def check(codes: np.ndarray, readout: str, target: Target) -> None:
    """The codes, and that they are electrons again by the sensor's figures."""
    assert codes.reshape(-1).tolist() == list(CODES[readout])
    sensor = default_sensor(target)
    electrons = (codes - sensor.adc_offset_lsb) * sensor.electrons_per_lsb
    wanted = [0.0, WELL_E / 2, WELL_E]
    np.testing.assert_allclose(electrons.reshape(-1), wanted, atol=sensor.electrons_per_lsb / 2)
