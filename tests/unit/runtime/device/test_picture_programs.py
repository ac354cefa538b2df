"""Images, planes and kept states on a device: the film of a stand-in is that of the emulator, bit
by bit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from cells_oracle import random_cell
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
from scipy.ndimage import correlate

from nscc.chips.target import Target
from nscc.operations import NEIGHBOURS
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container
from nscc.words.legality import picture_words
from nscc.words.reach import Reach, beyond_reaches
from nscc.words.readout import converter_of
from nscc_runtime.device import tasks
from nscc_runtime.device.board import BoardProgram, ExecutedFrame
from nscc_runtime.device.device_chip import channels_of, frame_of
from nscc_runtime.device.firmware import RunningFirmware
from nscc_runtime.device.host import Task
from nscc_runtime.device.objects import packed_plane, upload_of
from nscc_runtime.device.tasks import FrameRequest
from nscc_runtime.effects import selected
from nscc_runtime.frame_file import Frame
from nscc_runtime.host_setting import HostSetting, host_settings
from nscc_runtime.light import Light
from nscc_runtime.neighbours.pictured_program import PicturedProgram
from nscc_runtime.sensor import default_sensor

pytestmark = pytest.mark.xdist_group("firmware")
SMALL = replace(TARGET, rows=13, cols=18, name="small")
CROSS = "kernel k = [[0, 1, 0], [1, 1, 1], [0, 1, 0]] / 8\n"
PROGRAMS = {
    "a kernel": "open when true\n" + CROSS + "image i = k(exposure)\nread i",
    "edges": "open when true\nkernel s = [[1, 0, -1], [2, 0, -2], [1, 0, -1]] / 8\n"
    "image i = abs(s(exposure))\nplane p = i > 6%\nread i, p",
    "five images": "open when true\n"
    + "".join(f"image y{n} = -exposure\n" for n in range(5))
    + "plane p = exposure > 6%\nread y0, y1, y2, y3, y4, p",
    "a plane only": "open when true\noutside 0\n" + CROSS + "plane p = exposure > 20%\n"
    "plane core = all(p, k)\nread core",
    "reports": "open when true\n" + CROSS + "plane p = k(exposure) > 6%\n"
    "report events p at most 3\nreport any p\nreport box p",
    "buckets": "bucket a open when n < 2\nbucket b open when n >= 2\nplane p = a > b\n"
    "image d = a if p else b / 2\nread b, d, p",
    "reports of rare bits": "open when true\nplane p = exposure > 75%\nplane q = exposure > 99%\n"
    "report events p at most 2\nreport any p\nreport box p\nreport any q\nreport box q",
    "reports beside what is read": "open when true\noutside 0\n" + CROSS
    + "state s : bit = 0 kept\nplane p = exposure > 50%\nplane q = k(exposure) > 45%\nnext s = p\n"
    "plane far = any(s, k)\nimage i = k(exposure)\nread s, i\nreport any far\nreport box q\n"
    "report any s",
    "a state": "open when true\noutside 0\nkernel around = [[1, 1, 1], [1, 0, 1], [1, 1, 1]]\n"
    "state region : bit = 0 kept\nplane bright = exposure > 45%\nplane medium = exposure > 30%\n"
    "image joined = agree(region, around)\nnext region = bright or medium and joined >= -2\n"
    "read region",
    "a state beside codes": "code stop : 3..4\nbucket a open when n < stop\noutside 1\n"
    "pixels stop = 3 + x % 2\nkernel k = [[1, 1, 1]]\nstate old : bit = 1 kept\n"
    "plane p = exposure > 25%\nnext old = p\nplane came = p or old\n"
    "plane wide = any(old, k)\nread old, came, wide, a\nreport box came",
    "states without neighbours": "open when true\nstate s : bit = 0 kept\n"
    "state still : bit = 1 kept\nplane p = exposure > 40%\nnext s = not s when p\nread s, still",
    "a state that spreads what is beyond the border": "open when true\noutside 0\n" + CROSS
    + "state s : bit = 0 kept\nplane p = k(exposure) > 30%\nnext s = any(s, k) or p\n"
    "read s\nreport any s\nreport events s at most 5",
    "repeated steps beside a plane of x and y": "open when true\noutside 0\n" + CROSS
    + "plane p = exposure > 40% and 2 < x < 15\nplane q = p repeat 3 p or q[1, 0]\n"
    "image v = exposure repeat 2 v[0, -1] if p else v\n"
    "plane f = flood(p and y == 6, p, k, at most 9)\nread q, v\nreport count f",
    "all registers": "".join(f"bucket b{n} open when n == {n}\n" for n in range(4))
    + "bucket b4 open when n < 2\nbucket b5 open when n > 2\nplane p = b0 > 30%\n"
    "read b0, b1, b2, b3, b4, b5, p",
}  # fmt: skip
REPORTED = {
    "reports",
    "reports of rare bits",
    "reports beside what is read",
    "repeated steps beside a plane of x and y",
}
"""The programs whose reports are made by the device."""
FRAMES = 3
ALL_FORMS = {
    "halved": [[-1 / 8, 0, 1 / 8], [-2 / 8, 0, 2 / 8], [-1 / 8, 0, 1 / 8]],
    "summed": [[-1, -1, -1], [-1, 8, -1], [-1, -1, -1]],
}
"""Kernels whose words halve a neighbour's value, and read a neighbour beside two registers."""


def container_of(body: str, target: Target = SMALL) -> Container:
    version = 4 if "repeat" in body or "param" in body else 3
    source = Source("p.nsl", f"nsl {version}\nframe 4 slots of 1ms\n{body}\n")
    made = run_passes(source, Path(), Options(level=1, target=target, cache=False)).container
    assert made is not None
    return made


def lights() -> list[Light]:
    """The light of each frame of a film."""
    shape = FRAMES, 4, SMALL.rows, SMALL.cols
    values = np.random.default_rng(5).uniform(0, 7000, shape)
    return [Light.of_clip(clip) for clip in np.round(values).astype(np.float32)]


class FilmedChip(ChipAtOnce):
    """A chip that sees the next light in each frame."""

    def __init__(self, film: list[Light], target: Target = SMALL) -> None:
        coming = iter(film)
        super().__init__(lambda _: next(coming), target)

    def execute(self, program: BoardProgram, channels: int) -> ExecutedFrame:
        self._light = None
        return super().execute(program, channels)


@pytest.fixture(scope="module")
def core() -> Iterator[Lockstep]:
    """The firmware's core with sanitizers, one process for this file."""
    loader = Lockstep(sanitized(target=SMALL), chip_of(examples()[0]))
    yield loader
    assert loader.close() == 0, "a sanitizer complained"


def filmed(
    loader: RunningFirmware,
    container: Container,
    count: int,
    settings: Sequence[HostSetting] = (),
) -> list[Frame]:
    """Frames of a loader, as the host makes them."""
    host, program = new_host(1), upload_of(container, bytes(32))
    target = container.target
    line = Simulation(host, loader)

    def uploaded() -> Task[bool]:
        return (yield from tasks.upload(host, program))

    line.run(host.lasting(uploaded))
    assert host.info is not None
    channels = channels_of(host.info, program)
    shape = (program.readouts, target.rows, target.cols)
    sensor = default_sensor(converter_of(container))
    frames: list[Frame] = []
    reaches: dict[str, Reach] = {}
    for number in range(1, count + 1):
        wanted = FrameRequest(number, channels, program)
        setting = settings[number - 1] if settings else HostSetting.at_start(container)
        params, registers = setting.params, container.pictures.registers
        wanted.values = tuple(params.values())
        for name, bits in setting.inputs.items():
            register, plane = target.digital_registers.index(registers[name]), packed_plane(bits)
            line.run(host.lasting(lambda r=register, p=plane: tasks.load(host, r, p)))
        taken = line.run(host.lasting(lambda one=wanted: tasks.capture(host, one)))
        assert isinstance(taken, tasks.FetchedFrame)
        reaches = beyond_reaches(container, reaches, params)
        frames.append(frame_of(taken.data, channels, shape, sensor, target, container, reaches))
    return frames


def check_film(
    found: list[Frame],
    container: Container,
    film: list[Light],
    settings: Sequence[HostSetting] = (),
) -> None:
    """Compare frames of a device with the emulator's, bit by bit."""
    sensor = default_sensor(converter_of(container))
    runner = PicturedProgram(container, sensor, selected("none"), threads=1)
    for frame, wanted in zip(found, runner.film(film, 0, 0, settings), strict=True):
        assert frame.told.keys() == wanted.told.keys()
        pairs = [(frame.frame, wanted.frame), (frame.exposure_e, wanted.exposure_e)]
        pairs += [(frame.told[key], wanted.told[key]) for key in wanted.told]
        for one, other in pairs:
            assert one.dtype == other.dtype
            np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("kind", ["python", "firmware"])
@pytest.mark.parametrize("name", PROGRAMS)
def test_films_of_images_and_planes_on_a_device_equal_those_of_the_emulator(
    name: str, kind: str, request: pytest.FixtureRequest
) -> None:
    """The frames fetched from the loader, in Python and in C++, equal the emulator's for the same
    light."""
    container, film = container_of(PROGRAMS[name]), lights()
    assert (upload_of(container, bytes(32)).report_bytes > 0) == (name in REPORTED)
    loader = fresh_loader(kind, FilmedChip(film), request, SMALL)
    check_film(filmed(loader, container, FRAMES), container, film)


LARGE = replace(TARGET, rows=72, cols=80, name="large")
GALLERY = (
    "background",
    "event_camera",
    "far_shift",
    "fast_corners",
    "flood_border",
    "median_of_9",
    "stabilise",
)
OF_THE_HOST = {
    "input planes": "open when true\noutside 0\ninput plane q\ninput plane r\n"
    "pixels r = x > 4\nparam m : 0 .. 5 = 2\nplane p = exposure > 40% and q\n"
    "plane s = r repeat m s[0, 1]\nread p, s\nreport count r",
    "kept images and sums": "open when true\nassume exposure <= 40%\n"
    "state a : image kept = 1181.1023622047244e\nstate b : image kept\n"
    "state c : image kept = 1181.1023622047244e\n"
    "param t : -20% .. 20% = 4%\nimage d = (exposure - a) / 2\nplane p = d > t\n"
    "next a = exposure when p\nnext b = d\nnext c = b / 2\nread a, d\n"
    "report sum c\nreport sum exposure\nreport sum d\nreport count p",
    "loops that may be empty": "open when true\noutside 1\ninput plane q\n"
    "param m : -3 .. 4 = 0\nplane r = q repeat (m + 1) r[1, 0]\n"
    "plane s = exposure > 30% repeat m s[0, 1] or q\nread r, s\nreport any r",
}  # fmt: skip


def drawn_settings(container: Container, count: int) -> tuple[HostSetting, ...]:
    """The starts of all parameters, their ends, and values between them; planes of random bits in
    every second frame."""
    rng, pictures, target = np.random.default_rng(8), container.pictures, container.target
    drawn: list[dict[str, int]] = [{}]
    drawn += [{each.name: each.ends[end] for each in pictures.params} for end in (0, 1)]
    for _ in range(count - 3):
        drawn.append({p.name: int(rng.integers(p.low, p.high + 1)) for p in pictures.params})
    levels = {param.name for param in pictures.params if param.kind == "level"}
    step_e = target.electrons_per_step
    names = [plane.name for plane in pictures.inputs if plane.is_open]
    shape = target.rows, target.cols
    return host_settings(
        container,
        [{n: v * step_e if n in levels else v for n, v in row.items()} for row in drawn],
        [{n: rng.random(shape) < 0.5 for n in names if frame % 2} for frame in range(count)],
    )


def check_filmed(
    container: Container, kind: str, request: pytest.FixtureRequest, most_e: float = 30000
) -> None:
    """Compare a film of six frames and settings with that of the emulator."""
    target, count = container.target, 6
    settings = drawn_settings(container, count)
    shape = count, container.slots, target.rows, target.cols
    film = [
        Light.of_clip((clip / container.slots).astype(np.float32))
        for clip in np.random.default_rng(7).uniform(0, 1, shape) ** 2 * most_e
    ]
    chip = FilmedChip(film, target)
    loader: RunningFirmware = (
        Lockstep(sanitized(target=target), chip)
        if kind == "firmware"
        else fresh_loader(kind, chip, request, target)
    )
    check_film(filmed(loader, container, count, settings), container, film, settings)
    if isinstance(loader, Lockstep):
        assert loader.close() == 0, "a sanitizer complained"


@pytest.mark.parametrize("kind", ["python", "firmware"])
@pytest.mark.parametrize("name", GALLERY)
def test_films_of_the_examples_on_a_device_equal_those_of_the_emulator(
    name: str, kind: str, root: Path, request: pytest.FixtureRequest
) -> None:
    """Each gallery program on the loader, in Python and in C++, gives the frames of the
    emulator."""
    source = Source("p.nsl", (root / f"examples/{name}.nsl").read_text())
    container = run_passes(source, Path(), Options(level=1, target=LARGE, cache=False)).container
    assert container is not None
    check_filmed(container, kind, request)


@pytest.mark.parametrize("kind", ["python", "firmware"])
@pytest.mark.parametrize("name", OF_THE_HOST)
def test_films_with_values_of_the_host_are_those_of_the_emulator(
    name: str, kind: str, request: pytest.FixtureRequest
) -> None:
    """Programs that get values from the host between frames give the emulator's frames on both
    loaders."""
    container = container_of(OF_THE_HOST[name])
    assert upload_of(container, bytes(32)).host_values
    check_filmed(container, kind, request, most_e=12000)


@pytest.mark.parametrize("name", ALL_FORMS)
def test_words_of_all_forms_run_on_devices(name: str, request: pytest.FixtureRequest) -> None:
    target = replace(SMALL, directed_sources=4, directed_halving=True, name="all forms")
    weights = np.array(ALL_FORMS[name])
    rows = (8 * weights).astype(int).tolist()
    text = f"open when true\nassume exposure <= 6%\nkernel k = {rows} / 8\n"
    container = container_of(f"{text}image i = k(exposure)\nread i", target)
    directed = [word for word, _ in picture_words(container) if NEIGHBOURS.keys() & word.sources]
    assert any(
        len(word.sources) > 2 if name == "summed" else word.operation.divisor == 2
        for word in directed
    )
    film = [Light.of_clip(light.frames / np.float32(32)) for light in lights()]
    core = Lockstep(sanitized(target=target), FilmedChip(film, target))
    for loader in (fresh_loader("python", FilmedChip(film, target), request, target), core):
        check_film(filmed(loader, container, FRAMES), container, film)
    assert core.close() == 0, "a sanitizer complained"
    runner = PicturedProgram(
        container, default_sensor(converter_of(container)), selected("none"), threads=1
    )
    for frame, light in zip(runner.film(film, 0, 0), film, strict=True):
        expected = correlate(light.frames.sum(axis=0, dtype=float), weights, mode="constant")
        image = frame.told["image_i"]
        np.testing.assert_allclose(image[2:-2, 2:-2], expected[2:-2, 2:-2], atol=1e-2)


@pytest.mark.parametrize("seed", [0, 1, 2, 4])
def test_films_of_random_cells_are_those_of_the_emulator(
    seed: int, request: pytest.FixtureRequest
) -> None:
    shape = 16, 20
    target = replace(TARGET, rows=shape[0], cols=shape[1], name="cell")
    cell = random_cell(seed, most_side=3)
    made = run_passes(
        Source("p.nsl", cell.text), Path(), Options(level=0, target=target, cache=False)
    ).container
    assert made is not None
    rng = np.random.default_rng(seed)
    film = [
        Light.of_clip(values)
        for values in rng.integers(0, 30000, (5, 1, *shape)).astype(np.float32)
    ]
    loader = fresh_loader("python", FilmedChip(film, target), request, target)
    check_film(filmed(loader, made, len(film)), made, film)
