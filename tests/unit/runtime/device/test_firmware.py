"""The firmware: its tables are nscc's, it has no heap, and it does to a chip what it was told."""

from __future__ import annotations

import os
import re
import select
import subprocess
import time
from contextlib import suppress
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from struct import pack, unpack

import numpy as np
import pytest
from click.testing import CliRunner
from device_lockstep import SANITIZERS, Lockstep
from device_sessions import new_host, uploaded_and_captured
from device_simulation import Simulation
from emulator_programs import bumps, target_of

from nscc.chips.load import builtin_names, builtin_target, load_target, target_toml
from nscc.diagnostics.diagnostic import Rejected
from nscc.words.encoding import decode
from nscc.words.readout import converter_of
from nscc_cli import check
from nscc_runtime.device import firmware
from nscc_runtime.device.board import EmulatedChip, in_columns
from nscc_runtime.device.loaders import LOADERS
from nscc_runtime.device.messages import Channel
from nscc_runtime.device.objects import upload_of
from nscc_runtime.device.packets import MOST_DATA, VERSION, Packet, PacketKind
from nscc_runtime.device.stand_in import loaded
from nscc_runtime.device.target_header import refresh_words, target_header
from nscc_runtime.device.tasks import FetchedFrame
from nscc_runtime.emulator import expose
from nscc_runtime.frame_file import read_out
from nscc_runtime.light import Light
from nscc_runtime.sensor import default_sensor

pytestmark = pytest.mark.xdist_group("firmware")
SCAMP5 = builtin_target("scamp5")
needs_compiler = pytest.mark.skipif(
    firmware.compiler() is None, reason="no C++ compiler: the firmware cannot be built"
)


def test_the_committed_table_is_in_step() -> None:
    committed = firmware.SOURCES / "targets/scamp5/target.hpp"
    assert committed.read_text() == target_header(SCAMP5), (
        "run `python -m nscc_runtime.device.target_header scamp5 > " + str(committed) + "`"
    )


def test_the_protocols_numbers_are_the_same_at_both_ends() -> None:
    """The header `packets.hpp` and the Python module declare the same version, largest packet and
    kinds in the same order."""
    text = (firmware.SOURCES / "core/packets.hpp").read_text()
    assert f"protocol_version = {VERSION};" in text
    assert f"most_data = {MOST_DATA};" in text
    listed = re.search(r"enum Kind : uint8_t \{(.*?)BOOTED", text, re.S)
    assert listed is not None
    names = re.findall(r"[A-Z_]+", listed[1])
    assert names == [kind.name for kind in sorted(PacketKind) if kind < 0x80]


def test_a_check_notes_the_loaders_that_cannot_take_a_program(tmp_path: Path) -> None:
    """The limits in the headers are those of Python. A program of 200 slots fits; one of 2048 has
    too many schedule rows (NS0507)."""
    for loader in LOADERS:
        text = (firmware.SOURCES / loader.folder / "limits.hpp").read_text()
        numbers = dict(re.findall(r"constexpr \w+ (\w+) = (.+?);", text))
        for name in ("kernels", "rows", "runs"):
            assert numbers[f"most_{name}"] == str(getattr(loader, name))
        value, bits = re.fullmatch(r"(\d)u << (\d+)", numbers["most_frame"]).groups()
        assert loader.frame_bytes == int(value) << int(bits)
        assert loader.frame_ms == 1200000 // int(numbers["ticks_per_us"])
        assert numbers["gains"] == str(loader.gains).lower()
    schedule = (firmware.SOURCES / "core/schedule.hpp").read_text()
    assert "longest_us = 1200000000u / limits::ticks_per_us;" in schedule
    said = {}
    for slots in (200, 2048):
        path = tmp_path / f"{slots}.nsl"
        path.write_text(
            f"nsl 1\nframe {slots} slots of 250us\ncode stop : 1..N\nopen when n < stop\n"
        )
        run = CliRunner().invoke(check.command, [str(path)])
        assert run.exit_code == 0
        said[slots] = run.stderr
    assert "NS0507" not in said[200]
    assert "2049 rows of its schedule, but the loader supports 1024" in said[2048]


@pytest.mark.parametrize(
    ("text", "noted", "loaders"),
    [
        ("nsl 1\nframe 2 slots of 700s\nopen when true", "1400000 milliseconds", 3),
        (
            f"nsl 1\nframe slots [{', '.join(f'{100 + i}us' for i in range(71))}]\nopen when true",
            "71 runs of equal slots, but the loader supports 64",
            2,
        ),
        (
            "nsl 4\nframe 1 slots of 1ms\nopen when true\n"
            + "".join(
                f"param t{i} : 1%..30% = {i + 1}%\nplane p{i} = exposure > t{i}\n"
                for i in range(17)
            )
            + "plane q = "
            + " or ".join(f"p{i}" for i in range(17))
            + "\nread q",
            "17 parameters, but the loader supports 16",
            3,
        ),
        (
            "nsl 4\nframe 1 slots of 1ms\nopen when true\nstate m : image kept = 3.3%\n"
            "next m = exposure\nread m",
            "no loader can take this program: `m` starts with",
            1,
        ),
    ],
)
def test_a_check_notes_every_limit_of_a_loader(
    text: str, noted: str, loaders: int, tmp_path: Path
) -> None:
    path = tmp_path / "program.nsl"
    path.write_text(text + "\n")
    run = CliRunner().invoke(check.command, [str(path)])
    assert run.exit_code == 0, run.stderr
    assert run.stderr.count("NS0507") == loaders
    assert run.stderr.count(noted) == loaders


def test_a_check_notes_frames_that_a_loader_cannot_store(tmp_path: Path) -> None:
    """Three images of 400 x 400 pixels are 480,000 bytes, more than the firmware has."""
    table = (files("nscc.chips") / "tables" / "scamp5.toml").read_text()
    table = table.replace("rows = 256", "rows = 400").replace("cols = 256", "cols = 400")
    (tmp_path / "large.toml").write_text(table)
    path = tmp_path / "program.nsl"
    path.write_text(
        "nsl 3 frame 1 slots of 1ms open when true image i = exposure / 2 "
        "image j = exposure / 4 image k = i - j read i read j read k\n"
    )
    run = CliRunner().invoke(check.command, [str(path), "--target", str(tmp_path / "large.toml")])
    assert run.exit_code == 0, run.stderr
    assert "480000 bytes" in run.stderr


def test_a_refresh_changes_nothing() -> None:
    """Executed by hand, as the facts say words work: R12 takes a write only where R0 is 1."""
    for code in range(4):
        held = {"R0": code & 1, "R12": code >> 1, "FLAG": 1, "bus": 0}
        before = dict(held)
        for word in refresh_words(SCAMP5, "R12"):
            some = max([held[name] for name in word.sources], default=0)
            kind = word.name
            if kind == "WHERE":
                held["FLAG"] = some
            elif kind == "SET":
                held["R0"] = 1
            elif kind == "REFRESH.read":
                held["bus"] = some
            elif kind == "REFRESH.write":
                held["R12"] = held["bus"] if held["R0"] else held["R12"]
            elif kind == "MOV":
                held["R0"] = some
            else:
                raise AssertionError(kind)
        assert (held["R0"], held["R12"]) == (before["R0"], before["R12"])
    assert [str(word) for word in refresh_words(SCAMP5, "R3")] == [
        "REFRESH.read R3",
        "REFRESH.write R3",
    ]


@needs_compiler
@pytest.mark.parametrize("name", [n for n in builtin_names() if builtin_target(n).has_logic])
def test_the_loader_is_built_without_a_warning_for_every_chip(name: str, tmp_path: Path) -> None:
    """The compiler takes warnings as errors. A second build finds the first in the cache: one file
    with its digest."""
    loader = firmware.built(builtin_target(name), ("-O0", "-Werror"), tmp_path)
    assert loader.path.exists()
    again = firmware.built(builtin_target(name), ("-O0", "-Werror"), tmp_path)
    assert again == loader
    name = loader.path.name
    assert sorted(path.name for path in tmp_path.iterdir()) == [name, f"{name}.sha256"]


@needs_compiler
def test_the_core_has_no_heap_and_no_exceptions(tmp_path: Path) -> None:
    """Its object files import only functions that compilers call on their own."""
    found = firmware.compiler()
    assert found is not None
    wanted: set[str] = set()
    defined: set[str] = set()
    for source in sorted((firmware.SOURCES / "core").glob("*.cpp")):
        out = tmp_path / f"{source.stem}.o"
        includes = [f"-I{firmware.SOURCES / part}" for part in ("core", "host", "targets/scamp5")]
        flags = [*firmware.CORE_FLAGS, "-O2", "-ffreestanding", "-fno-pie"]
        subprocess.run([found, *flags, *includes, "-c", str(source), "-o", str(out)], check=True)
        listed = subprocess.run(["nm", "-P", str(out)], capture_output=True, text=True, check=True)
        for line in listed.stdout.splitlines():
            symbol, kind = line.split()[:2]
            (wanted if kind in "Uw" else defined).add(symbol)
    outside = {name for name in wanted - defined if not name.startswith("_GLOBAL_OFFSET")}
    assert outside <= {"memcpy", "memset", "memmove", "__stack_chk_fail"}


@needs_compiler
def test_every_chip_runs_a_program(tmp_path: Path) -> None:
    """A chip with other registers and another size than SCAMP-5's, from a table of the user's."""
    (tmp_path / "chip.toml").write_text(
        target_toml(replace(builtin_target("scamp7"), name="mine", rows=5, cols=7))
    )
    target = load_target("chip.toml", tmp_path)
    stop = np.random.default_rng(2).integers(1, 7, (5, 7))
    container = replace(bumps(target, None, stop, 6, "latch"), slot_us=(50.0,) * 6)
    light = Light.of_clip(np.random.default_rng(4).random((6, 5, 7), np.float32) * 900)
    chip = EmulatedChip(lambda _: light, target)
    with Lockstep(firmware.built(target, ("-O1",), tmp_path), chip) as loader:
        host = new_host(1)
        upload = upload_of(container, bytes(32))
        taken = Simulation(host, loader).run(host.lasting(uploaded_and_captured(host, upload, 1)))
    assert isinstance(taken, FetchedFrame)
    exact = expose(container, light)
    codes = read_out(exact, target, default_sensor(converter_of(container))).frame
    assert taken.data == in_columns(codes) + in_columns(exact.exposure_e.astype("<f8"))


@pytest.fixture(
    scope="module",
    params=[
        pytest.param((), id="object"),
        pytest.param(("-DDEVKIT_STUB_TABLE_FUNCTION",), id="function", marks=pytest.mark.slow),
    ],
)
def devkit_loader(
    request: pytest.FixtureRequest, root: Path, tmp_path_factory: pytest.TempPathFactory
) -> Path:
    """The loader for the devkit, compiled against a stand-in for its library."""
    form: tuple[str, ...] = request.param
    program = tmp_path_factory.mktemp("devkit") / "loader"
    sources = [*sorted((firmware.SOURCES / "core").glob("*.cpp"))]
    sources += sorted((firmware.SOURCES / "scamp5d").glob("*.cpp"))
    sources.append(root / "tests/firmware_chip/watchdog.cpp")
    includes = [
        f"-I{firmware.SOURCES / part}" for part in ("core", "port", "scamp5d", "targets/scamp5")
    ]
    found = firmware.compiler()
    if found is None:
        pytest.skip("no C++ compiler: the firmware cannot be built")
    command = [
        found,
        *form,
        "-D__LPC43XX__",
        "-std=c++17",
        "-O1",
        *firmware.WARNINGS,
        "-Werror",
        *SANITIZERS,
    ]
    command += [*includes, "-isystem", str(root / "tests/devkit_stub"), *map(str, sources)]
    subprocess.run([*command, "-o", str(program)], check=True)
    return program


def test_the_scamp5d_layer_draws_launches_waits_and_sends_as_the_program_says(
    devkit_loader: Path, tmp_path: Path
) -> None:
    """What it draws, launches and waits, and what it sends back."""
    target = target_of((256, 256))
    numbers = np.random.default_rng(6)
    stop = numbers.integers(1, 5, (256, 256))
    container = replace(bumps(target, None, stop, 4, "edges"), slot_us=(100.0, 50.5, 50.5, 200.0))
    events, data = run_devkit(devkit_loader, container, tmp_path)

    rows, cols = np.mgrid[:256, :256]
    assert data == ((3 * rows + 5 * cols + ord("A")) % 256).astype(np.uint8).T.tobytes()
    planes = container.planes()
    for register, plane in planes.items():
        drawn = np.zeros((256, 256), bool)
        for line in events:
            if line.startswith(f"draw {register} "):
                pairs = np.array(line.split()[2:], int).reshape(-1, 2)
                drawn[pairs[:, 0], 255 - pairs[:, 1]] = True
        np.testing.assert_array_equal(drawn, plane)

    kernels = {
        line.split()[1]: [int(word, 16) for word in line.split()[2:]]
        for line in events
        if line.startswith("kernel ")
    }
    expected = [
        [part for word in container.kernels[launch.kernel].words for part in word]
        for launch in container.launches
    ]
    scans = [i for i, line in enumerate(events) if line.startswith("scan ")]
    assert [events[i] for i in scans] == [f"scan A {column}" for column in range(256)]
    end = scans[0]
    launched = [i for i, line in enumerate(events[:end]) if line.startswith("launch ")]
    # Before readout FLAG is set everywhere, and A made 2 x exposure - full well; the frame's
    # launches are those before.
    frame = launched[-3 - len(expected) : -3]
    assert [kernels[events[i].split()[1]] for i in frame] == expected
    [level] = [line.split()[1] for line in events[frame[-1] : end] if line.startswith("in ")]
    for electrons, code in ((0, 0), (15_000, 128), (30_000, 255)):
        held = {"A": electrons, "F": 7, "NEWS": 9, "IN": int(level) * 30_000 / 127}
        stored = [part for i in launched[-3:] for part in kernels[events[i].split()[1]]]
        words = [decode(tuple(stored[i : i + 5])) for i in range(0, len(stored), 5)]  # type: ignore[arg-type]
        assert [str(word) for word in (words[0], words[-1])] == ["all", "all"]
        for word in words[1:-1]:
            held[word.destinations[0]] = -sum(held[name] for name in word.sources)
        assert min(128 + round(held["A"] / (60_000 / 255)), 255) == code


def run_devkit(program: Path, container: object, folder: Path) -> tuple[list[str], bytes]:
    """A session with the devkit's loader over pipes: what it printed, and the frame."""
    process, to_device, from_device = started(program, folder)
    host = new_host(1, patience_s=60.0)
    upload = upload_of(container, bytes(32))  # type: ignore[arg-type]
    work = uploaded_and_captured(host, upload, 1, Channel.CODES)
    host.start(host.lasting(work), time.monotonic())
    while host.running:
        data = host.poll(time.monotonic())
        while data:
            data = data[os.write(to_device, data) :]
        left = min(max(host.deadline - time.monotonic(), 0.0), 0.2)
        if host.running and select.select([from_device], [], [], left)[0]:
            host.receive(os.read(from_device, 65536), time.monotonic())
    os.close(to_device)
    assert process.wait(60) == 0
    os.close(from_device)
    taken = host.result
    assert isinstance(taken, FetchedFrame)
    return (folder / "log").read_text().splitlines(), taken.data


def started(program: Path, folder: Path) -> tuple[subprocess.Popen[bytes], int, int]:
    """The devkit's loader, which prints to `log`; the ends of its pipes. The registers of its
    watchdog are the file `watchdog`."""
    to_device, from_device = os.pipe(), os.pipe()
    ends = (to_device[0], from_device[1])
    watchdog = folder / "watchdog"
    watchdog.write_bytes(bytes(4096))
    names = {"PORT_IN": str(ends[0]), "PORT_OUT": str(ends[1]), "WATCHDOG": str(watchdog)}
    with open(folder / "log", "wb") as out:
        process = subprocess.Popen(
            [str(program)], stdout=out, pass_fds=ends, env={**os.environ, **names}
        )
    for fd in ends:
        os.close(fd)
    return process, to_device[1], from_device[0]


def test_the_watchdog_is_not_reset_while_a_port_is_stuck(
    devkit_loader: Path, tmp_path: Path
) -> None:
    """Only the main loop resets the watchdog. Without a reset for four seconds the LPC4357
    restarts."""
    process, to_device, from_device = started(devkit_loader, tmp_path)

    def fed(seconds: float) -> bool:
        with open(tmp_path / "watchdog", "r+b", buffering=0) as registers:
            registers.seek(8)
            registers.write(bytes(4))
            end = time.monotonic() + seconds
            while time.monotonic() < end:
                registers.seek(8)
                if registers.read(4) == pack("<I", 0x55):
                    return True
                time.sleep(0.01)
            return False

    assert fed(20)
    mode, counts = unpack("<2I", (tmp_path / "watchdog").read_bytes()[:8])
    # Enabled with reset; four seconds of a clock of 12 MHz that is divided by 4.
    assert (mode, counts) == (3, 4 * 12_000_000 // 4)
    # Nobody takes the answers, until the pipe is full and the library's `send` waits for ever.
    hello = Packet(PacketKind.HELLO, 1, 1, bytes([VERSION, VERSION, 0, 0])).wire()
    os.set_blocking(to_device, False)
    with suppress(BlockingIOError):
        while True:
            os.write(to_device, hello * 50)
            time.sleep(0.01)
    assert not fed(0.5)
    while select.select([from_device], [], [], 0.5)[0]:
        os.read(from_device, 65536)
    assert fed(20)
    os.close(to_device)
    assert process.wait(60) == 0
    os.close(from_device)


def _dark_chip() -> EmulatedChip:
    light = np.zeros((4, SCAMP5.rows, SCAMP5.cols), np.float32)
    return EmulatedChip(lambda _: Light.of_clip(light), SCAMP5)


@needs_compiler
@pytest.mark.parametrize("what", ["cut short", "other bytes", "no digest", "not executable"])
def test_a_damaged_loader_in_the_cache_is_compiled_again(tmp_path: Path, what: str) -> None:
    """Each kind of damage is noticed, and the compiled file has its first bytes again and
    starts."""
    loader = firmware.built(SCAMP5, ("-O0",), tmp_path)
    whole, digest = loader.path.read_bytes(), tmp_path / f"{loader.path.name}.sha256"
    match what:
        case "cut short":
            loader.path.write_bytes(whole[:1000])
        case "other bytes":
            loader.path.write_bytes(b"#!/bin/false" + whole[12:])
        case "no digest":
            digest.unlink()
        case _:
            loader.path.chmod(0o600)
    again = firmware.built(SCAMP5, ("-O0",), tmp_path)
    assert again.path == loader.path
    assert again.path.read_bytes() == whole
    with firmware.Process(again, _dark_chip()):
        pass


@needs_compiler
def test_a_cache_that_cannot_be_written_does_not_stop_the_loader(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """If folders stand in the place of the cached files, the loader is built elsewhere and
    starts."""
    monkeypatch.setenv("NSCC_CACHE_DIR", str(tmp_path))
    # A folder stands where the loader would be kept.
    (tmp_path / "firmware" / firmware.built(SCAMP5, ("-O0",)).path.name).unlink()
    for name in [path.name for path in (tmp_path / "firmware").iterdir()]:
        (tmp_path / "firmware" / name.removesuffix(".sha256")).mkdir()
    loader = firmware.built(SCAMP5, ("-O0",))
    assert loader.path.parent != tmp_path / "firmware"
    with firmware.Process(loader, _dark_chip()):
        pass


@needs_compiler
def test_a_loader_that_does_not_start_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A loader that ends at once (`/bin/false`) gives NS0772 and prints nothing."""
    path = tmp_path / "loader"
    path.write_text("#!/bin/false\n")
    path.chmod(0o755)
    monkeypatch.setattr(firmware, "built", lambda target: firmware.Built(path, "g++", target))
    said: list[str] = []
    with (
        pytest.raises(Rejected) as raised,
        loaded("host", SCAMP5, _dark_chip(), said.append),
    ):
        pass
    (diagnostic,) = raised.value.diagnostics
    assert diagnostic.code == "NS0772"
    assert "cannot be run on this machine: it does not start" in diagnostic.message
    assert said == []
