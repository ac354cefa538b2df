"""Programs that look, on a device: the frame file of a stand-in is that of `nscc run`, bit by bit.

Light falls at random on a small array; both loaders run the examples, kept states go on from frame
to frame.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
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
from looks_programs import looking_frames

from nscc.chips.load import target_toml
from nscc.compiler import compile_source
from nscc.pipeline import Options
from nscc.source import Source
from nscc.words.container import Container, Launch
from nscc_runtime.device import tasks
from nscc_runtime.device.device_chip import channels_of, frame_of
from nscc_runtime.device.host import Host, Task
from nscc_runtime.device.objects import upload_of
from nscc_runtime.device.tasks import FrameRequest
from nscc_runtime.effects import selected
from nscc_runtime.frame_file import Frame
from nscc_runtime.light import Light
from nscc_runtime.sensor import default_sensor

pytestmark = pytest.mark.xdist_group("firmware")
EXAMPLES = ROOT / "examples"


def looking(name: str, folder: Path) -> tuple[Container, Light]:
    """An example for the small target, and light that makes its pixels differ."""
    (folder / "small.toml").write_text(target_toml(replace(TARGET, name="small")))
    text = (EXAMPLES / f"{name}.nsl").read_text()
    text = text.replace("nsl 2\n", 'nsl 2\ntarget "small.toml"\n', 1)
    container = compile_source(Source("p.nsl", text), folder, Options(cache=False)).container
    assert container is not None
    container = replace(container, target=TARGET)
    a_slot = 10 ** np.random.default_rng(8).uniform(0, 4.5, (1, TARGET.rows, TARGET.cols))
    return container, Light.of_clip(np.repeat(a_slot.astype(np.float32), container.slots, axis=0))


@pytest.fixture(scope="module")
def core() -> Iterator[Lockstep]:
    """The firmware's core with sanitizers, one process for this file."""
    loader = Lockstep(sanitized(), chip_of(examples()[0]))
    yield loader
    assert loader.close() == 0, "a sanitizer complained"


@pytest.fixture(params=["python", "firmware"])
def kind(request: pytest.FixtureRequest) -> str:
    """Which loader."""
    return str(request.param)


def film(host: Host, container: Container, count: int, line: Simulation) -> list[Frame]:
    """Frames of a program that begins with its first values, as the host makes them."""
    program, frames = upload_of(container, bytes(32)), []

    def begun() -> Task[bool]:
        yield from tasks.forget(host, program)
        return (yield from tasks.upload(host, program))

    assert line.run(host.lasting(begun)) is False
    assert host.info is not None
    channels = channels_of(host.info, program)
    shape = (len(container.readouts), TARGET.rows, TARGET.cols)
    for number in range(1, count + 1):
        first = 100 * len(line.events) + number
        wanted = FrameRequest(first, channels, program)
        taken = line.run(host.lasting(lambda one=wanted: tasks.capture(host, one)))
        assert isinstance(taken, tasks.FetchedFrame)
        sensor = default_sensor(TARGET)
        frames.append(frame_of(taken.data, channels, shape, sensor, TARGET, container))
    line.events.append((line.now, "film"))
    return frames


@pytest.mark.parametrize("name", ["float_pixel", "auto_exposure", "first_light"])
def test_films_of_looking_programs_on_a_device_equal_those_of_the_emulator(
    name: str, kind: str, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    container, light = looking(name, tmp_path)
    chip = ChipAtOnce(lambda _: light, TARGET)
    host = new_host(1)
    line = Simulation(host, fresh_loader(kind, chip, request))
    count = 3 if name == "auto_exposure" else 1
    sensor = default_sensor(TARGET)
    wanted = list(looking_frames(container, light, sensor, selected("none"), count=count))
    # A film begins anew with what the program says, whatever the one before left.
    for frames in (film(host, container, count, line) for _ in range(2)):
        for found, frame in zip(frames, wanted, strict=True):
            assert found.told.keys() == frame.told.keys()
            pairs = [(found.frame, frame.frame), (found.exposure_e, frame.exposure_e)]
            pairs += [(found.told[key], frame.told[key]) for key in frame.told]
            for one, other in pairs:
                assert one.dtype == other.dtype
                np.testing.assert_array_equal(one, other)
    if name == "auto_exposure":
        stops = [frame.told["states_stop"] for frame in wanted]
        assert any((one != other).any() for one, other in pairwise(stops))


def test_levels_that_in_does_not_have_and_other_counts_are_refused(tmp_path: Path) -> None:
    from loader_twin.parsing import Held, Limits, Refusal

    from nscc_runtime.device.messages import LoaderFault
    from nscc_runtime.device.objects import COUNT, LEVEL, ObjectKind

    container, _ = looking("float_pixel", tmp_path)
    objects = {each.kind: each.data for each in upload_of(container, bytes(32)).objects}
    most = Limits(words=TARGET.store_words)

    def refusal(levels: list[int]) -> tuple[int, int]:
        held = Held()
        held.accept(ObjectKind.KERNELS, 0, objects[ObjectKind.KERNELS], TARGET, most)
        data = COUNT.pack(len(levels)) + b"".join(LEVEL.pack(level) for level in levels)
        with pytest.raises(Refusal) as refused:  # noqa: PT012
            held.accept(ObjectKind.LEVELS, 0, data, TARGET, most)
            held.accept(ObjectKind.SCHEDULE, 0, objects[ObjectKind.SCHEDULE], TARGET, most)
        return refused.value.fault, refused.value.detail

    assert refusal([5]) == (LoaderFault.SCHEDULE, 5)
    assert refusal([TARGET.in_high + 1]) == (LoaderFault.SCHEDULE, 6)
    assert refusal([TARGET.in_low - 1]) == (LoaderFault.SCHEDULE, 6)


def test_launches_are_a_row_only_where_their_level_is_one(tmp_path: Path) -> None:
    """Eight launches, four of them at level 5, make three rows of the schedule and need levels."""
    container, _ = looking("float_pixel", tmp_path)
    launches = tuple(Launch(n, 0, 5 if n < 4 else None) for n in range(8))
    upload = upload_of(replace(container, launches=launches), bytes(32))
    assert upload.rows == 3  # the first one comes without a slot before it
    assert upload.levels
