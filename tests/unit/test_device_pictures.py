"""Images and planes on a device: the frame of a stand-in is that of the emulator, bit by bit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from device_lockstep import Lockstep
from device_sessions import (
    TARGET,
    ChipAtOnce,
    chip_of,
    examples,
    fresh_loader,
    new_host,
    sanitized,
)
from device_simulation import Simulation

from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc_runtime.device import tasks
from nscc_runtime.device.device_chip import channels_of, frame_of
from nscc_runtime.device.frame_request import FrameRequest
from nscc_runtime.device.host import Task
from nscc_runtime.device.objects import upload_of
from nscc_runtime.device.serving import Loaded
from nscc_runtime.effects import selected
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

pytestmark = pytest.mark.xdist_group("firmware")
SMALL = replace(TARGET, rows=8, cols=12, name="small")
CROSS = "kernel k = [[0, 1, 0], [1, 1, 1], [0, 1, 0]] / 8\n"
PROGRAMS = {
    "a kernel": "open when true\n" + CROSS + "image i = k(exposure)\nread i",
    "edges": "open when true\nkernel s = [[1, 0, -1], [2, 0, -2], [1, 0, -1]] / 8\n"
    "image i = abs(s(exposure))\nplane p = i > 6%\nread i, p",
    "a plane only": "open when true\noutside 0\n" + CROSS + "plane p = exposure > 20%\n"
    "plane core = all(p, k)\nread core",
    "reports": "open when true\n" + CROSS + "plane p = k(exposure) > 6%\n"
    "report events p at most 3\nreport any p\nreport box p",
    "buckets": "bucket a open when n < 2\nbucket b open when n >= 2\nplane p = a > b\n"
    "image d = a if p else b / 2\nread b, d, p",
}  # fmt: skip


def container_of(body: str) -> Container:
    source = Source("p.nsl", f"nsl 3\nframe 4 slots of 1ms\n{body}\n")
    made = run_passes(source, Path(), Options(level=1, target=SMALL, cache=False)).container
    assert made is not None
    return made


def light() -> Light:
    values = np.random.default_rng(5).uniform(0, 7000, (4, SMALL.rows, SMALL.cols))
    return Light.of_clip(np.round(values).astype(np.float32))


@pytest.fixture(scope="module")
def core() -> Iterator[Lockstep]:
    """The firmware's core with sanitizers, one process for this file."""
    loader = Lockstep(sanitized(target=SMALL), chip_of(examples()[0]))
    yield loader
    assert loader.close() == 0, "a sanitizer complained"


def captured(loader: Loaded, container: Container) -> Frame:
    """The frame of a loader, as the host makes it."""
    host, program = new_host(1), upload_of(container, bytes(32))
    line = Simulation(host, loader)

    def uploaded() -> Task[bool]:
        return (yield from tasks.upload(host, program))

    line.run(host.lasting(uploaded))
    assert host.info is not None
    channels = channels_of(host.info, program)
    wanted = FrameRequest(1, channels, program)
    taken = line.run(host.lasting(lambda: tasks.capture(host, wanted)))
    assert isinstance(taken, tasks.FetchedFrame)
    shape = (program.readouts, SMALL.rows, SMALL.cols)
    return frame_of(taken.data, channels, shape, default_sensor(SMALL), SMALL, container)


@pytest.mark.parametrize("kind", ["python", "firmware"])
@pytest.mark.parametrize("name", PROGRAMS)
def test_a_frame_is_that_of_the_emulator(
    name: str, kind: str, request: pytest.FixtureRequest
) -> None:
    container = container_of(PROGRAMS[name])
    runner = PicturedProgram(container, default_sensor(SMALL), selected("none"), threads=1)
    (wanted,) = runner.frames(light(), 0, 0, 1)
    found = captured(
        fresh_loader(kind, ChipAtOnce(lambda _: light(), SMALL), request, SMALL), container
    )
    assert found.told.keys() == wanted.told.keys()
    pairs = [(found.frame, wanted.frame), (found.exposure_e, wanted.exposure_e)]
    pairs += [(found.told[key], wanted.told[key]) for key in wanted.told]
    for one, other in pairs:
        assert one.dtype == other.dtype
        np.testing.assert_array_equal(one, other)
